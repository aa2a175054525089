(* The diagram at one instant, seen from a disk l: of each other generator g an affine function K_g on the unit circle. A circle that
   touches l in the direction u, of curvature kappa in its form about l, touches g where kappa = K_g(u), and is empty of g where
   kappa >= K_g(u). So the cell of l is the upper envelope of the K_g. *)
From Coq Require Import Reals Lra List Bool PArith.
From Voroproof Require Import Geometry History Arc Spread.
Import ListNotations.
Open Scope R_scope.

(* The zero of an affine function at which it rises, where its direction is longer than its constant. *)
Definition up (f : affine) : vec :=
  let x := vx (fa f) in let y := vy (fa f) in let n := x * x + y * y in let w := sqrt (n - fb f * fb f) in
  Vec ((- fb f * x + w * y) / n) ((- fb f * y - w * x) / n).

Definition crosses (f : affine) : Prop := fb f * fb f < vx (fa f) * vx (fa f) + vy (fa f) * vy (fa f).

Lemma up_unit f : crosses f -> unit (up f).
Proof.
  unfold crosses, up, unit; simpl. set (x := vx (fa f)). set (y := vy (fa f)). set (b := fb f). intros H.
  set (w := sqrt (x * x + y * y - b * b)). assert (W : w * w = x * x + y * y - b * b) by (apply sqrt_sqrt; lra).
  assert (N : 0 < x * x + y * y) by (pose proof (sq b); lra).
  replace ((- b * x + w * y) / (x * x + y * y) * ((- b * x + w * y) / (x * x + y * y)) + (- b * y - w * x) / (x * x + y * y) * ((- b * y - w * x) / (x * x + y * y)))
    with ((b * b + w * w) * (x * x + y * y) / ((x * x + y * y) * (x * x + y * y))) by (field; lra).
  rewrite W. field. lra.
Qed.

Lemma up_zero f : crosses f -> at_ f (up f) = 0.
Proof.
  unfold crosses, up, at_, dot; simpl. set (x := vx (fa f)). set (y := vy (fa f)). set (b := fb f). intros H.
  assert (N : 0 < x * x + y * y) by (pose proof (sq b); lra). field. lra.
Qed.

Lemma up_slope f : crosses f -> slope f (up f) = sqrt (vx (fa f) * vx (fa f) + vy (fa f) * vy (fa f) - fb f * fb f) /\ 0 < slope f (up f).
Proof.
  intros H. assert (E : slope f (up f) = sqrt (vx (fa f) * vx (fa f) + vy (fa f) * vy (fa f) - fb f * fb f)).
  { unfold crosses, up, slope, dot, turn in *; simpl. set (x := vx (fa f)) in *. set (y := vy (fa f)) in *. set (b := fb f) in *.
    assert (N : 0 < x * x + y * y) by (pose proof (sq b); lra). field. lra. }
  split; [exact E|]. rewrite E. apply sqrt_lt_R0. unfold crosses in H. lra.
Qed.

(* It is the only such zero. *)
Lemma up_only f u : unit u -> at_ f u = 0 -> 0 < slope f u -> u = up f.
Proof.
  destruct u as [c d]. unfold unit, at_, slope, up, dot, turn; simpl. set (x := vx (fa f)). set (y := vy (fa f)). set (b := fb f).
  intros U Z S. assert (B : b = - (x * c + y * d)) by lra.
  assert (N : x * x + y * y = b * b + (x * - d + y * c) * (x * - d + y * c)).
  { rewrite B. replace (x * x + y * y) with ((x * x + y * y) * (c * c + d * d)) by (rewrite U; ring). ring. }
  assert (W : sqrt (x * x + y * y - b * b) = x * - d + y * c).
  { rewrite N. replace (b * b + (x * - d + y * c) * (x * - d + y * c) - b * b) with ((x * - d + y * c) * (x * - d + y * c)) by ring. apply sqrt_square. lra. }
  assert (P : 0 < x * x + y * y). { rewrite N. pose proof (sq b). pose proof (Rmult_lt_0_compat _ _ S S). lra. }
  rewrite W. f_equal; apply (Rmult_eq_reg_r (x * x + y * y)); try lra; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; rewrite B; ring_simplify.
  - replace (c * x ^ 2 + c * y ^ 2) with (x ^ 2 * c + y ^ 2 * c) by ring. ring.
  - ring.
