(* What the statement speaks of over time: a scene, the claims of a history, the paths and edges that follow from them.
   No proofs.

   All numbers are whole. The program brings the numbers of its files to common units (proved.md, section 2), so that
   times, velocities, places and radii have no fractions; a place is measured in the unit of a velocity times the unit of a
   time. *)
From Coq Require Import ZArith List Bool Reals FMapPositive.
From Voroproof Require Import Geometry.
Import ListNotations.
Open Scope Z_scope.

(* Generator 1 is the container, generator k + 2 is disk k. *)
Definition gen := positive.
Definition container : gen := 1%positive.

(* A piece of a path: at time [since] the centre is (x, y), from then on it moves with the velocity (vx, vy). *)
Record leg := Leg { since : Z; x : Z; y : Z; vx : Z; vy : Z }.
Definition x_at (l : leg) (t : Z) : Z := x l + vx l * (t - since l).
Definition y_at (l : leg) (t : Z) : Z := y l + vy l * (t - since l).

(* A generator of the scene: its signed radius (that of the container is -R), its mass, its path from 0 on. *)
Record body := Body { body_radius : Z; mass : Z; start : leg }.

(* The edge [l,r,s,e] of formats.md, section 3. *)
Record edge := Edge { el : gen; er : gen; es : gen; ee : gen }.
Definition edge_eqb (p q : edge) : bool :=
  Pos.eqb (el p) (el q) && Pos.eqb (er p) (er q) && Pos.eqb (es p) (es q) && Pos.eqb (ee p) (ee q).
Definition reversed (q : edge) : edge := Edge (er q) (el q) (ee q) (es q).

(* Where four generators stay cotangent, the largest is thought of as infinitely little larger: the rule wants the edge that
   joins it with the one opposite. An edge may have twice the same generator at its ends. *)
Definition largest (q : edge) : bool := Pos.eqb (es q) (ee q) || Pos.ltb (Pos.max (es q) (ee q)) (Pos.max (el q) (er q)).

Record maneuver := Scheduled { due : Z; who : gen; dvx : Z; dvy : Z }.

Record problem := Problem {
  bodies : PositiveMap.t body;
  schedule : list maneuver;
  disk_restitution : Z * Z;       (* numerator and denominator *)
  wall_restitution : Z * Z;
  whole_law : bool;               (* the wall scales all of the reflected velocity, not only its normal part *)
  horizon : Z;                    (* T *)
  tolerance : Z;                  (* tau *)
  law_tolerance : Z * Z;          (* lambda *)
  edges : PositiveMap.t edge      (* the initial diagram: its edges, numbered *)
}.

(* What a history claims, in the order of its lines. The fields after the bar of each are hints of the program's unproved
   part: they say where to look, and no claim of the theorem rests on their being good. *)
Inductive claim :=
| Flip (t : Z) (named : edge)
       (* | *) (lo hi : Z) (number n1 n2 n3 n4 : positive)
| Collision (t : Z) (i j : gen) (vi vj : Z * Z) (centres : list (gen * (Z * Z)))
       (* | *) (before after : Z) (number : positive) (around : list positive)
| Maneuver (t : Z) (i : gen) (v : Z * Z) (centres : list (gen * (Z * Z)))
       (* | *) (around : list positive).

Section History.
Variable P : problem.

(* A past is a list of claims, the last first. *)

(* When and to what velocity a claim turns a generator. *)
Definition turn_of (c : claim) (g : gen) : option (Z * (Z * Z)) :=
  match c with
  | Flip _ _ _ _ _ _ _ _ _ => None
  | Collision t i j vi vj _ _ _ _ _ =>
      if Pos.eqb g container then None else if Pos.eqb g i then Some (t, vi) else if Pos.eqb g j then Some (t, vj) else None
  | Maneuver t i v _ _ => if Pos.eqb g container then None else if Pos.eqb g i then Some (t, v) else None
  end.

Definition turned (l : leg) (t : Z) (v : Z * Z) : leg := Leg t (x_at l t) (y_at l t) (fst v) (snd v).

