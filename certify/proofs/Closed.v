(* What is right just before an instant is right at it, as long as the edges are there; what overlaps overlaps a neighbour; the circle
   of each vertex is empty. *)
From Coq Require Import Reals Lra List Bool PArith.
From Voroproof Require Import Geometry Vertex History Arc Cyclic Cover Spread Envelope Near Link.
Import ListNotations.
Open Scope R_scope.

(* The oriented edges are finitely many. *)
Definition all_oriented (cfg : gen -> generator) (D : list edge) : list edge :=
  filter (fun q => negb (wall (cfg (el q)))) (D ++ map reversed D).

Lemma reversed_twice q : reversed (reversed q) = q.
Proof. destruct q. reflexivity. Qed.

Lemma all_oriented_in cfg D q : In q (all_oriented cfg D) <-> oriented cfg D q.
Proof.
  unfold all_oriented, oriented. rewrite filter_In, in_app_iff, in_map_iff, negb_true_iff. split; intros [[H|H] W]; (split; [|exact W]).
  - left; exact H.
  - right. destruct H as (p & <- & I). rewrite reversed_twice. exact I.
  - left; exact H.
  - right. exists (reversed q). rewrite reversed_twice. split; [reflexivity|exact H].
Qed.

Lemma oriented_names gens cfg D q : fits gens D -> oriented cfg D q -> In (el q) gens /\ In (er q) gens /\ In (es q) gens /\ In (ee q) gens.
Proof.
  intros F [[I|I] _]; pose proof (fun g => names_in _ _ F _ g I) as N; simpl in N; repeat split; apply N; tauto.
Qed.

(* A side whose first generator is a disk is the end of an oriented edge; and the start of another, by which the edge follows that ends
   at the vertex. *)
Lemma side_oriented cfg D a b c : side D a b c -> wall (cfg a) = false -> exists q, oriented cfg D q /\ el q = a /\ er q = b /\ ee q = c.
Proof.
  intros (q & I & [(-> & -> & ->)|(-> & -> & ->)]) W.
  - exists q. split; [split; [left; exact I|exact W]|]. repeat split.
  - exists (reversed q). split; [split; [right; rewrite reversed_twice; exact I|exact W]|]. repeat split.
Qed.
Lemma oriented_side cfg D q : oriented cfg D q -> side D (el q) (er q) (ee q).
Proof.
  intros [[I|I] _]; [exists q|exists (reversed q)]; (split; [exact I|]); unfold side_of; simpl; tauto.
Qed.
Lemma next_oriented gens cfg D q : fits gens D -> oriented cfg D q -> exists p, oriented cfg D p /\ el p = el q /\ er p = ee q /\ es p = er q.
Proof.
  intros F O. pose proof (oriented_side _ _ _ O) as S. apply (sides_turn _ _ F), (sides_turn _ _ F) in S.
  destruct O as [_ W]. destruct S as (p & I & [(E1 & E2 & E3)|(E1 & E2 & E3)]).
  - exists (reversed p). unfold oriented. rewrite reversed_twice. simpl. rewrite <- E1, <- E2, <- E3. tauto.
  - exists p. unfold oriented. rewrite <- E1, <- E2, <- E3. tauto.
Qed.

Lemma start_on_arc p q : Envelope.on_arc p q p.
Proof. destruct (vec_dec p q) as [E|N]; [left; tauto|right]. split; [exact N|]. unfold chord, cross, minus; simpl. lra. Qed.
Lemma end_on_arc p q : Envelope.on_arc p q q.
Proof. destruct (vec_dec p q) as [E|N]; [left; split; [exact E|symmetry; exact E]|right]. split; [exact N|]. unfold chord, cross, minus; simpl. lra. Qed.

(* Around each disk, in every direction, there is an edge. *)
Theorem all_around gens cfg D : (forall g, wall (cfg g) = Pos.eqb g container) -> (forall g, proper (cfg g)) -> fits gens D ->
  (forall q, oriented cfg D q -> both_there cfg q) ->
  forall l u, In l gens -> wall (cfg l) = false -> unit u -> exists q, oriented cfg D q /\ el q = l /\ on_arc (start_of cfg q) (end_of cfg q) u.