Qed.

(* A generator seen from the base l, and its function. *)
Definition seen_at (l g : generator) : seen := Seen (cx g - cx l) (cy g - cy l) (radius g - radius l).
Definition Kg (l g : generator) : affine := K (seen_at l g).

(* The direction, seen from l, of the vertex [l,j,k], and the curvature of its circle there. *)
Definition dir (l j k : generator) : vec := up (diff (Kg l k) (Kg l j)).
Definition level (l j k : generator) : R := at_ (Kg l j) (dir l j k).

(* The vertex [l,j,k] is there; l is a disk. *)
Definition vertex (l j k : generator) : Prop :=
  wall l = false /\ right_pair l j /\ right_pair l k /\ right_pair j k /\ wall j && wall k = false /\ 0 < level l j k.

Lemma right_tang l g : right_pair l g <-> if wall l || wall g then tang (seen_at l g) < 0 else 0 < tang (seen_at l g).
Proof.
  unfold right_pair, tang, seen_at; simpl. replace ((cx l - cx g) * (cx l - cx g) + (cy l - cy g) * (cy l - cy g) - (radius l - radius g) * (radius l - radius g)) with
    ((cx g - cx l) * (cx g - cx l) + (cy g - cy l) * (cy g - cy l) - (radius g - radius l) * (radius g - radius l)) by ring. reflexivity.
Qed.

Lemma right_tang2 l j k : right_pair j k <-> if wall j || wall k then tang2 (seen_at l j) (seen_at l k) < 0 else 0 < tang2 (seen_at l j) (seen_at l k).
Proof.
  unfold right_pair, tang2, seen_at; simpl.
  replace ((cx j - cx l - (cx k - cx l)) * (cx j - cx l - (cx k - cx l)) + (cy j - cy l - (cy k - cy l)) * (cy j - cy l - (cy k - cy l)) -
    (radius j - radius l - (radius k - radius l)) * (radius j - radius l - (radius k - radius l))) with
    ((cx j - cx k) * (cx j - cx k) + (cy j - cy k) * (cy j - cy k) - (radius j - radius k) * (radius j - radius k)) by ring. reflexivity.
Qed.

(* With right tangencies the difference of two functions takes both signs. *)
Lemma difference_crosses l j k : wall l = false -> wall j && wall k = false -> right_pair l j -> right_pair l k -> right_pair j k ->
  crosses (diff (Kg l k) (Kg l j)).
Proof.
  intros Hl Hw Rj Rk Rjk. apply right_tang in Rj, Rk. apply (right_tang2 l) in Rjk. rewrite Hl in *. simpl in Rj, Rk.
  assert (Nj : tang (seen_at l j) <> 0) by (destruct (wall j); lra). assert (Nk : tang (seen_at l k) <> 0) by (destruct (wall k); lra).
  pose proof (spread (seen_at l k) (seen_at l j) Nk Nj) as S. rewrite norm_square in S. unfold crosses, Kg.
  assert (0 < tang2 (seen_at l k) (seen_at l j) / (tang (seen_at l k) * tang (seen_at l j))); [|lra].
  assert (E : tang2 (seen_at l k) (seen_at l j) = tang2 (seen_at l j) (seen_at l k)) by (unfold tang2; ring). rewrite E.
  destruct (wall j), (wall k); simpl in *; try discriminate.
  - replace (tang2 (seen_at l j) (seen_at l k) / (tang (seen_at l k) * tang (seen_at l j))) with
      (- tang2 (seen_at l j) (seen_at l k) / (tang (seen_at l k) * - tang (seen_at l j))) by (field; lra).
    apply Rdiv_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; lra.
  - replace (tang2 (seen_at l j) (seen_at l k) / (tang (seen_at l k) * tang (seen_at l j))) with
      (- tang2 (seen_at l j) (seen_at l k) / (- tang (seen_at l k) * tang (seen_at l j))) by (field; lra).
    apply Rdiv_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; lra.
  - apply Rdiv_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; lra.
