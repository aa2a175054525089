(* A whole run of the checker: every claim is true, and what was proved covers all times up to the horizon. *)
From Coq Require Import ZArith List Bool Reals Lra Lia FMapPositive.
From Voroproof Require Import Geometry Piece History Replay LifeSound ClaimSound Invariant ReplaySound.
Import ListNotations.
Open Scope R_scope.

Section Step.
Variable P : problem.
Hypothesis tolerance_nonneg : (0 <= tolerance P)%Z.

Record good (past : list claim) (s : state) : Prop := {
  holds : invariant P past past s;
  awaited : pending P past = Some (todo s)
}.

Lemma is_pair_true i j q : is_pair i j q = true -> (el q = i /\ er q = j) \/ (el q = j /\ er q = i).
Proof.
  unfold is_pair. intros H. apply orb_prop in H as [H|H]; apply andb_prop in H as [H1 H2]; apply Pos.eqb_eq in H1, H2; tauto.
Qed.

Lemma flip_sound past s t f lo hi k k1 k2 k3 k4 s' (c := Flip t f lo hi k k1 k2 k3 k4) :
  good past s -> step P s c = Good s' -> claim_true P past c /\ good (c :: past) s'.
Proof.
  intros [I W] E. cbn [step c] in E. unfold flip in E.
  apply try_good in E as (sl & F & E). apply known_good in F. apply need_good in E as [Name E]. apply need_good in E as [B E].
  repeat (apply andb_prop in B as [B ?]). apply Z.leb_le in B, H, H1, H2. apply Z.ltb_lt in H0.
  apply need_good in E as [Ds E]. apply andb_prop in Ds as [Ds Other]. apply try_good in E as (gone & C & E). apply need_good in E as [-> E].
  apply try_good in E as (s1 & E1 & E). injection E as <-.
  destruct (collapses_true P past s f lo hi (movers_known _ _ _ _ I) H2 C) as (C1 & C2 & C3 & C4 & C5). split.
  - unfold c. cbn [claim_true]. split.
    + rewrite (named _ _ _ _ _ _ (slots_true _ _ _ _ I k sl F)).
      apply orb_prop in Name as [Name|Name]; apply edge_eqb_true in Name; rewrite Name; tauto.
    + split; [apply distinct_true, Ds|]. split; [lia|]. split; [exact C1|]. split; [exact C2|]. split; [exact C3|]. split; [exact C4|exact C5].
  - destruct (flip_keeps P past s t f lo hi k k1 k2 k3 k4 s1 (if lo =? hi then hi + 1 else hi)%Z H2 ltac:(destruct (lo =? hi)%Z; lia) Ds I E1) as [I1 T]. split.
    + destruct I1 as [K S A]. split; assumption.
    + cbn [pending c todo]. rewrite T. exact W.
Qed.

Lemma collision_sound past s t i j wi wj ps b a k around s' (c := Collision t i j wi wj ps b a k around) :
  good past s -> step P s c = Good s' -> claim_true P past c /\ good (c :: past) s'.
