(* What the checker accepts of a flip, a collision and a maneuver is true of it. *)
From Coq Require Import ZArith List Bool Reals Lra Lia FMapPositive.
From Voroproof Require Import Forms Polynomial Geometry Circle Vertex Scale Piece PieceSound EdgeSound Short History Replay LifeSound FlipSound.
Import ListNotations.
Open Scope R_scope.

Section Claim.
Variable P : problem.

Lemma mover_known past s g m : knows P past s -> PositiveMap.find g (movers s) = Some m -> m = known_mover P past g.
Proof. intros K H. destruct (K g m H) as [H1 H2]. destruct m as [l r]. simpl in *. unfold known_mover. congruence. Qed.

Definition on (past : list claim) (u : R) (g : gen) : generator := on_leg P g (last_leg P g past) u.

(* The edge f on its lines at a time. *)
Definition edge_is (past : list claim) (f : edge) (say : generator -> generator -> generator -> generator -> Prop) (u : R) : Prop :=
  say (on past u (el f)) (on past u (er f)) (on past u (es f)) (on past u (ee f)).

Lemma at_start past g t v : at_z (span g (known_mover P past g) t v) 0 = on past (IZR t) g.
Proof. apply (span_start P g (known_mover P past g)). reflexivity. Qed.

(* A bracket of one instant. *)
Lemma instant_true past s f t : knows P past s -> collapses s f t t = Good true ->
  (forall g, In g [el f; er f; es f; ee f] -> (since (last_leg P g past) <= t)%Z) /\
  edge_is past f pinched (IZR t) /\
  exists u, IZR t < u /\ (forall w, IZR t <= w < u -> edge_is past f passed w) /\
    (edge_is past f entered u \/ (largest f = false /\ edge_is past f pinched u)).
Proof.
  intros K H. unfold collapses in H. rewrite Z.eqb_refl in H.
  apply try_good in H as (a & A & H). apply try_good in H as (b & B & H). apply try_good in H as (c & C & H). injection H as H.
  apply andb_prop in H as [H Hc]. apply andb_prop in H as [Ha Hb]. subst a b c.
  destruct (four_known P _ _ _ _ _ _ _ _ K A) as [A1 A2]. destruct (four_known P _ _ _ _ _ _ _ _ K B) as [B1 _].
  destruct (four_known P _ _ _ _ _ _ _ _ K C) as [C1 _]. split; [exact A2|]. split.
  { apply short_true in A1. rewrite !at_start in A1. exact A1. }
  exists (IZR (t + soon)). split; [apply IZR_lt; unfold soon; lia|]. split.
  - intros w Hw. destruct (parameter_pos _ _ _ Hw) as [Z1 Z2]. unfold edge_is, on. apply (passed_unscale _ Z2).
    assert (E : forall g, scale ((IZR (t + soon) - IZR t) / (IZR (t + soon) - w)) (on_leg P g (last_leg P g past) w) =
      at_z (span g (known_mover P past g) t (t + soon)) ((w - IZR t) / (IZR (t + soon) - w)))
      by (intros g; symmetry; apply (span_at P g (known_mover P past g)); [reflexivity|exact Hw]).
    rewrite !E. unfold by_fan, fan_past_at in B1. cbv zeta in B1.
    match type of B1 with (if ?w then _ else _) = _ => destruct w end; [apply circles_turn|]; apply (fan_past_true _ _ _ _ B1 _ Z1).
  - destruct (largest f) eqn:Rule.
    + left. apply entered_true in C1. rewrite !at_start in C1. exact C1.
    + assert (E : forall l r s e, by_fan (fun i a b c => fan_entered_at i a b c || fan_short_at i a b c) l r s e =
        by_fan fan_entered_at l r s e || by_fan fan_short_at l r s e) by (intros; unfold by_fan; destruct (mwall _); reflexivity).
      cbv zeta in C1. rewrite E in C1. apply orb_prop in C1 as [C1|C1]; [left; apply entered_true in C1|right; apply short_true in C1];
        rewrite !at_start in C1; [|split; [reflexivity|]]; exact C1.
