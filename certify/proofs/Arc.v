(* Affine functions on arcs of the unit circle. No angles. *)
From Coq Require Import Reals Lra Psatz.
Open Scope R_scope.

Record vec := Vec { vx : R; vy : R }.
Definition dot (u v : vec) : R := vx u * vx v + vy u * vy v.
Definition cross (u v : vec) : R := vx u * vy v - vy u * vx v.
Definition minus (u v : vec) : vec := Vec (vx u - vx v) (vy u - vy v).
Definition unit (u : vec) : Prop := vx u * vx u + vy u * vy u = 1.
Definition turn (u : vec) : vec := Vec (- vy u) (vx u).

(* K u = a.u + b. *)
Record affine := Affine { fa : vec; fb : R }.
Definition at_ (f : affine) (u : vec) : R := dot (fa f) u + fb f.
Definition slope (f : affine) (u : vec) : R := dot (fa f) (turn u).
Definition diff (f g : affine) : affine := Affine (minus (fa f) (fa g)) (fb f - fb g).

(* u lies on the arc from p counterclockwise to q (p <> q): right of the chord. *)
Definition chord (p q u : vec) : R := cross (minus u p) (minus q p).

Lemma sq x : 0 <= x * x.
Proof. apply Rle_0_sqr. Qed.

Lemma both_zero a b : a * a + b * b = 0 -> a = 0 /\ b = 0.
Proof. intros H. apply Rplus_sqr_eq_0. unfold Rsqr. exact H. Qed.

Lemma unit_dot u v : unit u -> unit v -> -1 <= dot u v <= 1.
Proof.
  unfold unit, dot. intros Hu Hv.
  pose proof (sq (vx u - vx v)). pose proof (sq (vy u - vy v)).
  pose proof (sq (vx u + vx v)). pose proof (sq (vy u + vy v)). lra.
Qed.

Lemma dot_one u v : unit u -> unit v -> dot u v = 1 -> u = v.
Proof.
  destruct u as [a b], v as [c d]. unfold unit, dot; simpl. intros Hu Hv H.
  assert ((a - c) * (a - c) + (b - d) * (b - d) = 0) by lra.
  apply both_zero in H0 as [X Y]. f_equal; lra.
Qed.

(* The arc lemma: if the least direction m of f lies outside the arc, then f is not negative on the arc if not at its ends.
   [J] is any affine function that vanishes at both ends and, where they are one, nowhere else on the disk. *)
