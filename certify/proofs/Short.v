(* The test of an instant at which an edge has no length. *)
From Coq Require Import ZArith List Bool Reals Lra.
From Voroproof Require Import Forms Polynomial Geometry Circle Vertex Scale Piece PieceSound EdgeSound History Arc Cover Spread Cyclic Envelope Link.
Import ListNotations.
Open Scope R_scope.

(* Three generators seen from l: the direction of the vertex [l,j,k] by the minors of two rows, and how the slopes of k and of another
   generator differ there. *)
Section Direction.
  Variables l j k e : generator.
  Let a := seen_from l j.
  Let b := seen_from l k.
  Let c := seen_from l e.
  Variable sigma : R.
  Let root := sqrt (gamma a b).
  Hypothesis sigma_unit : sigma * sigma = 1.
  Hypothesis sigma_is : 0 < sigma * (rp a * rp b).
  Hypothesis gamma_pos : 0 < gamma a b.

  Lemma dir_is : 0 < Circle.norm a b /\ dir l j k =
    Vec ((- r_dsp a b * r_dxp a b - sigma * root * r_dyp a b) / Circle.norm a b) ((- r_dsp a b * r_dyp a b + sigma * root * r_dxp a b) / Circle.norm a b).
  Proof.
    assert (G : gamma a b = Circle.norm a b - r_dsp a b * r_dsp a b) by apply gamma_is.
    assert (Q : root * root = gamma a b) by (apply sqrt_sqrt; lra). assert (Rt : 0 < root) by (apply sqrt_lt_R0, gamma_pos).
    assert (N : 0 < Circle.norm a b) by (pose proof (sq (r_dsp a b)); lra). split; [exact N|]. rewrite G in Q.
    assert (Nj : rp a <> 0) by (intros Z; rewrite Z in sigma_is; lra). assert (Nk : rp b <> 0) by (intros Z; rewrite Z in sigma_is; lra).
    symmetry. apply up_only.
    - revert Q N. unfold unit, Circle.norm; simpl. generalize (r_dxp a b) (r_dyp a b) (r_dsp a b). intros X Y S Q N.
      replace ((- S * X - sigma * root * Y) / (X * X + Y * Y) * ((- S * X - sigma * root * Y) / (X * X + Y * Y)) +
        (- S * Y + sigma * root * X) / (X * X + Y * Y) * ((- S * Y + sigma * root * X) / (X * X + Y * Y))) with
        ((S * S + sigma * sigma * (root * root)) / (X * X + Y * Y)) by (field; lra).
      rewrite sigma_unit, Q. field. lra.
    - transitivity (- (r_dxp a b * ((- r_dsp a b * r_dxp a b - sigma * root * r_dyp a b) / Circle.norm a b) +
        r_dyp a b * ((- r_dsp a b * r_dyp a b + sigma * root * r_dxp a b) / Circle.norm a b) + r_dsp a b) / (rp a * rp b)).
      + change (rp a) with (tang (seen_at l j)) in *. change (rp b) with (tang (seen_at l k)) in *.
        unfold at_, dot, diff, minus, Kg, K; cbn [fa fb vx vy].
        generalize ((- r_dsp a b * r_dxp a b - sigma * root * r_dyp a b) / Circle.norm a b) ((- r_dsp a b * r_dyp a b + sigma * root * r_dxp a b) / Circle.norm a b). intros u v.
        unfold dxp, dyp, dsp. change (rp a) with (tang (seen_at l j)). change (rp b) with (tang (seen_at l k)). revert Nj Nk.
        generalize (tang (seen_at l j)) (tang (seen_at l k)). intros p q Nj Nk. unfold a, b, seen_from, seen_at, row_of; simpl. field. split; assumption.
      + revert N. unfold Circle.norm. generalize (r_dxp a b) (r_dyp a b) (r_dsp a b). intros X Y S N. field. repeat split; try assumption; lra.
    - assert (E : slope (diff (Kg l k) (Kg l j)) (Vec ((- r_dsp a b * r_dxp a b - sigma * root * r_dyp a b) / Circle.norm a b)
        ((- r_dsp a b * r_dyp a b + sigma * root * r_dxp a b) / Circle.norm a b)) = root / (sigma * (rp a * rp b))).
      { transitivity ((r_dxp a b * ((- r_dsp a b * r_dyp a b + sigma * root * r_dxp a b) / Circle.norm a b) -
          r_dyp a b * ((- r_dsp a b * r_dxp a b - sigma * root * r_dyp a b) / Circle.norm a b)) / (rp a * rp b)).
        - change (rp a) with (tang (seen_at l j)) in *. change (rp b) with (tang (seen_at l k)) in *.
          unfold slope, dot, diff, minus, Arc.turn, Kg, K; cbn [fa fb vx vy].
          generalize ((- r_dsp a b * r_dxp a b - sigma * root * r_dyp a b) / Circle.norm a b) ((- r_dsp a b * r_dyp a b + sigma * root * r_dxp a b) / Circle.norm a b). intros u v.
          unfold dxp, dyp, dsp. change (rp a) with (tang (seen_at l j)). change (rp b) with (tang (seen_at l k)). revert Nj Nk.
          generalize (tang (seen_at l j)) (tang (seen_at l k)). intros p q Nj Nk. unfold a, b, seen_from, seen_at, row_of; simpl. field. split; assumption.
        - assert (Ns : sigma <> 0) by (intros Z; rewrite Z in sigma_unit; lra).
          replace (root / (sigma * (rp a * rp b))) with (sigma * sigma * root / (sigma * (rp a * rp b))) by (rewrite sigma_unit, Rmult_1_l; reflexivity).
          revert N. unfold Circle.norm. generalize (r_dxp a b) (r_dyp a b) (r_dsp a b). intros X Y S N. field. repeat split; try assumption; lra. }
      rewrite E. apply Rdiv_lt_0_compat; assumption.
  Qed.

  Lemma slopes_are : rp b <> 0 -> rp c <> 0 ->
    Circle.norm a b * (rp b * rp c) * (slope (Kg l e) (dir l j k) - slope (Kg l k) (dir l j k)) =
    - r_dsp a b * (r_dxp b c * r_dyp a b - r_dyp b c * r_dxp a b) + root * (sigma * (r_dxp b c * r_dxp a b + r_dyp b c * r_dyp a b)).
  Proof.
    intros Nk Ne. destruct dir_is as [N ->].
    transitivity (Circle.norm a b * (r_dxp b c * ((- r_dsp a b * r_dyp a b + sigma * root * r_dxp a b) / Circle.norm a b) -
      r_dyp b c * ((- r_dsp a b * r_dxp a b - sigma * root * r_dyp a b) / Circle.norm a b))).
    - rewrite (Rmult_assoc (Circle.norm a b)). f_equal.
      unfold slope, dot, Arc.turn, Kg, K; cbn [fa fb vx vy].
      generalize ((- r_dsp a b * r_dxp a b - sigma * root * r_dyp a b) / Circle.norm a b) ((- r_dsp a b * r_dyp a b + sigma * root * r_dxp a b) / Circle.norm a b). intros u v.
      change (rp b) with (tang (seen_at l k)) in *. change (rp c) with (tang (seen_at l e)) in *.
      unfold dxp, dyp. change (rp b) with (tang (seen_at l k)). change (rp c) with (tang (seen_at l e)). revert Nk Ne.
      generalize (tang (seen_at l k)) (tang (seen_at l e)). intros p q Nk Ne. unfold b, c, seen_from, seen_at, row_of; simpl. field. split; assumption.
    - generalize (r_dxp b c) (r_dyp b c) (r_dxp a b) (r_dyp a b) (r_dsp a b). revert N. generalize (Circle.norm a b). intros n N X' Y' X Y S. field. lra.
  Qed.
