(* What a run of the checker says of names and of paths: brackets of one edge do not meet but where it is beside both flips, each name
   in a bracket can be changed by its flip, and every path is continuous. *)
From Coq Require Import ZArith List Bool Reals Lra Lia FMapPositive.
From Voroproof Require Import Geometry Piece EdgeSound History Replay LifeSound ClaimSound Invariant ReplaySound StepSound Arc Spread Envelope Topology.
Import ListNotations.
Open Scope R_scope.

(* A function that is f before u and g from u on is continuous, if both are and they meet at u. *)
Lemma glued (f g h : R -> R) u : (forall t, t < u -> h t = f t) -> (forall t, u <= t -> h t = g t) -> f u = g u ->
  continuity f -> continuity g -> continuity h.
Proof.
  intros Before After Meet F G t e E.
  assert (At : forall x y z, continuity x -> x t = z -> exists d, 0 < d /\ (forall w, Rabs (w - t) < d -> y w = x w -> Rabs (y w - z) < e)).
  { intros x y z X Z. destruct (X t e E) as (d & D & N). exists d. split; [exact D|]. intros w W Y. rewrite Y, <- Z.
    destruct (Req_dec w t) as [->|O]; [replace (x t - x t) with 0 by ring; rewrite Rabs_R0; exact E|].
    apply (N w). split; [split; [exact I|congruence]|exact W]. }
  destruct (Rtotal_order t u) as [L|[->|L]].
  - destruct (At f h (h t) F) as (d & D & N); [symmetry; apply Before, L|]. exists (Rmin d (u - t)). split; [apply Rmin_glb_lt; lra|].
    intros w [_ W]. change (Rabs (w - t) < Rmin d (u - t)) in W. pose proof (Rmin_l d (u - t)). pose proof (Rmin_r d (u - t)).
    apply (N w); [lra|]. apply Before. pose proof (Rle_abs (w - t)). lra.
  - destruct (At f h (h u) F) as (d & D & N); [rewrite After by lra; exact Meet|].
    destruct (At g h (h u) G) as (d' & D' & N'); [rewrite After by lra; reflexivity|]. exists (Rmin d d'). split; [apply Rmin_glb_lt; lra|].
    intros w [_ W]. change (Rabs (w - u) < Rmin d d') in W. pose proof (Rmin_l d d'). pose proof (Rmin_r d d').
    destruct (Rlt_or_le w u) as [Lw|Lw]; [apply (N w); [lra|apply Before, Lw]|apply (N' w); [lra|apply After, Lw]].
  - destruct (At g h (h t) G) as (d & D & N); [symmetry; apply After; lra|]. exists (Rmin d (t - u)). split; [apply Rmin_glb_lt; lra|].
    intros w [_ W]. change (Rabs (w - t) < Rmin d (t - u)) in W. pose proof (Rmin_l d (t - u)). pose proof (Rmin_r d (t - u)).
    apply (N w); [lra|]. apply After. pose proof (Rle_abs (- (w - t))) as B. rewrite Rabs_Ropp in B. lra.
Qed.

(* The circle of a vertex touches three generators. *)
Lemma vertex_differs o i j k : vertex_circle o i j k -> i <> j /\ i <> k /\ j <> k.
Proof. unfold vertex_circle, counterclockwise. intros (_ & _ & _ & C). repeat split; intros ->; lra. Qed.

Lemma all_known_some {A B} (f : A -> option B) w l : forall m, all_known f w l = Good m -> forall a, In a l -> f a <> None.
Proof.
  induction l as [|b l IH]; cbn [all_known]; intros m H a I; [contradiction|].
  apply try_good in H as (x & X & H). apply known_good in X. apply try_good in H as (xs & Y & H).
  destruct I as [<-|I]; [congruence|apply (IH xs Y a I)].
Qed.

Section Run.
  Variable P : problem.
  Hypothesis tolerance_nonneg : (0 <= tolerance P)%Z.

  (* What holds of a claim after those of its past, beside its truth. *)
  Record orderly (earlier : list claim) (c : claim) : Prop := {
    own_is : forall t f lo hi k0 k1 k2 k3 k4 u q, c = Flip t f lo hi k0 k1 k2 k3 k4 ->
      IZR lo <= u -> In q (names_at P k0 earlier u) -> q = f \/ q = reversed f;
    all_five : forall t f lo hi k0 k1 k2 k3 k4, c = Flip t f lo hi k0 k1 k2 k3 k4 ->
      forall k, In k [k0; k1; k2; k3; k4] -> PositiveMap.find k (edges P) <> None;
    takes_name : forall k lo hi u q, bracket_of k c = Some (lo, hi) -> IZR lo <= u -> In q (names_at P k earlier u) -> after_flip k c q <> None;
    no_overlap : forall d k lo hi lo' hi', In d earlier -> own k d = true \/ own k c = true -> bracket_of k d = Some (lo, hi) ->
      bracket_of k c = Some (lo', hi') -> (hi <= lo')%Z;
    instants_over : forall d k t lo' hi', In d earlier -> bracket_of k d = Some (t, t) -> bracket_of k c = Some (lo', hi') -> (t <= lo')%Z;
    over_or_shared : forall d k lo hi lo' hi', In d earlier -> bracket_of k d = Some (lo, hi) -> bracket_of k c = Some (lo', hi') ->
      (hi <= lo' \/ hi = hi')%Z;
    turns_late : forall g t v d h u w, turn_of c g = Some (t, v) -> In d earlier -> turn_of d h = Some (u, w) -> (u <= t)%Z;
    turns_after : forall g t v d k lo hi, turn_of c g = Some (t, v) -> In d earlier -> bracket_of k d = Some (lo, hi) -> (hi <= t)%Z
  }.

  (* Since when a slot is free of its own flips, and of those of one instant. *)
  Definition free_from (sl : slot) : Z := match others sl with [] => proved sl | _ => opened sl end.

  (* Past brackets and turns are over. *)
  Definition slot_over (past : list claim) (k : positive) (sl : slot) : Prop :=
    (forall d lo hi, In d past -> bracket_of k d = Some (lo, hi) -> (hi <= proved sl)%Z) /\
    (forall d lo hi, In d past -> bracket_of k d = Some (lo, hi) -> own k d = true \/ lo = hi -> (hi <= free_from sl)%Z) /\
    (forall d lo hi, In d past -> bracket_of k d = Some (lo, hi) -> others sl <> [] -> (hi <= opened sl \/ hi = proved sl)%Z).
  Definition slots_over (past : list claim) (s : state) : Prop := forall k sl, PositiveMap.find k (slots s) = Some sl -> slot_over past k sl.
  Record over (past : list claim) (s : state) : Prop := {
    brackets_over : slots_over past s;
    turns_over : forall d g u v, In d past -> turn_of d g = Some (u, v) -> (u <= now s)%Z;
    flips_over : forall d k lo hi, In d past -> bracket_of k d = Some (lo, hi) -> (hi <= now s)%Z
  }.

  (* The slots after a flip. *)
  Lemma each_flip c lo hi ks : forall s s', NoDup ks -> each (flip_one c lo hi) ks s = Good s' ->
    now s' = now s /\
    (forall k, In k ks -> exists sl0 sl, PositiveMap.find k (slots s) = Some sl0 /\ new_slot c lo hi s k sl0 = Good sl /\ PositiveMap.find k (slots s') = Some sl) /\
    (forall k, ~ In k ks -> PositiveMap.find k (slots s') = PositiveMap.find k (slots s)).
  Proof.
    induction ks as [|k ks IH]; cbn [each]; intros s s' Nd E; [injection E as <-; split; [reflexivity|split; [intros k []|reflexivity]]|].
    apply NoDup_cons_iff in Nd as [Fresh Nd]. apply try_good in E as (s1 & E1 & E). destruct (IH _ _ Nd E) as (N & In_ & Out). unfold flip_one in E1.
    apply try_good in E1 as (sl0 & F & E1). apply known_good in F. apply try_good in E1 as (sl & New & E1). injection E1 as <-.
    change (new_slot c lo hi s k sl0 = Good sl) in New. cbn [slots now put] in *. split; [exact N|]. split.
    - intros k' [<-|I].
      + exists sl0, sl. split; [exact F|]. split; [exact New|]. rewrite Out by exact Fresh. apply PositiveMap.gss.
      + destruct (In_ k' I) as (a & b & A & B & C). assert (D : k' <> k) by (intros ->; contradiction).
        rewrite PositiveMap.gso in A by exact D. exists a, b. split; [exact A|]. split; [|exact C].
        rewrite <- B. symmetry. apply (new_slot_movers c lo hi (put s k sl)). reflexivity.
    - intros k' N'. rewrite Out by (intros I; apply N'; right; exact I). apply PositiveMap.gso. intros ->. apply N'. left. reflexivity.
  Qed.

  (* What a new slot says of the old one, and what it is. *)
  Lemma new_slot_says c lo hi s k sl0 sl : new_slot c lo hi s k sl0 = Good sl -> (corner k c <> None -> own k c = false) ->
    (proved sl0 <= lo /\ after_flip k c (name sl0) <> None \/
     own k c = false /\ others sl0 <> [] /\ opened sl0 = lo /\ proved sl0 = hi /\ forall q, In q (name sl0 :: others sl0) -> after_flip k c q <> None)%Z /\
    opened sl = lo /\ proved sl = hi /\ (own k c = true -> others sl = [] /\ proved sl0 <= lo)%Z.
  Proof.
    intros E Al. unfold new_slot in E. destruct (corner k c) as [nb|] eqn:Co.
    - specialize (Al ltac:(discriminate)). unfold beside_flip in E. apply need_good in E as [Sh E]. apply try_good in E as (u & _ & E).
      apply try_good in E as (news & A & E). apply try_good in E as (u' & _ & E). apply try_good in E as (u'' & _ & E). destruct news as [|m news]; [discriminate|]. injection E as <-.
      cbn [opened proved others]. pose proof (all_known_some _ _ _ _ A) as Kn. split; [|split; [reflexivity|split; [reflexivity|congruence]]].
      destruct (proved sl0 <=? lo)%Z eqn:L.
      + left. apply Z.leb_le in L. split; [exact L|apply Kn; left; reflexivity].
      + right. cbn [orb] in Sh. apply andb_prop in Sh as [Sh Ne]. apply andb_prop in Sh as [Op Pr]. apply Z.eqb_eq in Op, Pr.
        split; [exact Al|]. split; [intros X; rewrite X in Ne; discriminate|]. split; [exact Op|]. split; [exact Pr|exact Kn].
    - apply try_good in E as (q & A & E). apply known_good in A. unfold own_flip in E. apply need_good in E as [Hp E]. apply Z.leb_le in Hp.
      apply try_good in E as (u & _ & E). apply try_good in E as (ap & _ & E). apply need_good in E as [_ E]. apply try_good in E as (u' & _ & E).
      apply try_good in E as (u'' & _ & E). injection E as <-. cbn [opened proved others]. split; [left; split; [exact Hp|congruence]|]. repeat split. exact Hp.
  Qed.

  Lemma bracket_five t f lo hi k0 k1 k2 k3 k4 k lo' hi' : bracket_of k (Flip t f lo hi k0 k1 k2 k3 k4) = Some (lo', hi') ->
    In k [k0; k1; k2; k3; k4] /\ lo' = lo /\ hi' = hi.
  Proof.
    intros B. destruct (in_dec Pos.eq_dec k [k0; k1; k2; k3; k4]) as [I|I].
    - destruct (flip_numbers t f lo hi k0 k1 k2 k3 k4 k) as [A _]. destruct (A I) as [A' _]. rewrite A' in B. injection B as <- <-. repeat split; assumption.
    - destruct (flip_numbers t f lo hi k0 k1 k2 k3 k4 k) as (_ & A & _). destruct (A I) as [A' _]. rewrite A' in B. discriminate.
  Qed.

  Lemma flip_orderly past s t f lo hi k0 k1 k2 k3 k4 s' (c := Flip t f lo hi k0 k1 k2 k3 k4) :
    good P past s -> over past s -> step P s c = Good s' -> orderly past c /\ over (c :: past) s'.
  Proof.
    intros [Iv _] [Bo To Fo] E. cbn [step c] in E. unfold flip in E.
    apply try_good in E as (sl & F & E). apply known_good in F. apply need_good in E as [Name E]. apply need_good in E as [B E].
    repeat (apply andb_prop in B as [B ?]). apply Z.leb_le in H2. clear B H H0 H1. rename H2 into O.
    apply need_good in E as [Ds E]. apply andb_prop in Ds as [Ds _]. apply distinct_true in Ds. apply try_good in E as (gone & _ & E). apply need_good in E as [_ E].
    apply try_good in E as (s1 & E1 & E). injection E as <-. fold c in E1.
    destruct (each_flip c lo hi _ _ _ Ds E1) as (N & In_ & Out).
    assert (Al : forall k, corner k c <> None -> own k c = false).
    { intros k Co. destruct (flip_numbers t f lo hi k0 k1 k2 k3 k4 k) as (_ & _ & A). destruct (corner k c) as [nb|] eqn:X; [|congruence]. apply (A Ds nb X). }
    assert (Own0 : own k0 c = true) by apply Pos.eqb_refl.
    split; [split|split].
    - intros t' f' lo' hi' k0' k1' k2' k3' k4' u q Eq Hu I. unfold c in Eq. injection Eq as <- <- <- <- <- <- <- <- <-.
      destruct (In_ k0) as (sl0 & sl1 & F0 & New & _); [left; reflexivity|]. destruct (new_slot_says _ _ _ _ _ _ _ New (Al k0)) as (_ & _ & _ & X).
      destruct (X Own0) as [_ Hp]. apply IZR_le in Hp. rewrite F in F0. injection F0 as <-.
      rewrite (one_name _ _ _ _ _ _ (slots_true _ _ _ _ Iv k0 sl F)) in I by lra. destruct I as [<-|[]].
      apply orb_prop in Name as [Name|Name]; apply edge_eqb_true in Name; tauto.
    - intros t' f' lo' hi' k0' k1' k2' k3' k4' Eq k I Fn. unfold c in Eq. injection Eq as <- <- <- <- <- <- <- <- <-.
      destruct (In_ k I) as (sl0 & _ & F0 & _ & _). pose proof (named _ _ _ _ _ _ (slots_true _ _ _ _ Iv k sl0 F0)) as L.
      destruct (no_edge P k past Fn) as [L' _]. congruence.
    - intros k lo' hi' u q Br Hu I. apply bracket_five in Br as (Ik & -> & ->).
      destruct (In_ k Ik) as (sl0 & sl1 & F0 & New & _). destruct (new_slot_says _ _ _ _ _ _ _ New (Al k)) as (X & _).
      pose proof (slots_true _ _ _ _ Iv k sl0 F0) as T. destruct X as [(Hp & A)|(_ & Ne & Op & Pr & A)].
      + apply IZR_le in Hp. rewrite (one_name _ _ _ _ _ _ T) in I by lra. destruct I as [<-|[]]. exact A.
      + destruct (Rlt_or_le u (IZR hi)) as [L|L].
        * apply A. apply (few_names _ _ _ _ _ _ T Ne q u); [rewrite Op, Pr; lra|exact I].
        * rewrite (one_name _ _ _ _ _ _ T) in I by (rewrite Pr; exact L). destruct I as [<-|[]]. apply A. left. reflexivity.
    - intros d k l h lo' hi' Id Ow Bd Br. apply bracket_five in Br as (Ik & -> & ->).
      destruct (In_ k Ik) as (sl0 & sl1 & F0 & New & _). destruct (new_slot_says _ _ _ _ _ _ _ New (Al k)) as (X & _). destruct (Bo k sl0 F0) as (Any & Own & _).
      destruct X as [(Hp & _)|(Nown & Ne & Op & Pr & _)]; [specialize (Any d l h Id Bd); lia|]. destruct Ow as [Ow|Ow]; [|congruence].
      specialize (Own d l h Id Bd (or_introl Ow)). unfold free_from in Own. destruct (others sl0); [congruence|lia].
    - intros d k w lo' hi' Id Bd Br. apply bracket_five in Br as (Ik & -> & ->).
      destruct (In_ k Ik) as (sl0 & sl1 & F0 & New & _). destruct (new_slot_says _ _ _ _ _ _ _ New (Al k)) as (X & _). destruct (Bo k sl0 F0) as (Any & Own & _).
      destruct X as [(Hp & _)|(Nown & Ne & Op & Pr & _)]; [specialize (Any d w w Id Bd); lia|].
      specialize (Own d w w Id Bd (or_intror eq_refl)). unfold free_from in Own. destruct (others sl0); [congruence|lia].
    - intros d k l h lo' hi' Id Bd Br. apply bracket_five in Br as (Ik & -> & ->).
      destruct (In_ k Ik) as (sl0 & sl1 & F0 & New & _). destruct (new_slot_says _ _ _ _ _ _ _ New (Al k)) as (X & _). destruct (Bo k sl0 F0) as (Any & _ & Sh).
      destruct X as [(Hp & _)|(Nown & Ne & Op & Pr & _)]; [specialize (Any d l h Id Bd); lia|]. specialize (Sh d l h Id Bd Ne). lia.
    - discriminate.
    - discriminate.
    - intros k sl' F'. cbn [slots] in F'. destruct (in_dec Pos.eq_dec k [k0; k1; k2; k3; k4]) as [Ik|Ik].
      + destruct (In_ k Ik) as (sl0 & sl1 & F0 & New & F1). rewrite F1 in F'. injection F' as ->.
        destruct (new_slot_says _ _ _ _ _ _ _ New (Al k)) as (X & Op' & Pr' & Own'). destruct (Bo k sl0 F0) as (Any & Own & Sh). split; [|split].
        * intros d l h [<-|Id] Bd; [apply bracket_five in Bd as (_ & -> & ->); lia|]. specialize (Any d l h Id Bd). lia.
        * intros d l h [<-|Id] Bd Ow.
          -- apply bracket_five in Bd as (_ & -> & ->). unfold free_from. destruct Ow as [Ow|Ow]; [destruct (Own' Ow) as [Ot _]; rewrite Ot; lia|].
             destruct (others sl'); lia.
          -- specialize (Any d l h Id Bd). specialize (Own d l h Id Bd Ow). unfold free_from in *.
             assert (h <= lo)%Z by (destruct X as [(Hp & _)|(_ & Ne & Op & _)]; [lia|destruct (others sl0); [congruence|lia]]).
             destruct (others sl'); lia.
        * intros d l h [<-|Id] Bd _; [apply bracket_five in Bd as (_ & -> & ->); lia|]. specialize (Any d l h Id Bd).
          destruct X as [(Hp & _)|(_ & Ne & Op & Pr & _)]; [lia|]. specialize (Sh d l h Id Bd Ne). lia.
      + rewrite Out in F' by exact Ik. destruct (Bo k sl' F') as (Any & Own & Sh). split; [|split].
        * intros d l h [<-|Id] Bd; [apply bracket_five in Bd as (Ik' & _); contradiction|apply (Any d l h Id Bd)].
        * intros d l h [<-|Id] Bd; [apply bracket_five in Bd as (Ik' & _); contradiction|apply (Own d l h Id Bd)].
        * intros d l h [<-|Id] Bd; [apply bracket_five in Bd as (Ik' & _); contradiction|apply (Sh d l h Id Bd)].
    - intros d g u v [<-|Id] Td; [discriminate|]. specialize (To d g u v Id Td). cbn [now]. lia.
    - intros d k l h [<-|Id] Bd; cbn [now].
      + apply bracket_five in Bd as (_ & -> & ->). destruct (lo =? hi)%Z; lia.
      + specialize (Fo d k l h Id Bd). lia.
  Qed.

  (* Turns leave past brackets over. *)
  Lemma turns_leave past own t slack ks s s' : slots_over past s -> each (turn_one P own t slack) ks s = Good s' -> slots_over past s'.
  Proof.
    apply each_keeps. clear s s'. intros k s s' Bo E. unfold turn_one in E. apply try_good in E as (sl & F & E). apply known_good in F.
    apply try_good in E as (u & _ & E). injection E as <-. intros k' sl' F'. cbn [slots put] in F'. destruct (Pos.eq_dec k' k) as [->|D].
    - rewrite PositiveMap.gss in F'. injection F' as <-. destruct (Bo k sl F) as (Any & Own & Sh). split; [|split]; cbn [proved opened others].
      + intros d lo hi Id Bd. specialize (Any d lo hi Id Bd). lia.
      + intros d lo hi Id Bd Ow. specialize (Any d lo hi Id Bd). specialize (Own d lo hi Id Bd Ow). unfold free_from in *. cbn [opened proved others].
        destruct (proved sl <? t)%Z; [lia|]. destruct (others sl); lia.
      + intros d lo hi Id Bd. destruct (proved sl <? t)%Z eqn:L; [congruence|]. apply Z.ltb_ge in L. intros Ne. specialize (Sh d lo hi Id Bd Ne). lia.
    - rewrite PositiveMap.gso in F' by exact D. apply (Bo k' sl' F').
  Qed.

  (* A claim that is no flip, and turns generators at t. *)
  Lemma turn_orderly past s c t s' : (forall k, bracket_of k c = None) -> (forall g u v, turn_of c g = Some (u, v) -> u = t) -> (now s <= t)%Z ->
    over past s -> slots_over past s' -> now s' = t -> orderly past c /\ over (c :: past) s'.
  Proof.
    intros Nb At N [_ To Fo] Bo E. split; [split|split].
    - intros t' f lo hi k0 k1 k2 k3 k4 u q Eq. specialize (Nb k0). rewrite Eq in Nb. cbn [bracket_of] in Nb. rewrite Pos.eqb_refl in Nb. discriminate.
    - intros t' f lo hi k0 k1 k2 k3 k4 Eq. specialize (Nb k0). rewrite Eq in Nb. cbn [bracket_of] in Nb. rewrite Pos.eqb_refl in Nb. discriminate.
    - intros k lo hi u q B. rewrite Nb in B. discriminate.
    - intros d k lo hi lo' hi' _ _ _ B. rewrite Nb in B. discriminate.
    - intros d k w lo' hi' _ _ B. rewrite Nb in B. discriminate.
    - intros d k lo hi lo' hi' _ _ B. rewrite Nb in B. discriminate.
    - intros g u v d h w z T Id Td. apply At in T. specialize (To d h w z Id Td). lia.
    - intros g u v d k lo hi T Id Bd. apply At in T. specialize (Fo d k lo hi Id Bd). lia.
    - intros k sl F. destruct (Bo k sl F) as (Any & Own & Sh). split; [|split].
      + intros d lo hi [<-|Id] Bd; [rewrite Nb in Bd; discriminate|apply (Any d lo hi Id Bd)].
      + intros d lo hi [<-|Id] Bd; [rewrite Nb in Bd; discriminate|apply (Own d lo hi Id Bd)].
      + intros d lo hi [<-|Id] Bd; [rewrite Nb in Bd; discriminate|apply (Sh d lo hi Id Bd)].
    - intros d g u v [<-|Id] Td; [apply At in Td; lia|]. specialize (To d g u v Id Td). lia.
    - intros d k lo hi [<-|Id] Bd; [rewrite Nb in Bd; discriminate|]. specialize (Fo d k lo hi Id Bd). lia.
  Qed.

  Lemma step_orderly past s c s' : good P past s -> over past s -> step P s c = Good s' -> orderly past c /\ over (c :: past) s'.
  Proof.
    intros G O E. destruct c as [t f lo hi k0 k1 k2 k3 k4|t i j wi wj ps b a k around|t g v ps around].
    - apply (flip_orderly past s t f lo hi k0 k1 k2 k3 k4 s' G O E).
    - set (c := Collision t i j wi wj ps b a k around) in *. cbn [step c] in E. unfold collide in E. fold c in E.
      apply need_good in E as [N E]. apply Z.leb_le in N. apply try_good in E as (sl & F & E). apply need_good in E as [_ E].
      apply try_good in E as (mi & _ & E). apply try_good in E as (mj & _ & E). apply need_good in E as [_ E]. apply need_good in E as [_ E].
      apply need_good in E as [_ E]. apply try_good in E as (s1 & E1 & E). apply try_good in E as (s2 & E2 & E). apply try_good in E as (s3 & E3 & E).
      injection E as <-. apply (turn_orderly past s c t); try assumption; try reflexivity.
      + intros g u v. unfold c. cbn [turn_of]. destruct (Pos.eqb g container); [discriminate|].
        destruct (Pos.eqb g i); [congruence|]. destruct (Pos.eqb g j); congruence.
      + intros m sl' F'. change (PositiveMap.find m (slots s3) = Some sl') in F'.
        destruct (turn_movers _ _ _ _ E2) as (S2 & _). destruct (turn_movers _ _ _ _ E3) as (S3 & _). rewrite S3, S2 in F'.
        apply (turns_leave past _ _ _ _ _ _ (brackets_over _ _ O) E1 m sl' F').
    - set (c := Maneuver t g v ps around) in *. cbn [step c] in E. unfold manoeuvre in E. fold c in E.
      apply need_good in E as [N E]. apply Z.leb_le in N. apply try_good in E as ([m rest] & F & E). apply need_good in E as [_ E].
      apply need_good in E as [_ E]. apply try_good in E as (s1 & E1 & E). apply try_good in E as (s2 & E2 & E).
      injection E as <-. apply (turn_orderly past s c t); try assumption; try reflexivity.
      + intros h u w. unfold c. cbn [turn_of]. destruct (Pos.eqb h container); [discriminate|]. destruct (Pos.eqb h g); congruence.
      + intros k sl' F'. cbn [slots] in F'. destruct (turn_movers _ _ _ _ E2) as (S2 & _). rewrite S2 in F'.
        apply (turns_leave past _ _ _ _ _ _ (brackets_over _ _ O) E1 k sl' F').
  Qed.

  Definition all_orderly (past : list claim) : Prop := forall later c earlier, past = later ++ c :: earlier -> orderly earlier c.

  Lemma run_orderly cs : forall past s n s' n', good P past s -> over past s -> all_orderly past -> run P s cs n = (Good s', n') ->
    all_orderly (rev cs ++ past).
  Proof.
    induction cs as [|c cs IH]; cbn [rev run]; intros past s n s' n' G O T E; [exact T|].
    destruct (step P s c) as [s1|w] eqn:E1; [|discriminate]. destruct (step_sound P tolerance_nonneg past s c s1 G E1) as [_ G1].
    destruct (step_orderly past s c s1 G O E1) as [C O1]. rewrite <- app_assoc. apply (IH (c :: past) s1 (n + 1)%Z s' n'); [exact G1|exact O1| |exact E].
    intros [|d later] e earlier H; cbn [app] in H; injection H as H1 H2; subst; [exact C|]. apply (T later e earlier). reflexivity.
  Qed.

  Lemma first_over : over [] (first_state P).
  Proof. split; [intros k sl _; split; [|split]|..]; intros d; intros; contradiction. Qed.

  Lemma all_orderly_tail c past : all_orderly (c :: past) -> orderly past c /\ all_orderly past.
  Proof.
    intros A. split; [apply (A [] c past); reflexivity|]. intros later d earlier ->. apply (A (c :: later) d earlier). reflexivity.
  Qed.

  (* A generator is on its last leg from its last turn on. *)
  Lemma leg_over g past t : (forall d u v, In d past -> turn_of d g = Some (u, v) -> IZR u <= t) -> leg_at P g past t = last_leg P g past.
  Proof.
    induction past as [|c past IH]; intros H; [reflexivity|]. cbn [leg_at last_leg]. destruct (turn_of c g) as [[u v]|] eqn:E.
    - specialize (H c u v (or_introl eq_refl) E). destruct (Rle_dec (IZR u) t); [reflexivity|contradiction].
    - apply IH. intros d u v I. apply H. right. exact I.
  Qed.

  Lemma turned_start g l u v : on_leg P g (turned l u v) (IZR u) = on_leg P g l (IZR u).
  Proof.
    unfold on_leg, turned. cbn [x y vx vy since]. unfold x_at, y_at. rewrite !plus_IZR, !mult_IZR, !minus_IZR. f_equal; ring.
  Qed.

  (* Up to a turn the path is that of the past. *)
  Lemma place_until past c g u : all_orderly (c :: past) -> (forall w v, turn_of c g = Some (w, v) -> u <= IZR w) ->
    place P (c :: past) u g = place P past u g.
  Proof.
    intros A H. apply all_orderly_tail in A as [C _]. unfold place. cbn [leg_at]. destruct (turn_of c g) as [[w v]|] eqn:E; [|reflexivity].
    specialize (H w v eq_refl). destruct (Rle_dec (IZR w) u) as [L|L]; [|reflexivity]. assert (u = IZR w) as -> by lra.
    cbn [last_leg]. rewrite E, turned_start. f_equal. symmetry. apply leg_over. intros d x z Id T. apply IZR_le. apply (turns_late _ _ C g w v d g x z E Id T).
  Qed.

  (* When the bracket of a flip ends, the edge stands by each name that it had just before. *)
  Lemma before_some t a says : before t says -> a < t -> exists u, a <= u < t /\ says u.
  Proof.
    intros (d & D & H) L. exists (Rmax a (t - d / 2)). pose proof (Rmax_l a (t - d / 2)). pose proof (Rmax_r a (t - d / 2)).
    assert (Rmax a (t - d / 2) < t) by (apply Rmax_lub_lt; lra). split; [lra|]. apply H. lra.
  Qed.

  Lemma before_same t (f g : R -> list edge) q : (forall u, u < t -> f u = g u) -> before t (fun u => In q (f u)) -> before t (fun u => In q (g u)).
  Proof. intros E (d & D & H). exists d. split; [exact D|]. intros u Hu. rewrite <- E by lra. apply H, Hu. Qed.

  Lemma tested_stands past s q lo hi : (lo <= hi)%Z -> knows P past s -> four s q lo hi hi edge_there = Good true -> stands_at P past (IZR hi) q.
  Proof.
    intros O K H. apply IZR_le in O. destruct (four_known P past s _ _ _ _ _ _ K H) as [T Since]. cbv zeta in T.
    pose proof (edge_there_sound _ _ _ _ T 0 (Rle_refl 0)) as S. clear T H. rewrite !(span_start P) in S by reflexivity.
    unfold stands_at. rewrite !place_on_leg; [exact S|..]; match goal with |- IZR (since (last_leg P ?g past)) <= _ =>
      assert (X : (since (last_leg P g past) <= lo)%Z) by (apply Since; cbn [In]; tauto) end; apply IZR_le in X; lra.
  Qed.

  Definition ends_stand (past : list claim) : Prop := forall c k lo hi q, In c past -> bracket_of k c = Some (lo, hi) ->
    before (IZR hi) (fun u => In q (names_at P k past u)) -> stands_at P past (IZR hi) q.
  Definition slot_stands (past : list claim) (k : positive) (sl : slot) : Prop := forall q,
    before (IZR (proved sl)) (fun u => In q (names_at P k past u)) -> q = name sl \/ stands_at P past (IZR (proved sl)) q.
  Definition slots_stand (past : list claim) (s : state) : Prop := forall k sl, PositiveMap.find k (slots s) = Some sl -> slot_stands past k sl.

  (* What a flip has tested. *)
  Lemma new_slot_tests c lo hi s k sl0 sl : new_slot c lo hi s k sl0 = Good sl ->
    exists olds news, every (fun q => four s q lo hi hi edge_there) NotLasting (if (lo <? hi)%Z then news ++ olds else olds) = Good tt /\
      In (name sl0) olds /\ (forall p q, In p olds -> after_flip k c p = Some q -> In q news) /\
      ((proved sl0 <= lo)%Z \/ others sl0 <> [] /\ opened sl0 = lo /\ proved sl0 = hi /\ olds = name sl0 :: others sl0).
  Proof.
    intros E. unfold new_slot in E. destruct (corner k c) as [nb|].
    - unfold beside_flip in E. apply need_good in E as [Sh E]. apply try_good in E as (u & _ & E).
      apply try_good in E as (news & A & E). apply try_good in E as (u' & _ & E). apply try_good in E as ([] & Te & E). clear E u u'.
      set (olds := name sl0 :: (if (proved sl0 <=? lo)%Z then [] else others sl0)) in *. exists olds, news. split; [exact Te|].
      split; [left; reflexivity|]. split; [intros p q; apply (all_known_good _ _ _ _ A)|]. clear Te A. unfold olds. destruct (proved sl0 <=? lo)%Z eqn:L.
      + left. apply Z.leb_le, L.
      + right. cbn [orb] in Sh. apply andb_prop in Sh as [Sh Ne]. apply andb_prop in Sh as [Op Pr]. apply Z.eqb_eq in Op, Pr.
        split; [intros X; rewrite X in Ne; discriminate|]. repeat split; assumption.
    - apply try_good in E as (q & A & E). apply known_good in A. unfold own_flip in E. apply need_good in E as [Hp E]. apply Z.leb_le in Hp.
      apply try_good in E as (u & _ & E). apply try_good in E as (ap & _ & E). apply need_good in E as [_ E]. apply try_good in E as (u' & _ & E).
      apply try_good in E as ([] & Te & E). clear E. exists [name sl0], [name sl0; q]. split; [|split; [left; reflexivity|split; [|left; exact Hp]]].
      + destruct (lo <? hi)%Z; [|exact Te]. pose proof (every_good _ _ _ Te) as Go. clear Te.
        assert (All : forall l, (forall p, In p l -> four s p lo hi hi edge_there = Good true) -> every (fun p => four s p lo hi hi edge_there) NotLasting l = Good tt).
        { intros l. induction l as [|p l IH]; intros H; [reflexivity|]. cbn [every]. rewrite (H p (or_introl eq_refl)). cbn [try need]. apply IH. intros p' I. apply H. right. exact I. }
        apply All. intros p I. apply Go. apply in_app_or in I as [I|[<-|[]]]; [exact I|left; reflexivity].
      + intros p p' [<-|[]] F. right. left. congruence.
  Qed.

  Lemma new_slot_stands past s c lo hi k sl0 sl : (lo <= hi)%Z -> knows P past s -> slot_true P past past (now s) k sl0 -> slot_stands past k sl0 ->
    bracket_of k c = Some (lo, hi) -> (forall g, turn_of c g = None) -> new_slot c lo hi s k sl0 = Good sl -> forall q,
    before (IZR hi) (fun u => In q (names_at P k (c :: past) u)) -> stands_at P (c :: past) (IZR hi) q.
  Proof.
    intros O K T St Br Tn New q Bf. apply (same_stands P c past Tn). destruct (new_slot_tests _ _ _ _ _ _ _ New) as (olds & news & Te & Nm & Al & Sh). clear New.
    assert (Go : forall p, In p (if (lo <? hi)%Z then news ++ olds else olds) -> stands_at P past (IZR hi) p)
      by (intros p I; apply (tested_stands past s p lo hi O K), (every_good _ _ _ Te p I)). clear Te.
    destruct (lo <? hi)%Z eqn:L.
    - apply Z.ltb_lt, IZR_lt in L. apply Go. destruct (before_some _ _ _ Bf L) as (u & Hu & I).
      assert (Olds : forall p, In p (names_at P k past u) -> In p olds).
      { intros p Ip. destruct Sh as [Hp|(Ne & Op & Pr & ->)].
        - apply IZR_le in Hp. rewrite (one_name _ _ _ _ _ _ T) in Ip by lra. destruct Ip as [<-|[]]. exact Nm.
        - apply (few_names _ _ _ _ _ _ T Ne p u); [rewrite Op, Pr; lra|exact Ip]. }
      rewrite (names_within P c lo hi past k Br) in I by exact Hu. apply in_or_app. apply in_app_or in I as [I|I]; [left|right; apply Olds, I].
      apply renamed_in in I as (p & Ip & F). apply (Al p q); [apply Olds, Ip|exact F].
    - apply Z.ltb_ge in L. assert (lo = hi) as -> by lia. clear L.
      assert (Bf' : before (IZR hi) (fun u => In q (names_at P k past u)))
        by (revert Bf; apply before_same; intros u Hu; apply (names_before P c hi hi (Z.le_refl hi) past k Br u Hu)).
      assert (Hp : (proved sl0 <= hi)%Z) by (destruct Sh as [Sh|(_ & _ & Sh & _)]; lia).
      destruct (Z.eq_dec (proved sl0) hi) as [E|N].
      + rewrite <- E in Bf'. destruct (St q Bf') as [->|S]; [apply Go, Nm|rewrite E in S; exact S].
      + assert (Lt : IZR (proved sl0) < IZR hi) by (apply IZR_lt; lia). destruct (before_some _ _ _ Bf' Lt) as (u & Hu & I).
        rewrite (one_name _ _ _ _ _ _ T) in I by lra. destruct I as [<-|[]]. apply Go, Nm.
  Qed.

  Lemma flip_stand past s t f lo hi k0 k1 k2 k3 k4 s' (c := Flip t f lo hi k0 k1 k2 k3 k4) : good P past s -> orderly past c ->
    slots_stand past s -> ends_stand past -> step P s c = Good s' -> slots_stand (c :: past) s' /\ ends_stand (c :: past).
  Proof.
    intros [Iv _] Od Ss Es E. cbn [step c] in E. unfold flip in E.
    apply try_good in E as (sl & F & E). apply need_good in E as [Name E]. apply need_good in E as [B E].
    repeat (apply andb_prop in B as [B ?]). apply Z.leb_le in H2. clear B H H0 H1. rename H2 into O.
    apply need_good in E as [Ds E]. apply andb_prop in Ds as [Ds _]. apply distinct_true in Ds. apply try_good in E as (gone & _ & E). apply need_good in E as [_ E].
    apply try_good in E as (s1 & E1 & E). injection E as <-. fold c in E1. destruct (each_flip c lo hi _ _ _ Ds E1) as (_ & In_ & Out). clear E1 F Name sl.
    assert (Al : forall k, corner k c <> None -> own k c = false).
    { intros k Co. destruct (flip_numbers t f lo hi k0 k1 k2 k3 k4 k) as (_ & _ & A). destruct (corner k c) as [nb|] eqn:X; [|congruence]. apply (A Ds nb X). }
    assert (Tn : forall g, turn_of c g = None) by reflexivity.
    assert (Core : forall k, In k [k0; k1; k2; k3; k4] -> forall q, before (IZR hi) (fun u => In q (names_at P k (c :: past) u)) -> stands_at P (c :: past) (IZR hi) q).
    { intros k Ik. destruct (In_ k Ik) as (sl0 & sl1 & F0 & New & _). destruct (flip_numbers t f lo hi k0 k1 k2 k3 k4 k) as (Br & _). destruct (Br Ik) as [Br' _].
      apply (new_slot_stands past s c lo hi k sl0 sl1 O (movers_known _ _ _ _ Iv) (slots_true _ _ _ _ Iv k sl0 F0) (Ss k sl0 F0) Br' Tn New). }
    assert (Else : forall k, ~ In k [k0; k1; k2; k3; k4] -> forall u, names_at P k (c :: past) u = names_at P k past u).
    { intros k Ik u. destruct (flip_numbers t f lo hi k0 k1 k2 k3 k4 k) as (_ & Br & _). destruct (Br Ik) as [Br' _]. fold c in Br'. cbn [names_at]. rewrite Br'. reflexivity. }
    split.
    - intros k sl F q Bf. cbn [slots] in F. destruct (in_dec Pos.eq_dec k [k0; k1; k2; k3; k4]) as [Ik|Ik].
      + right. destruct (In_ k Ik) as (sl0 & sl1 & F0 & New & F1). rewrite F1 in F. injection F as ->.
        destruct (new_slot_says _ _ _ _ _ _ _ New (Al k)) as (_ & _ & Pr & _). rewrite Pr in *. apply (Core k Ik q Bf).
      + rewrite Out in F by exact Ik. destruct (Ss k sl F q) as [X|X]; [|left; exact X|right; apply (same_stands P c past Tn), X].
        revert Bf. apply before_same. intros u _. apply Else, Ik.
    - intros d k l h q Id Bd Bf. destruct (in_dec Pos.eq_dec k [k0; k1; k2; k3; k4]) as [Ik|Ik].
      + destruct Id as [<-|Id]; [apply bracket_five in Bd as (_ & -> & ->); apply (Core k Ik q Bf)|].
        destruct (flip_numbers t f lo hi k0 k1 k2 k3 k4 k) as (Br & _). destruct (Br Ik) as [Br' _]. fold c in Br'. clear Br.
        destruct (over_or_shared _ _ Od d k l h lo hi Id Bd Br') as [Hl| ->]; [|apply (Core k Ik q Bf)].
        apply (same_stands P c past Tn), (Es d k l h q Id Bd). apply IZR_le in Hl. revert Bf. apply before_same. intros u Hu.
        apply (names_before P c lo hi O past k Br' u). lra.
      + destruct Id as [<-|Id]; [apply bracket_five in Bd as (Ik' & _); contradiction|].
        apply (same_stands P c past Tn), (Es d k l h q Id Bd). revert Bf. apply before_same. intros u _. apply Else, Ik.
  Qed.

  Definition ready (past : list claim) (t : Z) (s : state) : Prop := forall k sl, PositiveMap.find k (slots s) = Some sl ->
    slot_stands past k sl /\ (proved sl <= t)%Z /\ forall u, IZR (proved sl) <= u -> names_at P k past u = [name sl].

  Lemma turns_stand past own t slack ks s s' : ready past t s -> each (turn_one P own t slack) ks s = Good s' -> ready past t s'.
  Proof.
    apply each_keeps.
    clear s s'. intros k s s' H E. unfold turn_one in E. apply try_good in E as (sl & F & E). apply known_good in F.
    apply try_good in E as (u & _ & E). injection E as <-. clear u. intros k' sl' F'. cbn [slots put] in F'. destruct (Pos.eq_dec k' k) as [->|D].
    - rewrite PositiveMap.gss in F'. injection F' as <-. destruct (H k sl F) as (St & Pr & One). unfold slot_stands. cbn [proved name].
      rewrite Z.max_r by exact Pr. apply IZR_le in Pr as Pr'. split; [|split; [lia|intros u Hu; apply One; lra]]. intros q Bf.
      destruct (Z.eq_dec (proved sl) t) as [E|N]; [rewrite <- E in *; apply (St q Bf)|left].
      assert (Lt : IZR (proved sl) < IZR t) by (apply IZR_lt; lia). destruct (before_some _ _ _ Bf Lt) as (u & Hu & I).
      rewrite One in I by lra. destruct I as [<-|[]]. reflexivity.
    - rewrite PositiveMap.gso in F' by exact D. apply (H k' sl' F').
  Qed.

  (* A claim that is no flip, and turns generators at t. *)
  Lemma turn_stand past s own t slack ks s1 c s' : (forall k, bracket_of k c = None) -> (forall g u v, turn_of c g = Some (u, v) -> u = t) -> (now s <= t)%Z ->
    good P past s -> all_orderly (c :: past) -> slots_stand past s -> ends_stand past -> each (turn_one P own t slack) ks s = Good s1 -> slots s' = slots s1 ->
    slots_stand (c :: past) s' /\ ends_stand (c :: past).
  Proof.
    intros Nb At N [Iv _] A Ss Es E S.
    assert (Names : forall k u, names_at P k (c :: past) u = names_at P k past u) by (intros k u; cbn [names_at]; rewrite Nb; reflexivity).
    assert (Same : forall u q, (forall g w v, turn_of c g = Some (w, v) -> u <= IZR w) -> stands_at P past u q -> stands_at P (c :: past) u q).
    { intros u q H. unfold stands_at. rewrite !(place_until past c _ u A) by (intros w v; apply H). tauto. }
    split.
    - assert (R : ready past t s).
      { intros k' sl' F'. pose proof (slots_true _ _ _ _ Iv k' sl' F') as T. split; [apply (Ss k' sl' F')|]. pose proof (not_ahead _ _ _ _ _ _ T).
        split; [lia|apply (one_name _ _ _ _ _ _ T)]. }
      intros k sl F q Bf. rewrite S in F. destruct (turns_stand past own t slack ks s s1 R E k sl F) as (St & Pr & _).
      destruct (St q) as [X|X]; [revert Bf; apply before_same; intros u _; apply Names|left; exact X|right].
      apply Same; [|exact X]. intros g w v Tw. apply At in Tw as ->. apply IZR_le, Pr.
    - intros d k lo hi q [<-|Id] Bd Bf; [rewrite Nb in Bd; discriminate|]. apply Same.
      + intros g w v Tw. destruct (all_orderly_tail c past A) as [C _]. apply IZR_le, (turns_after _ _ C g w v d k lo hi Tw Id Bd).
      + apply (Es d k lo hi q Id Bd). revert Bf. apply before_same. intros u _. apply Names.
  Qed.

  Lemma step_stand past s c s' : good P past s -> all_orderly (c :: past) -> slots_stand past s -> ends_stand past -> step P s c = Good s' ->
    slots_stand (c :: past) s' /\ ends_stand (c :: past).
  Proof.
    intros G A Ss Es E. destruct c as [t f lo hi k0 k1 k2 k3 k4|t i j wi wj ps b a k around|t g v ps around].
    - apply (flip_stand past s t f lo hi k0 k1 k2 k3 k4 s' G (proj1 (all_orderly_tail _ _ A)) Ss Es E).
    - set (c := Collision t i j wi wj ps b a k around) in *. cbn [step c] in E. unfold collide in E. fold c in E.
      apply need_good in E as [N E]. apply Z.leb_le in N. apply try_good in E as (sl & F & E). apply need_good in E as [_ E].
      apply try_good in E as (mi & _ & E). apply try_good in E as (mj & _ & E). apply need_good in E as [_ E]. apply need_good in E as [_ E].
      apply need_good in E as [_ E]. apply try_good in E as (s1 & E1 & E). apply try_good in E as (s2 & E2 & E). apply try_good in E as (s3 & E3 & E).
      injection E as <-. destruct (turn_movers _ _ _ _ E2) as (S2 & _). destruct (turn_movers _ _ _ _ E3) as (S3 & _).
      refine (turn_stand past s _ t _ _ s1 c _ (fun _ => eq_refl) _ N G A Ss Es E1 (eq_trans S3 S2)).
      intros g u v. unfold c. cbn [turn_of]. destruct (Pos.eqb g container); [discriminate|].
      destruct (Pos.eqb g i); [congruence|]. destruct (Pos.eqb g j); congruence.
    - set (c := Maneuver t g v ps around) in *. cbn [step c] in E. unfold manoeuvre in E. fold c in E.
      apply need_good in E as [N E]. apply Z.leb_le in N. apply try_good in E as ([m rest] & F & E). apply need_good in E as [_ E].
      apply need_good in E as [_ E]. apply try_good in E as (s1 & E1 & E). apply try_good in E as (s2 & E2 & E).
      injection E as <-. destruct (turn_movers _ _ _ _ E2) as (S2 & _).
      refine (turn_stand past s _ t _ _ s1 c _ (fun _ => eq_refl) _ N G A Ss Es E1 S2).
      intros h u w. unfold c. cbn [turn_of]. destruct (Pos.eqb h container); [discriminate|]. destruct (Pos.eqb h g); congruence.
  Qed.

  Lemma run_stand cs : forall past s n s' n', good P past s -> over past s -> all_orderly past -> slots_stand past s -> ends_stand past ->
    run P s cs n = (Good s', n') -> ends_stand (rev cs ++ past).
  Proof.
    induction cs as [|c cs IH]; cbn [rev run]; intros past s n s' n' G O A Ss Es E; [exact Es|].
    destruct (step P s c) as [s1|w] eqn:E1; [|discriminate]. destruct (step_sound P tolerance_nonneg past s c s1 G E1) as [_ G1].
    destruct (step_orderly past s c s1 G O E1) as [C O1].
    assert (A1 : all_orderly (c :: past)) by (intros [|d later] e earlier H; cbn [app] in H; injection H as H1 H2; subst; [exact C|apply (A later e earlier); reflexivity]).
    destruct (step_stand past s c s1 G A1 Ss Es E1) as [Ss1 Es1].
    rewrite <- app_assoc. apply (IH (c :: past) s1 (n + 1)%Z s' n'); assumption.
  Qed.

  Lemma first_stand : slots_stand [] (first_state P).
  Proof.
    intros k sl F q Bf. left. pose proof (slots_true _ _ _ _ (holds _ _ _ (first_good P)) k sl F) as T.
    assert (L : IZR (proved sl) - 1 < IZR (proved sl)) by lra. destruct (before_some _ _ _ Bf L) as (u & _ & I). cbn [names_at] in I.
    rewrite (named _ _ _ _ _ _ T) in I. destruct I as [<-|[]]. reflexivity.
  Qed.

  Lemma place_from past c g u w v : turn_of c g = Some (w, v) -> IZR w <= u -> place P (c :: past) u g = on_leg P g (last_leg P g (c :: past)) u.
  Proof. intros E H. unfold place. f_equal. cbn [leg_at]. rewrite E. destruct (Rle_dec (IZR w) u); [reflexivity|contradiction]. Qed.

  Lemma line_continuous g l : continuity (fun t => cx (on_leg P g l t)) /\ continuity (fun t => cy (on_leg P g l t)).
  Proof. split; apply derivable_continuous; unfold on_leg; cbn [cx cy]; reg. Qed.

  Lemma places_continuous past g : all_orderly past -> continuity (fun t => cx (place P past t g)) /\ continuity (fun t => cy (place P past t g)).
  Proof.
    induction past as [|c past IH]; intros A; [exact (line_continuous g (last_leg P g []))|]. destruct (all_orderly_tail c past A) as [_ A']. specialize (IH A').
    destruct IH as [X Y]. destruct (turn_of c g) as [[u v]|] eqn:E.
    - assert (Before : forall t, t <= IZR u -> place P (c :: past) t g = place P past t g)
        by (intros t Ht; apply place_until; [exact A|]; intros w z Ew; congruence).
      assert (After : forall t, IZR u <= t -> place P (c :: past) t g = on_leg P g (last_leg P g (c :: past)) t)
        by (intros t Ht; apply (place_from past c g t u v E Ht)).
      assert (Meet : place P past (IZR u) g = on_leg P g (last_leg P g (c :: past)) (IZR u))
        by (rewrite <- Before by lra; apply After; lra).
      split.
      + apply (glued (fun t => cx (place P past t g)) (fun t => cx (on_leg P g (last_leg P g (c :: past)) t)) _ (IZR u));
          [intros t Ht; rewrite Before by lra; reflexivity|intros t Ht; rewrite After by exact Ht; reflexivity|rewrite Meet; reflexivity|exact X|apply (line_continuous g)].
      + apply (glued (fun t => cy (place P past t g)) (fun t => cy (on_leg P g (last_leg P g (c :: past)) t)) _ (IZR u));
          [intros t Ht; rewrite Before by lra; reflexivity|intros t Ht; rewrite After by exact Ht; reflexivity|rewrite Meet; reflexivity|exact Y|apply (line_continuous g)].
    - unfold place in *. cbn [leg_at]. rewrite E. split; assumption.
  Qed.
End Run.

Section Tracked.
  Variable P : problem.
  Hypothesis tolerance_nonneg : (0 <= tolerance P)%Z.
  Variables (claims : list claim) (s : state) (n : Z).
  Hypothesis ran : run P (first_state P) claims 0 = (Good s, n).

  Lemma run_good : all_true P (rev claims) /\ all_orderly P (rev claims).
  Proof.
    rewrite <- (app_nil_r (rev claims)). split.
    - apply (run_sound P tolerance_nonneg claims [] (first_state P) 0%Z s n); [apply first_good| |exact ran]. intros later c earlier H.
      symmetry in H. apply app_eq_nil in H as [_ H]. discriminate.
    - apply (run_orderly P tolerance_nonneg claims [] (first_state P) 0%Z s n); [apply first_good|apply first_over| |exact ran]. intros later c earlier H.
      symmetry in H. apply app_eq_nil in H as [_ H]. discriminate.
  Qed.

  Theorem run_tracked : tracked P (rev claims).
  Proof.
    destruct run_good as [T O]. split.
    - intros later earlier t f lo hi k0 k1 k2 k3 k4 u q E. apply (own_is _ _ _ (O _ _ _ E) t f lo hi k0 k1 k2 k3 k4 u q eq_refl).
    - intros later earlier t f lo hi k0 k1 k2 k3 k4 E. split; [apply (T _ _ _ E)|apply (all_five _ _ _ (O _ _ _ E) t f lo hi k0 k1 k2 k3 k4 eq_refl)].
    - intros later earlier t f lo hi k0 k1 k2 k3 k4 E. destruct (T _ _ _ E) as (_ & _ & (Br & _) & _ & There & _). cbv zeta in There.
      assert (L : IZR lo <= IZR lo <= IZR hi) by (split; [lra|apply IZR_le; lia]). destruct (There (IZR lo) L) as [(o & V & _) (o' & V' & _)].
      apply vertex_differs in V as (V1 & V2 & V3), V' as (V4 & V5 & V6). repeat split; intros X; rewrite X in *; tauto.
    - intros later earlier t f lo hi k0 k1 k2 k3 k4 E. destruct (T _ _ _ E) as (_ & _ & (Br & _) & _). lia.
    - intros later middle earlier c c' k lo hi lo' hi' E Ow B B'. apply (no_overlap _ _ _ (O _ _ _ E) c k lo hi lo' hi'); try assumption.
      apply in_or_app. right. left. reflexivity.
    - intros later c earlier k lo hi u q E. apply (takes_name _ _ _ (O _ _ _ E)).
  Qed.

  (* After a flip of one instant comes no flip of that edge, or beside it, whose bracket begins before. *)
  Theorem run_instants : forall later middle earlier c c' k t lo' hi', rev claims = later ++ c' :: middle ++ c :: earlier ->
    bracket_of k c = Some (t, t) -> bracket_of k c' = Some (lo', hi') -> (t <= lo')%Z.
  Proof.
    intros later middle earlier c c' k t lo' hi' E B B'. destruct run_good as [_ O]. apply (instants_over _ _ _ (O _ _ _ E) c k t lo' hi'); try assumption.
    apply in_or_app. right. left. reflexivity.
  Qed.

  (* When the bracket of a flip of an edge or of one beside it ends, the edge still stands by each name that it had just before. *)
  Theorem run_stands_closed : forall c k lo hi q, In c (rev claims) -> bracket_of k c = Some (lo, hi) -> (0 < hi < horizon P)%Z ->
    before (IZR hi) (fun u => In q (names_at P k (rev claims) u)) ->
    let t := IZR hi in stands (place P (rev claims) t (el q)) (place P (rev claims) t (er q)) (place P (rev claims) t (es q)) (place P (rev claims) t (ee q)).
  Proof.
    intros c k lo hi q I B _ Bf. cut (ends_stand P (rev claims)); [intros H; apply (H c k lo hi q I B Bf)|]. rewrite <- (app_nil_r (rev claims)).
    apply (run_stand P tolerance_nonneg claims [] (first_state P) 0%Z s n); [apply first_good|apply first_over| |apply first_stand|intros d ? ? ? ? []|exact ran].
    intros later d earlier H. symmetry in H. apply app_eq_nil in H as [_ H]. discriminate.
  Qed.

  (* Every path is continuous. *)
  Theorem paths_continuous g : continuity (fun t => cx (place P (rev claims) t g)) /\ continuity (fun t => cy (place P (rev claims) t g)).
  Proof. apply places_continuous, run_good. Qed.

  (* Over the bracket of a flip its four are on the lines that they were on before. *)
  Theorem flip_lines later earlier t f lo hi k0 k1 k2 k3 k4 g u : rev claims = later ++ Flip t f lo hi k0 k1 k2 k3 k4 :: earlier ->
    In g [el f; er f; es f; ee f] -> IZR lo <= u <= IZR hi -> place P (rev claims) u g = on_leg P g (last_leg P g earlier) u.
  Proof.
    intros E G Hu. destruct run_good as [T O]. destruct (T _ _ _ E) as (_ & _ & _ & Begun & _). specialize (Begun g G). apply IZR_le in Begun.
    rewrite E in O |- *. clear E T. set (c := Flip t f lo hi k0 k1 k2 k3 k4) in *. induction later as [|d later IH]; cbn [app] in *.
    - rewrite place_until by (try exact O; intros; discriminate). apply place_on_leg. lra.
    - destruct (all_orderly_tail P d _ O) as [D O']. rewrite <- (IH O'). apply place_until; [exact O|]. intros w v Ew.
      assert (hi <= w)%Z as W.
      { apply (turns_after _ _ _ D g w v c k0 lo hi Ew); [apply in_or_app; right; left; reflexivity|]. unfold c. cbn [bracket_of]. rewrite Pos.eqb_refl. reflexivity. }
      apply IZR_le in W. lra.
  Qed.
End Tracked.
