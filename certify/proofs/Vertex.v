(* From the signs of the forms to circles: where they are as the program finds them, the vertex has its circle, and the
   fourth generator is outside it, touches it or enters it. *)
From Coq Require Import Reals Lra Bool Psatz.
From Voroproof Require Import Forms Geometry Circle.
Open Scope R_scope.

Definition sign_of (w : bool) : R := if w then -1 else 1.

(* A disk has a radius that is not negative, the container a negative one. *)
Definition proper (g : generator) : Prop := if wall g then radius g < 0 else 0 <= radius g.

(* In-circle of e for the circle that touches i (a disk), j, k: positive where e is outside. *)
Definition incircle (i j k e : generator) : R :=
  let a := seen_from i j in let b := seen_from i k in let c := seen_from i e in
  sign_of (wall e) * (r_g a b (r_a a b c) (r_b a b c) + sqrt (gamma a b) * (sign_of (wall j || wall k) * r_c a b c)).

Definition existence (i j k : generator) : R :=
  let a := seen_from i j in let b := seen_from i k in
  r_u a b + sqrt (gamma a b) * (sign_of (wall j || wall k) * r_dxy a b).

(* One contact: a circle of centre c_i + q n, where n is a unit vector and q > 0. *)
Section Contact.
  Variables nx ny q x y s kappa p : R.
  Hypothesis unit : nx * nx + ny * ny = 1.
  Hypothesis q_pos : 0 < q.
  Hypothesis q_is : 2 * q * kappa = 1.
  Hypothesis p_is : p = x * x + y * y - s * s.
  Let wx := x - q * nx.
  Let wy := y - q * ny.

  Lemma off_square : wx * wx + wy * wy - (q + s) * (q + s) = 2 * q * (p * kappa - (nx * x + ny * y + s)).
  Proof.
    unfold wx, wy. replace (2 * q * (p * kappa - (nx * x + ny * y + s))) with (p * (2 * q * kappa) - 2 * q * (nx * x + ny * y + s)) by ring.
    rewrite q_is, p_is.
    replace ((x - q * nx) * (x - q * nx) + (y - q * ny) * (y - q * ny)) with
      (x * x + y * y - 2 * q * (nx * x + ny * y) + q * q * (nx * nx + ny * ny)) by ring.
    rewrite unit. ring.
  Qed.

  Lemma along : nx * wx + ny * wy <= length wx wy /\ - (nx * wx + ny * wy) <= length wx wy.
  Proof.
    assert (L : length nx ny = 1) by (apply length_of_square; lra).
    pose proof (dot_bound nx ny wx wy) as D1. pose proof (dot_bound (- nx) (- ny) wx wy) as D2.
    assert (L2 : length (- nx) (- ny) = 1) by (apply length_of_square; [lra|transitivity (nx * nx + ny * ny); [ring|lra]]).
    rewrite L in D1. rewrite L2 in D2. split; lra.
  Qed.

  Lemma far_square : x * x + y * y = q * q + 2 * q * (nx * wx + ny * wy) + length wx wy * length wx wy.
  Proof.
    rewrite length_square. unfold wx, wy.
    replace (x * x + y * y) with (q * q * 1 + 2 * q * (nx * (x - q * nx) + ny * (y - q * ny)) +
      ((x - q * nx) * (x - q * nx) + (y - q * ny) * (y - q * ny)) + q * q * ((nx * nx + ny * ny) - 1)) by ring.
    rewrite unit. ring.
  Qed.

  Lemma disk_in_contact : 0 < p -> nx * x + ny * y + s = p * kappa -> 0 < q + s /\ length wx wy = q + s.
  Proof.
    intros Hp E. pose proof off_square as O. rewrite E in O.
    assert (0 < q + s) as Hs.
    { apply Rnot_le_lt. intros H.
      assert (length wx wy = - (q + s)) as L by (apply length_of_square; lra).
      pose proof far_square as F. pose proof along as [A _]. rewrite L in F, A.
      assert (q * (nx * wx + ny * wy) <= q * - (q + s)) by (apply Rmult_le_compat_l; lra). nra. }
    split; [exact Hs|]. apply length_of_square; lra.
  Qed.

  Lemma wall_in_contact : p < 0 -> nx * x + ny * y + s = p * kappa -> q + s < 0 /\ length wx wy = - (q + s).
  Proof.
    intros Hp E. pose proof off_square as O. rewrite E in O.
    assert (q + s < 0) as Hs.
    { apply Rnot_le_lt. intros H.
      assert (length wx wy = q + s) as L by (apply length_of_square; lra).
      pose proof far_square as F. pose proof along as [_ A]. rewrite L in F, A.
      assert (q * - (nx * wx + ny * wy) <= q * (q + s)) by (apply Rmult_le_compat_l; lra). nra. }
    split; [exact Hs|]. apply length_of_square; lra.
  Qed.

  (* z is in-circle up to a positive factor. *)
  Let z := p * kappa - (nx * x + ny * y + s).

  Lemma disk_outside : 0 <= z -> q + s <= length wx wy.
  Proof.
    intros Hz. pose proof off_square as O. fold z in O.
    assert (0 <= q * z) by (apply Rmult_le_pos; lra).
    pose proof (length_square wx wy) as L. pose proof (length_nonneg wx wy). nra.
  Qed.

  Lemma disk_inside : z < 0 -> 0 < p -> length wx wy < q + s.
  Proof.
    intros Hz Hp. pose proof off_square as O. fold z in O.
    assert (0 < q * - z) by (apply Rmult_lt_0_compat; lra).
    pose proof (length_square wx wy) as L. pose proof (length_nonneg wx wy) as L0.
    destruct (Rlt_or_le 0 (q + s)) as [H5|H5]; [nra|exfalso].
    assert (length wx wy < - (q + s)) as H1 by nra.
    pose proof far_square as F. pose proof along as [A _].
    assert (q * (nx * wx + ny * wy) <= q * length wx wy) by (apply Rmult_le_compat_l; lra). nra.
  Qed.

  Lemma wall_outside : z <= 0 -> p < 0 -> s < 0 -> length wx wy <= - (q + s).
  Proof.
    intros Hz Hp Hs. pose proof off_square as O. fold z in O.
    assert (0 <= q * - z) by (apply Rmult_le_pos; lra).
    pose proof (length_square wx wy) as L. pose proof (length_nonneg wx wy) as L0.
    destruct (Rle_or_lt (q + s) 0) as [H5|H5]; [nra|exfalso].
    assert (length wx wy <= q + s) as H1 by nra.
    pose proof far_square as F. pose proof along as [_ A].
    assert (q * - (nx * wx + ny * wy) <= q * length wx wy) by (apply Rmult_le_compat_l; lra). nra.
  Qed.

  Lemma wall_inside : 0 < z -> - (q + s) < length wx wy.
  Proof.
    intros Hz. pose proof off_square as O. fold z in O.
    assert (0 < q * z) by (apply Rmult_lt_0_compat; lra).
    pose proof (length_square wx wy) as L. pose proof (length_nonneg wx wy) as L0. nra.
  Qed.
