(* A flip: between the ends of its bracket a vertex's circle touches all four. *)
From Coq Require Import ZArith List Bool Reals Ranalysis5 Lra Lia FMapPositive.
From Voroproof Require Import Forms Polynomial Geometry Circle Vertex Scale Piece PieceSound EdgeSound History Replay LifeSound.
Import ListNotations.
Open Scope R_scope.

(* Enlarging does not change the sign of an in-circle function. *)
Definition enlarged (m : R) (j : row R) : row R := Row (m * rx j) (m * ry j) (m * rs j) (m * m * rp j).

Lemma seen_scaled m i g : seen_from (scale m i) (scale m g) = enlarged m (seen_from i g).
Proof. unfold seen_from, enlarged, row_of, scale; simpl. f_equal; ring. Qed.

Lemma incircle_scaled m i j k e : 0 < m -> incircle (scale m i) (scale m j) (scale m k) (scale m e) = m * m * m * (m * m * m * m) * incircle i j k e.
Proof.
  intros Hm. unfold incircle. rewrite !seen_scaled. simpl (wall (scale m _)).
  generalize (seen_from i j) (seen_from i k) (seen_from i e). intros a b c.
  assert (A : r_a (enlarged m a) (enlarged m b) (enlarged m c) = m * m * m * m * r_a a b c)
    by (unfold form_a, dsp, dxp, dxs, enlarged; simpl; ring).
  assert (B : r_b (enlarged m a) (enlarged m b) (enlarged m c) = m * m * m * m * r_b a b c)
    by (unfold form_b, dsp, dyp, dys, enlarged; simpl; ring).
  assert (C : r_c (enlarged m a) (enlarged m b) (enlarged m c) = m * m * m * m * r_c a b c)
    by (unfold form_c, dyp, dxp, dxy, enlarged; simpl; ring).
  assert (X : r_dxp (enlarged m a) (enlarged m b) = m * m * m * r_dxp a b) by (unfold dxp, enlarged; simpl; ring).
  assert (Y : r_dyp (enlarged m a) (enlarged m b) = m * m * m * r_dyp a b) by (unfold dyp, enlarged; simpl; ring).
  assert (G : gamma (enlarged m a) (enlarged m b) = (m * m * m) * (m * m * m) * gamma a b)
    by (unfold gamma, tangency, enlarged; simpl; ring).
  assert (M : 0 < m * m * m) by (repeat apply Rmult_lt_0_compat; exact Hm).
  rewrite G, sqrt_mult_alt, sqrt_square by (try apply Rle_0_sqr; lra).
  unfold form_g. rewrite A, B, C, X, Y. ring.
Qed.

Lemma same_continuity (f g : R -> R) z : (forall w, f w = g w) -> continuity_pt f z -> continuity_pt g z.
Proof.
  intros E H eps He. destruct (H eps He) as (a & Ha & B). exists a. split; [exact Ha|]. intros w Hw. rewrite <- !E. apply B, Hw.
Qed.

(* An in-circle function of moving generators that goes from not negative to negative has a zero. *)
Section Zero.
  Variables i j k e : moving.
  Hypothesis i_disk : mwall i = false.
  Hypothesis there : circle_there (mwall j) (mwall k) (prow i j) (prow i k) (zrow i j) (zrow i k) = true.
  Let q z := incircle (at_z i z) (at_z j z) (at_z k z) (at_z e z).

  Lemma incircle_continuous z : 0 <= z -> continuity_pt q z.
  Proof.
    intros Hz.
    set (g := p_g (prow i j) (prow i k) (p_a (prow i j) (prow i k) (prow i e)) (p_b (prow i j) (prow i k) (prow i e))).
    set (c := p_c (prow i j) (prow i k) (prow i e)).
    set (gam := mul (mul (rp (prow i j)) (rp (prow i k))) (p_tangency (prow i j) (prow i k))).
    assert (G : forall w, gamma (seen_from (at_z i w) (at_z j w)) (seen_from (at_z i w) (at_z k w)) = eval gam w).
    { intros w. unfold gam. rewrite !eval_mul, at_tangency, !prow_at. unfold gamma. rewrite <- !prow_at. reflexivity. }
    apply (same_continuity (fun w => eval (poly_sign (mwall e) g) w + sqrt (eval gam w) *
      eval (poly_sign (xorb (mwall e) (mwall j || mwall k)) c) w)).
    { intros w. unfold q. rewrite incircle_is, G. reflexivity. }
    apply (continuity_pt_plus (eval (poly_sign (mwall e) g))); [apply eval_continuous|].
    apply (continuity_pt_mult (fun w => sqrt (eval gam w))); [|apply eval_continuous].
    apply (continuity_pt_comp (eval gam) sqrt); [apply eval_continuous|].
    apply sqrt_continuity_pt. rewrite <- G. apply there_gamma; assumption.
  Qed.

  Lemma zero_between y : 0 <= y -> 0 <= q 0 -> q y < 0 -> exists z, 0 <= z <= y /\ q z = 0.
  Proof.
    intros Hy H0 H1. destruct (Rle_lt_or_eq_dec _ _ H0) as [H|H]; [|exists 0; split; [lra|symmetry; exact H]].
    destruct (Rle_lt_or_eq_dec _ _ Hy) as [Hy'|E]; [|rewrite <- E in H1; lra].
    destruct (IVT_interv (fun z => - q z) 0 y) as [z [Hz E]]; try lra.
    - intros a Ha. apply (continuity_pt_opp q). apply incircle_continuous. lra.
    - exists z. split; [lra|]. lra.
  Qed.
End Zero.

Section Flip.
Variable P : problem.

(* A generator with what the checker knows of it. *)
Section Bracket.
  Variables lo hi : Z.
  Hypothesis order : (lo < hi)%Z.
  Variables gi ga gb gc : gen.
  Variables mi ma mb mc : mover.
  Hypothesis ri : size_ mi = radius_of P gi.
  Hypothesis ra : size_ ma = radius_of P ga.
  Hypothesis rb : size_ mb = radius_of P gb.
  Hypothesis rc : size_ mc = radius_of P gc.
  Let at_ (g : gen) (m : mover) (t : R) := on_leg P g (path m) t.

  (* The fan's edge at a time. *)
  Let edge_is (say : generator -> generator -> generator -> generator -> Prop) (u : R) : Prop :=
    say (at_ gi mi u) (at_ gb mb u) (at_ ga ma u) (at_ gc mc u).

  Lemma there_between : fan_there (span gi mi lo (hi + 1)) (span ga ma lo (hi + 1)) (span gb mb lo (hi + 1)) (span gc mc lo (hi + 1)) = true ->
    forall u, IZR lo <= u <= IZR hi -> edge_is there u.
  Proof.
    intros H u Hu. assert (B : IZR lo <= u < IZR (hi + 1)) by (rewrite plus_IZR; lra).
    destruct (parameter_pos _ _ _ B) as [Z1 Z2]. unfold edge_is, at_. apply (there_unscale _ Z2). rewrite <- !(span_at P) by assumption.
    apply (fan_says _ (fun _ => True)); trivial.
  Qed.

  Lemma bracket :
    fan_legal_at (span gi mi lo lo) (span ga ma lo lo) (span gb mb lo lo) (span gc mc lo lo) = true ->
    fan_entered_at (span gi mi hi (hi + 1)) (span ga ma hi (hi + 1)) (span gb mb hi (hi + 1)) (span gc mc hi (hi + 1)) = true ->
    fan_there (span gi mi lo (hi + 1)) (span ga ma lo (hi + 1)) (span gb mb lo (hi + 1)) (span gc mc lo (hi + 1)) = true ->
    edge_is legal (IZR lo) /\ edge_is entered (IZR hi) /\
    (exists u o, (IZR lo <= u <= IZR hi) /\ vertex_circle o (at_ gi mi u) (at_ ga ma u) (at_ gb mb u) /\ touches o (at_ gc mc u)) /\
    (exists u o, (IZR lo <= u <= IZR hi) /\ vertex_circle o (at_ gi mi u) (at_ gb mb u) (at_ gc mc u) /\ touches o (at_ ga ma u)).
  Proof.
    intros H1 H2 H3. unfold fan_legal_at in H1. unfold fan_entered_at in H2.
    pose proof (fan_legal_true _ _ _ _ H1 0 (Rle_refl 0)) as L. rewrite !(span_start P) in L by assumption.
    apply andb_prop in H1 as [T1 E1]. apply andb_prop in H2 as [T2 E2].
    destruct (fan_empty_true _ _ _ _ T1 0 (Rle_refl 0) E1) as [Q1 Q2]. rewrite !(span_start P) in Q1 by assumption. rewrite !(span_start P) in Q2 by assumption.
    destruct (fan_entered_true _ _ _ _ T2 E2) as [N1 N2]. 
    destruct (fan_circles _ _ _ _ T2 0 (Rle_refl 0)) as [(o1 & V1 & _ & _ & X1 & _) (o2 & V2 & _ & _ & X2 & _)].
    specialize (X1 N1). specialize (X2 N2). 
    rewrite !(span_start P) in V1 by assumption. rewrite !(span_start P) in V2 by assumption. rewrite !(span_start P) in X1 by assumption. rewrite !(span_start P) in X2 by assumption. rewrite !(span_start P) in N1 by assumption. rewrite !(span_start P) in N2 by assumption.
    assert (Hlt : IZR lo < IZR hi) by (apply IZR_lt, order).
    assert (Y : IZR lo <= IZR hi < IZR (hi + 1)) by (rewrite plus_IZR; lra).
    destruct (fan_parts _ _ _ _ H3) as (W & _ & _ & _ & _ & C1 & C2).
    destruct (parameter_pos _ _ _ Y) as [Z1 Z2].
    set (y := (IZR hi - IZR lo) / (IZR (hi + 1) - IZR hi)) in *.
    set (m := (IZR (hi + 1) - IZR lo) / (IZR (hi + 1) - IZR hi)) in *.
    assert (M7 : 0 < m * m * m * (m * m * m * m)).
    { assert (Pow : forall w, 0 < w -> 0 < w * w * w * (w * w * w * w)) by (intros w Hw; repeat apply Rmult_lt_0_compat; exact Hw).
      apply Pow, Z2. }
    assert (Time : forall z, 0 <= z <= y -> exists u v, (IZR lo <= u <= IZR hi) /\ 0 < v /\
      forall g n, size_ n = radius_of P g -> at_z (span g n lo (hi + 1)) z = scale v (at_ g n u)).
    { intros z [Hz0 Hzy]. set (u := (IZR lo + z * IZR (hi + 1)) / (1 + z)).
      assert (U1 : u = IZR hi + (z * 1 - (IZR hi - IZR lo)) / (1 + z)) by (unfold u; rewrite plus_IZR; field; lra).
      assert (U0 : u = IZR lo + z * (IZR (hi + 1) - IZR lo) / (1 + z)) by (unfold u; field; lra).
      assert (y = IZR hi - IZR lo) as Ey by (unfold y; rewrite plus_IZR; field; lra).
      assert (I1 : 0 < / (1 + z)) by (apply Rinv_0_lt_compat; lra).
      assert (B1 : IZR lo <= u).
      { rewrite U0. assert (0 <= z * (IZR (hi + 1) - IZR lo) / (1 + z)); [|lra].
        apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]. }
      assert (B2 : u <= IZR hi).
      { rewrite U1. assert (0 <= ((IZR hi - IZR lo) - z) / (1 + z)) by (apply Rmult_le_pos; lra).
        replace ((z * 1 - (IZR hi - IZR lo)) / (1 + z)) with (- (((IZR hi - IZR lo) - z) / (1 + z))) by (field; lra). lra. }
      exists u, ((IZR (hi + 1) - IZR lo) / (IZR (hi + 1) - u)).
      assert (B : IZR lo <= u < IZR (hi + 1)) by (rewrite plus_IZR; lra).
      destruct (parameter_pos _ _ _ B) as [_ V]. repeat split; try assumption.
      intros g n Hn. unfold at_. rewrite <- span_at by assumption. f_equal.
      rewrite U0. field. rewrite plus_IZR. split; [|lra]. 
      intros Hx. assert (0 < IZR hi + 1 - IZR lo) by lra. lra. }
    split; [exact L|]. split; [split; [exists o1|exists o2]; split; assumption|]. split.
    - destruct (zero_between _ _ _ (span gc mc lo (hi + 1)) C1 y Z1) as (z & Hz & E).
      + rewrite !(span_start P) by assumption. exact Q1.
      + unfold y. rewrite !(span_at P) by assumption. fold m. rewrite incircle_scaled by exact Z2.
        assert (0 < m * m * m * (m * m * m * m) * - incircle (on_leg P gi (path mi) (IZR hi)) (on_leg P ga (path ma) (IZR hi))
          (on_leg P gb (path mb) (IZR hi)) (on_leg P gc (path mc) (IZR hi))) by (apply Rmult_lt_0_compat; lra). lra.
      + destruct (Time z Hz) as (u & v & Hu & Hv & A).
        destruct (fan_circles _ _ _ _ H3 z (proj1 Hz)) as [(o & V & _ & X & _) _]. specialize (X E).
        rewrite !A in V by assumption. rewrite !A in X by assumption.
        exists u, (scale_circle (/ v) o). split; [exact Hu|]. split; [apply vertex_unscale | apply touches_unscale]; assumption.
    - destruct (zero_between _ _ _ (span ga ma lo (hi + 1)) C2 y Z1) as (z & Hz & E).
      + rewrite !(span_start P) by assumption. exact Q2.
      + unfold y. rewrite !(span_at P) by assumption. fold m. rewrite incircle_scaled by exact Z2.
        assert (0 < m * m * m * (m * m * m * m) * - incircle (on_leg P gi (path mi) (IZR hi)) (on_leg P gb (path mb) (IZR hi))
          (on_leg P gc (path mc) (IZR hi)) (on_leg P ga (path ma) (IZR hi))) by (apply Rmult_lt_0_compat; lra). lra.
      + destruct (Time z Hz) as (u & v & Hu & Hv & A).
        destruct (fan_circles _ _ _ _ H3 z (proj1 Hz)) as [_ (o & V & _ & X & _)]. specialize (X E).
        rewrite !A in V by assumption. rewrite !A in X by assumption.
        exists u, (scale_circle (/ v) o). split; [exact Hu|]. split; [apply vertex_unscale | apply touches_unscale]; assumption.
  Qed.
End Bracket.
End Flip.
