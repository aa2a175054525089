(* Enlarging everything by one positive factor changes nothing that the statement speaks of. *)
From Coq Require Import Reals Lra Bool.
From Voroproof Require Import Geometry Circle.
Open Scope R_scope.

Definition scale (m : R) (g : generator) : generator := Generator (m * cx g) (m * cy g) (m * radius g) (wall g).
Definition scale_circle (m : R) (c : circle) : circle := Circle (m * ox c) (m * oy c) (m * size c).

Section Scale.
  Variable m : R.
  Hypothesis m_pos : 0 < m.

  Lemma length_scale x y : length (m * x) (m * y) = m * length x y.
  Proof.
    apply length_of_square; [apply Rmult_le_pos; [lra|apply length_nonneg]|].
    replace (m * length x y * (m * length x y)) with (m * m * (length x y * length x y)) by ring. rewrite length_square. ring.
  Qed.

  Lemma length_unscale x y : length x y = / m * length (m * x) (m * y).
  Proof. rewrite length_scale. field. lra. Qed.

  Lemma distance_unscale g x y : distance g x y = / m * distance (scale m g) (m * x) (m * y).
  Proof.
    unfold distance, scale; simpl. rewrite <- !Rmult_minus_distr_l, length_scale. destruct (wall g); field; lra.
  Qed.

  (* A circle of the enlarged generators, made smaller again. *)
  Let shrink := scale_circle (/ m).

  Lemma shrunk_distance c g : distance g (ox (shrink c)) (oy (shrink c)) = / m * distance (scale m g) (ox c) (oy c).
  Proof. rewrite distance_unscale. simpl. repeat f_equal; field; lra. Qed.

  Lemma touches_unscale c g : touches c (scale m g) -> touches (shrink c) g.
  Proof. unfold touches. rewrite shrunk_distance. simpl. intros ->. reflexivity. Qed.

  Lemma not_touches_unscale c g : ~ touches c (scale m g) -> ~ touches (shrink c) g.
  Proof.
    unfold touches. rewrite shrunk_distance. simpl. intros H H1. apply H.
    apply (Rmult_eq_reg_l (/ m)); [exact H1|]. apply Rinv_neq_0_compat. lra.
  Qed.

  Lemma inverse_pos : 0 < / m.
  Proof. apply Rinv_0_lt_compat, m_pos. Qed.

  Lemma empty_unscale c g : empty_of c (scale m g) -> empty_of (shrink c) g.
  Proof. unfold empty_of. rewrite shrunk_distance. simpl. intros H. apply Rmult_le_compat_l; [apply Rlt_le, inverse_pos|exact H]. Qed.

  Lemma not_empty_unscale c g : ~ empty_of c (scale m g) -> ~ empty_of (shrink c) g.
  Proof.
    unfold empty_of. rewrite shrunk_distance. simpl. intros H H1. apply H.
    apply (Rmult_le_reg_l (/ m)); [apply inverse_pos|exact H1].
  Qed.

  Lemma contact_unscale c g : contact_x (shrink c) g = contact_x c (scale m g) /\ contact_y (shrink c) g = contact_y c (scale m g).
  Proof.
    unfold contact_x, contact_y; simpl.
    replace (cx g - / m * ox c) with (/ m * (m * cx g - ox c)) by (field; lra).
    replace (cy g - / m * oy c) with (/ m * (m * cy g - oy c)) by (field; lra).
    set (x := m * cx g - ox c). set (y := m * cy g - oy c).
    assert (L : length (/ m * x) (/ m * y) = / m * length x y).
    { rewrite (length_unscale (/ m * x) (/ m * y)). repeat f_equal; field; lra. }
    rewrite L.
    destruct (Req_dec (length x y) 0) as [E|E].
    - pose proof (length_square x y) as Q. rewrite E in Q.
      assert (x = 0) as -> by nra. assert (y = 0) as -> by nra. unfold Rdiv. rewrite !Rmult_0_r, !Rmult_0_l. split; reflexivity.
    - split; field; lra.
  Qed.

  Lemma vertex_unscale c i j k : vertex_circle c (scale m i) (scale m j) (scale m k) -> vertex_circle (shrink c) i j k.
  Proof.
    intros (Hi & Hj & Hk & Hc). unfold vertex_circle. repeat split; try (apply touches_unscale; assumption).
    unfold counterclockwise in *.
    destruct (contact_unscale c i) as [-> ->]. destruct (contact_unscale c j) as [-> ->]. destruct (contact_unscale c k) as [-> ->].
    exact Hc.
  Qed.

  Lemma circles_unscale (say : circle -> generator -> Prop) : (forall c g, say c (scale m g) -> say (shrink c) g) ->
    forall l r s e, circles say (scale m l) (scale m r) (scale m s) (scale m e) -> circles say l r s e.
  Proof.
    intros H l r s e [(c & V & E) (c' & V' & E')].
    split; [exists (shrink c)|exists (shrink c')]; (split; [apply vertex_unscale|apply H]; assumption).
  Qed.

  Lemma legal_unscale l r s e : legal (scale m l) (scale m r) (scale m s) (scale m e) -> legal l r s e.
  Proof. apply circles_unscale, empty_unscale. Qed.

  Lemma there_unscale l r s e : there (scale m l) (scale m r) (scale m s) (scale m e) -> there l r s e.
  Proof. apply circles_unscale. trivial. Qed.

  Lemma right_unscale g h : right_pair (scale m g) (scale m h) -> right_pair g h.
  Proof.
    unfold right_pair, scale; simpl.
    replace ((m * cx g - m * cx h) * (m * cx g - m * cx h) + (m * cy g - m * cy h) * (m * cy g - m * cy h) - (m * radius g - m * radius h) * (m * radius g - m * radius h))
      with (m * m * ((cx g - cx h) * (cx g - cx h) + (cy g - cy h) * (cy g - cy h) - (radius g - radius h) * (radius g - radius h))) by ring.
    generalize ((cx g - cx h) * (cx g - cx h) + (cy g - cy h) * (cy g - cy h) - (radius g - radius h) * (radius g - radius h)). intros p.
    assert (Q : 0 < m * m) by (apply Rmult_lt_0_compat; exact m_pos).
    destruct (wall g || wall h); intros H; apply (Rmult_lt_reg_l (m * m)); lra.
  Qed.

  Lemma stands_unscale l r s e : stands (scale m l) (scale m r) (scale m s) (scale m e) -> stands l r s e.
  Proof. intros (T & A & B & C & D & E). split; [apply there_unscale, T|]. repeat split; apply right_unscale; assumption. Qed.

  Lemma passed_unscale l r s e : passed (scale m l) (scale m r) (scale m s) (scale m e) -> passed l r s e.
  Proof. apply circles_unscale. intros c g [H|H]; [left; apply touches_unscale, H|right; apply not_empty_unscale, H]. Qed.

  Lemma not_cotangent_unscale l r s e : not_cotangent (scale m l) (scale m r) (scale m s) (scale m e) -> not_cotangent l r s e.
  Proof.
    intros [(c & V & E)|(c & V & E)]; [left|right]; exists (shrink c);
      (split; [apply vertex_unscale, V | apply not_touches_unscale, E]).
  Qed.

  Lemma apart_unscale i j : apart (scale m i) (scale m j) -> apart i j.
  Proof.
    unfold apart; simpl. rewrite <- !Rmult_minus_distr_l, length_scale, <- Rmult_plus_distr_l.
    destruct (wall i || wall j); intros H.
    - apply (Rmult_le_reg_l m); [exact m_pos|]. lra.
    - apply (Rmult_le_reg_l m); [exact m_pos|]. lra.
  Qed.
End Scale.

Lemma vertex_turn c i j k : vertex_circle c i j k -> vertex_circle c j k i.
Proof. intros (Hi & Hj & Hk & Hc). unfold vertex_circle, counterclockwise in *. repeat split; try assumption. lra. Qed.

(* The edge seen from its other side. *)
Lemma circles_turn say l r s e : circles say r l e s -> circles say l r s e.
Proof. intros [(c & V & E) (c' & V' & E')]. split; [exists c'|exists c]; (split; [|assumption]); [|apply vertex_turn]; apply vertex_turn; assumption. Qed.

Lemma right_turn g h : right_pair g h -> right_pair h g.
Proof.
  unfold right_pair. rewrite orb_comm.
  replace ((cx h - cx g) * (cx h - cx g) + (cy h - cy g) * (cy h - cy g) - (radius h - radius g) * (radius h - radius g)) with
    ((cx g - cx h) * (cx g - cx h) + (cy g - cy h) * (cy g - cy h) - (radius g - radius h) * (radius g - radius h)) by ring. tauto.
Qed.

Lemma stands_turn l r s e : stands r l e s -> stands l r s e.
Proof. intros (T & A & B & C & D & E). split; [apply circles_turn, T|]. split; [apply right_turn, A|]. repeat split; assumption. Qed.

Lemma lasts_turn l r s e t : lasts r l e s t -> lasts l r s e t.
Proof.
  intros [T H]. split; [apply stands_turn, T|]. destruct H as [[(k & W & E)|(k & W & E)]|(u & Hu & H)].
  - left; right. exists k. split; [do 2 apply vertex_turn; exact W|exact E].
  - left; left. exists k. split; [apply vertex_turn, W|exact E].
  - right. exists u. split; [exact Hu|]. intros w Hw. apply circles_turn, H, Hw.
Qed.

Lemma pinched_turn l r s e : pinched r l e s -> pinched l r s e.
Proof. intros (c & V & V'). exists c. split; [|apply vertex_turn]; apply vertex_turn; assumption. Qed.

Lemma pinched_cotangent l r s e : pinched l r s e -> cotangent l r s e.
Proof.
  intros (c & V & W). split; exists c; (split; [assumption|]).
  - apply W.
  - apply V.
Qed.

(* Four generators, and the same enlarged and at other times. *)
Section Along.
  Variables l r s e l' r' s' e' : R -> generator.
  Variable phi : R -> R.
  Definition enlarged_at (w : R) : Prop := exists m, 0 < m /\
    l' (phi w) = scale m (l w) /\ r' (phi w) = scale m (r w) /\ s' (phi w) = scale m (s w) /\ e' (phi w) = scale m (e w).

  Lemma lasts_along t :
    (forall y, phi t < y -> exists u, t < u /\ forall w, t <= w < u -> phi t <= phi w < y /\ enlarged_at w) ->
    lasts l' r' s' e' (phi t) -> lasts l r s e t.
  Proof.
    intros C [T H]. destruct (C (phi t + 1)) as (u0 & Hu0 & C0); [lra|].
    destruct (C0 t) as [_ (m & Hm & E1 & E2 & E3 & E4)]; [lra|]. rewrite E1, E2, E3, E4 in *. split.
    - apply (stands_unscale m Hm), T.
    - destruct H as [H|(y & Hy & H)]; [left; apply (not_cotangent_unscale m Hm), H|right].
      destruct (C y Hy) as (u & Hu & D). exists u. split; [exact Hu|]. intros w Hw.
      destruct (D w Hw) as [B (n & Hn & F1 & F2 & F3 & F4)]. specialize (H (phi w) B). rewrite F1, F2, F3, F4 in H.
      apply (legal_unscale n Hn), H.
  Qed.
End Along.
