(* Halving, and what the checks say of an edge and of a pair over the whole interval. *)
From Coq Require Import ZArith List Bool Reals Lra.
From Voroproof Require Import Forms Polynomial Geometry Circle Vertex Scale Piece PieceSound.
Import ListNotations.
Open Scope R_scope.

Lemma left_at g z : 0 <= z -> z < 1 -> at_z (left g) (2 * z / (1 - z)) = scale (2 / (1 - z)) (at_z g z).
Proof.
  intros H0 H1. unfold at_z, left, scale; cbn [ax ay bx by_ mr mwall cx cy radius wall]. rewrite !plus_IZR, !mult_IZR. f_equal; field; lra.
Qed.

Lemma right_at g z : at_z (right_ g) ((z - 1) / 2) = at_z g z.
Proof. unfold at_z, right_; cbn [ax ay bx by_ mr mwall]. rewrite !plus_IZR, !mult_IZR. f_equal; field. Qed.

Section Halving.
  Variable test : moving -> moving -> moving -> moving -> bool.
  Variable says : generator -> generator -> generator -> generator -> Prop.
  Hypothesis unscale : forall m, 0 < m -> forall i a b c, says (scale m i) (scale m a) (scale m b) (scale m c) -> says i a b c.
  Hypothesis sound : forall i a b c, test i a b c = true ->
    forall z, 0 <= z -> says (at_z i z) (at_z a z) (at_z b z) (at_z c z).

  Lemma halving_sound d : forall i a b c, halving test d i a b c = true ->
    forall z, 0 <= z -> says (at_z i z) (at_z a z) (at_z b z) (at_z c z).
  Proof.
    induction d as [|d IH]; intros i a b c; simpl; destruct (test i a b c) eqn:T; intros H z Hz; try discriminate;
      try (apply sound; assumption).
    apply andb_prop in H as [HL HR]. destruct (Rlt_or_le z 1) as [H1|H1].
    - apply (unscale (2 / (1 - z))); [apply Rdiv_lt_0_compat; lra|].
      rewrite <- !left_at by assumption. apply IH; [exact HL|].
      apply Rmult_le_pos; [lra|]. apply Rlt_le, Rinv_0_lt_compat. lra.
    - rewrite <- (right_at i), <- (right_at a), <- (right_at b), <- (right_at c). apply IH; [exact HR|lra].
  Qed.
End Halving.

Definition fan_legal (i a b c : generator) : Prop :=
  (exists k, vertex_circle k i a b /\ empty_of k c) /\ (exists k, vertex_circle k i b c /\ empty_of k a).

Lemma fan_legal_unscale m : 0 < m -> forall i a b c,
  fan_legal (scale m i) (scale m a) (scale m b) (scale m c) -> fan_legal i a b c.
