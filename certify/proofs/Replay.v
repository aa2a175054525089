(* The checker: it replays the claims and proves each life of an edge and of a pair when it ends. *)
From Coq Require Import ZArith List Bool FMapPositive.
From Voroproof Require Import Geometry Forms Polynomial Piece History.
Import ListNotations.
Open Scope Z_scope.

(* Why a history is not accepted. *)
Inductive reason :=
| UnknownGenerator | UnknownEdge | NotBeside | WrongName | BadBracket | EdgeTooYoung | MotionTooYoung | NotLegal | NotLasting | Tied | Overlap
| NoCollapse | Slides | OutOfOrder | NotNeighbours | NoContact | NotTheLaw | CentreElsewhere | NoSuchManeuver | ManeuverLeftOut | BadInitial
(* of what comes before the checker *)
| NoMultiple | NoVelocity | NoBracket.

Inductive outcome (A : Type) := Good (a : A) | Bad (why : reason).
Arguments Good {A}. Arguments Bad {A}.
Definition try {A B} (a : outcome A) (f : A -> outcome B) : outcome B := match a with Good x => f x | Bad w => Bad w end.
Definition need {B} (b : bool) (w : reason) (f : outcome B) : outcome B := if b then f else Bad w.
Definition known {A} (a : option A) (w : reason) : outcome A := match a with Some x => Good x | None => Bad w end.
Notation "'do' x <- a ; b" := (try a (fun x => b)) (at level 200, x pattern, a at level 100, b at level 200).

