(* Each step of the checker keeps the invariant and proves its claim. *)
From Coq Require Import ZArith List Bool Reals Lra Lia FMapPositive.
From Voroproof Require Import Geometry Piece History Replay LifeSound ClaimSound Invariant.
Import ListNotations.
Open Scope R_scope.

Section Replay.
Variable P : problem.
Hypothesis tolerance_nonneg : (0 <= tolerance P)%Z.

Lemma edge_eqb_true p q : edge_eqb p q = true -> p = q.
Proof.
  unfold edge_eqb. intros H. repeat (apply andb_prop in H as [H ?]). apply Pos.eqb_eq in H, H0, H1, H2.
  destruct p, q; simpl in *; congruence.
Qed.

(* A turn of one generator. *)
Lemma turn_movers c g s s' : turn c g s = Good s' ->
  slots s' = slots s /\ now s' = now s /\ todo s' = todo s /\
  (forall h, h <> g -> PositiveMap.find h (movers s') = PositiveMap.find h (movers s)) /\
  (turn_of c g = None -> PositiveMap.find g (movers s') = PositiveMap.find g (movers s)) /\
  (forall t v, turn_of c g = Some (t, v) -> exists m, PositiveMap.find g (movers s) = Some m /\
     PositiveMap.find g (movers s') = Some (Mover (turned (path m) t v) (size_ m))).
Proof.
  unfold turn. destruct (turn_of c g) as [[t v]|].
  - intros H. apply try_good in H as (m & M & H). apply known_good in M. injection H as <-. simpl.
    repeat split; try reflexivity; try discriminate.
    + intros h D. apply PositiveMap.gso, D.
    + intros t0 v0 E. injection E as <- <-. exists m. split; [exact M|apply PositiveMap.gss].
  - intros H. injection H as <-. repeat split; try reflexivity. discriminate.
Qed.

(* Both generators of a claim turn, and nobody else does. *)
Lemma turned_known c past s s1 s2 i j : i <> j -> (forall g, turn_of c g <> None -> g = i \/ g = j) ->
  knows P past s -> turn c i s = Good s1 -> turn c j s1 = Good s2 -> knows P (c :: past) s2.
Proof.
  intros D Only K T1 T2. destruct (turn_movers _ _ _ _ T1) as (_ & _ & _ & O1 & N1 & S1).
  destruct (turn_movers _ _ _ _ T2) as (_ & _ & _ & O2 & N2 & S2).
  intros g m F. simpl. destruct (turn_of c g) as [[t v]|] eqn:E.
  - destruct (Only g) as [->| ->]; [congruence| |].
    + destruct (S1 t v E) as (m0 & F0 & F1). rewrite O2, F1 in F by exact D. injection F as <-. simpl.
      destruct (K i m0 F0) as [-> ->]. split; reflexivity.
    + destruct (S2 t v E) as (m0 & F0 & F1). rewrite F1 in F. injection F as <-. simpl.
      rewrite O1 in F0 by congruence. destruct (K j m0 F0) as [-> ->]. split; reflexivity.
  - apply K. destruct (Pos.eq_dec g i) as [->|Di].
    + rewrite <- (N1 E), <- (O2 i D). exact F.
    + destruct (Pos.eq_dec g j) as [->|Dj].
      * rewrite <- (O1 j Di), <- (N2 E). exact F.
      * rewrite <- (O1 g Di), <- (O2 g Dj). exact F.
Qed.

Lemma invariant_at_time past near s t : (now s <= t)%Z -> invariant P past near s -> invariant P past near (at_time s t).
Proof.
  intros H [K T A]. split; [exact K| |exact A]. intros k sl F. apply (slot_later P past near (now s)); [exact H|]. apply T, F.
Qed.

Lemma invariant_more c past near s : invariant P past near s -> invariant P past (c :: near) s.
Proof. intros [K T A]. split; [exact K| |exact A]. intros k sl F. apply slot_more, T, F. Qed.

(* The knowledge of movers does not depend on slots or time. *)
Lemma each_turn_movers own t slack ks : forall s s', each (turn_one P own t slack) ks s = Good s' -> movers s' = movers s /\ todo s' = todo s.
Proof.
  induction ks as [|k ks IH]; simpl; intros s s' E; [injection E as <-; split; reflexivity|].
  apply try_good in E as (s1 & E1 & E). destruct (IH _ _ E) as [M T]. unfold turn_one in E1.
  apply try_good in E1 as (sl & F & E1). apply try_good in E1 as (u & H & E1). injection E1 as <-. split; assumption.