End Direction.

Definition int_tangency := map_tangency Z.add Z.sub Z.mul Rplus Rminus Rmult IZR plus_IZR minus_IZR mult_IZR.
Lemma int_dxp (j k : row Z) : IZR (dxp Z.sub Z.mul j k) = r_dxp (row_map IZR j) (row_map IZR k).
Proof. unfold dxp, row_map; simpl. rewrite minus_IZR, !mult_IZR. reflexivity. Qed.
Lemma int_dyp (j k : row Z) : IZR (dyp Z.sub Z.mul j k) = r_dyp (row_map IZR j) (row_map IZR k).
Proof. unfold dyp, row_map; simpl. rewrite minus_IZR, !mult_IZR. reflexivity. Qed.
Lemma int_dsp (j k : row Z) : IZR (dsp Z.sub Z.mul j k) = r_dsp (row_map IZR j) (row_map IZR k).
Proof. unfold dsp, row_map; simpl. rewrite minus_IZR, !mult_IZR. reflexivity. Qed.
Lemma int_gamma (j k : row Z) : IZR (rp j * rp k * tangency Z.add Z.sub Z.mul j k) = gamma (row_map IZR j) (row_map IZR k).
Proof. rewrite !mult_IZR, int_tangency. reflexivity. Qed.

(* The sign of a product of tangencies of a disk with two others, of which one at most is the container. *)
Lemma right_product v w p q : v && w = false -> right v p -> right w q -> 0 < sign_of (v || w) * (p * q).
Proof.
  unfold right, sign_of. destruct v, w; simpl; intros O P Q; try discriminate.
  - replace (-1 * (p * q)) with (- p * q) by ring. apply Rmult_lt_0_compat; lra.
  - replace (-1 * (p * q)) with (p * - q) by ring. apply Rmult_lt_0_compat; lra.
  - rewrite Rmult_1_l. apply Rmult_lt_0_compat; lra.