(* A generator's present leg and radius. *)
Record mover := Mover { path : leg; size_ : Z }.
(* An edge of the present diagram. It has been proved legal up to [proved], its pair apart up to [pair_proved]; from [opened]
   to [proved] all times lie in brackets. Where these are brackets of flips beside it, [others] are the further names that
   it may have while these flips are under way; all have been proved legal from [opened] to [proved]. *)
Record slot := Slot { name : edge; opened : Z; proved : Z; pair_proved : Z; others : list edge }.
Record state := State { movers : PositiveMap.t mover; slots : PositiveMap.t slot; now : Z; todo : list maneuver }.

Section Replay.
Variable P : problem.

Definition span (g : gen) (m : mover) (a b : Z) : moving :=
  Moving (x_at (path m) a) (y_at (path m) a) (x_at (path m) b) (y_at (path m) b) (size_ m) (Pos.eqb g container).

Definition mover_of (s : state) (g : gen) : outcome mover := known (PositiveMap.find g (movers s)) UnknownGenerator.

(* The four of an edge over [a, b), and whether their legs have begun by [birth]. *)
Definition four {T} (s : state) (q : edge) (birth a b : Z) (test : moving -> moving -> moving -> moving -> T) : outcome T :=
  do l <- mover_of s (el q); do r <- mover_of s (er q); do i <- mover_of s (es q); do e <- mover_of s (ee q);
  need ((since (path l) <=? birth) && (since (path r) <=? birth) && (since (path i) <=? birth) && (since (path e) <=? birth))
    MotionTooYoung
    (Good (test (span (el q) l a b) (span (er q) r a b) (span (es q) i a b) (span (ee q) e a b))).

(* The four are not cotangent when their life begins, or when it ends. *)
Definition untied (s : state) (q : edge) (birth upto : Z) : outcome bool :=
  do b <- four s q birth birth birth (by_fan fan_strict_at);
  if b : bool then Good true else four s q birth upto upto (by_fan fan_strict_at).

(* Proves the edge up to [upto] and its pair up to [pair_upto]. *)
Definition settle (s : state) (sl : slot) (upto pair_upto : Z) : outcome unit :=
  do legal <- (if proved sl <? upto then four s (name sl) (proved sl) (proved sl) upto edge_legal else Good true);
  need legal NotLegal (
  do broken <- (if (proved sl <? upto) && negb (largest (name sl)) then untied s (name sl) (proved sl) upto else Good true);
  need broken Tied (
  do apart <- (if pair_proved sl <? pair_upto
               then four s (name sl) (pair_proved sl) (pair_proved sl) pair_upto (fun l r _ _ => pair_apart depth l r) else Good true);
  need apart Overlap (Good tt))).

Definition slot_of (s : state) (k : positive) : outcome slot := known (PositiveMap.find k (slots s)) UnknownEdge.

Definition put (s : state) (k : positive) (sl : slot) : state := State (movers s) (PositiveMap.add k sl (slots s)) (now s) (todo s).

Fixpoint every {A} (test : A -> outcome bool) (w : reason) (l : list A) : outcome unit :=
  match l with [] => Good tt | a :: l => do b <- test a; need b w (every test w l) end.
Fixpoint all_known {A B} (f : A -> option B) (w : reason) (l : list A) : outcome (list B) :=
  match l with [] => Good [] | a :: l => do b <- known (f a) w; do bs <- all_known f w l; Good (b :: bs) end.

(* The edge k has been settled up to lo. It flips. By each name that it may have just before hi it stands at hi. *)
Definition own_flip (s : state) (sl : slot) (lo hi : Z) (new : edge) : outcome slot :=
  need (proved sl <=? lo) EdgeTooYoung (
  do _ <- settle s sl lo hi;
  do apart <- (if lo <? hi then four s new lo lo hi (fun l r _ _ => pair_apart depth l r) else Good true);
  need apart Overlap (
  do _ <- (if lo <? hi then every (fun q => four s q lo lo hi edge_there) NotLasting [name sl; new] else Good tt);
  do _ <- every (fun q => four s q lo hi hi edge_there) NotLasting (if lo <? hi then [name sl; new] else [name sl]);
  Good (Slot new lo hi hi []))).

(* A flip beside the edge k changes one of its ends. The other end may change in the same bracket: until its end the edge may
   have the names that any of these flips leave and make. *)
Definition beside_flip (s : state) (sl : slot) (lo hi : Z) (new : edge -> option edge) : outcome slot :=
  let alone := proved sl <=? lo in
  need (alone || (opened sl =? lo) && (proved sl =? hi) && match others sl with [] => false | _ => true end) EdgeTooYoung (
  do _ <- settle s sl lo hi;
  let olds := name sl :: (if alone then [] else others sl) in
  do news <- all_known new NotBeside olds;
  do _ <- (if lo <? hi then every (fun q => four s q lo lo hi edge_lasts) NotLasting (if alone then name sl :: news else news) else Good tt);
  do _ <- every (fun q => four s q lo hi hi edge_there) NotLasting (if lo <? hi then news ++ olds else olds);
  match news with
  | [] => Bad NotBeside
  | n :: news => Good (Slot n lo hi (Z.max (pair_proved sl) hi) (if lo <? hi then news ++ olds else []))
  end).

Definition flip_one (c : claim) (lo hi : Z) (k : positive) (s : state) : outcome state :=
  do sl <- slot_of s k;
  do sl <- match corner k c with
    | Some _ => beside_flip s sl lo hi (after_flip k c)
    | None => do new <- known (after_flip k c (name sl)) NotBeside; own_flip s sl lo hi new
    end;
  Good (put s k sl).


(* The edge collapses between lo and hi: it is legal at lo, entered at hi, and there throughout. Or it collapses at lo = hi: its
   circles are one, which touches all four. From then on they are not empty but for touches; soon they are entered, or are still
   one while the rule wants the other edge. *)
Definition soon : Z := 4.
Definition collapses (s : state) (f : edge) (lo hi : Z) : outcome bool :=
  if lo =? hi then
    let u := lo + soon in
    do a <- four s f lo lo lo (by_fan fan_short_at);
    do b <- four s f lo lo u (by_fan fan_past_at);
    do c <- four s f lo u u (by_fan (if largest f then fan_entered_at else fun i a b c => fan_entered_at i a b c || fan_short_at i a b c));
    Good (a && b && c)
  else
  do a <- four s f lo lo lo (by_fan fan_legal_at);
  do b <- four s f lo hi (hi + 1) (by_fan fan_entered_at);
  do c <- four s f lo lo (hi + 1) (by_fan fan_there);
  Good (a && b && c).

(* One after the other. *)
Fixpoint each (step : positive -> state -> outcome state) (ks : list positive) (s : state) : outcome state :=
  match ks with [] => Good s | k :: ks => do s <- step k s; each step ks s end.

Fixpoint distinct (ks : list positive) : bool :=
  match ks with [] => true | k :: ks => negb (existsb (Pos.eqb k) ks) && distinct ks end.

(* Turns come before the flips of their instant: after a flip at one instant none may come at that instant. *)
Definition flip (s : state) (c : claim) (t : Z) (f : edge) (lo hi : Z) (k k1 k2 k3 k4 : positive) : outcome state :=
  do sl <- slot_of s k;
  need (edge_eqb (name sl) f || edge_eqb (name sl) (reversed f)) WrongName (
  need ((t - tolerance P <=? lo) && (lo <=? hi) && (hi <=? t + tolerance P) && (0 <? lo) && (hi - lo <=? widest t)) BadBracket (
  need (distinct [k; k1; k2; k3; k4] && negb (Pos.eqb (es f) (ee f))) NotBeside (
  do gone <- collapses s f lo hi;
  need gone NoCollapse (
  do s <- each (flip_one c lo hi) [k; k1; k2; k3; k4] s;
  Good (State (movers s) (slots s) (Z.max (now s) (if lo =? hi then hi + 1 else hi)) (todo s)))))).

(* Whether the pair of an edge is i, j. *)
Definition is_pair (i j : gen) (q : edge) : bool :=
  (Pos.eqb (el q) i && Pos.eqb (er q) j) || (Pos.eqb (el q) j && Pos.eqb (er q) i).

(* The edge k ends its life at t, where a generator of it turns; at a collision its pair is not looked at from t - tau on, and
   for [slack] after t. *)
Definition turn_one (own : edge -> bool) (t slack : Z) (k : positive) (s : state) : outcome state :=
  do sl <- slot_of s k;
  do _ <- settle s sl t (if own (name sl) then t - tolerance P else t);
  Good (put s k (Slot (name sl) (if proved sl <? t then t else opened sl) (Z.max (proved sl) t)
     (Z.max (pair_proved sl) (if own (name sl) then t + slack else t)) (if proved sl <? t then [] else others sl))).

(* The generator g turns. *)
Definition turn (c : claim) (g : gen) (s : state) : outcome state :=
  match turn_of c g with
  | None => Good s
  | Some (t, v) =>
      do m <- mover_of s g;
      Good (State (PositiveMap.add g (Mover (turned (path m) t v) (size_ m)) (movers s)) (slots s) (now s) (todo s))
  end.

Definition at_time (s : state) (t : Z) : state := State (movers s) (slots s) t (todo s).

(* Distance squared minus reach squared, for the container the other way round. *)
Definition gap_at (i j : gen) (a b : mover) (t : Z) : Z :=
  let dx := x_at (path a) t - x_at (path b) t in let dy := y_at (path a) t - y_at (path b) t in let r := size_ a + size_ b in
  let g := dx * dx + dy * dy - r * r in if Pos.eqb i container || Pos.eqb j container then - g else g.

Definition touch (i j : gen) (a b : mover) (t before after : Z) : bool :=
  (since (path a) <=? before) && (since (path b) <=? before) && (before <=? after) &&
  (t - tolerance P <=? before) && (after <=? t + tolerance P) &&
  (if Pos.eqb i container || Pos.eqb j container then size_ a + size_ b <=? 0 else 0 <=? size_ a + size_ b) &&
  (0 <=? gap_at i j a b before) && (gap_at i j a b after <? 0).

Definition within_law_b (vi vj off : Z * Z) (scale : Z) : bool :=
  let (num, den) := law_tolerance P in
  den * den * dot off off <=? num * num * (dot vi vi + dot vj vj) * (scale * scale).

Definition law_of_disks_b (n vi vj wi wj : Z * Z) (mi mj : Z) : bool :=
  let (num, den) := disk_restitution P in
  let q := (den + num) * dot (minus vj vi) n in
  let scale := den * (mi + mj) * dot n n in
  (0 <? scale) &&
  within_law_b vi vj (minus (times scale (minus wi vi)) (times (mj * q) n)) scale &&
  within_law_b vi vj (minus (times scale (minus wj vj)) (times (- mi * q) n)) scale.

Definition law_of_wall_b (n v w : Z * Z) : bool :=
  let (num, den) := wall_restitution P in
  let scale := den * dot n n in
  (0 <? scale) &&
  if whole_law P then within_law_b v (0, 0) (minus (times scale w) (times num (minus (times (dot n n) v) (times (2 * dot v n) n)))) scale
  else within_law_b v (0, 0) (minus (times scale (minus w v)) (times (- (den + num) * dot v n) n)) scale.

Definition law (i j : gen) (a b : mover) (t : Z) (wi wj : Z * Z) : bool :=
  let n := minus (x_at (path b) t, y_at (path b) t) (x_at (path a) t, y_at (path a) t) in
  if Pos.eqb i container then law_of_wall_b n (velocity (path b)) wj
  else match PositiveMap.find i (bodies P), PositiveMap.find j (bodies P) with
  | Some bi, Some bj => law_of_disks_b n (velocity (path a)) (velocity (path b)) wi wj (mass bi) (mass bj)
  | _, _ => false
  end.

(* The centres that a claim gives. *)
Definition centre_ok (s : state) (c : claim) (t : Z) (gp : gen * (Z * Z)) : bool :=
  let (g, p) := gp in
  match PositiveMap.find g (movers s) with
  | None => false
  | Some m =>
      let l := path m in
      let w := match turn_of c g with Some (_, w) => w | None => velocity l end in
      let off := minus p (x_at l t, y_at l t) in
      2 ^ 102 * dot off off <=? 2 ^ 102 * (tolerance P * tolerance P * (dot (velocity l) (velocity l) + dot w w)) + dot p p
  end.

Definition collide (s : state) (c : claim) (t : Z) (i j : gen) (wi wj : Z * Z) (centres : list (gen * (Z * Z)))
    (before after : Z) (k : positive) (around : list positive) : outcome state :=
  need (now s <=? t) OutOfOrder (
  do sl <- slot_of s k;
  need (is_pair i j (name sl) && negb (Pos.eqb i j) && negb (Pos.eqb j container)) NotNeighbours (
  do a <- mover_of s i;
  do b <- mover_of s j;
  need (touch i j a b t before after) NoContact (
  need (law i j a b t wi wj) NotTheLaw (
  need (forallb (centre_ok s c t) centres) CentreElsewhere (
  do s <- each (turn_one (is_pair i j) t (if 0 <=? gap_at i j a b t then 0 else tolerance P)) around s;
  do s <- turn c i s;
  do s <- turn c j s;
  Good (at_time s t)))))).

Definition manoeuvre (s : state) (c : claim) (t : Z) (g : gen) (v : Z * Z) (centres : list (gen * (Z * Z)))
    (around : list positive) : outcome state :=
  need (now s <=? t) OutOfOrder (
  do p <- known (take g (todo s)) NoSuchManeuver;
  let (m, rest) := p : maneuver * list maneuver in
  need ((Z.abs (due m - t) <=? tolerance P) && (due m <=? horizon P) &&
        within_law_b (dvx m, dvy m) (0, 0) (minus v (dvx m, dvy m)) 1) NoSuchManeuver (
  need (forallb (centre_ok s c t) centres) CentreElsewhere (
  do s <- each (turn_one (fun _ => false) t 0) around s;
  do s <- turn c g s;
  Good (State (movers s) (slots s) t rest)))).

Definition step (s : state) (c : claim) : outcome state :=
  match c with
  | Flip t f lo hi k k1 k2 k3 k4 => flip s c t f lo hi k k1 k2 k3 k4
  | Collision t i j vi vj centres before after k around => collide s c t i j vi vj centres before after k around
  | Maneuver t g v centres around => manoeuvre s c t g v centres around
  end.

Definition first_state : state :=
  State (PositiveMap.map (fun b => Mover (start b) (body_radius b)) (bodies P))
        (PositiveMap.map (fun q => Slot q 0 0 0 []) (edges P)) 0 (schedule P).

(* At the horizon all lives end. *)
Fixpoint finish (s : state) (ks : list (positive * slot)) : outcome unit :=
  match ks with
  | [] => Good tt
  | (_, sl) :: ks => do _ <- settle s sl (horizon P) (horizon P); finish s ks
  end.

(* [done] counts the claims taken. *)
Fixpoint run (s : state) (cs : list claim) (done : Z) : outcome state * Z :=
  match cs with
  | [] => (Good s, done)
  | c :: cs => match step s c with Good s' => run s' cs (done + 1) | Bad w => (Bad w, done) end
  end.

(* A disk off the container's centre by this, which has this room, touches it and moves along it: then it has no motion. *)
Definition slides (room : Z) (off v : Z * Z) : bool := (dot off off =? room * room) && (dot off v =? 0) && negb (dot v v =? 0).
Definition slides_at (s : state) (t : Z) : bool :=
  match PositiveMap.find container (movers s) with
  | None => false
  | Some box => existsb (fun gm => let m := snd gm in
      slides (- size_ box - size_ m) (x_at (path m) t - x_at (path box) t, y_at (path m) t - y_at (path box) t) (velocity (path m)))
      (PositiveMap.elements (PositiveMap.remove container (movers s)))
  end.

Definition ending (s : state) : outcome unit :=
  need (forallb (fun m => horizon P <? due m) (todo s)) ManeuverLeftOut (
  need (negb (slides_at s (horizon P))) Slides (finish s (PositiveMap.elements (slots s)))).
End Replay.
