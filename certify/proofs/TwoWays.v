(* A flip of an edge that has no length: the diagram stays right; and just after it one of the two edges is legal. *)
From Coq Require Import Reals Lra List Bool PArith ZArith.
From Voroproof Require Import Geometry Vertex Scale History Arc Cyclic Cover Spread Envelope Near Link.
Import ListNotations.
Open Scope R_scope.

(* The edge q = [l,r,s,e] after its flip. *)
Definition turned_over (q : edge) : edge := Edge (es q) (ee q) (er q) (el q).

(* Both vertices of the edge [l,r,s,e] have one circle. It touches all four. This says more than [cotangent]: there, the two vertices may
   have two circles that both touch all four, at the two ends of an edge that has a length. *)
Definition one_circle_at (c : circle) (l r s e : generator) : Prop := vertex_circle c l s r /\ vertex_circle c l r e.


(* The circle of the vertex [a,b,c] is there and empty of d. *)
Definition clear (a b c d : generator) : Prop := exists o, vertex_circle o a b c /\ empty_of o d.

Lemma clear_turn a b c d : clear a b c d -> clear b c a d.
Proof. intros (o & V & E). exists o. split; [apply vertex_turn, V|exact E]. Qed.

Lemma legal_clear l r s e : clear l s r e -> clear l r e s -> legal l r s e.
Proof. intros A B. exact (conj A B). Qed.

Lemma opposite_twice u : opposite (opposite u) = u.
Proof. destruct u as [a b]. unfold opposite; simpl. rewrite !Ropp_involutive. reflexivity. Qed.