Qed.

Lemma fan_short_slopes i a b c : fan_there i a b c = true -> fan_short i a b c = true ->
  slope (Kg (at_z i 0) (at_z b 0)) (dir (at_z i 0) (at_z a 0) (at_z b 0)) < slope (Kg (at_z i 0) (at_z c 0)) (dir (at_z i 0) (at_z a 0) (at_z b 0)).
Proof.
  intros There H. destruct (fan_parts _ _ _ _ There) as (Hi & _ & _ & _ & _ & C1 & C2).
  destruct (there_parts _ _ _ C1 0 (Rle_refl 0)) as (W1 & Ra & Rb & _). destruct (there_parts _ _ _ C2 0 (Rle_refl 0)) as (W2 & _ & Rc & _).
  pose proof (there_gamma _ _ _ C1 0 (Rle_refl 0)) as G.
  pose proof (right_product _ _ _ _ W1 Ra Rb) as S1. pose proof (right_product _ _ _ _ W2 Rb Rc) as S2.
  assert (Nb : rp (seen_from (at_z i 0) (at_z b 0)) <> 0) by (intros Z; rewrite Z in S2; lra).
  assert (Nc : rp (seen_from (at_z i 0) (at_z c 0)) <> 0) by (intros Z; rewrite Z in S2; lra).
  destruct (dir_is (at_z i 0) (at_z a 0) (at_z b 0) _ (sign_square _) S1 G) as [N _].
  pose proof (slopes_are (at_z i 0) (at_z a 0) (at_z b 0) (at_z c 0) _ (sign_square _) S1 G Nb Nc) as E.
  unfold fan_short in H. cbv zeta in H.
  match type of H with sum_positive_at ?f ?x ?y = true =>
    assert (P : 0 < IZR x + sqrt (gamma (seen_from (at_z i 0) (at_z a 0)) (seen_from (at_z i 0) (at_z b 0))) * IZR y) end.
  { apply (sum_positive_at_true _ _ _ 1 _ (sqrt_lt_R0 _ G) Rlt_0_1) with (2 := H).
    rewrite sqrt_sqrt by lra. rewrite !with_sign_is, minus_IZR, (mult_IZR (rp _ * rp _ * _)), int_gamma, !zrow_at, sign_xor.
    rewrite (mult_IZR (- _ * _) (- _ * _)), (mult_IZR (_ + _) (_ + _)).
    match goal with |- ?s * ?x * (?s * ?x) - ?g * (?s * ?t * ?y * (?s * ?t * ?y)) = _ =>
      replace (s * x * (s * x) - g * (s * t * y * (s * t * y))) with (s * s * (x * x) - s * s * (t * t) * (g * (y * y))) by ring end.
    rewrite !sign_square. ring. }
  rewrite !with_sign_is, sign_xor, plus_IZR, !mult_IZR, minus_IZR, !mult_IZR, opp_IZR, !int_dxp, !int_dyp, !int_dsp, !zrow_at in P.
  revert E P S2 N.
  generalize (slope (Kg (at_z i 0) (at_z b 0)) (dir (at_z i 0) (at_z a 0) (at_z b 0))) (slope (Kg (at_z i 0) (at_z c 0)) (dir (at_z i 0) (at_z a 0) (at_z b 0))).
  intros sb sc E P S2 N. apply Rnot_le_lt. intros L.
  pose proof (Rmult_lt_0_compat _ _ N S2) as M.
  match type of P with 0 < ?p => assert (F : p = Circle.norm (seen_from (at_z i 0) (at_z a 0)) (seen_from (at_z i 0) (at_z b 0)) *
    (sign_of (mwall b || mwall c) * (rp (seen_from (at_z i 0) (at_z b 0)) * rp (seen_from (at_z i 0) (at_z c 0)))) * (sc - sb)) end.
  { transitivity (sign_of (mwall b || mwall c) * (Circle.norm (seen_from (at_z i 0) (at_z a 0)) (seen_from (at_z i 0) (at_z b 0)) *
      (rp (seen_from (at_z i 0) (at_z b 0)) * rp (seen_from (at_z i 0) (at_z c 0))) * (sc - sb))); [rewrite E|]; ring. }
  rewrite F in P. match type of M with 0 < ?m => assert (0 <= m * (sb - sc)) by (apply Rmult_le_pos; lra) end. lra.
