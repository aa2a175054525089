(* What the program reads, in fractions, and how it is brought to whole numbers. No proofs.

   The part that reads files (docs/proved.md, section 2) makes a scene and a history of them; ids of generators are already
   those of History.v, and the container, which has no velocity, is given 0 for one. *)
From Coq Require Import ZArith QArith List Bool FMapPositive.
From Voroproof Require Import History.
Import ListNotations.
Open Scope Z_scope.

Record disk := Disk { disk_centre : Q * Q; disk_radius : Q; disk_velocity : Q * Q; disk_mass : Q }.

Record scene := Scene {
  box_centre : Q * Q;
  box_radius : Q;
  restitution : Q;
  restitution_of_wall : Q;
  law_is_whole : bool;
  scene_horizon : Q;
  disks : list disk;
  plan : list (Q * gen * (Q * Q))       (* maneuvers: when, which disk, to which velocity *)
}.

(* The lines of a history; [A] are fractions, or whole numbers of units. Centres are given of some generators or of none. *)
Inductive event (A : Type) :=
| Flipped (t : A) (q : edge)
| Collided (t : A) (i j : gen) (v : option ((A * A) * (A * A))) (centres : list (gen * (A * A)))
| Maneuvered (t : A) (g : gen) (v : option (A * A)) (centres : list (gen * (A * A))).
Arguments Flipped {A}. Arguments Collided {A}. Arguments Maneuvered {A}.

Record history := Written {
  history_horizon : Q;
  first_edges : option (list edge);
  events : list (event Q);
  stops : bool;                         (* it says itself that it stops before its horizon *)
  counts : Z * Z * Z                    (* flips, collisions and maneuvers, by its last line *)
}.

(* z is the fraction q in a unit of which there are u to 1. *)
Definition in_unit (u : Z) (q : Q) (z : Z) : Prop := (inject_Z z == q * inject_Z u)%Q.
Definition both_in_unit (u : Z) (q : Q * Q) (z : Z * Z) : Prop := in_unit u (fst q) (fst z) /\ in_unit u (snd q) (snd z).
Definition is_fraction (q : Q) (z : Z * Z) : Prop := z = (Qnum q, Zpos (Qden q)).

(* The generators: the container first, as a disk of the radius -R at rest. *)
Definition generators (s : scene) : list disk := Disk (box_centre s) (- box_radius s) (0%Q, 0%Q) 0%Q :: disks s.
Definition numbered {A} (l : list A) (k : positive) : option A := nth_error l (pred (Pos.to_nat k)).

(* With t units of time, v of velocity and m of mass to 1, and tv units of length. *)
Section Units.
Variables t v m : Z.

Definition disk_is (d : disk) (b : body) : Prop :=
  in_unit (t * v) (disk_radius d) (body_radius b) /\ in_unit m (disk_mass d) (mass b) /\ since (start b) = 0 /\
  both_in_unit (t * v) (disk_centre d) (x (start b), y (start b)) /\ both_in_unit v (disk_velocity d) (vx (start b), vy (start b)).

Definition maneuver_is (p : Q * gen * (Q * Q)) (n : maneuver) : Prop :=
  in_unit t (fst (fst p)) (due n) /\ snd (fst p) = who n /\ both_in_unit v (snd p) (dvx n, dvy n).

Definition centre_is (p : gen * (Q * Q)) (n : gen * (Z * Z)) : Prop := fst p = fst n /\ both_in_unit (t * v) (snd p) (snd n).

(* The claim says what the line says. *)
Inductive event_is : event Q -> claim -> Prop :=
| flip_is u q n lo hi k k1 k2 k3 k4 : in_unit t u n -> event_is (Flipped u q) (Flip n q lo hi k k1 k2 k3 k4)
| collision_is u i j vi vj ps n wi wj ns before after k around :
    in_unit t u n -> both_in_unit v vi wi -> both_in_unit v vj wj -> Forall2 centre_is ps ns ->
    event_is (Collided u i j (Some (vi, vj)) ps) (Collision n i j wi wj ns before after k around)
| maneuvered_is u g w ps n z ns around :
    in_unit t u n -> both_in_unit v w z -> Forall2 centre_is ps ns ->
    event_is (Maneuvered u g (Some w) ps) (Maneuver n g z ns around).

(* The problem is that of the files, with the tolerances that are asked for. *)
Record problem_is (s : scene) (h : history) (tau lambda : Q) (P : problem) : Prop := {
  bodies_are : forall g, match numbered (generators s) g, PositiveMap.find g (bodies P) with
                         | Some d, Some b => disk_is d b | None, None => True | _, _ => False end;
  edges_are : forall k, PositiveMap.find k (edges P) = match first_edges h with Some l => numbered l k | None => None end;
  schedule_is : Forall2 maneuver_is (plan s) (schedule P);
  restitution_is : is_fraction (restitution s) (disk_restitution P);
  wall_is : is_fraction (restitution_of_wall s) (wall_restitution P);
  law_is : whole_law P = law_is_whole s;
  horizon_is : in_unit t (history_horizon h) (horizon P);
  tolerance_is : in_unit t tau (tolerance P);
  law_tolerance_is : is_fraction lambda (law_tolerance P)
}.
End Units.
