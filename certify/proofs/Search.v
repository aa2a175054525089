(* Finds the hints of the claims, from which flips have brackets and edges numbers. What is found is checked afterwards. *)
From Coq Require Import ZArith List Bool FMapPositive.
From Voroproof Require Import History Replay Initial Files.
Import ListNotations.
Open Scope Z_scope.

Definition remove_or_leave {A} (k : positive) (m : PositiveMap.t A) (inner : PositiveMap.t (PositiveMap.t A)) : PositiveMap.t (PositiveMap.t A) :=
  if PositiveMap.is_empty m then PositiveMap.remove k inner else PositiveMap.add k m inner.
Definition remove3 {A} (t : triple) (m : triples A) : triples A :=
  let '(a, b, c) := t in
  let ma := or_empty (PositiveMap.find a m) in
  remove_or_leave a (remove_or_leave b (PositiveMap.remove c (or_empty (PositiveMap.find b ma))) ma) m.

(* The diagram: edges by number, the last bracket of each, by their sides, and by the generators that they depend on; and
   where the generators are ([moved]). *)
Record finder := Finder {
  moved : state;
  names : PositiveMap.t edge;
  brackets : PositiveMap.t (Z * Z);
  owners : triples positive;
  nearby : PositiveMap.t (PositiveMap.t unit)
}.

Definition nearby_of (d : finder) (g : gen) : PositiveMap.t unit := or_empty (PositiveMap.find g (nearby d)).
Definition four_of (q : edge) : list gen := [el q; er q; es q; ee q].
Definition last_bracket (d : finder) (k : positive) : Z * Z := match PositiveMap.find k (brackets d) with Some b => b | None => (0, 0) end.

(* The edge k has these sides from now on, and depends on these generators; or no longer. *)
Definition enter (d : finder) (k : positive) (ss : list triple) (gs : list gen) : finder :=
  Finder (moved d) (names d) (brackets d) (fold_left (fun m s => add3 s k m) ss (owners d))
    (fold_left (fun m g => PositiveMap.add g (PositiveMap.add k tt (or_empty (PositiveMap.find g m))) m) gs (nearby d)).
Definition leave (d : finder) (k : positive) (ss : list triple) (gs : list gen) : finder :=
  Finder (moved d) (names d) (brackets d)
    (fold_left (fun m s => match find3 m s with Some k' => if Pos.eqb k k' then remove3 s m else m | None => m end) ss (owners d))
    (fold_left (fun m g => PositiveMap.add g (PositiveMap.remove k (or_empty (PositiveMap.find g m))) m) gs (nearby d)).
Definition rename (d : finder) (k : positive) (q : edge) (since : Z * Z) : finder :=
  Finder (moved d) (PositiveMap.add k q (names d)) (PositiveMap.add k since (brackets d)) (owners d) (nearby d).

(* What the first list has and the second has not. *)
Definition without {A} (eqb : A -> A -> bool) (l m : list A) : list A := filter (fun a => negb (existsb (eqb a) m)) l.

(* The edges that depend on one of these generators. *)
Definition around (d : finder) (gs : list gen) : list (positive * edge) :=
  let ks := fold_left (fun m g => PositiveMap.fold (fun k _ m => PositiveMap.add k tt m) (nearby_of d g) m) gs (PositiveMap.empty unit) in
  fold_left (fun l kt => match PositiveMap.find (fst kt) (names d) with Some q => (fst kt, q) :: l | None => l end)
    (PositiveMap.elements ks) [].

Section Search.
Variable P : problem.

Definition first_finder : finder :=
  fold_left (fun d kq => enter (rename d (fst kq) (snd kq) (0, 0)) (fst kq) (sides (snd kq)) (four_of (snd kq))) (PositiveMap.elements (edges P))
    (Finder (first_state P) (PositiveMap.empty _) (PositiveMap.empty _) (PositiveMap.empty _) (PositiveMap.empty _)).

Definition gone (s : state) (f : edge) (b : Z * Z) : bool :=
  match collapses s f (fst b) (snd b) with Good gone => gone | Bad _ => false end.

(* A bracket around t within [least, most], a few widths tried. *)
Fixpoint widen (fuel : nat) (s : state) (f : edge) (t least most w : Z) : outcome (Z * Z) :=
  let lo := Z.max least (t - w) in
  let hi := Z.min (t + w) most in
  if (lo <? hi) && gone s f (lo, hi) then Good (lo, hi)
  else match fuel with
  | S fuel => if w =? tolerance P then Bad NoBracket else widen fuel s f t least most (Z.min (tolerance P) (8 * w))
  | O => Bad NoBracket
  end.

(* A part of the bracket that is narrow enough. There is none where the circles at both ends of the edge do not change together. *)
Fixpoint narrow (fuel : nat) (s : state) (f : edge) (t : Z) (b : Z * Z) : outcome (Z * Z) :=
  let (lo, hi) := b in
  if hi - lo <=? widest t then Good b
  else
    let mid := (lo + hi) / 2 in
    match fuel with
    | S fuel => if gone s f (lo, mid) then narrow fuel s f t (lo, mid) else if gone s f (mid, hi) then narrow fuel s f t (mid, hi) else Bad NoBracket
    | O => Bad NoBracket
    end.