Section ArcLemma.
  Variables p q u m : vec.
  Hypothesis Up : unit p.
  Hypothesis Uq : unit q.
  Hypothesis Uu : unit u.
  Hypothesis Um : unit m.
  Variable f : affine.
  Hypothesis fp : 0 <= at_ f p.
  Hypothesis fq : 0 <= at_ f q.
  Hypothesis least : at_ f m <= at_ f u.

  Lemma arc_lemma : 0 <= chord p q u -> chord p q m < 0 -> 0 <= at_ f u.
  Proof.
    intros Hu Hm. apply Rnot_lt_le. intros Neg.
    set (hu := chord p q u) in *. set (hm := - chord p q m).
    assert (Pm : 0 < hm) by (unfold hm; lra).
    set (dx := vx q - vx p). set (dy := vy q - vy p). set (n := dx * dx + dy * dy).
    assert (Hn : 0 < n).
    { assert (0 <= n) by (unfold n; nra). destruct (Req_dec n 0) as [E|]; [|lra]. exfalso.
      apply both_zero in E as [X Y].
      assert (chord p q m = 0); [|lra]. unfold chord, cross, minus; simpl. fold dx dy. rewrite X, Y. ring. }
    set (N := hm + hu).
    set (zx := hm * vx u + hu * vx m - N * vx p). set (zy := hm * vy u + hu * vy m - N * vy p).
    assert (L : zx * dy - zy * dx = 0).
    { unfold zx, zy, N.
      replace ((hm * vx u + hu * vx m - (hm + hu) * vx p) * dy - (hm * vy u + hu * vy m - (hm + hu) * vy p) * dx)
        with (hm * chord p q u + hu * chord p q m) by (unfold chord, cross, minus, dx, dy; simpl; ring).
      fold hu. unfold hm. ring. }
    set (s := (zx * dx + zy * dy) / n).
    assert (Zx : zx = s * dx).
    { unfold s. apply (Rmult_eq_reg_r n); [|lra]. unfold Rdiv. replace ((zx * dx + zy * dy) * / n * dx * n) with ((zx * dx + zy * dy) * dx)
        by (field; lra). unfold n. replace (zx * (dx * dx + dy * dy)) with (zx * dx * dx + (zx * dy) * dy) by ring.
      replace (zx * dy) with (zy * dx) by lra. ring. }
    assert (Zy : zy = s * dy).
    { unfold s. apply (Rmult_eq_reg_r n); [|lra]. unfold Rdiv. replace ((zx * dx + zy * dy) * / n * dy * n) with ((zx * dx + zy * dy) * dy)
        by (field; lra). unfold n. replace (zy * (dx * dx + dy * dy)) with (zy * dy * dy + (zy * dx) * dx) by ring.
      replace (zy * dx) with (zx * dy) by lra. ring. }
    (* The point of the chord's line between u and m lies in the disk, so between p and q. *)
    assert (D : (N * vx p + zx) * (N * vx p + zx) + (N * vy p + zy) * (N * vy p + zy) <= N * N).
    { replace (N * vx p + zx) with (hm * vx u + hu * vx m) by (unfold zx; ring).
      replace (N * vy p + zy) with (hm * vy u + hu * vy m) by (unfold zy; ring).
      pose proof (unit_dot u m Uu Um) as B. unfold dot in B. unfold unit in Uu, Um.
      replace ((hm * vx u + hu * vx m) * (hm * vx u + hu * vx m) + (hm * vy u + hu * vy m) * (hm * vy u + hu * vy m)) with
        (hm * hm * (vx u * vx u + vy u * vy u) + hu * hu * (vx m * vx m + vy m * vy m) + 2 * (hm * hu) * (vx u * vx m + vy u * vy m)) by ring.
      rewrite Uu, Um. assert (0 <= hm * hu) by (apply Rmult_le_pos; lra). unfold N. nra. }
    rewrite Zx, Zy in D. unfold unit in Up, Uq.
    assert (n = 2 * (1 - (vx p * vx q + vy p * vy q))) as En by (unfold n, dx, dy; lra).
    assert (S : 0 <= s * (N - s)).
    { assert ((N * vx p + s * dx) * (N * vx p + s * dx) + (N * vy p + s * dy) * (N * vy p + s * dy) =
        N * N * (vx p * vx p + vy p * vy p) + s * s * n + 2 * N * s * (vx p * dx + vy p * dy)) as X by (unfold n; ring).
      rewrite X, Up in D. assert (vx p * dx + vy p * dy = - n / 2) as Y by (rewrite En; unfold dx, dy; lra). rewrite Y in D.
      assert (s * (N - s) * n >= 0) by lra. apply Rnot_lt_le. intros Q. assert (0 < - (s * (N - s)) * n) by (apply Rmult_lt_0_compat; lra). lra. }
    assert (HN : 0 < N) by (unfold N; lra).
    assert (S0 : 0 <= s) by nra. assert (S1 : s <= N) by nra.
    assert (V : hm * at_ f u + hu * at_ f m = (N - s) * at_ f p + s * at_ f q).
    { unfold at_, dot. unfold zx in Zx. unfold zy in Zy.
      assert (hm * vx u + hu * vx m = N * vx p + s * dx) as Ex by lra.
      assert (hm * vy u + hu * vy m = N * vy p + s * dy) as Ey by lra.
      replace (hm * (vx (fa f) * vx u + vy (fa f) * vy u + fb f) + hu * (vx (fa f) * vx m + vy (fa f) * vy m + fb f)) with
        (vx (fa f) * (hm * vx u + hu * vx m) + vy (fa f) * (hm * vy u + hu * vy m) + N * fb f) by (unfold N; ring).
      rewrite Ex, Ey. unfold dx, dy. ring. }
    assert (0 <= (N - s) * at_ f p) by (apply Rmult_le_pos; lra).
    assert (0 <= s * at_ f q) by (apply Rmult_le_pos; lra).
    assert (hm * at_ f u < 0) by (assert (0 < hm * - at_ f u) by (apply Rmult_lt_0_compat; lra); lra).
    assert (hu * at_ f m <= 0) by (assert (0 <= hu * - at_ f m) by (apply Rmult_le_pos; lra); lra).
    lra.
  Qed.
End ArcLemma.

(* The least direction. *)
Definition norm (f : affine) : R := sqrt (vx (fa f) * vx (fa f) + vy (fa f) * vy (fa f)).
Definition least (f : affine) : vec := Vec (- vx (fa f) / norm f) (- vy (fa f) / norm f).

Lemma norm_square f : norm f * norm f = vx (fa f) * vx (fa f) + vy (fa f) * vy (fa f).
Proof. apply sqrt_sqrt. nra. Qed.

Lemma least_unit f : 0 < norm f -> unit (least f).
Proof.
  intros H. unfold unit, least; simpl. pose proof (norm_square f) as Q.
  replace (- vx (fa f) / norm f * (- vx (fa f) / norm f) + - vy (fa f) / norm f * (- vy (fa f) / norm f)) with
    ((vx (fa f) * vx (fa f) + vy (fa f) * vy (fa f)) / (norm f * norm f)) by (field; lra).
  rewrite <- Q. field. lra.
Qed.

Lemma least_value f : 0 < norm f -> at_ f (least f) = fb f - norm f.
Proof.
  intros H. unfold at_, dot, least; simpl. pose proof (norm_square f) as Q.
  replace (vx (fa f) * (- vx (fa f) / norm f) + vy (fa f) * (- vy (fa f) / norm f)) with
    (- ((vx (fa f) * vx (fa f) + vy (fa f) * vy (fa f)) / norm f)) by (field; lra).
  rewrite <- Q. field. lra.
Qed.

Lemma value_at_least f u : unit u -> fb f - norm f <= at_ f u.
Proof.
  intros Hu. unfold at_, dot. unfold unit in Hu. pose proof (norm_square f) as Q.
  assert (0 <= norm f) by apply sqrt_pos.
  assert (- norm f <= vx (fa f) * vx u + vy (fa f) * vy u); [|lra].
  apply Rnot_lt_le. intros L.
  assert ((vx (fa f) * vx u + vy (fa f) * vy u) * (vx (fa f) * vx u + vy (fa f) * vy u) <= norm f * norm f) as C.
  { rewrite Q. replace (vx (fa f) * vx (fa f) + vy (fa f) * vy (fa f)) with ((vx (fa f) * vx (fa f) + vy (fa f) * vy (fa f)) * (vx u * vx u + vy u * vy u)) by (rewrite Hu; ring).
    pose proof (sq (vx (fa f) * vy u - vy (fa f) * vx u)). lra. }
  nra.
Qed.

(* The condition for an arc: not negative at the ends, and either positive everywhere or least outside. *)
Theorem arc_not_negative f p q u : unit p -> unit q -> unit u -> 0 <= at_ f p -> 0 <= at_ f q ->
  (0 <= fb f - norm f \/ (0 < norm f /\ chord p q (least f) < 0)) -> 0 <= chord p q u -> 0 <= at_ f u.
Proof.
  intros Up Uq Uu Fp Fq [B|[Hn B]] C.
  - pose proof (value_at_least f u Uu). lra.
  - apply (arc_lemma p q u (least f)); try assumption; [apply least_unit, Hn|].
    rewrite least_value by exact Hn. apply value_at_least, Uu.
Qed.

(* The linear order of the circle without v. *)
Definition key (v u : vec) : R := cross v u / (1 - dot v u).

Lemma not_one v u : unit v -> unit u -> u <> v -> 0 < 1 - dot v u.
Proof.
  intros Hv Hu N. pose proof (unit_dot v u Hv Hu) as [_ B]. destruct (Req_dec (dot v u) 1) as [E|E]; [|lra].
  destruct N. symmetry. apply dot_one; assumption.
Qed.

Lemma chord_key v p q : unit v -> unit p -> unit q -> p <> v -> q <> v ->
  chord p q v = (1 - dot v p) * (1 - dot v q) * (key v q - key v p).
Proof.
  intros Hv Hp Hq Np Nq. pose proof (not_one v p Hv Hp Np). pose proof (not_one v q Hv Hq Nq).
  unfold key. replace ((1 - dot v p) * (1 - dot v q) * (cross v q / (1 - dot v q) - cross v p / (1 - dot v p))) with
    ((1 - dot v p) * cross v q - (1 - dot v q) * cross v p) by (field; lra).
  unfold chord, cross, minus, dot; simpl. unfold unit in Hv.
  replace ((vx v - vx p) * (vy q - vy p) - (vy v - vy p) * (vx q - vx p)) with
    (vx v * vy q - vy v * vx q - (vx v * vy p - vy v * vx p) - (vx p * vy q - vy p * vx q)) by ring.
  replace (vx p * vy q - vy p * vx q) with ((vx v * vx v + vy v * vy v) * (vx p * vy q - vy p * vx q)) by (rewrite Hv; ring). ring.
Qed.

(* An affine function that is not negative on an arc and vanishes at its end does not rise there. *)
Lemma no_exit f p q : unit p -> unit q -> p <> q -> (forall u, unit u -> 0 <= chord p q u -> 0 <= at_ f u) -> at_ f q = 0 -> slope f q <= 0.
Proof.
  intros Up Uq D H Z. apply Rnot_lt_le. intros S.
  assert (D1 : 0 < 1 - dot q p) by (apply not_one; assumption).
  set (a := dot (fa f) q). set (c := cross p q). set (d := slope f q) in *. set (e := 1 - dot q p) in *.
  (* h small: h |a| < d, h |c| < e *)
  set (h := Rmin (d / (2 * (1 + Rabs a))) (e / (2 * (1 + Rabs c)))).
  assert (A : 0 < 1 + Rabs a) by (pose proof (Rabs_pos a); lra). assert (C : 0 < 1 + Rabs c) by (pose proof (Rabs_pos c); lra).
  assert (Hh : 0 < h) by (unfold h; apply Rmin_glb_lt; apply Rdiv_lt_0_compat; lra).
  assert (H1 : h * a < d).
  { apply Rle_lt_trans with (h * Rabs a); [apply Rmult_le_compat_l; [lra|apply Rle_abs]|].
    apply Rle_lt_trans with (d / (2 * (1 + Rabs a)) * (1 + Rabs a)).
    - apply Rmult_le_compat; [lra|apply Rabs_pos|apply Rmin_l|lra].
    - replace (d / (2 * (1 + Rabs a)) * (1 + Rabs a)) with (d / 2) by (field; lra). lra. }
  assert (H1' : - (h * a) < d).
  { apply Rle_lt_trans with (h * Rabs a); [rewrite Ropp_mult_distr_r; apply Rmult_le_compat_l; [lra|rewrite <- Rabs_Ropp; apply Rle_abs]|].
    apply Rle_lt_trans with (d / (2 * (1 + Rabs a)) * (1 + Rabs a)).
    - apply Rmult_le_compat; [lra|apply Rabs_pos|apply Rmin_l|lra].
    - replace (d / (2 * (1 + Rabs a)) * (1 + Rabs a)) with (d / 2) by (field; lra). lra. }
  assert (H2 : h * c < e).
  { apply Rle_lt_trans with (h * Rabs c); [apply Rmult_le_compat_l; [lra|apply Rle_abs]|].
    apply Rle_lt_trans with (e / (2 * (1 + Rabs c)) * (1 + Rabs c)).
    - apply Rmult_le_compat; [lra|apply Rabs_pos|apply Rmin_r|lra].
    - replace (e / (2 * (1 + Rabs c)) * (1 + Rabs c)) with (e / 2) by (field; lra). lra. }
  set (w := 1 + h * h). assert (Hw : 0 < w) by (unfold w; nra).
  set (u := Vec (((1 - h * h) * vx q + 2 * h * vy q) / w) (((1 - h * h) * vy q - 2 * h * vx q) / w)).
  assert (Uu : unit u).
  { unfold unit, u; simpl. unfold unit in Uq.
    assert (G : forall A B, A / w * (A / w) + B / w * (B / w) = (A * A + B * B) / (w * w)) by (intros; field; lra).
    rewrite G. replace (((1 - h * h) * vx q + 2 * h * vy q) * ((1 - h * h) * vx q + 2 * h * vy q) + ((1 - h * h) * vy q - 2 * h * vx q) * ((1 - h * h) * vy q - 2 * h * vx q))
      with (w * w * (vx q * vx q + vy q * vy q)) by (unfold w; ring). rewrite Uq. field. lra. }
  assert (E1 : at_ f u * w = -2 * h * (d + h * a)).
  { unfold at_, d, slope, a, dot, turn, u in *; simpl in *.
    replace ((vx (fa f) * (((1 - h * h) * vx q + 2 * h * vy q) / w) + vy (fa f) * (((1 - h * h) * vy q - 2 * h * vx q) / w) + fb f) * w) with
      (vx (fa f) * ((1 - h * h) * vx q + 2 * h * vy q) + vy (fa f) * ((1 - h * h) * vy q - 2 * h * vx q) + fb f * w) by (field; lra).
    replace (fb f) with (- (vx (fa f) * vx q + vy (fa f) * vy q)) by lra. unfold w. ring. }
  assert (E2 : chord p q u * w = 2 * h * (e - h * c)).
  { unfold chord, c, e, cross, dot, minus, u; simpl. unfold unit in Uq.
    replace (((((1 - h * h) * vx q + 2 * h * vy q) / w - vx p) * (vy q - vy p) - (((1 - h * h) * vy q - 2 * h * vx q) / w - vy p) * (vx q - vx p)) * w) with
      (((1 - h * h) * vx q + 2 * h * vy q - w * vx p) * (vy q - vy p) - ((1 - h * h) * vy q - 2 * h * vx q - w * vy p) * (vx q - vx p)) by (field; lra).
    replace (1 - (vx q * vx p + vy q * vy p)) with (vx q * vx q + vy q * vy q - (vx q * vx p + vy q * vy p)) by lra. unfold w. ring. }
  assert (0 <= chord p q u).
  { apply (Rmult_le_reg_r w); [exact Hw|]. rewrite E2, Rmult_0_l. apply Rmult_le_pos; lra. }
  specialize (H u Uu H0). assert (0 <= at_ f u * w) by (apply Rmult_le_pos; lra). rewrite E1 in H3.
  assert (0 < 2 * h * (d + h * a)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
