(* The checks of Piece.v are sound: what they accept is so at every instant of the interval. *)
From Coq Require Import ZArith List Bool Reals Lra.
From Voroproof Require Import Forms Polynomial Geometry Circle Vertex Scale Piece.
Import ListNotations.
Open Scope R_scope.

(* The generator at z, enlarged by 1 + z. *)
Definition at_z (g : moving) (z : R) : generator :=
  Generator (IZR (ax g) + z * IZR (bx g)) (IZR (ay g) + z * IZR (by_ g)) ((1 + z) * IZR (mr g)) (mwall g).

Notation value z := (row_map (fun p => eval p z)).

Lemma prow_at i g z : value z (prow i g) = seen_from (at_z i z) (at_z g z).
Proof.
  unfold prow, seen_from.
  rewrite (map_row add sub mul Rplus Rminus Rmult (fun p => eval p z) (fun p q => eval_add p q z) (fun p q => eval_sub p q z)
    (fun p q => eval_mul p q z)).
  f_equal; simpl; rewrite ?minus_IZR; ring.
Qed.

Lemma zrow_at i g : row_map IZR (zrow i g) = seen_from (at_z i 0) (at_z g 0).
Proof.
  unfold zrow, seen_from. rewrite (map_row Z.add Z.sub Z.mul Rplus Rminus Rmult IZR plus_IZR minus_IZR mult_IZR).
  f_equal; simpl; rewrite ?minus_IZR; ring.
Qed.

Section At.
  Variable z : R.
  Let h_add p q := eval_add p q z.
  Let h_sub p q := eval_sub p q z.
  Let h_mul p q := eval_mul p q z.
  Definition at_dxy := map_dxy sub mul Rminus Rmult (fun p => eval p z) h_sub h_mul.
  Definition at_tangency := map_tangency add sub mul Rplus Rminus Rmult (fun p => eval p z) h_add h_sub h_mul.
  Definition at_a := map_a add sub mul Rplus Rminus Rmult (fun p => eval p z) h_add h_sub h_mul.
  Definition at_b := map_b add sub mul Rplus Rminus Rmult (fun p => eval p z) h_add h_sub h_mul.
  Definition at_c := map_c add sub mul Rplus Rminus Rmult (fun p => eval p z) h_add h_sub h_mul.
  Definition at_g := map_g add sub mul Rplus Rminus Rmult (fun p => eval p z) h_add h_sub h_mul.
  Definition at_f := map_f add sub mul Rplus Rminus Rmult (fun p => eval p z) h_add h_sub h_mul.
  Definition at_u := map_u add sub mul Rplus Rminus Rmult (fun p => eval p z) h_add h_sub h_mul.
  Definition at_m := map_m add sub mul Rplus Rminus Rmult (fun p => eval p z) h_add h_sub h_mul.
End At.

Definition int_dxy := map_dxy Z.sub Z.mul Rminus Rmult IZR minus_IZR mult_IZR.
Definition int_a := map_a Z.add Z.sub Z.mul Rplus Rminus Rmult IZR plus_IZR minus_IZR mult_IZR.
Definition int_b := map_b Z.add Z.sub Z.mul Rplus Rminus Rmult IZR plus_IZR minus_IZR mult_IZR.
Definition int_c := map_c Z.add Z.sub Z.mul Rplus Rminus Rmult IZR plus_IZR minus_IZR mult_IZR.
Definition int_g := map_g Z.add Z.sub Z.mul Rplus Rminus Rmult IZR plus_IZR minus_IZR mult_IZR.
Definition int_f := map_f Z.add Z.sub Z.mul Rplus Rminus Rmult IZR plus_IZR minus_IZR mult_IZR.
Definition int_u := map_u Z.add Z.sub Z.mul Rplus Rminus Rmult IZR plus_IZR minus_IZR mult_IZR.

Lemma eval_poly_sign w p z : eval (poly_sign w p) z = sign_of w * eval p z.
Proof. unfold poly_sign, sign_of. destruct w; [rewrite eval_neg|]; ring. Qed.

