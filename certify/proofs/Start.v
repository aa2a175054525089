(* The check that the initial diagram is the Voronoi diagram at time 0: all pairs are right, and along each edge every circle is empty
   of all generators. Its soundness is proved here, too. *)
From Coq Require Import ZArith List Bool FMapPositive Reals Lra.
From Voroproof Require Import Forms Polynomial Geometry Circle Vertex Scale Piece PieceSound EdgeSound History Replay LifeSound Initial InitialSound
  Arc Cyclic Cover Spread Envelope Link Short Topology.
Import ListNotations.
Open Scope Z_scope.

(* A rational direction is a point (X / Z, Y / Z) of the unit circle; half its angle has the direction (b, a). *)
Record point := Point { px : Z; py : Z; pz : Z }.
Definition doubled (h : Z * Z) : point := let (b, a) := h in Point (b * b - a * a) (2 * (a * b)) (a * a + b * b).

(* The chord from v to w, as a function that is positive right of it: rx u_x + ry u_y + rs. *)
Definition line (v w : point) : row Z :=
  Row (py w * pz v - py v * pz w) (px v * pz w - px w * pz v) (py v * px w - px v * py w) 0.

(* The vertex [l,j,k], seen from l, lies right of a chord; wjk says that j or k is the container. *)
Definition right_of (wjk : bool) (j k e : row Z) : bool :=
  let a := z_a j k e in let b := z_b j k e in let c := z_c j k e in
  sum_positive_at (z_f a b c) (- z_g j k a b) (with_sign (negb wjk) c).

(* The arc of the edge lies within that from w1 to w2; w3 lies on it. *)
Definition arc_within (w1 w3 w2 : point) (wsr wre : bool) (s r e : row Z) : bool :=
  let k := line w1 w2 in
  (0 <? pz w1) && (0 <? pz w3) && (0 <? pz w2) && (0 <? rx k * px w3 + ry k * py w3 + rs k * pz w3) &&
  right_of wsr s r (line w1 w3) && right_of wre r e (line w3 w2).

(* The direction in which K_r - K_g is least lies left of the chord k. [square] is the square of rs k, [along] is the linear part of k at
   the centre of r. *)
Definition least_off (k : row Z) (square along : Z) (wr : bool) (r : row Z) (wg : bool) (g : row Z) : bool :=
  let x := with_sign (negb (xorb wr wg)) (rp g * along - rp r * (rx k * rx g + ry k * ry g)) in
  let n := fun _ : Datatypes.unit => let a := rx r * rp g - rx g * rp r in let b := ry r * rp g - ry g * rp r in a * a + b * b in
  if rs k <? 0 then (x <=? 0) || (x * x <? square * n tt) else (x <? 0) && (square * n tt <? x * x).

(* The hints; they are believed by nobody. The root of n, rounded. *)
Fixpoint at_least_root (fuel : nat) (n p : Z) : Z :=
  match fuel with O => p | S fuel => if p * p <? n then at_least_root fuel n (p * 65536) else p end.
Fixpoint newton (fuel : nat) (n p : Z) : Z :=
  match fuel with O => p | S fuel => let q := (p + n / p) / 2 in if q <? p then newton fuel n q else p end.
Definition near_root (n : Z) : Z := newton 200 n (at_least_root 1000 n 1).

(* Half the direction of the vertex [l,j,k], of a length between m and 2 m. *)
Definition half_direction (m : Z) (wjk : bool) (j k : row Z) : Z * Z :=
  let x := dxp Z.sub Z.mul j k in let y := dyp Z.sub Z.mul j k in let s := dsp Z.sub Z.mul j k in
  let n := x * x + y * y in
  let root := with_sign wjk (near_root ((n - s * s) * (m * m))) in
  let u := - (s * x * m) - root * y in let v := root * x - s * y * m in
  let '(b, a) := if 0 <=? u then (n * m + u, v) else (v, n * m - u) in
  let big := Z.max 1 (Z.max (Z.abs a) (Z.abs b)) in
  (b * m / big, a * m / big).

(* Half the direction of the middle of the arc between two, the first being its start. *)
Definition half_middle (p e : Z * Z) : Z * Z :=
  let (bp, ap) := p in
  let '(be, ae) := if bp * snd e - ap * fst e <? 0 then (- fst e, - snd e) else e in
  if 0 <=? bp * be + ap * ae then (bp + be, ap + ae) else (ae - ap, bp - be).

(* A direction rounded, and turned a little. *)
Definition turned_by (m fine c : Z) (h : Z * Z) : Z * Z :=
  let (b, a) := h in ((m * b - c * a) / fine, (m * a + c * b) / fine).

Definition hints (m : Z) (wsr wre : bool) (s r e : row Z) : (Z * Z) * (Z * Z) * (Z * Z) :=
  let fine := m * m * m * m in
  let p := half_direction fine wsr s r in let q := half_direction fine wre r e in
  (turned_by m fine (-2) p, half_middle p q, turned_by m fine 2 q).

(* Hints become finer and finer; each level is tried for the generators that those before it leave open. *)
Definition levels : list Z := [2 ^ 10; 2 ^ 20; 2 ^ 40; 2 ^ 80; 2 ^ 160; 2 ^ 320].
Fixpoint edge_clear (levels : list Z) (r_id : gen) (ws wr we : bool) (s r e : row Z) (others : list (gen * (bool * row Z))) : bool :=
  match levels with
  | [] => false
  | m :: levels =>
      let '(h1, h3, h2) := hints m (ws || wr) (wr || we) s r e in
      let w1 := doubled h1 in let w3 := doubled h3 in let w2 := doubled h2 in
      let rest :=
        if arc_within w1 w3 w2 (ws || wr) (wr || we) s r e then
          let k := line w1 w2 in let square := rs k * rs k in let along := rx k * rx r + ry k * ry r in
          filter (fun g => negb (Pos.eqb (fst g) r_id || least_off k square along wr r (fst (snd g)) (snd (snd g)))) others
        else others in
      match rest with [] => true | _ => edge_clear levels r_id ws wr we s r e rest end
  end.