Qed.

Lemma fan_short_true i a b c : fan_short_at i a b c = true -> pinched (at_z i 0) (at_z b 0) (at_z a 0) (at_z c 0).
Proof.
  intros H. unfold fan_short_at, fan_tied_at in H. apply andb_prop in H as [T H]. apply andb_prop in T as [There T].
  destruct (fan_tied_true _ _ _ _ There T) as [Q _]. pose proof (fan_short_slopes _ _ _ _ There H) as S.
  destruct (fan_parts _ _ _ _ There) as (Hi & Pi & Pa & Pb & Pc & C1 & C2).
  apply (fun g => proper_at g 0 (Rle_refl 0)) in Pi, Pa, Pb, Pc.
  destruct (there_parts _ _ _ C1 0 (Rle_refl 0)) as (W1 & _). destruct (there_parts _ _ _ C2 0 (Rle_refl 0)) as (W2 & _).
  destruct (fan_stands _ _ _ _ There 0 (Rle_refl 0)) as (_ & Rb & Ra & Rc & Rba & Rbc).
  destruct (fan_circles _ _ _ _ There 0 (Rle_refl 0)) as [(k & V & _ & B & _) (k' & V' & _)].
  assert (start : vertex (at_z i 0) (at_z a 0) (at_z b 0)) by (apply (vertex_of_circle k); try assumption; apply right_turn; assumption).
  assert (last : vertex (at_z i 0) (at_z b 0) (at_z c 0)) by (apply (vertex_of_circle k'); assumption).
  apply no_length_link; try assumption. apply no_length_if; try assumption.
  - apply (circle_and_other k (at_z i 0) (at_z a 0) (at_z b 0) (at_z c 0)); try assumption. apply B, Q.
  - apply Rlt_le, S.
Qed.

Theorem short_true l r s e : by_fan fan_short_at l r s e = true -> pinched (at_z l 0) (at_z r 0) (at_z s 0) (at_z e 0).
Proof.
  unfold by_fan. destruct (mwall l); intros H; [apply pinched_turn|]; apply fan_short_true, H.
Qed.
