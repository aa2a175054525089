(* From intervals to times: what the checker proves of a life, in terms of paths. *)
From Coq Require Import ZArith List Bool Reals Lra Lia FMapPositive.
From Voroproof Require Import Geometry Circle Scale Piece PieceSound EdgeSound History Replay.
Import ListNotations.
Open Scope R_scope.

Section Life.
Variable P : problem.

(* The checker's idea of a generator is that of the past. *)
Definition knows (past : list claim) (s : state) : Prop :=
  forall g m, PositiveMap.find g (movers s) = Some m -> path m = last_leg P g past /\ size_ m = radius_of P g.

Lemma leg_at_last g past t : IZR (since (last_leg P g past)) <= t -> leg_at P g past t = last_leg P g past.
Proof.
  induction past as [|c past IH]; simpl; [reflexivity|].
  destruct (turn_of c g) as [[u v]|]; [|exact IH].
  intros H. change (since (turned (last_leg P g past) u v)) with u in H.
  destruct (Rle_dec (IZR u) t) as [|N]; [reflexivity|contradiction].
Qed.

(* Over [a, b) the parameter of t is (t - a)/(b - t). *)
Lemma span_at g m a b t : size_ m = radius_of P g -> IZR a <= t < IZR b ->
  at_z (span g m a b) ((t - IZR a) / (IZR b - t)) = scale ((IZR b - IZR a) / (IZR b - t)) (on_leg P g (path m) t).
Proof.
  intros Hs [Ha Hb]. unfold at_z, span, scale, on_leg, x_at, y_at. cbn [ax ay bx by_ mr mwall cx cy radius wall].
  rewrite !plus_IZR, !mult_IZR, !minus_IZR, Hs. f_equal; field; lra.
Qed.

Lemma parameter_pos (a b : Z) (t : R) : IZR a <= t < IZR b -> 0 <= (t - IZR a) / (IZR b - t) /\ 0 < (IZR b - IZR a) / (IZR b - t).
Proof.
  intros [Ha Hb]. split.
  - apply Rmult_le_pos; [lra|]. apply Rlt_le, Rinv_0_lt_compat. lra.
  - apply Rdiv_lt_0_compat; lra.
Qed.

Lemma try_good {A B} (a : outcome A) (f : A -> outcome B) (y : B) : try a f = Good y -> exists z, a = Good z /\ f z = Good y.
Proof. destruct a as [z|w]; simpl; [eauto|discriminate]. Qed.

Lemma need_good {B} b w (f : outcome B) (y : B) : need b w f = Good y -> b = true /\ f = Good y.
Proof. destruct b; simpl; [auto|discriminate]. Qed.

Lemma known_good {A} (a : option A) w (y : A) : known a w = Good y -> a = Some y.
Proof. destruct a; simpl; congruence. Qed.

(* The four of an edge: their legs have begun, and the test was made of them. *)
Lemma four_good {T} past s q birth a b (test : moving -> moving -> moving -> moving -> T) (y : T) :
  knows past s -> four s q birth a b test = Good y ->
  exists l r i e, test (span (el q) l a b) (span (er q) r a b) (span (es q) i a b) (span (ee q) e a b) = y /\
    (path l = last_leg P (el q) past /\ size_ l = radius_of P (el q) /\ (since (path l) <= birth)%Z) /\
    (path r = last_leg P (er q) past /\ size_ r = radius_of P (er q) /\ (since (path r) <= birth)%Z) /\
    (path i = last_leg P (es q) past /\ size_ i = radius_of P (es q) /\ (since (path i) <= birth)%Z) /\
    (path e = last_leg P (ee q) past /\ size_ e = radius_of P (ee q) /\ (since (path e) <= birth)%Z).
Proof.
  intros K H. unfold four, mover_of in H.
  apply try_good in H as (l & L & H). apply try_good in H as (r & R & H). apply try_good in H as (i & I & H).
  apply try_good in H as (e & E & H). apply need_good in H as [H1 H]. injection H as H.
  apply known_good, K in L. apply known_good, K in R. apply known_good, K in I. apply known_good, K in E.
  repeat (apply andb_prop in H1 as [H1 ?]). rewrite !Z.leb_le in *.
  exists l, r, i, e. tauto.
Qed.

Lemma span_start g m a b : size_ m = radius_of P g -> at_z (span g m a b) 0 = on_leg P g (path m) (IZR a).
Proof.
  intros Hs. unfold at_z, span, on_leg, x_at, y_at. cbn [ax ay bx by_ mr mwall].
  rewrite !plus_IZR, !mult_IZR, !minus_IZR, Hs. f_equal; ring.
Qed.

(* What the checker knows of a generator. *)
Definition known_mover (past : list claim) (g : gen) : mover := Mover (last_leg P g past) (radius_of P g).

Lemma four_known {T} past s q birth a b (test : moving -> moving -> moving -> moving -> T) (y : T) :
  knows past s -> four s q birth a b test = Good y ->
  let g k := span k (known_mover past k) a b in
  test (g (el q)) (g (er q)) (g (es q)) (g (ee q)) = y /\
  forall k, In k [el q; er q; es q; ee q] -> (since (last_leg P k past) <= birth)%Z.
Proof.
  intros K H. destruct (four_good _ _ _ _ _ _ _ _ K H) as (l & r & i & e & T0 & (L & Ls & Lb) & (R & Rs & Rb) & (I & Is & Ib) & (E & Es & Eb)).
  simpl. assert (M : forall g m, path m = last_leg P g past -> size_ m = radius_of P g -> m = known_mover past g)
    by (intros g [p z]; unfold known_mover; simpl; congruence).
  rewrite <- (M _ l L Ls), <- (M _ r R Rs), <- (M _ i I Is), <- (M _ e E Es). split; [exact T0|].
  rewrite L in Lb. rewrite R in Rb. rewrite I in Ib. rewrite E in Eb.
  intros k [<-|[<-|[<-|[<-|[]]]]]; assumption.
Qed.

Lemma untied_true past s q birth upto : knows past s -> untied s q birth upto = Good true ->
  (forall g, In g [el q; er q; es q; ee q] -> (since (last_leg P g past) <= birth)%Z) /\
  exists u : R, let on g := on_leg P g (last_leg P g past) u in not_cotangent (on (el q)) (on (er q)) (on (es q)) (on (ee q)).
Proof.
  intros K H. unfold untied in H. apply try_good in H as (b & B & H).
  destruct (four_known _ _ _ _ _ _ _ _ K B) as [B1 B2]. split; [exact B2|].
  assert (At : exists v, by_fan fan_strict_at (span (el q) (known_mover past (el q)) v v) (span (er q) (known_mover past (er q)) v v)
      (span (es q) (known_mover past (es q)) v v) (span (ee q) (known_mover past (ee q)) v v) = true).
  { destruct b; [exists birth; exact B1|]. destruct (four_known _ _ _ _ _ _ _ _ K H) as [C1 _]. exists upto. exact C1. }
  destruct At as (v & T). exists (IZR v). cbv zeta.
  assert (At : forall g, at_z (span g (known_mover past g) v v) 0 = on_leg P g (last_leg P g past) (IZR v))
    by (intros g; apply (span_start g (known_mover past g)); reflexivity).
  unfold by_fan, fan_strict_at in T. unfold not_cotangent. destruct (mwall (span (el q) (known_mover past (el q)) v v));
    apply andb_prop in T as [T1 T2]; destruct (fan_strict_true _ _ _ _ T1 T2) as [(o & V & X)|(o & V & X)];
    rewrite !At in V; rewrite !At in X.
  - right. exists o. split; [apply vertex_turn, vertex_turn, V|exact X].
  - left. exists o. split; [apply vertex_turn, V|exact X].
  - left. exists o. split; [exact V|exact X].
  - right. exists o. split; [exact V|exact X].
Qed.

Lemma place_on_leg past t g : IZR (since (last_leg P g past)) <= t -> place P past t g = on_leg P g (last_leg P g past) t.
Proof. intros H. unfold place. rewrite leg_at_last by exact H. reflexivity. Qed.

(* The edge q at time t, by the paths of a past. *)
Definition lasts_at (past : list claim) (t : R) (q : edge) : Prop :=
  let moving g u := place P past u g in lasts (moving (el q)) (moving (er q)) (moving (es q)) (moving (ee q)) t.

Lemma lasting_true past s q a b : knows past s -> four s q a a b edge_lasts = Good true -> forall t, IZR a <= t < IZR b -> lasts_at past t q.
Proof.
  intros K H t Ht. destruct (four_known _ _ _ _ _ _ _ _ K H) as [T Since]. cbv zeta in T. unfold lasts_at.
  set (g k := span k (known_mover past k) a b) in *. set (phi w := (w - IZR a) / (IZR b - w)).
  apply (lasts_along _ _ _ _ (at_z (g (el q))) (at_z (g (er q))) (at_z (g (es q))) (at_z (g (ee q))) phi).
  2: { apply edge_lasts_sound; [exact T|]. apply parameter_pos, Ht. }
  intros y Hy. assert (P0 : 0 <= phi t) by (apply parameter_pos, Ht).
  assert (Up : forall v w, v < IZR b -> w < IZR b -> phi w - phi v = (w - v) * ((IZR b - IZR a) / ((IZR b - v) * (IZR b - w)))).
  { intros v w Hv Hw. unfold phi. field. lra. }
  assert (Pos : forall v w, v < IZR b -> w < IZR b -> 0 < (IZR b - IZR a) / ((IZR b - v) * (IZR b - w))).
  { intros v w Hv Hw. apply Rdiv_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; lra. }
  set (u := (IZR a + y * IZR b) / (1 + y)).
  assert (Ub : IZR b - u = (IZR b - IZR a) / (1 + y)) by (unfold u; field; lra).
  assert (U1 : u < IZR b). { assert (0 < (IZR b - IZR a) / (1 + y)) by (apply Rdiv_lt_0_compat; lra). lra. }
  assert (Uy : phi u = y). { unfold phi. rewrite Ub. replace (u - IZR a) with (y * ((IZR b - IZR a) / (1 + y))) by (unfold u; field; lra). field. lra. }
  exists u. split.
  { pose proof (Up t u ltac:(lra) U1) as E. pose proof (Pos t u ltac:(lra) U1) as Q. rewrite Uy in E.
    destruct (Rlt_or_le t u) as [|H1]; [assumption|]. assert (0 <= (t - u) * ((IZR b - IZR a) / ((IZR b - t) * (IZR b - u)))) by (apply Rmult_le_pos; lra). lra. }
  intros w Hw. split; [split|].
  - pose proof (Up t w ltac:(lra) ltac:(lra)) as E. pose proof (Pos t w ltac:(lra) ltac:(lra)) as Q.
    assert (0 <= (w - t) * ((IZR b - IZR a) / ((IZR b - t) * (IZR b - w)))) by (apply Rmult_le_pos; lra). lra.
  - pose proof (Up w u ltac:(lra) U1) as E. pose proof (Pos w u ltac:(lra) U1) as Q. rewrite Uy in E.
    assert (0 < (u - w) * ((IZR b - IZR a) / ((IZR b - w) * (IZR b - u)))) by (apply Rmult_lt_0_compat; lra). lra.
  - exists ((IZR b - IZR a) / (IZR b - w)). split; [apply Rdiv_lt_0_compat; lra|].
    assert (E : forall k, In k [el q; er q; es q; ee q] -> at_z (g k) (phi w) = scale ((IZR b - IZR a) / (IZR b - w)) (place P past w k)).
    { intros k I. unfold g, phi. rewrite span_at by (try reflexivity; lra). rewrite place_on_leg; [reflexivity|].
      pose proof (Since k I) as S. apply IZR_le in S. lra. }
    simpl in E. repeat split; apply E; tauto.
Qed.

Definition stands_at (past : list claim) (t : R) (q : edge) : Prop :=
  stands (place P past t (el q)) (place P past t (er q)) (place P past t (es q)) (place P past t (ee q)).

(* A test of the four over [a, b) that says something of each instant. *)
Lemma four_sound (test : moving -> moving -> moving -> moving -> bool) (says : generator -> generator -> generator -> generator -> Prop)
    past s q a b :
  (forall m, 0 < m -> forall l r i e, says (scale m l) (scale m r) (scale m i) (scale m e) -> says l r i e) ->
  (forall l r i e, test l r i e = true -> forall z, 0 <= z -> says (at_z l z) (at_z r z) (at_z i z) (at_z e z)) ->
  knows past s -> four s q a a b test = Good true -> forall t, IZR a <= t < IZR b ->
  says (place P past t (el q)) (place P past t (er q)) (place P past t (es q)) (place P past t (ee q)).
Proof.
  intros Un So K H t Ht. destruct (four_known _ _ _ _ _ _ _ _ K H) as [T Since]. cbv zeta in T.
  destruct (parameter_pos _ _ _ Ht) as [Z1 Z2]. apply (Un ((IZR b - IZR a) / (IZR b - t)) Z2).
  assert (E : forall k, In k [el q; er q; es q; ee q] -> scale ((IZR b - IZR a) / (IZR b - t)) (place P past t k) =
    at_z (span k (known_mover past k) a b) ((t - IZR a) / (IZR b - t))).
  { intros k I. rewrite place_on_leg by (pose proof (Since k I) as S; apply IZR_le in S; lra). symmetry.
    apply (span_at k (known_mover past k)); [reflexivity|exact Ht]. }
  rewrite !E by (simpl; tauto). apply (So _ _ _ _ T _ Z1).
Qed.

Lemma standing_true past s q a b : knows past s -> four s q a a b edge_there = Good true -> forall t, IZR a <= t < IZR b -> stands_at past t q.
Proof. intros K H. apply (four_sound edge_there stands past s q a b); try assumption; [exact stands_unscale|exact edge_there_sound]. Qed.

(* The pair of an edge over [a, b). *)
Lemma pair_true past s q a b : knows past s -> four s q a a b (fun l r _ _ => pair_apart depth l r) = Good true ->
  forall t, IZR a <= t < IZR b -> apart (place P past t (el q)) (place P past t (er q)).
Proof.
  intros K B t Ht. destruct (four_known _ _ _ _ _ _ _ _ K B) as [T Since]. cbv zeta in T.
  pose proof (Since (el q) ltac:(simpl; tauto)) as Lb. pose proof (Since (er q) ltac:(simpl; tauto)) as Rb. apply IZR_le in Lb, Rb.
  destruct (parameter_pos _ _ _ Ht) as [Z1 Z2]. rewrite !place_on_leg by lra.
  apply (apart_unscale ((IZR b - IZR a) / (IZR b - t)) Z2).
  assert (E : forall k, scale ((IZR b - IZR a) / (IZR b - t)) (on_leg P k (last_leg P k past) t) =
    at_z (span k (known_mover past k) a b) ((t - IZR a) / (IZR b - t))) by (intros k; symmetry; apply span_at; [reflexivity|exact Ht]).
  rewrite !E.
  apply (pair_apart_sound _ _ _ T). exact Z1.
Qed.

(* What a settled life says. *)
Lemma settled past s sl u pu : knows past s -> settle s sl u pu = Good tt ->
  (forall t, IZR (proved sl) <= t < IZR u ->
     legal (place P past t (el (name sl))) (place P past t (er (name sl))) (place P past t (es (name sl))) (place P past t (ee (name sl))) /\
     tie_broken P past t (name sl) /\ stands_at past t (name sl)) /\
  (forall t, IZR (pair_proved sl) <= t < IZR pu ->
     apart (place P past t (el (name sl))) (place P past t (er (name sl)))).
Proof.
  intros K H. unfold settle in H.
  apply try_good in H as (a & A & H). apply need_good in H as [Ha H]. subst a.
  apply try_good in H as (d & D & H). apply need_good in H as [Hd H]. subst d.
  apply try_good in H as (b & B & H). apply need_good in H as [Hb H]. subst b. clear H. split.
  - intros t Ht. destruct (proved sl <? u)%Z eqn:E; [|apply Z.ltb_ge, IZR_le in E; lra].
    split; [|split].
    + apply (four_sound edge_legal legal past s (name sl) (proved sl) u); try assumption; [exact legal_unscale|exact edge_legal_sound].
    + destruct (four_known _ _ _ _ _ _ _ _ K A) as [_ Since]. unfold tie_broken.
      destruct (largest (name sl)); [left; reflexivity|right]. cbn [andb negb] in D.
      destruct (untied_true past s _ _ _ K D) as (_ & w & W). exists w. cbv zeta in *.
      rewrite !leg_at_last by (apply Rle_trans with (IZR (proved sl)); [apply IZR_le, Since; simpl; tauto|lra]). exact W.
    + apply (four_sound edge_legal stands past s (name sl) (proved sl) u); try assumption; [exact stands_unscale|exact edge_legal_stands].
  - intros t Ht. destruct (pair_proved sl <? pu)%Z eqn:E; [|apply Z.ltb_ge, IZR_le in E; lra].
    apply (pair_true past s _ _ _ K B t Ht).
Qed.
End Life.
