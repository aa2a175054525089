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

(* A fan about i is the edge [i,b,a,c]: what a sign of both in-circle functions says of it. *)
Lemma fan_says (say : circle -> generator -> Prop) (sign : R -> Prop) i a b c z : fan_there i a b c = true -> 0 <= z ->
  (forall k x g, (0 <= x -> empty_of k g) -> (x = 0 -> touches k g) -> (x < 0 -> ~ empty_of k g) -> sign x -> say k g) ->
  sign (incircle (at_z i z) (at_z a z) (at_z b z) (at_z c z)) -> sign (incircle (at_z i z) (at_z b z) (at_z c z) (at_z a z)) ->
  circles say (at_z i z) (at_z b z) (at_z a z) (at_z c z).
Proof.
  intros T Hz H S1 S2. destruct (fan_circles _ _ _ _ T z Hz) as [(k & V & A & B & C & _) (k' & V' & A' & B' & C' & _)].
  split; [exists k|exists k']; (split; [assumption|eapply H; eassumption]).
Qed.

Lemma fan_legal_true i a b c : fan_there i a b c && fan_empty i a b c = true ->
  forall z, 0 <= z -> legal (at_z i z) (at_z b z) (at_z a z) (at_z c z).
Proof.
  intros H z Hz. apply andb_prop in H as [H1 H2]. destruct (fan_empty_true _ _ _ _ H1 z Hz H2) as [Q1 Q2].
  apply (fan_says _ (fun x => 0 <= x)); auto.
Qed.

(* A test of a fan, halved, says it of the edge at every instant. *)
Lemma edge_sound test (says : generator -> generator -> generator -> generator -> Prop) :
  (forall m, 0 < m -> forall l r s e, says (scale m l) (scale m r) (scale m s) (scale m e) -> says l r s e) ->
  (forall l r s e, says r l e s -> says l r s e) ->
  (forall i a b c, test i a b c = true -> forall z, 0 <= z -> says (at_z i z) (at_z b z) (at_z a z) (at_z c z)) ->
  forall l r s e, by_fan (halving test depth) l r s e = true -> forall z, 0 <= z -> says (at_z l z) (at_z r z) (at_z s z) (at_z e z).
Proof.
  intros Unscale Turn Sound l r s e H. unfold by_fan in H.
  assert (Fan : forall i a b c, halving test depth i a b c = true -> forall z, 0 <= z -> says (at_z i z) (at_z b z) (at_z a z) (at_z c z))
    by (apply (halving_sound test (fun i a b c => says i b a c)); [intros m Hm i a b c; apply Unscale, Hm|exact Sound]).
  destruct (mwall l); intros z Hz; [apply Turn|]; apply Fan; assumption.
Qed.

Theorem edge_legal_sound l r s e : edge_legal l r s e = true -> forall z, 0 <= z -> legal (at_z l z) (at_z r z) (at_z s z) (at_z e z).
Proof. apply edge_sound; [exact legal_unscale|intros; apply circles_turn; assumption|exact fan_legal_true]. Qed.

(* An edge that stands. *)
Theorem edge_there_sound l r s e : edge_there l r s e = true -> forall z, 0 <= z -> stands (at_z l z) (at_z r z) (at_z s z) (at_z e z).
Proof. apply edge_sound; [exact stands_unscale|exact stands_turn|exact fan_stands]. Qed.

Theorem edge_legal_stands l r s e : edge_legal l r s e = true -> forall z, 0 <= z -> stands (at_z l z) (at_z r z) (at_z s z) (at_z e z).
Proof. apply edge_sound; [exact stands_unscale|exact stands_turn|]. intros i a b c H. apply andb_prop in H as [H _]. exact (fan_stands _ _ _ _ H). Qed.

(* An edge that lasts. *)
Lemma fan_lasts_true i a b c : fan_there i a b c && (fan_empty i a b c || fan_long i a b c) = true ->
  forall z, 0 <= z -> lasts (at_z i) (at_z b) (at_z a) (at_z c) z.
Proof.
  intros H z Hz. apply andb_prop in H as [T H]. split.
  - apply fan_stands; assumption.
  - apply orb_prop in H as [H|H].
    + right. exists (z + 1). split; [lra|]. intros w Hw. apply fan_legal_true; [rewrite T, H; reflexivity|lra].
    + left. destruct (fan_circles _ _ _ _ T z Hz) as [(k & V & _ & _ & _ & X) (k' & V' & _ & _ & _ & X')].
      destruct (fan_long_true _ _ _ _ T z Hz H) as [Q|Q]; [left; exists k|right; exists k']; auto.
Qed.

Lemma fan_lasts_halving d : forall i a b c,
  halving (fun i a b c => fan_there i a b c && (fan_empty i a b c || fan_long i a b c)) d i a b c = true ->
  forall z, 0 <= z -> lasts (at_z i) (at_z b) (at_z a) (at_z c) z.
Proof.
  induction d as [|d IH]; intros i a b c; cbn [halving]; destruct (fan_there i a b c && _) eqn:T; intros H z Hz; try discriminate;
    try (apply fan_lasts_true; assumption).
  apply andb_prop in H as [HL HR]. destruct (Rlt_or_le z 1) as [H1|H1].
  - apply (lasts_along _ _ _ _ (at_z (left i)) (at_z (left b)) (at_z (left a)) (at_z (left c)) (fun z => 2 * z / (1 - z))).
    + intros y Hy. assert (Y : 0 <= 2 * z / (1 - z)) by (apply Rmult_le_pos; [lra|]; apply Rlt_le, Rinv_0_lt_compat; lra).
      assert (U : forall w, w < 1 -> 2 * w / (1 - w) < y <-> w < y / (2 + y)).
      { intros w Hw. split; intros Q.
        - apply (Rmult_lt_reg_r (2 + y)); [lra|]. replace (y / (2 + y) * (2 + y)) with y by (field; lra).
          apply (Rmult_lt_compat_r (1 - w)) in Q; [|lra]. replace (2 * w / (1 - w) * (1 - w)) with (2 * w) in Q by (field; lra). lra.
        - apply (Rmult_lt_reg_r (1 - w)); [lra|]. replace (2 * w / (1 - w) * (1 - w)) with (2 * w) by (field; lra).
          apply (Rmult_lt_compat_r (2 + y)) in Q; [|lra]. replace (y / (2 + y) * (2 + y)) with y in Q by (field; lra). lra. }
      assert (Y1 : y / (2 + y) < 1).
      { apply (Rmult_lt_reg_r (2 + y)); [lra|]. replace (y / (2 + y) * (2 + y)) with y by (field; lra). lra. }
      exists (y / (2 + y)). split; [apply U; assumption|]. intros w Hw. split; [split|].
      * apply (Rmult_le_reg_r ((1 - z) * (1 - w))); [apply Rmult_lt_0_compat; lra|].
        replace (2 * z / (1 - z) * ((1 - z) * (1 - w))) with (2 * z * (1 - w)) by (field; lra).
        replace (2 * w / (1 - w) * ((1 - z) * (1 - w))) with (2 * w * (1 - z)) by (field; lra). lra.
      * apply U; lra.
      * exists (2 / (1 - w)). split; [apply Rdiv_lt_0_compat; lra|]. rewrite !left_at by lra. auto.
    + apply IH; [exact HL|]. apply Rmult_le_pos; [lra|]. apply Rlt_le, Rinv_0_lt_compat. lra.
  - apply (lasts_along _ _ _ _ (at_z (right_ i)) (at_z (right_ b)) (at_z (right_ a)) (at_z (right_ c)) (fun z => (z - 1) / 2)).
    + intros y Hy. exists (2 * y + 1). split; [lra|]. intros w Hw. split; [lra|]. exists 1. split; [lra|].
      rewrite !right_at. unfold scale. rewrite !Rmult_1_l. repeat split; destruct (at_z _ w); reflexivity.
    + apply IH; [exact HR|lra].
Qed.

Theorem edge_lasts_sound l r s e : edge_lasts l r s e = true -> forall z, 0 <= z -> lasts (at_z l) (at_z r) (at_z s) (at_z e) z.
Proof.
  unfold edge_lasts, by_fan. destruct (mwall l); intros H z Hz.
  - apply lasts_turn. apply (fan_lasts_halving _ _ _ _ _ H z Hz).
  - apply (fan_lasts_halving _ _ _ _ _ H z Hz).
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

Lemma sum_zero_at_true f x y n root : 0 < root ->
  IZR x * IZR x - root * root * (IZR y * IZR y) = n * IZR f -> sum_zero_at f x y = true -> IZR x + root * IZR y = 0.
Proof.
  intros Hr P H. unfold sum_zero_at in H. apply andb_prop in H as [Hf H]. apply Z.eqb_eq in Hf. subst f. rewrite Rmult_0_r in P.
  assert (Q : (IZR x + root * IZR y) * (IZR x - root * IZR y) = 0) by lra.
  apply orb_prop in H as [H|H]; [apply orb_prop in H as [H|H]|]; apply andb_prop in H as [H1 H2].
  - apply Z.eqb_eq in H1, H2. subst. lra.
  - apply Z.ltb_lt, IZR_lt in H1, H2. pose proof (Rmult_lt_0_compat _ _ Hr H2).
    apply Rmult_integral in Q as [Q|Q]; lra.
  - apply Z.ltb_lt, IZR_lt in H1, H2. assert (0 < root * - IZR y) by (apply Rmult_lt_0_compat; lra).
    apply Rmult_integral in Q as [Q|Q]; lra.
Qed.

Lemma fan_tied_true i a b c : fan_there i a b c = true -> fan_tied i a b c = true ->
  incircle (at_z i 0) (at_z a 0) (at_z b 0) (at_z c 0) = 0 /\ incircle (at_z i 0) (at_z b 0) (at_z c 0) (at_z a 0) = 0.
Proof.
  intros There H. destruct (fan_parts _ _ _ _ There) as (_ & _ & _ & _ & _ & C1 & C2).
  pose proof (there_gamma _ _ _ C1 0 (Rle_refl 0)) as G1. pose proof (there_gamma _ _ _ C2 0 (Rle_refl 0)) as G2.
  unfold fan_tied in H. apply andb_prop in H as [H1 H2]. split.
  - rewrite start_incircle. apply (sum_zero_at_true _ _ _ _ _ (sqrt_lt_R0 _ G1) (start_product i a b c _ _ G1) H1).
  - destruct (turned_ints (zrow i a) (zrow i b) (zrow i c)) as (Ea & Eb & Ec). rewrite <- Ea, <- Eb, <- Ec in H2.
    rewrite start_incircle. apply (sum_zero_at_true _ _ _ _ _ (sqrt_lt_R0 _ G2) (start_product i b c a _ _ G2) H2).
Qed.

Lemma fan_past_true i a b c : fan_there i a b c && fan_past i a b c = true ->
  forall z, 0 <= z -> passed (at_z i z) (at_z b z) (at_z a z) (at_z c z).
Proof.
  intros H z Hz. apply andb_prop in H as [H1 H2].
  destruct (fan_sums_true _ _ _ _ H1 sum_not_positive (fun x => x <= 0) true z sum_not_positive_proves Hz H2) as [Q1 Q2].
  apply (fan_says _ (fun x => x <= 0)); try assumption.
  intros k x g _ B C S. destruct S as [S|S]; [right; apply C, S|left; apply B, S].
Qed.

(* At the beginning of the interval. *)
Lemma entered_true l r s e : by_fan fan_entered_at l r s e = true -> entered (at_z l 0) (at_z r 0) (at_z s 0) (at_z e 0).
Proof.
  assert (Fan : forall i a b c, fan_there i a b c && fan_entered i a b c = true -> entered (at_z i 0) (at_z b 0) (at_z a 0) (at_z c 0)).
  { intros i a b c H. apply andb_prop in H as [T E]. destruct (fan_entered_true _ _ _ _ T E).
    apply (fan_says _ (fun x => x < 0)); auto; lra. }
  unfold by_fan, fan_entered_at. destruct (mwall l); intros H; [apply circles_turn|]; apply Fan, H.
Qed.
