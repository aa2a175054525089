(* The check of the initial diagram, at time 0. *)
From Coq Require Import ZArith List Bool FMapPositive.
From Voroproof Require Import Forms Polynomial Piece History Replay.
Import ListNotations.
Open Scope Z_scope.

Definition triple : Type := gen * gen * gen.
Definition triple_eqb (s t : triple) : bool :=
  let '(a, b, c) := s in let '(d, e, f) := t in Pos.eqb a d && Pos.eqb b e && Pos.eqb c f.

(* Maps from triples. *)
Definition triples (A : Type) := PositiveMap.t (PositiveMap.t (PositiveMap.t A)).
Definition find3 {A} (m : triples A) (t : triple) : option A :=
  let '(a, b, c) := t in
  bind (PositiveMap.find a m) (fun m => bind (PositiveMap.find b m) (fun m => PositiveMap.find c m)).
Definition or_empty {A} (m : option (PositiveMap.t A)) : PositiveMap.t A := match m with Some m => m | None => PositiveMap.empty A end.
Definition add3 {A} (t : triple) (v : A) (m : triples A) : triples A :=
  let '(a, b, c) := t in
  let ma := or_empty (PositiveMap.find a m) in let mb := or_empty (PositiveMap.find b ma) in
  PositiveMap.add a (PositiveMap.add b (PositiveMap.add c v mb) ma) m.

(* Where an edge lies between a and b and c is the third generator of the vertex [a,b,c] at one of its ends, (a,b,c) is a
   side of that vertex, and the edge's. *)
Definition sides (q : edge) : list triple := [(el q, er q, ee q); (er q, el q, es q)].
Definition next_side (t : triple) : triple := let '(a, b, c) := t in (b, c, a).

(* The same vertex named from its smallest generator on. *)
Definition canonical (t : triple) : triple :=
  let '(a, b, c) := t in
  if Pos.ltb b a && Pos.ltb b c then (b, c, a) else if Pos.ltb c a && Pos.ltb c b then (c, a, b) else (a, b, c).

(* e does not enter the circle of the disk i and j, k; their minors are given. *)
Definition not_negative_at (f x y : Z) : bool :=
  ((0 <=? f) && (0 <=? x)) || ((f <=? 0) && (0 <=? y)) || ((0 <=? x) && (0 <=? y)).
Definition outside (w : bool) (sp xp yp xs ys xy : Z) (we : bool) (e : row Z) : bool :=
  let a := rx e * sp - rs e * xp + rp e * xs in
  let b := ry e * sp - rs e * yp + rp e * ys in
  let c := rx e * yp - ry e * xp + rp e * xy in
  not_negative_at (a * a + b * b - c * c) (with_sign we (xp * a + yp * b)) (with_sign (xorb we w) c) &&
  (negb we || (rp e <? 0)).

Definition still (b : body) (g : gen) : moving := span g (Mover (start b) (body_radius b)) 0 0.

(* The circle of the disk i and j, k is there and empty of all. *)
Definition empty_circle (all : list (gen * moving)) (i j k : moving) : bool :=
  let pj := prow i j in let pk := prow i k in let zj := zrow i j in let zk := zrow i k in
  negb (mwall i) && is_proper i && circle_there (mwall j) (mwall k) pj pk zj zk &&
  (let sp := dsp Z.sub Z.mul zj zk in let xp := dxp Z.sub Z.mul zj zk in let yp := dyp Z.sub Z.mul zj zk in
   let xs := dxs Z.sub Z.mul zj zk in let ys := dys Z.sub Z.mul zj zk in let xy := dxy Z.sub Z.mul zj zk in
   forallb (fun g => is_proper (snd g) && outside (mwall j || mwall k) sp xp yp xs ys xy (mwall (snd g)) (zrow i (snd g))) all).

Definition vertex_ok (all : list (gen * moving)) (find : gen -> option moving) (t : triple) : bool :=
  let '(a, b, c) := t in
  match find a, find b, find c with
  | Some i, Some j, Some k => if mwall i then empty_circle all j k i else empty_circle all i j k
  | _, _, _ => false
  end.

(* Numbers for the vertices of the diagram. *)
Definition number (n : positive * PositiveMap.t triple * triples positive) (t : triple) :=
  let '(next, names, numbers) := n in
  match find3 numbers t with
  | Some _ => n
  | None => (Pos.succ next, PositiveMap.add next t names, add3 t next numbers)
  end.

Section Initial.
Variable P : problem.

Definition all_still : list (gen * moving) := map (fun b => (fst b, still (snd b) (fst b))) (PositiveMap.elements (bodies P)).
Definition find_still (g : gen) : option moving :=
  match PositiveMap.find g (bodies P) with Some b => Some (still b g) | None => None end.

Definition owned (owner : triples positive) (k : positive) (t : triple) : bool :=
  match find3 owner t, find3 owner (next_side t) with
  | Some k0, Some k1 =>
      Pos.eqb k0 k && match PositiveMap.find k1 (edges P) with Some q => existsb (triple_eqb (next_side t)) (sides q) | None => false end
  | _, _ => false
  end.

Definition numbered (names : PositiveMap.t triple) (numbers : triples positive) (t : triple) : bool :=
  match find3 numbers (canonical t) with
  | Some v => match PositiveMap.find v names with Some u => triple_eqb u (canonical t) | None => false end
  | None => false
  end.

(* The maps are found by the program and believed by nobody. *)
Definition initial_with (owner : triples positive) (names : PositiveMap.t triple) (numbers : triples positive) : bool :=
  let es := PositiveMap.elements (edges P) in
  let all := all_still in
  forallb (fun kq => forallb (fun t => owned owner (fst kq) t && numbered names numbers t) (sides (snd kq))) es &&
  forallb (fun vt => vertex_ok all find_still (snd vt)) (PositiveMap.elements names).

Definition initial_ok : bool :=
  let all := PositiveMap.elements (edges P) in
  let owner := fold_left (fun m kq => fold_left (fun m t => add3 t (fst kq) m) (sides (snd kq)) m) all (PositiveMap.empty _) in
  let '(_, names, numbers) :=
    fold_left (fun n kq => fold_left (fun n t => number n (canonical t)) (sides (snd kq)) n) all
      (1%positive, PositiveMap.empty triple, PositiveMap.empty _) in
  initial_with owner names numbers.
End Initial.