Lemma with_sign_is w x : IZR (with_sign w x) = sign_of w * IZR x.
Proof. unfold with_sign, sign_of. destruct w; [rewrite opp_IZR|]; ring. Qed.

Lemma sign_square w : sign_of w * sign_of w = 1.
Proof. unfold sign_of. destruct w; ring. Qed.

Lemma sign_xor v w : sign_of (xorb v w) = sign_of v * sign_of w.
Proof. unfold sign_of. destruct v, w; simpl; ring. Qed.

Lemma has_right_sign_true w p z : 0 <= z -> has_right_sign w p = true -> right w (eval p z).
Proof.
  intros Hz H. apply (positive_true _ z Hz) in H. unfold right. destruct w; [rewrite eval_neg in H; lra|exact H].
Qed.

(* Sums x + sqrt(gamma) y of polynomials. *)
Section Sum.
  Variables m px py : poly.
  Variables x0 y0 : Z.
  Variables gam n : R -> R.
  Hypothesis x0_is : IZR x0 = eval px 0.
  Hypothesis y0_is : IZR y0 = eval py 0.
  Hypothesis gam_pos : forall w, 0 <= w -> 0 < gam w.
  Hypothesis n_pos : forall w, 0 <= w -> 0 < n w.
  Hypothesis product : forall w, 0 <= w -> eval px w * eval px w - gam w * (eval py w * eval py w) = n w * eval m w.

  Lemma roots z : 0 <= z -> 0 < sqrt (gam z) /\
    eval px z * eval px z - sqrt (gam z) * sqrt (gam z) * (eval py z * eval py z) = n z * eval m z.
  Proof.
    intros Hz. split; [apply sqrt_lt_R0, gam_pos, Hz|]. rewrite sqrt_sqrt by (apply Rlt_le, gam_pos, Hz). apply product, Hz.
  Qed.

  Lemma first_stays z : 0 <= z -> is_positive m = true -> (0 <? x0)%Z = true -> 0 < eval px z.
  Proof.
    intros Hz Hm H0. apply positive_from_start; [|rewrite <- x0_is; apply IZR_lt, Z.ltb_lt, H0|exact Hz].
    intros w Hw E. pose proof (product w Hw) as P. rewrite E in P.
    pose proof (Rmult_lt_0_compat _ _ (n_pos w Hw) (positive_true _ _ Hw Hm)).
    pose proof (Rle_0_sqr (eval py w)) as Q. unfold Rsqr in Q.
    pose proof (Rmult_le_pos _ _ (Rlt_le _ _ (gam_pos w Hw)) Q). lra.
  Qed.

  Lemma second_stays z : 0 <= z -> is_positive (neg m) = true -> (0 <? y0)%Z = true -> 0 < eval py z.
  Proof.
    intros Hz Hm H0. apply positive_from_start; [|rewrite <- y0_is; apply IZR_lt, Z.ltb_lt, H0|exact Hz].
    intros w Hw E. pose proof (product w Hw) as P. rewrite E in P.
    pose proof (Rmult_lt_0_compat _ _ (n_pos w Hw) (positive_true _ _ Hw Hm)) as Q. rewrite eval_neg in Q.
    pose proof (Rle_0_sqr (eval px w)) as Q1. unfold Rsqr in Q1. lra.
  Qed.

  Lemma sum_positive_true z : 0 <= z ->
    sum_positive m (fun _ => x0) (fun _ => y0) (fun _ => px) (fun _ => py) = true -> 0 < eval px z + sqrt (gam z) * eval py z.
  Proof.
    intros Hz H. destruct (roots z Hz) as [R P].
    apply (positive_by_f _ _ (eval m z) (n z) _ R (n_pos z Hz) P). unfold sum_positive in H.
    destruct (is_positive m) eqn:Em.
    - left. split; [apply positive_true; assumption | apply first_stays; assumption].
    - destruct (is_positive (neg m)) eqn:En.
      + right; left. apply (positive_true _ z Hz) in En as En'. rewrite eval_neg in En'. split; [lra | apply second_stays; assumption].
      + right; right. apply orb_prop in H as [H|H]; apply andb_prop in H as [H1 H2].
        * left. split; [apply positive_true | apply never_negative_true]; assumption.
        * right. split; [apply never_negative_true | apply positive_true]; assumption.
  Qed.

  Lemma sum_not_negative_true z : 0 <= z ->
    sum_not_negative m (fun _ => x0) (fun _ => y0) (fun _ => px) (fun _ => py) = true -> 0 <= eval px z + sqrt (gam z) * eval py z.
  Proof.
    intros Hz H. destruct (roots z Hz) as [R P].
    apply (not_negative_by_f _ _ (eval m z) (n z) _ R (n_pos z Hz) P). unfold sum_not_negative in H.
    destruct (is_positive m) eqn:Em.
    - left. split; apply Rlt_le; [apply positive_true; assumption | apply first_stays; assumption].
    - destruct (is_positive (neg m)) eqn:En.
      + right; left. apply (positive_true _ z Hz) in En as En'. rewrite eval_neg in En'.
        split; [lra | apply Rlt_le, second_stays; assumption].
      + apply orb_prop in H as [H|H]; [apply orb_prop in H as [H|H]|]; apply andb_prop in H as [H1 H2].
        * right; right. split; apply never_negative_true; assumption.
        * left. split; apply never_negative_true; assumption.
        * right; left. apply (never_negative_true _ z Hz) in H1. rewrite eval_neg in H1.
          split; [lra | apply never_negative_true; assumption].
  Qed.
