(* The circle that touches three generators, by the formulas of design/predicates.md. *)
From Coq Require Import Reals Lra Bool Psatz.
From Voroproof Require Import Forms Geometry.
Open Scope R_scope.

Notation rrow := (row_of Rplus Rminus Rmult).
Notation r_dxy := (dxy Rminus Rmult).
Notation r_dxs := (dxs Rminus Rmult).
Notation r_dys := (dys Rminus Rmult).
Notation r_dxp := (dxp Rminus Rmult).
Notation r_dyp := (dyp Rminus Rmult).
Notation r_dsp := (dsp Rminus Rmult).
Notation r_a := (form_a Rplus Rminus Rmult).
Notation r_b := (form_b Rplus Rminus Rmult).
Notation r_c := (form_c Rplus Rminus Rmult).
Notation r_g := (form_g Rplus Rminus Rmult).
Notation r_f := (form_f Rplus Rminus Rmult).
Notation r_u := (form_u Rplus Rminus Rmult).
Notation r_m := (form_m Rplus Rminus Rmult).
Notation r_tangency := (tangency Rplus Rminus Rmult).

(* The product of the three tangencies of the base and two rows. *)
Definition gamma (j k : row R) : R := rp j * rp k * r_tangency j k.
Definition norm (j k : row R) : R := r_dxp j k * r_dxp j k + r_dyp j k * r_dyp j k.

Definition seen_from (i g : generator) : row R := rrow (cx g - cx i) (cy g - cy i) (radius g - radius i).

Lemma plucker (j k : row R) : r_dxy j k * r_dsp j k - r_dxs j k * r_dyp j k + r_dxp j k * r_dys j k = 0.
Proof. unfold dxy, dsp, dxs, dyp, dxp, dys. ring. Qed.

(* gamma = norm - dsp^2, for rows whose p is their tangency. *)
Lemma gamma_is xj yj sj xk yk sk :
  let j := rrow xj yj sj in let k := rrow xk yk sk in gamma j k = norm j k - r_dsp j k * r_dsp j k.
Proof. simpl. unfold gamma, norm, tangency, dsp, dxp, dyp, row_of; simpl. ring. Qed.

(* The product of in-circle and its conjugate. *)
Lemma incircle_product j k e :
  gamma j k = norm j k - r_dsp j k * r_dsp j k ->
  let a := r_a j k e in let b := r_b j k e in let c := r_c j k e in
  r_g j k a b * r_g j k a b - gamma j k * (c * c) = norm j k * r_f a b c.
Proof.
  intros Hg a b c.
  assert (E : r_dxp j k * b - r_dyp j k * a = - r_dsp j k * c).
  { assert (r_dxp j k * b - r_dyp j k * a + r_dsp j k * c =
            rp e * (r_dxy j k * r_dsp j k - r_dxs j k * r_dyp j k + r_dxp j k * r_dys j k)) as H
      by (unfold a, b, c, form_a, form_b, form_c; ring).
    rewrite plucker in H. lra. }
  rewrite Hg. unfold form_g, form_f, norm.
  generalize dependent c. generalize dependent b. generalize dependent a.
  generalize (r_dxp j k) (r_dyp j k) (r_dsp j k). intros X Y S a b c E.
  assert ((X * a + Y * b) * (X * a + Y * b) = (X * X + Y * Y) * (a * a + b * b) - (X * b - Y * a) * (X * b - Y * a)) as H by ring.
  rewrite H, E. ring.
Qed.

(* The same for existence. *)
Lemma existence_product j k :
  gamma j k = norm j k - r_dsp j k * r_dsp j k ->
  r_u j k * r_u j k - gamma j k * (r_dxy j k * r_dxy j k) = norm j k * r_m j k.
Proof.
  intros Hg. rewrite Hg. unfold form_u, form_m, norm. pose proof (plucker j k) as P. revert P.
  generalize (r_dxp j k) (r_dyp j k) (r_dsp j k) (r_dxs j k) (r_dys j k) (r_dxy j k). intros X Y S U V W P.
  assert (W * S = U * Y - X * V) as E by lra.
  assert ((X * U + Y * V) * (X * U + Y * V) = (X * X + Y * Y) * (U * U + V * V) - (U * Y - X * V) * (U * Y - X * V)) as H by ring.
  rewrite H, <- E. ring.
Qed.

