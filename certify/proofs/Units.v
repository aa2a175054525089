(* Brings what files say to whole numbers. How the units are found is believed by nobody: a number that is no multiple of its
   unit is refused. *)
From Coq Require Import ZArith QArith List Bool FMapPositive.
From Voroproof Require Import History Replay Files.
Import ListNotations.
Open Scope Z_scope.

Definition to_unit (u : Z) (q : Q) : outcome Z :=
  let '(z, rest) := Z.div_eucl (Qnum q * u) (Zpos (Qden q)) in need (rest =? 0) NoMultiple (Good z).
Definition both (u : Z) (q : Q * Q) : outcome (Z * Z) := do a <- to_unit u (fst q); do b <- to_unit u (snd q); Good (a, b).

(* One after the other; the list may be long. *)
Fixpoint all_onto {A B} (f : A -> outcome B) (l : list A) (done : list B) : outcome (list B) :=
  match l with [] => Good (rev' done) | a :: l => do b <- f a; all_onto f l (b :: done) end.
Definition all {A B} (f : A -> outcome B) (l : list A) : outcome (list B) := all_onto f l [].

(* A list as a map from its places, the first being [k]. *)
Fixpoint map_from {A} (k : positive) (l : list A) (m : PositiveMap.t A) : PositiveMap.t A :=
  match l with [] => m | a :: l => map_from (Pos.succ k) l (PositiveMap.add k a m) end.
Definition numbers {A} (l : list A) : PositiveMap.t A := map_from 1 l (PositiveMap.empty A).

Section Conversion.
Variables t v m : Z.

Definition body_of (d : disk) : outcome body :=
  do r <- to_unit (t * v) (disk_radius d);
  do w <- to_unit m (disk_mass d);
  do c <- both (t * v) (disk_centre d);
  do u <- both v (disk_velocity d);
  Good (Body r w (Leg 0 (fst c) (snd c) (fst u) (snd u))).

Definition maneuver_of (p : Q * gen * (Q * Q)) : outcome maneuver :=
  let '(when, g, w) := p in do n <- to_unit t when; do u <- both v w; Good (Scheduled n g (fst u) (snd u)).

Definition centre_of (p : gen * (Q * Q)) : outcome (gen * (Z * Z)) := do c <- both (t * v) (snd p); Good (fst p, c).

Definition event_of (e : event Q) : outcome (event Z) :=
  match e with
  | Flipped u q => do n <- to_unit t u; Good (Flipped n q)
  | Collided u i j w ps =>
      do n <- to_unit t u;
      do z <- match w with
              | Some (a, b) => do a <- both v a; do b <- both v b; Good (Some (a, b))
              | None => Good None
              end;
      do ns <- all centre_of ps;
      Good (Collided n i j z ns)
  | Maneuvered u g w ps =>
      do n <- to_unit t u;
      do z <- match w with Some w => do w <- both v w; Good (Some w) | None => Good None end;
      do ns <- all centre_of ps;
      Good (Maneuvered n g z ns)
  end.

Definition fraction (q : Q) : Z * Z := (Qnum q, Zpos (Qden q)).

Definition problem_of (s : scene) (h : history) (tau lambda : Q) : outcome problem :=
  need ((0 <? t) && (0 <? v) && (0 <? m)) NoMultiple (
  do bs <- all body_of (generators s);
  do ms <- all maneuver_of (plan s);
  do T <- to_unit t (history_horizon h);
  do n <- to_unit t tau;
  Good (Problem (numbers bs) ms (fraction (restitution s)) (fraction (restitution_of_wall s)) (law_is_whole s) T n (fraction lambda)
    (numbers (match first_edges h with Some l => l | None => [] end)))).
End Conversion.

(* The units: common multiples of denominators. *)
Definition enough (u : Z) (q : Q) : Z := let d := Zpos (Qden q) in if u mod d =? 0 then u else Z.lcm u d.
Definition enough_for (l : list (Q * Q)) (u : Z) : Z := fold_left (fun u p => enough (enough u (fst p)) (snd p)) l u.

Definition time_in (e : event Q) : Q := match e with Flipped u _ => u | Collided u _ _ _ _ => u | Maneuvered u _ _ _ => u end.
Definition velocities_in (e : event Q) : list (Q * Q) :=
  match e with Collided _ _ _ (Some (a, b)) _ => [a; b] | Maneuvered _ _ (Some a) _ => [a] | _ => [] end.
Definition centres_in (e : event Q) : list (Q * Q) :=
  match e with Flipped _ _ => [] | Collided _ _ _ _ ps => map snd ps | Maneuvered _ _ _ ps => map snd ps end.

(* Brackets are narrower than a unit in the last place of the horizon. *)
Definition finest (T : Q) : Z :=
  let h := Qnum T / Zpos (Qden T) in 2 ^ Z.max 0 (64 - (if h <=? 0 then 0 else Z.log2 h + 1)).

Definition unit_of_time (s : scene) (h : history) (tau : Q) : Z :=
  let u := enough (enough 1 (history_horizon h)) tau in
  let u := fold_left (fun u e => enough u (time_in e)) (events h) u in
  let u := fold_left (fun u p => enough u (fst (fst p))) (plan s) u in
  Z.lcm u (finest (history_horizon h)).

Definition unit_of_velocity (s : scene) (h : history) (t : Z) : Z :=
  let v := enough_for (map disk_velocity (disks s) ++ map snd (plan s)) 1 in
  let v := fold_left (fun u e => enough_for (velocities_in e) u) (events h) v in
  let l := enough_for (map disk_centre (generators s) ++ map (fun d => (disk_radius d, 0%Q)) (generators s)) (t * v) in
  fold_left (fun u e => enough_for (centres_in e) u) (events h) l / t.

Definition unit_of_mass (s : scene) : Z := fold_left (fun u d => enough u (disk_mass d)) (disks s) 1.