(* The last leg of a generator's path. *)
Fixpoint last_leg (g : gen) (past : list claim) : leg :=
  match past with
  | [] => match PositiveMap.find g (bodies P) with Some b => start b | None => Leg 0 0 0 0 0 end
  | c :: past => match turn_of c g with Some (t, v) => turned (last_leg g past) t v | None => last_leg g past end
  end.

Definition radius_of (g : gen) : Z := match PositiveMap.find g (bodies P) with Some b => body_radius b | None => 0 end.

Open Scope R_scope.

(* A generator that runs along a leg, at time t. *)
Definition on_leg (g : gen) (l : leg) (t : R) : generator :=
  Generator (IZR (x l) + IZR (vx l) * (t - IZR (since l))) (IZR (y l) + IZR (vy l) * (t - IZR (since l)))
    (IZR (radius_of g)) (Pos.eqb g container).

(* The leg that a generator is on at time t: the last that has begun. *)
Fixpoint leg_at (g : gen) (past : list claim) (t : R) : leg :=
  match past with
  | [] => last_leg g []
  | c :: earlier =>
      match turn_of c g with
      | Some (u, _) => if Rle_dec (IZR u) t then last_leg g past else leg_at g earlier t
      | None => leg_at g earlier t
      end
  end.

(* Where a generator is at time t. *)
Definition place (past : list claim) (t : R) (g : gen) : generator := on_leg g (leg_at g past t) t.

(* Edges. When [l,r,s,e] flips, it becomes [s,e,r,l], and each of the four edges beside it gets another generator at one
   end: [beside a b c d q] is what the edge q between a and b becomes whose vertex [a,b,c] turns into [a,b,d]. *)
Definition beside (a b c d : gen) (q : edge) : option edge :=
  if Pos.eqb (el q) a && Pos.eqb (er q) b && Pos.eqb (ee q) c then Some (Edge a b (es q) d)
  else if Pos.eqb (el q) b && Pos.eqb (er q) a && Pos.eqb (es q) c then Some (Edge b a d (ee q))
  else None.

Definition bind {A B} (a : option A) (f : A -> option B) : option B := match a with Some x => f x | None => None end.

(* Which vertex at an end of the edge k a flip changes: the edge lies between a and b, and [a,b,c] turns into [a,b,d]. *)
Definition corner (k : positive) (c : claim) : option (gen * gen * gen * gen) :=
  match c with
  | Flip _ f _ _ _ k1 k2 k3 k4 =>
      if Pos.eqb k k1 then Some (el f, es f, er f, ee f)
      else if Pos.eqb k k2 then Some (es f, er f, el f, ee f)
      else if Pos.eqb k k3 then Some (er f, ee f, el f, es f)
      else if Pos.eqb k k4 then Some (ee f, el f, er f, es f)
      else None
  | _ => None
  end.
(* Whether a flip is of the edge k itself. *)
Definition own (k : positive) (c : claim) : bool := match c with Flip _ _ _ _ k0 _ _ _ _ => Pos.eqb k k0 | _ => false end.

Definition after_flip (k : positive) (c : claim) (q : edge) : option edge :=
  match c with
  | Flip _ f _ _ _ _ _ _ _ =>
      if own k c then Some (Edge (es f) (ee f) (er f) (el f))
      else match corner k c with Some (a, b, c, d) => beside a b c d q | None => Some q end
  | _ => Some q
  end.

(* The edge of a number after all claims of a past. *)
Fixpoint last_edge (k : positive) (past : list claim) : option edge :=
  match past with
  | [] => PositiveMap.find k (edges P)
  | c :: past => bind (last_edge k past) (after_flip k c)
  end.

(* Whether a claim is a flip of the edge of this number, or of one beside it, and its bracket. *)
Definition bracket_of (k : positive) (c : claim) : option (Z * Z) :=
  match c with
  | Flip _ _ lo hi k0 k1 k2 k3 k4 =>
      if Pos.eqb k k0 || Pos.eqb k k1 || Pos.eqb k k2 || Pos.eqb k k3 || Pos.eqb k k4 then Some (lo, hi) else None
  | _ => None
  end.

(* The edge of a number at time t. *)
Fixpoint edge_at (k : positive) (past : list claim) (t : R) : option edge :=
  match past with
  | [] => last_edge k []
  | c :: earlier =>
      match bracket_of k c with
      | Some (_, hi) => if Rle_dec (IZR hi) t then last_edge k past else edge_at k earlier t
      | None => edge_at k earlier t
      end
  end.

(* t lies in the bracket of a flip of this edge or of one beside it. *)
Definition bracketed (k : positive) (past : list claim) (t : R) : Prop :=
  exists c lo hi, In c past /\ bracket_of k c = Some (lo, hi) /\ IZR lo <= t < IZR hi.

(* All that the edge of a number may be called at time t: each flip whose bracket t lies in is over, or is not. *)
Definition renamed (k : positive) (c : claim) (qs : list edge) : list edge :=
  flat_map (fun q => match after_flip k c q with Some new => [new] | None => [] end) qs.
Fixpoint names_at (k : positive) (past : list claim) (t : R) : list edge :=
  match past with
  | [] => match last_edge k [] with Some q => [q] | None => [] end
  | c :: earlier =>
      let olds := names_at k earlier t in
      match bracket_of k c with
      | Some (lo, hi) =>
          if Rle_dec (IZR hi) t then renamed k c olds else if Rle_dec (IZR lo) t then renamed k c olds ++ olds else olds
      | None => olds
      end
  end.

(* The diagrams that the claims allow at time t, with the numbers of their edges: each flip whose bracket t lies in is over, or is not. *)
Definition diagram := list (positive * edge).
Definition renames (c : claim) (D D' : diagram) : Prop :=
  Forall2 (fun p p' => fst p' = fst p /\ after_flip (fst p) c (snd p) = Some (snd p')) D D'.
Inductive allowed : list claim -> R -> diagram -> Prop :=
| at_start t : allowed [] t (PositiveMap.elements (edges P))
| not_over c past t D : (forall k lo hi, bracket_of k c = Some (lo, hi) -> t < IZR hi) -> allowed past t D -> allowed (c :: past) t D
| already c past t D D' : (forall k lo hi, bracket_of k c = Some (lo, hi) -> IZR lo <= t) -> allowed past t D -> renames c D D' ->
    allowed (c :: past) t D'.

(* t lies in the bracket of a flip of this very edge. *)
Definition flipping (k : positive) (past : list claim) (t : R) : Prop :=
  exists c lo hi, In c past /\ own k c = true /\ bracket_of k c = Some (lo, hi) /\ IZR lo <= t < IZR hi.

(* A collision of the two is claimed at a time u within the tolerance of t: not before t, or the two overlap at u. *)
Definition near_collision (past : list claim) (i j : gen) (t : R) : Prop :=
  exists later earlier u vi vj ps b a k n, past = later ++ Collision u i j vi vj ps b a k n :: earlier /\
    Rabs (t - IZR u) <= IZR (tolerance P) /\
    (t <= IZR u \/ ~ apart (on_leg i (last_leg i earlier) (IZR u)) (on_leg j (last_leg j earlier) (IZR u))).

(* Maneuvers: a claim is of the first of its disk that has not been claimed. *)
Fixpoint take (g : gen) (ms : list maneuver) : option (maneuver * list maneuver) :=
  match ms with
  | [] => None
  | m :: ms => if Pos.eqb (who m) g then Some (m, ms)
               else match take g ms with Some (n, rest) => Some (n, m :: rest) | None => None end
  end.

Fixpoint pending (past : list claim) : option (list maneuver) :=
  match past with
  | [] => Some (schedule P)
  | Maneuver _ g _ _ _ :: past => bind (pending past) (fun ms => bind (take g ms) (fun r => Some (snd r)))
  | _ :: past => pending past
  end.

Open Scope Z_scope.

Definition near (t u : Z) : Prop := Z.abs (t - u) <= tolerance P.
Definition dot (a b : Z * Z) : Z := fst a * fst b + snd a * snd b.
Definition minus (a b : Z * Z) : Z * Z := (fst a - fst b, snd a - snd b).
Definition times (k : Z) (a : Z * Z) : Z * Z := (k * fst a, k * snd a).
Definition velocity (l : leg) : Z * Z := (vx l, vy l).

(* lambda (|v_i|^2 + |v_j|^2)^(1/2) is at least |off| / scale. *)
Definition within_law (vi vj off : Z * Z) (scale : Z) : Prop :=
  let (num, den) := law_tolerance P in
  den * den * dot off off <= num * num * (dot vi vi + dot vj vj) * (scale * scale).

(* The law of collision (formats.md, section 6): with n = c_j - c_i at time t, vi and vj before and wi and wj after it, each
   velocity is the law's but for lambda (|vi|^2 + |vj|^2)^(1/2). The two sides are multiplied by the denominators. *)
Definition law_of_disks (n vi vj wi wj : Z * Z) (mi mj : Z) : Prop :=
  let (num, den) := disk_restitution P in
  let q := (den + num) * dot (minus vj vi) n in
  let scale := den * (mi + mj) * dot n n in
  0 < scale /\
  within_law vi vj (minus (times scale (minus wi vi)) (times (mj * q) n)) scale /\
  within_law vi vj (minus (times scale (minus wj vj)) (times (- mi * q) n)) scale.

Definition law_of_wall (n v w : Z * Z) : Prop :=
  let (num, den) := wall_restitution P in
  let scale := den * dot n n in
  0 < scale /\
  if whole_law P then within_law v (0, 0) (minus (times scale w) (times num (minus (times (dot n n) v) (times (2 * dot v n) n)))) scale
  else within_law v (0, 0) (minus (times scale (minus w v)) (times (- (den + num) * dot v n) n)) scale.

(* A centre that a claim gives is the path's at that time, but for the tolerance times the speeds before and after, and four
   units in the last place of a binary64: tau^2 (|v|^2 + |w|^2) + (4 |p| / 2^53)^2 bounds the square of its error. *)
Definition centre_true (past : list claim) (c : claim) (t : Z) (gp : gen * (Z * Z)) : Prop :=
  let (g, p) := gp in
  let l := last_leg g past in
  let w := match turn_of c g with Some (_, w) => w | None => velocity l end in
  let off := minus p (x_at l t, y_at l t) in
  2 ^ 102 * dot off off <= 2 ^ 102 * (tolerance P * tolerance P * (dot (velocity l) (velocity l) + dot w w)) + dot p p.

(* How wide the bracket of a flip may be: what the rounding of its time to a binary64 asks for, and no more. *)
Definition widest (t : Z) : Z := 2 * Z.max 4 (t / 2 ^ 51).

(* What each claim says, after those of its past. *)
Definition claim_true (past : list claim) (c : claim) : Prop :=
  match c with
  | Flip t f lo hi k k1 k2 k3 k4 =>
      (* the edge is named, those beside it are four others; its bracket lies within the tolerance of the claimed time
         and is narrow, or one instant *)
      (last_edge k past = Some f \/ last_edge k past = Some (reversed f)) /\
      NoDup [k; k1; k2; k3; k4] /\
      (t - tolerance P <= lo <= hi /\ hi <= t + tolerance P /\ 0 < lo /\ hi - lo <= widest t) /\
      let at_ u g := on_leg g (last_leg g past) u in
      let edge_is say (u : R) := say (at_ u (el f)) (at_ u (er f)) (at_ u (es f)) (at_ u (ee f)) : Prop in
      (forall g, In g [el f; er f; es f; ee f] -> since (last_leg g past) <= lo) /\
      (* the edge is there, and legal when the bracket begins; when it ends, both circles are entered by the generator opposite *)
      (forall u, (IZR lo <= u <= IZR hi)%R -> edge_is there u) /\
      edge_is legal (IZR lo) /\
      (lo < hi -> edge_is entered (IZR hi)) /\
      (* a bracket of one instant: then the circles are one, from then on they touch or are entered, and soon they are
         entered, or still one while the rule wants the other edge *)
      (lo = hi -> edge_is pinched (IZR lo) /\ exists u, (IZR lo < u)%R /\ (forall w, (IZR lo <= w < u)%R -> edge_is passed w) /\
        (edge_is entered u \/ (largest f = false /\ edge_is pinched u))) /\
      (* in between, at some instant, the circle of a vertex touches all four *)
      exists (u : R) o, (IZR lo <= u <= IZR hi)%R /\
        (vertex_circle o (at_ u (el f)) (at_ u (es f)) (at_ u (er f)) /\ touches o (at_ u (ee f)))
  | Collision t i j wi wj centres before after k around =>
      (* the two are neighbours: the edge number k lies between them; the second is a disk *)
      j <> container /\
      (exists q, last_edge k past = Some q /\ ((el q = i /\ er q = j) \/ (el q = j /\ er q = i))) /\
      (* they come into contact within the tolerance of the claimed time, on the lines on which they are, and on these would
         overlap after that *)
      (exists u w : R, (Rabs (u - IZR t) <= IZR (tolerance P))%R /\ (u <= w <= IZR t + IZR (tolerance P))%R /\
        (IZR (since (last_leg i past)) <= u)%R /\ (IZR (since (last_leg j past)) <= u)%R /\
        in_contact (on_leg i (last_leg i past) u) (on_leg j (last_leg j past) u) /\
        ~ apart (on_leg i (last_leg i past) w) (on_leg j (last_leg j past) w)) /\
      (* the law is kept, with the places of the paths at the claimed time *)
      (let li := last_leg i past in let lj := last_leg j past in
      let n := minus (x_at lj t, y_at lj t) (x_at li t, y_at li t) in
      if Pos.eqb i container then law_of_wall n (velocity lj) wj
      else exists bi bj, PositiveMap.find i (bodies P) = Some bi /\ PositiveMap.find j (bodies P) = Some bj /\
        law_of_disks n (velocity li) (velocity lj) wi wj (mass bi) (mass bj)) /\
      Forall (centre_true past c t) centres
  | Maneuver t g v centres around =>
      (exists ms m rest, pending past = Some ms /\ take g ms = Some (m, rest) /\ near (due m) t /\ due m <= horizon P /\
        within_law (dvx m, dvy m) (0, 0) (minus v (dvx m, dvy m)) 1) /\
      Forall (centre_true past c t) centres
  end.

(* The sides of an edge: (a,b,c) where it lies between a and b, and [a,b,c] is the vertex at one of its ends. *)
Definition side_of (q : edge) (a b c : gen) : Prop :=
  (a = el q /\ b = er q /\ c = ee q) \/ (a = er q /\ b = el q /\ c = es q).

Definition between (q : edge) (a b : gen) : Prop := (el q = a /\ er q = b) \/ (el q = b /\ er q = a).

(* The initial diagram, at time 0: at each vertex of an edge three edges meet, on each side one; they name generators of the scene; and
   the circle of each vertex is there, with its contacts counterclockwise, and empty of all generators. *)
Record true_initial : Prop := {
  sides_once : forall k k' q q' a b c, PositiveMap.find k (edges P) = Some q -> PositiveMap.find k' (edges P) = Some q' ->
    side_of q a b c -> side_of q' a b c -> k = k';
  sides_closed : forall k q a b c, PositiveMap.find k (edges P) = Some q -> side_of q a b c ->
    exists k' q', PositiveMap.find k' (edges P) = Some q' /\ side_of q' b c a;
  generators_there : forall k q a b c, PositiveMap.find k (edges P) = Some q -> side_of q a b c ->
    PositiveMap.find a (bodies P) <> None /\ PositiveMap.find b (bodies P) <> None /\ PositiveMap.find c (bodies P) <> None;
  vertices_empty : forall k q a b c, PositiveMap.find k (edges P) = Some q -> side_of q a b c ->
    exists o, vertex_circle o (place [] 0%R a) (place [] 0%R b) (place [] 0%R c) /\
      forall g, PositiveMap.find g (bodies P) <> None -> empty_of o (place [] 0%R g)
}.

(* The four of the edge q, on the lines that they are on at time t, are not always cotangent; or q is the edge that the rule
   wants where they are. *)
Definition tie_broken (past : list claim) (t : R) (q : edge) : Prop :=
  largest q = true \/ exists u : R, let on g := on_leg g (leg_at g past t) u in not_cotangent (on (el q)) (on (er q)) (on (es q)) (on (ee q)).

(* All that the theorem says of a history. *)
Record true_history (past : list claim) : Prop := {
  (* Every claim is true, after those before it. *)
  claims_true : forall later c earlier, past = later ++ c :: earlier -> claim_true earlier c;
  (* Nothing scheduled up to the horizon is left out. *)
  maneuvers_done : exists ms, pending past = Some ms /\ forall m, In m ms -> horizon P < due m;
  (* No edge is lost: at all times each number names an edge. *)
  edges_remain : forall k t, PositiveMap.find k (edges P) <> None -> edge_at k past t <> None;
  (* From 0 to the horizon, outside the brackets of its flips and of those beside it, every edge is legal at every
     instant: both circles exist, with their contacts counterclockwise, and neither is entered by the generator opposite;
     and ties that last are broken by the rule. *)
  edges_legal : forall k q t, (0 <= t < IZR (horizon P))%R -> edge_at k past t = Some q -> ~ bracketed k past t ->
    legal (place past t (el q)) (place past t (er q)) (place past t (es q)) (place past t (ee q)) /\ tie_broken past t q;
  (* But in the brackets of its own flips, at every instant the edge lasts, by each of its names. *)
  edges_last : forall k q t, (0 <= t < IZR (horizon P))%R -> In q (names_at k past t) -> ~ flipping k past t ->
    let moving g u := place past u g in lasts (moving (el q)) (moving (er q)) (moving (es q)) (moving (ee q)) t;
  (* By each of its names the edge stands at every instant. *)
  edges_stand : forall k q t, (0 <= t < IZR (horizon P))%R -> In q (names_at k past t) ->
    stands (place past t (el q)) (place past t (er q)) (place past t (es q)) (place past t (ee q));
  (* At every instant, by each of its names, the two generators of an edge do not overlap but near a claimed collision of the two. *)
  pairs_apart : forall k q t, (0 <= t < IZR (horizon P))%R -> In q (names_at k past t) ->
    apart (place past t (el q)) (place past t (er q)) \/
    near_collision past (el q) (er q) t \/ near_collision past (er q) (el q) t
}.

(* D is the Voronoi diagram at time t: the circle of each vertex is there and empty of all generators; the three sides of each vertex
   belong to edges; and of two generators that overlap one overlaps a neighbour, near a claimed collision of the two. *)
Record voronoi_at (past : list claim) (t : R) (D : diagram) : Prop := {
  circles_empty_at : forall k q a b c, In (k, q) D -> side_of q a b c ->
    exists o, vertex_circle o (place past t a) (place past t b) (place past t c) /\
      forall g, PositiveMap.find g (bodies P) <> None -> empty_of o (place past t g);
  sides_close_at : forall k q a b c, In (k, q) D -> side_of q a b c -> exists k' q', In (k', q') D /\ side_of q' b c a;
  all_there_at : forall g, PositiveMap.find g (bodies P) <> None -> exists k q, In (k, q) D /\ (el q = g \/ er q = g);
  overlaps_at : forall i j, PositiveMap.find i (bodies P) <> None -> PositiveMap.find j (bodies P) <> None -> i <> j ->
    ~ apart (place past t i) (place past t j) -> exists k q a b, In (k, q) D /\ between q a b /\ (a = i \/ a = j) /\
      ~ apart (place past t a) (place past t b) /\ (near_collision past a b t \/ near_collision past b a t)
}.
End History.