Qed.

Lemma each_at_time own t slack ks : forall s u, 
  each (turn_one P own t slack) ks (at_time s u) = match each (turn_one P own t slack) ks s with Good s' => Good (at_time s' u) | Bad w => Bad w end.
Proof.
  induction ks as [|k ks IH]; simpl; intros s u; [reflexivity|].
  unfold turn_one at 1 3. unfold slot_of. change (slots (at_time s u)) with (slots s).
  destruct (PositiveMap.find k (slots s)) as [sl|]; [|reflexivity]. simpl try.
  change (settle (at_time s u)) with (settle s).
  destruct (settle s sl t (if own (name sl) then t - tolerance P else t)%Z) as [v|w]; [|reflexivity]. simpl try.
  exact (IH (put s k _) u).
Qed.

(* A claim that turns i and j (which may be one) at time t, after the lives around it have been settled. *)
Lemma turning c past s own t slack around s1 s2 s3 i j : (0 <= slack)%Z ->
  invariant P past past s -> (now s <= t)%Z -> i <> j ->
  (forall g, turn_of c g <> None -> g = i \/ g = j) -> (forall g u v, turn_of c g = Some (u, v) -> u = t) ->
  (forall k, bracket_of k c = None) -> (forall k q, after_flip k c q = Some q) ->
  (forall q u, own q = true -> IZR t - IZR (tolerance P) <= u <= IZR t + IZR slack -> near_pair P (c :: past) u q) ->
  each (turn_one P own t slack) around s = Good s1 -> turn c i s1 = Good s2 -> turn c j s2 = Good s3 ->
  invariant P (c :: past) (c :: past) (at_time s3 t) /\ todo s3 = todo s.
Proof.
  intros Slack I N D Only When B F Own E1 E2 E3.
  destruct (each_turn_movers _ _ _ _ _ _ E1) as [M1 T1].
  destruct (turn_movers _ _ _ _ E2) as (S2 & N2 & T2 & _). destruct (turn_movers _ _ _ _ E3) as (S3 & N3 & T3 & _).
  split; [|congruence].
  pose proof (invariant_more c _ _ _ (invariant_at_time _ _ _ _ N I)) as I0.
  pose proof (each_at_time own t slack around s t) as X. rewrite E1 in X.
  destruct (turns_keep P tolerance_nonneg past (c :: past) own t slack Slack Own around _ _ (conj I0 eq_refl) X) as [[K T A] _].
  split.
  - intros g m Fm. change (PositiveMap.find g (movers s3) = Some m) in Fm.
    apply (turned_known c past s1 s2 s3 i j D Only); try assumption.
  - intros k sl Fk. change (PositiveMap.find k (slots s3) = Some sl) in Fk. rewrite S3, S2 in Fk.
    apply slot_unchanged; try (apply B || apply F || exact When). apply T, Fk.
  - intros k Fk. change (PositiveMap.find k (slots s3) = None) in Fk. rewrite S3, S2 in Fk. apply A, Fk.
Qed.

(* A flip: the five edges. *)
Lemma settle_movers s s' sl u pu : movers s = movers s' -> settle s sl u pu = settle s' sl u pu.
Proof. intros H. unfold settle, untied, four, mover_of. rewrite H. reflexivity. Qed.