Section Start.
Variable P : problem.

(* The edge q, whose base is the disk i: its circles are one, or it is clear of all the others. *)
Definition edge_start (i : moving) (others : list (gen * (bool * row Z))) (q : edge) : bool :=
  match find_still P (er q), find_still P (es q), find_still P (ee q) with
  | Some r, Some s, Some e =>
      (fan_tied i s r e && fan_short i s r e && fan_there i s r e) ||
      edge_clear levels (er q) (mwall s) (mwall r) (mwall e) (zrow i s) (zrow i r) (zrow i e) others
  | _, _, _ => false
  end.

Definition distinct_names (q : edge) : bool :=
  negb (Pos.eqb (el q) (er q)) && negb (Pos.eqb (el q) (es q)) && negb (Pos.eqb (er q) (es q)) &&
  negb (Pos.eqb (el q) (ee q)) && negb (Pos.eqb (er q) (ee q)).

(* The edges that have g at a side, seen from g. *)
Definition seen_from_it (g : gen) (qs : list edge) : list edge :=
  flat_map (fun q => if Pos.eqb (el q) g then [q] else if Pos.eqb (er q) g then [reversed q] else []) qs.

Definition right_sign (w : bool) (p : Z) : bool := if w then p <? 0 else 0 <? p.

Definition disk_start (all : list (gen * moving)) (qs : list edge) (g : gen * moving) : bool :=
  let mine := seen_from_it (fst g) qs in
  match mine with
  | [] => false
  | _ =>
      if mwall (snd g) then true
      else
        let others := flat_map (fun h => if Pos.eqb (fst h) (fst g) then [] else [(fst h, (mwall (snd h), zrow (snd g) (snd h)))]) all in
        forallb (fun h => right_sign (fst (snd h)) (rp (snd (snd h)))) others && forallb (edge_start (snd g) others) mine
  end.

Definition start_ok : bool :=
  let all := all_still P in
  let qs := map snd (PositiveMap.elements (edges P)) in
  forallb (fun g => is_proper (snd g)) all && forallb distinct_names qs && forallb (disk_start all qs) all.
End Start.

Open Scope R_scope.

(* Rational directions. *)
Definition direction (w : point) : vec := Vec (IZR (px w) / IZR (pz w)) (IZR (py w) / IZR (pz w)).

Lemma doubled_unit h : (0 < pz (doubled h))%Z -> unit (direction (doubled h)).
Proof.
  destruct h as [b a]. unfold doubled, direction, unit; cbn [px py pz vx vy]. intros H. apply IZR_lt in H. revert H.
  rewrite plus_IZR, minus_IZR, !mult_IZR. generalize (IZR a) (IZR b). intros x y H. field. lra.
Qed.

Lemma line_is v w u : (0 < pz v)%Z -> (0 < pz w)%Z ->
  IZR (rx (line v w)) * vx u + IZR (ry (line v w)) * vy u + IZR (rs (line v w)) = IZR (pz v) * IZR (pz w) * chord (direction v) (direction w) u.
Proof.
  intros Hv Hw. apply IZR_lt in Hv, Hw. unfold line, chord, cross, minus, direction; cbn [rx ry rs vx vy].
  rewrite !minus_IZR, !mult_IZR. field. lra.
Qed.

Lemma line_ccw v w u : (0 < pz v)%Z -> (0 < pz w)%Z ->
  0 < IZR (rx (line v w)) * vx u + IZR (ry (line v w)) * vy u + IZR (rs (line v w)) -> ccw (direction v) u (direction w).
Proof.
  intros Hv Hw H. rewrite line_is in H by assumption. apply IZR_lt in Hv, Hw. pose proof (Rmult_lt_0_compat _ _ Hv Hw) as Pos.
  unfold ccw. change (0 < chord (direction v) (direction w) u). apply Rnot_le_lt. intros L.
  assert (0 <= IZR (pz v) * IZR (pz w) * - chord (direction v) (direction w) u) by (apply Rmult_le_pos; lra). lra.
Qed.

(* The order of all: from w1 the start, w3, the end, w2, the least direction m. *)
Lemma least_outside w1 p w3 e w2 m : unit w1 -> unit p -> unit w3 -> unit e -> unit w2 -> unit m ->
  ccw w1 p w3 -> ccw w3 e w2 -> ccw w1 w3 w2 -> ccw w1 w2 m -> chord p e m < 0.