Proof.
  intros _ _ F There l u Il Wl Uu.
  set (mine := filter (fun q => Pos.eqb (el q) l) (all_oriented cfg D)).
  assert (Mine : forall q, In q mine <-> oriented cfg D q /\ el q = l).
  { intros q. unfold mine. rewrite filter_In, all_oriented_in, Pos.eqb_eq. tauto. }
  set (of := fun q => Spoke (start_of cfg q) (end_of cfg q) (slope (Kg (cfg (el q)) (cfg (ee q))) (end_of cfg q))).
  destruct (cover (map of mine)) with (v := u) as (s & Is & A).
  - assert (exists q, In q mine) as (q & I).
    { destruct (each_has_one _ _ F l Il) as (q & I & [E|E]).
      - exists q. apply Mine. unfold oriented. rewrite E. tauto.
      - exists (reversed q). apply Mine. unfold oriented. rewrite reversed_twice. simpl. rewrite E. tauto. }
    destruct mine; [destruct I|discriminate].
  - intros s H. apply in_map_iff in H as (q & <- & I). apply Mine in I as [O _]. destruct (There q O) as [V1 V2].
    split; [exact (proj1 (vertex_dir _ _ _ V1))|exact (proj1 (vertex_dir _ _ _ V2))].
  - intros s H. apply in_map_iff in H as (q & <- & I). apply Mine in I as [O E].
    destruct (next_oriented _ _ _ _ F O) as (p & Op & E1 & E2 & E3). exists (of p).
    assert (S : start_of cfg p = end_of cfg q) by (unfold start_of, end_of; rewrite E1, E2, E3; reflexivity).
    split; [|split].
    + apply in_map, Mine. split; [exact Op|congruence].
    + exact S.
    + unfold of; simpl. intros N. destruct (There p Op) as [_ V]. apply vertex_dir in V as (_ & _ & V). fold (end_of cfg p) in V.
      rewrite E2 in V. rewrite <- N, S in V. rewrite <- N, S. rewrite E1 in *. exact V.
  - exact Uu.
  - apply in_map_iff in Is as (q & <- & I). apply Mine in I as [O E]. exists q. split; [exact O|]. split; [exact E|].
    unfold Cover.on_arc in A; simpl in A. destruct A as [->|[->|A]]; [apply start_on_arc|apply end_on_arc|right; exact A].
Qed.

(* How far a disk l may grow till it meets g is half of the gap, but for its radius: the greatest value of K_g is 1 / gap. *)
Definition far (l g : generator) : R := length (cx g - cx l) (cy g - cy l).
Definition gap (l g : generator) : R := if wall g then - (radius g - radius l) - far l g else far l g - (radius g - radius l).

Lemma far_square l g : 0 <= far l g /\ far l g * far l g = (cx g - cx l) * (cx g - cx l) + (cy g - cy l) * (cy g - cy l).
Proof.
  unfold far, length. split; [apply sqrt_pos|]. apply sqrt_sqrt. pose proof (sq (cx g - cx l)). pose proof (sq (cy g - cy l)). lra.
Qed.

