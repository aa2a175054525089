(* Truth at 0 that is kept by limits from the left, and lasts a little to the right, reaches T. *)
From Coq Require Import Reals Lra.
Open Scope R_scope.

Lemma march (T : R) (good : R -> Prop) : (forall t, good t \/ ~ good t) -> good 0 ->
  (forall t, 0 < t < T -> (forall d, 0 < d -> exists u, t - d < u < t /\ 0 <= u /\ good u) -> good t) ->
  (forall t, 0 <= t < T -> good t -> exists d, 0 < d /\ forall u, t < u < t + d -> u < T -> good u) ->
  forall t, 0 <= t < T -> good t.
Proof.
  intros Dec G0 Limit Last t Ht.
  set (E := fun x => 0 <= x <= t /\ forall u, 0 <= u <= x -> good u).
  assert (E0 : E 0).
  { split; [lra|]. intros u Hu. assert (u = 0) as -> by lra. exact G0. }
  destruct (completeness E) as [s [Up Low]].
  - exists t. intros x [Hx _]. lra.
  - exists 0. exact E0.
  - assert (S0 : 0 <= s) by (apply Up, E0). assert (S1 : s <= t) by (apply Low; intros x [Hx _]; lra).
    assert (Below : forall u, 0 <= u < s -> good u).
    { intros u Hu. destruct (Dec u) as [|N]; [assumption|exfalso]. assert (s <= u); [|lra]. apply Low. intros x [_ X].
      apply Rnot_lt_le. intros L. apply N, X. lra. }
    assert (Gs : good s).
    { destruct (Rle_lt_or_eq_dec 0 s S0) as [L| <-]; [|exact G0]. apply Limit; [lra|]. intros d Hd.
      set (m := Rmin d s). assert (0 < m) by (apply Rmin_glb_lt; lra). assert (m <= d) by apply Rmin_l. assert (m <= s) by apply Rmin_r. clearbody m.
      exists (s - m / 2). split; [lra|]. split; [lra|]. apply Below. lra. }
    destruct (Rle_lt_or_eq_dec s t S1) as [L| ->]; [|exact Gs].
    destruct (Last s ltac:(lra) Gs) as (d & Hd & D).
    set (m := Rmin d (t - s)). assert (0 < m) by (apply Rmin_glb_lt; lra). assert (m <= d) by apply Rmin_l. assert (m <= t - s) by apply Rmin_r. clearbody m.
    assert (E (s + m / 2)); [|apply Up in H2; lra]. split; [lra|]. intros u Hu.
    destruct (Rtotal_order u s) as [H3|[->|H3]]; [apply Below; lra|exact Gs|apply D; lra].
Qed.
