(* Near an instant at which the diagram is right it stays right, if the edges without length stay legal. *)
From Coq Require Import Reals Lra List Bool PArith.
From Voroproof Require Import Geometry Vertex Scale History Arc Cyclic Cover Spread Envelope Near Link Corners.
Import ListNotations.
Open Scope R_scope.

(* Arcs at one instant. [arc] is [on_arc] of Envelope.v. *)
Local Notation arc := Envelope.on_arc.

(* The cap right of the chord of a short arc, defined also where its ends are one. *)
Definition cap (p q u : vec) : R := dot p u + dot q u - 1 - dot p q.

Lemma cap_chord p q u : unit p -> unit q -> cross p q * cap p q u = chord p q u * (1 + dot p q).
Proof.
  destruct p as [a b], q as [c d], u as [x y]. unfold unit, cap, chord, cross, dot, minus; cbn [vx vy]. intros P Q.
  assert (P' : a * a = 1 - b * b) by lra. assert (Q' : c * c = 1 - d * d) by lra.
  replace ((a * d - b * c) * (a * x + b * y + (c * x + d * y) - 1 - (a * c + b * d))) with
    (a * a * d * x + a * b * d * y + a * c * d * x + a * d * d * y - a * d - a * a * c * d - a * b * d * d
     - a * b * c * x - b * b * c * y - c * c * b * x - b * c * d * y + b * c + c * c * a * b + b * b * c * d) by ring.
  replace (((x - a) * (d - b) - (y - b) * (c - a)) * (1 + (a * c + b * d))) with
    (x * d - x * b - a * d - y * c + y * a + b * c
     + (a * c * d * x - a * b * c * x - a * a * c * d - c * c * a * y + a * a * c * y + c * c * a * b)
     + (b * d * d * x - b * b * d * x - a * b * d * d - b * c * d * y + a * b * d * y + b * b * c * d)) by ring.
  rewrite P', Q'. ring.
Qed.

Lemma same_of_cross p q : unit p -> unit q -> 0 < 1 + dot p q -> cross p q = 0 -> p = q.
Proof.
  intros P Q D C. apply dot_one; [exact P|exact Q|].
  assert (E : dot p q * dot p q + cross p q * cross p q = 1).
  { transitivity ((vx p * vx p + vy p * vy p) * (vx q * vx q + vy q * vy q)); [unfold dot, cross; ring|].
    unfold unit in P, Q. rewrite P, Q. ring. }
  rewrite C in E. assert (Z : (1 + dot p q) * (1 - dot p q) = 0) by lra. apply Rmult_integral in Z. destruct Z; lra.
Qed.

Lemma same_or_not (p q : vec) : p = q \/ p <> q.
Proof.
  destruct p as [a b], q as [c d]. destruct (Req_dec a c) as [->|N]; [|right; congruence].
  destruct (Req_dec b d) as [->|N]; [left; reflexivity|right; congruence].
Qed.

Lemma crosses_norm f : crosses f -> 0 < norm f /\ fb f - norm f < 0.
Proof.
  unfold crosses. rewrite <- norm_square. intros H. assert (N : 0 <= norm f) by apply sqrt_pos.
  assert (B : fb f < norm f). { apply Rnot_le_lt. intros L. pose proof (Rmult_le_compat _ _ _ _ N N L L). lra. }
  split; [|lra]. destruct N as [N|N]; [exact N|]. exfalso. rewrite <- N in *. pose proof (sq (fb f)). lra.
Qed.

(* A long arc: the least direction is beyond the chord. *)
Lemma long_arc f p q u : crosses f -> unit p -> unit q -> unit u -> 0 <= at_ f p -> 0 <= at_ f q -> chord p q (least f) < 0 ->
  arc p q u -> 0 <= at_ f u.
Proof.
  intros C P Q U Fp Fq L [[E ->]|[N A]]; [exact Fp|]. apply (arc_not_negative f p q u); try assumption.
  right. split; [apply crosses_norm, C|exact L].
Qed.

(* A short arc: the least direction is not in the cap. *)
Lemma short_arc f p q u : crosses f -> unit p -> unit q -> unit u -> 0 <= at_ f p -> 0 <= at_ f q -> cap p q (least f) < 0 ->
  0 < 1 + dot p q -> 0 <= cross p q -> arc p q u -> 0 <= at_ f u.
