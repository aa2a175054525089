(* Bounds that grow with the coefficient, as filtered/search/bernstein.cpp has them (docs/proved.md, section 6), and means. They
   are no part of the theorem. *)
From Coq Require Import Reals Lra Lia.
Open Scope R_scope.

(* A mean of numbers of at most B is at most B. *)
Lemma mean_bound (w x : nat -> R) (B : R) (n : nat) :
  (forall i, (i <= n)%nat -> 0 <= w i) -> sum_f_R0 w n = 1 -> (forall i, (i <= n)%nat -> Rabs (x i) <= B) ->
  Rabs (sum_f_R0 (fun i => w i * x i) n) <= B.
Proof.
  intros W One X. apply Rle_trans with (B * sum_f_R0 w n); [|rewrite One; lra]. rewrite scal_sum. clear One. induction n as [|n IH]; simpl.
  - rewrite Rabs_mult, (Rabs_pos_eq (w 0%nat)) by auto. apply Rmult_le_compat_l; auto.
  - eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; [apply IH; auto|].
    rewrite Rabs_mult, (Rabs_pos_eq (w (S n))) by auto. apply Rmult_le_compat_l; auto.
Qed.

Section Growth.
Variable g : R.
Hypothesis g_positive : 0 < g.

(* A coefficient of a product is a mean of products: where those of the factors are at most g^k P and g^k Q and err by at most g^k E
   and g^k F, it is at most g^k P Q and errs by at most g^k (P F + Q E + E F). *)
Theorem product_grows (w p q p' q' : nat -> R) (P Q E F : R) (k : nat) :
  (forall i, (i <= k)%nat -> 0 <= w i) -> sum_f_R0 w k = 1 ->
  (forall i, (i <= k)%nat -> Rabs (p i) <= g ^ i * P /\ Rabs (q i) <= g ^ i * Q /\
     Rabs (p' i - p i) <= g ^ i * E /\ Rabs (q' i - q i) <= g ^ i * F) ->
  Rabs (sum_f_R0 (fun i => w i * (p i * q (k - i)%nat)) k) <= g ^ k * (P * Q) /\
  Rabs (sum_f_R0 (fun i => w i * (p' i * q' (k - i)%nat - p i * q (k - i)%nat)) k) <= g ^ k * (P * F + Q * E + E * F).
Proof.
  intros W One H.
  assert (Two : forall a b A B i, (i <= k)%nat -> Rabs a <= g ^ i * A -> Rabs b <= g ^ (k - i) * B -> Rabs (a * b) <= g ^ k * (A * B)).
  { intros a b A B i I Ha Hb. rewrite Rabs_mult. replace (g ^ k) with (g ^ i * g ^ (k - i)) by (rewrite <- pow_add; f_equal; lia).
    replace (g ^ i * g ^ (k - i) * (A * B)) with ((g ^ i * A) * (g ^ (k - i) * B)) by ring. apply Rmult_le_compat; auto using Rabs_pos. }
  split; apply mean_bound; auto; intros i I; destruct (H i I) as (Hp & _ & Ep & _), (H (k - i)%nat ltac:(lia)) as (_ & Hq & _ & Eq).
  - exact (Two _ _ _ _ i I Hp Hq).
  - replace (p' i * q' (k - i)%nat - p i * q (k - i)%nat) with
      (p i * (q' (k - i)%nat - q (k - i)%nat) + (p' i - p i) * q (k - i)%nat + (p' i - p i) * (q' (k - i)%nat - q (k - i)%nat)) by ring.
    pose proof (Two _ _ _ _ i I Hp Eq) as T1. pose proof (Two _ _ _ _ i I Ep Hq) as T2. pose proof (Two _ _ _ _ i I Ep Eq) as T3.
    eapply Rle_trans; [apply Rabs_triang|]. eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang|].
    replace (g ^ k * (P * F + Q * E + E * F)) with (g ^ k * (P * F) + g ^ k * (E * Q) + g ^ k * (E * F)) by ring. lra.
Qed.

(* A level of de Casteljau's scheme at x, for a part of the window. *)
Theorem level_grows (c : nat -> R) (B x : R) (k : nat) :
  0 <= x <= 1 -> Rabs (c k) <= g ^ k * B -> Rabs (c (S k)) <= g ^ S k * B ->
  Rabs ((1 - x) * c k + x * c (S k)) <= g ^ k * (B * ((1 - x) + g * x)).
Proof.
  intros X H0 H1. eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult, (Rabs_pos_eq (1 - x)), (Rabs_pos_eq x) by lra.
  replace (g ^ k * (B * ((1 - x) + g * x))) with ((1 - x) * (g ^ k * B) + x * (g ^ S k * B)) by (simpl; ring).
  apply Rplus_le_compat; apply Rmult_le_compat_l; lra.
Qed.
End Growth.