Proof.
  intros [I W] E. cbn [step c] in E. unfold collide in E. fold c in E.
  apply need_good in E as [N E]. apply Z.leb_le in N. apply try_good in E as (sl & F & E). apply known_good in F.
  apply need_good in E as [Pair E]. apply andb_prop in Pair as [Pair Disk]. apply andb_prop in Pair as [Pair D].
  apply negb_true_iff, Pos.eqb_neq in D, Disk.
  apply try_good in E as (mi & Fi & E). apply try_good in E as (mj & Fj & E). apply known_good in Fi, Fj.
  apply need_good in E as [T E]. apply need_good in E as [L E]. apply need_good in E as [Ps E].
  apply try_good in E as (s1 & E1 & E). apply try_good in E as (s2 & E2 & E). apply try_good in E as (s3 & E3 & E). injection E as <-.
  pose proof (mover_known P past s i mi (movers_known _ _ _ _ I) Fi) as Mi.
  pose proof (mover_known P past s j mj (movers_known _ _ _ _ I) Fj) as Mj. rewrite Mi, Mj in T, L. split.
  - unfold c. cbn [claim_true]. split; [exact Disk|]. split; [|split; [|split]].
    + exists (name sl). split; [apply (named _ _ _ _ _ _ (slots_true _ _ _ _ I k sl F))|apply is_pair_true, Pair].
    + apply (touch_true P past i j t b a T).
    + apply (law_true P past i j t wi wj L).
    + apply (centres_true P past s); [apply (movers_known _ _ _ _ I)|exact Ps].
  - set (slack := if (0 <=? gap_at i j mi mj t)%Z then 0%Z else tolerance P) in E1.
    assert (Slack : (0 <= slack)%Z) by (unfold slack; destruct (0 <=? gap_at i j mi mj t)%Z; lia).
    destruct (turning P tolerance_nonneg c past s (is_pair i j) t slack around s1 s2 s3 i j) as [I1 T1]; try assumption; try reflexivity.
    + intros g. unfold c. cbn [turn_of]. destruct (Pos.eqb g container); [congruence|].
      destruct (Pos.eqb g i) eqn:Ei; [apply Pos.eqb_eq in Ei; tauto|]. destruct (Pos.eqb g j) eqn:Ej; [apply Pos.eqb_eq in Ej; tauto|congruence].
    + intros g u v. unfold c. cbn [turn_of]. destruct (Pos.eqb g container); [discriminate|].
      destruct (Pos.eqb g i); [congruence|]. destruct (Pos.eqb g j); congruence.
    + intros q u Q Hu.
      assert (Near : near_collision P (c :: past) i j u).
      { exists [], past, t, wi, wj, ps, b, a, k, around. split; [reflexivity|]. apply IZR_le in tolerance_nonneg as TN.
        unfold slack in Hu. destruct (0 <=? gap_at i j mi mj t)%Z eqn:Gap.
        - split; [apply Rabs_le; lra|left; lra].
        - split; [apply Rabs_le; lra|right]. apply Z.leb_gt in Gap. rewrite Mi, Mj in Gap. apply (overlap_true P past i j t b a T Gap). }
      destruct (is_pair_true i j q Q) as [[E4 E5]|[E4 E5]]; [left|right]; rewrite E4, E5; exact Near.
    + split; [exact I1|]. cbn [pending c]. change (todo (at_time s3 t)) with (todo s3). rewrite T1. exact W.
Qed.

Lemma maneuver_sound past s t g v ps around s' (c := Maneuver t g v ps around) :
  good past s -> step P s c = Good s' -> claim_true P past c /\ good (c :: past) s'.