Proof.
  intros C P Q U Fp Fq L D X A. destruct A as [[E ->]|[N A]]; [exact Fp|].
  apply (long_arc f p q u); try assumption; [|right; split; assumption].
  assert (X' : 0 < cross p q). { destruct X as [X|X]; [exact X|]. destruct N. apply same_of_cross; auto. }
  pose proof (cap_chord p q (least f) P Q) as E. apply Rnot_le_lt. intros H.
  assert (0 <= chord p q (least f) * (1 + dot p q)) by (apply Rmult_le_pos; lra).
  assert (0 < cross p q * - cap p q (least f)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(* The least direction is outside an arc where the function is not negative. *)
Lemma least_outside f p q : crosses f -> (forall u, unit u -> arc p q u -> 0 <= at_ f u) -> ~ arc p q (least f).
Proof.
  intros C H A. destruct (crosses_norm f C) as [N L]. specialize (H _ (least_unit f N) A). rewrite least_value in H by exact N. lra.
Qed.

(* Vectors and affine functions that are continuous at an instant. *)
Section Continuous.
  Variable t0 : R.
  Definition steady (u : R -> vec) : Prop := continuity_pt (fun t => vx (u t)) t0 /\ continuity_pt (fun t => vy (u t)) t0.
  Definition steady_affine (f : R -> affine) : Prop := continuity_pt (fun t => vx (fa (f t))) t0 /\ continuity_pt (fun t => vy (fa (f t))) t0 /\
    continuity_pt (fun t => fb (f t)) t0.

  Lemma c_plus f g : continuity_pt f t0 -> continuity_pt g t0 -> continuity_pt (fun t => f t + g t) t0.
  Proof. exact (continuity_pt_plus f g t0). Qed.
  Lemma c_minus f g : continuity_pt f t0 -> continuity_pt g t0 -> continuity_pt (fun t => f t - g t) t0.
  Proof. exact (continuity_pt_minus f g t0). Qed.
  Lemma c_mult f g : continuity_pt f t0 -> continuity_pt g t0 -> continuity_pt (fun t => f t * g t) t0.
  Proof. exact (continuity_pt_mult f g t0). Qed.
  Lemma c_opp f : continuity_pt f t0 -> continuity_pt (fun t => - f t) t0.
  Proof. exact (continuity_pt_opp f t0). Qed.
  Lemma c_div f g : continuity_pt f t0 -> continuity_pt g t0 -> g t0 <> 0 -> continuity_pt (fun t => f t / g t) t0.
  Proof. exact (continuity_pt_div f g t0). Qed.
  Lemma c_const c : continuity_pt (fun _ => c) t0.
  Proof. apply continuity_pt_const. intros x y. reflexivity. Qed.
  Lemma c_abs f : continuity_pt f t0 -> continuity_pt (fun t => Rabs (f t)) t0.
  Proof. intros H. exact (continuity_pt_comp f Rabs t0 H (Rcontinuity_abs (f t0))). Qed.
  Lemma c_sqrt f : continuity_pt f t0 -> 0 <= f t0 -> continuity_pt (fun t => sqrt (f t)) t0.
  Proof. intros H P. exact (continuity_pt_comp f sqrt t0 H (continuity_pt_sqrt (f t0) P)). Qed.

  Lemma steady_minus u v : steady u -> steady v -> steady (fun t => minus (u t) (v t)).
  Proof. intros [A B] [C D]. unfold minus; split; cbn [vx vy]; apply c_minus; assumption. Qed.
  Lemma steady_dot u v : steady u -> steady v -> continuity_pt (fun t => dot (u t) (v t)) t0.
  Proof. intros [A B] [C D]. unfold dot. apply c_plus; apply c_mult; assumption. Qed.
  Lemma steady_cross u v : steady u -> steady v -> continuity_pt (fun t => cross (u t) (v t)) t0.
  Proof. intros [A B] [C D]. unfold cross. apply c_minus; apply c_mult; assumption. Qed.
  Lemma steady_chord p q u : steady p -> steady q -> steady u -> continuity_pt (fun t => chord (p t) (q t) (u t)) t0.
  Proof.
    intros P Q U. unfold chord. apply (steady_cross (fun t => minus (u t) (p t)) (fun t => minus (q t) (p t))); apply steady_minus; assumption.
  Qed.
  Lemma steady_cap p q u : steady p -> steady q -> steady u -> continuity_pt (fun t => cap (p t) (q t) (u t)) t0.
  Proof.
    intros P Q U. unfold cap. apply c_minus; [apply c_minus; [apply c_plus|apply c_const]|]; apply steady_dot; assumption.
  Qed.
  Lemma steady_diff f g : steady_affine f -> steady_affine g -> steady_affine (fun t => diff (f t) (g t)).
  Proof. intros (A & B & C) (A' & B' & C'). unfold diff, minus, steady_affine; cbn [vx vy fa fb]. repeat split; apply c_minus; assumption. Qed.
  Lemma steady_fa f : steady_affine f -> steady (fun t => fa (f t)).
  Proof. intros (A & B & _). split; assumption. Qed.
  Lemma steady_slope f u : steady_affine f -> steady u -> continuity_pt (fun t => slope (f t) (u t)) t0.
  Proof.
    intros (A & B & C) (X & Y). unfold slope. apply (steady_dot (fun t => fa (f t)) (fun t => turn (u t))); [split; assumption|].
    unfold turn, steady; cbn [vx vy]. split; [apply c_opp, Y|exact X].
  Qed.
  Lemma steady_least f : steady_affine f -> 0 < norm (f t0) -> steady (fun t => least (f t)).
  Proof.
    intros (A & B & _) N.
    assert (C : continuity_pt (fun t => norm (f t)) t0).
    { unfold norm. apply (c_sqrt (fun t => vx (fa (f t)) * vx (fa (f t)) + vy (fa (f t)) * vy (fa (f t)))).
      - apply c_plus; apply c_mult; assumption.
      - pose proof (sq (vx (fa (f t0)))). pose proof (sq (vy (fa (f t0)))). lra. }
    unfold least, steady; cbn [vx vy]. split.
    - apply (c_div (fun t => - vx (fa (f t))) (fun t => norm (f t))); [apply c_opp, A|exact C|lra].
    - apply (c_div (fun t => - vy (fa (f t))) (fun t => norm (f t))); [apply c_opp, B|exact C|lra].
  Qed.
End Continuous.

Lemma after_negative f t : continuity_pt f t -> f t < 0 -> after t (fun u => f u < 0).
Proof.
  intros C N. apply (after_impl t (fun u => 0 < - f u)); [intros u H; lra|].
  apply (after_positive (fun u => - f u)); [apply c_opp, C|lra].
Qed.
Lemma after_always t (P : R -> Prop) : (forall u, P u) -> after t P.
Proof. intros H. exists 1. split; [lra|]. intros u _. apply H. Qed.

(* Sides and ends of edges. *)
Lemma reversed_twice q : reversed (reversed q) = q.
Proof. destruct q. reflexivity. Qed.

Lemma circle_turn c i j k : vertex_circle c i j k -> vertex_circle c j k i.
Proof. unfold vertex_circle, counterclockwise. intros (A & B & C & E). repeat split; try assumption. lra. Qed.

Lemma circles_reversed say l r s e : circles say l r s e -> circles say r l e s.
Proof.
  intros [(c & Vc & Sc) (d & Vd & Sd)]. split.
  - exists d. split; [apply circle_turn, Vd|exact Sd].
  - exists c. split; [do 2 apply circle_turn; exact Vc|exact Sc].
Qed.

Lemma right_irreflexive g h : right_pair g h -> g <> h.
Proof. intros H ->. unfold right_pair in H. destruct (wall h || wall h); lra. Qed.

Section Local.
  Variable gens : list gen.
  Variable cfg : R -> gen -> generator.
  Variable D : list edge.
  Variable t0 : R.
  Hypothesis M : moves cfg.
  Hypothesis F : fits gens D.
  Hypothesis V : voronoi gens (cfg t0) D.

  Let ways := D ++ map reversed D.

  Lemma oriented_is t q : oriented (cfg t) D q <-> In q ways /\ wall (cfg t0 (el q)) = false.
  Proof.
    unfold oriented, ways. rewrite in_app_iff, in_map_iff, !(walls cfg M). split; intros [H W]; (split; [|exact W]).
    - destruct H as [H|H]; [left; exact H|]. right. exists (reversed q). split; [apply reversed_twice|exact H].
    - destruct H as [H|(q' & <- & H)]; [left; exact H|]. right. rewrite reversed_twice. exact H.
  Qed.

  Lemma moving_proper t g : proper (cfg t g).
  Proof.
    unfold proper. rewrite (walls cfg M). destruct (Pos.eqb_spec g container) as [->|N].
    - apply (proper_wall cfg M).
    - apply (proper_disk cfg M), N.
  Qed.

  Lemma one_wall t g h : g <> h -> wall (cfg t g) && wall (cfg t h) = false.
  Proof.
    intros N. rewrite !(walls cfg M). destruct (Pos.eqb_spec g container); [|reflexivity].
    destruct (Pos.eqb_spec h container); [congruence|reflexivity].
  Qed.

  Lemma way_names q : In q ways -> In (el q) gens /\ In (er q) gens /\ In (es q) gens /\ In (ee q) gens.
  Proof.
    unfold ways. rewrite in_app_iff, in_map_iff. intros [H|(q' & <- & H)].
    - repeat split; apply (names_in gens D F q _ H); cbn [In]; tauto.
    - destruct q' as [a b c d]. repeat split; apply (names_in gens D F _ _ H); cbn [In el er es ee reversed]; tauto.
  Qed.

  Lemma way_sides q : In q ways -> side D (el q) (es q) (er q) /\ side D (el q) (er q) (ee q).
  Proof.
    intros H. assert (S : side D (er q) (el q) (es q) /\ side D (el q) (er q) (ee q)).
    { unfold ways in H. rewrite in_app_iff, in_map_iff in H. destruct H as [H|(q' & <- & H)]; split.
      - exists q. split; [exact H|]. right. auto.
      - exists q. split; [exact H|]. left. auto.
      - exists q'. split; [exact H|]. left. destruct q'. auto.
      - exists q'. split; [exact H|]. right. destruct q'. auto. }
    destruct S as [S T]. split; [|exact T]. apply (sides_turn gens D F), S.
  Qed.

  Lemma short_legal_way t q : In q ways -> short_legal cfg D t0 t ->
    pinched (cfg t0 (el q)) (cfg t0 (er q)) (cfg t0 (es q)) (cfg t0 (ee q)) ->
    legal (cfg t (el q)) (cfg t (er q)) (cfg t (es q)) (cfg t (ee q)).
  Proof.
    unfold ways. rewrite in_app_iff, in_map_iff. intros [H|(q' & <- & H)] S C.
    - apply S; assumption.
    - apply circles_reversed, S; [exact H|]. destruct q' as [a b c d]. cbn [el er es ee reversed] in *. apply pinched_turn, C.
  Qed.

  (* Pairs and circles. *)
  Definition pairs_right (t : R) : Prop := forall g, In g gens -> forall h, In h gens -> g <> h -> right_pair (cfg t g) (cfg t h).
  Definition circles_there (t : R) : Prop := forall q, In q ways -> wall (cfg t0 (el q)) = false -> both_there (cfg t) q.

  Lemma pairs_after : after t0 pairs_right.
  Proof.
    unfold pairs_right. apply after_list. intros g Ig. apply after_list. intros h Ih.
    destruct (Pos.eq_dec g h) as [->|N]; [apply after_always; congruence|].
    apply (after_impl t0 (fun t => right_pair (cfg t g) (cfg t h))); [auto|].
    apply (right_after cfg M). apply (all_right _ _ _ V); assumption.
  Qed.

  Lemma there_after : after t0 circles_there.
  Proof.
    unfold circles_there. apply after_list. intros q Iq. destruct (wall (cfg t0 (el q))) eqn:W; [apply after_always; congruence|].
    assert (O : oriented (cfg t0) D q) by (apply (oriented_is t0); split; assumption).
    destruct (all_there _ _ _ V q O) as [S E].
    apply (after_impl t0 (fun t => vertex (cfg t (el q)) (cfg t (es q)) (cfg t (er q)) /\ vertex (cfg t (el q)) (cfg t (er q)) (cfg t (ee q)))).
    - intros u H _. exact H.
    - apply after_and; apply (vertex_after cfg M); assumption.
  Qed.

  (* The ends of an edge are empty of g, if the circles of vertices are. *)
  Definition corners_empty (t : R) : Prop := forall a b c g, side D a b c -> In g gens ->
    forall o, vertex_circle o (cfg t a) (cfg t b) (cfg t c) -> empty_of o (cfg t g).

  Lemma ends_right t q g : corners_empty t -> pairs_right t -> In q ways -> both_there (cfg t) q -> In g gens -> g <> el q ->
    0 <= at_ (diff (Kg (cfg t (el q)) (cfg t (er q))) (Kg (cfg t (el q)) (cfg t g))) (start_of (cfg t) q) /\
    0 <= at_ (diff (Kg (cfg t (el q)) (cfg t (er q))) (Kg (cfg t (el q)) (cfg t g))) (end_of (cfg t) q).
  Proof.
    intros C R Iq [S E] Ig N. destruct (way_names q Iq) as (Il & _). destruct (way_sides q Iq) as [S1 S2].
    assert (Rg : right_pair (cfg t (el q)) (cfg t g)) by (apply R; auto).
    assert (X : forall f h u, at_ h u <= at_ f u -> 0 <= at_ (diff f h) u).
    { intros f h u H. unfold at_, dot, diff, minus in *; cbn [vx vy fa fb] in *. lra. }
    split; apply X.
    - destruct (circle_of_vertex _ _ _ (moving_proper t (el q)) (moving_proper t (es q)) (moving_proper t (er q)) S) as (c & Vc & _).
      pose proof (C _ _ _ g S1 Ig c Vc) as Em.
      apply (circle_and_other c _ _ _ _ (moving_proper t (el q)) (moving_proper t (es q)) (moving_proper t (er q)) (moving_proper t g) S Vc Rg) in Em.
      destruct (vertex_dir _ _ _ S) as (_ & Z & _). unfold start_of. rewrite Z. exact Em.
    - destruct (circle_of_vertex _ _ _ (moving_proper t (el q)) (moving_proper t (er q)) (moving_proper t (ee q)) E) as (c & Vc & _).
      pose proof (C _ _ _ g S2 Ig c Vc) as Em.
      apply (circle_and_other c _ _ _ _ (moving_proper t (el q)) (moving_proper t (er q)) (moving_proper t (ee q)) (moving_proper t g) E Vc Rg) in Em.
      unfold end_of. exact Em.
  Qed.

  (* One edge and one generator. *)
  Section One.
    Variable q : edge.
    Variable g : gen.
    Hypothesis Iq : In q ways.
    Hypothesis Wq : wall (cfg t0 (el q)) = false.
    Hypothesis Ig : In g gens.
    Hypothesis Nl : g <> el q.
    Hypothesis Nr : g <> er q.

    Let l t := cfg t (el q).
    Let r t := cfg t (er q).
    Let f t := diff (Kg (l t) (r t)) (Kg (l t) (cfg t g)).
    Let p t := start_of (cfg t) q.
    Let z t := end_of (cfg t) q.
    Let m t := least (f t).

    Lemma now_there : both_there (cfg t0) q.
    Proof. apply (all_there _ _ _ V). apply (oriented_is t0). split; assumption. Qed.

    Lemma l_not_r : el q <> er q.
    Proof.
      destruct now_there as [(_ & _ & R & _) _]. intros E. apply right_irreflexive in R. rewrite E in R. auto.
    Qed.
    Lemma l_not_e : el q <> ee q.
    Proof. destruct now_there as [_ (_ & _ & R & _)]. intros E. apply right_irreflexive in R. rewrite E in R. auto. Qed.

    Lemma f_crosses t : pairs_right t -> crosses (f t).
    Proof.
      intros R. destruct (way_names q Iq) as (Il & Ir & _). unfold f, l, r. apply difference_crosses.
      - rewrite (walls cfg M) in *. exact Wq.
      - apply one_wall, Nr.
      - apply R; auto.
      - apply R; auto. apply l_not_r.
      - apply R; auto.
    Qed.

    Lemma steady_K h : In h gens -> h <> el q -> steady_affine t0 (fun t => Kg (l t) (cfg t h)).
    Proof.
      intros Ih N. apply (K_continuous cfg M).
      assert (R : right_pair (cfg t0 (el q)) (cfg t0 h)) by (apply (all_right _ _ _ V); auto; apply (way_names q Iq)).
      apply right_tang in R. destruct (wall (cfg t0 (el q)) || wall (cfg t0 h)); lra.
    Qed.
    Lemma steady_f : steady_affine t0 f.
    Proof.
      apply (steady_diff t0 (fun t => Kg (l t) (r t)) (fun t => Kg (l t) (cfg t g))); apply steady_K; auto.
      - apply (way_names q Iq).
      - pose proof l_not_r. auto.
    Qed.
    Lemma steady_p : steady t0 p.
    Proof. apply (dir_continuous cfg M t0 (el q) (es q) (er q)), now_there. Qed.
    Lemma steady_z : steady t0 z.
    Proof. apply (dir_continuous cfg M t0 (el q) (er q) (ee q)), now_there. Qed.

    Lemma pairs_now : pairs_right t0.
    Proof. intros a Ia b Ib N. apply (all_right _ _ _ V); assumption. Qed.

    Lemma norm_now : 0 < norm (f t0).
    Proof. apply crosses_norm, f_crosses, pairs_now. Qed.
    Lemma steady_m : steady t0 m.
    Proof. apply steady_least; [exact steady_f|exact norm_now]. Qed.

    Lemma m_outside : ~ arc (p t0) (z t0) (m t0).
    Proof.
      apply least_outside; [apply f_crosses, pairs_now|]. intros u U A.
      pose proof (envelope _ _ _ V q u g) as E. unfold K_at in E.
      assert (O : oriented (cfg t0) D q) by (apply (oriented_is t0); split; assumption).
      specialize (E O U A Ig Nl Nr). unfold f, l, r. unfold at_, dot, diff, minus in *; cbn [vx vy fa fb] in *. lra.
    Qed.

    Lemma units t : both_there (cfg t) q -> unit (p t) /\ unit (z t).
    Proof. intros [S E]. split; [apply (vertex_dir _ _ _ S)|apply (vertex_dir _ _ _ E)]. Qed.

    Definition kept (t : R) : Prop := short_legal cfg D t0 t -> pairs_right t -> circles_there t -> corners_empty t ->
      forall u, unit u -> arc (p t) (z t) u -> 0 <= at_ (f t) u.

    Lemma kept_long : p t0 <> z t0 -> after t0 kept.
    Proof.
      intros N. apply (after_impl t0 (fun t => chord (p t) (z t) (m t) < 0)).
      - intros t C _ R T E u U A. specialize (T q Iq Wq). destruct (units t T) as [Up Uz].
        destruct (ends_right t q g E R Iq T Ig Nl) as [Ep Ez].
        apply (long_arc (f t) (p t) (z t) u); try assumption. apply f_crosses, R.
      - apply (after_negative (fun t => chord (p t) (z t) (m t))).
        + apply steady_chord; [exact steady_p|exact steady_z|exact steady_m].
        + apply Rnot_le_lt. intros H. apply m_outside. right. split; assumption.
    Qed.

    (* The function that puts the ends of an edge without length in order. *)
    Let h t := diff (Kg (l t) (r t)) (Kg (l t) (cfg t (ee q))).
    Lemma steady_h : steady_affine t0 h.
    Proof.
      apply (steady_diff t0 (fun t => Kg (l t) (r t)) (fun t => Kg (l t) (cfg t (ee q)))); apply steady_K; try apply (way_names q Iq).
      - pose proof l_not_r. auto.
      - pose proof l_not_e. auto.
    Qed.
    Lemma h_end t : both_there (cfg t) q -> at_ (h t) (z t) = 0 /\ slope (h t) (z t) < 0.
    Proof.
      intros [_ E]. destruct (vertex_dir _ _ _ E) as (_ & Z & S). unfold h, z, end_of, l, r in *.
      unfold at_, slope, dot, diff, minus in *; cbn [vx vy fa fb turn] in *. split; lra.
    Qed.
    Lemma h_start t : both_there (cfg t) q -> legal (cfg t (el q)) (cfg t (er q)) (cfg t (es q)) (cfg t (ee q)) -> 0 <= at_ (h t) (p t).
    Proof.
      intros [S E] L. apply legal_link in L; try assumption; try apply moving_proper. destruct L as [L _].
      destruct (vertex_dir _ _ _ S) as (_ & Z & _). unfold level in L. rewrite <- Z in L. unfold h, p, start_of, l, r.
      unfold at_, dot, diff, minus in *; cbn [vx vy fa fb] in *. lra.
    Qed.

    Lemma kept_short : p t0 = z t0 -> after t0 kept.
    Proof.
      intros N. pose proof steady_p as Sp. pose proof steady_z as Sz. destruct (units t0 now_there) as [Up0 Uz0].
      assert (D1 : dot (p t0) (p t0) = 1) by exact Up0.
      assert (Sd : continuity_pt (fun t => 1 + dot (p t) (z t)) t0) by (apply c_plus; [apply c_const|apply steady_dot; assumption]).
      apply (after_impl t0 (fun t => (cap (p t) (z t) (m t) < 0 /\ 0 < 1 + dot (p t) (z t)) /\
        slope (h t) (z t) * (1 + dot (p t) (z t)) + Rabs (dot (fa (h t)) (z t)) * Rabs (cross (z t) (p t)) < 0)).
      - intros t [[C Dt] O] L R T E u U A. specialize (T q Iq Wq). destruct (units t T) as [Up Uz].
        destruct (ends_right t q g E R Iq T Ig Nl) as [Ep Ez].
        apply (short_arc (f t) (p t) (z t) u); try assumption; [apply f_crosses, R|].
        apply (order (h t)); try assumption; [apply h_end, T|]. apply h_start; [exact T|].
        apply short_legal_way; [exact Iq|exact L|]. destruct now_there as [S0 E0].
        apply no_length_link; try assumption; apply moving_proper.
      - apply after_and; [apply after_and|].
        + apply (after_negative (fun t => cap (p t) (z t) (m t))).
          * apply steady_cap; [exact Sp|exact Sz|exact steady_m].
          * unfold cap. rewrite <- N, D1.
            assert (X : 0 < 1 - dot (p t0) (m t0)); [|lra].
            apply not_one; [exact Up0|apply least_unit, norm_now|]. intros X. apply m_outside. left. split; assumption.
        + apply (after_positive (fun t => 1 + dot (p t) (z t))); [exact Sd|]. rewrite <- N, D1. lra.
        + apply (after_negative (fun t => slope (h t) (z t) * (1 + dot (p t) (z t)) + Rabs (dot (fa (h t)) (z t)) * Rabs (cross (z t) (p t)))).
          * apply c_plus; apply c_mult; [apply steady_slope; [exact steady_h|exact Sz]|exact Sd|apply c_abs|apply c_abs].
            -- apply (steady_dot t0 (fun t => fa (h t)) z); [apply steady_fa, steady_h|exact Sz].
            -- apply steady_cross; assumption.
          * destruct (h_end t0 now_there) as [_ S]. rewrite N in D1 |- *.
            replace (cross (z t0) (z t0)) with 0 by (unfold cross; ring). rewrite Rabs_R0, D1. lra.
    Qed.

    Lemma kept_after : after t0 kept.
    Proof. destruct (same_or_not (p t0) (z t0)) as [E|N]; [apply kept_short, E|apply kept_long, N]. Qed.
  End One.

  Theorem local : after t0 (fun t => short_legal cfg D t0 t -> voronoi gens (cfg t) D).
  Proof.
    assert (K : after t0 (fun t => forall q, In q ways -> forall g, In g gens ->
      wall (cfg t0 (el q)) = false -> g <> el q -> g <> er q -> kept q g t)).
    { apply after_list. intros q Iq. apply after_list. intros g Ig.
      destruct (wall (cfg t0 (el q))) eqn:W; [apply after_always; congruence|].
      destruct (Pos.eq_dec g (el q)) as [E|Nl]; [apply after_always; congruence|].
      destruct (Pos.eq_dec g (er q)) as [E|Nr]; [apply after_always; congruence|].
      apply (after_impl t0 (kept q g)); [auto|]. apply kept_after; assumption. }
    assert (C : after t0 (fun t => short_legal cfg D t0 t -> corners_empty t)) by (eapply corners; eassumption).
    pose proof (after_and _ _ _ (after_and _ _ _ pairs_after there_after) (after_and _ _ _ C K)) as H.
    revert H. apply after_impl. intros t [[R T] [E H]] L. constructor.
    - intros g h Ig Ih N. apply R; assumption.
    - intros q O. apply oriented_is in O. destruct O as [Iq W]. apply T; assumption.
    - intros q u g O U A Ig Nl Nr. apply oriented_is in O. destruct O as [Iq W].
      pose proof (H q Iq g Ig W Nl Nr L R T (E L) u U A) as P. unfold K_at.
      unfold at_, dot, diff, minus in *; cbn [vx vy fa fb] in *. lra.
  Qed.
End Local.
