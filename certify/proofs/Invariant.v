(* What holds of the checker's state after each claim: everything up to the present has been proved. *)
From Coq Require Import ZArith List Bool Reals Lra Lia FMapPositive.
From Voroproof Require Import Geometry Piece History Replay LifeSound.
Import ListNotations.
Open Scope R_scope.

Section Invariant.
Variable P : problem.
Hypothesis tolerance_nonneg : (0 <= tolerance P)%Z.

(* The four of an edge at time t are legal, and its pair. *)
Definition legal_at (past : list claim) (t : R) (q : edge) : Prop :=
  legal (place P past t (el q)) (place P past t (er q)) (place P past t (es q)) (place P past t (ee q)) /\
  tie_broken P past t q /\ stands_at P past t q.
Definition near_pair (near : list claim) (t : R) (q : edge) : Prop :=
  near_collision P near (el q) (er q) t \/ near_collision P near (er q) (el q) t.
Definition pair_at (past near : list claim) (t : R) (q : edge) : Prop :=
  apart (place P past t (el q)) (place P past t (er q)) \/ near_pair near t q.

(* What holds of the edge k of the diagram. Collisions are looked for in [near], which may hold the present claim too. *)
Record slot_true (past near : list claim) (present : Z) (k : positive) (sl : slot) : Prop := {
  named : last_edge P k past = Some (name sl);
  not_ahead : (proved sl <= present)%Z;
  pair_ahead : (proved sl <= pair_proved sl)%Z;
  proved_legal : forall q t, 0 <= t < IZR (proved sl) -> edge_at P k past t = Some q -> ~ bracketed k past t -> legal_at past t q;
  stays : forall t, IZR (proved sl) <= t -> edge_at P k past t = Some (name sl);
  proved_apart : forall q t, 0 <= t < IZR (pair_proved sl) -> t < IZR present -> In q (names_at P k past t) -> pair_at past near t q;
  in_brackets : forall t, IZR (opened sl) <= t < IZR (proved sl) -> bracketed k past t;
  proved_near : forall t, IZR present <= t < IZR (pair_proved sl) -> near_pair near t (name sl);
  (* by all its names *)
  proved_lasts : forall q t, 0 <= t < IZR (proved sl) -> In q (names_at P k past t) ->
    stands_at P past t q /\ (flipping k past t \/ lasts_at P past t q);
  one_name : forall t, IZR (proved sl) <= t -> names_at P k past t = [name sl];
  few_names : others sl <> [] -> forall q t, IZR (opened sl) <= t < IZR (proved sl) -> In q (names_at P k past t) ->
    In q (name sl :: others sl)
}.

Record invariant (past near : list claim) (s : state) : Prop := {
  movers_known : knows P past s;
  slots_true : forall k sl, PositiveMap.find k (slots s) = Some sl -> slot_true past near (now s) k sl;
  slots_all : forall k, PositiveMap.find k (slots s) = None -> PositiveMap.find k (edges P) = None
}.

(* Time passes. *)
Lemma slot_later past near t u k sl : (t <= u)%Z -> slot_true past near t k sl -> slot_true past near u k sl.
Proof.
  intros H [N A B L S Q O R La On Fe]. apply IZR_le in H as H'. split; try assumption; try lia.
  - intros q v Hv Hu I. destruct (Rlt_or_le v (IZR t)) as [Hl|Hl]; [exact (Q q v Hv Hl I)|].
    right. rewrite On in I by (apply IZR_le in A; lra). destruct I as [<-|[]]. apply R. lra.
  - intros v Hv. apply R. lra.
Qed.

Lemma near_more c near t q : near_pair near t q -> near_pair (c :: near) t q.
Proof.
  intros [H|H]; [left|right]; destruct H as (later & earlier & u & vi & vj & ps & b & a & k & n & -> & B);
    exists (c :: later), earlier, u, vi, vj, ps, b, a, k, n; (split; [reflexivity|exact B]).
Qed.

Lemma slot_more c past near t k sl : slot_true past near t k sl -> slot_true past (c :: near) t k sl.
Proof.
  intros [N A B L S Q O R La On Fe]. split; try assumption.
  - intros q v Hv Hu I. destruct (Q q v Hv Hu I) as [H|H]; [left; exact H|right; apply near_more, H].
  - intros v Hv. apply near_more, R, Hv.
Qed.

(* Legal over a while, it lasts. *)
Lemma legal_lasts past q a b : (forall t, a <= t < b -> legal_at past t q) -> forall t, a <= t < b -> lasts_at P past t q.
Proof.
  intros H t Ht. split.
  - apply (H t Ht).
  - right. exists b. split; [lra|]. intros w Hw. apply (H w). lra.
Qed.

(* A life that ends in a turn. *)
Lemma slot_turns past near s own t slack k sl : (0 <= slack)%Z ->
  knows P past s -> slot_true past near t k sl ->
  (forall q u, own q = true -> IZR t - IZR (tolerance P) <= u <= IZR t + IZR slack -> near_pair near u q) ->
  settle s sl t (if own (name sl) then t - tolerance P else t)%Z = Good tt ->
  slot_true past near t k (Slot (name sl) (if (proved sl <? t)%Z then t else opened sl) (Z.max (proved sl) t)
    (Z.max (pair_proved sl) (if own (name sl) then t + slack else t)) (if (proved sl <? t)%Z then [] else others sl)).
Proof.
  intros Slack. apply IZR_le in Slack as Slack'. intros K [N A B L S Q O R La On Fe] Own H. destruct (settled P past s sl _ _ K H) as [HL HP].
  assert (M : Z.max (proved sl) t = t) by lia.
  split; cbn [name opened proved pair_proved others]; try assumption; try lia.
  - destruct (own (name sl)); lia.
  - rewrite M. intros q u Hu E Nb. destruct (Rlt_or_le u (IZR (proved sl))) as [Hl|Hl]; [apply L; try assumption; lra|].
    rewrite S in E by exact Hl. injection E as E. subst q. apply HL. lra.
  - rewrite M. intros u Hu. apply S. apply IZR_le in A. lra.
  - intros q u Hu Ht I.
    destruct (Rlt_or_le u (IZR (pair_proved sl))) as [Hl|Hl]; [apply Q; try assumption; lra|].
    rewrite On in I by (apply IZR_le in B; lra). destruct I as [<-|[]]. destruct (own (name sl)) eqn:OW.
    + destruct (Rlt_or_le u (IZR (t - tolerance P))) as [H1|H1]; [left; apply HP; lra|].
      rewrite minus_IZR in H1. right. apply Own; [exact OW|].
      lra.
    + left. apply HP. lra.
  - rewrite M. intros u Hu. destruct (proved sl <? t)%Z eqn:E; [lra|]. apply O. apply Z.ltb_ge, IZR_le in E. lra.
  - intros u [Hu1 Hu2]. destruct (Rlt_or_le u (IZR (pair_proved sl))) as [Hl|Hl]; [apply R; lra|].
    destruct (own (name sl)) eqn:OW.
    + apply Own; [exact OW|]. destruct (Z.max_spec (pair_proved sl) (t + slack)) as [[_ X]|[_ X]]; rewrite X in Hu2; [|lra].
      rewrite plus_IZR in Hu2. pose proof tolerance_nonneg as TN. apply IZR_le in TN. lra.
    + destruct (Z.max_spec (pair_proved sl) t) as [[_ X]|[_ X]]; rewrite X in Hu2; lra.
  - rewrite M. intros q u Hu I. destruct (Rlt_or_le u (IZR (proved sl))) as [Hl|Hl]; [apply La; try assumption; lra|].
    rewrite On in I by exact Hl. destruct I as [<-|[]]. split; [apply HL; lra|right]. apply (legal_lasts past _ _ _ HL). lra.
  - rewrite M. intros u Hu. apply On. apply IZR_le in A. lra.
  - rewrite M. intros Ne q u Hu I. destruct (proved sl <? t)%Z eqn:E; [congruence|]. apply Z.ltb_ge, IZR_le in E.
    apply (Fe Ne q u); [lra|exact I].
Qed.

Lemma each_keeps (I : state -> Prop) step : (forall k s s', I s -> step k s = Good s' -> I s') ->
  forall ks s s', I s -> each step ks s = Good s' -> I s'.
Proof.
  intros H ks. induction ks as [|k ks IH]; simpl; intros s s' Hs E; [injection E as <-; exact Hs|].
  apply try_good in E as (s1 & E1 & E). apply (IH s1 s'); [|exact E]. apply (H k s); assumption.
Qed.

Lemma turns_keep past near own t slack : (0 <= slack)%Z ->
  (forall q u, own q = true -> IZR t - IZR (tolerance P) <= u <= IZR t + IZR slack -> near_pair near u q) ->
  forall ks s s', invariant past near s /\ now s = t -> each (turn_one P own t slack) ks s = Good s' -> invariant past near s' /\ now s' = t.
Proof.
  intros Slack Own. apply each_keeps. intros k s s' [[K T A] N] E. unfold turn_one in E.
  apply try_good in E as (sl & F & E). apply try_good in E as (u & H & E). injection E as <-. destruct u.
  apply known_good in F. split; [|exact N]. split; [exact K| |].
  - intros k' sl' F'. cbn [slots put now] in *. destruct (Pos.eq_dec k' k) as [->|D].
    + rewrite PositiveMap.gss in F'. injection F' as <-. rewrite N. apply (slot_turns past near s); try assumption.
      rewrite <- N. apply T, F.
    + rewrite PositiveMap.gso in F' by exact D. apply T, F'.
  - intros k' F'. cbn [slots put] in F'. destruct (Pos.eq_dec k' k) as [->|D].
    + rewrite PositiveMap.gss in F'. discriminate.
    + rewrite PositiveMap.gso in F' by exact D. apply A, F'.
Qed.

(* Before a turn nothing changes. *)
Lemma leg_before c past g t : (forall u v, turn_of c g = Some (u, v) -> t < IZR u) -> leg_at P g (c :: past) t = leg_at P g past t.
Proof.
  intros H. simpl. destruct (turn_of c g) as [[u v]|] eqn:E; [|reflexivity].
  specialize (H u v eq_refl). destruct (Rle_dec (IZR u) t); [lra|reflexivity].
Qed.

Lemma place_before c past t : (forall g u v, turn_of c g = Some (u, v) -> t < IZR u) -> forall g, place P (c :: past) t g = place P past t g.
Proof. intros H g. unfold place. rewrite leg_before; [reflexivity|]. intros u v. apply H. Qed.

(* What lasts depends on no later paths. *)
Lemma lasts_before past past' b t q : (forall u, u < b -> forall g, place P past' u g = place P past u g) -> t < b ->
  lasts_at P past t q -> lasts_at P past' t q.