(* The bracket of a flip of f: one instant, or from the last bracket of the five edges on, or that bracket itself. *)
Definition bracket (s : state) (f : edge) (t : Z) (last : Z * Z) (limit : Z) : outcome (Z * Z) :=
  let fuel := Pos.size_nat (Z.to_pos (2 * tolerance P)) in
  if (snd last <=? t) && gone s f (t, t) then Good (t, t)
  else if snd last <=? t then
    do b <- widen fuel s f t (Z.max (snd last) 1) (Z.max limit (t + 1)) (Z.min (tolerance P) (Z.max 4 (t / 2 ^ 51)));
    narrow fuel s f t b
  else if gone s f last then Good last else Bad NoBracket.

Definition after_flips (c : claim) (ks : list positive) (d : finder) (since : Z * Z) : outcome finder :=
  do qs <- fold_left (fun qs k =>
      do qs <- qs;
      do old <- known (PositiveMap.find k (names d)) UnknownEdge;
      do new <- known (after_flip k c old) NotBeside;
      Good ((k, (old, new)) :: qs)) ks (Good []);
  let lost p q := (without triple_eqb (sides p) (sides q), without Pos.eqb (four_of p) (four_of q)) in
  let d := fold_left (fun d x => let '(k, (old, new)) := x in let (ss, gs) := lost old new in leave d k ss gs) qs d in
  Good (fold_left (fun d x => let '(k, (old, new)) := x in let (ss, gs) := lost new old in rename (enter d k ss gs) k new since) qs d).

Definition find_flip (d : finder) (t : Z) (f : edge) (limit : Z) : outcome (claim * finder) :=
  let side a b c := known (find3 (owners d) (a, b, c)) WrongName in
  do k <- side (el f) (er f) (ee f);
  do k1 <- side (el f) (es f) (er f);
  do k2 <- side (es f) (er f) (el f);
  do k3 <- side (er f) (ee f) (el f);
  do k4 <- side (ee f) (el f) (er f);
  let ks := [k; k1; k2; k3; k4] in
  let last := fold_left (fun b k => let b' := last_bracket d k in if snd b <? snd b' then b' else b) ks (0, 0) in
  do b <- bracket (moved d) f t last limit;
  let (lo, hi) := b : Z * Z in
  let c := Flip t f lo hi k k1 k2 k3 k4 in
  do d <- after_flips c ks d b;
  Good (c, d).

(* After the turn of some generators, around which these edges are. *)
Definition after_turn (c : claim) (gs : list gen) (near : list (positive * edge)) (t : Z) (d : finder) : outcome finder :=
  do s <- fold_left (fun s g => do s <- s; turn c g s) gs (Good (moved d));
  Good (Finder s (names d) (fold_left (fun m kq => PositiveMap.add (fst kq) (t, t) m) near (brackets d)) (owners d) (nearby d)).

Definition find_collision (d : finder) (t : Z) (i j : gen) (vi vj : Z * Z) (ps : list (gen * (Z * Z))) : outcome (claim * finder) :=
  do a <- mover_of (moved d) i;
  do b <- mover_of (moved d) j;
  let gs := if Pos.eqb i container then [j] else [i; j] in
  let near := around d gs in
  match filter (fun kq => is_pair i j (snd kq)) near with
  | [] => Bad NotNeighbours
  | (k, _) :: _ =>
      let before := Z.max (t - tolerance P) (Z.max (since (path a)) (since (path b))) in
      let last := t + tolerance P in
      (* They overlap most where they are nearest. *)
      let off := minus (x_at (path b) t, y_at (path b) t) (x_at (path a) t, y_at (path a) t) in
      let speed := minus (velocity (path b)) (velocity (path a)) in
      let nearest := t - dot off speed / Z.max 1 (dot speed speed) in
      let overlap h := (before <=? h) && (h <=? last) && (gap_at i j a b h <? 0) in
      let after := if overlap last then last else if overlap nearest then nearest else last in
      let c := Collision t i j vi vj ps before after k (map fst near) in
      do d <- after_turn c gs near t d;
      Good (c, d)
  end.

Definition find_claim (d : finder) (e : event Z) (limit : Z) : outcome (claim * finder) :=
  match e with
  | Flipped t f => find_flip d t f limit
  | Collided t i j (Some (vi, vj)) ps => find_collision d t i j vi vj ps
  | Maneuvered t g (Some v) ps =>
      let near := around d [g] in
      let c := Maneuver t g v ps (map fst near) in
      do d <- after_turn c [g] near t d;
      Good (c, d)
  | Collided _ _ _ None _ | Maneuvered _ _ None _ => Bad NoVelocity
  end.

(* For each event the time of the first turn from it on, where a bracket has to end. *)
Definition limits (es : list (event Z)) : list Z :=
  fold_left (fun rest e =>
      let later := match rest with [] => 4 * horizon P | l :: _ => l end in
      match e with Flipped _ _ => later | Collided t _ _ _ _ => t | Maneuvered t _ _ _ => t end :: rest) (rev' es) [].

(* The claims, or why one of them has no hints, and the number of those before it. *)
Fixpoint search (d : finder) (es : list (event Z)) (ls : list Z) (found : list claim) (done : Z) : outcome (list claim) * Z :=
  match es with
  | [] => (Good (rev' found), done)
  | e :: es =>
      match find_claim d e (hd 0 ls) with
      | Good (c, d) => search d es (tl ls) (c :: found) (done + 1)
      | Bad why => (Bad why, done)
      end
  end.
End Search.