End Sum.

(* A test of such sums that proves something of them. *)
Definition proves (test : sum_test) (says : R -> Prop) : Prop := forall m px py x0 y0 (gam n : R -> R),
  IZR x0 = eval px 0 -> IZR y0 = eval py 0 -> (forall w, 0 <= w -> 0 < gam w) -> (forall w, 0 <= w -> 0 < n w) ->
  (forall w, 0 <= w -> eval px w * eval px w - gam w * (eval py w * eval py w) = n w * eval m w) ->
  forall z, 0 <= z -> test m (fun _ => x0) (fun _ => y0) (fun _ => px) (fun _ => py) = true -> says (eval px z + sqrt (gam z) * eval py z).

Lemma sum_not_positive_proves : proves sum_not_positive (fun x => x <= 0).
Proof.
  intros m px py x0 y0 gam n X Y G N Pr z Hz H.
  assert (Q : 0 <= eval (neg px) z + sqrt (gam z) * eval (neg py) z); [|rewrite !eval_neg in Q; lra].
  apply (sum_not_negative_true m (neg px) (neg py) (- x0)%Z (- y0)%Z gam n); try assumption.
  - rewrite opp_IZR, eval_neg, X. reflexivity.
  - rewrite opp_IZR, eval_neg, Y. reflexivity.
  - intros w Hw. rewrite !eval_neg, <- Pr by exact Hw. ring.
Qed.