Proof.
  intros Pl Hb [T H]. unfold lasts_at, lasts in *. cbv zeta in *. rewrite !Pl by exact Hb. split; [exact T|].
  destruct H as [H|(u & Hu & H)]; [left; exact H|right]. exists (Rmin u b). split; [apply Rmin_glb_lt; assumption|].
  intros w Hw. assert (w < u /\ w < b) as [W1 W2] by (pose proof (Rmin_l u b); pose proof (Rmin_r u b); lra).
  rewrite !Pl by exact W2. apply H. lra.
Qed.

(* A claim that is no flip leaves all edges. *)
Lemma edge_not_flipped c past k : bracket_of k c = None -> (forall q, after_flip k c q = Some q) ->
  last_edge P k (c :: past) = last_edge P k past /\ (forall t, edge_at P k (c :: past) t = edge_at P k past t) /\
  (forall t, bracketed k (c :: past) t <-> bracketed k past t) /\ (forall t, names_at P k (c :: past) t = names_at P k past t) /\
  (forall t, flipping k past t -> flipping k (c :: past) t).
Proof.
  intros B F. repeat split.
  - simpl. destruct (last_edge P k past); simpl; [apply F|reflexivity].
  - intros t. simpl. rewrite B. reflexivity.
  - intros (d & lo & hi & I & E & H). destruct I as [<-|I]; [congruence|]. exists d, lo, hi. tauto.
  - intros (d & lo & hi & I & E & H). exists d, lo, hi. split; [right; exact I|tauto].
  - intros t. simpl. rewrite B. reflexivity.
  - intros t (d & lo & hi & I & E). exists d, lo, hi. split; [right; exact I|exact E].