Proof.
  intros U1 Up U3 Ue U2 Um A B C D.
  assert (E : ccw w3 w2 w1) by (apply ccw_turn, C).
  assert (F : ccw w1 w3 e) by (apply ccw_turn, ccw_turn; apply (ccw_trans w3 e w2 w1); assumption).
  assert (G : ccw w1 e w2).
  { assert (T : ccw w2 w3 e) by (apply ccw_turn, ccw_turn, B). assert (T' : ccw w2 w1 w3) by (apply ccw_turn, E).
    apply ccw_turn, (ccw_trans w2 w1 w3 e); assumption. }
  assert (H : ccw w1 e m) by (apply (ccw_trans w1 e w2 m); assumption).
  assert (I : ccw w1 p e) by (apply (ccw_trans w1 p w3 e); assumption).
  assert (J : ccw p e m).
  { assert (T : ccw e w1 p) by (apply ccw_turn, ccw_turn, I). assert (T' : ccw e m w1) by (apply ccw_turn, H).
    apply ccw_turn, ccw_turn. apply (ccw_trans e m w1 p); assumption. }
  unfold ccw in J. unfold chord. revert J. unfold cross, minus; simpl. lra.
Qed.

(* The direction of a vertex is that of Circle.v. *)
Section Direction.
  Variables l j k : generator.
  Hypothesis disk : wall l = false.
  Hypothesis one_wall : wall j && wall k = false.
  Hypothesis rj : right_pair l j.
  Hypothesis rk : right_pair l k.
  Hypothesis rjk : right_pair j k.
  Let a := seen_from l j.
  Let b := seen_from l k.

  Lemma right_row g : right_pair l g -> right (wall g) (rp (seen_from l g)).
  Proof. intros H. apply right_tang in H. rewrite disk in H. exact H. Qed.

  Lemma right_gamma : 0 < gamma a b.
  Proof.
    apply gamma_positive; try assumption; try (apply right_row; assumption).
    apply (right_tang2 l) in rjk. unfold right, tangency; simpl. unfold tang2 in rjk; simpl in rjk. exact rjk.
  Qed.

  Let sigma := sign_of (wall j || wall k).
  Lemma sigma_square : sigma * sigma = 1.
  Proof. apply sign_square. Qed.

  Definition direct : vec :=
    Vec (nx (cx j - cx l) (cy j - cy l) (radius j - radius l) (cx k - cx l) (cy k - cy l) (radius k - radius l) sigma)
        (ny (cx j - cx l) (cy j - cy l) (radius j - radius l) (cx k - cx l) (cy k - cy l) (radius k - radius l) sigma).

  Lemma sigma_product : 0 < sigma * (rp a * rp b).
  Proof.
    pose proof (right_row j rj) as Hj. pose proof (right_row k rk) as Hk. fold a in Hj. fold b in Hk. unfold right in *. unfold sigma, sign_of.
    revert Hj Hk one_wall. generalize (rp a) (rp b). intros x y Hj Hk O. destruct (wall j), (wall k); simpl in *; try discriminate.
    - replace (-1 * (x * y)) with (- x * y) by ring. apply Rmult_lt_0_compat; lra.
    - replace (-1 * (x * y)) with (x * - y) by ring. apply Rmult_lt_0_compat; lra.
    - rewrite Rmult_1_l. apply Rmult_lt_0_compat; lra.
  Qed.

  Lemma dir_is : dir l j k = direct.
  Proof.
    exact (proj2 (Short.dir_is l j k sigma sigma_square sigma_product right_gamma)).
  Qed.
End Direction.

Lemma right_of_true i j k e :
  wall (at_z i 0) = false -> mwall j && mwall k = false -> right_pair (at_z i 0) (at_z j 0) -> right_pair (at_z i 0) (at_z k 0) -> right_pair (at_z j 0) (at_z k 0) ->
  rp e = 0%Z -> right_of (mwall j || mwall k) (zrow i j) (zrow i k) e = true ->
  0 < IZR (rx e) * vx (dir (at_z i 0) (at_z j 0) (at_z k 0)) + IZR (ry e) * vy (dir (at_z i 0) (at_z j 0) (at_z k 0)) + IZR (rs e).
Proof.
  intros W O Rj Rk Rjk Pe H. rewrite dir_is by assumption. unfold direct; cbn [vx vy].
  pose proof (right_gamma (at_z i 0) (at_z j 0) (at_z k 0) W O Rj Rk Rjk) as G.
  assert (N : 0 < Circle.norm (seen_from (at_z i 0) (at_z j 0)) (seen_from (at_z i 0) (at_z k 0))) by (apply norm_positive; exact G).
  pose proof (third _ _ _ _ _ _ (sign_of (mwall j || mwall k)) G (row_map IZR e)) as T. cbv zeta in T.
  unfold right_of in H. cbv zeta in H. apply (sum_positive_at_true _ _ _ _ _ (sqrt_lt_R0 _ G) N) in H.
  - rewrite opp_IZR, with_sign_is, int_g, int_a, int_b, int_c, !zrow_at in H.
    change (rrow (cx (at_z j 0) - cx (at_z i 0)) (cy (at_z j 0) - cy (at_z i 0)) (radius (at_z j 0) - radius (at_z i 0))) with (seen_from (at_z i 0) (at_z j 0)) in T.
    change (rrow (cx (at_z k 0) - cx (at_z i 0)) (cy (at_z k 0) - cy (at_z i 0)) (radius (at_z k 0) - radius (at_z i 0))) with (seen_from (at_z i 0) (at_z k 0)) in T.
    assert (Neg : sign_of (negb (mwall j || mwall k)) = - sign_of (mwall j || mwall k)) by (destruct (mwall j || mwall k); simpl; lra).
    rewrite Neg in H. cbn [row_map rx ry rs rp] in T, H. rewrite Pe in T. change (wall (at_z j 0)) with (mwall j). change (wall (at_z k 0)) with (mwall k).
    apply (Rmult_lt_reg_l _ _ _ N). rewrite Rmult_0_r. revert H T. cbn [row_map]. 
    match goal with |- context [nx ?a ?b ?c ?d ?e ?f ?g] => generalize (nx a b c d e f g) (ny a b c d e f g) end. intros mx my.
    intros H T. lra.
  - rewrite sqrt_sqrt by lra. rewrite opp_IZR, with_sign_is, int_f, int_g, int_a, int_b, int_c, !zrow_at.
    rewrite <- incircle_product by (apply gamma_is).
    match goal with |- - ?g * - ?g - ?m * (?t * ?c * (?t * ?c)) = _ => replace (- g * - g - m * (t * c * (t * c))) with (g * g - t * t * (m * (c * c))) by ring end.
    rewrite sign_square. ring.
Qed.

(* The least direction. *)
Lemma least_off_true i r g k square along :
  wall (at_z i 0) = false -> mwall r && mwall g = false -> right_pair (at_z i 0) (at_z r 0) -> right_pair (at_z i 0) (at_z g 0) -> right_pair (at_z r 0) (at_z g 0) ->
  square = (rs k * rs k)%Z -> along = (rx k * rx (zrow i r) + ry k * ry (zrow i r))%Z ->
  least_off k square along (mwall r) (zrow i r) (mwall g) (zrow i g) = true ->
  let f := diff (Kg (at_z i 0) (at_z r 0)) (Kg (at_z i 0) (at_z g 0)) in
  0 < Arc.norm f /\ IZR (rx k) * vx (least f) + IZR (ry k) * vy (least f) + IZR (rs k) < 0.
Proof.
  intros W O Rr Rg Rrg -> -> H f.
  assert (Sp : 0 < sign_of (xorb (mwall r) (mwall g)) * (tang (seen_at (at_z i 0) (at_z r 0)) * tang (seen_at (at_z i 0) (at_z g 0)))).
  { pose proof (sigma_product (at_z i 0) (at_z r 0) (at_z g 0) W O Rr Rg) as Q. rewrite sign_xor. change (wall (at_z r 0)) with (mwall r) in Q. change (wall (at_z g 0)) with (mwall g) in Q.
    change (rp (seen_from (at_z i 0) (at_z r 0))) with (tang (seen_at (at_z i 0) (at_z r 0))) in Q.
    change (rp (seen_from (at_z i 0) (at_z g 0))) with (tang (seen_at (at_z i 0) (at_z g 0))) in Q.
    destruct (mwall r), (mwall g); simpl in *; try discriminate; lra. }
  assert (C : crosses f).
  { apply difference_crosses; try assumption; [rewrite andb_comm; exact O|apply right_turn, Rrg]. }
  assert (Nf : 0 < Arc.norm f).
  { unfold crosses in C. apply sqrt_lt_R0. pose proof (sq (fb f)). lra. }
  split; [exact Nf|].
  unfold least_off in H. cbv zeta in H.
  set (x := with_sign _ _) in H. set (n := (_ + _)%Z) in H.
  set (s := sign_of (xorb (mwall r) (mwall g))) in *. set (D := tang (seen_at (at_z i 0) (at_z r 0)) * tang (seen_at (at_z i 0) (at_z g 0))) in *.
  assert (S1 : s * s = 1) by apply sign_square.
  pose proof (zrow_at i r) as Zr. pose proof (zrow_at i g) as Zg.
  assert (Er : IZR (rx (zrow i r)) = xx (seen_at (at_z i 0) (at_z r 0)) /\ IZR (ry (zrow i r)) = xy (seen_at (at_z i 0) (at_z r 0)) /\ IZR (rp (zrow i r)) = tang (seen_at (at_z i 0) (at_z r 0))).
  { apply (f_equal (fun q => (rx q, ry q, rp q))) in Zr. injection Zr as X Y Q. tauto. }
  assert (Eg : IZR (rx (zrow i g)) = xx (seen_at (at_z i 0) (at_z g 0)) /\ IZR (ry (zrow i g)) = xy (seen_at (at_z i 0) (at_z g 0)) /\ IZR (rp (zrow i g)) = tang (seen_at (at_z i 0) (at_z g 0))).
  { apply (f_equal (fun q => (rx q, ry q, rp q))) in Zg. injection Zg as X Y Q. tauto. }
  destruct Er as (Xr & Yr & Pr). destruct Eg as (Xg & Yg & Pg).
  assert (Nr : tang (seen_at (at_z i 0) (at_z r 0)) <> 0) by (intros Z; unfold D in Sp; rewrite Z in Sp; lra).
  assert (Ng : tang (seen_at (at_z i 0) (at_z g 0)) <> 0) by (intros Z; unfold D in Sp; rewrite Z in Sp; lra).
  set (A := vx (fa f) * D). set (B := vy (fa f) * D).
  assert (En : IZR n = A * A + B * B).
  { unfold n. rewrite plus_IZR, !mult_IZR, !minus_IZR, !mult_IZR, Xr, Yr, Pr, Xg, Yg, Pg. unfold A, B, D, f, diff, minus, Kg, K; cbn [fa vx vy]. field. split; assumption. }
  assert (Ex : IZR x = - s * (IZR (rx k) * A + IZR (ry k) * B)).
  { unfold x. rewrite with_sign_is, minus_IZR, !mult_IZR, !plus_IZR, !mult_IZR, Xr, Yr, Pr, Xg, Yg, Pg.
    assert (Sn : sign_of (negb (xorb (mwall r) (mwall g))) = - s) by (unfold s; destruct (xorb (mwall r) (mwall g)); simpl; lra).
    rewrite Sn. unfold A, B, D, f, diff, minus, Kg, K; cbn [fa vx vy]. field. split; assumption. }
  set (w := Arc.norm f * (s * D)).
  assert (Pw : 0 < w) by (apply Rmult_lt_0_compat; assumption).
  assert (Ew : w * w = IZR n).
  { rewrite En. unfold w, A, B. replace (Arc.norm f * (s * D) * (Arc.norm f * (s * D))) with (s * s * (Arc.norm f * Arc.norm f) * (D * D)) by ring.
    rewrite S1, norm_square. ring. }
  assert (V : (IZR (rx k) * vx (least f) + IZR (ry k) * vy (least f) + IZR (rs k)) * w = IZR x + IZR (rs k) * w).
  { rewrite Ex. unfold w, A, B, least; cbn [vx vy]. field. lra. }
  assert (M : IZR x + IZR (rs k) * w < 0).
  { destruct (rs k <? 0)%Z eqn:Hk.
    - apply Z.ltb_lt, IZR_lt in Hk. assert (0 < - IZR (rs k) * w) by (apply Rmult_lt_0_compat; lra).
      apply orb_prop in H as [H|H].
      + apply Z.leb_le, IZR_le in H. lra.
      + apply Z.ltb_lt, IZR_lt in H. rewrite !mult_IZR, <- Ew in H. apply Rnot_le_lt. intros L.
        assert ((- IZR (rs k) * w) * (- IZR (rs k) * w) <= IZR x * IZR x) by (apply Rmult_le_compat; lra). lra.
    - apply Z.ltb_ge, IZR_le in Hk. assert (0 <= IZR (rs k) * w) by (apply Rmult_le_pos; lra).
      apply andb_prop in H as [Hx H]. apply Z.ltb_lt, IZR_lt in Hx. apply Z.ltb_lt, IZR_lt in H. rewrite !mult_IZR, <- Ew in H.
      apply Rnot_le_lt. intros L. assert (- IZR x * - IZR x <= (IZR (rs k) * w) * (IZR (rs k) * w)) by (apply Rmult_le_compat; lra). lra. }
  rewrite <- V in M. apply Rnot_le_lt. intros L.
  assert (0 <= (IZR (rx k) * vx (least f) + IZR (ry k) * vy (least f) + IZR (rs k)) * w) by (apply Rmult_le_pos; lra). lra.
Qed.

(* The tests of an edge. *)
Lemma edge_clear_true ls r_id ws wr we s r e others : edge_clear ls r_id ws wr we s r e others = true ->
  forall g, In g others -> fst g <> r_id -> exists h1 h3 h2,
    arc_within (doubled h1) (doubled h3) (doubled h2) (ws || wr) (wr || we) s r e = true /\
    let k := line (doubled h1) (doubled h2) in
    least_off k (rs k * rs k) (rx k * rx r + ry k * ry r) wr r (fst (snd g)) (snd (snd g)) = true.
Proof.
  revert others. induction ls as [|m ls IH]; intros others H g I N; [discriminate|]. cbn [edge_clear] in H.
  destruct (hints m (ws || wr) (wr || we) s r e) as [[h1 h3] h2]. cbv zeta in H.
  destruct (arc_within (doubled h1) (doubled h3) (doubled h2) (ws || wr) (wr || we) s r e) eqn:A.
  - match type of H with match filter ?t others with _ => _ end = _ => set (test := t) in H; destruct (test g) eqn:T end.
    + assert (J : In g (filter test others)) by (apply filter_In; split; assumption).
      destruct (filter test others) as [|x rest]; [destruct J|]. apply (IH _ H g J N).
    + exists h1, h3, h2. split; [exact A|]. unfold test in T. apply negb_false_iff, orb_prop in T as [T|T]; [apply Pos.eqb_eq in T; contradiction|exact T].
  - destruct others as [|x rest]; [destruct I|]. apply (IH _ H g I N).
Qed.

Lemma chord_within i s r e w1 w3 w2 :
  wall (at_z i 0) = false -> vertex (at_z i 0) (at_z s 0) (at_z r 0) -> vertex (at_z i 0) (at_z r 0) (at_z e 0) ->
  arc_within w1 w3 w2 (mwall s || mwall r) (mwall r || mwall e) (zrow i s) (zrow i r) (zrow i e) = true ->
  let p := dir (at_z i 0) (at_z s 0) (at_z r 0) in let q := dir (at_z i 0) (at_z r 0) (at_z e 0) in
  (0 < pz w1)%Z /\ (0 < pz w3)%Z /\ (0 < pz w2)%Z /\ ccw (direction w1) p (direction w3) /\ ccw (direction w3) q (direction w2) /\
  ccw (direction w1) (direction w3) (direction w2).
Proof.
  intros W (_ & Rs & Rr & Rsr & Osr & _) (_ & _ & Re & Rre & Ore & _) H p q. unfold arc_within in H. cbv zeta in H.
  apply andb_prop in H as [H Q]. apply andb_prop in H as [H S]. apply andb_prop in H as [H M]. apply andb_prop in H as [H Z2]. apply andb_prop in H as [Z1 Z3].
  apply Z.ltb_lt in Z1, Z2, Z3, M.
  split; [exact Z1|]. split; [exact Z3|]. split; [exact Z2|]. split; [|split].
  - apply line_ccw; [exact Z1|exact Z3|]. apply right_of_true; try assumption; reflexivity.
  - apply line_ccw; [exact Z3|exact Z2|]. apply right_of_true; try assumption; reflexivity.
  - apply line_ccw; [exact Z1|exact Z2|]. apply IZR_lt in M. rewrite !plus_IZR, !mult_IZR in M. apply IZR_lt in Z3.
    unfold direction; cbn [vx vy]. revert M Z3. generalize (IZR (pz w3)) (IZR (px w3)) (IZR (py w3)) (IZR (rx (line w1 w2))) (IZR (ry (line w1 w2))) (IZR (rs (line w1 w2))).
    intros z x y a b c M Z3. replace (a * (x / z) + b * (y / z) + c) with ((a * x + b * y + c * z) / z) by (field; lra). apply Rdiv_lt_0_compat; assumption.
Qed.

(* K_r is at least K_g along the arc. *)
Lemma along_arc i s r e g w1 w3 w2 u (p := dir (at_z i 0) (at_z s 0) (at_z r 0)) (q := dir (at_z i 0) (at_z r 0) (at_z e 0)) :
  wall (at_z i 0) = false -> vertex (at_z i 0) (at_z s 0) (at_z r 0) -> vertex (at_z i 0) (at_z r 0) (at_z e 0) ->
  mwall r && mwall g = false -> right_pair (at_z i 0) (at_z g 0) -> right_pair (at_z r 0) (at_z g 0) ->
  unit (direction w1) -> unit (direction w3) -> unit (direction w2) ->
  arc_within w1 w3 w2 (mwall s || mwall r) (mwall r || mwall e) (zrow i s) (zrow i r) (zrow i e) = true ->
  (let k := line w1 w2 in least_off k (rs k * rs k) (rx k * rx (zrow i r) + ry k * ry (zrow i r)) (mwall r) (zrow i r) (mwall g) (zrow i g) = true) ->
  at_ (Kg (at_z i 0) (at_z g 0)) p <= at_ (Kg (at_z i 0) (at_z r 0)) p -> at_ (Kg (at_z i 0) (at_z g 0)) q <= at_ (Kg (at_z i 0) (at_z r 0)) q ->
  unit u -> 0 <= chord p q u -> at_ (Kg (at_z i 0) (at_z g 0)) u <= at_ (Kg (at_z i 0) (at_z r 0)) u.
Proof.
  intros W Vs Ve O Rg Rrg U1 U3 U2 H T Hp Hq Uu C.
  destruct (chord_within _ _ _ _ _ _ _ W Vs Ve H) as (Z1 & Z3 & Z2 & Cp & Cq & Cw). fold p in Cp. fold q in Cq.
  pose proof (vertex_dir _ _ _ Vs) as [Up _]. pose proof (vertex_dir _ _ _ Ve) as [Uq _]. fold p in Up. fold q in Uq.
  pose proof Ve as (_ & Rr & _).
  destruct (least_off_true i r g (line w1 w2) _ _ W O Rr Rg Rrg eq_refl eq_refl T) as [N L].
  set (f := diff (Kg (at_z i 0) (at_z r 0)) (Kg (at_z i 0) (at_z g 0))) in *.
  assert (F : forall v, at_ f v = at_ (Kg (at_z i 0) (at_z r 0)) v - at_ (Kg (at_z i 0) (at_z g 0)) v).
  { intros v. unfold f, at_, diff, dot, minus; cbn [fa fb vx vy]. ring. }
  pose proof (least_unit f N) as Um.
  assert (D : ccw (direction w1) (direction w2) (least f)).
  { rewrite line_is in L by assumption. apply IZR_lt in Z1, Z2. pose proof (Rmult_lt_0_compat _ _ Z1 Z2) as Pos.
    assert (X : chord (direction w1) (direction w2) (least f) < 0).
    { apply Rnot_le_lt. intros Q. pose proof (Rmult_le_pos _ _ (Rlt_le _ _ Pos) Q). lra. }
    unfold chord in X. unfold ccw. revert X. unfold cross, minus; cbn [vx vy]. lra. }
  assert (Out : chord p q (least f) < 0) by (apply (least_outside (direction w1) p (direction w3) q (direction w2)); assumption).
  assert (0 <= at_ f u); [|rewrite F in *; lra].
  apply (arc_not_negative f p q u); try assumption; try (rewrite F; lra). right. split; assumption.
Qed.

Section Sound.
Variable P : problem.
Let gens := map fst (PositiveMap.elements (bodies P)).
Let cfg := fun g => place P [] 0 g.
Let D := map snd (PositiveMap.elements (edges P)).

Lemma in_gens g : In g gens <-> exists b, PositiveMap.find g (bodies P) = Some b.
Proof.
  unfold gens. rewrite in_map_iff. split.
  - intros ([h b] & E & I). cbn [fst] in E. subst h. exists b. apply PositiveMap.elements_complete, I.
  - intros (b & F). exists (g, b). split; [reflexivity|]. apply PositiveMap.elements_correct, F.
Qed.

Lemma in_all g b : PositiveMap.find g (bodies P) = Some b -> In (g, still b g) (all_still P).
Proof. intros F. apply (in_map (fun b => (fst b, still (snd b) (fst b))) _ (g, b)), PositiveMap.elements_correct, F. Qed.

Lemma in_edges q : In q D <-> exists k, PositiveMap.find k (edges P) = Some q.
Proof.
  unfold D. rewrite in_map_iff. split.
  - intros ([k q'] & E & I). cbn [snd] in E. subst q'. exists k. apply PositiveMap.elements_complete, I.
  - intros (k & F). exists (k, q). split; [reflexivity|]. apply PositiveMap.elements_correct, F.
Qed.

Lemma still_is g b : PositiveMap.find g (bodies P) = Some b -> cfg g = at_z (still b g) 0.
Proof. intros F. symmetry. apply still_at, F. Qed.

Lemma still_wall g b : mwall (still b g) = Pos.eqb g container.
Proof. reflexivity. Qed.

Lemma cfg_wall g : wall (cfg g) = Pos.eqb g container.
Proof. reflexivity. Qed.

Hypothesis initial : true_initial P.
Hypothesis ok : start_ok P = true.

Lemma proper_all g : In g gens -> proper (cfg g).
Proof.
  intros I. apply in_gens in I as (b & F). rewrite (still_is g b F). apply proper_at; [lra|].
  unfold start_ok in ok. cbv zeta in ok. apply andb_prop in ok as [H _]. apply andb_prop in H as [H _]. rewrite forallb_forall in H.
  apply (H _ (in_all g b F)).
Qed.

Lemma names q : In q D -> el q <> er q /\ el q <> es q /\ er q <> es q /\ el q <> ee q /\ er q <> ee q.
Proof.
  intros I. unfold start_ok in ok. cbv zeta in ok. apply andb_prop in ok as [H _]. apply andb_prop in H as [_ H]. rewrite forallb_forall in H.
  specialize (H q I). unfold distinct_names in H. apply andb_prop in H as [H E5]. apply andb_prop in H as [H E4]. apply andb_prop in H as [H E3].
  apply andb_prop in H as [E1 E2]. apply negb_true_iff in E1, E2, E3, E4, E5. apply Pos.eqb_neq in E1, E2, E3, E4, E5. tauto.
Qed.

Definition the_others (g : gen) (b : body) : list (gen * (bool * row Z)) :=
  flat_map (fun h => if Pos.eqb (fst h) g then [] else [(fst h, (mwall (snd h), zrow (still b g) (snd h)))]) (all_still P).

Lemma disk_parts g b : PositiveMap.find g (bodies P) = Some b -> seen_from_it g D <> [] /\
  (g <> container -> (forall h, In h (the_others g b) -> right_sign (fst (snd h)) (rp (snd (snd h))) = true) /\
     forall q, In q (seen_from_it g D) -> edge_start P (still b g) (the_others g b) q = true).
Proof.
  intros F. unfold start_ok in ok. cbv zeta in ok. apply andb_prop in ok as [_ H]. rewrite forallb_forall in H.
  specialize (H _ (in_all g b F)). unfold disk_start in H. cbv zeta in H. cbn [fst snd] in H. fold D in H. fold (the_others g b) in H.
  destruct (seen_from_it g D) as [|q0 qs] eqn:E; [discriminate|]. split; [discriminate|]. intros N.
  rewrite still_wall in H. destruct (Pos.eqb_spec g container); [contradiction|]. apply andb_prop in H as [R H]. rewrite forallb_forall in R, H. tauto.
Qed.

Lemma in_others g b h bh : PositiveMap.find h (bodies P) = Some bh -> h <> g ->
  In (h, (mwall (still bh h), zrow (still b g) (still bh h))) (the_others g b).
Proof.
  intros F N. unfold the_others. apply in_flat_map. exists (h, still bh h). split; [apply in_all, F|]. cbn [fst snd].
  destruct (Pos.eqb_spec h g); [contradiction|left; reflexivity].
Qed.

Lemma right_disk_pair g h : In g gens -> In h gens -> g <> container -> h <> g -> right_pair (cfg g) (cfg h).
Proof.
  intros Ig Ih N Nh. apply in_gens in Ig as (b & F). apply in_gens in Ih as (bh & Fh).
  destruct (disk_parts g b F) as [_ R]. destruct (R N) as [R' _]. specialize (R' _ (in_others g b h bh Fh Nh)). cbn [fst snd] in R'.
  rewrite (still_is g b F), (still_is h bh Fh). apply right_tang.
  change (tang (seen_at (at_z (still b g) 0) (at_z (still bh h) 0))) with (rp (seen_from (at_z (still b g) 0) (at_z (still bh h) 0))).
  rewrite <- zrow_at. change (wall (at_z (still b g) 0)) with (Pos.eqb g container). change (wall (at_z (still bh h) 0)) with (mwall (still bh h)).
  destruct (Pos.eqb_spec g container); [contradiction|]. cbn [orb row_map rp]. unfold right_sign in R'.
  destruct (mwall (still bh h)); apply Z.ltb_lt, IZR_lt in R'; exact R'.
Qed.

Lemma right_all g h : In g gens -> In h gens -> g <> h -> right_pair (cfg g) (cfg h).
Proof.
  intros Ig Ih N. destruct (Pos.eq_dec g container) as [E|E].
  - apply right_turn, right_disk_pair; try assumption. congruence.
  - apply right_disk_pair; try assumption. congruence.
Qed.

(* An edge of the diagram, in one of its two directions. *)
Lemma oriented_parts q : In q D \/ In (reversed q) D ->
  (exists k q', PositiveMap.find k (edges P) = Some q' /\ side_of q' (el q) (er q) (ee q) /\ side_of q' (er q) (el q) (es q)) /\
  el q <> er q /\ el q <> es q /\ er q <> es q /\ el q <> ee q /\ er q <> ee q.
Proof.
  intros [I|I]; pose proof (names _ I) as N; apply in_edges in I as (k & F).
  - split; [|exact N]. exists k, q. split; [exact F|]. unfold side_of. tauto.
  - unfold reversed in N; cbn [el er es ee] in N. split; [|intuition congruence]. exists k, (reversed q). split; [exact F|].
    unfold side_of, reversed; cbn [el er es ee]. tauto.
Qed.

Lemma gens_of q : In q D \/ In (reversed q) D -> In (el q) gens /\ In (er q) gens /\ In (es q) gens /\ In (ee q) gens.
Proof.
  intros H. apply oriented_parts in H as [(k & q' & F & S & S') _].
  assert (G : forall g, PositiveMap.find g (bodies P) <> None -> In g gens).
  { intros g Hg. apply in_gens. destruct (PositiveMap.find g (bodies P)) as [b|]; [exists b; reflexivity|congruence]. }
  pose proof (generators_there P initial k q' _ _ _ F S) as (A & B & C). pose proof (generators_there P initial k q' _ _ _ F S') as (_ & _ & E).
  repeat split; apply G; assumption.
Qed.

Lemma two_walls g h : g <> h -> wall (cfg g) && wall (cfg h) = false.
Proof. intros N. rewrite !cfg_wall. destruct (Pos.eqb_spec g container), (Pos.eqb_spec h container); try reflexivity. congruence. Qed.

(* Its two circles are there, and empty of all. *)
Lemma both_empty q : oriented cfg D q ->
  (vertex (cfg (el q)) (cfg (es q)) (cfg (er q)) /\ forall g, In g gens -> g <> el q -> K_at cfg (el q) g (start_of cfg q) <= K_at cfg (el q) (er q) (start_of cfg q)) /\
  (vertex (cfg (el q)) (cfg (er q)) (cfg (ee q)) /\ forall g, In g gens -> g <> el q -> K_at cfg (el q) g (end_of cfg q) <= K_at cfg (el q) (er q) (end_of cfg q)).
Proof.
  intros [I W]. destruct (gens_of q I) as (Gl & Gr & Gs & Ge). destruct (oriented_parts q I) as [(k & q' & F & S & S') (N1 & N2 & N3 & N4 & N5)].
  assert (In_bodies : forall g, In g gens -> PositiveMap.find g (bodies P) <> None).
  { intros g Hg. apply in_gens in Hg as (b & Fb). congruence. }
  pose proof (proper_all _ Gl) as Pl. pose proof (proper_all _ Gr) as Pr. pose proof (proper_all _ Gs) as Ps. pose proof (proper_all _ Ge) as Pe.
  destruct (vertices_empty P initial k q' _ _ _ F S) as (o & V & E). destruct (vertices_empty P initial k q' _ _ _ F S') as (o' & V' & E').
  apply Scale.vertex_turn in V'. fold (cfg (el q)) (cfg (er q)) (cfg (ee q)) in V. fold (cfg (el q)) (cfg (er q)) (cfg (es q)) in V'.
  assert (T : vertex (cfg (el q)) (cfg (er q)) (cfg (ee q))).
  { apply (vertex_of_circle o); try assumption; try (apply right_all; congruence || assumption). apply two_walls; congruence. }
  assert (T' : vertex (cfg (el q)) (cfg (es q)) (cfg (er q))).
  { apply (vertex_of_circle o'); try assumption; try (apply right_all; congruence || assumption). apply two_walls; congruence. }
  destruct (level_both (cfg (el q)) (cfg (er q)) (cfg (es q)) (cfg (ee q)) T') as [L _].
  split; split; [exact T'| |exact T|]; intros g Ig Ng.
  - unfold K_at, start_of. rewrite <- L. apply (circle_and_other o'); try assumption; [apply proper_all, Ig|apply right_all; congruence || assumption|].
    apply E', In_bodies, Ig.
  - unfold K_at, end_of. apply (circle_and_other o); try assumption; [apply proper_all, Ig|apply right_all; congruence || assumption|].
    apply E, In_bodies, Ig.
Qed.

Lemma edge_tested q b : In q D \/ In (reversed q) D -> el q <> container -> PositiveMap.find (el q) (bodies P) = Some b ->
  edge_start P (still b (el q)) (the_others (el q) b) q = true.
Proof.
  intros I N F. destruct (disk_parts (el q) b F) as [_ H]. apply (H N). unfold seen_from_it. apply in_flat_map.
  destruct (oriented_parts q I) as [_ (Nr & _)]. destruct I as [I|I].
  - exists q. split; [exact I|]. rewrite Pos.eqb_refl. left. reflexivity.
  - exists (reversed q). split; [exact I|]. cbn [reversed el er es ee]. destruct (Pos.eqb_spec (er q) (el q)); [congruence|]. rewrite Pos.eqb_refl.
    left. destruct q; reflexivity.
Qed.

Lemma find_still_is g b : PositiveMap.find g (bodies P) = Some b -> find_still P g = Some (still b g).
Proof. intros F. unfold find_still. rewrite F. reflexivity. Qed.

Lemma arc_empty q u g : oriented cfg D q -> unit u -> on_arc (start_of cfg q) (end_of cfg q) u -> In g gens -> g <> el q -> g <> er q ->
  K_at cfg (el q) g u <= K_at cfg (el q) (er q) u.
Proof.
  intros Or Uu A Ig Nl Nr. destruct (both_empty q Or) as [[Vs Es] [Ve Ee]]. destruct Or as [I W].
  destruct A as [[_ ->]|[Np C]]; [apply Es; assumption|].
  destruct (gens_of q I) as (Gl & Gr & Gs & Ge). pose proof (two_walls (er q) g) as Two.
  assert (Nc : el q <> container) by (intros E; rewrite cfg_wall, E in W; discriminate).
  pose proof (right_all (el q) g Gl Ig) as Rg. pose proof (right_all (er q) g Gr Ig) as Rrg.
  pose proof (Es g Ig Nl) as Hs. pose proof (Ee g Ig Nl) as He.
  apply in_gens in Gl as (bl & Fl). apply in_gens in Gr as (br & Fr). apply in_gens in Gs as (bs & Fs). apply in_gens in Ge as (be & Fe). apply in_gens in Ig as (bg & Fg).
  pose proof (edge_tested q bl I Nc Fl) as H. unfold edge_start in H.
  rewrite (find_still_is _ _ Fr), (find_still_is _ _ Fs), (find_still_is _ _ Fe) in H.
  unfold K_at, start_of, end_of in *. rewrite (still_is _ _ Fl), (still_is _ _ Fr), (still_is _ _ Fs), (still_is _ _ Fe), (still_is _ _ Fg) in *.
  apply orb_prop in H as [H|H].
  - exfalso. apply Np. apply andb_prop in H as [H There]. apply andb_prop in H as [Tied Short].
    assert (B : by_fan fan_short_at (still bl (el q)) (still br (er q)) (still bs (es q)) (still be (ee q)) = true).
    { unfold by_fan, fan_short_at, fan_tied_at. change (mwall (still bl (el q))) with (wall (at_z (still bl (el q)) 0)). rewrite W, There, Tied, Short. reflexivity. }
    apply short_true in B. apply no_length_link; try assumption; rewrite <- still_is by assumption; apply proper_all, in_gens; eexists; eassumption.
  - destruct (edge_clear_true _ _ _ _ _ _ _ _ _ H _ (in_others (el q) bl g bg Fg Nl) Nr) as (h1 & h3 & h2 & Arc & Off). cbn [fst snd] in Off.
    pose proof (chord_within _ _ _ _ _ _ _ W Vs Ve Arc) as (Z1 & Z3 & Z2 & _).
    apply (along_arc (still bl (el q)) (still bs (es q)) (still br (er q)) (still be (ee q)) (still bg g) (doubled h1) (doubled h3) (doubled h2) u); try assumption;
      try (apply doubled_unit; assumption).
    + apply Two. congruence.
    + apply Rg. congruence.
    + apply Rrg. congruence.
Qed.

Theorem start_sound_from : voronoi gens cfg D /\ first_fits P gens.
Proof.
  split.
  - constructor.
    + exact right_all.
    + intros q Or. destruct (both_empty q Or) as [[Vs _] [Ve _]]. split; assumption.
    + exact arc_empty.
  - constructor.
    + exact (sides_once P initial).
    + exact (sides_closed P initial).
    + intros k q F. apply names, in_edges. exists k. exact F.
    + intros g Ig. apply in_gens in Ig as (b & F). destruct (disk_parts g b F) as [N _].
      destruct (seen_from_it g D) as [|q0 qs] eqn:E; [congruence|]. assert (I : In q0 (seen_from_it g D)) by (rewrite E; left; reflexivity).
      unfold seen_from_it in I. apply in_flat_map in I as (q & I & H). apply in_edges in I as (k & Fk). exists k, q. split; [exact Fk|].
      destruct (Pos.eqb_spec (el q) g); [left; assumption|]. destruct (Pos.eqb_spec (er q) g); [right; assumption|destruct H].
    + intros k q g F I. assert (J : In q D) by (apply in_edges; exists k; exact F). destruct (gens_of q (or_introl J)) as (A & B & C & E).
      cbn [In] in I. intuition congruence.
Qed.
End Sound.

Theorem start_sound P : initial_ok P = true -> start_ok P = true ->
  let gens := map fst (PositiveMap.elements (bodies P)) in
  voronoi gens (fun g => place P [] 0 g) (map snd (PositiveMap.elements (edges P))) /\ first_fits P gens.
Proof. intros I S. apply start_sound_from; [apply initial_sound, I|exact S]. Qed.