Proof.
  intros Hm i a b c [(k & V & E) (k' & V' & E')]. split.
  - exists (scale_circle (/ m) k). split; [apply vertex_unscale | apply empty_unscale]; assumption.
  - exists (scale_circle (/ m) k'). split; [apply vertex_unscale | apply empty_unscale]; assumption.
Qed.

Lemma fan_legal_true i a b c : fan_there i a b c && fan_empty i a b c = true ->
  forall z, 0 <= z -> fan_legal (at_z i z) (at_z a z) (at_z b z) (at_z c z).
Proof.
  intros H z Hz. apply andb_prop in H as [H1 H2].
  destruct (fan_empty_true _ _ _ _ H1 z Hz H2) as [Q1 Q2].
  destruct (fan_circles _ _ _ _ H1 z Hz) as [(k & V & E & _) (k' & V' & E' & _)]. split; eauto.
Qed.

(* The fan about r, where l is the container, is the edge seen from its other side. *)
Lemma fan_of_edge_l l r s e : fan_legal l s r e -> legal l r s e.
Proof. intros [H1 H2]. split; assumption. Qed.

Lemma fan_of_edge_r l r s e : fan_legal r e l s -> legal l r s e.
Proof.
  intros [(k & V & E) (k' & V' & E')]. split.
  - exists k'. split; [|exact E']. apply vertex_turn, V'.
  - exists k. split; [|exact E]. apply vertex_turn, vertex_turn, V.
Qed.

Theorem edge_legal_sound l r s e : edge_legal l r s e = true ->
  forall z, 0 <= z -> legal (at_z l z) (at_z r z) (at_z s z) (at_z e z).
Proof.
  unfold edge_legal, by_fan. destruct (mwall l); intros H z Hz.
  - apply fan_of_edge_r. revert z Hz. revert H. apply halving_sound; [exact fan_legal_unscale | exact fan_legal_true].
  - apply fan_of_edge_l. revert z Hz. revert H. apply halving_sound; [exact fan_legal_unscale | exact fan_legal_true].
Qed.

(* Pairs. *)
Lemma pair_gap_at i j z : eval (pair_gap i j) z =
  (cx (at_z i z) - cx (at_z j z)) * (cx (at_z i z) - cx (at_z j z)) + (cy (at_z i z) - cy (at_z j z)) * (cy (at_z i z) - cy (at_z j z)) -
  (radius (at_z i z) + radius (at_z j z)) * (radius (at_z i z) + radius (at_z j z)).
Proof.
  unfold pair_gap. rewrite eval_sub, eval_add, !eval_mul. simpl. rewrite !minus_IZR, !plus_IZR. ring.
Qed.

Lemma length_at_least x y a : 0 <= a -> a * a <= x * x + y * y -> a <= length x y.
Proof. intros Ha H. pose proof (length_square x y). pose proof (length_nonneg x y). nra. Qed.

Lemma length_at_most x y a : 0 <= a -> x * x + y * y <= a * a -> length x y <= a.
Proof. intros Ha H. pose proof (length_square x y). pose proof (length_nonneg x y). nra. Qed.

Lemma quadratic_not_negative_true p z : 0 <= z -> quadratic_not_negative p = true -> 0 <= eval p z.
Proof.
  intros Hz H. unfold quadratic_not_negative in H. apply orb_prop in H as [H|H]; [apply never_negative_true; assumption|].
  destruct p as [|c [|b [|a [|? ?]]]]; try discriminate. apply andb_prop in H as [H D]. apply andb_prop in H as [Hc Ha].
  apply Z.leb_le, IZR_le in Hc, Ha, D. rewrite !mult_IZR in D. cbn [eval]. revert Hc Ha D.
  generalize (IZR a) (IZR b) (IZR c). intros u v w Hw Hu D.
  destruct (Rle_lt_or_eq_dec _ _ Hu) as [P|E].
  - apply (Rmult_le_reg_l (4 * u)); [lra|]. rewrite Rmult_0_r.
    replace (4 * u * (w + z * (v + z * (u + z * 0)))) with ((2 * u * z + v) * (2 * u * z + v) + (4 * u * w - v * v)) by ring.
    pose proof (Rle_0_sqr (2 * u * z + v)) as Q. unfold Rsqr in Q. lra.
  - subst u. assert (v = 0) as -> by nra. lra.
Qed.

Theorem pair_apart_sound d : forall i j, pair_apart d i j = true -> forall z, 0 <= z -> apart (at_z i z) (at_z j z).
Proof.
  induction d as [|d IH]; intros i j; simpl; destruct (quadratic_not_negative (poly_sign (mwall i || mwall j) (pair_gap i j))) eqn:T;
    intros H z Hz; try discriminate.
  3: { apply andb_prop in H as [HL HR]. destruct (Rlt_or_le z 1) as [H1|H1].
    - apply (apart_unscale (2 / (1 - z))); [apply Rdiv_lt_0_compat; lra|].
      rewrite <- !left_at by assumption. apply IH; [exact HL|].
      apply Rmult_le_pos; [lra|]. apply Rlt_le, Rinv_0_lt_compat. lra.
    - rewrite <- (right_at i), <- (right_at j). apply IH; [exact HR|lra]. }
  all: apply (quadratic_not_negative_true _ z Hz) in T; rewrite eval_poly_sign, pair_gap_at in T; unfold apart;
    change (wall (at_z i z)) with (mwall i); change (wall (at_z j z)) with (mwall j);
    destruct (mwall i || mwall j); simpl in T; apply Z.leb_le, IZR_le in H; rewrite plus_IZR in H; simpl;
    [apply length_at_most | apply length_at_least]; try lra;
    rewrite <- Rmult_plus_distr_l; try (rewrite Ropp_mult_distr_r); apply Rmult_le_pos; lra.
Qed.

(* Signs at the interval's beginning. *)
Lemma sum_negative_true f x y n root : 0 < root -> 0 < n ->
  IZR x * IZR x - root * root * (IZR y * IZR y) = n * IZR f -> sum_negative_at f x y = true -> IZR x + root * IZR y < 0.
Proof.
  intros Hr Hn P H. assert (0 < - IZR x + root * - IZR y); [|lra].
  apply (positive_by_f _ _ (IZR f) n _ Hr Hn); [lra|].
  unfold sum_negative_at in H.
  apply orb_prop in H as [H|H]; [apply orb_prop in H as [H|H]; [apply orb_prop in H as [H|H]|]|]; apply andb_prop in H as [H1 H2];
    first [apply Z.ltb_lt, IZR_lt in H1 | apply Z.leb_le, IZR_le in H1]; first [apply Z.ltb_lt, IZR_lt in H2 | apply Z.leb_le, IZR_le in H2].
  - left; lra.
  - right; left; lra.
  - right; right; left; lra.
  - right; right; right; lra.
Qed.

Lemma start_incircle i j k e (p := incircle (at_z i 0) (at_z j 0) (at_z k 0) (at_z e 0)) :
  p = IZR (with_sign (mwall e) (z_g (zrow i j) (zrow i k) (z_a (zrow i j) (zrow i k) (zrow i e)) (z_b (zrow i j) (zrow i k) (zrow i e)))) +
  sqrt (gamma (seen_from (at_z i 0) (at_z j 0)) (seen_from (at_z i 0) (at_z k 0))) *
  IZR (with_sign (xorb (mwall e) (mwall j || mwall k)) (z_c (zrow i j) (zrow i k) (zrow i e))).
Proof.
  unfold p, incircle. rewrite !with_sign_is, sign_xor, int_g, int_a, int_b, int_c, !zrow_at. simpl. ring.
Qed.

Lemma start_product i j k e s t :
  0 < gamma (seen_from (at_z i 0) (at_z j 0)) (seen_from (at_z i 0) (at_z k 0)) ->
  let root := sqrt (gamma (seen_from (at_z i 0) (at_z j 0)) (seen_from (at_z i 0) (at_z k 0))) in
  let x := with_sign s (z_g (zrow i j) (zrow i k) (z_a (zrow i j) (zrow i k) (zrow i e)) (z_b (zrow i j) (zrow i k) (zrow i e))) in
  let y := with_sign t (z_c (zrow i j) (zrow i k) (zrow i e)) in
  IZR x * IZR x - root * root * (IZR y * IZR y) = norm (seen_from (at_z i 0) (at_z j 0)) (seen_from (at_z i 0) (at_z k 0)) *
    IZR (z_f (z_a (zrow i j) (zrow i k) (zrow i e)) (z_b (zrow i j) (zrow i k) (zrow i e)) (z_c (zrow i j) (zrow i k) (zrow i e))).
Proof.
  intros Hg root x y. unfold root. rewrite sqrt_sqrt by lra. unfold x, y.
  rewrite !with_sign_is, int_f, int_g, int_a, int_b, int_c, !zrow_at.
  rewrite <- incircle_product by (apply gamma_is).
  match goal with |- ?s * ?g * (?s * ?g) - ?m * (?t * ?c * (?t * ?c)) = _ =>
    replace (s * g * (s * g) - m * (t * c * (t * c))) with (s * s * (g * g) - t * t * (m * (c * c))) by ring end.
  rewrite !sign_square. ring.
Qed.

Lemma turned_ints (a b c : row Z) : z_a b c a = z_a a b c /\ z_b b c a = z_b a b c /\ z_c b c a = z_c a b c.
Proof. unfold form_a, form_b, form_c, dsp, dxp, dyp, dxs, dys, dxy. repeat split; ring. Qed.

Lemma fan_entered_true i a b c : fan_there i a b c = true -> fan_entered i a b c = true ->
  incircle (at_z i 0) (at_z a 0) (at_z b 0) (at_z c 0) < 0 /\ incircle (at_z i 0) (at_z b 0) (at_z c 0) (at_z a 0) < 0.
Proof.
  intros There H. destruct (fan_parts _ _ _ _ There) as (_ & _ & _ & _ & _ & C1 & C2).
  pose proof (there_gamma _ _ _ C1 0 (Rle_refl 0)) as G1. pose proof (there_gamma _ _ _ C2 0 (Rle_refl 0)) as G2.
  pose proof (there_norm _ _ _ C1 0 (Rle_refl 0)) as N1. pose proof (there_norm _ _ _ C2 0 (Rle_refl 0)) as N2.
  unfold fan_entered in H. apply andb_prop in H as [H1 H2]. split.
  - rewrite start_incircle. apply (sum_negative_true _ _ _ _ _ (sqrt_lt_R0 _ G1) N1 (start_product i a b c _ _ G1) H1).
  - destruct (turned_ints (zrow i a) (zrow i b) (zrow i c)) as (Ea & Eb & Ec). rewrite <- Ea, <- Eb, <- Ec in H2.
    rewrite start_incircle. apply (sum_negative_true _ _ _ _ _ (sqrt_lt_R0 _ G2) N2 (start_product i b c a _ _ G2) H2).
Qed.

Lemma sum_positive_at_true f x y n root : 0 < root -> 0 < n ->
  IZR x * IZR x - root * root * (IZR y * IZR y) = n * IZR f -> sum_positive_at f x y = true -> 0 < IZR x + root * IZR y.
Proof.
  intros Hr Hn P H. apply (positive_by_f _ _ (IZR f) n _ Hr Hn); [exact P|].
  unfold sum_positive_at in H.
  apply orb_prop in H as [H|H]; [apply orb_prop in H as [H|H]; [apply orb_prop in H as [H|H]|]|]; apply andb_prop in H as [H1 H2];
    first [apply Z.ltb_lt, IZR_lt in H1 | apply Z.leb_le, IZR_le in H1]; first [apply Z.ltb_lt, IZR_lt in H2 | apply Z.leb_le, IZR_le in H2]; tauto.
Qed.

Lemma fan_strict_true i a b c : fan_there i a b c = true -> fan_strict i a b c = true ->
  (exists o, vertex_circle o (at_z i 0) (at_z a 0) (at_z b 0) /\ ~ touches o (at_z c 0)) \/
  (exists o, vertex_circle o (at_z i 0) (at_z b 0) (at_z c 0) /\ ~ touches o (at_z a 0)).
Proof.
  intros There H. destruct (fan_parts _ _ _ _ There) as (_ & _ & _ & _ & _ & C1 & C2).
  pose proof (there_gamma _ _ _ C1 0 (Rle_refl 0)) as G1. pose proof (there_norm _ _ _ C1 0 (Rle_refl 0)) as N1.
  pose proof (there_gamma _ _ _ C2 0 (Rle_refl 0)) as G2. pose proof (there_norm _ _ _ C2 0 (Rle_refl 0)) as N2.
  destruct (fan_circles _ _ _ _ There 0 (Rle_refl 0)) as [(o & V & _ & _ & _ & X) (o' & V' & _ & _ & _ & X')].
  unfold fan_strict in H. cbv zeta in H. apply orb_prop in H as [H|H].
  - left. exists o. split; [exact V|]. apply X. rewrite start_incircle.
    apply (sum_positive_at_true _ _ _ _ _ (sqrt_lt_R0 _ G1) N1 (start_product i a b c _ _ G1) H).
  - right. exists o'. split; [exact V'|]. apply X'. rewrite start_incircle.
    destruct (turned_ints (zrow i a) (zrow i b) (zrow i c)) as (Ea & Eb & Ec). rewrite <- Ea, <- Eb, <- Ec in H.
    apply (sum_positive_at_true _ _ _ _ _ (sqrt_lt_R0 _ G2) N2 (start_product i b c a _ _ G2) H).
Qed.
