(* Circles, as Geometry.v has them, and the functions of Envelope.v. *)
From Coq Require Import Reals Lra List Bool PArith.
From Voroproof Require Import Geometry Circle Vertex Scale History Arc Cyclic Cover Spread Envelope.
Import ListNotations.
Open Scope R_scope.

Definition contact (c : circle) (g : generator) : vec := Vec (contact_x c g) (contact_y c g).
Definition opposite (u : vec) : vec := Vec (- vx u) (- vy u).

(* A circle touches a generator where its centre is at a signed distance from the generator's. *)
Lemma touch_length c g : touches c g <-> Geometry.length (cx g - ox c) (cy g - oy c) = sign_of (wall g) * (size c + radius g).
Proof.
  unfold touches, distance.
  assert (E : Geometry.length (ox c - cx g) (oy c - cy g) = Geometry.length (cx g - ox c) (cy g - oy c)) by (unfold Geometry.length; f_equal; ring).
  rewrite E. unfold sign_of. destruct (wall g); split; lra.
Qed.

Lemma sign_square w : sign_of w * sign_of w = 1.
Proof. unfold sign_of. destruct w; lra. Qed.

Lemma touch_square c g : touches c g -> (cx g - ox c) * (cx g - ox c) + (cy g - oy c) * (cy g - oy c) = (size c + radius g) * (size c + radius g).
Proof.
  intros H. apply touch_length in H. rewrite <- length_square, H.
  replace (sign_of (wall g) * (size c + radius g) * (sign_of (wall g) * (size c + radius g))) with
    (sign_of (wall g) * sign_of (wall g) * ((size c + radius g) * (size c + radius g))) by ring.
  rewrite sign_square. ring.
Qed.

Lemma right_disk l g : wall l = false -> right_pair l g -> 0 < sign_of (wall g) * tang (seen_at l g).
Proof. intros W H. apply right_tang in H. rewrite W in H. simpl in H. unfold sign_of. destruct (wall g); lra. Qed.

(* Where a circle touches a disk l and a generator that is right with it, all that is divided by is not 0. *)
Lemma pencil c l g : wall l = false -> right_pair l g -> touches c l -> touches c g ->
  let ux := ox c - cx l in let uy := oy c - cy l in let q := size c + radius l in
  let x := cx g - cx l in let y := cy g - cy l in let s := radius g - radius l in
  0 < q /\ 0 < sign_of (wall g) * (q + s) /\ ux * ux + uy * uy = q * q /\ 2 * (x * ux + y * uy + q * s) = tang (seen_at l g).
Proof.
  intros W Rg Tl Tg ux uy q x y s. pose proof (right_disk l g W Rg) as P.
  pose proof (touch_square c l Tl) as Sl. pose proof (touch_square c g Tg) as Sg.
  apply touch_length in Tl, Tg. rewrite W in Tl. simpl in Tl.
  pose proof (length_nonneg (cx l - ox c) (cy l - oy c)) as Nl. pose proof (length_nonneg (cx g - ox c) (cy g - oy c)) as Ng.
  assert (Q : ux * ux + uy * uy = q * q) by (unfold ux, uy, q; lra).
  assert (E : (x - ux) * (x - ux) + (y - uy) * (y - uy) = (q + s) * (q + s)) by (unfold x, y, ux, uy, q, s; lra).
  assert (T : 2 * (x * ux + y * uy + q * s) = tang (seen_at l g)) by (unfold tang, seen_at; simpl; fold x y s; lra).
  repeat split.
  - destruct (Rle_lt_or_eq_dec 0 q) as [L|L]; [fold q in Tl; lra|exact L|exfalso].
    rewrite <- L in Q. assert (Z : ux * ux + uy * uy = 0) by lra. apply both_zero in Z as [Zx Zy].
    rewrite <- T, Zx, Zy, <- L in P. lra.
  - replace (q + s) with (size c + radius g) by (unfold q, s; ring).
    destruct (Rle_lt_or_eq_dec 0 (sign_of (wall g) * (size c + radius g))) as [L|L]; [lra|exact L|exfalso].
    assert (Z : q + s = 0).
    { replace (q + s) with (sign_of (wall g) * sign_of (wall g) * (size c + radius g)) by (rewrite sign_square; unfold q, s; ring).
      rewrite Rmult_assoc, <- L. ring. }
    rewrite Z in E. assert (Z1 : (x - ux) * (x - ux) + (y - uy) * (y - uy) = 0) by lra. apply both_zero in Z1 as [Zx Zy].
    assert (x = ux) as Ex by lra. assert (y = uy) as Ey by lra. assert (s = - q) as Es by lra.
    assert (tang (seen_at l g) = 0) as Z2; [|rewrite Z2 in P; lra]. rewrite <- T, Ex, Ey, Es. lra.
  - exact Q.
  - exact T.
Qed.

(* The contact of a generator whose distance is not 0. *)
Lemma contact_is c g : touches c g -> 0 < sign_of (wall g) * (size c + radius g) ->
  contact c g = Vec ((cx g - ox c) / (size c + radius g)) ((cy g - oy c) / (size c + radius g)).
Proof.
  intros T P. apply touch_length in T. unfold contact, contact_x, contact_y. rewrite T. unfold sign_of in *.
  assert (size c + radius g <> 0) by (intros Z; rewrite Z in P; lra). destruct (wall g); f_equal; field; lra.
Qed.

Lemma contact_is_unit c g : touches c g -> 0 < sign_of (wall g) * (size c + radius g) -> unit (contact c g).
Proof.
  intros T P. rewrite contact_is by assumption. unfold unit; simpl. pose proof (touch_square c g T) as Q.
  assert (N : size c + radius g <> 0) by (intros Z; rewrite Z in P; lra).
  replace ((cx g - ox c) / (size c + radius g) * ((cx g - ox c) / (size c + radius g)) + (cy g - oy c) / (size c + radius g) * ((cy g - oy c) / (size c + radius g)))
    with (((cx g - ox c) * (cx g - ox c) + (cy g - oy c) * (cy g - oy c)) / ((size c + radius g) * (size c + radius g))) by (field; exact N).
  rewrite Q. field. exact N.
Qed.

Lemma opposite_contact c l : wall l = false -> touches c l -> 0 < size c + radius l ->
  opposite (contact c l) = Vec ((ox c - cx l) / (size c + radius l)) ((oy c - cy l) / (size c + radius l)).
Proof.
  intros W T P. rewrite contact_is by (rewrite ?W; simpl; lra || assumption). unfold opposite; simpl. f_equal; field; lra.
Qed.

Lemma opposite_unit u : unit u -> unit (opposite u).
Proof. unfold unit, opposite; simpl. lra. Qed.

(* A circle that touches a disk l and g, which are right: its contacts are unit vectors; where it touches three, their order is that of
   the slopes seen from l, and right_pair generators touch it at different places. *)
Lemma contact_unit c l g : proper l -> proper g -> wall l = false -> right_pair l g -> touches c l -> touches c g -> unit (contact c l) /\ unit (contact c g).
Proof.
  intros _ _ W Rg Tl Tg. destruct (pencil c l g W Rg Tl Tg) as (Q & S & _ & _). split; apply contact_is_unit; try assumption.
  - rewrite W. simpl. lra.
  - replace (size c + radius g) with (size c + radius l + (radius g - radius l)) by ring. exact S.
Qed.

Lemma touching_level c l g : proper l -> proper g -> wall l = false -> right_pair l g -> touches c l -> touches c g ->
  0 < size c + radius l /\ at_ (Kg l g) (opposite (contact c l)) = / (2 * (size c + radius l)).
Proof.
  intros _ _ W Rg Tl Tg. destruct (pencil c l g W Rg Tl Tg) as (Q & _ & _ & T). split; [exact Q|].
  rewrite opposite_contact by assumption. pose proof (right_disk l g W Rg) as P.
  assert (N : tang (seen_at l g) <> 0) by (intros Z; rewrite Z in P; lra).
  unfold Kg, K, at_, dot; simpl. revert T N. generalize (tang (seen_at l g)). intros t T N.
  apply (Rmult_eq_reg_r (2 * t * (size c + radius l))); [|repeat apply Rmult_integral_contrapositive_currified; lra].
  replace (/ (2 * (size c + radius l)) * (2 * t * (size c + radius l))) with t by (field; lra).
  transitivity (2 * ((cx g - cx l) * (ox c - cx l) + (cy g - cy l) * (oy c - cy l) + (size c + radius l) * (radius g - radius l))); [field; lra|exact T].
Qed.

Lemma contact_slopes c l j k : proper l -> proper j -> proper k -> wall l = false -> wall j && wall k = false ->
  right_pair l j -> right_pair l k -> right_pair j k -> touches c l -> touches c j -> touches c k ->
  (counterclockwise c l j k <-> slope (Kg l j) (opposite (contact c l)) < slope (Kg l k) (opposite (contact c l))).
Proof.
  intros _ _ _ W _ Rj Rk _ Tl Tj Tk.
  destruct (pencil c l j W Rj Tl Tj) as (Q & Sj & U & Ej). destruct (pencil c l k W Rk Tl Tk) as (_ & Sk & _ & Ek).
  pose proof (right_disk l j W Rj) as Pj. pose proof (right_disk l k W Rk) as Pk.
  rewrite (opposite_contact c l W Tl Q). unfold counterclockwise.
  assert (Cl : contact c l = Vec (- (ox c - cx l) / (size c + radius l)) (- (oy c - cy l) / (size c + radius l))).
  { rewrite contact_is; [f_equal; field; lra|exact Tl|rewrite W; simpl; lra]. }
  assert (Cj : contact c j = Vec ((cx j - cx l - (ox c - cx l)) / (size c + radius l + (radius j - radius l))) ((cy j - cy l - (oy c - cy l)) / (size c + radius l + (radius j - radius l)))).
  { replace (size c + radius l + (radius j - radius l)) with (size c + radius j) in * by ring. rewrite (contact_is c j Tj Sj). f_equal; f_equal; ring. }
  assert (Ck : contact c k = Vec ((cx k - cx l - (ox c - cx l)) / (size c + radius l + (radius k - radius l))) ((cy k - cy l - (oy c - cy l)) / (size c + radius l + (radius k - radius l)))).
  { replace (size c + radius l + (radius k - radius l)) with (size c + radius k) in * by ring. rewrite (contact_is c k Tk Sk). f_equal; f_equal; ring. }
  injection Cl as -> ->. injection Cj as -> ->. injection Ck as -> ->.
  unfold Kg, K, slope, dot, turn; simpl. revert Ej Ek Pj Pk. generalize (tang (seen_at l j)) (tang (seen_at l k)). intros pj pk.
  revert U Sj Sk Q. generalize (ox c - cx l) (oy c - cy l) (size c + radius l) (cx j - cx l) (cy j - cy l) (radius j - radius l) (cx k - cx l) (cy k - cy l) (radius k - radius l).
  intros ux uy q xj yj sj xk yk sk U Sj Sk Q Ej Ek Pj Pk.
  assert (Nj : q + sj <> 0) by (intros Z; rewrite Z in Sj; lra). assert (Nk : q + sk <> 0) by (intros Z; rewrite Z in Sk; lra).
  assert (Mj : pj <> 0) by (intros Z; rewrite Z in Pj; lra). assert (Mk : pk <> 0) by (intros Z; rewrite Z in Pk; lra).
  set (D := (xk / pk * - (uy / q) + yk / pk * (ux / q)) - (xj / pj * - (uy / q) + yj / pj * (ux / q))).
  assert (E : ((xj - ux) / (q + sj) - - ux / q) * ((yk - uy) / (q + sk) - - uy / q) - ((yj - uy) / (q + sj) - - uy / q) * ((xk - ux) / (q + sk) - - ux / q) =
    (pj / (q + sj)) * (pk / (q + sk)) / (2 * q) * D).
  { apply (Rmult_eq_reg_r ((q + sj) * (q + sk) * (q * q))); [|repeat apply Rmult_integral_contrapositive_currified; lra].
    replace (pj / (q + sj) * (pk / (q + sk)) / (2 * q) * D * ((q + sj) * (q + sk) * (q * q))) with
      ((pj * (- xk * uy + yk * ux) - pk * (- xj * uy + yj * ux)) / 2) by (unfold D; field; repeat split; assumption || lra).
    rewrite <- Ej, <- Ek.
    replace ((((xj - ux) / (q + sj) - - ux / q) * ((yk - uy) / (q + sk) - - uy / q) - ((yj - uy) / (q + sj) - - uy / q) * ((xk - ux) / (q + sk) - - ux / q)) * ((q + sj) * (q + sk) * (q * q)))
      with ((q * xj + sj * ux) * (q * yk + sk * uy) - (q * yj + sj * uy) * (q * xk + sk * ux)) by (field; repeat split; assumption || lra).
    replace ((2 * (xj * ux + yj * uy + q * sj) * (- xk * uy + yk * ux) - 2 * (xk * ux + yk * uy + q * sk) * (- xj * uy + yj * ux)) / 2) with
      ((xj * yk - yj * xk) * (ux * ux + uy * uy) + q * (sj * (yk * ux - xk * uy) - sk * (yj * ux - xj * uy))) by field.
    rewrite U. ring. }
  rewrite E.
  assert (Ratio : forall w p d, 0 < sign_of w * p -> 0 < sign_of w * d -> 0 < p / d).
  { intros w p d Hp Hd. replace (p / d) with (sign_of w * p / (sign_of w * d)); [apply Rdiv_lt_0_compat; assumption|].
    pose proof (sign_square w) as S2. assert (sign_of w <> 0) by (intros Z; rewrite Z in S2; lra).
    assert (d <> 0) by (intros Z; rewrite Z in Hd; lra). field. split; assumption. }
  assert (F : 0 < pj / (q + sj) * (pk / (q + sk)) / (2 * q)).
  { apply Rdiv_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; [apply (Ratio (wall j))|apply (Ratio (wall k))]; assumption. }
  revert F. generalize (pj / (q + sj) * (pk / (q + sk)) / (2 * q)). intros f F. split; intros H.
  - assert (0 < D); [|unfold D in *; lra]. apply Rnot_le_lt. intros L. assert (0 <= f * - D) by (apply Rmult_le_pos; lra). lra.
  - apply Rmult_lt_0_compat; [exact F|]. unfold D. lra.
Qed.

Lemma contact_vector c g : touches c g -> cx g - ox c = (size c + radius g) * contact_x c g /\ cy g - oy c = (size c + radius g) * contact_y c g.
Proof.
  intros T. destruct (Req_dec (size c + radius g) 0) as [Z|N].
  - pose proof (touch_square c g T) as Q. rewrite Z, Rmult_0_l in Q. apply both_zero in Q as [-> ->]. rewrite Z. split; ring.
  - assert (P : 0 < sign_of (wall g) * (size c + radius g)).
    { pose proof T as L. apply touch_length in L. rewrite <- L. destruct (Rle_lt_or_eq_dec 0 _ (length_nonneg (cx g - ox c) (cy g - oy c))) as [H|H]; [exact H|].
      exfalso. rewrite L in H. apply N. rewrite <- (Rmult_1_l (size c + radius g)), <- (sign_square (wall g)), Rmult_assoc, <- H. ring. }
    pose proof (contact_is c g T P) as E. injection E as -> ->. split; field; exact N.
Qed.

Lemma contacts_differ c g h : proper g -> proper h -> wall g && wall h = false -> right_pair g h -> touches c g -> touches c h ->
  unit (contact c g) -> unit (contact c h) -> contact c g <> contact c h.
Proof.
  intros _ _ _ Rp Tg Th Ug _ E. destruct (contact_vector c g Tg) as [Gx Gy]. destruct (contact_vector c h Th) as [Hx Hy].
  injection E as Ex Ey. rewrite <- Ex in Hx. rewrite <- Ey in Hy. unfold unit, contact in Ug; simpl in Ug.
  revert Gx Gy Hx Hy Ug. generalize (contact_x c g) (contact_y c g). intros a b Gx Gy Hx Hy U.
  assert (X : cx g - cx h = (radius g - radius h) * a) by lra. assert (Y : cy g - cy h = (radius g - radius h) * b) by lra.
  unfold right_pair in Rp. rewrite X, Y in Rp.
  replace ((radius g - radius h) * a * ((radius g - radius h) * a) + (radius g - radius h) * b * ((radius g - radius h) * b) - (radius g - radius h) * (radius g - radius h))
    with ((radius g - radius h) * (radius g - radius h) * (a * a + b * b) - (radius g - radius h) * (radius g - radius h)) in Rp by ring.
  rewrite U in Rp. destruct (wall g || wall h); lra.
Qed.
(* counterclockwise is the order of Cyclic.v of the contacts *)
Lemma counterclockwise_is c i j k : counterclockwise c i j k <-> ccw (contact c i) (contact c j) (contact c k).
Proof. unfold counterclockwise, ccw, cross, contact, minus; simpl. tauto. Qed.

(* How a circle that touches a disk lies to a generator that is right with it. *)
Lemma pencil_other c l e : proper l -> proper e -> wall l = false -> right_pair l e -> touches c l -> 0 < size c + radius l ->
  (empty_of c e <-> at_ (Kg l e) (opposite (contact c l)) <= / (2 * (size c + radius l))) /\
  (touches c e <-> at_ (Kg l e) (opposite (contact c l)) = / (2 * (size c + radius l))).
Proof.
  intros Hl He W Re Tl Q. pose proof (right_disk l e W Re) as P.
  assert (U : unit (opposite (contact c l))) by (apply opposite_unit, contact_is_unit; [exact Tl|rewrite W; simpl; lra]).
  assert (V : touches c e -> at_ (Kg l e) (opposite (contact c l)) = / (2 * (size c + radius l))) by (intros T; apply touching_level; assumption).
  rewrite (opposite_contact c l W Tl Q) in *. set (nx := (ox c - cx l) / (size c + radius l)) in *. set (ny := (oy c - cy l) / (size c + radius l)) in *.
  unfold unit in U; simpl in U. set (q := size c + radius l) in *. set (kap := / (2 * q)) in *.
  assert (Qk : 2 * q * kap = 1) by (unfold kap; field; lra).
  set (x := cx e - cx l). set (y := cy e - cy l). set (s := radius e - radius l).
  assert (Wx : x - q * nx = cx e - ox c) by (unfold x, nx; field; lra). assert (Wy : y - q * ny = cy e - oy c) by (unfold y, ny; field; lra).
  assert (Sz : size c + radius e = q + s) by (unfold q, s; ring).
  set (p := tang (seen_at l e)) in *. assert (Pe : p = x * x + y * y - s * s) by reflexivity.
  assert (N : p <> 0) by (intros Z; rewrite Z in P; lra).
  assert (A : at_ (Kg l e) (Vec nx ny) = (nx * x + ny * y + s) / p) by (unfold Kg, K, at_, dot; simpl; fold p x y s; field; exact N).
  rewrite A in *.
  assert (Le : size c <= distance e (ox c) (oy c) <->
    if wall e then Geometry.length (x - q * nx) (y - q * ny) <= - (q + s) else q + s <= Geometry.length (x - q * nx) (y - q * ny)).
  { rewrite Wx, Wy, <- Sz. unfold distance.
    assert (E : Geometry.length (ox c - cx e) (oy c - cy e) = Geometry.length (cx e - ox c) (cy e - oy c)) by (unfold Geometry.length; f_equal; ring).
    rewrite E. destruct (wall e); split; lra. }
  assert (Te : touches c e <-> Geometry.length (x - q * nx) (y - q * ny) = sign_of (wall e) * (q + s)) by (rewrite touch_length, Wx, Wy, Sz; reflexivity).
  set (m := nx * x + ny * y + s) in *. assert (Mp : m / p * p = m) by (field; exact N).
  unfold empty_of. rewrite Le. unfold proper in Hl, He. rewrite W in Hl. destruct (wall e) eqn:Ew; simpl in P, Te; split.
  - split; intros H.
    + apply Rnot_lt_le. intros L. assert (0 < - p * (m / p - kap)) by (apply Rmult_lt_0_compat; lra).
      pose proof (wall_inside nx ny q x y s kap p U Q Qk Pe) as I. fold m in I. specialize (I ltac:(lra)). lra.
    + apply (wall_outside nx ny q x y s kap p U Q Qk Pe); [|lra|unfold s; lra]. fold m.
      assert (0 <= - p * (kap - m / p)) by (apply Rmult_le_pos; lra). lra.
  - split; [exact V|]. intros H. rewrite H in Mp. apply Te.
    destruct (wall_in_contact nx ny q x y s kap p U Q Qk Pe) as [_ L]; [lra|fold m; lra|]. lra.
  - split; intros H.
    + apply Rnot_lt_le. intros L. assert (0 < p * (m / p - kap)) by (apply Rmult_lt_0_compat; lra).
      pose proof (disk_inside nx ny q x y s kap p U Q Qk Pe) as I. fold m in I. specialize (I ltac:(lra) ltac:(lra)). lra.
    + apply (disk_outside nx ny q x y s kap p U Q Qk Pe). fold m.
      assert (0 <= p * (kap - m / p)) by (apply Rmult_le_pos; lra). lra.
  - split; [exact V|]. intros H. rewrite H in Mp. apply Te.
    destruct (disk_in_contact nx ny q x y s kap p U Q Qk Pe) as [_ L]; [lra|fold m; lra|]. lra.
Qed.

(* The circle of a vertex that is there. *)
Lemma circle_of_vertex l j k : proper l -> proper j -> proper k -> vertex l j k ->
  exists c, vertex_circle c l j k /\ contact c l = opposite (dir l j k) /\ size c + radius l = / (2 * level l j k).
Proof.
  intros Hl Hj Hk V. pose proof (vertex_dir l j k V) as (U & E & S). destruct V as (W & Rj & Rk & Rjk & Wjk & P).
  set (u := dir l j k) in *. set (v := level l j k) in *.
  assert (Ej : at_ (Kg l j) u = v) by reflexivity. clearbody u v. set (q := / (2 * v)).
  assert (Q : 0 < q) by (apply Rinv_0_lt_compat; lra).
  set (c := Circle (cx l + q * vx u) (cy l + q * vy u) (q - radius l)).
  assert (Sz : size c + radius l = q) by (simpl; ring).
  assert (Tl : touches c l).
  { apply touch_length. rewrite W. simpl sign_of. rewrite Rmult_1_l, Sz. apply length_of_square; [lra|]. simpl.
    replace ((cx l - (cx l + q * vx u)) * (cx l - (cx l + q * vx u)) + (cy l - (cy l + q * vy u)) * (cy l - (cy l + q * vy u))) with
      (q * q * (vx u * vx u + vy u * vy u)) by ring. unfold unit in U. rewrite U. ring. }
  assert (O : opposite (contact c l) = u).
  { rewrite opposite_contact by (assumption || lra). rewrite Sz. unfold c; simpl. destruct u as [a b]; simpl. f_equal; field; lra. }
  assert (Ql : / (2 * (size c + radius l)) = v) by (rewrite Sz; unfold q; field; lra).
  destruct (pencil_other c l j) as [_ Tj]; try assumption; [lra|]. destruct (pencil_other c l k) as [_ Tk]; try assumption; [lra|].
  rewrite O, Ql in Tj, Tk.
  assert (Hcj : touches c j) by (apply Tj; exact Ej). assert (Hck : touches c k) by (apply Tk; rewrite E; exact Ej).
  exists c. split; [|split; [|exact Sz]].
  - unfold vertex_circle. split; [exact Tl|]. split; [exact Hcj|]. split; [exact Hck|].
    apply contact_slopes; try assumption. rewrite O. exact S.
  - rewrite <- O. unfold opposite, contact; simpl. f_equal; ring.
Qed.

(* A circle of the three has the direction and the curvature of the vertex. *)
Lemma circle_dir c l j k : proper l -> proper j -> proper k -> wall l = false -> wall j && wall k = false ->
  right_pair l j -> right_pair l k -> right_pair j k -> vertex_circle c l j k ->
  0 < size c + radius l /\ opposite (contact c l) = dir l j k /\ / (2 * (size c + radius l)) = level l j k.
Proof.
  intros Hl Hj Hk W Wjk Rj Rk Rjk (Tl & Tj & Tk & C).
  destruct (touching_level c l j) as [Q Ej]; try assumption. destruct (touching_level c l k) as [_ Ek]; try assumption.
  assert (U : unit (opposite (contact c l))) by (apply opposite_unit, contact_is_unit; [exact Tl|rewrite W; simpl; lra]).
  apply contact_slopes in C; try assumption.
  assert (D : opposite (contact c l) = dir l j k).
  { apply up_only; [exact U| |]; revert Ej Ek C; generalize (opposite (contact c l)); intros u Ej Ek C;
      unfold at_, slope, diff, dot, minus, turn in *; simpl in *; lra. }
  split; [exact Q|]. split; [exact D|]. unfold level. rewrite <- D. symmetry. exact Ej.
Qed.

(* A circle of the three is that of the vertex. *)
Lemma vertex_of_circle c l j k : proper l -> proper j -> proper k -> wall l = false -> wall j && wall k = false ->
  right_pair l j -> right_pair l k -> right_pair j k -> vertex_circle c l j k -> vertex l j k.
Proof.
  intros Hl Hj Hk W Wjk Rj Rk Rjk V. destruct (circle_dir c l j k) as (Q & _ & E); try assumption.
  unfold vertex. rewrite <- E. repeat split; try assumption. apply Rinv_0_lt_compat. lra.
Qed.

Lemma one_circle c c' l j k : proper l -> proper j -> proper k -> vertex l j k -> vertex_circle c l j k -> vertex_circle c' l j k -> c = c'.
Proof.
  intros Hl Hj Hk (W & Rj & Rk & Rjk & Wjk & _) V V'.
  destruct (circle_dir c l j k) as (Q & D & E); try assumption. destruct (circle_dir c' l j k) as (Q' & D' & E'); try assumption.
  rewrite <- D' in D. rewrite <- E' in E. destruct V as (Tl & _). destruct V' as (Tl' & _).
  rewrite !opposite_contact in D by assumption. injection D as Dx Dy.
  assert (S : size c + radius l = size c' + radius l).
  { assert (X : 2 * (size c + radius l) = 2 * (size c' + radius l)); [|lra]. rewrite <- (Rinv_inv (2 * (size c + radius l))), E. apply Rinv_inv. }
  rewrite S in Dx, Dy. apply Rmult_eq_reg_r in Dx, Dy; try (apply Rinv_neq_0_compat; lra).
  destruct c, c'; simpl in *. f_equal; lra.
Qed.

(* How the circle lies to others. *)
Lemma circle_and_other c l j k e : proper l -> proper j -> proper k -> proper e -> vertex l j k -> vertex_circle c l j k -> right_pair l e ->
  (empty_of c e <-> at_ (Kg l e) (dir l j k) <= level l j k) /\ (touches c e <-> at_ (Kg l e) (dir l j k) = level l j k).
Proof.
  intros Hl Hj Hk He (W & Rj & Rk & Rjk & Wjk & _) V Re. destruct (circle_dir c l j k) as (Q & D & E); try assumption.
  rewrite <- D, <- E. destruct V as (Tl & _). apply pencil_other; assumption.
Qed.

(* Edges: l is a disk. *)
Section Edge.
  Variables l r s e : generator.
  Hypothesis pl : proper l. Hypothesis pr : proper r. Hypothesis ps : proper s. Hypothesis pe : proper e.
  Hypothesis start : vertex l s r.
  Hypothesis last : vertex l r e.
  Lemma legal_link : legal l r s e <-> (at_ (Kg l e) (dir l s r) <= level l s r /\ at_ (Kg l s) (dir l r e) <= level l r e).
  Proof.
    pose proof start as (_ & Rs & _). pose proof last as (_ & _ & Re & _). unfold legal, circles. split.
    - intros [(c & C & E) (c' & C' & E')]. split.
      + apply (circle_and_other c l s r e); assumption.
      + apply (circle_and_other c' l r e s); assumption.
    - intros [H H']. destruct (circle_of_vertex l s r pl ps pr start) as (c & C & _). destruct (circle_of_vertex l r e pl pr pe last) as (c' & C' & _). split.
      + exists c. split; [exact C|]. apply (circle_and_other c l s r e); assumption.
      + exists c'. split; [exact C'|]. apply (circle_and_other c' l r e s); assumption.
  Qed.
  (* level on both sides is the same function *)
  Lemma level_both : level l s r = at_ (Kg l r) (dir l s r) /\ level l r e = at_ (Kg l r) (dir l r e).
  Proof. split; [|reflexivity]. symmetry. apply (vertex_dir l s r start). Qed.
  (* The edge has no length where both its circles are one. (The circles of an edge that has a length may touch all four, too: cotangent
     does not imply that it has no length, not even where all pairs are right and apart: see LinkCounter.v.) *)
  Lemma no_length_link : dir l s r = dir l r e <-> exists c, vertex_circle c l s r /\ vertex_circle c l r e.
  Proof.
    pose proof start as (W & Rs & Rr & Rsr & Wsr & _). pose proof last as (_ & _ & Re & Rre & Wre & _). split.
    - intros H. destruct (circle_of_vertex l s r pl ps pr start) as (c & C & D & S). exists c. split; [exact C|].
      destruct (circle_of_vertex l r e pl pr pe last) as (c' & C' & D' & S').
      assert (L : level l s r = level l r e) by (destruct level_both as [-> ->]; rewrite H; reflexivity).
      assert (T : touches c e).
      { apply (circle_and_other c l s r e); try assumption. rewrite H, L. symmetry. destruct level_both as [_ ->].
        symmetry. apply (vertex_dir l r e last). }
      destruct C as (Tl & _ & Tr & _). unfold vertex_circle. repeat split; try assumption.
      apply contact_slopes; try assumption. rewrite D, H. replace (opposite (opposite (dir l r e))) with (dir l r e).
      + apply (vertex_dir l r e last).
      + destruct (dir l r e) as [a b]. unfold opposite; simpl. f_equal; ring.
    - intros (c & C & C'). destruct (circle_dir c l s r) as (_ & <- & _); try assumption. apply circle_dir; assumption.
  Qed.
  Lemma no_length_other : dir l s r = dir l r e -> ~ not_cotangent l r s e.
  Proof.
    intros H. apply no_length_link in H as (c & C & C'). pose proof C as (_ & Ts & _). pose proof C' as (_ & _ & Te & _).
    intros [(d & D & N)|(d & D & N)]; apply N.
    - rewrite (one_circle d c l s r); assumption.
    - rewrite (one_circle d c l r e); assumption.
  Qed.
  (* The converse holds for one circle: a circle of the start that touches e, too, beyond r, is that of the end. *)
  Lemma no_length_if : at_ (Kg l e) (dir l s r) = level l s r -> slope (Kg l r) (dir l s r) <= slope (Kg l e) (dir l s r) -> dir l s r = dir l r e.
  Proof.
    intros H S. pose proof start as (W & Rs & Rr & Rsr & Wsr & _). pose proof last as (_ & _ & Re & Rre & Wre & _).
    destruct (circle_of_vertex l s r pl ps pr start) as (c & C & D & _).
    assert (O : opposite (contact c l) = dir l s r) by (rewrite D; destruct (dir l s r) as [a b]; unfold opposite; simpl; f_equal; ring).
    assert (T : touches c e) by (apply (circle_and_other c l s r e); assumption).
    pose proof C as (Tl & _ & Tr & _). apply no_length_link. exists c. split; [exact C|].
    destruct (contact_unit c l r) as [Ul Ur]; try assumption. destruct (contact_unit c l e) as [_ Ue]; try assumption.
    assert (Wl : forall g, wall l && wall g = false) by (intros g; rewrite W; reflexivity).
    destruct (ccw_total (contact c l) (contact c r) (contact c e)) as [G|G]; try assumption; try (apply contacts_differ; auto).
    - unfold vertex_circle. repeat split; try assumption.
    - exfalso. assert (K : counterclockwise c l e r) by exact G. apply contact_slopes in K; try assumption; [|rewrite andb_comm; exact Wre|apply right_turn; exact Rre].
      rewrite O in K. lra.
  Qed.
End Edge.