Section Flip.
  Variables (c : claim) (lo hi : Z) (s0 : state).
  Hypothesis order : (lo < hi)%Z.

  Record flipped (ks : list positive) (s : state) : Prop := {
    same_movers : movers s = movers s0;
    same_time : now s = now s0;
    same_todo : todo s = todo s0;
    done_ : forall k sl, In k ks -> PositiveMap.find k (slots s) = Some sl ->
      exists sl0 q, PositiveMap.find k (slots s0) = Some sl0 /\ (opened sl0 <= lo)%Z /\ settle s0 sl0 lo lo = Good tt /\
        after_flip k c (name sl0) = Some q /\ sl = Slot q lo (Z.max (proved sl0) hi) (Z.max (proved sl0) hi);
    not_done : forall k, ~ In k ks -> PositiveMap.find k (slots s) = PositiveMap.find k (slots s0);
    none_lost : forall k, PositiveMap.find k (slots s) = None -> PositiveMap.find k (slots s0) = None
  }.

  Lemma flip_one_keeps ks k s s' : ~ In k ks -> flipped ks s -> flip_one c lo hi k s = Good s' -> flipped (k :: ks) s'.
  Proof.
    intros Fresh [M T D Y N L] E. unfold flip_one in E.
    apply try_good in E as (sl & F & E). apply known_good in F. apply need_good in E as [Hlo E]. apply Z.leb_le in Hlo.
    apply try_good in E as (u & S & E). destruct u. apply try_good in E as (q & A & E). apply known_good in A. injection E as <-.
    split; try assumption.
    - intros k' sl' I F'. cbn [slots put] in F'. destruct (Pos.eq_dec k' k) as [->|Dk].
      + rewrite PositiveMap.gss in F'. injection F' as <-. exists sl, q. rewrite N in F by exact Fresh.
        rewrite (settle_movers s s0) in S by exact M. tauto.
      + rewrite PositiveMap.gso in F' by exact Dk. destruct I as [I|I]; [congruence|]. apply (Y k' sl' I F').
    - intros k' I. cbn [slots put]. rewrite PositiveMap.gso by (intros ->; apply I; left; reflexivity). apply N. intros I'. apply I. right. exact I'.
    - intros k' F'. cbn [slots put] in F'. destruct (Pos.eq_dec k' k) as [->|Dk].
      + rewrite PositiveMap.gss in F'. discriminate.
      + rewrite PositiveMap.gso in F' by exact Dk. apply L, F'.
  Qed.

  Lemma flips_keep ks : forall before s s', NoDup (rev ks ++ before) -> flipped before s -> each (flip_one c lo hi) ks s = Good s' -> flipped (rev ks ++ before) s'.
  Proof.
    induction ks as [|k ks IH]; simpl; intros before s s' D H E; [injection E as <-; exact H|].
    rewrite <- app_assoc in *. simpl in *.
    apply try_good in E as (s1 & E1 & E). apply (IH (k :: before) s1 s'); [exact D| |exact E].
    apply (flip_one_keeps _ _ s); try assumption. apply NoDup_remove_2 in D. intros I. apply D, in_or_app. right. exact I.
  Qed.
End Flip.

Lemma flip_brackets t f lo hi k k1 k2 k3 k4 m : let c := Flip t f lo hi k k1 k2 k3 k4 in
  (In m [k; k1; k2; k3; k4] -> bracket_of m c = Some (lo, hi)) /\
  (~ In m [k; k1; k2; k3; k4] -> bracket_of m c = None /\ forall q, after_flip m c q = Some q).
Proof.
  simpl. split.
  - intros [<-|[<-|[<-|[<-|[<-|[]]]]]]; rewrite Pos.eqb_refl, ?orb_true_r; reflexivity.
  - intros H. assert (forall n, (n = k \/ n = k1 \/ n = k2 \/ n = k3 \/ n = k4) -> Pos.eqb m n = false) as X.
    { intros n Hn. apply Pos.eqb_neq. intros ->. apply H. repeat destruct Hn as [<-|Hn]; subst; tauto. }
    rewrite !X by tauto. split; reflexivity.
Qed.

Lemma distinct_true ks : distinct ks = true -> NoDup ks.
Proof.
  induction ks as [|k ks IH]; simpl; intros H; [constructor|]. apply andb_prop in H as [H1 H2]. constructor; [|apply IH, H2].
  apply negb_true_iff in H1. intros I. assert (existsb (Pos.eqb k) ks = true) as X; [|congruence].
  apply existsb_exists. exists k. split; [exact I|apply Pos.eqb_refl].
Qed.

Lemma flip_keeps past s t f lo hi k k1 k2 k3 k4 s1 (c := Flip t f lo hi k k1 k2 k3 k4) :
  (lo < hi)%Z -> distinct [k; k1; k2; k3; k4] = true -> invariant P past past s ->
  each (flip_one c lo hi) [k; k1; k2; k3; k4] s = Good s1 ->
  invariant P (c :: past) (c :: past) (at_time s1 (Z.max (now s1) hi)) /\ todo s1 = todo s.
Proof.
  intros O Ds I0 E. apply distinct_true, NoDup_rev in Ds. rewrite <- app_nil_r in Ds.
  assert (Start : flipped c lo hi s [] s). { split; try reflexivity; try tauto; intros ? ? []. }
  pose proof (flips_keep c lo hi s _ _ _ _ Ds Start E) as [M N D Y X L]. rewrite app_nil_r in *. clear Start E Ds.
  split; [|exact D].
  pose proof (invariant_at_time past past s (Z.max (now s1) hi) ltac:(lia) I0) as I1.
  destruct (invariant_more c _ _ _ I1) as [K T A]. clear I0 I1.
  assert (Pl : forall u g, place P (c :: past) u g = place P past u g) by reflexivity.
  split.
  - intros g m F. cbn [movers at_time] in F. rewrite M in F. apply K, F.
  - intros m sl F. cbn [slots at_time now] in F. cbn [now at_time].
    destruct (flip_brackets t f lo hi k k1 k2 k3 k4 m) as [In_ Out]. fold c in In_, Out.
    destruct (in_dec Pos.eq_dec m [k; k1; k2; k3; k4]) as [Hm|Hm].
    + specialize (In_ Hm).
      destruct (Y m sl (proj1 (in_rev _ _) Hm) F) as (sl0 & q & F0 & Hlo & S & AF & ->).
      destruct (T m sl0 F0) as [N0 A0 B0 L0 S0 Q0 O0 R0]. cbn [now at_time] in *.
      destruct (settled P past s sl0 _ _ K S) as [HL HP].
      assert (Last : last_edge P m (c :: past) = Some q) by (cbn [last_edge]; rewrite N0; exact AF).
      assert (Before : forall u, u < IZR hi -> edge_at P m (c :: past) u = edge_at P m past u).
      { intros u Hu. cbn [edge_at]. rewrite In_. destruct (Rle_dec (IZR hi) u); [lra|reflexivity]. }
      assert (Old : forall u, bracketed m past u -> bracketed m (c :: past) u).
      { intros u (d & l & h & I & H). exists d, l, h. split; [right; exact I|exact H]. }
      assert (New : forall u, IZR lo <= u < IZR hi -> bracketed m (c :: past) u).
      { intros u Hu. exists c, lo, hi. split; [left; reflexivity|]. split; [exact In_|exact Hu]. }
      apply IZR_lt in O as O'. apply IZR_le in Hlo as Hlo'. apply IZR_le in B0 as B0'.
      (* A time that has been dealt with and lies in no bracket is one before lo. *)
      assert (Early : forall u, u < IZR (Z.max (proved sl0) hi) -> ~ bracketed m (c :: past) u -> u < IZR lo /\ ~ bracketed m past u).
      { intros u Hu Nu. split; [|intros H; apply Nu, Old, H].
        destruct (Rlt_or_le u (IZR lo)) as [H1|H1]; [exact H1|exfalso; apply Nu].
        destruct (Rlt_or_le u (IZR hi)) as [H2|H2]; [apply New; lra|]. apply Old, O0.
        destruct (Z.max_spec (proved sl0) hi) as [[_ E]|[_ E]]; rewrite E in Hu; lra. }
      split; cbn [name opened proved pair_proved].
      * exact Last.
      * lia.
      * lia.
      * intros p u Hu Eu Nu. destruct (Early u (proj2 Hu) Nu) as [H1 H2]. rewrite Before in Eu by lra.
        change (legal_at P past u p).
        destruct (Rlt_or_le u (IZR (proved sl0))) as [Hl|Hl]; [apply L0; try assumption; lra|].
        rewrite S0 in Eu by exact Hl. injection Eu as <-. apply HL. lra.
      * intros u Hu. cbn [edge_at]. rewrite In_. destruct (Rle_dec (IZR hi) u) as [|H]; [exact Last|].
        exfalso. apply H. assert (IZR hi <= IZR (Z.max (proved sl0) hi)) by (apply IZR_le; lia). lra.
      * intros p u Hu Hu' Eu Nu. destruct (Early u (proj2 Hu) Nu) as [H1 H2]. rewrite Before in Eu by lra.
        change (pair_at P past (c :: past) u p).
        destruct (Rlt_or_le u (IZR (pair_proved sl0))) as [Hl|Hl]; [apply Q0; try assumption; lra|].
        rewrite S0 in Eu by lra. injection Eu as <-. left. apply HP. lra.
      * intros u Hu. destruct (Rlt_or_le u (IZR hi)) as [H2|H2]; [apply New; lra|]. apply Old, O0.
        destruct (Z.max_spec (proved sl0) hi) as [[_ E]|[_ E]]; rewrite E in Hu; lra.
      * intros u Hu. assert (IZR (Z.max (proved sl0) hi) <= IZR (Z.max (now s1) hi)) by (apply IZR_le; lia). lra.
    + rewrite X in F by (rewrite <- in_rev; exact Hm). destruct (Out Hm) as [B AF].
      specialize (T m sl F). cbn [now at_time] in T.
      apply slot_unchanged; try assumption. intros g u v H. discriminate.
  - intros m F. apply A. cbn [slots at_time] in *. apply L, F.
Qed.
End Replay.