(* The circle of a vertex touches its base in the direction of the vertex. *)
Lemma vertex_contact c l j k : proper l -> proper j -> proper k -> vertex l j k -> vertex_circle c l j k -> dir l j k = opposite (contact c l).
Proof.
  intros pl pj pk V C. destruct (circle_of_vertex l j k pl pj pk V) as (c' & C' & E & _).
  rewrite (one_circle c c' l j k) by assumption. rewrite E, opposite_twice. reflexivity.
Qed.

(* The edge seen from its other side. *)

(* A clear circle seen from the base. *)
Lemma clear_link l j k e : proper l -> proper j -> proper k -> proper e -> vertex l j k -> right_pair l e ->
  (clear l j k e <-> at_ (Kg l e) (dir l j k) <= at_ (Kg l j) (dir l j k)).
Proof.
  intros pl pj pk pe V R. split.
  - intros (o & C & E). apply (circle_and_other o l j k e) in E; assumption.
  - intros H. destruct (circle_of_vertex l j k pl pj pk V) as (c & C & _). exists c. split; [exact C|].
    apply (circle_and_other c l j k e); assumption.
Qed.

(* What touches a circle leaves it empty. *)
Lemma touching_empty c g : touches c g -> empty_of c g.
Proof. unfold touches, empty_of. lra. Qed.

Lemma reversed_twice q : reversed (reversed q) = q.
Proof. destruct q; reflexivity. Qed.

(* Four generators of one instant, that one circle touches in the order l, s, r, e. *)
Section Four.
  Variable gens : list gen.
  Variable cfg : gen -> generator.
  Hypothesis W : forall g, wall (cfg g) = Pos.eqb g container.
  Hypothesis P : forall g, In g gens -> proper (cfg g).
  Hypothesis Right : forall g h, In g gens -> In h gens -> g <> h -> right_pair (cfg g) (cfg h).

  Lemma one_wall g h : g <> h -> wall (cfg g) && wall (cfg h) = false.
  Proof.
    intros N. rewrite !W. destruct (Pos.eqb_spec g container) as [->|]; [|reflexivity]. rewrite andb_true_l. apply Pos.eqb_neq. congruence.
  Qed.

  Lemma a_disk g h : g <> h -> wall (cfg g) = false \/ wall (cfg h) = false.
  Proof. intros N. apply andb_false_iff, one_wall, N. Qed.

  Lemma circle_apart o a b c : vertex_circle o (cfg a) (cfg b) (cfg c) -> a <> b /\ b <> c /\ a <> c.
  Proof.
    intros (_ & _ & _ & C). unfold counterclockwise in C. repeat split; intros ->; lra.
  Qed.

  Lemma vertex_at o a b c : In a gens -> In b gens -> In c gens -> wall (cfg a) = false -> vertex_circle o (cfg a) (cfg b) (cfg c) ->
    vertex (cfg a) (cfg b) (cfg c).
  Proof.
    intros Ia Ib Ic D V. destruct (circle_apart _ _ _ _ V) as (N1 & N2 & N3).
    apply (vertex_of_circle o); auto using one_wall.
  Qed.

  Lemma touching_unit o a b : In a gens -> In b gens -> a <> b -> touches o (cfg a) -> touches o (cfg b) ->
    unit (contact o (cfg a)) /\ unit (contact o (cfg b)).
  Proof.
    intros Ia Ib N Ta Tb. destruct (a_disk a b N) as [D|D].
    - apply contact_unit; auto.
    - destruct (contact_unit o (cfg b) (cfg a)); auto.
  Qed.

  Variables l r s e : gen.
  Hypothesis Il : In l gens. Hypothesis Ir : In r gens. Hypothesis Is : In s gens. Hypothesis Ie : In e gens.
  Variable z : circle.
  Hypothesis Z : one_circle_at z (cfg l) (cfg r) (cfg s) (cfg e).

  Lemma apart_ends : s <> e.
  Proof.
    destruct Z as [(_ & _ & _ & A) (_ & _ & _ & B)]. intros E. unfold counterclockwise in *. rewrite E in A. lra.
  Qed.

  (* The circle is that of the two vertices of the edge after the flip. *)
  Lemma one_circle_after : one_circle_at z (cfg s) (cfg e) (cfg r) (cfg l).
  Proof.
    destruct Z as [A B]. destruct (circle_apart _ _ _ _ A) as (N1 & N2 & N3). destruct (circle_apart _ _ _ _ B) as (N4 & N5 & N6).
    destruct A as (Tl & Ts & Tr & A). destruct B as (_ & _ & Te & B).
    destruct (touching_unit z l r) as [Ul Ur]; auto. destruct (touching_unit z l s) as [_ Us]; auto. destruct (touching_unit z l e) as [_ Ue]; auto.
    apply counterclockwise_is in A, B.
    assert (C : ccw (contact z (cfg l)) (contact z (cfg s)) (contact z (cfg e))) by (apply (ccw_trans _ _ (contact z (cfg r))); assumption).
    assert (D : ccw (contact z (cfg r)) (contact z (cfg e)) (contact z (cfg s))).
    { apply (ccw_trans _ _ (contact z (cfg l))); try assumption; [apply ccw_turn|apply ccw_turn, ccw_turn]; assumption. }
    split; (split; [|split; [|split]]; try assumption); apply counterclockwise_is.
    - apply ccw_turn, ccw_turn, D.
    - apply ccw_turn, C.
  Qed.
End Four.

(* The edges around a flip, at one instant. *)
Section Change.
  Variable gens : list gen.
  Variable cfg : gen -> generator.
  Hypothesis W : forall g, wall (cfg g) = Pos.eqb g container.
  Hypothesis P : forall g, In g gens -> proper (cfg g).
  Hypothesis Right : forall g h, In g gens -> In h gens -> g <> h -> right_pair (cfg g) (cfg h).

  (* What a diagram says of an edge seen from a disk. *)
  Definition good (q : edge) : Prop := both_there cfg q /\
    forall u g, unit u -> on_arc (start_of cfg q) (end_of cfg q) u -> In g gens -> g <> el q -> g <> er q -> K_at cfg (el q) g u <= K_at cfg (el q) (er q) u.

  (* The third generator at an end of an edge is another one on the same circle. *)
  Lemma good_end o a b x c d : In a gens -> In b gens -> In c gens -> In d gens -> wall (cfg a) = false ->
    vertex_circle o (cfg a) (cfg b) (cfg c) -> vertex_circle o (cfg a) (cfg b) (cfg d) -> good (Edge a b x c) -> good (Edge a b x d).
  Proof.
    intros Ia Ib Ic Id D Vc Vd [T E]. unfold good, both_there, start_of, end_of in *; simpl in *.
    assert (Vn : vertex (cfg a) (cfg b) (cfg d)) by (apply (vertex_at gens cfg W P Right o); assumption).
    split; [split; [apply T|exact Vn]|].
    assert (X : dir (cfg a) (cfg b) (cfg d) = dir (cfg a) (cfg b) (cfg c)); [|rewrite X; exact E].
    destruct T as [_ T]. rewrite (vertex_contact o (cfg a) (cfg b) (cfg d)), (vertex_contact o (cfg a) (cfg b) (cfg c)) by auto. reflexivity.
  Qed.

  Lemma good_start o a b x c d : In a gens -> In b gens -> In c gens -> In d gens -> wall (cfg b) = false ->
    vertex_circle o (cfg a) (cfg b) (cfg c) -> vertex_circle o (cfg a) (cfg b) (cfg d) -> good (Edge b a c x) -> good (Edge b a d x).
  Proof.
    intros Ia Ib Ic Id D Vc Vd [T E]. unfold good, both_there, start_of, end_of in *; simpl in *.
    apply vertex_turn in Vc, Vd.
    assert (Vn : vertex (cfg b) (cfg d) (cfg a)) by (apply (vertex_at gens cfg W P Right o); assumption).
    split; [split; [exact Vn|apply T]|].
    assert (X : dir (cfg b) (cfg d) (cfg a) = dir (cfg b) (cfg c) (cfg a)); [|rewrite X; exact E].
    destruct T as [T _]. rewrite (vertex_contact o (cfg b) (cfg d) (cfg a)), (vertex_contact o (cfg b) (cfg c) (cfg a)) by auto. reflexivity.
  Qed.

  (* An edge both of whose vertices have one circle, which is empty of all. *)
  Lemma good_point o a b x y : In a gens -> In b gens -> In x gens -> In y gens -> wall (cfg a) = false ->
    one_circle_at o (cfg a) (cfg b) (cfg x) (cfg y) -> (forall g, In g gens -> empty_of o (cfg g)) -> good (Edge a b x y).
  Proof.
    intros Ia Ib Ix Iy D [Vx Vy] E. unfold good, both_there, start_of, end_of; simpl.
    assert (Vx' : vertex (cfg a) (cfg x) (cfg b)) by (apply (vertex_at gens cfg W P Right o); assumption).
    assert (Vy' : vertex (cfg a) (cfg b) (cfg y)) by (apply (vertex_at gens cfg W P Right o); assumption).
    split; [split; assumption|]. intros u g _ H Ig Na _.
    assert (X : dir (cfg a) (cfg x) (cfg b) = dir (cfg a) (cfg b) (cfg y)).
    { rewrite (vertex_contact o (cfg a) (cfg x) (cfg b)), (vertex_contact o (cfg a) (cfg b) (cfg y)) by auto. reflexivity. }
    destruct H as [[_ ->]|[N _]]; [|contradiction]. unfold K_at.
    destruct (vertex_dir _ _ _ Vx') as (_ & -> & _).
    assert (R : right_pair (cfg a) (cfg g)) by auto.
    destruct (circle_and_other o (cfg a) (cfg x) (cfg b) (cfg g)) as [H _]; auto. apply H, E, Ig.
  Qed.

  (* Both ends of an arc lie on it. *)
  Lemma start_on_arc p q : on_arc p q p.
  Proof.
    destruct (vec_dec p q) as [E|E]; [left; auto|right]. split; [exact E|]. unfold chord, cross, minus; simpl. lra.
  Qed.

  (* The circle of the first vertex of an edge is empty of all. *)
  Lemma good_empty o q : In (el q) gens -> In (er q) gens -> In (es q) gens -> good q ->
    vertex_circle o (cfg (el q)) (cfg (es q)) (cfg (er q)) -> forall g, In g gens -> empty_of o (cfg g).
  Proof.
    intros Il Ir Is [[T _] E] V g Ig. destruct (vertex_dir _ _ _ T) as (U & Eq & _).
    destruct (Pos.eq_dec g (el q)) as [->|Nl]; [apply touching_empty, V|].
    destruct (Pos.eq_dec g (er q)) as [->|Nr]; [apply touching_empty, V|].
    assert (R : right_pair (cfg (el q)) (cfg g)) by auto.
    destruct (circle_and_other o (cfg (el q)) (cfg (es q)) (cfg (er q)) (cfg g)) as [H _]; auto. apply H. unfold level. rewrite <- Eq.
    apply E; try assumption. apply start_on_arc.
  Qed.

  (* An edge is good from each side that is a disk. *)
  Definition good_both (q : edge) : Prop := (wall (cfg (el q)) = false -> good q) /\ (wall (cfg (er q)) = false -> good (reversed q)).

  Lemma good_voronoi D : (forall q, In q D -> good_both q) -> voronoi gens cfg D.
  Proof.
    intros G. assert (O : forall q, oriented cfg D q -> good q).
    { intros q [[I|I] D0]; destruct (G _ I) as [A B]; [apply A, D0|]. rewrite <- (reversed_twice q). apply B. destruct q; exact D0. }
    split; [exact Right| |].
    - intros q H. apply O, H.
    - intros q u g H. apply O, H.
  Qed.

  Lemma voronoi_good D q : voronoi gens cfg D -> In q D -> good_both q.
  Proof.
    intros V I. split; intros D0; (split; [apply (all_there _ _ _ V)|intros u g; apply (envelope _ _ _ V)]); (split; [|exact D0]).
    - left. exact I.
    - left. exact I.
    - right. rewrite reversed_twice. exact I.
    - right. rewrite reversed_twice. exact I.
  Qed.

  (* What becomes of an edge beside the flip. *)
  Lemma beside_good o a b c d q q' : In a gens -> In b gens -> In c gens -> In d gens ->
    vertex_circle o (cfg a) (cfg b) (cfg c) -> vertex_circle o (cfg a) (cfg b) (cfg d) -> beside a b c d q = Some q' -> good_both q -> good_both q'.
  Proof.
    intros Ia Ib Ic Id Vc Vd B [G H]. unfold beside in B. destruct q as [ql qr qs qe]; simpl in *.
    destruct (Pos.eqb ql a && Pos.eqb qr b && Pos.eqb qe c) eqn:E1.
    - apply andb_prop in E1 as [E1 E]. apply andb_prop in E1 as [E1 E2]. apply Pos.eqb_eq in E, E1, E2. subst ql qr qe. injection B as <-.
      split; simpl in *; intros D; [apply (good_end o a b qs c d)|apply (good_start o a b qs c d)]; auto.
    - destruct (Pos.eqb ql b && Pos.eqb qr a && Pos.eqb qs c) eqn:E2; [|discriminate].
      apply andb_prop in E2 as [E2 E]. apply andb_prop in E2 as [E2 E3]. apply Pos.eqb_eq in E, E2, E3. subst ql qr qs. injection B as <-.
      split; simpl in *; intros D; [apply (good_start o a b qe c d)|apply (good_end o a b qe c d)]; auto.
  Qed.
End Change.

(* Three generators j, k, m that rise about the base i, at one instant: what each of the vertices says of the generator left out. *)
Section Base.
  Variables i j k m : generator.
  Hypothesis pi : proper i. Hypothesis pj : proper j. Hypothesis pk : proper k. Hypothesis pm : proper m.
  Hypothesis Vp : vertex i j k. Hypothesis Vq : vertex i k m. Hypothesis Vw : vertex i j m.

  Definition rises (u : vec) : Prop := 0 < slope (Kg i k) u - slope (Kg i j) u /\ 0 < slope (Kg i m) u - slope (Kg i k) u.
  Definition close (u v : vec) : Prop := 0 < 1 + dot u v.

  (* The difference of two values of an affine function. *)
  Lemma value_difference f u v : unit u -> unit v -> (at_ f u - at_ f v) * (1 + dot u v) = cross v u * (slope f u + slope f v).
  Proof.
    intros Uu Uv. replace (at_ f u - at_ f v) with (dot (fa f) (minus u v)) by (unfold at_, dot, minus; simpl; ring).
    unfold slope, cross, dot, turn, minus; simpl. unfold unit in *.
    set (a := vx (fa f)). set (b := vy (fa f)). set (c := vx u) in *. set (d := vy u) in *. set (g := vx v) in *. set (h := vy v) in *.
    (* the difference of the two sides is a sum of multiples of c c + d d - g g - h h *)
    apply Rminus_diag_uniq.
    replace ((a * (c - g) + b * (d - h)) * (1 + (c * g + d * h)) - (g * d - h * c) * (a * - d + b * c + (a * - h + b * g))) with
      (a * (c - g + g * (c * c + d * d) - c * (g * g + h * h)) + b * (d - h + h * (c * c + d * d) - d * (g * g + h * h))) by ring.
    rewrite Uu, Uv. ring.
  Qed.

  Lemma order_of_values f u v : unit u -> unit v -> close u v -> 0 < slope f u -> 0 < slope f v ->
    (0 < cross v u -> at_ f v < at_ f u) /\ (cross v u = 0 -> at_ f u = at_ f v) /\ (cross v u < 0 -> at_ f u < at_ f v).
  Proof.
    unfold close. intros Uu Uv C Su Sv. pose proof (value_difference f u v Uu Uv) as E. set (x := at_ f u - at_ f v) in *.
    assert (S : 0 < slope f u + slope f v) by lra. set (y := slope f u + slope f v) in *. set (z := cross v u) in *. set (w := 1 + dot u v) in *.
    split; [|split]; intros H.
    - assert (0 < z * y) by (apply Rmult_lt_0_compat; assumption). assert (0 < x); [|unfold x in *; lra].
      apply Rnot_le_lt. intros L. assert (0 <= - x * w) by (apply Rmult_le_pos; lra). lra.
    - rewrite H in E. assert (x = 0); [|unfold x in *; lra]. apply (Rmult_eq_reg_r w); lra.
    - assert (0 < - z * y) by (apply Rmult_lt_0_compat; lra). assert (x < 0); [|unfold x in *; lra].
      apply Rnot_le_lt. intros L. assert (0 <= x * w) by (apply Rmult_le_pos; lra). lra.
  Qed.

  Let f := diff (Kg i k) (Kg i j).
  Let g := diff (Kg i m) (Kg i k).

  Lemma together u v : unit u -> unit v -> close u v -> rises u -> rises v ->
    (at_ f u < at_ f v /\ at_ g u < at_ g v) \/ (at_ f u = at_ f v /\ at_ g u = at_ g v) \/ (at_ f v < at_ f u /\ at_ g v < at_ g u).
  Proof.
    intros Uu Uv C [Fu Gu] [Fv Gv].
    assert (S : forall a b x, slope (diff a b) x = slope a x - slope b x) by (intros; unfold slope, diff, dot, minus; simpl; ring).
    rewrite <- !S in *. fold f in Fu, Fv. fold g in Gu, Gv.
    destruct (order_of_values f u v) as (F1 & F2 & F3); try assumption. destruct (order_of_values g u v) as (G1 & G2 & G3); try assumption.
    destruct (Rtotal_order (cross v u) 0) as [H|[H|H]]; auto.
  Qed.

  Lemma one_base : let p := dir i j k in let q := dir i k m in let w := dir i j m in
    close p q -> close p w -> close q w -> rises p -> rises q -> rises w ->
    (clear i j k m <-> clear i k m j) /\ (clear i j m k \/ clear i j k m).
  Proof.
    intros p q w Cpq Cpw Cqw Rp Rq Rw.
    assert (Rj : right_pair i j) by apply Vp. assert (Rk : right_pair i k) by apply Vp. assert (Rm : right_pair i m) by apply Vq.
    destruct (vertex_dir _ _ _ Vp) as (Up & Ep & _). destruct (vertex_dir _ _ _ Vq) as (Uq & Eq & _). destruct (vertex_dir _ _ _ Vw) as (Uw & Ew & _).
    fold p in Up, Ep. fold q in Uq, Eq. fold w in Uw, Ew.
    assert (S : forall a b x, at_ (diff a b) x = at_ a x - at_ b x) by (intros; unfold at_, diff, dot, minus; simpl; ring).
    pose proof (together p q Up Uq Cpq Rp Rq) as Tpq. pose proof (together p w Up Uw Cpw Rp Rw) as Tpw. pose proof (together q w Uq Uw Cqw Rq Rw) as Tqw.
    unfold f, g in Tpq, Tpw, Tqw. rewrite !S in Tpq, Tpw, Tqw.
    rewrite (clear_link i j k m), (clear_link i k m j), (clear_link i j m k) by assumption. fold p q w.
    destruct Tpq as [H|[H|H]]; destruct Tpw as [I|[I|I]]; destruct Tqw as [J|[J|J]]; (split; [split|]); lra.
  Qed.
End Base.

(* The same near an instant at which all touch one circle. *)
Section Near.
  Variable cfg : R -> gen -> generator.
  Hypothesis M : moves cfg.
  Variable t0 : R.

  Lemma all_proper t g : proper (cfg t g).
  Proof.
    unfold proper. rewrite (walls _ M). destruct (Pos.eqb_spec g container) as [->|N].
    - apply (proper_wall _ M).
    - apply (proper_disk _ M), N.
  Qed.

  Variable i : gen.

  Lemma dir_of_vertex a b : vertex (cfg t0 i) (cfg t0 a) (cfg t0 b) ->
    continuity_pt (fun t => vx (dir (cfg t i) (cfg t a) (cfg t b))) t0 /\ continuity_pt (fun t => vy (dir (cfg t i) (cfg t a) (cfg t b))) t0.
  Proof. intros V. apply dir_continuous; assumption. Qed.

  Lemma slopes_after a b x y : vertex (cfg t0 i) (cfg t0 a) (cfg t0 b) -> vertex (cfg t0 i) (cfg t0 x) (cfg t0 y) ->
    (let u := dir (cfg t0 i) (cfg t0 a) (cfg t0 b) in 0 < slope (Kg (cfg t0 i) (cfg t0 y)) u - slope (Kg (cfg t0 i) (cfg t0 x)) u) ->
    after t0 (fun t => let u := dir (cfg t i) (cfg t a) (cfg t b) in 0 < slope (Kg (cfg t i) (cfg t y)) u - slope (Kg (cfg t i) (cfg t x)) u).
  Proof.
    intros V V' H. apply after_positive; [|exact H].
    destruct (dir_of_vertex a b V) as [Dx Dy].
    assert (C : forall g, right_pair (cfg t0 i) (cfg t0 g) -> continuity_pt (fun t => slope (Kg (cfg t i) (cfg t g)) (dir (cfg t i) (cfg t a) (cfg t b))) t0).
    { intros g Rg. assert (N : tang (seen_at (cfg t0 i) (cfg t0 g)) <> 0).
      { apply right_tang in Rg. destruct V as [D _]. rewrite D in Rg. simpl in Rg. destruct (wall (cfg t0 g)); lra. }
      assert (K : continuity_pt (fun t => vx (fa (Kg (cfg t i) (cfg t g)))) t0 /\ continuity_pt (fun t => vy (fa (Kg (cfg t i) (cfg t g)))) t0 /\
        continuity_pt (fun t => fb (Kg (cfg t i) (cfg t g))) t0) by (apply K_continuous; assumption). destruct K as (K1 & K2 & K3).
      eapply at_continuous with (f := fun t => Kg (cfg t i) (cfg t g)) (u := fun t => dir (cfg t i) (cfg t a) (cfg t b)); eassumption. }
    apply (continuity_pt_minus (fun t => slope (Kg (cfg t i) (cfg t y)) (dir (cfg t i) (cfg t a) (cfg t b)))
      (fun t => slope (Kg (cfg t i) (cfg t x)) (dir (cfg t i) (cfg t a) (cfg t b)))); apply C; apply V'.
  Qed.

  Lemma close_after a b x y : vertex (cfg t0 i) (cfg t0 a) (cfg t0 b) -> vertex (cfg t0 i) (cfg t0 x) (cfg t0 y) ->
    close (dir (cfg t0 i) (cfg t0 a) (cfg t0 b)) (dir (cfg t0 i) (cfg t0 x) (cfg t0 y)) ->
    after t0 (fun t => close (dir (cfg t i) (cfg t a) (cfg t b)) (dir (cfg t i) (cfg t x) (cfg t y))).
  Proof.
    intros V V' H. apply (after_positive (fun t => 1 + dot (dir (cfg t i) (cfg t a) (cfg t b)) (dir (cfg t i) (cfg t x) (cfg t y)))); [|exact H].
    destruct (dir_of_vertex a b V) as [Dx Dy]. destruct (dir_of_vertex x y V') as [Ex Ey].
    pose proof (continuity_pt_plus _ _ t0 (continuity_pt_mult _ _ t0 Dx Ex) (continuity_pt_mult _ _ t0 Dy Ey)) as C.
    assert (O : continuity_pt (fun _ => 1) t0) by (apply continuity_pt_const; intros ? ?; reflexivity).
    exact (continuity_pt_plus _ _ t0 O C).
  Qed.

  Variables j k m : gen.
  Variable z : circle.

  Lemma base_after : vertex (cfg t0 i) (cfg t0 j) (cfg t0 k) -> vertex (cfg t0 i) (cfg t0 k) (cfg t0 m) -> vertex (cfg t0 i) (cfg t0 j) (cfg t0 m) ->
    vertex_circle z (cfg t0 i) (cfg t0 j) (cfg t0 k) -> vertex_circle z (cfg t0 i) (cfg t0 k) (cfg t0 m) -> vertex_circle z (cfg t0 i) (cfg t0 j) (cfg t0 m) ->
    after t0 (fun t => let c g := cfg t g in (clear (c i) (c j) (c k) (c m) <-> clear (c i) (c k) (c m) (c j)) /\
      (clear (c i) (c j) (c m) (c k) \/ clear (c i) (c j) (c k) (c m))).
  Proof.
    intros Vp Vq Vw Cp Cq Cw.
    assert (X : forall a b, vertex (cfg t0 i) (cfg t0 a) (cfg t0 b) -> vertex_circle z (cfg t0 i) (cfg t0 a) (cfg t0 b) ->
      dir (cfg t0 i) (cfg t0 a) (cfg t0 b) = opposite (contact z (cfg t0 i))) by (intros; apply vertex_contact; auto using all_proper).
    pose proof (X _ _ Vp Cp) as Ep. pose proof (X _ _ Vq Cq) as Eq. pose proof (X _ _ Vw Cw) as Ew.
    destruct (vertex_dir _ _ _ Vp) as (U & _ & Sp). destruct (vertex_dir _ _ _ Vq) as (_ & _ & Sq). rewrite Ep in U, Sp. rewrite Eq in Sq.
    assert (Cl : close (opposite (contact z (cfg t0 i))) (opposite (contact z (cfg t0 i)))) by (unfold close, dot; unfold unit in U; lra).
    assert (A1 : after t0 (fun t => vertex (cfg t i) (cfg t j) (cfg t k))) by (apply vertex_after; assumption).
    assert (A2 : after t0 (fun t => vertex (cfg t i) (cfg t k) (cfg t m))) by (apply vertex_after; assumption).
    assert (A3 : after t0 (fun t => vertex (cfg t i) (cfg t j) (cfg t m))) by (apply vertex_after; assumption).
    assert (C1 := close_after j k k m Vp Vq). rewrite Ep, Eq in C1. specialize (C1 Cl).
    assert (C2 := close_after j k j m Vp Vw). rewrite Ep, Ew in C2. specialize (C2 Cl).
    assert (C3 := close_after k m j m Vq Vw). rewrite Eq, Ew in C3. specialize (C3 Cl).
    assert (R : forall a b, vertex (cfg t0 i) (cfg t0 a) (cfg t0 b) -> dir (cfg t0 i) (cfg t0 a) (cfg t0 b) = opposite (contact z (cfg t0 i)) ->
      after t0 (fun t => rises (cfg t i) (cfg t j) (cfg t k) (cfg t m) (dir (cfg t i) (cfg t a) (cfg t b)))).
    { intros a b V E. apply after_and; apply (slopes_after a b); try assumption; rewrite E; lra. }
    pose proof (R _ _ Vp Ep) as R1. pose proof (R _ _ Vq Eq) as R2. pose proof (R _ _ Vw Ew) as R3.
    pose proof (after_and _ _ _ A1 (after_and _ _ _ A2 (after_and _ _ _ A3 (after_and _ _ _ C1 (after_and _ _ _ C2 (after_and _ _ _ C3
      (after_and _ _ _ R1 (after_and _ _ _ R2 R3)))))))) as H.
    revert H. apply after_impl. intros t (H1 & H2 & H3 & H4 & H5 & H6 & H7 & H8 & H9). apply one_base; auto using all_proper.
  Qed.
End Near.

Section Flip.
  Variable gens : list gen.

  (* The numbered edges before and after the flip that a claim names; all four edges beside it fit. *)
  Theorem flipped (cfg : gen -> generator) (c : claim) t f lo hi k0 k1 k2 k3 k4 (D D' : list (positive * edge)) :
    (forall g, wall (cfg g) = Pos.eqb g container) -> (forall g, In g gens -> proper (cfg g)) ->
    c = Flip t f lo hi k0 k1 k2 k3 k4 -> NoDup [k0; k1; k2; k3; k4] -> NoDup (map fst D) ->
    (In (k0, f) D \/ In (k0, reversed f) D) -> (forall k, In k [k0; k1; k2; k3; k4] -> In k (map fst D)) ->
    (forall k q, In (k, q) D -> exists q', after_flip k c q = Some q' /\ In (k, q') D') ->
    (forall k q', In (k, q') D' -> exists q, In (k, q) D /\ after_flip k c q = Some q') ->
    fits gens (map snd D) -> fits gens (map snd D') -> voronoi gens cfg (map snd D) ->
    pinched (cfg (el f)) (cfg (er f)) (cfg (es f)) (cfg (ee f)) -> voronoi gens cfg (map snd D').
  Proof.
    intros W P -> _ _ If _ _ Back F _ V (z & Z). pose proof (all_right _ _ _ V) as Right.
    destruct f as [l r s e]; simpl in *.
    assert (Names : In l gens /\ In r gens /\ In s gens /\ In e gens).
    { destruct If as [I|I]; apply (in_map snd) in I; simpl in I; repeat split; apply (names_in _ _ F _ _ I); simpl; tauto. }
    destruct Names as (Il & Ir & Is & Ie).
    pose proof (one_circle_after gens cfg W P Right l r s e Il Ir Is Ie z Z) as [Zs Ze]. destruct Z as [Zl Zr].
    assert (Gf : good_both gens cfg (Edge l r s e)).
    { destruct If as [I|I]; apply (in_map snd) in I; simpl in I; pose proof (voronoi_good _ _ _ _ V I) as [A B]; split; assumption. }
    assert (Empty : forall g, In g gens -> empty_of z (cfg g)).
    { destruct (circle_apart cfg _ _ _ _ Zr) as (N & _). destruct (a_disk cfg W l r N) as [D0|D0].
      - apply (good_empty gens cfg P Right z (Edge l r s e)); try assumption. apply Gf, D0.
      - apply (good_empty gens cfg P Right z (Edge r l e s)); try assumption; [apply Gf, D0|apply vertex_turn, Zr]. }
    apply good_voronoi; [exact Right|]. intros q' I'. apply in_map_iff in I' as ((k & q) & E & I'). simpl in E. subst q'. rename q into q'.
    destruct (Back k q' I') as (q & I & A). apply (in_map snd) in I. simpl in I. pose proof (voronoi_good _ _ _ _ V I) as G.
    unfold after_flip, own, corner in A; simpl in A.
    destruct (Pos.eqb k k0).
    { injection A as <-. split; simpl; intros D0.
      - apply (good_point gens cfg W P Right z s e r l); try assumption. split; assumption.
      - apply (good_point gens cfg W P Right z e s l r); try assumption. split; apply vertex_turn; [|apply vertex_turn]; assumption. }
    assert (T : forall a b c, vertex_circle z (cfg a) (cfg b) (cfg c) -> vertex_circle z (cfg b) (cfg c) (cfg a)) by (intros; apply vertex_turn; assumption).
    destruct (Pos.eqb k k1); [apply (beside_good gens cfg W P Right z l s r e q q'); auto|].
    destruct (Pos.eqb k k2); [apply (beside_good gens cfg W P Right z s r l e q q'); auto|].
    destruct (Pos.eqb k k3); [apply (beside_good gens cfg W P Right z r e l s q q'); auto|].
    destruct (Pos.eqb k k4); [apply (beside_good gens cfg W P Right z e l r s q q'); auto|].
    injection A as <-. exact G.
  Qed.

  Theorem two_ways (cfg : R -> gen -> generator) (D : list edge) t0 q : moves cfg -> fits gens D -> voronoi gens (cfg t0) D -> In q D ->
    pinched (cfg t0 (el q)) (cfg t0 (er q)) (cfg t0 (es q)) (cfg t0 (ee q)) ->
    after t0 (fun t => legal (cfg t (el q)) (cfg t (er q)) (cfg t (es q)) (cfg t (ee q)) \/
      let n := turned_over q in legal (cfg t (el n)) (cfg t (er n)) (cfg t (es n)) (cfg t (ee n))).
  Proof.
    intros M F V I (z & Z). pose proof (all_right _ _ _ V) as Right. destruct q as [l r s e]; simpl in *.
    assert (Il : In l gens) by (apply (names_in _ _ F _ _ I); simpl; tauto). assert (Ir : In r gens) by (apply (names_in _ _ F _ _ I); simpl; tauto).
    assert (Is : In s gens) by (apply (names_in _ _ F _ _ I); simpl; tauto). assert (Ie : In e gens) by (apply (names_in _ _ F _ _ I); simpl; tauto).
    assert (W : forall g, wall (cfg t0 g) = Pos.eqb g container) by (intros; apply (walls _ M)).
    assert (P : forall g, In g gens -> proper (cfg t0 g)) by (intros; apply all_proper, M).
    pose proof (one_circle_after gens (cfg t0) W P Right l r s e Il Ir Is Ie z Z) as [Zs Ze].
    pose proof (apart_ends (cfg t0) l r s e z Z) as Nse. destruct Z as [Zl Zr].
    destruct (circle_apart (cfg t0) _ _ _ _ Zr) as (Nlr & _).
    assert (T : forall a b c, vertex_circle z (cfg t0 a) (cfg t0 b) (cfg t0 c) -> vertex_circle z (cfg t0 b) (cfg t0 c) (cfg t0 a))
      by (intros; apply vertex_turn; assumption).
    assert (Base : forall i j k m, In i gens -> In j gens -> In k gens -> In m gens -> wall (cfg t0 i) = false ->
      vertex_circle z (cfg t0 i) (cfg t0 j) (cfg t0 k) -> vertex_circle z (cfg t0 i) (cfg t0 k) (cfg t0 m) -> vertex_circle z (cfg t0 i) (cfg t0 j) (cfg t0 m) ->
      after t0 (fun t => let c g := cfg t g in (clear (c i) (c j) (c k) (c m) <-> clear (c i) (c k) (c m) (c j)) /\
        (clear (c i) (c j) (c m) (c k) \/ clear (c i) (c j) (c k) (c m)))).
    { intros i j k m Ii Ij Ik Im D0 C1 C2 C3. apply (base_after cfg M t0 i j k m z); try assumption; apply (vertex_at gens (cfg t0) W P Right z); assumption. }
    (* one of l, r is a disk: the circles of the edge are both clear, or neither *)
    assert (Old : after t0 (fun t => clear (cfg t l) (cfg t s) (cfg t r) (cfg t e) <-> clear (cfg t l) (cfg t r) (cfg t e) (cfg t s))).
    { destruct (a_disk (cfg t0) W l r Nlr) as [D0|D0].
      - eapply after_impl; [|apply (Base l s r e); auto]. simpl. intros t [H1 _]. exact H1.
      - eapply after_impl; [|apply (Base r e l s); auto]. simpl. intros t [H1 _]. split; intros H.
        + apply clear_turn, clear_turn, H1, clear_turn, clear_turn, H.
        + apply clear_turn, H1, clear_turn, H. }
    (* one of s, e is a disk: so are those of the flipped edge; and one circle of either edge is clear *)
    assert (New : after t0 (fun t => (clear (cfg t s) (cfg t r) (cfg t e) (cfg t l) <-> clear (cfg t s) (cfg t e) (cfg t l) (cfg t r)) /\
      (clear (cfg t l) (cfg t s) (cfg t r) (cfg t e) \/ clear (cfg t l) (cfg t r) (cfg t e) (cfg t s) \/ clear (cfg t s) (cfg t r) (cfg t e) (cfg t l) \/
       clear (cfg t s) (cfg t e) (cfg t l) (cfg t r)))).
    { destruct (a_disk (cfg t0) W s e Nse) as [D0|D0].
      - eapply after_impl; [|apply (Base s r e l); auto]. simpl. intros t [H1 H2]. split; [exact H1|].
        destruct H2 as [H2|H2]; [left|tauto]. apply clear_turn, clear_turn, H2.
      - eapply after_impl; [|apply (Base e l s r); auto]. simpl. intros t [H1 H2]. split; [split; intros H|].
        + apply clear_turn, clear_turn, H1, clear_turn, clear_turn, H.
        + apply clear_turn, H1, clear_turn, H.
        + destruct H2 as [H2|H2]; [right; left; apply clear_turn, H2|right; right; right; apply clear_turn, clear_turn, H2]. }
    eapply after_impl; [|exact (after_and _ _ _ Old New)]. simpl. intros t (O & N & H).
    assert (Two : (clear (cfg t l) (cfg t s) (cfg t r) (cfg t e) /\ clear (cfg t l) (cfg t r) (cfg t e) (cfg t s)) \/
      (clear (cfg t s) (cfg t r) (cfg t e) (cfg t l) /\ clear (cfg t s) (cfg t e) (cfg t l) (cfg t r))) by tauto.
    destruct Two as [[A B]|[A B]]; [left|right]; apply legal_clear; assumption.
  Qed.
End Flip.