Qed.

Lemma collapses_true past s f lo hi : knows P past s -> (lo <= hi)%Z -> collapses s f lo hi = Good true ->
  (forall g, In g [el f; er f; es f; ee f] -> (since (last_leg P g past) <= lo)%Z) /\
  (forall u, IZR lo <= u <= IZR hi -> edge_is past f there u) /\
  edge_is past f legal (IZR lo) /\
  ((lo < hi)%Z -> edge_is past f entered (IZR hi)) /\
  ((lo = hi)%Z -> edge_is past f pinched (IZR lo) /\
    exists u, IZR lo < u /\ (forall w, IZR lo <= w < u -> edge_is past f passed w) /\
      (edge_is past f entered u \/ (largest f = false /\ edge_is past f pinched u))) /\
  exists (u : R) o, (IZR lo <= u <= IZR hi) /\
    (vertex_circle o (on past u (el f)) (on past u (es f)) (on past u (er f)) /\ touches o (on past u (ee f))).
Proof.
  intros K O H. destruct (Z.eq_dec lo hi) as [<-|Ne].
  { destruct (instant_true past s f lo K H) as (S & T & R). destruct (pinched_cotangent _ _ _ _ T) as [(o & V & X) (o' & V' & X')]. split; [exact S|].
    split; [intros u Hu; replace u with (IZR lo) by lra; split; eauto|].
    split; [split; [exists o|exists o']; (split; [assumption|unfold touches, empty_of in *; lra])|].
    split; [lia|]. split; [intros _; split; [exact T|exact R]|]. exists (IZR lo), o. split; [lra|split; assumption]. }
  assert (O' : (lo < hi)%Z) by lia. unfold collapses in H. apply Z.eqb_neq in Ne as E. rewrite E in H.
  apply try_good in H as (a & A & H). apply try_good in H as (b & B & H). apply try_good in H as (c & C & H). injection H as H.
  apply andb_prop in H as [H Hc]. apply andb_prop in H as [Ha Hb]. subst a b c.
  destruct (four_known P _ _ _ _ _ _ _ _ K A) as [A1 A2]. destruct (four_known P _ _ _ _ _ _ _ _ K B) as [B1 _].
  destruct (four_known P _ _ _ _ _ _ _ _ K C) as [C1 _]. split; [exact A2|].
  unfold by_fan in A1, B1, C1. cbv zeta in A1, B1, C1.
  change (mwall (span (el f) (known_mover P past (el f)) lo lo)) with (Pos.eqb (el f) container) in A1.
  change (mwall (span (el f) (known_mover P past (el f)) hi (hi + 1))) with (Pos.eqb (el f) container) in B1.
  change (mwall (span (el f) (known_mover P past (el f)) lo (hi + 1))) with (Pos.eqb (el f) container) in C1.
  destruct (Pos.eqb (el f) container).
  - destruct (bracket P lo hi O' (er f) (ee f) (el f) (es f)
      (known_mover P past (er f)) (known_mover P past (ee f)) (known_mover P past (el f)) (known_mover P past (es f)) eq_refl eq_refl eq_refl eq_refl A1 B1 C1)
      as (L & N & _ & (u & o & Hu & V & X)).
    pose proof (there_between P lo hi (er f) (ee f) (el f) (es f) (known_mover P past (er f)) (known_mover P past (ee f))
      (known_mover P past (el f)) (known_mover P past (es f)) eq_refl eq_refl eq_refl eq_refl C1) as T.
    split; [intros v Hv; apply circles_turn, T, Hv|]. split; [apply circles_turn, L|]. split; [intros _; apply circles_turn, N|].
    split; [lia|]. exists u, o. split; [exact Hu|]. split; [apply vertex_turn, V|exact X].
  - destruct (bracket P lo hi O' (el f) (es f) (er f) (ee f)
      (known_mover P past (el f)) (known_mover P past (es f)) (known_mover P past (er f)) (known_mover P past (ee f)) eq_refl eq_refl eq_refl eq_refl A1 B1 C1)
      as (L & N & (u & o & Hu & V & X) & _).
    pose proof (there_between P lo hi (el f) (es f) (er f) (ee f) (known_mover P past (el f)) (known_mover P past (es f))
      (known_mover P past (er f)) (known_mover P past (ee f)) eq_refl eq_refl eq_refl eq_refl C1) as T.
    split; [exact T|]. split; [exact L|]. split; [intros _; exact N|]. split; [lia|].
    exists u, o. split; [exact Hu|]. split; [exact V|exact X].
Qed.

(* Contact. *)
Lemma gap_at_real i j a b (t : Z) : IZR (gap_at i j a b t) =
  (let dx := IZR (x (path a)) + IZR (vx (path a)) * (IZR t - IZR (since (path a))) - (IZR (x (path b)) + IZR (vx (path b)) * (IZR t - IZR (since (path b)))) in
   let dy := IZR (y (path a)) + IZR (vy (path a)) * (IZR t - IZR (since (path a))) - (IZR (y (path b)) + IZR (vy (path b)) * (IZR t - IZR (since (path b)))) in
   let r := IZR (size_ a) + IZR (size_ b) in
   (if Pos.eqb i container || Pos.eqb j container then -1 else 1) * (dx * dx + dy * dy - r * r)).
Proof.
  unfold gap_at, x_at, y_at. destruct (Pos.eqb i container || Pos.eqb j container); cbv zeta;
    rewrite ?opp_IZR, !minus_IZR, !plus_IZR, !mult_IZR, !minus_IZR, !plus_IZR, !mult_IZR, !minus_IZR; ring.
Qed.

Lemma touch_true past i j t before after :
  touch P i j (known_mover P past i) (known_mover P past j) t before after = true ->
  exists u w : R, Rabs (u - IZR t) <= IZR (tolerance P) /\ u <= w <= IZR t + IZR (tolerance P) /\
    IZR (since (last_leg P i past)) <= u /\ IZR (since (last_leg P j past)) <= u /\
    in_contact (on past u i) (on past u j) /\ ~ apart (on past w i) (on past w j).
Proof.
  intros H. unfold touch in H. apply andb_prop in H as [H Hg1]. apply andb_prop in H as [H Hg0]. apply andb_prop in H as [H Hr].
  repeat (apply andb_prop in H as [H ?]). rewrite !Z.leb_le in *.
  apply Z.ltb_lt, IZR_lt in Hg1. apply IZR_le in Hg0, H, H3. apply IZR_le in H2 as H2'. apply IZR_le in H1. apply IZR_le in H0.
  rewrite minus_IZR in H1. rewrite plus_IZR in H0. rewrite gap_at_real in Hg0, Hg1. simpl path in *. simpl size_ in *.
  set (li := last_leg P i past) in *. set (lj := last_leg P j past) in *.
  set (k := fun u : R =>
    (let dx := IZR (x li) + IZR (vx li) * (u - IZR (since li)) - (IZR (x lj) + IZR (vx lj) * (u - IZR (since lj))) in
     let dy := IZR (y li) + IZR (vy li) * (u - IZR (since li)) - (IZR (y lj) + IZR (vy lj) * (u - IZR (since lj))) in
     let r := IZR (radius_of P i) + IZR (radius_of P j) in
     (if Pos.eqb i container || Pos.eqb j container then -1 else 1) * (dx * dx + dy * dy - r * r))).
  change (0 <= k (IZR before)) in Hg0. change (k (IZR after) < 0) in Hg1.
  assert (Z : exists u, IZR before <= u <= IZR after /\ k u = 0).
  { destruct (Rle_lt_or_eq_dec _ _ Hg0) as [L0|E]; [|exists (IZR before); split; [lra|symmetry; exact E]].
    destruct (Rle_lt_or_eq_dec _ _ H2') as [L2|E]; [|rewrite E in L0; lra].
    destruct (IVT (fun u => - k u) (IZR before) (IZR after)) as [u [Hu E]]; try lra.
    - unfold k. cbv zeta. apply continuity_opp. reg.
    - exists u. split; [exact Hu|lra]. }
  destruct Z as (u & Hu & E). exists u, (IZR after). split; [apply Rabs_le; lra|]. split; [lra|]. split; [lra|]. split; [lra|].
  unfold in_contact, apart, on, on_leg; cbn [cx cy radius wall].
  unfold k in E, Hg1. cbv zeta in E, Hg1. fold li lj.
  destruct (Pos.eqb i container || Pos.eqb j container); apply Z.leb_le, IZR_le in Hr; rewrite plus_IZR in Hr;
    (split; [apply length_of_square; lra|]); intros A;
    match type of A with context [length ?a ?b] => pose proof (length_square a b) as Q; pose proof (length_nonneg a b) end; nra.
Qed.

(* They overlap at t. *)
Lemma overlap_true past i j t before after :
  touch P i j (known_mover P past i) (known_mover P past j) t before after = true ->
  (gap_at i j (known_mover P past i) (known_mover P past j) t < 0)%Z -> ~ apart (on past (IZR t) i) (on past (IZR t) j).
Proof.
  intros H G. unfold touch in H. apply andb_prop in H as [H _]. apply andb_prop in H as [H _]. apply andb_prop in H as [_ Hr].
  apply IZR_lt in G. rewrite gap_at_real in G. simpl path in *. simpl size_ in *. cbv zeta in G.
  unfold apart, on, on_leg; cbn [cx cy radius wall].
  destruct (Pos.eqb i container || Pos.eqb j container); apply Z.leb_le, IZR_le in Hr; rewrite plus_IZR in Hr; intros A;
    match type of A with context [length ?a ?b] => pose proof (length_square a b) as Q; pose proof (length_nonneg a b) end; nra.
Qed.

(* The law is the statement's. *)
Lemma within_law_true vi vj off scale : within_law_b P vi vj off scale = true -> within_law P vi vj off scale.
Proof. unfold within_law_b, within_law. destruct (law_tolerance P). apply Z.leb_le. Qed.

Lemma law_true past i j t wi wj :
  law P i j (known_mover P past i) (known_mover P past j) t wi wj = true ->
  let li := last_leg P i past in let lj := last_leg P j past in
  let n := minus (x_at lj t, y_at lj t) (x_at li t, y_at li t) in
  if Pos.eqb i container then law_of_wall P n (velocity lj) wj
  else exists bi bj, PositiveMap.find i (bodies P) = Some bi /\ PositiveMap.find j (bodies P) = Some bj /\
    law_of_disks P n (velocity li) (velocity lj) wi wj (mass bi) (mass bj).
Proof.
  unfold law. simpl path. cbv zeta. destruct (Pos.eqb i container).
  - unfold law_of_wall_b, law_of_wall. destruct (wall_restitution P). cbv zeta. intros H. apply andb_prop in H as [H1 H2].
    split; [apply Z.ltb_lt, H1|]. destruct (whole_law P); apply within_law_true, H2.
  - destruct (PositiveMap.find i (bodies P)) as [bi|]; [|discriminate].
    destruct (PositiveMap.find j (bodies P)) as [bj|]; [|discriminate].
    intros H. exists bi, bj. split; [reflexivity|]. split; [reflexivity|].
    unfold law_of_disks_b in H. unfold law_of_disks. destruct (disk_restitution P). cbv zeta in *.
    apply andb_prop in H as [H H3]. apply andb_prop in H as [H1 H2].
    split; [apply Z.ltb_lt, H1|]. split; apply within_law_true; assumption.
Qed.

Lemma centres_true past s c t ps : knows P past s -> forallb (centre_ok P s c t) ps = true -> Forall (centre_true P past c t) ps.
Proof.
  intros K H. apply Forall_forall. intros [g p] I. rewrite forallb_forall in H. specialize (H _ I).
  unfold centre_ok in H. unfold centre_true. destruct (PositiveMap.find g (movers s)) as [m|] eqn:F; [|discriminate].
  destruct (K g m F) as [E _]. rewrite E in H. apply Z.leb_le, H.
Qed.
End Claim.
