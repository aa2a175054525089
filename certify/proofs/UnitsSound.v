(* What is checked is what the files say: numbers are multiples of their units, claims those of the lines. *)
From Coq Require Import ZArith QArith List Bool FMapPositive Lia.
From Voroproof Require Import History Replay Files Units Search.
Import ListNotations.
Open Scope Z_scope.

Ltac good H := match type of H with
  | try ?a _ = Good _ => let X := fresh "X" in destruct a eqn:X; simpl in H; [|discriminate]; good H
  | need ?b _ _ = Good _ => let X := fresh "X" in destruct b eqn:X; simpl in H; [|discriminate]; good H
  | _ => idtac
  end.

Lemma to_unit_ok u q z : to_unit u q = Good z -> in_unit u q z.
Proof.
  unfold to_unit. pose proof (Z_div_mod (Qnum q * u) (Zpos (Qden q)) eq_refl) as D.
  destruct (Z.div_eucl _ _) as [y r]. intros H. good H. injection H as <-. apply Z.eqb_eq in X.
  unfold in_unit, Qeq, inject_Z, Qmult. simpl. rewrite Pos.mul_1_r. lia.
Qed.

Lemma both_ok u q z : both u q = Good z -> both_in_unit u q z.
Proof. unfold both. intros H. good H. injection H as <-. split; apply to_unit_ok; assumption. Qed.

Lemma all_onto_ok {A B} (f : A -> outcome B) l : forall done l', all_onto f l done = Good l' ->
  exists l2, l' = rev done ++ l2 /\ Forall2 (fun a b => f a = Good b) l l2.