(* The circle (i,j,k). *)
Section There.
  Variables i j k : moving.
  Hypothesis i_disk : mwall i = false.
  Hypothesis there : circle_there (mwall j) (mwall k) (prow i j) (prow i k) (zrow i j) (zrow i k) = true.

  Lemma there_parts z : 0 <= z ->
    mwall j && mwall k = false /\
    right (mwall j) (rp (seen_from (at_z i z) (at_z j z))) /\ right (mwall k) (rp (seen_from (at_z i z) (at_z k z))) /\
    right (mwall j || mwall k) (r_tangency (seen_from (at_z i z) (at_z j z)) (seen_from (at_z i z) (at_z k z))).
  Proof.
    intros Hz. unfold circle_there in there. repeat (apply andb_prop in there as [there ?]).
    rewrite <- !prow_at, <- at_tangency.
    repeat split; [apply negb_true_iff; assumption|..]; (apply has_right_sign_true; [exact Hz|assumption]).
  Qed.

  Lemma there_gamma z : 0 <= z -> 0 < gamma (seen_from (at_z i z) (at_z j z)) (seen_from (at_z i z) (at_z k z)).
  Proof.
    intros Hz. destruct (there_parts z Hz) as (H1 & H2 & H3 & H4). apply gamma_positive; assumption.
  Qed.

  Lemma there_norm z : 0 <= z -> 0 < norm (seen_from (at_z i z) (at_z j z)) (seen_from (at_z i z) (at_z k z)).
  Proof. intros Hz. apply norm_positive. exact (there_gamma z Hz). Qed.

  Lemma there_true z : 0 <= z -> 0 < existence (at_z i z) (at_z j z) (at_z k z).
  Proof.
    intros Hz. pose proof there as T. unfold circle_there in T. apply andb_prop in T as [_ T].
    unfold existence.
    replace (r_u (seen_from (at_z i z) (at_z j z)) (seen_from (at_z i z) (at_z k z))) with (eval (p_u (prow i j) (prow i k)) z)
      by (rewrite at_u, !prow_at; reflexivity).
    replace (sign_of (wall (at_z j z) || wall (at_z k z)) * r_dxy (seen_from (at_z i z) (at_z j z)) (seen_from (at_z i z) (at_z k z)))
      with (eval (poly_sign (mwall j || mwall k) (p_dxy (prow i j) (prow i k))) z)
      by (rewrite eval_poly_sign, at_dxy, !prow_at; reflexivity).
    apply (sum_positive_true _ _ _ _ _
      (fun w => gamma (seen_from (at_z i w) (at_z j w)) (seen_from (at_z i w) (at_z k w)))
      (fun w => norm (seen_from (at_z i w) (at_z j w)) (seen_from (at_z i w) (at_z k w)))
      ) with (7 := T); try assumption.
    - rewrite int_u, at_u, !zrow_at, !prow_at. reflexivity.
    - rewrite with_sign_is, eval_poly_sign, int_dxy, at_dxy, !zrow_at, !prow_at. reflexivity.
    - exact there_gamma.
    - exact there_norm.
    - intros w Hw. rewrite eval_poly_sign, at_u, at_dxy, at_m, !prow_at.
      pose proof (sign_square (mwall j || mwall k)) as S.
      rewrite <- existence_product by (apply gamma_is).
      match goal with |- _ - ?g * (?s * ?d * (?s * ?d)) = _ => replace (g * (s * d * (s * d))) with (s * s * (g * (d * d))) by ring end.
      rewrite S. ring.
  Qed.
End There.

(* The in-circle function of e as a sum of polynomials. *)
Section Incircle.
  Variables i j k e : moving.
  Hypothesis i_disk : mwall i = false.
  Hypothesis there : circle_there (mwall j) (mwall k) (prow i j) (prow i k) (zrow i j) (zrow i k) = true.
  Let first := poly_sign (mwall e) (p_g (prow i j) (prow i k) (p_a (prow i j) (prow i k) (prow i e)) (p_b (prow i j) (prow i k) (prow i e))).
  Let second := poly_sign (xorb (mwall e) (mwall j || mwall k)) (p_c (prow i j) (prow i k) (prow i e)).
  Let gam w := gamma (seen_from (at_z i w) (at_z j w)) (seen_from (at_z i w) (at_z k w)).

  Lemma incircle_is z : incircle (at_z i z) (at_z j z) (at_z k z) (at_z e z) = eval first z + sqrt (gam z) * eval second z.
  Proof.
    unfold incircle, first, second, gam. rewrite !eval_poly_sign, sign_xor, at_g, at_a, at_b, at_c, !prow_at. simpl. ring.
  Qed.

  Lemma incircle_norm w : 0 <= w -> eval first w * eval first w - gam w * (eval second w * eval second w) =
    norm (seen_from (at_z i w) (at_z j w)) (seen_from (at_z i w) (at_z k w)) *
    eval (p_f (p_a (prow i j) (prow i k) (prow i e)) (p_b (prow i j) (prow i k) (prow i e)) (p_c (prow i j) (prow i k) (prow i e))) w.
  Proof.
    intros _. unfold first, second, gam. rewrite !eval_poly_sign, at_f, at_g, at_a, at_b, at_c, !prow_at.
    rewrite <- incircle_product by (apply gamma_is).
    match goal with |- ?s * ?g * (?s * ?g) - ?m * (?t * ?c * (?t * ?c)) = _ =>
      replace (s * g * (s * g) - m * (t * c * (t * c))) with (s * s * (g * g) - t * t * (m * (c * c))) by ring end.
    rewrite !sign_square. ring.
  Qed.
