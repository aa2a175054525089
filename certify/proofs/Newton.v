(* How far a root is from a Newton step, as filtered/search/newton_step.cpp bounds it (docs/proved.md, section 6). It is no part of the
   theorem. *)
From Coq Require Import Reals Lra.
Open Scope R_scope.

(* f is computed as F at c, its slope as S; within h of c the slope changes by at most [curve] times the way. Then a root within h is
   within r of c, and within (e_f + |F/S| sigma) / least of c - F/S. *)
Theorem newton_step (f slope : R -> R) (c h F S e_f e_slope curve everywhere r sigma least z : R) :
  (forall x, Rabs (x - c) <= h -> derivable_pt_lim f x (slope x)) ->
  (forall x, Rabs (x - c) <= h -> Rabs (slope x - slope c) <= curve * Rabs (x - c)) ->
  Rabs (f c - F) <= e_f -> Rabs (slope c - S) <= e_slope -> 0 <= curve ->
  0 < everywhere <= Rabs S - (e_slope + curve * h) ->
  Rmin h ((Rabs F + e_f) / everywhere) <= r ->
  e_slope + curve * r <= sigma -> 0 < least <= Rabs S - sigma ->
  Rabs (z - c) <= h -> f z = 0 ->
  Rabs (z - c) <= r /\ Rabs (z - (c - F / S)) <= (e_f + Rabs (F / S) * sigma) / least.
Proof.
  intros D K EF ES Hc [E0 E1] Hr Hs [L0 L1] Hz Root.
  assert (Mean : exists x, Rabs (x - c) <= Rabs (z - c) /\ slope x * (z - c) = - f c).
  { destruct (Rtotal_order c z) as [H|[H|H]].
    - destruct (MVT_cor2 f slope c z H) as (x & E & I).
      { intros x Hx. apply D. rewrite Rabs_pos_eq in * by lra. lra. }
      exists x. rewrite !Rabs_pos_eq by lra. split; [lra|]. rewrite Root in E. lra.
    - subst z. exists c. split; [lra|]. rewrite Root. lra.
    - destruct (MVT_cor2 f slope z c H) as (x & E & I).
      { intros x Hx. apply D. rewrite Rabs_left1 in * by lra. lra. }
      exists x. rewrite !Rabs_left1 by lra. split; [lra|]. rewrite Root in E. lra. }
  destruct Mean as (x & X & M).
  assert (Near : Rabs (slope x - S) <= e_slope + curve * Rabs (x - c)).
  { replace (slope x - S) with ((slope x - slope c) + (slope c - S)) by ring. pose proof (K x ltac:(lra)).
    pose proof (Rabs_triang (slope x - slope c) (slope c - S)). lra. }
  assert (Far : Rabs S <= Rabs (slope x) + Rabs (slope x - S)).
  { replace S with (slope x + - (slope x - S)) at 1 by ring. pose proof (Rabs_triang (slope x) (- (slope x - S))). rewrite Rabs_Ropp in *. lra. }
  assert (Fc : Rabs (f c) <= Rabs F + e_f).
  { replace (f c) with (F + (f c - F)) by ring. pose proof (Rabs_triang F (f c - F)). lra. }
  assert (Way : Rabs (z - c) <= r).
  { assert (curve * Rabs (x - c) <= curve * h) by (apply Rmult_le_compat_l; lra).
    apply Rle_trans with (2 := Hr). apply Rmin_glb; [exact Hz|]. apply Rmult_le_reg_r with everywhere; [exact E0|].
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. rewrite <- (Rabs_Ropp (f c)), <- M, Rabs_mult in Fc.
    assert (everywhere * Rabs (z - c) <= Rabs (slope x) * Rabs (z - c)) by (apply Rmult_le_compat_r; [apply Rabs_pos|lra]). lra. }
  split; [exact Way|].
  assert (curve * Rabs (x - c) <= curve * r) by (apply Rmult_le_compat_l; lra).
  assert (S0 : S <> 0) by (intros ->; rewrite Rabs_R0 in *; pose proof (Rabs_pos (slope x - 0)); lra).
  apply Rmult_le_reg_r with least; [exact L0|]. unfold Rdiv at 2. rewrite (Rmult_assoc _ (/ least)), Rinv_l, Rmult_1_r by lra.
  apply Rle_trans with (Rabs (z - (c - F / S)) * Rabs (slope x)).
  { apply Rmult_le_compat_l; [apply Rabs_pos|lra]. }
  rewrite <- Rabs_mult. replace ((z - (c - F / S)) * slope x) with ((F - f c) + F / S * (slope x - S)).
  - apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_mult, <- (Rabs_Ropp (F - f c)). replace (- (F - f c)) with (f c - F) by ring.
    apply Rplus_le_compat; [exact EF|]. apply Rmult_le_compat_l; [apply Rabs_pos|lra].
  - replace (f c) with (- (slope x * (z - c))) by lra. field. exact S0.
Qed.