(* The sign of g + root * c, where root^2 = gamma > 0, from the signs of three numbers. *)
Section Sign.
  Variables g c f n q root : R.
  Hypothesis root_pos : 0 < root.
  Hypothesis n_pos : 0 < n.
  Hypothesis product : g * g - root * root * (c * c) = n * f.

  Lemma positive_by_f : (0 < f /\ 0 < g) \/ (f < 0 /\ 0 < c) \/ (0 < g /\ 0 <= c) \/ (0 <= g /\ 0 < c) -> 0 < g + root * c.
  Proof.
    intros [[Hf Hg]|[[Hf Hc]|[[Hg Hc]|[Hg Hc]]]].
    - destruct (Rlt_or_le 0 (g + root * c)) as [|H]; [assumption|exfalso].
      assert (0 < n * f) by (apply Rmult_lt_0_compat; assumption). nra.
    - destruct (Rlt_or_le 0 (g + root * c)) as [|H]; [assumption|exfalso].
      assert (0 < n * - f) by (apply Rmult_lt_0_compat; lra).
      assert (0 < root * c) by (apply Rmult_lt_0_compat; assumption). nra.
    - pose proof (Rmult_le_pos root c). lra.
    - pose proof (Rmult_lt_0_compat root c). lra.
  Qed.

  Lemma not_negative_by_f : (0 <= f /\ 0 <= g) \/ (f <= 0 /\ 0 <= c) \/ (0 <= g /\ 0 <= c) -> 0 <= g + root * c.
  Proof.
    intros [[Hf Hg]|[[Hf Hc]|[Hg Hc]]].
    - destruct (Rle_or_lt 0 (g + root * c)) as [|H]; [assumption|exfalso].
      assert (0 <= n * f) by (apply Rmult_le_pos; lra). nra.
    - destruct (Rle_or_lt 0 (g + root * c)) as [|H]; [assumption|exfalso].
      assert (0 <= n * - f) by (apply Rmult_le_pos; lra).
      assert (0 <= root * c) by (apply Rmult_le_pos; lra). nra.
    - assert (0 <= root * c) by (apply Rmult_le_pos; lra). lra.
  Qed.
End Sign.

(* The tangency of two generators has its right sign: positive for two disks, negative for a disk and the container. *)
Definition right (w : bool) (p : R) : Prop := if w then p < 0 else 0 < p.

Lemma length_nonneg x y : 0 <= length x y.
Proof. apply sqrt_pos. Qed.

Lemma length_square x y : length x y * length x y = x * x + y * y.
Proof. unfold length. apply sqrt_sqrt. nra. Qed.

Lemma length_of_square x y a : 0 <= a -> x * x + y * y = a * a -> length x y = a.
Proof. intros Ha H. unfold length. rewrite H. apply sqrt_square, Ha. Qed.