Lemma along_far l g v : unit v -> - far l g <= (cx g - cx l) * vx v + (cy g - cy l) * vy v <= far l g.
Proof.
  intros U. destruct (far_square l g) as [P Q]. set (d := far l g) in *. set (a := cx g - cx l) in *. set (b := cy g - cy l) in *.
  unfold unit in U. clearbody d a b.
  assert (S : (a * vx v + b * vy v) * (a * vx v + b * vy v) <= d * d).
  { rewrite Q. replace (a * a + b * b) with ((a * a + b * b) * (vx v * vx v + vy v * vy v)) by (rewrite U; ring).
    pose proof (sq (a * vy v - b * vx v)). lra. }
  set (z := a * vx v + b * vy v) in *. clearbody z. split; apply Rnot_lt_le; intros L.
  - assert (0 < (- z - d) * (- z + d)) by (apply Rmult_lt_0_compat; lra). lra.
  - assert (0 < (z - d) * (z + d)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma gap_tang l g : tang (seen_at l g) = far l g * far l g - (radius g - radius l) * (radius g - radius l).
Proof. unfold tang, seen_at; simpl. rewrite (proj2 (far_square l g)). ring. Qed.

Lemma value_tang l g v : tang (seen_at l g) <> 0 ->
  at_ (Kg l g) v * tang (seen_at l g) = (cx g - cx l) * vx v + (cy g - cy l) * vy v + (radius g - radius l).
Proof. intros N. unfold at_, Kg, K, dot; simpl. field. exact N. Qed.

(* A square less another has the sign of the difference. *)
Lemma above_square d s : 0 <= d -> 0 < d * d - s * s -> s < d /\ - s < d.
Proof.
  intros P H. split; apply Rnot_le_lt; intros L.
  - assert (0 <= (s - d) * (s + d)) by (apply Rmult_le_pos; lra). lra.
  - assert (0 <= (- s - d) * (- s + d)) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma gap_values l g : wall l = false -> proper l -> proper g -> right_pair l g ->
  0 < gap l g /\ (exists v, unit v /\ at_ (Kg l g) v * gap l g = 1) /\ (forall v, unit v -> at_ (Kg l g) v * gap l g <= 1).
Proof.
  intros Wl Pl Pg H. apply right_tang in H. unfold proper in *. rewrite Wl in *. simpl in H.
  pose proof (value_tang l g) as V. pose proof (along_far l g) as A. destruct (far_square l g) as [F Q]. rewrite gap_tang in *. unfold gap.
  set (d := far l g) in *. set (a := cx g - cx l) in *. set (b := cy g - cy l) in *. set (s := radius g - radius l) in *.
  destruct (wall g).
  - assert (S : s < 0) by (unfold s; lra). clearbody d a b s.
    assert (G : 0 < - s - d).
    { apply Rnot_le_lt. intros L. assert (0 <= (d + s) * (d - s)) by (apply Rmult_le_pos; lra). lra. }
    split; [exact G|]. split.
    + destruct (Req_dec d 0) as [Z|Z].
      * exists (Vec 1 0). split; [unfold unit; simpl; ring|]. specialize (V (Vec 1 0) ltac:(lra)). simpl in V.
        rewrite Z in Q. destruct (both_zero a b ltac:(lra)) as [-> ->]. rewrite Z in *.
        apply (Rmult_eq_reg_r (0 * 0 - s * s)); [|lra]. set (k := at_ (Kg l g) (Vec 1 0)) in *. clearbody k.
        replace (k * (- s - 0) * (0 * 0 - s * s)) with (k * (0 * 0 - s * s) * (- s)) by ring. rewrite V. ring.
      * exists (Vec (- a / d) (- b / d)). split.
        { unfold unit; simpl. replace (- a / d * (- a / d) + - b / d * (- b / d)) with ((a * a + b * b) / (d * d)) by (field; exact Z).
          rewrite <- Q. field. exact Z. }
        specialize (V (Vec (- a / d) (- b / d)) ltac:(lra)). simpl in V. set (k := at_ (Kg l g) (Vec (- a / d) (- b / d))) in *. clearbody k.
        apply (Rmult_eq_reg_r (d * d - s * s)); [|lra].
        replace (k * (- s - d) * (d * d - s * s)) with (k * (d * d - s * s) * (- s - d)) by ring. rewrite V.
        replace (a * (- a / d) + b * (- b / d)) with (- ((a * a + b * b) / d)) by (field; exact Z). rewrite <- Q. field. exact Z.
    + intros v U. specialize (V v ltac:(lra)). specialize (A v U). set (k := at_ (Kg l g) v) in *. set (z := a * vx v + b * vy v) in *. clearbody k z.
      apply Rnot_lt_le. intros L. assert (0 < (k * (- s - d) - 1) * (s * s - d * d)) by (apply Rmult_lt_0_compat; lra).
      replace ((k * (- s - d) - 1) * (s * s - d * d)) with (- (k * (d * d - s * s)) * (- s - d) - (s * s - d * d)) in H0 by ring. rewrite V in H0.
      assert (0 <= (z + d) * (- s - d)) by (apply Rmult_le_pos; lra). lra.
  - clearbody d a b s. destruct (above_square d s F H) as [G G']. split; [lra|]. split.
    + assert (Z : d <> 0) by lra. exists (Vec (a / d) (b / d)). split.
      { unfold unit; simpl. replace (a / d * (a / d) + b / d * (b / d)) with ((a * a + b * b) / (d * d)) by (field; exact Z).
        rewrite <- Q. field. exact Z. }
      specialize (V (Vec (a / d) (b / d)) ltac:(lra)). simpl in V. set (k := at_ (Kg l g) (Vec (a / d) (b / d))) in *. clearbody k.
      apply (Rmult_eq_reg_r (d * d - s * s)); [|lra].
      replace (k * (d - s) * (d * d - s * s)) with (k * (d * d - s * s) * (d - s)) by ring. rewrite V.
      replace (a * (a / d) + b * (b / d)) with ((a * a + b * b) / d) by (field; exact Z). rewrite <- Q. field. exact Z.
    + intros v U. specialize (V v ltac:(lra)). specialize (A v U). set (k := at_ (Kg l g) v) in *. set (z := a * vx v + b * vy v) in *. clearbody k z.
      apply Rnot_lt_le. intros L. assert (0 < (k * (d - s) - 1) * (d * d - s * s)) by (apply Rmult_lt_0_compat; lra).
      replace ((k * (d - s) - 1) * (d * d - s * s)) with (k * (d * d - s * s) * (d - s) - (d * d - s * s)) in H0 by ring. rewrite V in H0.
      assert (0 <= (d - z) * (d - s)) by (apply Rmult_le_pos; lra). lra.
Qed.

(* A gap keeps the tangency away from 0; of two disks, l is not the larger. *)
Lemma gap_apart l g m : 0 < m -> m <= gap l g -> wall g = true \/ radius l <= radius g ->
  m * m <= if wall g then - tang (seen_at l g) else tang (seen_at l g).
Proof.
  intros Pm. rewrite gap_tang. unfold gap. destruct (far_square l g) as [F _]. set (d := far l g) in *. clearbody d.
  set (s := radius g - radius l). intros H S. destruct (wall g).
  - clearbody s. assert (0 <= (- s - d - m) * (- s + d)) by (apply Rmult_le_pos; lra). assert (0 <= m * (- s + d - m)) by (apply Rmult_le_pos; lra). lra.
  - assert (0 <= s) by (destruct S; [discriminate|unfold s; lra]). clearbody s.
    assert (0 <= (d - s - m) * (d + s)) by (apply Rmult_le_pos; lra). assert (0 <= m * (d + s - m)) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma apart_gap l g : wall l = false -> (apart l g <-> 2 * radius l <= gap l g).
Proof.
  intros W. unfold apart, gap, far. rewrite W. simpl.
  replace (length (cx g - cx l) (cy g - cy l)) with (length (cx l - cx g) (cy l - cy g)) by (unfold length; f_equal; ring).
  destruct (wall g); split; lra.
Qed.

(* The order of a pair says nothing. *)
Lemma right_swap g h : right_pair g h -> right_pair h g.
Proof.
  unfold right_pair. rewrite (orb_comm (wall h)).
  replace ((cx h - cx g) * (cx h - cx g) + (cy h - cy g) * (cy h - cy g) - (radius h - radius g) * (radius h - radius g)) with
    ((cx g - cx h) * (cx g - cx h) + (cy g - cy h) * (cy g - cy h) - (radius g - radius h) * (radius g - radius h)) by ring. tauto.
Qed.
Lemma apart_swap g h : apart g h -> apart h g.
Proof.
  unfold apart. rewrite (orb_comm (wall h)), (Rplus_comm (radius h)).
  replace (length (cx h - cx g) (cy h - cy g)) with (length (cx g - cx h) (cy g - cy h)) by (unfold length; f_equal; ring). tauto.
Qed.

(* A point of the circle on the line of a chord is one of its ends. *)
Lemma chord_ends p q u : unit p -> unit q -> unit u -> p <> q -> chord p q u = 0 -> u = p \/ u = q.
Proof.
  intros Up Uq Uu N C. destruct (vec_dec u p) as [E|Np]; [left; exact E|]. destruct (vec_dec u q) as [E|Nq]; [right; exact E|]. exfalso.
  rewrite chord_key in C by congruence.
  pose proof (not_one u p Uu Up ltac:(congruence)) as P1. pose proof (not_one u q Uu Uq ltac:(congruence)) as P2.
  apply Rmult_integral in C as [C|C]; [apply Rmult_integral in C; lra|].
  apply N. apply (key_one u); try assumption; try congruence. lra.
Qed.

Section Limit.
  Variable gens : list gen.
  Variable cfg : R -> gen -> generator.
  Variable D : list edge.
  Variable t0 : R.
  Hypothesis M : moves cfg.
  Hypothesis F : fits gens D.
  Hypothesis Often : ~ before t0 (fun t => ~ voronoi gens (cfg t) D).
  Hypothesis There : forall q, oriented (cfg t0) D q -> both_there (cfg t0) q.

  Lemma moving_proper t g : proper (cfg t g).
  Proof.
    unfold proper. rewrite (walls _ M). destruct (Pos.eqb_spec g container) as [->|N]; [apply (proper_wall _ M)|apply (proper_disk _ M), N].
  Qed.
  Lemma wall_then t u g : wall (cfg t g) = wall (cfg u g).
  Proof. rewrite !(walls _ M). reflexivity. Qed.
  Lemma oriented_then t u q : oriented (cfg t) D q -> oriented (cfg u) D q.
  Proof. unfold oriented. rewrite (wall_then t u). tauto. Qed.

  (* What holds just before t0 holds at once with voronoi. *)
  Lemma at_once (P : R -> Prop) : before t0 P -> (forall t, P t -> voronoi gens (cfg t) D -> False) -> False.
  Proof. intros B H. apply Often. apply (before_impl t0) with (2 := B). intros t Pt V. exact (H t Pt V). Qed.

  (* The neighbours' functions are bounded near t0, since they are right at t0. *)
  Lemma bounded_one q : oriented (cfg t0) D q ->
    exists B, 0 < B /\ before t0 (fun t => forall v, unit v -> K_at (cfg t) (el q) (er q) v <= B).
  Proof.
    intros O. destruct (There q O) as [_ (W & R & _)]. pose proof (right_tang_nonzero cfg M t0 _ _ W R) as N.
    destruct (K_continuous cfg M t0 _ _ N) as (Ca & Cb & Cc).
    set (a := fun t => vx (fa (Kg (cfg t (el q)) (cfg t (er q))))) in *. set (b := fun t => vy (fa (Kg (cfg t (el q)) (cfg t (er q))))) in *.
    set (c := fun t => fb (Kg (cfg t (el q)) (cfg t (er q)))) in *.
    set (B := Rabs (a t0) + Rabs (b t0) + Rabs (c t0) + 1). exists B. split.
    - unfold B. pose proof (Rabs_pos (a t0)). pose proof (Rabs_pos (b t0)). pose proof (Rabs_pos (c t0)). lra.
    - apply before_impl with (P := fun t => 0 < B - (Rabs (a t) + Rabs (b t) + Rabs (c t))).
      + intros t L v U. unfold K_at, at_, dot. fold (a t). fold (b t). fold (c t).
        assert (S : forall k z, z * z <= 1 -> k * z <= Rabs k).
        { intros k z Z. assert (Z1 : Rabs z <= 1).
          { apply Rabs_le. split; apply Rnot_lt_le; intros X.
            - assert (0 < (- z - 1) * (- z + 1)) by (apply Rmult_lt_0_compat; lra). lra.
            - assert (0 < (z - 1) * (z + 1)) by (apply Rmult_lt_0_compat; lra). lra. }
          apply Rle_trans with (Rabs (k * z)); [apply Rle_abs|]. rewrite Rabs_mult. rewrite <- (Rmult_1_r (Rabs k)) at 2.
          apply Rmult_le_compat_l; [apply Rabs_pos|exact Z1]. }
        unfold unit in U. pose proof (sq (vx v)). pose proof (sq (vy v)).
        pose proof (S (a t) (vx v) ltac:(lra)). pose proof (S (b t) (vy v) ltac:(lra)). pose proof (Rle_abs (c t)). lra.
      + apply before_positive; [|unfold B; lra]. apply minus_continuous; [apply constant_continuous|].
        apply plus_continuous; [apply plus_continuous|]; apply abs_continuous; assumption.
  Qed.
  Lemma bounded_list L : (forall q, In q L -> oriented (cfg t0) D q) ->
    exists B, 0 < B /\ before t0 (fun t => forall q, In q L -> forall v, unit v -> K_at (cfg t) (el q) (er q) v <= B).
  Proof.
    induction L as [|p L IH]; intros H.
    - exists 1. split; [lra|]. exists 1. split; [lra|]. intros u _ q [].
    - destruct (bounded_one p) as (B & PB & HB); [apply H; left; reflexivity|].
      destruct IH as (C & PC & HC); [intros q I; apply H; right; exact I|].
      exists (Rmax B C). pose proof (Rmax_l B C). pose proof (Rmax_r B C). split; [lra|].
      apply (before_impl t0) with (2 := before_and _ _ _ HB HC). intros t [X Y] q [<-|I] v U.
      + specialize (X v U). lra.
      + specialize (Y q I v U). lra.
  Qed.
  Lemma bounded : exists B, 0 < B /\ before t0 (fun t => forall q, oriented (cfg t0) D q -> forall v, unit v -> K_at (cfg t) (el q) (er q) v <= B).
  Proof.
    destruct (bounded_list (all_oriented (cfg t0) D)) as (B & P & H); [intros q; apply all_oriented_in|].
    exists B. split; [exact P|]. apply (before_impl t0) with (2 := H). intros t X q O. apply X, all_oriented_in, O.
  Qed.

  (* 4.2: all pairs are right at t0. *)
  Lemma right_at_last g h : In g gens -> In h gens -> g <> h -> wall (cfg t0 g) = false ->
    wall (cfg t0 h) = true \/ radius (cfg t0 g) <= radius (cfg t0 h) -> right_pair (cfg t0 g) (cfg t0 h).
  Proof.
    intros Ig Ih N Wg S. apply (right_sign_is cfg M t0). apply Rnot_le_lt. intros L.
    destruct bounded as (B & PB & HB). assert (Pm : 0 < / B) by (apply Rinv_0_lt_compat, PB).
    assert (Pmm : 0 < / B * / B) by (apply Rmult_lt_0_compat; exact Pm).
    assert (C : before t0 (fun t => 0 < / B * / B - right_sign cfg t0 g h t)).
    { apply before_positive; [|lra]. apply minus_continuous; [apply constant_continuous|apply (right_sign_continuous cfg M)]. }
    apply (at_once _ (before_and _ _ _ HB C)). intros t [Bt Ct] V.
    assert (Wgt : wall (cfg t g) = false) by (rewrite (wall_then t t0); exact Wg).
    destruct (gap_values (cfg t g) (cfg t h)) as (G & (v & Uv & Ev) & _); [exact Wgt|apply moving_proper|apply moving_proper|apply (all_right _ _ _ V); assumption|].
    destruct (all_around gens (cfg t) D (walls _ M t) (moving_proper t) F (all_there _ _ _ V) g v Ig Wgt Uv) as (q & O & E & A).
    pose proof (oriented_then t t0 q O) as O0.
    assert (H : K_at (cfg t) g h v <= B).
    { destruct (Pos.eq_dec h (er q)) as [X|X].
      - exfalso. destruct (There q O0) as [_ (_ & R & _)]. rewrite E, <- X in R. apply (right_sign_is cfg M t0) in R. lra.
      - pose proof (envelope _ _ _ V q v h O Uv A Ih ltac:(congruence) X) as K. pose proof (Bt q O0 v Uv). rewrite E in *. lra. }
    unfold K_at in H.
    assert (Gm : / B <= gap (cfg t g) (cfg t h)).
    { apply (Rmult_le_reg_l B); [exact PB|]. rewrite Rinv_r by lra. rewrite <- Ev. apply Rmult_le_compat_r; lra. }
    pose proof (gap_apart _ _ _ Pm Gm) as T. unfold right_sign in Ct. rewrite Wg in Ct. simpl in Ct.
    rewrite (wall_then t t0 h), (radii _ M t t0 g), (radii _ M t t0 h) in T. specialize (T S).
    destruct (wall (cfg t0 h)); lra.
  Qed.
  Lemma right_all g h : In g gens -> In h gens -> g <> h -> right_pair (cfg t0 g) (cfg t0 h).
  Proof.
    intros Ig Ih N. destruct (wall (cfg t0 g)) eqn:Wg.
    - apply right_swap, right_at_last; try assumption; [congruence| |left; exact Wg].
      rewrite (walls _ M) in *. apply Pos.eqb_eq in Wg. apply Pos.eqb_neq. congruence.
    - destruct (wall (cfg t0 h)) eqn:Wh; [apply right_at_last; try assumption; left; exact Wh|].
      destruct (Rle_dec (radius (cfg t0 g)) (radius (cfg t0 h))) as [L|L]; [apply right_at_last; try assumption; right; exact L|].
      apply right_swap, right_at_last; try assumption; [congruence|right; lra].
  Qed.

  (* 4.1: the arcs. *)
  Section OneEdge.
    Variable q : edge.
    Variable g : gen.
    Hypothesis O : oriented (cfg t0) D q.
    Hypothesis Ig : In g gens.
    Hypothesis Nl : g <> el q.
    Hypothesis Nr : g <> er q.
    Lemma nonzero_g : tang (seen_at (cfg t0 (el q)) (cfg t0 g)) <> 0.
    Proof.
      apply (right_tang_nonzero cfg M); [exact (proj2 O)|]. apply right_all; [apply (oriented_names _ _ _ _ F O)|exact Ig|congruence].
    Qed.
    Lemma nonzero_r : tang (seen_at (cfg t0 (el q)) (cfg t0 (er q))) <> 0.
    Proof. destruct (There q O) as [_ (W & R & _)]. apply (right_tang_nonzero cfg M); assumption. Qed.

    (* A direction that moves continuously and lies on the arc before t0. *)
    Lemma limit_direction (u : R -> vec) : continuity_pt (fun t => vx (u t)) t0 -> continuity_pt (fun t => vy (u t)) t0 ->
      before t0 (fun t => voronoi gens (cfg t) D -> unit (u t) /\ on_arc (start_of (cfg t) q) (end_of (cfg t) q) (u t)) ->
      K_at (cfg t0) (el q) g (u t0) <= K_at (cfg t0) (el q) (er q) (u t0).
    Proof.
      intros X Y A. apply Rnot_lt_le. intros L.
      destruct (K_continuous cfg M t0 _ _ nonzero_g) as (A1 & B1 & C1). destruct (K_continuous cfg M t0 _ _ nonzero_r) as (A2 & B2 & C2).
      pose proof (proj1 (affine_continuous t0 _ u A1 B1 C1 X Y)) as G. pose proof (proj1 (affine_continuous t0 _ u A2 B2 C2 X Y)) as H.
      pose proof (before_positive _ t0 (minus_continuous _ _ _ G H) ltac:(unfold K_at in L; lra)) as P.
      apply (at_once _ (before_and _ _ _ A P)). intros t [At Pt] V. destruct (At V) as [U On].
      pose proof (envelope _ _ _ V q (u t) g (oriented_then t0 t q O) U On Ig Nl Nr) as E. unfold K_at in E. lra.
    Qed.
    Lemma limit_start : K_at (cfg t0) (el q) g (start_of (cfg t0) q) <= K_at (cfg t0) (el q) (er q) (start_of (cfg t0) q).
    Proof.
      destruct (There q O) as [V1 _]. destruct (dir_continuous cfg M t0 _ _ _ V1) as [X Y].
      apply (limit_direction (fun t => start_of (cfg t) q) X Y). exists 1. split; [lra|]. intros t _ V.
      split; [|apply start_on_arc]. exact (proj1 (vertex_dir _ _ _ (proj1 (all_there _ _ _ V q (oriented_then t0 t q O))))).
    Qed.
    Lemma limit_end : K_at (cfg t0) (el q) g (end_of (cfg t0) q) <= K_at (cfg t0) (el q) (er q) (end_of (cfg t0) q).
    Proof.
      destruct (There q O) as [_ V2]. destruct (dir_continuous cfg M t0 _ _ _ V2) as [X Y].
      apply (limit_direction (fun t => end_of (cfg t) q) X Y). exists 1. split; [lra|]. intros t _ V.
      split; [|apply end_on_arc]. exact (proj1 (vertex_dir _ _ _ (proj2 (all_there _ _ _ V q (oriented_then t0 t q O))))).
    Qed.
    Lemma limit_within u : unit u -> 0 < chord (start_of (cfg t0) q) (end_of (cfg t0) q) u ->
      K_at (cfg t0) (el q) g u <= K_at (cfg t0) (el q) (er q) u.
    Proof.
      intros U C. destruct (There q O) as [V1 V2].
      destruct (dir_continuous cfg M t0 _ _ _ V1) as [X1 Y1]. destruct (dir_continuous cfg M t0 _ _ _ V2) as [X2 Y2].
      apply (limit_direction (fun _ => u)); [apply constant_continuous|apply constant_continuous|].
      assert (B : before t0 (fun t => 0 < chord (start_of (cfg t) q) (end_of (cfg t) q) u)).
      { apply before_positive; [|exact C]. unfold chord, cross, minus, start_of, end_of; cbv [Arc.vx Arc.vy].
        unfold Arc.vx in X1, X2. unfold Arc.vy in Y1, Y2.
        apply minus_continuous; apply mult_continuous; apply minus_continuous; assumption || apply constant_continuous. }
      apply (before_impl t0) with (2 := B). intros t P _. split; [exact U|]. right. split; [|lra].
      intros Z. rewrite Z in P. unfold chord, cross, minus in P; simpl in P. lra.
    Qed.
  End OneEdge.
End Limit.

(* It is enough that it is not true that D is wrong at all times just before t0. *)
Theorem closed_unless gens (cfg : R -> gen -> generator) D t0 : moves cfg -> fits gens D ->
  ~ before t0 (fun t => ~ voronoi gens (cfg t) D) ->
  (forall q, oriented (cfg t0) D q -> both_there (cfg t0) q) -> voronoi gens (cfg t0) D.
Proof.
  intros M F Often There. constructor; [intros g h; apply (right_all gens cfg D t0); assumption|exact There|].
  intros q u g O U A Ig Nl Nr. destruct (There q O) as [V1 V2]. apply vertex_dir in V1 as [U1 _]. apply vertex_dir in V2 as [U2 _].
  fold (start_of (cfg t0) q) in U1. fold (end_of (cfg t0) q) in U2.
  assert (S : u = start_of (cfg t0) q \/ u = end_of (cfg t0) q \/ 0 < chord (start_of (cfg t0) q) (end_of (cfg t0) q) u).
  { destruct A as [[_ E]|[N C]]; [tauto|]. destruct C as [C|C]; [tauto|].
    destruct (chord_ends _ _ _ U1 U2 U N) as [E|E]; [congruence|tauto|tauto]. }
  destruct S as [->|[->|C]].
  - apply (limit_start gens cfg D t0); assumption.
  - apply (limit_end gens cfg D t0); assumption.
  - apply (limit_within gens cfg D t0); assumption.
Qed.

Theorem closed gens (cfg : R -> gen -> generator) D t0 : moves cfg -> fits gens D ->
  (forall d, 0 < d -> exists t, t0 - d < t < t0 /\ voronoi gens (cfg t) D) ->
  (forall q, oriented (cfg t0) D q -> both_there (cfg t0) q) -> voronoi gens (cfg t0) D.
Proof.
  intros M F Often. apply closed_unless; try assumption. intros (d & Hd & H). destruct (Often d Hd) as (t & L & V). exact (H t L V).
Qed.

(* A disk that overlaps another generator overlaps a neighbour, since the greatest of the functions about it is a neighbour's. *)
Lemma overlap_of_disk gens cfg D i j : (forall g, wall (cfg g) = Pos.eqb g container) -> (forall g, proper (cfg g)) -> fits gens D ->
  voronoi gens cfg D -> In i gens -> In j gens -> i <> j -> wall (cfg i) = false -> ~ apart (cfg i) (cfg j) ->
  exists q b, In q D /\ between q i b /\ ~ apart (cfg i) (cfg b).
Proof.
  intros W P F V Ii Ij N Wi H. rewrite (apart_gap _ _ Wi) in H.
  destruct (gap_values _ _ Wi (P i) (P j) (all_right _ _ _ V i j Ii Ij N)) as (G & (v & Uv & Ev) & _).
  destruct (all_around gens cfg D W P F (all_there _ _ _ V) i v Ii Wi Uv) as (q & O & E & A).
  assert (R : right_pair (cfg i) (cfg (er q))).
  { destruct (all_there _ _ _ V q O) as [_ (_ & R & _)]. rewrite E in R. exact R. }
  destruct (gap_values _ _ Wi (P i) (P (er q)) R) as (Ga & _ & La). specialize (La v Uv).
  assert (K : at_ (Kg (cfg i) (cfg j)) v <= at_ (Kg (cfg i) (cfg (er q))) v).
  { destruct (Pos.eq_dec j (er q)) as [->|X]; [lra|].
    pose proof (envelope _ _ _ V q v j O Uv A Ij ltac:(congruence) X) as K. rewrite E in K. exact K. }
  assert (S : gap (cfg i) (cfg (er q)) <= gap (cfg i) (cfg j)).
  { set (k := at_ (Kg (cfg i) (cfg j)) v) in *. assert (0 < k).
    { apply Rnot_le_lt. intros X. assert (0 <= - k * gap (cfg i) (cfg j)) by (apply Rmult_le_pos; lra). lra. }
    apply (Rmult_le_reg_l k); [assumption|]. rewrite Ev.
    apply Rle_trans with (2 := La). apply Rmult_le_compat_r; lra. }
  assert (X : ~ apart (cfg i) (cfg (er q))) by (rewrite (apart_gap _ _ Wi); lra).
  destruct O as [[I|I] _]; [exists q|exists (reversed q)]; exists (er q); (split; [exact I|]); (split; [|exact X]); unfold between; simpl; tauto.
Qed.

Theorem overlap_of_neighbours gens cfg D i j : (forall g, wall (cfg g) = Pos.eqb g container) -> (forall g, proper (cfg g)) -> fits gens D ->
  voronoi gens cfg D -> In i gens -> In j gens -> i <> j -> ~ apart (cfg i) (cfg j) ->
  exists q a b, In q D /\ between q a b /\ (a = i \/ a = j) /\ ~ apart (cfg a) (cfg b).
Proof.
  intros W P F V Ii Ij N H. destruct (wall (cfg i)) eqn:Wi.
  - assert (Wj : wall (cfg j) = false). { rewrite W in *. apply Pos.eqb_eq in Wi. apply Pos.eqb_neq. congruence. }
    destruct (overlap_of_disk gens cfg D j i W P F V) as (q & b & I & B & X); try assumption; [congruence|intros Y; apply H, apart_swap, Y|].
    exists q, j, b. tauto.
  - destruct (overlap_of_disk gens cfg D i j W P F V) as (q & b & I & B & X); try assumption. exists q, i, b. tauto.
Qed.

(* The circle of a side about a disk. *)
Lemma circle_of_side gens cfg D a b c : (forall g, proper (cfg g)) -> fits gens D ->
  voronoi gens cfg D -> side D a b c -> wall (cfg a) = false ->
  exists o, vertex_circle o (cfg a) (cfg b) (cfg c) /\ forall g, In g gens -> empty_of o (cfg g).
Proof.
  intros P F V S W. destruct (side_oriented cfg D a b c S W) as (q & O & <- & <- & <-).
  destruct (all_there _ _ _ V q O) as [_ T]. destruct (circle_of_vertex _ _ _ (P _) (P _) (P _) T) as (o & Vo & _). exists o. split; [exact Vo|].
  intros g Ig. pose proof Vo as (Ta & Tb & _).
  assert (Touch : forall h, touches o h -> empty_of o h) by (unfold touches, empty_of; intros; lra).
  destruct (Pos.eq_dec g (el q)) as [->|Na]; [apply Touch, Ta|]. destruct (Pos.eq_dec g (er q)) as [->|Nb]; [apply Touch, Tb|].
  apply (circle_and_other o _ _ _ _ (P _) (P _) (P _) (P g) T Vo).
  - apply (all_right _ _ _ V); [apply (oriented_names _ _ _ _ F O)|exact Ig|congruence].
  - apply (envelope _ _ _ V q (end_of cfg q) g O); try assumption; [exact (proj1 (vertex_dir _ _ _ T))|apply end_on_arc].
Qed.

Lemma vertex_circle_turn o a b c : vertex_circle o a b c -> vertex_circle o b c a.
Proof. unfold vertex_circle, counterclockwise. intros (A & B & C & H). repeat split; try assumption. lra. Qed.

(* [fits] and [voronoi] alone allow an edge that names nothing but the container; its sides have no circle (ClosedCounter.v). *)
Theorem circles_empty gens cfg D a b c : (forall g, wall (cfg g) = Pos.eqb g container) -> (forall g, proper (cfg g)) -> fits gens D ->
  voronoi gens cfg D -> side D a b c -> a <> container \/ b <> container \/ c <> container ->
  exists o, vertex_circle o (cfg a) (cfg b) (cfg c) /\ forall g, In g gens -> empty_of o (cfg g).
Proof.
  intros W P F V S N. assert (Disk : forall g, g <> container -> wall (cfg g) = false) by (intros g X; rewrite W; apply Pos.eqb_neq, X).
  pose proof (sides_turn _ _ F _ _ _ S) as S1. pose proof (sides_turn _ _ F _ _ _ S1) as S2. destruct N as [N|[N|N]].
  - apply (circle_of_side gens cfg D); try assumption. apply Disk, N.
  - destruct (circle_of_side gens cfg D b c a P F V S1 (Disk b N)) as (o & Vo & E). exists o. split; [|exact E].
    apply vertex_circle_turn, vertex_circle_turn, Vo.
  - destruct (circle_of_side gens cfg D c a b P F V S2 (Disk c N)) as (o & Vo & E). exists o. split; [|exact E].
    apply vertex_circle_turn, Vo.
Qed.