Proof.
  induction l as [|a l IH]; simpl; intros done l' H.
  - injection H as <-. exists []. rewrite app_nil_r. split; [unfold rev'; symmetry; apply rev_alt | constructor].
  - destruct (f a) as [b|] eqn:E; [|discriminate]. simpl in H. apply IH in H as (l2 & -> & F). exists (b :: l2).
    simpl. rewrite <- app_assoc. split; [reflexivity|constructor; assumption].
Qed.
Lemma all_ok {A B} (f : A -> outcome B) l l' : all f l = Good l' -> Forall2 (fun a b => f a = Good b) l l'.
Proof. intros H. apply all_onto_ok in H as (l2 & -> & F). exact F. Qed.

Lemma implied {A B} (R S : A -> B -> Prop) l m : Forall2 R l m -> (forall a b, R a b -> S a b) -> Forall2 S l m.
Proof. intros F I. induction F; constructor; auto. Qed.

Lemma find_map_from {A} (l : list A) : forall k m j, PositiveMap.find j (map_from k l m) =
  if Pos.ltb j k then PositiveMap.find j m
  else match nth_error l (Pos.to_nat j - Pos.to_nat k) with Some a => Some a | None => PositiveMap.find j m end.
Proof.
  induction l as [|a l IH]; simpl; intros k m j.
  - destruct (Pos.ltb j k); [reflexivity|]. destruct (Pos.to_nat j - Pos.to_nat k)%nat; reflexivity.
  - rewrite IH. destruct (Pos.ltb_spec j (Pos.succ k)), (Pos.ltb_spec j k); try lia.
    + apply PositiveMap.gso. lia.
    + assert (j = k) as -> by lia. rewrite Nat.sub_diag. simpl. apply PositiveMap.gss.
    + rewrite PositiveMap.gso by lia. replace (Pos.to_nat j - Pos.to_nat k)%nat with (S (Pos.to_nat j - Pos.to_nat (Pos.succ k))) by lia.
      reflexivity.
Qed.
Lemma find_numbers {A} (l : list A) k : PositiveMap.find k (numbers l) = numbered l k.
Proof.
  unfold numbers, numbered. rewrite find_map_from, PositiveMap.gempty. destruct (Pos.ltb_spec k 1); [lia|].
  rewrite Pos2Nat.inj_1, Nat.sub_1_r. destruct (nth_error _ _); reflexivity.
Qed.

Lemma numbered_both {A B} (R : A -> B -> Prop) l m : Forall2 R l m -> forall k,
  match numbered l k, numbered m k with Some a, Some b => R a b | None, None => True | _, _ => False end.
Proof. intros F k. unfold numbered. generalize (pred (Pos.to_nat k)). induction F; intros [|n]; simpl; auto. apply IHF. Qed.

Section Units.
Variables t v m : Z.

Lemma body_ok d b : body_of t v m d = Good b -> disk_is t v m d b.
Proof.
  unfold body_of. intros H. good H. injection H as <-. apply to_unit_ok in X, X0. apply both_ok in X1, X2.
  unfold disk_is. simpl. tauto.
Qed.
Lemma maneuver_ok p n : maneuver_of t v p = Good n -> maneuver_is t v p n.
Proof.
  destruct p as [[u g] w]. unfold maneuver_of. intros H. good H. injection H as <-. apply to_unit_ok in X. apply both_ok in X0.
  unfold maneuver_is. simpl. tauto.
Qed.
Lemma centre_ok p n : centre_of t v p = Good n -> centre_is t v p n.
Proof. unfold centre_of. intros H. good H. injection H as <-. apply both_ok in X. split; [reflexivity|assumption]. Qed.

Lemma problem_ok s h tau lambda P : problem_of t v m s h tau lambda = Good P ->
  0 < t /\ 0 < v /\ 0 < m /\ problem_is t v m s h tau lambda P.
Proof.
  unfold problem_of. intros H. good H. injection H as <-. apply andb_prop in X as [X Xm]. apply andb_prop in X as [Xt Xv].
  apply Z.ltb_lt in Xt, Xv, Xm. apply all_ok in X0, X1. apply to_unit_ok in X2, X3.
  repeat (split; [assumption|]). constructor; simpl; try reflexivity; try assumption.
  - intros g. rewrite find_numbers. refine (numbered_both _ _ _ (implied _ _ _ _ X0 body_ok) g).
  - intros k. rewrite find_numbers. destruct (first_edges h); [reflexivity|]. unfold numbered. destruct (pred _); reflexivity.
  - exact (implied _ _ _ _ X1 maneuver_ok).
Qed.

(* The line that a claim is of. *)
Definition told (c : claim) : event Z :=
  match c with
  | Flip n q _ _ _ _ _ _ _ => Flipped n q
  | Collision n i j a b ps _ _ _ _ => Collided n i j (Some (a, b)) ps
  | Maneuver n g a ps _ => Maneuvered n g (Some a) ps
  end.

Lemma event_ok e c : event_of t v e = Good (told c) -> event_is t v e c.
Proof.
  destruct e as [u q|u i j w ps|u g w ps]; unfold event_of; intros H.
  - good H. apply to_unit_ok in X. destruct c; try discriminate. injection H; intros; subst. constructor; assumption.
  - destruct w as [[a b]|]; good H; destruct c; try discriminate; simpl in H.
    injection H; intros; subst. simpl in X0. good X0. injection X0; intros; subst.
    apply to_unit_ok in X. apply both_ok in X2, X3. apply all_ok in X1. constructor; try assumption. exact (implied _ _ _ _ X1 centre_ok).
  - destruct w as [a|]; good H; destruct c; try discriminate; simpl in H.
    injection H; intros; subst. simpl in X0. good X0. injection X0; intros; subst.
    apply to_unit_ok in X. apply both_ok in X2. apply all_ok in X1. constructor; try assumption. exact (implied _ _ _ _ X1 centre_ok).
Qed.
End Units.

Lemma find_claim_ok P d e l c d' : find_claim P d e l = Good (c, d') -> told c = e.
Proof.
  destruct e as [u q|u i j [[a b]|] ps|u g [w|] ps]; unfold find_claim; intros H; try discriminate.
  - unfold find_flip in H. good H. destruct a4 as [lo hi]. good H. injection H as <- _. reflexivity.
  - unfold find_collision in H. good H. destruct (filter _ _) as [|[k q] r]; [discriminate|]. good H. injection H as <- _. reflexivity.
  - good H. injection H as <- _. reflexivity.
Qed.

Lemma search_ok P es : forall d ls found n cs n', search P d es ls found n = (Good cs, n') ->
  exists cs2, cs = rev found ++ cs2 /\ map told cs2 = es.
Proof.
  induction es as [|e es IH]; simpl; intros d ls found n cs n' H.
  - injection H as <- _. exists []. rewrite app_nil_r. split; [unfold rev'; symmetry; apply rev_alt|reflexivity].
  - destruct (find_claim P d e (hd 0 ls)) as [[c d']|] eqn:F; [|discriminate]. apply IH in H as (cs2 & -> & M).
    apply find_claim_ok in F. exists (c :: cs2). simpl. rewrite <- app_assoc, F, M. split; reflexivity.
Qed.