(* Cauchy's inequality. *)
Lemma dot_bound a b x y : a * x + b * y <= length a b * length x y.
Proof.
  pose proof (length_nonneg a b). pose proof (length_nonneg x y).
  apply Rnot_lt_le. intros H1.
  assert (H2 : 0 <= length a b * length x y) by (apply Rmult_le_pos; assumption).
  assert (H3 : (length a b * length x y) * (length a b * length x y) = (a * a + b * b) * (x * x + y * y))
    by (rewrite <- !length_square; ring).
  assert (H4 : (a * x + b * y) * (a * x + b * y) <= (a * a + b * b) * (x * x + y * y))
    by (pose proof (Rle_0_sqr (a * y - b * x)) as Q; unfold Rsqr in Q; lra).
  nra.
Qed.

Section Circle.
  (* Two rows, the sign that is +1 for two disks and -1 where one is the container. *)
  Variables xj yj sj xk yk sk sigma : R.
  Let j := rrow xj yj sj.
  Let k := rrow xk yk sk.
  Hypothesis sigma_unit : sigma * sigma = 1.
  Hypothesis gamma_pos : 0 < gamma j k.
  Let root := sqrt (gamma j k).
  Let h := r_u j k + root * (sigma * r_dxy j k).
  Hypothesis h_pos : 0 < h.

  Definition nx := (- r_dsp j k * r_dxp j k - sigma * root * r_dyp j k) / norm j k.
  Definition ny := (- r_dsp j k * r_dyp j k + sigma * root * r_dxp j k) / norm j k.
  Definition kappa := h / norm j k.

  Lemma root_square : root * root = gamma j k.
  Proof. apply sqrt_sqrt. lra. Qed.

  Lemma root_positive : 0 < root.
  Proof. apply sqrt_lt_R0, gamma_pos. Qed.

  Lemma norm_positive : 0 < norm j k.
  Proof.
    pose proof (gamma_is xj yj sj xk yk sk) as G. simpl in G. fold j k in G.
    pose proof (Rle_0_sqr (r_dsp j k)) as Q. unfold Rsqr in Q. lra.
  Qed.

  Lemma kappa_positive : 0 < kappa.
  Proof. apply Rdiv_lt_0_compat; [exact h_pos | exact norm_positive]. Qed.

  Lemma n_unit : nx * nx + ny * ny = 1.
  Proof.
    pose proof norm_positive as Hn. unfold nx, ny.
    assert (E : (- r_dsp j k * r_dxp j k - sigma * root * r_dyp j k) * (- r_dsp j k * r_dxp j k - sigma * root * r_dyp j k) +
      (- r_dsp j k * r_dyp j k + sigma * root * r_dxp j k) * (- r_dsp j k * r_dyp j k + sigma * root * r_dxp j k) =
      norm j k * norm j k).
    { assert (norm j k = r_dsp j k * r_dsp j k + (sigma * sigma) * (root * root)) as E0.
      { rewrite sigma_unit, root_square. pose proof (gamma_is xj yj sj xk yk sk) as G. simpl in G. fold j k in G. lra. }
      rewrite E0 at 2. unfold norm. ring. }
    revert E. generalize (- r_dsp j k * r_dxp j k - sigma * root * r_dyp j k) (- r_dsp j k * r_dyp j k + sigma * root * r_dxp j k).
    intros a b E. replace (a / norm j k * (a / norm j k) + b / norm j k * (b / norm j k)) with ((a * a + b * b) / (norm j k * norm j k))
      by (field; lra).
    rewrite E. field. lra.
  Qed.

  (* What any third row makes with the direction n: in-circle. *)
  Lemma third e : norm j k * (nx * rx e + ny * ry e + rs e - rp e * kappa) =
    - (r_g j k (r_a j k e) (r_b j k e) + root * (sigma * r_c j k e)).
  Proof.
    pose proof norm_positive as Hn.
    assert (E : norm j k * (nx * rx e + ny * ry e + rs e - rp e * kappa) =
      (- r_dsp j k * r_dxp j k - sigma * root * r_dyp j k) * rx e + (- r_dsp j k * r_dyp j k + sigma * root * r_dxp j k) * ry e +
      norm j k * rs e - rp e * h) by (unfold nx, ny, kappa; field; lra).
    rewrite E. unfold h, form_g, form_a, form_b, form_c, form_u, norm.
    generalize (r_dxp j k) (r_dyp j k) (r_dsp j k) (r_dxs j k) (r_dys j k) (r_dxy j k). intros. ring.
  Qed.

  Lemma first_row : nx * xj + ny * yj + sj = rp j * kappa.
  Proof.
    pose proof norm_positive as Hn. pose proof (third j) as T.
    assert (r_g j k (r_a j k j) (r_b j k j) + root * (sigma * r_c j k j) = 0) as E.
    { unfold form_g, form_a, form_b, form_c, dxp, dyp, dsp, dxs, dys, dxy. ring. }
    rewrite E in T. apply (Rmult_eq_reg_l (norm j k)); [|lra]. unfold j, row_of in *; simpl in *. lra.
  Qed.

  Lemma second_row : nx * xk + ny * yk + sk = rp k * kappa.
  Proof.
    pose proof norm_positive as Hn. pose proof (third k) as T.
    assert (r_g j k (r_a j k k) (r_b j k k) + root * (sigma * r_c j k k) = 0) as E.
    { unfold form_g, form_a, form_b, form_c, dxp, dyp, dsp, dxs, dys, dxy. ring. }
    rewrite E in T. apply (Rmult_eq_reg_l (norm j k)); [|lra]. unfold k, row_of in *; simpl in *. lra.
  Qed.

  (* The orientation of the contacts before they are scaled to unit vectors. *)
  Lemma turn : sigma * ((xj + sj * nx) * (yk + sk * ny) - (yj + sj * ny) * (xk + sk * nx)) = root * h / norm j k.
  Proof.
    pose proof norm_positive as Hn.
    assert (E : (xj + sj * nx) * (yk + sk * ny) - (yj + sj * ny) * (xk + sk * nx) = r_dxy j k + ny * r_dxs j k - nx * r_dys j k).
    { unfold dxy, dxs, dys, j, k, row_of; simpl. ring. }
    rewrite E. apply (Rmult_eq_reg_r (norm j k)); [|lra].
    replace (sigma * (r_dxy j k + ny * r_dxs j k - nx * r_dys j k) * norm j k) with
      (sigma * (norm j k * r_dxy j k + (- r_dsp j k * r_dyp j k + sigma * root * r_dxp j k) * r_dxs j k
       - (- r_dsp j k * r_dxp j k - sigma * root * r_dyp j k) * r_dys j k)) by (unfold nx, ny; field; lra).
    replace (root * h / norm j k * norm j k) with (root * h) by (field; lra).
    pose proof (gamma_is xj yj sj xk yk sk) as G. simpl in G. fold j k in G.
    pose proof root_square as Q. rewrite G in Q.
    assert (E1 : norm j k = root * root + r_dsp j k * r_dsp j k) by lra. rewrite E1.
    unfold h, form_u. pose proof (plucker j k) as P. revert P sigma_unit.
    generalize (r_dxp j k) (r_dyp j k) (r_dsp j k) (r_dxs j k) (r_dys j k) (r_dxy j k). intros X Y S U V W P Q1.
    assert (root * (X * U + Y * V + root * (sigma * W)) = (sigma * sigma) * root * (X * U + Y * V) + root * root * (sigma * W)) as E2
      by (rewrite Q1; ring).
    rewrite E2.
    replace (sigma * ((root * root + S * S) * W + (- S * Y + sigma * root * X) * U - (- S * X - sigma * root * Y) * V)) with
      (sigma * sigma * root * (X * U + Y * V) + root * root * (sigma * W) + sigma * S * (W * S - U * Y + X * V)) by ring.
    rewrite P. ring.
  Qed.
End Circle.
