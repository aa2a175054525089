(* Polynomials with whole coefficients in z, for z in [0, oo): sums, products, signs. *)
From Coq Require Import ZArith List Reals Lra.
Import ListNotations.

Definition poly := list Z.

Fixpoint add (p q : poly) : poly :=
  match p, q with
  | [], _ => q
  | _, [] => p
  | a :: p', b :: q' => (a + b)%Z :: add p' q'
  end.

Fixpoint sub (p q : poly) : poly :=
  match p, q with
  | [], _ => map Z.opp q
  | _, [] => p
  | a :: p', b :: q' => (a - b)%Z :: sub p' q'
  end.

Fixpoint mul (p q : poly) : poly :=
  match p with
  | [] => []
  | [a] => map (Z.mul a) q
  | a :: p' => add (map (Z.mul a) q) (0%Z :: mul p' q)
  end.

Definition neg (p : poly) : poly := map Z.opp p.

(* No coefficient is negative; moreover the first is positive. *)
Definition never_negative (p : poly) : bool := forallb (fun a => (0 <=? a)%Z) p.
Definition is_positive (p : poly) : bool :=
  match p with [] => false | a :: p' => ((0 <? a)%Z && never_negative p')%bool end.

Open Scope R_scope.

Fixpoint eval (p : poly) (z : R) : R :=
  match p with [] => 0 | a :: p' => IZR a + z * eval p' z end.

Lemma eval_scaled a p z : eval (map (Z.mul a) p) z = IZR a * eval p z.
Proof. induction p as [|b p IH]; simpl; [ring|]. rewrite IH, mult_IZR. ring. Qed.

Lemma eval_neg p z : eval (neg p) z = - eval p z.
Proof. unfold neg. induction p as [|b p IH]; simpl; [ring|]. rewrite IH, opp_IZR. ring. Qed.

Lemma eval_add p q z : eval (add p q) z = eval p z + eval q z.
Proof.
  revert q. induction p as [|a p IH]; intros [|b q]; simpl; try ring.
  rewrite IH, plus_IZR. ring.
Qed.

Lemma eval_sub p q z : eval (sub p q) z = eval p z - eval q z.
Proof.
  revert q. induction p as [|a p IH]; intros [|b q]; simpl; try ring.
  - fold (neg q). rewrite eval_neg, opp_IZR. ring.
  - rewrite IH, minus_IZR. ring.
Qed.

Lemma eval_mul p q z : eval (mul p q) z = eval p z * eval q z.
Proof.
  induction p as [|a p IH]; [simpl; ring|].
  destruct p as [|b p].
  - simpl. rewrite eval_scaled. ring.
  - change (mul (a :: b :: p) q) with (add (map (Z.mul a) q) (0%Z :: mul (b :: p) q)).
    rewrite eval_add, eval_scaled. change (eval (0%Z :: mul (b :: p) q) z) with (0 + z * eval (mul (b :: p) q) z).
    rewrite IH. change (eval (a :: b :: p) z) with (IZR a + z * eval (b :: p) z). ring.
Qed.

Lemma never_negative_true p z : 0 <= z -> never_negative p = true -> 0 <= eval p z.
Proof.
  intros Hz. induction p as [|a p IH]; simpl; [lra|].
  intros H. apply andb_prop in H. destruct H as [Ha Hp].
  apply Z.leb_le, IZR_le in Ha. pose proof (Rmult_le_pos _ _ Hz (IH Hp)). lra.
Qed.

Lemma positive_true p z : 0 <= z -> is_positive p = true -> 0 < eval p z.
Proof.
  intros Hz. destruct p as [|a p]; simpl; [discriminate|].
  intros H. apply andb_prop in H. destruct H as [Ha Hp].
  apply Z.ltb_lt, IZR_lt in Ha. pose proof (Rmult_le_pos _ _ Hz (never_negative_true p z Hz Hp)). lra.
Qed.

Lemma eval_continuous p : continuity (eval p).
Proof.
  induction p as [|a p IH]; simpl.
  - apply continuity_const. intros x y; reflexivity.
  - apply (continuity_plus (fun _ => IZR a) (fun z => z * eval p z)).
    + apply continuity_const. intros x y; reflexivity.
    + apply (continuity_mult (fun z => z) (eval p)); [apply derivable_continuous, derivable_id | exact IH].
Qed.

(* A polynomial without zeros in [0, oo) that is positive at 0 is positive. *)
Lemma positive_from_start p z :
  (forall w, 0 <= w -> eval p w <> 0) -> 0 < eval p 0 -> 0 <= z -> 0 < eval p z.
Proof.
  intros Hn H0 Hz. destruct (Rtotal_order (eval p z) 0) as [H|[H|H]]; [|exfalso; apply (Hn z Hz H)|exact H].
  exfalso. destruct (Req_dec z 0) as [->|Hne]; [lra|].
  destruct (IVT (fun w => - eval p w) 0 z) as [w [Hw He]]; try lra.
  - apply continuity_opp, eval_continuous.
  - apply (Hn w); lra.
Qed.