Qed.

Lemma slot_unchanged c past near t k sl : (forall g u v, turn_of c g = Some (u, v) -> u = t) ->
  bracket_of k c = None -> (forall q, after_flip k c q = Some q) ->
  slot_true past near t k sl -> slot_true (c :: past) near t k sl.
Proof.
  intros HT B F [N A BB L S Q O R La On Fe]. destruct (edge_not_flipped c past k B F) as (E1 & E2 & E3 & E4 & E5).
  assert (Pl : forall u, u < IZR t -> forall g, place P (c :: past) u g = place P past u g).
  { intros u Hu. apply place_before. intros g w v E. rewrite (HT g w v E). exact Hu. }
  apply IZR_le in A as A'. split; try assumption.
  - rewrite E1. exact N.
  - intros q u Hu. rewrite E2, E3. intros E Nb. unfold legal_at, tie_broken, stands_at. rewrite !Pl by lra.
    rewrite !leg_before by (intros w v Ew; rewrite (HT _ w v Ew); lra). apply L; assumption.
  - intros u Hu. rewrite E2. apply S, Hu.
  - intros q u Hu Ht. rewrite E4. intros I. unfold pair_at. rewrite !Pl by exact Ht. apply Q; assumption.
  - intros u Hu. rewrite E3. apply O, Hu.
  - intros q u Hu. rewrite E4. intros I. destruct (La q u Hu I) as [St H]. split; [unfold stands_at in *; rewrite !Pl by lra; exact St|].
    destruct H as [H|H]; [left; apply E5, H|right].
    apply (lasts_before past _ (IZR t)); [exact Pl|lra|exact H].
  - intros u Hu. rewrite E4. apply On, Hu.
  - intros Ne q u Hu. rewrite E4. apply Fe; assumption.
Qed.
End Invariant.