End Incircle.

(* The forms a, b, c do not change when their rows are turned round. *)
Lemma turned_forms (a b c : row R) : r_a b c a = r_a a b c /\ r_b b c a = r_b a b c /\ r_c b c a = r_c a b c.
Proof.
  unfold form_a, form_b, form_c, dsp, dxp, dyp, dxs, dys, dxy. repeat split; ring.
Qed.

Lemma proper_at g z : 0 <= z -> is_proper g = true -> proper (at_z g z).
Proof.
  intros Hz H. unfold proper, is_proper in *. simpl. destruct (mwall g).
  - apply Z.ltb_lt, IZR_lt in H. replace ((1 + z) * IZR (mr g)) with (- ((1 + z) * - IZR (mr g))) by ring.
    assert (0 < (1 + z) * - IZR (mr g)) by (apply Rmult_lt_0_compat; lra). lra.
  - apply Z.leb_le, IZR_le in H. apply Rmult_le_pos; lra.
Qed.

Section Fan.
  Variables i a b c : moving.
  Hypothesis there : fan_there i a b c = true.

  Lemma fan_parts : mwall i = false /\ is_proper i = true /\ is_proper a = true /\ is_proper b = true /\ is_proper c = true /\
    circle_there (mwall a) (mwall b) (prow i a) (prow i b) (zrow i a) (zrow i b) = true /\
    circle_there (mwall b) (mwall c) (prow i b) (prow i c) (zrow i b) (zrow i c) = true.
  Proof.
    unfold fan_there in there. repeat (apply andb_prop in there as [there ?]). apply negb_true_iff in there. tauto.
  Qed.

  (* What signs of the in-circle functions say. *)
  Lemma fan_circles z : 0 <= z ->
    (exists k, vertex_circle k (at_z i z) (at_z a z) (at_z b z) /\
      (0 <= incircle (at_z i z) (at_z a z) (at_z b z) (at_z c z) -> empty_of k (at_z c z)) /\
      (incircle (at_z i z) (at_z a z) (at_z b z) (at_z c z) = 0 -> touches k (at_z c z)) /\
      (incircle (at_z i z) (at_z a z) (at_z b z) (at_z c z) < 0 -> ~ empty_of k (at_z c z)) /\
      (0 < incircle (at_z i z) (at_z a z) (at_z b z) (at_z c z) -> ~ touches k (at_z c z))) /\
    (exists k, vertex_circle k (at_z i z) (at_z b z) (at_z c z) /\
      (0 <= incircle (at_z i z) (at_z b z) (at_z c z) (at_z a z) -> empty_of k (at_z a z)) /\
      (incircle (at_z i z) (at_z b z) (at_z c z) (at_z a z) = 0 -> touches k (at_z a z)) /\
      (incircle (at_z i z) (at_z b z) (at_z c z) (at_z a z) < 0 -> ~ empty_of k (at_z a z)) /\
      (0 < incircle (at_z i z) (at_z b z) (at_z c z) (at_z a z) -> ~ touches k (at_z a z))).
  Proof.
    intros Hz. destruct fan_parts as (Hi & Pi & Pa & Pb & Pc & C1 & C2).
    destruct (there_parts _ _ _ C1 z Hz) as (W1 & Ra & Rb & Rab).
    destruct (there_parts _ _ _ C2 z Hz) as (W2 & _ & Rc & Rbc).
    split.
    - destruct (vertex_exists (at_z i z) (at_z a z) (at_z b z) Hi W1 Ra Rb Rab (there_true _ _ _ C1 z Hz)) as (k & V & E).
      destruct (E (at_z c z) (proper_at _ _ Hz Pc) (proper_at _ _ Hz Pi) (or_introl Rc)) as (E1 & E2 & E3 & E4).
      exists k. repeat split; try tauto; apply V.
    - destruct (vertex_exists (at_z i z) (at_z b z) (at_z c z) Hi W2 Rb Rc Rbc (there_true _ _ _ C2 z Hz)) as (k & V & E).
      destruct (E (at_z a z) (proper_at _ _ Hz Pa) (proper_at _ _ Hz Pi) (or_introl Ra)) as (E1 & E2 & E3 & E4).
      exists k. repeat split; try tauto; apply V.
  Qed.

  Lemma fan_stands z : 0 <= z -> stands (at_z i z) (at_z b z) (at_z a z) (at_z c z).
  Proof.
    intros Hz. destruct (fan_circles z Hz) as [(k & V & _) (k' & V' & _)].
    destruct fan_parts as (Hi & _ & _ & _ & _ & C1 & C2).
    destruct (there_parts _ _ _ C1 z Hz) as (_ & Ra & Rb & Rab). destruct (there_parts _ _ _ C2 z Hz) as (_ & _ & Rc & Rbc).
    assert (Row : forall g, right (mwall g) (rp (seen_from (at_z i z) (at_z g z))) -> right_pair (at_z i z) (at_z g z)).
    { intros g R. unfold right_pair. simpl (wall _). rewrite Hi. unfold right in R. simpl in R. unfold row_of in R. simpl in R. simpl orb. destruct (mwall g); simpl; lra. }
    assert (Two : forall g h, right (mwall g || mwall h) (r_tangency (seen_from (at_z i z) (at_z g z)) (seen_from (at_z i z) (at_z h z))) -> right_pair (at_z g z) (at_z h z)).
    { intros g h R. unfold right_pair. simpl (wall _). unfold right, tangency in R. simpl in R. destruct (mwall g || mwall h); simpl; lra. }
    split; [split; [exists k|exists k']; auto|]. repeat split; [apply Row, Rb|apply Row, Ra|apply Row, Rc|apply right_turn, Two, Rab|apply Two, Rbc].
  Qed.

  Lemma second_product w : 0 <= w ->
    eval (p_f (p_a (prow i b) (prow i c) (prow i a)) (p_b (prow i b) (prow i c) (prow i a)) (p_c (prow i b) (prow i c) (prow i a))) w =
    eval (p_f (p_a (prow i a) (prow i b) (prow i c)) (p_b (prow i a) (prow i b) (prow i c)) (p_c (prow i a) (prow i b) (prow i c))) w.
  Proof.
    intros _. rewrite !at_f, !at_a, !at_b, !at_c, !prow_at.
    destruct (turned_forms (seen_from (at_z i w) (at_z a w)) (seen_from (at_z i w) (at_z b w)) (seen_from (at_z i w) (at_z c w)))
      as (-> & -> & ->). reflexivity.
  Qed.

  Lemma fan_sums_true test says both z : proves test says -> 0 <= z -> fan_sums test both i a b c = true ->
    let first := says (incircle (at_z i z) (at_z a z) (at_z b z) (at_z c z)) in
    let second := says (incircle (at_z i z) (at_z b z) (at_z c z) (at_z a z)) in
    if both then first /\ second else first \/ second.
  Proof.
    intros Sound Hz H first second. destruct fan_parts as (Hi & Pi & Pa & Pb & Pc & C1 & C2).
    unfold fan_sums in H. cbv zeta in H. match type of H with (if eqb ?t _ then ?u else _) = _ =>
      assert (H1 : t = true -> first); [|assert (H2 : u = true -> second)] end.
    - intros T. unfold first. rewrite incircle_is.
      apply (Sound _ _ _ _ _ (fun z => gamma (seen_from (at_z i z) (at_z a z)) (seen_from (at_z i z) (at_z b z)))
         (fun w => norm (seen_from (at_z i w) (at_z a w)) (seen_from (at_z i w) (at_z b w)))) with (7 := T); try assumption.
      + rewrite with_sign_is, eval_poly_sign, int_g, int_a, int_b, at_g, at_a, at_b, !zrow_at, !prow_at. reflexivity.
      + rewrite with_sign_is, eval_poly_sign, int_c, at_c, !zrow_at, !prow_at. reflexivity.
      + apply there_gamma; assumption.
      + apply there_norm; assumption.
      + apply incircle_norm.
    - intros T. unfold second.
      assert (X : incircle (at_z i z) (at_z b z) (at_z c z) (at_z a z) =
        eval (poly_sign (mwall a) (p_g (prow i b) (prow i c) (p_a (prow i a) (prow i b) (prow i c)) (p_b (prow i a) (prow i b) (prow i c)))) z +
        sqrt (gamma (seen_from (at_z i z) (at_z b z)) (seen_from (at_z i z) (at_z c z))) *
        eval (poly_sign (xorb (mwall a) (mwall b || mwall c)) (p_c (prow i a) (prow i b) (prow i c))) z).
      { rewrite incircle_is, !eval_poly_sign, !at_g, !at_a, !at_b, !at_c, !prow_at.
        destruct (turned_forms (seen_from (at_z i z) (at_z a z)) (seen_from (at_z i z) (at_z b z)) (seen_from (at_z i z) (at_z c z)))
          as (-> & -> & ->). reflexivity. }
      rewrite X.
      apply (Sound _ _ _ _ _ (fun z => gamma (seen_from (at_z i z) (at_z b z)) (seen_from (at_z i z) (at_z c z)))
         (fun w => norm (seen_from (at_z i w) (at_z b w)) (seen_from (at_z i w) (at_z c w)))) with (7 := T); try assumption.
      + rewrite with_sign_is, eval_poly_sign, int_g, int_a, int_b, at_g, at_a, at_b, !zrow_at, !prow_at. reflexivity.
      + rewrite with_sign_is, eval_poly_sign, int_c, at_c, !zrow_at, !prow_at. reflexivity.
      + apply there_gamma; assumption.
      + apply there_norm; assumption.
      + intros w Hw. pose proof (incircle_norm i b c a w Hw) as N. rewrite second_product in N by assumption. rewrite <- N.
        rewrite !eval_poly_sign, !at_g, !at_a, !at_b, !at_c, !prow_at.
        destruct (turned_forms (seen_from (at_z i w) (at_z a w)) (seen_from (at_z i w) (at_z b w)) (seen_from (at_z i w) (at_z c w)))
          as (-> & -> & ->). reflexivity.
    - match type of H with (if eqb ?t _ then _ else _) = _ => destruct t eqn:T end; destruct both; simpl in H; try discriminate; auto.
  Qed.

  Lemma fan_empty_true z : 0 <= z -> fan_empty i a b c = true ->
    0 <= incircle (at_z i z) (at_z a z) (at_z b z) (at_z c z) /\ 0 <= incircle (at_z i z) (at_z b z) (at_z c z) (at_z a z).
  Proof. exact (fan_sums_true _ (fun x => 0 <= x) true z (fun m px py x0 y0 gam n => sum_not_negative_true m px py x0 y0 gam n)). Qed.

  Lemma fan_long_true z : 0 <= z -> fan_long i a b c = true ->
    0 < incircle (at_z i z) (at_z a z) (at_z b z) (at_z c z) \/ 0 < incircle (at_z i z) (at_z b z) (at_z c z) (at_z a z).
  Proof. exact (fan_sums_true _ (fun x => 0 < x) false z (fun m px py x0 y0 gam n => sum_positive_true m px py x0 y0 gam n)). Qed.
End Fan.