Qed.

(* What a vertex that is there says of its direction. *)
Lemma vertex_dir l j k : vertex l j k ->
  unit (dir l j k) /\ at_ (Kg l k) (dir l j k) = at_ (Kg l j) (dir l j k) /\ slope (Kg l j) (dir l j k) < slope (Kg l k) (dir l j k).
Proof.
  intros (Hl & Rj & Rk & Rjk & Hw & _). pose proof (difference_crosses l j k Hl Hw Rj Rk Rjk) as C.
  split; [apply up_unit, C|]. pose proof (up_zero _ C) as Z. destruct (up_slope _ C) as [_ S].
  unfold at_, slope, diff, dot, minus, turn in Z, S; simpl in Z, S. fold (dir l j k) in Z, S. unfold at_, slope, dot, turn; simpl. split; lra.
Qed.

Definition on_arc (p q u : vec) : Prop := (p = q /\ u = p) \/ (p <> q /\ 0 <= chord p q u).

(* The diagram D of the generators of a list, which are where [cfg] says. *)
Section Instant.
  Variable gens : list gen.
  Variable cfg : gen -> generator.
  Variable D : list edge.

  (* An edge of D seen from a disk. *)
  Definition oriented (q : edge) : Prop := (In q D \/ In (reversed q) D) /\ wall (cfg (el q)) = false.
  Definition K_at (l g : gen) (u : vec) : R := at_ (Kg (cfg l) (cfg g)) u.
  (* Its first circle and its last. *)
  Definition start_of (q : edge) : vec := dir (cfg (el q)) (cfg (es q)) (cfg (er q)).
  Definition end_of (q : edge) : vec := dir (cfg (el q)) (cfg (er q)) (cfg (ee q)).
  Definition both_there (q : edge) : Prop :=
    vertex (cfg (el q)) (cfg (es q)) (cfg (er q)) /\ vertex (cfg (el q)) (cfg (er q)) (cfg (ee q)).

  (* D is the Voronoi diagram: every circle along every edge, not only those at vertices, is empty of all generators. *)
  Record voronoi : Prop := {
    all_right : forall g h, In g gens -> In h gens -> g <> h -> right_pair (cfg g) (cfg h);
    all_there : forall q, oriented q -> both_there q;
    envelope : forall q u g, oriented q -> unit u -> on_arc (start_of q) (end_of q) u -> In g gens -> g <> el q -> g <> er q ->
      K_at (el q) g u <= K_at (el q) (er q) u
  }.

End Instant.

(* The edges of D fit together: the three sides of each vertex are there, and each generator has an edge. *)
Definition side (D : list edge) (a b c : gen) : Prop := exists q, In q D /\ side_of q a b c.
Record fits (gens : list gen) (D : list edge) : Prop := {
  sides_turn : forall a b c, side D a b c -> side D b c a;
  each_has_one : forall g, In g gens -> exists q, In q D /\ (el q = g \/ er q = g);
  names_in : forall q g, In q D -> In g [el q; er q; es q; ee q] -> In g gens
}.

(* A time from t on, before some later one. *)
Definition after (t : R) (says : R -> Prop) : Prop := exists d, 0 < d /\ forall u, t <= u < t + d -> says u.
Definition before (t : R) (says : R -> Prop) : Prop := exists d, 0 < d /\ forall u, t - d < u < t -> says u.

(* Generators that move continuously, with fixed radii; generator 1 is the container. *)
Record moves (cfg : R -> gen -> generator) : Prop := {
  walls : forall t g, wall (cfg t g) = Pos.eqb g container;
  radii : forall t u g, radius (cfg t g) = radius (cfg u g);
  proper_disk : forall t g, g <> container -> 0 <= radius (cfg t g);
  proper_wall : forall t, radius (cfg t container) < 0;
  cx_continuous : forall g, continuity (fun t => cx (cfg t g));
  cy_continuous : forall g, continuity (fun t => cy (cfg t g))
}.