End Contact.

Section Vertex.
  Variables i j k : generator.
  Hypothesis i_disk : wall i = false.
  Hypothesis one_wall : wall j && wall k = false.
  Let a := seen_from i j.
  Let b := seen_from i k.
  Hypothesis right_j : right (wall j) (rp a).
  Hypothesis right_k : right (wall k) (rp b).
  Hypothesis right_jk : right (wall j || wall k) (r_tangency a b).

  Lemma gamma_positive : 0 < gamma a b.
  Proof.
    unfold gamma. revert right_j right_k right_jk one_wall.
    generalize (rp a) (rp b) (r_tangency a b). intros u v w.
    unfold right. destruct (wall j), (wall k); simpl; intros Hu Hv Hw Ho; try discriminate.
    - assert (0 < - u * v) by (apply Rmult_lt_0_compat; lra). replace (u * v * w) with ((- u * v) * - w) by ring.
      apply Rmult_lt_0_compat; lra.
    - assert (0 < u * - v) by (apply Rmult_lt_0_compat; lra). replace (u * v * w) with ((u * - v) * - w) by ring.
      apply Rmult_lt_0_compat; lra.
    - apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra|lra].
  Qed.

  Hypothesis exists_pos : 0 < existence i j k.
  Let sigma := sign_of (wall j || wall k).

  Theorem vertex_exists : exists c, vertex_circle c i j k /\
    (forall e, proper e -> proper i -> right (wall e) (rp (seen_from i e)) \/ wall e = false ->
       (0 <= incircle i j k e -> empty_of c e) /\
       (incircle i j k e = 0 -> right (wall e) (rp (seen_from i e)) -> touches c e) /\
       (incircle i j k e < 0 -> right (wall e) (rp (seen_from i e)) -> ~ empty_of c e) /\
       (0 < incircle i j k e -> ~ touches c e)).
  Proof.
    pose proof gamma_positive as Hg.
    assert (S1 : sigma * sigma = 1) by (unfold sigma, sign_of; destruct (wall j || wall k); lra).
    set (xj := cx j - cx i) in *. set (yj := cy j - cy i) in *. set (sj := radius j - radius i) in *.
    set (xk := cx k - cx i) in *. set (yk := cy k - cy i) in *. set (sk := radius k - radius i) in *.
    pose proof (first_row xj yj sj xk yk sk sigma Hg) as E1.
    pose proof (second_row xj yj sj xk yk sk sigma Hg) as E2.
    pose proof (n_unit xj yj sj xk yk sk sigma S1 Hg) as U.
    pose proof (turn xj yj sj xk yk sk sigma S1 Hg) as T.
    pose proof (third xj yj sj xk yk sk sigma Hg) as Q.
    pose proof (kappa_positive xj yj sj xk yk sk sigma Hg exists_pos) as K.
    pose proof (norm_positive xj yj sj xk yk sk Hg) as N.
    change (rrow xj yj sj) with a in *. change (rrow xk yk sk) with b in *.
    assert (T0 : 0 < sqrt (gamma a b) * (r_u a b + sqrt (gamma a b) * (sigma * r_dxy a b)) / norm a b).
    { apply Rdiv_lt_0_compat; [|exact N]. apply Rmult_lt_0_compat; [apply sqrt_lt_R0, Hg | exact exists_pos]. }
    rewrite <- T in T0. clear T.
    revert E1 E2 U T0 Q K. generalize (kappa xj yj sj xk yk sk sigma) (ny xj yj sj xk yk sk sigma) (nx xj yj sj xk yk sk sigma).
    intros kap my mx E1 E2 U1 T0 Q K.
    set (q := / (2 * kap)).
    assert (Hq : 0 < q) by (apply Rinv_0_lt_compat; lra).
    assert (Hqk : 2 * q * kap = 1) by (unfold q; field; lra).
    exists (Circle (cx i + q * mx) (cy i + q * my) (q - radius i)).
    (* What a contact with g is. *)
    assert (Contact : forall g, right (wall g) (rp (seen_from i g)) ->
       mx * (cx g - cx i) + my * (cy g - cy i) + (radius g - radius i) = rp (seen_from i g) * kap ->
       0 < sign_of (wall g) * (q + (radius g - radius i)) /\
       length (cx g - cx i - q * mx) (cy g - cy i - q * my) = sign_of (wall g) * (q + (radius g - radius i))).
    { intros g Hr E. unfold right, sign_of in *. destruct (wall g).
      - destruct (wall_in_contact mx my q _ _ _ kap _ U1 Hq Hqk eq_refl Hr E) as [H1 H2]. rewrite H2. split; lra.
      - destruct (disk_in_contact mx my q _ _ _ kap _ U1 Hq Hqk eq_refl Hr E) as [H1 H2]. rewrite H2. split; lra. }
    assert (Flip : forall g, length (cx i + q * mx - cx g) (cy i + q * my - cy g) = length (cx g - cx i - q * mx) (cy g - cy i - q * my)).
    { intros g. unfold length. f_equal. ring. }
    destruct (Contact j right_j E1) as [Pj Lj]. destruct (Contact k right_k E2) as [Pk Lk].
    assert (Li : length (cx i + q * mx - cx i) (cy i + q * my - cy i) = q).
    { apply length_of_square; [lra|]. replace (_ + _) with (q * q * (mx * mx + my * my)) by ring. rewrite U1. ring. }
    split; [unfold vertex_circle; repeat split|].
    - unfold touches, distance; simpl. rewrite i_disk, Li. ring.
    - unfold touches, distance; simpl. rewrite Flip, Lj. unfold sign_of. destruct (wall j); lra.
    - unfold touches, distance; simpl. rewrite Flip, Lk. unfold sign_of. destruct (wall k); lra.
    - unfold counterclockwise.
      assert (Cg : forall g, 0 < sign_of (wall g) * (q + (radius g - radius i)) ->
        length (cx g - cx i - q * mx) (cy g - cy i - q * my) = sign_of (wall g) * (q + (radius g - radius i)) ->
        contact_x (Circle (cx i + q * mx) (cy i + q * my) (q - radius i)) g = (cx g - cx i - q * mx) / (q + (radius g - radius i)) /\
        contact_y (Circle (cx i + q * mx) (cy i + q * my) (q - radius i)) g = (cy g - cy i - q * my) / (q + (radius g - radius i))).
      { intros g P L. unfold contact_x, contact_y; simpl.
        replace (cx g - (cx i + q * mx)) with (cx g - cx i - q * mx) by ring.
        replace (cy g - (cy i + q * my)) with (cy g - cy i - q * my) by ring.
        rewrite L. unfold sign_of in *. destruct (wall g); split; field; lra. }
      assert (Ci : contact_x (Circle (cx i + q * mx) (cy i + q * my) (q - radius i)) i = - mx /\
                   contact_y (Circle (cx i + q * mx) (cy i + q * my) (q - radius i)) i = - my).
      { assert (P : 0 < sign_of (wall i) * (q + (radius i - radius i))) by (rewrite i_disk; simpl; lra).
        assert (L : length (cx i - cx i - q * mx) (cy i - cy i - q * my) = sign_of (wall i) * (q + (radius i - radius i))).
        { rewrite <- Flip, Li, i_disk. simpl. ring. }
        destruct (Cg i P L) as [H1 H2]. rewrite H1, H2. split; field; lra. }
      destruct (Cg j Pj Lj) as [Jx Jy]. destruct (Cg k Pk Lk) as [Kx Ky]. destruct Ci as [Ix Iy].
      rewrite Ix, Iy, Jx, Jy, Kx, Ky. fold xj yj sj xk yk sk.
      assert (Dj : q + sj <> 0) by (fold sj in Pj; intros H; rewrite H in Pj; lra).
      assert (Dk : q + sk <> 0) by (fold sk in Pk; intros H; rewrite H in Pk; lra).
      fold sj in Pj. fold sk in Pk.
      replace (((xj - q * mx) / (q + sj) - - mx) * ((yk - q * my) / (q + sk) - - my) -
               ((yj - q * my) / (q + sj) - - my) * ((xk - q * mx) / (q + sk) - - mx)) with
        (((xj + sj * mx) * (yk + sk * my) - (yj + sj * my) * (xk + sk * mx)) / ((q + sj) * (q + sk))) by (field; split; assumption).
      revert T0 Pj Pk. generalize ((xj + sj * mx) * (yk + sk * my) - (yj + sj * my) * (xk + sk * mx)). intros D.
      unfold sigma. revert one_wall. unfold sign_of. destruct (wall j), (wall k); simpl; intros O T0 Pj Pk; try discriminate.
      + replace (D / ((q + sj) * (q + sk))) with ((-1 * D) / ((-1 * (q + sj)) * (1 * (q + sk)))) by (field; split; assumption).
        apply Rdiv_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; lra.
      + replace (D / ((q + sj) * (q + sk))) with ((-1 * D) / ((1 * (q + sj)) * (-1 * (q + sk)))) by (field; split; assumption).
        apply Rdiv_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; lra.
      + apply Rdiv_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; lra.
    - intros e He Hi Hr. specialize (Q (seen_from i e)).
      fold sigma in Q. unfold incircle. fold a b sigma.
      revert Q. generalize (r_g a b (r_a a b (seen_from i e)) (r_b a b (seen_from i e)) + sqrt (gamma a b) * (sigma * r_c a b (seen_from i e))).
      intros g Q.
      set (z := rp (seen_from i e) * kap - (mx * (cx e - cx i) + my * (cy e - cy i) + (radius e - radius i))).
      assert (Z : g = norm a b * z).
      { unfold z. simpl in Q. simpl. lra. }
      assert (Zp : 0 <= g -> 0 <= z) by (intros; rewrite Z in *; apply Rnot_lt_le; intros HH; assert (0 < norm a b * - z) by (apply Rmult_lt_0_compat; lra); lra).
      assert (Zn : g <= 0 -> z <= 0) by (intros; rewrite Z in *; apply Rnot_lt_le; intros HH; assert (0 < norm a b * z) by (apply Rmult_lt_0_compat; lra); lra).
      assert (Zs : g < 0 -> z < 0) by (intros; destruct Zn as [|E]; [lra|assumption|rewrite E in Z; lra]).
      assert (Zt : 0 < g -> 0 < z) by (intros; destruct Zp as [|E]; [lra|assumption|rewrite <- E in Z; lra]).
      assert (Apart : forall d, g <> 0 -> length (cx e - cx i - q * mx) (cy e - cy i - q * my) = d ->
        d * d = (q + (radius e - radius i)) * (q + (radius e - radius i)) -> False).
      { intros d Hg0 L D. pose proof (off_square mx my q (cx e - cx i) (cy e - cy i) (radius e - radius i) kap (rp (seen_from i e)) U1 Hqk eq_refl) as O.
        fold z in O. rewrite <- length_square, L, D in O. apply Hg0. rewrite Z.
        assert (z = 0) as ->; [|ring]. apply (Rmult_eq_reg_l (2 * q)); lra. }
      unfold empty_of, touches, distance; simpl. rewrite Flip.
      unfold right, proper, sign_of in *. rewrite i_disk in Hi. destruct (wall e) eqn:EW.
      + destruct Hr as [Hr|]; [|discriminate].
        assert (We : 0 <= -1 * g -> length (cx e - cx i - q * mx) (cy e - cy i - q * my) <= - (q + (radius e - radius i))).
        { intros H. apply (wall_outside mx my q _ _ _ kap _ U1 Hq Hqk eq_refl); [apply Zn; lra | exact Hr | lra]. }
        split; [|split; [|split]].
        * intros H. specialize (We H). lra.
        * intros H Hp. assert (z = 0) as Z0 by (apply Rle_antisym; [apply Zn; lra | apply Zp; lra]).
          destruct (Contact e) as [_ L]; [rewrite EW; exact Hp | unfold z in Z0; lra |]. rewrite L. rewrite EW; simpl; lra.
        * intros H _ H1. pose proof (wall_inside mx my q (cx e - cx i) (cy e - cy i) (radius e - radius i) kap (rp (seen_from i e)) U1 Hq Hqk eq_refl) as W.
          specialize (W (Zt ltac:(lra))). lra.
        * intros H H1. assert (L : length (cx e - cx i - q * mx) (cy e - cy i - q * my) = - (q + (radius e - radius i))) by lra.
          apply (Apart (- (q + (radius e - radius i)))); [lra|exact L|ring].
      + assert (We : 0 <= 1 * g -> q + (radius e - radius i) <= length (cx e - cx i - q * mx) (cy e - cy i - q * my)).
        { intros H. apply (disk_outside mx my q _ _ _ kap _ U1 Hq Hqk eq_refl). apply Zp; lra. }
        split; [|split; [|split]].
        * intros H. specialize (We H). lra.
        * intros H Hp. assert (z = 0) as Z0 by (apply Rle_antisym; [apply Zn; lra | apply Zp; lra]).
          destruct (Contact e) as [_ L]; [rewrite EW; exact Hp | unfold z in Z0; lra |]. rewrite L. rewrite EW; simpl; lra.
        * intros H Hp H1. pose proof (disk_inside mx my q (cx e - cx i) (cy e - cy i) (radius e - radius i) kap (rp (seen_from i e)) U1 Hq Hqk eq_refl) as W.
          specialize (W (Zs ltac:(lra)) Hp). lra.
        * intros H H1. assert (L : length (cx e - cx i - q * mx) (cy e - cy i - q * my) = q + (radius e - radius i)) by lra.
          apply (Apart (q + (radius e - radius i))); [lra|exact L|ring].
  Qed.
End Vertex.