Proof.
  intros [I W] E. cbn [step c] in E. unfold manoeuvre in E. fold c in E.
  apply need_good in E as [N E]. apply Z.leb_le in N.
  apply try_good in E as ([m rest] & F & E). apply known_good in F. apply need_good in E as [B E].
  apply need_good in E as [Ps E].
  apply andb_prop in B as [B L]. apply andb_prop in B as [B H]. apply Z.leb_le in B, H.
  apply try_good in E as (s1 & E1 & E). apply try_good in E as (s2 & E2 & E). injection E as <-. split.
  - unfold c. cbn [claim_true]. split; [|apply (centres_true P past s); [apply (movers_known _ _ _ _ I)|exact Ps]].
    exists (todo s), m, rest. split; [exact W|]. split; [exact F|]. split; [exact B|].
    split; [exact H|]. apply within_law_true, L.
  - set (h := if Pos.eqb g 1 then 2%positive else 1%positive).
    assert (D : g <> h) by (unfold h; destruct (Pos.eqb g 1) eqn:E; [apply Pos.eqb_eq in E|apply Pos.eqb_neq in E]; congruence).
    assert (None_ : turn_of c h = None).
    { unfold c. cbn [turn_of]. destruct (Pos.eqb h container); [reflexivity|]. destruct (Pos.eqb h g) eqn:E; [|reflexivity].
      apply Pos.eqb_eq in E. congruence. }
    destruct (turning P tolerance_nonneg c past s (fun _ => false) t 0 around s1 s2 s2 g h) as [I1 T1]; try assumption; try reflexivity; try apply Z.le_refl.
    + intros g'. unfold c. cbn [turn_of]. destruct (Pos.eqb g' container); [congruence|].
      destruct (Pos.eqb g' g) eqn:Ei; [apply Pos.eqb_eq in Ei; tauto|congruence].
    + intros g' u w. unfold c. cbn [turn_of]. destruct (Pos.eqb g' container); [discriminate|]. destruct (Pos.eqb g' g); congruence.
    + discriminate.
    + unfold turn. rewrite None_. reflexivity.
    + split; [destruct I1 as [K S A]; split; assumption|]. cbn [pending c todo]. rewrite W. cbn [bind]. rewrite F. reflexivity.
Qed.

Theorem step_sound past s c s' : good past s -> step P s c = Good s' -> claim_true P past c /\ good (c :: past) s'.
Proof. destruct c; [apply flip_sound|apply collision_sound|apply maneuver_sound]. Qed.

Definition all_true (past : list claim) : Prop := forall later c earlier, past = later ++ c :: earlier -> claim_true P earlier c.

Lemma run_sound cs : forall past s n s' n', good past s -> all_true past -> run P s cs n = (Good s', n') ->
  good (rev cs ++ past) s' /\ all_true (rev cs ++ past).
Proof.
  induction cs as [|c cs IH]; simpl; intros past s n s' n' G T E; [injection E as <- _; split; assumption|].
  destruct (step P s c) as [s1|w] eqn:E1; [|discriminate].
  destruct (step_sound past s c s1 G E1) as [C G1]. rewrite <- app_assoc. apply (IH (c :: past) s1 (n + 1)%Z s' n'); [exact G1| |exact E].
  intros [|d later] e earlier H; simpl in H; injection H as H1 H2; subst; [exact C|]. apply (T later e earlier). reflexivity.
Qed.

Lemma first_good : good [] (first_state P).
Proof.
  split; [|reflexivity]. split.
  - intros g m. unfold first_state, PositiveMap.map; cbn [movers]. rewrite PositiveMap.gmapi. unfold last_leg, radius_of.
    destruct (PositiveMap.find g (bodies P)); [|discriminate]. intros H. injection H as <-. split; reflexivity.
  - intros k sl. unfold first_state, PositiveMap.map; cbn [slots now]. rewrite PositiveMap.gmapi. intros H.
    assert (exists q, PositiveMap.find k (edges P) = Some q /\ sl = Slot q 0 0 0 []) as (q & F & ->).
    { destruct (PositiveMap.find k (edges P)) as [q|]; [|discriminate]. exists q. injection H as <-. split; reflexivity. }
    split; cbn [name opened proved pair_proved others]; try lia; try (intros; lra); try congruence.
    + exact F.
    + intros t _. exact F.
    + intros t _. cbn [names_at last_edge]. rewrite F. reflexivity.
  - intros k. unfold first_state, PositiveMap.map; cbn [slots]. rewrite PositiveMap.gmapi.
    destruct (PositiveMap.find k (edges P)); [discriminate|reflexivity].
Qed.

Lemma finish_good s ks : finish P s ks = Good tt -> forall k sl, In (k, sl) ks -> settle s sl (horizon P) (horizon P) = Good tt.
Proof.
  induction ks as [|[k sl] ks IH]; simpl; intros E k' sl' I; [contradiction|].
  apply try_good in E as (u & S & E). destruct u. destruct I as [I|I]; [injection I as <- <-; exact S|apply (IH E k' sl' I)].
Qed.

Lemma no_names k past t : PositiveMap.find k (edges P) = None -> names_at P k past t = [].
Proof.
  intros N. induction past as [|c past IH]; cbn [names_at last_edge]; [rewrite N; reflexivity|]. rewrite IH.
  destruct (bracket_of k c) as [[lo hi]|]; [|reflexivity]. destruct (Rle_dec (IZR hi) t); [reflexivity|]. destruct (Rle_dec (IZR lo) t); reflexivity.
Qed.

Lemma no_edge k past : PositiveMap.find k (edges P) = None -> last_edge P k past = None /\ forall t, edge_at P k past t = None.
Proof.
  intros N. induction past as [|c past [IH1 IH2]]; [split; [exact N|intros t; exact N]|].
  assert (L : last_edge P k (c :: past) = None) by (cbn [last_edge]; rewrite IH1; reflexivity).
  split; [exact L|]. intros t. cbn [edge_at]. destruct (bracket_of k c) as [[lo hi]|]; [|apply IH2].
  destruct (Rle_dec (IZR hi) t); [exact L|apply IH2].
Qed.

Lemma edge_stays k past : last_edge P k past <> None -> forall t, edge_at P k past t <> None.
Proof.
  intros L t. induction past as [|c past IH]; [exact L|].
  assert (L1 : last_edge P k past <> None) by (intros E; apply L; cbn [last_edge]; rewrite E; reflexivity).
  cbn [edge_at]. destruct (bracket_of k c) as [[lo hi]|]; [|apply IH, L1].
  destruct (Rle_dec (IZR hi) t); [exact L|apply IH, L1].
Qed.

Theorem ending_sound past s : good past s -> all_true past -> ending P s = Good tt -> true_history P past.
Proof.
  intros [[K T A] W] C E. unfold ending in E. apply need_good in E as [M E]. apply need_good in E as [_ E]. split.
  - exact C.
  - exists (todo s). split; [exact W|]. intros m Hm. rewrite forallb_forall in M. apply Z.ltb_lt, M, Hm.
  - intros k t N. apply edge_stays. destruct (PositiveMap.find k (slots s)) as [sl|] eqn:F.
    + rewrite (named _ _ _ _ _ _ (T k sl F)). discriminate.
    + apply A in F. congruence.
  - intros k q t Ht Eq Nb.
    destruct (PositiveMap.find k (slots s)) as [sl|] eqn:F.
    2: { apply A in F. destruct (no_edge k past F) as [_ N]. rewrite N in Eq. discriminate. }
    pose proof (finish_good s _ E k sl (PositiveMap.elements_correct _ _ F)) as S. pose proof (T k sl F) as St.
    destruct (settled P past s sl _ _ K S) as [HL _]. cut (legal_at P past t q); [intros (L1 & L2 & _); split; assumption|].
    destruct (Rlt_or_le t (IZR (proved sl))) as [Hl|Hl]; [apply (proved_legal _ _ _ _ _ _ St); try assumption; lra|].
    rewrite (stays _ _ _ _ _ _ St) in Eq by exact Hl. injection Eq as <-. apply HL. lra.
  - intros k q t Ht I Nf.
    destruct (PositiveMap.find k (slots s)) as [sl|] eqn:F.
    2: { apply A in F. rewrite no_names in I by exact F. contradiction. }
    pose proof (finish_good s _ E k sl (PositiveMap.elements_correct _ _ F)) as S. pose proof (T k sl F) as St.
    destruct (settled P past s sl _ _ K S) as [HL _]. change (lasts_at P past t q).
    destruct (Rlt_or_le t (IZR (proved sl))) as [Hl|Hl].
    + destruct (proved_lasts _ _ _ _ _ _ St q t) as [_ [H|H]]; try assumption; [lra|contradiction].
    + rewrite (one_name _ _ _ _ _ _ St) in I by exact Hl. destruct I as [<-|[]]. apply (legal_lasts P past _ _ _ HL). lra.
  - intros k q t Ht I.
    destruct (PositiveMap.find k (slots s)) as [sl|] eqn:F.
    2: { apply A in F. rewrite no_names in I by exact F. contradiction. }
    pose proof (finish_good s _ E k sl (PositiveMap.elements_correct _ _ F)) as S. pose proof (T k sl F) as St.
    destruct (settled P past s sl _ _ K S) as [HL _]. change (stands_at P past t q).
    destruct (Rlt_or_le t (IZR (proved sl))) as [Hl|Hl].
    + apply (proved_lasts _ _ _ _ _ _ St q t); try assumption; lra.
    + rewrite (one_name _ _ _ _ _ _ St) in I by exact Hl. destruct I as [<-|[]]. apply HL. lra.
  - intros k q t Ht I.
    destruct (PositiveMap.find k (slots s)) as [sl|] eqn:F.
    2: { apply A in F. rewrite no_names in I by exact F. contradiction. }
    pose proof (finish_good s _ E k sl (PositiveMap.elements_correct _ _ F)) as S. pose proof (T k sl F) as St.
    destruct (settled P past s sl _ _ K S) as [_ HP].
    pose proof (not_ahead _ _ _ _ _ _ St) as A0. pose proof (pair_ahead _ _ _ _ _ _ St) as B0. apply IZR_le in A0, B0.
    destruct (Rlt_or_le t (IZR (pair_proved sl))) as [Hl|Hl].
    + destruct (Rlt_or_le t (IZR (now s))) as [Hn|Hn].
      * destruct (proved_apart _ _ _ _ _ _ St q t ltac:(lra) Hn I) as [H|H]; [left; exact H|right; exact H].
      * rewrite (one_name _ _ _ _ _ _ St) in I by lra. destruct I as [<-|[]]. right. apply (proved_near _ _ _ _ _ _ St). lra.
    + rewrite (one_name _ _ _ _ _ _ St) in I by lra. destruct I as [<-|[]]. left. apply HP. lra.
Qed.
End Step.
