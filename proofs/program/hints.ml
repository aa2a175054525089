(* Brings a scene and a history to whole numbers, and finds the hints of the claims. What is wrong here cannot make the
   checker accept a claim that is false of the whole numbers; but these must be those of the files. *)
open Numbers
open Files

exception Undecided of int * string

let undecided line format = Printf.ksprintf (fun text -> raise (Undecided (line, text))) format

(* Generators: the container 1, disk k is k + 2. The checker's positive numbers must be positive. *)
let gen k = if k < -1 then invalid "an id below -1" else Z.of_int (k + 2)
let edge q = { Checker.el = gen q.(0); er = gen q.(1); es = gen q.(2); ee = gen q.(3) }

let velocities line = function
  | None -> undecided line "velocities are not given"
  | Some v -> v

(* All numbers of one kind, to find a unit of which they are multiples. *)
let turns (_, t, what) =
  match what with
  | Flipped _ -> (t, [], [])
  | Collided (_, _, v, p) ->
      let both = function None -> [] | Some (a, b) -> Option.to_list a @ [ b ] in
      (t, both v, both p)
  | Maneuvered (_, v, p) -> (t, Option.to_list v, Option.to_list p)

let denominator unit x = Z.lcm unit (Q.den x)
let denominators = List.fold_left (fun unit (x, y) -> denominator (denominator unit x) y)

(* A number in such a unit. *)
let to_unit unit x =
  let multiple = Q.mul x (Q.of_bigint unit) in
  if Z.equal (Q.den multiple) Z.one then Q.num multiple else failwith "a number is no multiple of its unit"

type units = { time : Z.t; speed : Z.t; length : Z.t }

let units scene history tolerance =
  let all = List.map turns history.events in
  let time = List.fold_left (fun u (t, _, _) -> denominator u t) (Q.den history.horizon) all in
  let time = List.fold_left (fun u (m : maneuver) -> denominator u m.time) (denominator time tolerance) scene.maneuvers in
  (* Brackets are narrower than a unit in the last place of the horizon. *)
  let finest = Z.shift_left Z.one (max 0 (64 - Z.numbits (Q.to_bigint history.horizon))) in
  let time = Z.lcm time finest in
  let disks = Array.to_list scene.disks in
  let speed = denominators Z.one (List.map (fun d -> d.velocity) disks @ List.map (fun (m : maneuver) -> m.turned) scene.maneuvers) in
  let speed = List.fold_left (fun u (_, v, _) -> denominators u v) speed all in
  let length = denominators (Z.mul time speed) ((scene.origin :: (scene.size, Q.zero) :: List.map (fun d -> d.center) disks) @
      List.map (fun d -> (d.radius, Q.zero)) disks) in
  { time; speed; length = List.fold_left (fun u (_, _, p) -> denominators u p) length all }

let problem scene history tolerance law u =
  let at = to_unit u.length and time = to_unit u.time in
  let velocity x = to_unit (Z.divexact u.length u.time) x in
  let masses = Array.fold_left (fun unit d -> denominator unit d.mass) Z.one scene.disks in
  let body radius mass (x, y) (vx, vy) =
    { Checker.body_radius = at radius; mass; start = { Checker.since = Z.zero; x = at x; y = at y; vx = velocity vx; vy = velocity vy } } in
  let bodies = ref (Checker.PositiveMap.add Z.one (body (Q.neg scene.size) Z.zero scene.origin (Q.zero, Q.zero)) Checker.PositiveMap.empty) in
  Array.iteri (fun k d -> bodies := Checker.PositiveMap.add (gen k) (body d.radius (to_unit masses d.mass) d.center d.velocity) !bodies) scene.disks;
  let edges = ref Checker.PositiveMap.empty in
  List.iteri (fun k q -> edges := Checker.PositiveMap.add (Z.of_int (k + 1)) (edge q) !edges) (Option.get history.initial);
  let maneuver (m : maneuver) = { Checker.due = time m.time; who = gen m.disk; dvx = velocity (fst m.turned); dvy = velocity (snd m.turned) } in
  let fraction x = (Q.num x, Q.den x) in
  { Checker.bodies = !bodies; schedule = List.map maneuver scene.maneuvers; disk_restitution = fraction scene.restitution;
    wall_restitution = fraction scene.wall; whole_law = scene.whole_law; horizon = time history.horizon;
    tolerance = time tolerance; law_tolerance = fraction law; edges = !edges }

(* The diagram, for the hints: edges by number, since when each may flip, by their sides, and by the
   generators that they depend on. *)
type diagram = { names : Checker.edge array; born : Z.t array; side : (Z.t * Z.t * Z.t, int) Hashtbl.t; around : (Z.t, (int, unit) Hashtbl.t) Hashtbl.t }

let four q = Checker.[ q.el; q.er; q.es; q.ee ]
let sides q = Checker.[ (q.el, q.er, q.ee); (q.er, q.el, q.es) ]

let around d g = match Hashtbl.find_opt d.around g with
  | Some set -> set
  | None -> let set = Hashtbl.create 16 in Hashtbl.add d.around g set; set

let enter d k =
  List.iter (fun s -> Hashtbl.replace d.side s k) (sides d.names.(k));
  List.iter (fun g -> Hashtbl.replace (around d g) k ()) (four d.names.(k))

let leave d k =
  List.iter (fun s -> if Hashtbl.find_opt d.side s = Some k then Hashtbl.remove d.side s) (sides d.names.(k));
  List.iter (fun g -> Hashtbl.remove (around d g) k) (four d.names.(k))

let diagram (p : Checker.problem) =
  let names = Array.of_list (List.map snd (Checker.PositiveMap.elements p.edges |> List.sort (fun (a, _) (b, _) -> Z.compare a b))) in
  let d = { names; born = Array.map (fun _ -> Z.zero) names; side = Hashtbl.create 1000; around = Hashtbl.create 1000 } in
  Array.iteri (fun k _ -> enter d k) names;
  d

let number k = Z.of_int (k + 1)
let edges_around d gens = List.concat_map (fun g -> Hashtbl.fold (fun k () l -> k :: l) (around d g) []) gens |> List.sort_uniq compare

(* The claims with their hints. [s] holds where the generators are now; [next] are the times of the turns to come. *)
let claims (p : Checker.problem) u history =
  let d = diagram p in
  let time = to_unit u.time and at = to_unit u.length in
  let velocity (x, y) = let v = to_unit (Z.divexact u.length u.time) in (v x, v y) in
  let centres list = List.filter_map (fun (k, c) -> Option.map (fun (x, y) -> (gen k, (at x, at y))) c) list in
  let s = ref (Checker.first_state p) in
  let mover g = match Checker.PositiveMap.find g !s.movers with Some m -> m | None -> raise Not_found in
  let turn line claim gens t =
    List.iter (fun g -> match Checker.turn claim g !s with Good s' -> s := s' | Bad _ -> undecided line "an unknown generator") gens;
    List.iter (fun k -> if Z.gt t d.born.(k) then d.born.(k) <- t) (edges_around d gens);
    claim
  in
  let flip line t q limit =
    let f = edge q in
    let { Checker.el = l; er = r; es = i; ee = e } = f in
    let find side = match Hashtbl.find_opt d.side side with Some k -> k | None -> undecided line "no such edge is there" in
    let ks = List.map find [ (l, r, e); (l, i, r); (i, r, l); (r, e, l); (e, l, r) ] in
    let born = List.fold_left (fun b k -> Z.max b d.born.(k)) Z.zero ks in
    let rec widen w =
      let lo = Z.max (Z.max born Z.one) (Z.sub t w) and hi = Z.min (Z.add t w) limit in
      if Z.lt lo hi && Checker.collapses !s f lo hi = Good true then (lo, hi)
      else if Z.equal w p.tolerance then undecided line "no bracket of the collapse was found"
      else widen (Z.min p.tolerance (Z.mul w (Z.of_int 8)))
    in
    let lo, hi = widen (Z.min p.tolerance (Z.max (Z.of_int 4) (Z.shift_right t 51))) in
    let n = List.map number ks in
    let claim = match n with [ a; b; c; x; y ] -> Checker.Flip (t, f, lo, hi, a, b, c, x, y) | _ -> assert false in
    List.iter (fun k ->
        let q = match Checker.after_flip (number k) claim d.names.(k) with Some q -> q | None -> undecided line "the edges do not fit" in
        leave d k; d.names.(k) <- q; d.born.(k) <- lo) ks;
    List.iter (enter d) ks;
    claim
  in
  let collide line t i j v ps =
    let gi = gen i and gj = gen j in
    let a = mover gi and b = mover gj in
    let pair (q : Checker.edge) = (Z.equal q.el gi && Z.equal q.er gj) || (Z.equal q.el gj && Z.equal q.er gi) in
    let between = List.filter (fun k -> pair d.names.(k)) (edges_around d [ gj ]) in
    let number_ = match between with k :: _ -> number k | [] -> undecided line "the two are no neighbours" in
    let gap = Checker.gap_at gi gj a b in
    let before = List.fold_left Z.max (Z.sub t p.tolerance) [ a.path.since; b.path.since ] in
    let last = Z.add t p.tolerance in
    (* They overlap most where they are nearest. *)
    let dx = Z.sub (Checker.x_at b.path t) (Checker.x_at a.path t) and dy = Z.sub (Checker.y_at b.path t) (Checker.y_at a.path t) in
    let wx = Z.sub b.path.vx a.path.vx and wy = Z.sub b.path.vy a.path.vy in
    let speed = Z.max Z.one (Z.add (Z.mul wx wx) (Z.mul wy wy)) in
    let nearest = Z.sub t (Z.div (Z.add (Z.mul dx wx) (Z.mul dy wy)) speed) in
    let overlap h = Z.geq h before && Z.leq h last && Z.lt (gap h) Z.zero in
    let after = match List.find_opt overlap [ last; nearest ] with Some h -> h | None -> last in
    let vi, vj = velocities line v in
    let zero = (Z.zero, Z.zero) in
    let vi = match vi with Some v -> velocity v | None -> zero in
    let ps = match ps with None -> [] | Some (x, y) -> centres [ (i, x); (j, Some y) ] in
    let gens = if i < 0 then [ gj ] else [ gi; gj ] in
    let near = List.map number (edges_around d gens) in
    turn line (Checker.Collision (t, gi, gj, vi, velocity vj, ps, before, after, number_, near)) gens t
  in
  let maneuver line t k v ps =
    let v = match v with Some v -> v | None -> undecided line "the velocity is not given" in
    let g = gen k in
    let near = List.map number (edges_around d [ g ]) in
    turn line (Checker.Maneuver (t, g, velocity v, centres [ (k, ps) ], near)) [ g ] t
  in
  let next = List.fold_right (fun (_, t, what) rest ->
      let later = match rest with [] -> Z.shift_left p.horizon 2 | l :: _ -> l in
      (match what with Flipped _ -> later | _ -> time t) :: rest) history.events [] in
  let stay limit t = Z.max limit (Z.add t Z.one) in
  List.map2 (fun (line, t, what) limit ->
      let t = time t in
      try
        match what with
        | Flipped q -> flip line t q (stay limit t)
        | Collided (i, j, v, ps) -> collide line t i j v ps
        | Maneuvered (k, v, ps) -> maneuver line t k v ps
      with Not_found -> undecided line "an unknown generator")
    history.events next
