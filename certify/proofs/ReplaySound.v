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
Lemma four_movers {T} s s' q birth a b (test : moving -> moving -> moving -> moving -> T) :
  movers s = movers s' -> four s q birth a b test = four s' q birth a b test.
Proof. intros H. unfold four, mover_of. rewrite H. reflexivity. Qed.

Lemma settle_movers s s' sl u pu : movers s = movers s' -> settle s sl u pu = settle s' sl u pu.
Proof. intros H. unfold settle, untied, four, mover_of. rewrite H. reflexivity. Qed.

Lemma every_same {A} (test test' : A -> outcome bool) w l : (forall a, test a = test' a) -> every test w l = every test' w l.
Proof. intros H. induction l as [|a l IH]; simpl; [reflexivity|]. rewrite H, IH. reflexivity. Qed.

Lemma every_movers s s' birth a b test w l : movers s = movers s' ->
  every (fun q => four s q birth a b test) w l = every (fun q => four s' q birth a b test) w l.
Proof. intros M. apply every_same. intros q. apply four_movers, M. Qed.

Lemma try_same {A B} (a b : outcome A) (f g : A -> outcome B) : a = b -> (forall x, f x = g x) -> try a f = try b g.
Proof. intros -> H. destruct b; [apply H|reflexivity]. Qed.

Lemma need_same {B} b w (f g : outcome B) : f = g -> need b w f = need b w g.
Proof. intros ->. reflexivity. Qed.

Lemma every_good {A} (test : A -> outcome bool) w l : every test w l = Good tt -> forall a, In a l -> test a = Good true.
Proof.
  induction l as [|a l IH]; simpl; intros H b I; [contradiction|]. apply try_good in H as (x & X & H). apply need_good in H as [-> H].
  destruct I as [<-|I]; [exact X|apply IH; assumption].
Qed.

Lemma all_known_good {A B} (f : A -> option B) w l : forall m, all_known f w l = Good m ->
  match l, m with [], [] => True | a :: _, b :: _ => f a = Some b | _, _ => False end /\
  forall a b, In a l -> f a = Some b -> In b m.
Proof.
  induction l as [|a l IH]; simpl; intros m H; [injection H as <-; split; [exact I|contradiction]|].
  apply try_good in H as (b & X & H). apply known_good in X. apply try_good in H as (bs & Y & H). injection H as <-.
  split; [exact X|]. destruct (IH bs Y) as [_ Z]. intros a' b' [<-|I] F; [left; congruence|right; apply (Z a'); assumption].
Qed.

(* Another end leaves an edge its pair. *)
Lemma beside_pair k c q p nb : corner k c = Some nb -> own k c = false -> after_flip k c q = Some p -> el p = el q /\ er p = er q.
Proof.
  intros Co Ow F. unfold after_flip in F. destruct c; try discriminate Co. rewrite Ow, Co in F. destruct nb as [[[a b] d] e]. unfold beside in F.
  destruct (Pos.eqb (el q) a && Pos.eqb (er q) b && Pos.eqb (ee q) d) eqn:X.
  - injection F as <-. apply andb_prop in X as [X _]. apply andb_prop in X as [X Y]. apply Pos.eqb_eq in X, Y. cbn [el er]. split; congruence.
  - destruct (Pos.eqb (el q) b && Pos.eqb (er q) a && Pos.eqb (es q) d) eqn:Y; [|discriminate].
    injection F as <-. apply andb_prop in Y as [Y _]. apply andb_prop in Y as [Y Z]. apply Pos.eqb_eq in Y, Z. cbn [el er]. split; congruence.
Qed.

Section Flip.
  Variables (c : claim) (lo hi : Z) (s0 : state).
  Hypothesis order : (lo <= hi)%Z.

  (* The slot of an edge after a flip. *)
  Definition new_slot (s : state) (k : positive) (sl : slot) : outcome slot :=
    match corner k c with
    | Some _ => beside_flip s sl lo hi (after_flip k c)
    | None => do new <- known (after_flip k c (name sl)) NotBeside; own_flip s sl lo hi new
    end.

  Lemma new_slot_movers s k sl : movers s = movers s0 -> new_slot s k sl = new_slot s0 k sl.
  Proof.
    intros M. unfold new_slot, beside_flip, own_flip. destruct (corner k c).
    - rewrite (settle_movers s s0) by exact M. apply need_same, try_same; [reflexivity|]. intros _. apply try_same; [reflexivity|]. intros news.
      apply try_same; [destruct (lo <? hi)%Z; [apply every_movers, M|reflexivity]|]. intros _. apply try_same; [apply every_movers, M|reflexivity].
    - destruct (after_flip k c (name sl)) as [q|]; cbn [known try]; [|reflexivity].
      rewrite (settle_movers s s0) by exact M. apply need_same, try_same; [reflexivity|]. intros _.
      apply try_same; [destruct (lo <? hi)%Z; [apply four_movers, M|reflexivity]|]. intros apart. apply need_same.
      apply try_same; [destruct (lo <? hi)%Z; [apply every_movers, M|reflexivity]|]. intros _. apply try_same; [apply every_movers, M|reflexivity].
  Qed.

  Record flipped (ks : list positive) (s : state) : Prop := {
    same_movers : movers s = movers s0;
    same_time : now s = now s0;
    same_todo : todo s = todo s0;
    done_ : forall k sl, In k ks -> PositiveMap.find k (slots s) = Some sl ->
      exists sl0, PositiveMap.find k (slots s0) = Some sl0 /\ new_slot s0 k sl0 = Good sl;
    not_done : forall k, ~ In k ks -> PositiveMap.find k (slots s) = PositiveMap.find k (slots s0);
    none_lost : forall k, PositiveMap.find k (slots s) = None -> PositiveMap.find k (slots s0) = None
  }.

  Lemma flip_one_keeps ks k s s' : ~ In k ks -> flipped ks s -> flip_one c lo hi k s = Good s' -> flipped (k :: ks) s'.
  Proof.
    intros Fresh [M T D Y N L] E. unfold flip_one in E.
    apply try_good in E as (sl & F & E). apply known_good in F. apply try_good in E as (new & E' & E). injection E as <-.
    change (new_slot s k sl = Good new) in E'. rewrite (new_slot_movers s k sl M) in E'.
    split; try assumption.
    - intros k' sl' I F'. cbn [slots put] in F'. destruct (Pos.eq_dec k' k) as [->|Dk].
      + rewrite PositiveMap.gss in F'. injection F' as <-. exists sl. rewrite N in F by exact Fresh. split; assumption.
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

  (* What holds of a slot after the flip, whose bracket ends now or before. *)
  Section Slot.
    Variables (past : list claim) (k : positive) (sl0 sl : slot) (present : Z).
    Hypothesis knows0 : knows P past s0.
    Hypothesis old : slot_true P past (c :: past) present k sl0.
    Hypothesis hi_past : (hi <= present)%Z.
    Hypothesis paths : forall g, turn_of c g = None.
    Hypothesis bracket : bracket_of k c = Some (lo, hi).
    Hypothesis own_or_beside : corner k c = None -> own k c = true.
    Hypothesis beside_alone : forall nb, corner k c = Some nb -> own k c = false.
    Hypothesis taken : new_slot s0 k sl0 = Good sl.

    Lemma same_place u g : place P (c :: past) u g = place P past u g.
    Proof. unfold place. rewrite leg_before; [reflexivity|]. intros w v. rewrite paths. discriminate. Qed.

    Lemma same_lasts u q : lasts_at P past u q -> lasts_at P (c :: past) u q.
    Proof. apply (lasts_before P past _ (u + 1)); [intros; apply same_place|lra]. Qed.

    Lemma same_stands u q : stands_at P past u q -> stands_at P (c :: past) u q.
    Proof. unfold stands_at. rewrite !same_place. tauto. Qed.

    Lemma same_legal u q : legal_at P past u q -> legal_at P (c :: past) u q.
    Proof.
      unfold legal_at, tie_broken, stands_at. rewrite !same_place. rewrite !leg_before by (intros w v; rewrite paths; discriminate). tauto.
    Qed.

    Lemma same_pair u q : pair_at P past (c :: past) u q -> pair_at P (c :: past) (c :: past) u q.
    Proof. unfold pair_at. rewrite !same_place. tauto. Qed.

    Lemma edge_before u : u < IZR hi -> edge_at P k (c :: past) u = edge_at P k past u.
    Proof. intros Hu. cbn [edge_at]. rewrite bracket. destruct (Rle_dec (IZR hi) u); [lra|reflexivity]. Qed.

    Lemma names_before u : u < IZR lo -> names_at P k (c :: past) u = names_at P k past u.
    Proof.
      intros Hu. apply IZR_le in order as O. cbn [names_at]. rewrite bracket.
      destruct (Rle_dec (IZR hi) u); [lra|]. destruct (Rle_dec (IZR lo) u); [lra|reflexivity].
    Qed.

    Lemma names_within u : IZR lo <= u < IZR hi -> names_at P k (c :: past) u = renamed k c (names_at P k past u) ++ names_at P k past u.
    Proof.
      intros Hu. cbn [names_at]. rewrite bracket. destruct (Rle_dec (IZR hi) u); [lra|]. destruct (Rle_dec (IZR lo) u); [reflexivity|lra].
    Qed.

    Lemma names_after u : IZR hi <= u -> names_at P k (c :: past) u = renamed k c (names_at P k past u).
    Proof. intros Hu. cbn [names_at]. rewrite bracket. destruct (Rle_dec (IZR hi) u); [reflexivity|lra]. Qed.

    Lemma flipping_before u : flipping k past u -> flipping k (c :: past) u.
    Proof. intros (d & l & h & I & H). exists d, l, h. split; [right; exact I|exact H]. Qed.

    Lemma bracketed_before u : bracketed k past u -> bracketed k (c :: past) u.
    Proof. intros (d & l & h & I & H). exists d, l, h. split; [right; exact I|exact H]. Qed.

    Lemma bracketed_now u : IZR lo <= u < IZR hi -> bracketed k (c :: past) u.
    Proof. intros Hu. exists c, lo, hi. split; [left; reflexivity|]. split; [exact bracket|exact Hu]. Qed.

    Lemma renamed_in q qs : In q (renamed k c qs) -> exists p, In p qs /\ after_flip k c p = Some q.
    Proof.
      unfold renamed. intros I. apply in_flat_map in I as (p & Ip & I). exists p. split; [exact Ip|].
      destruct (after_flip k c p); [|contradiction]. destruct I as [<-|[]]. reflexivity.
    Qed.

    (* What [settle s0 sl0 lo hi] and the times before say of the past. *)
    Lemma settled_legal q u : settle s0 sl0 lo hi = Good tt -> 0 <= u -> u < IZR lo -> edge_at P k past u = Some q ->
      ~ bracketed k past u -> legal_at P past u q.
    Proof.
      intros S H0 Hu E Nb. destruct (settled P past s0 sl0 _ _ knows0 S) as [HL _].
      destruct (Rlt_or_le u (IZR (proved sl0))) as [Hl|Hl]; [apply (proved_legal _ _ _ _ _ _ old); try assumption; lra|].
      rewrite (stays _ _ _ _ _ _ old) in E by exact Hl. injection E as <-. apply HL. lra.
    Qed.

    Lemma settled_lasts q u : settle s0 sl0 lo hi = Good tt -> 0 <= u -> u < IZR lo -> In q (names_at P k past u) ->
      stands_at P past u q /\ (flipping k past u \/ lasts_at P past u q).
    Proof.
      intros S H0 Hu I. destruct (settled P past s0 sl0 _ _ knows0 S) as [HL _].
      destruct (Rlt_or_le u (IZR (proved sl0))) as [Hl|Hl]; [apply (proved_lasts _ _ _ _ _ _ old); try assumption; lra|].
      rewrite (one_name _ _ _ _ _ _ old) in I by exact Hl. destruct I as [<-|[]]. split; [apply HL; lra|right]. apply (legal_lasts P past _ _ _ HL). lra.
    Qed.

    Lemma settled_pair q u : settle s0 sl0 lo hi = Good tt -> 0 <= u -> u < IZR hi \/ u < IZR (pair_proved sl0) -> u < IZR present ->
      In q (names_at P k past u) -> pair_at P past (c :: past) u q.
    Proof.
      intros S H0 Hu Hp I. destruct (settled P past s0 sl0 _ _ knows0 S) as [_ HP].
      destruct (Rlt_or_le u (IZR (pair_proved sl0))) as [Hl|Hl]; [apply (proved_apart _ _ _ _ _ _ old); try assumption; lra|].
      pose proof (pair_ahead _ _ _ _ _ _ old) as A. apply IZR_le in A.
      rewrite (one_name _ _ _ _ _ _ old) in I by lra. destruct I as [<-|[]]. left. apply HP. lra.
    Qed.

    Lemma after_own : corner k c = None -> slot_true P (c :: past) (c :: past) present k sl.
    Proof.
      intros Co. pose proof (own_or_beside Co) as Own. unfold new_slot in taken. rewrite Co in taken.
      apply try_good in taken as (q & A & E). apply known_good in A. unfold own_flip in E.
      apply need_good in E as [Hp E]. apply Z.leb_le in Hp. apply try_good in E as (u & S & E). destruct u.
      apply try_good in E as (ap & Ap & E). apply need_good in E as [-> E]. apply try_good in E as (u & Th & E). destruct u.
      apply try_good in E as (w & _ & E). injection E as <-. clear w.
      apply IZR_le in Hp as Hp'. apply IZR_le in order as O. apply IZR_le in hi_past as Hi.
      assert (Last : last_edge P k (c :: past) = Some q) by (cbn [last_edge]; rewrite (named _ _ _ _ _ _ old); exact A).
      assert (One : forall u, IZR lo <= u -> names_at P k past u = [name sl0]) by (intros u Hu; apply (one_name _ _ _ _ _ _ old); lra).
      assert (Re : renamed k c [name sl0] = [q]) by (unfold renamed; simpl; rewrite A; reflexivity).
      split; cbn [name opened proved pair_proved others]; try lia.
      - exact Last.
      - intros p u Hu Eu Nu. destruct (Rlt_or_le u (IZR lo)) as [Hl|Hl]; [|exfalso; apply Nu, bracketed_now; lra].
        rewrite edge_before in Eu by lra. apply same_legal, settled_legal; try assumption; [lra|]. intros B. apply Nu, bracketed_before, B.
      - intros u Hu. cbn [edge_at]. rewrite bracket. destruct (Rle_dec (IZR hi) u); [exact Last|lra].
      - intros p u Hu Hu' I. apply same_pair. destruct (Rlt_or_le u (IZR lo)) as [Hl|Hl].
        + rewrite names_before in I by exact Hl. apply settled_pair; try assumption; lra.
        + rewrite names_within in I by lra. rewrite One, Re in I by exact Hl. destruct I as [<-|I].
          * destruct (lo <? hi)%Z eqn:L; [|apply Z.ltb_ge, IZR_le in L; lra]. left. apply (pair_true P past s0 q lo hi knows0 Ap). lra.
          * rewrite <- (One u Hl) in I. apply settled_pair; try assumption; lra.
      - intros u Hu. apply bracketed_now, Hu.
      - intros u Hu. lra.
      - intros p u Hu I. destruct (Rlt_or_le u (IZR lo)) as [Hl|Hl].
        + rewrite names_before in I by exact Hl.
          destruct (settled_lasts p u S (proj1 Hu) Hl I) as [Sd F]. split; [apply same_stands, Sd|].
          destruct F as [F|F]; [left; apply flipping_before, F|right; apply same_lasts, F].
        + split.
          { apply same_stands. rewrite names_within in I by lra. rewrite One, Re in I by exact Hl.
            destruct (lo <? hi)%Z eqn:L; [|apply Z.ltb_ge, IZR_le in L; lra].
            apply (standing_true P past s0 p lo hi knows0); [|lra]. apply (every_good _ _ _ Th). destruct I as [<-|[<-|[]]]; simpl; tauto. }
          left. exists c, lo, hi. split; [left; reflexivity|]. split; [exact Own|]. split; [exact bracket|lra].
      - intros u Hu. rewrite names_after by exact Hu. rewrite One by lra. exact Re.
      - congruence.
    Qed.

    Lemma after_beside nb : corner k c = Some nb -> slot_true P (c :: past) (c :: past) present k sl.
    Proof.
      intros Co. unfold new_slot in taken. rewrite Co in taken. unfold beside_flip in taken.
      apply need_good in taken as [Sh E]. apply try_good in E as (u & S & E). destruct u.
      apply try_good in E as (news & A & E). apply try_good in E as (u & La & E). destruct u. apply try_good in E as (w & _ & E). clear w.
      destruct news as [|n news]; [discriminate|]. injection E as <-.
      set (olds := name sl0 :: (if (proved sl0 <=? lo)%Z then [] else others sl0)) in A |- *.
      apply all_known_good in A as [A1 A2]. simpl in A1.
      apply IZR_le in order as O. apply IZR_le in hi_past as Hi.
      assert (Last : last_edge P k (c :: past) = Some n) by (cbn [last_edge]; rewrite (named _ _ _ _ _ _ old); exact A1).
      assert (Hp : IZR (proved sl0) <= IZR hi).
      { apply IZR_le. apply orb_prop in Sh as [Sh|Sh]; [apply Z.leb_le in Sh; lia|].
        apply andb_prop in Sh as [Sh _]. apply andb_prop in Sh as [_ Sh]. apply Z.eqb_eq in Sh. lia. }
      assert (Olds : forall u q, IZR lo <= u -> In q (names_at P k past u) -> u < IZR hi -> In q olds).
      { intros u q Hu I Hh. unfold olds. destruct (proved sl0 <=? lo)%Z eqn:Al.
        - apply Z.leb_le, IZR_le in Al. rewrite (one_name _ _ _ _ _ _ old) in I by lra. exact I.
        - simpl in Sh. apply andb_prop in Sh as [Sh Ne]. apply andb_prop in Sh as [Op Pr]. apply Z.eqb_eq in Op, Pr.
          apply (few_names _ _ _ _ _ _ old) with (t := u); [destruct (others sl0); [discriminate|congruence]|rewrite Op, Pr; lra|exact I]. }
      assert (Pair : forall q p, after_flip k c q = Some p -> el p = el q /\ er p = er q).
      { intros q p. apply (beside_pair k c q p nb Co (beside_alone _ Co)). }
      assert (Re : renamed k c [name sl0] = [n]) by (unfold renamed; simpl; rewrite A1; reflexivity).
      assert (Within : forall u q, IZR lo <= u < IZR hi -> In q (names_at P k (c :: past) u) ->
        In q (n :: news) \/ In q (names_at P k past u)).
      { intros u q Hu I. rewrite names_within in I by exact Hu. apply in_app_or in I as [I|I]; [left|right; exact I].
        apply renamed_in in I as (p & Ip & F). apply (A2 p q); [apply (Olds u); try assumption; lra|exact F]. }
      assert (PairOf : forall q p u, el p = el q -> er p = er q -> pair_at P past (c :: past) u q -> pair_at P past (c :: past) u p).
      { intros q p u E1 E2. unfold pair_at, near_pair. rewrite E1, E2. tauto. }
      split; cbn [name opened proved pair_proved others]; try lia.
      - exact Last.
      - intros p u Hu Eu Nu. destruct (Rlt_or_le u (IZR lo)) as [Hl|Hl]; [|exfalso; apply Nu, bracketed_now; lra].
        rewrite edge_before in Eu by lra. apply same_legal, settled_legal; try assumption; [lra|]. intros B. apply Nu, bracketed_before, B.
      - intros u Hu. cbn [edge_at]. rewrite bracket. destruct (Rle_dec (IZR hi) u); [exact Last|lra].
      - intros p u Hu Hu' I. apply same_pair.
        assert (Up : u < IZR hi \/ u < IZR (pair_proved sl0)).
        { destruct (Z.max_spec (pair_proved sl0) hi) as [[_ X]|[_ X]]; rewrite X in Hu; lra. }
        assert (From : forall q, In q (names_at P k past u) -> pair_at P past (c :: past) u q)
          by (intros q Iq; apply settled_pair; try assumption; lra).
        destruct (Rlt_or_le u (IZR lo)) as [Hl|Hl]; [rewrite names_before in I by exact Hl; apply From, I|].
        assert (Old : In p (names_at P k past u) \/ exists q, In q (names_at P k past u) /\ after_flip k c q = Some p).
        { destruct (Rlt_or_le u (IZR hi)) as [Hh|Hh].
          - rewrite names_within in I by lra. apply in_app_or in I as [I|I]; [right; apply renamed_in, I|left; exact I].
          - rewrite names_after in I by exact Hh. right. apply renamed_in, I. }
        destruct Old as [Iq|(q & Iq & F)]; [apply From, Iq|]. destruct (Pair q p F) as [E1 E2].
        apply (PairOf q p u E1 E2), From, Iq.
      - intros u Hu. apply bracketed_now, Hu.
      - intros u Hu. assert (Up : u < IZR (pair_proved sl0)).
        { destruct (Z.max_spec (pair_proved sl0) hi) as [[_ X]|[_ X]]; rewrite X in Hu; lra. }
        destruct (Pair _ _ A1) as [E1 E2]. unfold near_pair. rewrite E1, E2. apply (proved_near _ _ _ _ _ _ old). lra.
      - intros p u Hu I. destruct (Rlt_or_le u (IZR lo)) as [Hl|Hl].
        + rewrite names_before in I by exact Hl.
          destruct (settled_lasts p u S (proj1 Hu) Hl I) as [Sd F]. split; [apply same_stands, Sd|].
          destruct F as [F|F]; [left; apply flipping_before, F|right; apply same_lasts, F].
        + destruct (lo <? hi)%Z eqn:Lt; [|apply Z.ltb_ge, IZR_le in Lt; lra].
          assert (Tested : forall q, In q (if (proved sl0 <=? lo)%Z then name sl0 :: n :: news else n :: news) -> lasts_at P past u q).
          { intros q Iq. apply (lasting_true P past s0 q lo hi knows0); [|lra]. apply (every_good _ _ _ La q Iq). }
          assert (Both : forall q, lasts_at P past u q -> stands_at P (c :: past) u q /\ (flipping k (c :: past) u \/ lasts_at P (c :: past) u q)).
          { intros q L. split; [apply same_stands, (proj1 L)|right; apply same_lasts, L]. }
          destruct (Within u p ltac:(lra) I) as [In_|In_].
          * apply Both, Tested. destruct (proved sl0 <=? lo)%Z; [right|]; exact In_.
          * destruct (proved sl0 <=? lo)%Z eqn:Al.
            -- apply Z.leb_le, IZR_le in Al. rewrite (one_name _ _ _ _ _ _ old) in In_ by lra. destruct In_ as [<-|[]].
               apply Both, Tested. left. reflexivity.
            -- simpl in Sh. apply andb_prop in Sh as [Sh _]. apply andb_prop in Sh as [_ Pr]. apply Z.eqb_eq in Pr.
               destruct (proved_lasts _ _ _ _ _ _ old p u) as [Sd F]; [rewrite Pr; lra|exact In_|]. split; [apply same_stands, Sd|].
               destruct F as [F|F]; [left; apply flipping_before, F|right; apply same_lasts, F].
      - intros u Hu. rewrite names_after by exact Hu. rewrite (one_name _ _ _ _ _ _ old) by lra. exact Re.
      - intros _ q u Hu I. destruct (lo <? hi)%Z eqn:Lt; [|apply Z.ltb_ge, IZR_le in Lt; lra].
        destruct (Within u q Hu I) as [In_|In_].
        + destruct In_ as [In_|In_]; [left; exact In_|right; apply in_or_app; left; exact In_].
        + right. apply in_or_app. right. apply (Olds u); try assumption; lra.
    Qed.

    Lemma after_flip_true : slot_true P (c :: past) (c :: past) present k sl.
    Proof. pose proof after_beside as B. pose proof after_own as O. destruct (corner k c) as [nb|]; [exact (B nb eq_refl)|exact (O eq_refl)]. Qed.
  End Slot.
End Flip.

Lemma flip_numbers t f lo hi k k1 k2 k3 k4 m : let c := Flip t f lo hi k k1 k2 k3 k4 in
  (In m [k; k1; k2; k3; k4] -> bracket_of m c = Some (lo, hi) /\ (corner m c = None -> own m c = true)) /\
  (~ In m [k; k1; k2; k3; k4] -> bracket_of m c = None /\ forall q, after_flip m c q = Some q) /\
  (NoDup [k; k1; k2; k3; k4] -> forall nb, corner m c = Some nb -> own m c = false).
Proof.
  assert (Eq : forall a b, Pos.eqb a b = true <-> a = b) by (intros; apply Pos.eqb_eq).
  simpl. split; [|split].
  - intros H. split.
    + destruct H as [<-|[<-|[<-|[<-|[<-|[]]]]]]; rewrite Pos.eqb_refl, ?orb_true_r; reflexivity.
    + destruct (Pos.eqb m k1) eqn:E1; [discriminate|]. destruct (Pos.eqb m k2) eqn:E2; [discriminate|].
      destruct (Pos.eqb m k3) eqn:E3; [discriminate|]. destruct (Pos.eqb m k4) eqn:E4; [discriminate|]. intros _.
      apply Pos.eqb_neq in E1, E2, E3, E4. apply Eq. destruct H as [H|[H|[H|[H|[H|[]]]]]]; congruence.
  - intros H. assert (forall n, (n = k \/ n = k1 \/ n = k2 \/ n = k3 \/ n = k4) -> Pos.eqb m n = false) as X.
    { intros n Hn. apply Pos.eqb_neq. intros ->. apply H. repeat destruct Hn as [<-|Hn]; subst; tauto. }
    rewrite !X by tauto. split; [reflexivity|]. intros q. reflexivity.
  - intros D nb H. apply NoDup_cons_iff in D as [D _]. apply Pos.eqb_neq. intros ->. apply D.
    destruct (Pos.eqb k k1) eqn:E1; [left; symmetry; apply Eq, E1|]. destruct (Pos.eqb k k2) eqn:E2; [right; left; symmetry; apply Eq, E2|].
    destruct (Pos.eqb k k3) eqn:E3; [right; right; left; symmetry; apply Eq, E3|].
    destruct (Pos.eqb k k4) eqn:E4; [right; right; right; left; symmetry; apply Eq, E4|discriminate].
Qed.

Lemma distinct_true ks : distinct ks = true -> NoDup ks.
Proof.
  induction ks as [|k ks IH]; simpl; intros H; [constructor|]. apply andb_prop in H as [H1 H2]. constructor; [|apply IH, H2].
  apply negb_true_iff in H1. intros I. assert (existsb (Pos.eqb k) ks = true) as X; [|congruence].
  apply existsb_exists. exists k. split; [exact I|apply Pos.eqb_refl].
Qed.

Lemma flip_keeps past s t f lo hi k k1 k2 k3 k4 s1 n (c := Flip t f lo hi k k1 k2 k3 k4) :
  (lo <= hi)%Z -> (hi <= n)%Z -> distinct [k; k1; k2; k3; k4] = true -> invariant P past past s ->
  each (flip_one c lo hi) [k; k1; k2; k3; k4] s = Good s1 ->
  invariant P (c :: past) (c :: past) (at_time s1 (Z.max (now s1) n)) /\ todo s1 = todo s.
Proof.
  intros O Hn Ds I0 E. apply distinct_true in Ds as Nd. pose proof (NoDup_rev Nd) as Dr. rewrite <- app_nil_r in Dr.
  assert (Start : flipped c lo hi s [] s). { split; try reflexivity; try tauto; intros ? ? []. }
  pose proof (flips_keep c lo hi s _ _ _ _ Dr Start E) as [M N D Y X L]. rewrite app_nil_r in *. clear Start E Dr Ds.
  split; [|exact D].
  pose proof (invariant_at_time past past s (Z.max (now s1) n) ltac:(lia) I0) as I1.
  destruct (invariant_more c _ _ _ I1) as [K T A]. clear I0 I1.
  split.
  - intros g m F. cbn [movers at_time] in F. rewrite M in F. apply K, F.
  - intros m sl F. cbn [slots at_time now] in F. cbn [now at_time].
    destruct (flip_numbers t f lo hi k k1 k2 k3 k4 m) as (In_ & Out & Alone). fold c in In_, Out, Alone.
    destruct (in_dec Pos.eq_dec m [k; k1; k2; k3; k4]) as [Hm|Hm].
    + destruct (In_ Hm) as [B Own]. destruct (Y m sl (proj1 (in_rev _ _) Hm) F) as (sl0 & F0 & New).
      apply (after_flip_true c lo hi s O past m sl0 sl); try assumption; try reflexivity; [apply T, F0|lia|apply Alone, Nd].
    + rewrite X in F by (rewrite <- in_rev; exact Hm). destruct (Out Hm) as [B AF].
      specialize (T m sl F). cbn [now at_time] in T.
      apply slot_unchanged; try assumption. intros g u v H. discriminate.
  - intros m F. apply A. cbn [slots at_time] in *. apply L, F.
Qed.
End Replay.
