(* At every instant one of the diagrams that the claims allow is the Voronoi diagram. *)
From Coq Require Import ZArith List Bool Reals Lra Lia FMapPositive ClassicalDedekindReals.
From Voroproof Require Import Geometry Vertex Scale History Arc Cyclic Cover Spread Envelope Near Link Corners Local TwoWays Closed Topology March.
Import ListNotations.
Open Scope R_scope.

(* What the axioms of the reals decide. *)
Lemma right_dec g h : {right_pair g h} + {~ right_pair g h}.
Proof. unfold right_pair. destruct (wall g || wall h); apply Rlt_dec. Qed.

Lemma vertex_dec l j k : {vertex l j k} + {~ vertex l j k}.
Proof.
  unfold vertex. destruct (bool_dec (wall l) false); [|right; tauto]. destruct (right_dec l j); [|right; tauto]. destruct (right_dec l k); [|right; tauto].
  destruct (right_dec j k); [|right; tauto]. destruct (bool_dec (wall j && wall k) false); [|right; tauto].
  destruct (Rlt_dec 0 (level l j k)); [left; tauto|right; tauto].
Qed.

Lemma voronoi_dec gens cfg D : {voronoi gens cfg D} + {~ voronoi gens cfg D}.
Proof.
  destruct (sig_not_dec (voronoi gens cfg D)) as [N|N]; [left|right; exact N]. constructor.
  - intros g h Ig Ih X. destruct (right_dec (cfg g) (cfg h)) as [H|H]; [exact H|]. exfalso. apply N. intros V. apply H, (all_right _ _ _ V); assumption.
  - intros q O. assert (Dec : forall A B, {A} + {~ A} -> {B} + {~ B} -> ~ ~ (A /\ B) -> A /\ B) by (intros A B [a|a] [b|b] H; try (split; assumption); exfalso; apply H; tauto).
    apply Dec; try apply vertex_dec. intros H. apply N. intros V. apply H, (all_there _ _ _ V q O).
  - intros q u g O U A Ig Nl Nr. apply Rnot_lt_le. intros L. apply N. intros V. pose proof (envelope _ _ _ V q u g O U A Ig Nl Nr). lra.
Qed.

(* What is said of an edge. *)
Definition is (say : generator -> generator -> generator -> generator -> Prop) (cfg : gen -> generator) (q : edge) : Prop :=
  say (cfg (el q)) (cfg (er q)) (cfg (es q)) (cfg (ee q)).

Lemma circles_back say cfg q : is (circles say) cfg q -> is (circles say) cfg (reversed q).
Proof. apply circles_reversed. Qed.
Lemma pinched_back cfg q : is pinched cfg q -> is pinched cfg (reversed q).
Proof. apply pinched_turn. Qed.
Lemma stands_back cfg q : is stands cfg q -> is stands cfg (reversed q).
Proof.
  unfold is, stands, there. cbn [reversed el er es ee]. intros (T & R1 & R2 & R3 & R4 & R5). split; [apply circles_reversed, T|].
  apply right_swap in R1. tauto.
Qed.

Section Still.
  Variable cfg : gen -> generator.
  Hypothesis W : forall g, wall (cfg g) = Pos.eqb g container.
  Hypothesis Pr : forall g, proper (cfg g).

  (* An edge that stands has its vertices, seen from a disk. *)
  Lemma stands_both q : is stands cfg q -> wall (cfg (el q)) = false -> both_there cfg q.
  Proof.
    intros (T & R1 & R2 & R3 & R4 & R5) D. destruct T as [(c & C & _) (c' & C' & _)]. split.
    - apply (vertex_of_circle c); try assumption; try apply Pr; [|apply right_swap, R4].
      apply TwoWays.one_wall; [exact W|]. apply (circle_apart cfg) in C. tauto.
    - apply (vertex_of_circle c'); try assumption; try apply Pr. apply TwoWays.one_wall; [exact W|]. apply (circle_apart cfg) in C'. tauto.
  Qed.

  Lemma stands_apart q : is stands cfg q -> el q <> er q.
  Proof. intros (_ & R & _) E. apply right_irreflexive in R. rewrite E in R. auto. Qed.

  Lemma stands_way q : is stands cfg q -> both_there cfg q \/ both_there cfg (reversed q).
  Proof.
    intros S. destruct (TwoWays.a_disk cfg W (el q) (er q) (stands_apart q S)) as [D|D]; [left; apply stands_both; assumption|right].
    apply stands_both; [apply stands_back, S|exact D].
  Qed.

  Lemma both_pinched q : both_there cfg q -> is pinched cfg q \/ ~ is pinched cfg q.
  Proof.
    intros [S E]. destruct (same_or_not (start_of cfg q) (end_of cfg q)) as [H|H]; [left|right].
    - apply no_length_link; try apply Pr; assumption.
    - intros H'. apply H. apply no_length_link; try apply Pr; assumption.
  Qed.

  Lemma back_back q : reversed (reversed q) = q.
  Proof. destruct q; reflexivity. Qed.

  Lemma pinched_or_not q : is stands cfg q -> is pinched cfg q \/ ~ is pinched cfg q.
  Proof.
    intros S. destruct (stands_way q S) as [B|B]; apply both_pinched in B; [exact B|].
    destruct B as [B|B]; [left|right]; [rewrite <- (back_back q)|intros H; apply B]; apply pinched_back; assumption.
  Qed.

  Lemma both_legal q : both_there cfg q -> is legal cfg q \/ ~ is legal cfg q.
  Proof.
    intros [S E]. assert (L := legal_link _ _ _ _ (Pr (el q)) (Pr (er q)) (Pr (es q)) (Pr (ee q)) S E). unfold is. rewrite L.
    match goal with |- (?a <= ?b /\ ?c <= ?d) \/ _ => destruct (Rle_dec a b), (Rle_dec c d); tauto end.
  Qed.

  Lemma legal_or_not q : is stands cfg q -> is legal cfg q \/ ~ is legal cfg q.
  Proof.
    intros S. destruct (stands_way q S) as [B|B]; apply both_legal in B; [exact B|].
    destruct B as [B|B]; [left|right]; [rewrite <- (back_back q)|intros H; apply B]; apply circles_back; assumption.
  Qed.

  (* An edge whose vertices have one circle is not not cotangent. *)
  Lemma pinched_cotangent q : is stands cfg q -> is pinched cfg q -> ~ is not_cotangent cfg q.
  Proof.
    intros S H. assert (X : forall p, both_there cfg p -> is pinched cfg p -> ~ is not_cotangent cfg p).
    { intros p [A B] Z. apply no_length_other; try apply Pr; try assumption. apply no_length_link; try apply Pr; assumption. }
    destruct (stands_way q S) as [B|B]; [apply X; assumption|]. intros N. apply (X _ B); [apply pinched_back, H|].
    unfold is, not_cotangent in *. cbn [reversed el er es ee]. destruct N as [(c & C & T)|(c & C & T)].
    - right. exists c. split; [|exact T]. do 2 apply vertex_turn; exact C.
    - left. exists c. split; [|exact T]. apply vertex_turn; exact C.
  Qed.

  Variable gens : list gen.

  (* In a Voronoi diagram no circle of an edge is entered. *)
  Lemma not_entered_way D q : voronoi gens cfg D -> oriented cfg D q -> In (ee q) gens -> In (el q) gens -> ~ is entered cfg q.
  Proof.
    intros V O Ie Il [(c & C & N) _]. apply N. destruct (all_there _ _ _ V q O) as [S E].
    destruct (vertex_dir _ _ _ S) as (U & Eq & _). destruct (vertex_dir _ _ _ E) as (_ & _ & Sl).
    assert (Ne : ee q <> el q). { destruct E as (_ & _ & R & _). intros H. apply right_irreflexive in R. rewrite H in R. auto. }
    assert (Nr : ee q <> er q). { destruct E as (_ & _ & _ & R & _). intros H. apply right_irreflexive in R. rewrite H in R. auto. }
    apply (circle_and_other c _ _ _ (cfg (ee q)) (Pr _) (Pr _) (Pr _) (Pr _) S C).
    - apply (all_right _ _ _ V); auto.
    - pose proof (envelope _ _ _ V q (start_of cfg q) (ee q) O U (Closed.start_on_arc _ _) Ie Ne Nr) as H. unfold K_at, start_of, level in *. rewrite <- Eq. exact H.
  Qed.

  Lemma not_entered D q : voronoi gens cfg D -> In q D \/ In (reversed q) D -> el q <> er q ->
    (forall g, In g [el q; er q; es q; ee q] -> In g gens) -> ~ is entered cfg q.
  Proof.
    intros V I N G. cbn [In] in G. destruct (TwoWays.a_disk cfg W (el q) (er q) N) as [D0|D0].
    - apply (not_entered_way D); try (apply G; tauto); [exact V|split; assumption].
    - intros E. apply circles_back in E. revert E. apply (not_entered_way D); try (destruct q; apply G; cbn; tauto); [exact V|].
      split; [rewrite back_back; tauto|destruct q; exact D0].
  Qed.

  (* How a flip of f, in either direction, may change an edge. *)
  Definition five_of (f q : edge) : Prop := q = f \/ q = reversed f \/ q = turned_over f \/ q = reversed (turned_over f).
  Definition moved (f q q' : edge) : Prop := q' = q \/ five_of f q' \/
    exists a b c d, beside a b c d q = Some q' /\ In (a, b, c, d) [(el f, es f, er f, ee f); (es f, er f, el f, ee f); (er f, ee f, el f, es f); (ee f, el f, er f, es f);
      (el f, es f, ee f, er f); (es f, er f, ee f, el f); (er f, ee f, es f, el f); (ee f, el f, es f, er f)].

  Lemma change_voronoi f D D' : (forall g, In g [el f; er f; es f; ee f] -> In g gens) -> is pinched cfg f -> voronoi gens cfg D ->
    (exists q, In q D /\ five_of f q) -> (forall q', In q' D' -> exists q, In q D /\ moved f q q') -> voronoi gens cfg D'.
  Proof.
    intros G (z & Z) V (q & Iq & Fq) Back. pose proof (all_right _ _ _ V) as Right. destruct f as [l r s e]. unfold is in *. cbn [el er es ee In] in *.
    assert (Il : In l gens) by (apply G; tauto). assert (Ir : In r gens) by (apply G; tauto). assert (Is : In s gens) by (apply G; tauto). assert (Ie : In e gens) by (apply G; tauto). clear G.
    assert (Pg : forall g, In g gens -> proper (cfg g)) by auto.
    pose proof (one_circle_after gens cfg W Pg Right l r s e Il Ir Is Ie z Z) as [Zs Ze]. destruct Z as [Zl Zr].
    assert (T : forall a b c, vertex_circle z (cfg a) (cfg b) (cfg c) -> vertex_circle z (cfg b) (cfg c) (cfg a)) by (intros; apply vertex_turn; assumption).
    assert (Empty : forall g, In g gens -> empty_of z (cfg g)).
    { pose proof (voronoi_good gens cfg D q V Iq) as [A B].
      assert (X : vertex_circle z (cfg (el q)) (cfg (es q)) (cfg (er q)) /\ vertex_circle z (cfg (el q)) (cfg (er q)) (cfg (ee q)) /\
        In (el q) gens /\ In (er q) gens /\ In (es q) gens /\ In (ee q) gens).
      { destruct Fq as [->|[->|[->| ->]]]; cbn [turned_over reversed el er es ee]; (split; [|split; [|repeat split; assumption]]); auto 7. }
      destruct X as (X1 & X2 & X3 & X4 & X5 & X6).
      assert (N : el q <> er q) by (apply (circle_apart cfg) in X1; tauto). destruct (TwoWays.a_disk cfg W (el q) (er q) N) as [D0|D0].
      - apply (good_empty gens cfg Pg Right z q); auto.
      - apply (good_empty gens cfg Pg Right z (reversed q)); auto. }
    apply good_voronoi; [exact Right|]. intros q' I'. destruct (Back q' I') as (p & Ip & [->|[F|(a & b & c & d & B & I)]]).
    - apply (voronoi_good _ _ _ _ V Ip).
    - destruct F as [->|[->|[->| ->]]]; split; cbn [turned_over reversed el er es ee]; intros D0; apply (good_point gens cfg W Pg Right z); try assumption; split; auto.
    - pose proof (voronoi_good _ _ _ _ V Ip) as Gp. cbn [In] in I.
      repeat destruct I as [I|I]; try contradiction; injection I as <- <- <- <-; revert B Gp; apply (beside_good gens cfg W Pg Right z); auto.
  Qed.
End Still.

(* The brackets of a claim. *)
Lemma bracket_same c : (forall k, bracket_of k c = None) \/
  exists k lo hi, bracket_of k c = Some (lo, hi) /\ forall m l h, bracket_of m c = Some (l, h) -> l = lo /\ h = hi.
Proof.
  destruct c as [t f lo hi k0 k1 k2 k3 k4| |]; try (left; reflexivity). right. exists k0, lo, hi. cbn [bracket_of]. rewrite Pos.eqb_refl. split; [reflexivity|].
  intros m l h. destruct (_ || _); [|discriminate]. intros E. injection E as <- <-. split; reflexivity.
Qed.

(* The claim may be not yet done at t, or may be done; and so just before t. *)
Definition late (t : R) (c : claim) : Prop := forall k lo hi, bracket_of k c = Some (lo, hi) -> t < IZR hi.
Definition soon (t : R) (c : claim) : Prop := forall k lo hi, bracket_of k c = Some (lo, hi) -> IZR lo <= t.
Definition late_before (t : R) (c : claim) : Prop := forall k lo hi, bracket_of k c = Some (lo, hi) -> t <= IZR hi.
Definition soon_before (t : R) (c : claim) : Prop := forall k lo hi, bracket_of k c = Some (lo, hi) -> IZR lo < t.

Lemma after_numbers t l h : after t (fun u => (u < h <-> t < h) /\ (l <= u <-> l <= t)).
Proof.
  apply after_and.
  - destruct (Rlt_dec t h); [exists (h - t)|exists 1]; (split; [lra|]); intros u U; split; lra.
  - destruct (Rle_dec l t); [exists 1|exists (l - t)]; (split; [lra|]); intros u U; split; lra.
Qed.

Lemma before_numbers t l h : before t (fun u => (u < h <-> t <= h) /\ (l <= u <-> l < t)).
Proof.
  apply before_and.
  - destruct (Rle_dec t h); [exists 1|exists (t - h)]; (split; [lra|]); intros u U; split; lra.
  - destruct (Rlt_dec l t); [exists (t - l)|exists 1]; (split; [lra|]); intros u U; split; lra.
Qed.

Lemma after_claim t c : after t (fun u => (late u c <-> late t c) /\ (soon u c <-> soon t c)).
Proof.
  destruct (bracket_same c) as [N|(k & lo & hi & B & S)].
  - exists 1. split; [lra|]. intros u _. unfold late, soon. split; split; intros H k lo hi B; rewrite N in B; discriminate.
  - apply (after_impl t) with (2 := after_numbers t (IZR lo) (IZR hi)). intros u [X Y]. unfold late, soon. split; split; intros H m l h E; pose proof (H k lo hi B) as Z;
      destruct (S m l h E) as [-> ->]; tauto.
Qed.

Lemma before_claim t c : before t (fun u => (late u c <-> late_before t c) /\ (soon u c <-> soon_before t c)).
Proof.
  destruct (bracket_same c) as [N|(k & lo & hi & B & S)].
  - exists 1. split; [lra|]. intros u _. unfold late, soon, late_before, soon_before. split; split; intros H k lo hi B; rewrite N in B; discriminate.
  - apply (before_impl t) with (2 := before_numbers t (IZR lo) (IZR hi)). intros u [X Y]. unfold late, soon, late_before, soon_before.
    split; split; intros H m l h E; pose proof (H k lo hi B) as Z; destruct (S m l h E) as [-> ->]; tauto.
Qed.

Lemma late_or_not t c : late t c \/ ~ late t c.
Proof.
  destruct (bracket_same c) as [N|(k & lo & hi & B & S)]; [left; intros k lo hi B; rewrite N in B; discriminate|].
  destruct (Rlt_dec t (IZR hi)) as [L|L]; [left|right].
  - intros m l h E. destruct (S m l h E) as [_ ->]. exact L.
  - intros H. exact (L (H k lo hi B)).
Qed.

Lemma soon_or_not t c : soon t c \/ ~ soon t c.
Proof.
  destruct (bracket_same c) as [N|(k & lo & hi & B & S)]; [left; intros k lo hi B; rewrite N in B; discriminate|].
  destruct (Rle_dec (IZR lo) t) as [L|L]; [left|right].
  - intros m l h E. destruct (S m l h E) as [-> _]. exact L.
  - intros H. exact (L (H k lo hi B)).
Qed.

(* The diagram D comes from E by some of the claims: those that are not done may wait, those that are done may be. *)
Inductive from (waits does : claim -> Prop) : list claim -> diagram -> diagram -> Prop :=
| from_none D : from waits does [] D D
| from_wait c later E D : waits c -> from waits does later E D -> from waits does (c :: later) E D
| from_done c later E D D' : does c -> from waits does later E D -> renames c D D' -> from waits does (c :: later) E D'.

Lemma from_app (w d : claim -> Prop) l1 l2 E D : from w d (l1 ++ l2) E D -> exists F, from w d l2 E F /\ from w d l1 F D.
Proof.
  revert D. induction l1 as [|c l1 IH]; cbn [app]; intros D H.
  - exists D. split; [exact H|constructor].
  - inversion H as [|? ? ? ? Wc H'|? ? ? D0 ? Dc H' Re]; subst; destruct (IH _ H') as (F & A & B); exists F; (split; [exact A|]).
    + apply from_wait; assumption.
    + apply (from_done _ _ _ _ _ D0); assumption.
Qed.

Lemma from_nothing (w d : claim -> Prop) E F : from w d [] E F -> F = E.
Proof. intros H. inversion H. reflexivity. Qed.

Lemma from_one (w d : claim -> Prop) c E F : from w d [c] E F -> (w c /\ F = E) \/ (d c /\ renames c E F).
Proof.
  intros H. inversion H as [|? ? ? ? Wc H'|? ? ? D ? Dc H' Re]; subst; apply from_nothing in H'; subst; [left|right]; split; try assumption. reflexivity.
Qed.

Lemma from_change (w d w' d' : claim -> Prop) l E D : (forall c, In c l -> w c -> w' c) -> (forall c, In c l -> d c -> d' c) -> from w d l E D -> from w' d' l E D.
Proof.
  intros X Y H. induction H as [D|c l E D Wc H IH|c l E D D' Dc H IH Re]; [constructor| |].
  - apply from_wait; [apply X; [left; reflexivity|exact Wc]|]. apply IH; intros; [apply X|apply Y]; try right; assumption.
  - apply (from_done _ _ _ _ _ D); [apply Y; [left; reflexivity|exact Dc]| |exact Re]. apply IH; intros; [apply X|apply Y]; try right; assumption.
Qed.

Lemma allowed_from P past t D : allowed P past t D <-> from (late t) (soon t) past (PositiveMap.elements (edges P)) D.
Proof.
  split.
  - induction 1 as [t|c past t D L A IH|c past t D D' S A IH Re]; [constructor|apply from_wait; assumption|apply (from_done _ _ _ _ _ D); assumption].
  - remember (PositiveMap.elements (edges P)) as I eqn:E. induction 1 as [D|c l I D Wc H IH|c l I D D' Dc H IH Re]; subst.
    + apply at_start.
    + apply not_over; auto.
    + apply (already P c l t D); auto.
Qed.

Lemma renames_once c D D1 D2 : renames c D D1 -> renames c D D2 -> D1 = D2.
Proof.
  unfold renames. intros H. revert D2. induction H as [|[k q] [k1 q1] D D1 [E A] _ IH]; intros D2 H2; inversion H2 as [|? [k2 q2] ? D3 [E' A'] H3]; subst; [reflexivity|].
  cbn [fst snd] in *. rewrite (IH D3 H3). congruence.
Qed.

Lemma renames_or_not c D : (exists D', renames c D D') \/ ~ exists D', renames c D D'.
Proof.
  unfold renames. induction D as [|[k q] D IH]; [left; exists []; constructor|].
  destruct (after_flip k c q) as [q'|] eqn:A.
  - destruct IH as [(D' & H)|N]; [left|right].
    + exists ((k, q') :: D'). constructor; [split; [reflexivity|exact A]|exact H].
    + intros (D' & H). inversion H; subst. apply N. eexists; eassumption.
  - right. intros (D' & H). inversion H as [|? [k' q'] ? ? [E B] _]; subst. cbn [fst snd] in *. congruence.
Qed.

(* They are finitely many. *)
Lemma all_from (w d : claim -> Prop) l E : (forall c, w c \/ ~ w c) -> (forall c, d c \/ ~ d c) -> exists L, forall D, In D L <-> from w d l E D.
Proof.
  intros Wd Dd. induction l as [|c l (L & HL)].
  - exists [E]. intros D. cbn [In]. split; [intros [<-|[]]; constructor|intros H; inversion H; tauto].
  - assert (X : exists M, forall D', In D' M <-> exists D, In D L /\ renames c D D').
    { clear HL. induction L as [|D L (M & HM)].
      - exists []. intros D'. cbn [In]. split; [contradiction|intros (D & [] & _)].
      - destruct (renames_or_not c D) as [(D1 & R)|N]; [exists (D1 :: M)|exists M]; intros D'; cbn [In]; rewrite HM; split.
        + intros [<-|(D0 & I & H)]; [exists D; tauto|exists D0; tauto].
        + intros (D0 & [<-|I] & H); [left; apply (renames_once c D); assumption|right; exists D0; tauto].
        + intros (D0 & I & H). exists D0; tauto.
        + intros (D0 & [<-|I] & H); [destruct N; exists D'; exact H|exists D0; tauto]. }
    destruct X as (M & HM).
    destruct (Wd c) as [w1|w1], (Dd c) as [d1|d1]; [exists (L ++ M)|exists L|exists M|exists []]; intros D; rewrite ?in_app_iff, ?HL, ?HM; (split; [|
      intros H; inversion H as [|? ? ? ? Wc H'|? ? ? D0 ? Dc H' Re]; subst; try contradiction; rewrite <- ?HL in *; try tauto; try (right; exists D0; tauto); exists D0; tauto]).
    + intros [H|(D0 & I & H)]; [apply from_wait; assumption|]. apply HL in I. apply (from_done _ _ _ _ _ D0); assumption.
    + intros H. apply from_wait; assumption.
    + intros (D0 & I & H). apply HL in I. apply (from_done _ _ _ _ _ D0); assumption.
    + intros [].
Qed.

(* Claims that name no edge in common rename in either order. *)
Lemma renames_apart c c' D E D' : (forall k, bracket_of k c = None \/ bracket_of k c' = None) -> renames c D E -> renames c' D D' ->
  exists E', renames c' E E' /\ renames c D' E'.
Proof.
  intros N Re. unfold renames in *. revert D'. induction Re as [|[k q] [k1 p] D E [F A] _ IH]; intros D' Re'; inversion Re' as [|? [k2 p'] ? D2 [F' A'] Re3]; subst.
  - exists []. split; constructor.
  - cbn [fst snd] in *. subst. destruct (IH D2 Re3) as (E' & H1 & H2). destruct (N k) as [B|B].
    + rewrite (not_named k c q B) in A. injection A as <-. exists ((k, p') :: E'). split; constructor; try assumption; cbn [fst snd]; split; try reflexivity; try assumption.
      apply not_named, B.
    + rewrite (not_named k c' q B) in A'. injection A' as <-. exists ((k, p) :: E'). split; constructor; try assumption; cbn [fst snd]; split; try reflexivity; try assumption.
      apply not_named, B.
Qed.

Lemma from_apart (w d : claim -> Prop) later c E E' D : (forall c' k, In c' later -> d c' -> bracket_of k c = None \/ bracket_of k c' = None) -> from w d later E D -> renames c E E' ->
  exists D', from w d later E' D' /\ renames c D D'.
Proof.
  intros N H. revert E' N. induction H as [D|c' l E D Wc H IH|c' l E D D0 Dc H IH Re]; intros E' N R.
  - exists E'. split; [constructor|exact R].
  - destruct (IH E') as (D' & A & B); [intros x k I; apply N; right; exact I|exact R|]. exists D'. split; [apply from_wait; assumption|exact B].
  - destruct (IH E') as (D' & A & B); [intros x k I; apply N; right; exact I|exact R|].
    destruct (renames_apart c c' D D' D0) as (F & X & Y); [intros k; apply N; [left; reflexivity|exact Dc]|exact B|exact Re|].
    exists F. split; [apply (from_done _ _ _ _ _ D'); assumption|exact Y].
Qed.

(* An edge that no claim done names keeps its name. *)
Lemma from_keeps (w d : claim -> Prop) later E D k q : (forall c', In c' later -> d c' -> bracket_of k c' = None) -> from w d later E D -> In (k, q) E -> In (k, q) D.
Proof.
  intros N H I. induction H as [D|c' l E D Wc H IH|c' l E D D0 Dc H IH Re]; [exact I| |].
  - apply IH; [|exact I]. intros x Ix. apply N. right. exact Ix.
  - assert (ID : In (k, q) D) by (apply IH; [intros x Ix; apply N; right; exact Ix|exact I]).
    destruct (renamed_to _ _ _ _ _ Re ID) as (p & Ip & A). rewrite (not_named k c' q) in A by (apply N; [left; reflexivity|exact Dc]). injection A as <-. exact Ip.
Qed.

Section Exchange.
  Variable P : problem.
  Variables (s lo hi : Z) (f : edge) (k0 k1 k2 k3 k4 : positive).
  Let c := Flip s f lo hi k0 k1 k2 k3 k4.
  Definition still (D : diagram) : Prop := forall q, In (k0, q) D -> q = f \/ q = reversed f.

  Lemma c_bracket k l h : bracket_of k c = Some (l, h) -> l = lo /\ h = hi.
  Proof. unfold c. cbn [bracket_of]. destruct (_ || _); [|discriminate]. intros E. injection E as <- <-. split; reflexivity. Qed.
  Lemma c_own : own k0 c = true.
  Proof. apply Pos.eqb_refl. Qed.
  Lemma c_bracket_own : bracket_of k0 c = Some (lo, hi).
  Proof. unfold c. cbn [bracket_of]. rewrite Pos.eqb_refl. reflexivity. Qed.

  Lemma exchange_suffix later middle earlier u D : tracked P (later ++ middle ++ c :: earlier) -> IZR lo <= u < IZR hi ->
    allowed P (middle ++ c :: earlier) u D ->
    exists D', allowed P (middle ++ c :: earlier) u D' /\ ((still D /\ renames c D D') \/ (still D' /\ renames c D' D)).
  Proof.
    intros T U. assert (Way : forall k l h, bracket_of k c = Some (l, h) -> IZR l <= u < IZR h) by (intros k l h B; apply c_bracket in B as [-> ->]; exact U).
    revert later D T. induction middle as [|c' middle IH]; intros later D T A; cbn [app] in *.
    - assert (St : forall E, allowed P earlier u E -> still E).
      { intros E AE q I. apply (own_name P _ T later earlier s f lo hi k0 k1 k2 k3 k4 u q eq_refl); [lra|]. apply (allowed_names P earlier u E); assumption. }
      inversion A as [|? ? ? ? Late A0|? ? ? D0 ? Soon A0 Re]; subst.
      + destruct (all_rename P later c earlier u D T) as [D' Re]; [intros k l h B; apply (Way k l h B)|exact A0|].
        exists D'. split; [|left; split; [apply St, A0|exact Re]]. apply (already P c earlier u D); [intros k l h B; apply (Way k l h B)|exact A0|exact Re].
      + exists D0. split; [|right; split; [apply St, A0|exact Re]]. apply not_over; [intros k l h B; apply (Way k l h B)|exact A0].
    - assert (T' : tracked P ((later ++ [c']) ++ middle ++ c :: earlier)) by (rewrite <- app_assoc; exact T).
      inversion A as [|? ? ? ? Late A0|? ? ? D0 ? Soon A0 Re]; subst.
      + destruct (IH (later ++ [c']) D T' A0) as (D' & A' & Re). exists D'. split; [apply not_over; assumption|exact Re].
      + destruct (IH (later ++ [c']) D0 T' A0) as (D1 & A1 & Re1). destruct (all_rename P later c' (middle ++ c :: earlier) u D1 T Soon A1) as [D' Re'].
        exists D'. split; [apply (already P c' _ u D1); assumption|].
        assert (Late : forall k l h, bracket_of k c = Some (l, h) -> u < IZR h) by (intros k l h B; apply (Way k l h B)).
        assert (Keep : forall E E', renames c' E E' -> still E -> still E').
        { intros E E' R S q I. destruct (renamed_of _ _ _ _ _ R I) as (p & Ip & F). destruct (bracket_of k0 c') as [[l h]|] eqn:B.
          - exfalso. pose proof (Soon _ _ _ B). pose proof (alone P _ T later middle earlier c c' k0 lo hi l h eq_refl (or_introl c_own) c_bracket_own B) as X.
            apply IZR_le in X. lra.
          - rewrite (not_named k0 c' p B) in F. injection F as <-. apply S, Ip. }
        destruct Re1 as [[S1 Re1]|[S1 Re1]]; [left|right]; (split; [first [exact (Keep _ _ Re S1)|exact (Keep _ _ Re' S1)]|]).
        * apply (renames_commute P _ later c' middle c earlier u D0 D1 D D' T eq_refl Late Soon); assumption.
        * apply (renames_commute P _ later c' middle c earlier u D1 D0 D' D T eq_refl Late Soon); assumption.
  Qed.

  (* A flip under way may be done, or taken back. *)
  Lemma exchange past u D : tracked P past -> In c past -> IZR lo <= u < IZR hi -> allowed P past u D ->
    exists D', allowed P past u D' /\ ((still D /\ renames c D D') \/ (still D' /\ renames c D' D)).
  Proof. intros T I U A. apply in_split in I as (later & earlier & ->). apply (exchange_suffix [] later earlier u D T U A). Qed.

  (* How the flip changes each edge. *)
  Lemma renames_moved D D' q' : renames c D D' -> In q' (map snd D') -> exists q, In q (map snd D) /\ moved f q q'.
  Proof.
    intros Re I. apply in_map_iff in I as ([k q1] & E & I). cbn [snd] in E. subst q1. destruct (renamed_of _ _ _ _ _ Re I) as (q & Iq & A).
    exists q. split; [apply in_map_iff; exists (k, q); tauto|]. unfold c in A. cbn [after_flip own corner] in A. unfold moved.
    destruct (Pos.eqb k k0); [injection A as <-; right; left; unfold five_of, turned_over; tauto|].
    destruct (Pos.eqb k k1); [|destruct (Pos.eqb k k2); [|destruct (Pos.eqb k k3); [|destruct (Pos.eqb k k4)]]];
      try (right; right; do 4 eexists; split; [exact A|cbn [In]; tauto]). injection A as <-. left. reflexivity.
  Qed.

  Lemma beside_back a b x y q p : a <> b -> beside a b x y q = Some p -> beside a b y x p = Some q.
  Proof. intros N B. apply beside_cases in B as [(e & -> & ->)|(e & -> & ->)]; [apply beside_last|apply beside_first, N]. Qed.

  Lemma renames_moved_back D D' q : el f <> es f /\ el f <> ee f /\ er f <> es f /\ er f <> ee f -> still D ->
    renames c D D' -> In q (map snd D) -> exists q', In q' (map snd D') /\ moved f q' q.
  Proof.
    intros (N1 & N2 & N3 & N4) S Re I. apply in_map_iff in I as ([k q1] & E & I). cbn [snd] in E. subst q1. destruct (renamed_to _ _ _ _ _ Re I) as (q' & Iq & A).
    exists q'. split; [apply in_map_iff; exists (k, q'); tauto|]. unfold c in A. cbn [after_flip own corner] in A. unfold moved.
    destruct (Pos.eqb_spec k k0) as [->|_]; [right; left; unfold five_of; destruct (S q I); tauto|].
    destruct (Pos.eqb k k1); [|destruct (Pos.eqb k k2); [|destruct (Pos.eqb k k3); [|destruct (Pos.eqb k k4)]]];
      try (right; right; do 4 eexists; split; [apply beside_back; [|exact A]; congruence|cbn [In]; tauto]). injection A as <-. left. reflexivity.
  Qed.
End Exchange.

Lemma list_or_not {A} (Q : A -> Prop) (L : list A) : (forall a, Q a \/ ~ Q a) -> (exists a, In a L /\ Q a) \/ ~ exists a, In a L /\ Q a.
Proof.
  intros Dec. induction L as [|a L IH]; [right; intros (a & [] & _)|]. destruct (Dec a) as [H|H]; [left; exists a; split; [left; reflexivity|exact H]|].
  destruct IH as [(b & I & Hb)|N]; [left; exists b; split; [right; exact I|exact Hb]|right]. intros (b & [<-|I] & Hb); [tauto|apply N; exists b; tauto].
Qed.

(* Where it is not false of any of finitely many that it holds just before t, it is not false of all together. *)
Lemma before_all {A} t (Q : A -> R -> Prop) (L : list A) : (forall a, In a L -> ~ ~ before t (Q a)) -> ~ ~ before t (fun u => forall a, In a L -> Q a u).
Proof.
  induction L as [|b L IH]; intros H N.
  - apply N. exists 1. split; [lra|]. intros u _ a [].
  - apply (H b); [left; reflexivity|]. intros B. apply IH; [intros a I; apply H; right; exact I|]. intros C. apply N.
    apply (before_impl t) with (2 := before_and _ _ _ B C). intros u [X Y] a [<-|I]; [exact X|apply Y, I].
Qed.

Section Global.
  Variable P : problem.
  Variable past : list claim.
  Let gens : list gen := map fst (PositiveMap.elements (bodies P)).
  Let at_ (t : R) (g : gen) : generator := place P past t g.
  Hypothesis true_ : true_history P past.
  Hypothesis names : tracked P past.
  Hypothesis first : first_fits P gens.
  Hypothesis motion : moves at_.
  Hypothesis voronoi_first : voronoi gens (at_ 0) (map snd (PositiveMap.elements (edges P))).
  Hypothesis lines : forall later earlier t f lo hi k0 k1 k2 k3 k4 g u, past = later ++ Flip t f lo hi k0 k1 k2 k3 k4 :: earlier ->
    In g [el f; er f; es f; ee f] -> IZR lo <= u <= IZR hi -> at_ u g = on_leg P g (last_leg P g earlier) u.
  (* When the bracket of a flip of an edge or of one beside it ends, the edge still stands by each name that it had just before. *)
  Hypothesis stands_closed : forall c k lo hi q, In c past -> bracket_of k c = Some (lo, hi) -> (0 < hi < horizon P)%Z ->
    before (IZR hi) (fun u => In q (names_at P k past u)) ->
    let t := IZR hi in stands (at_ t (el q)) (at_ t (er q)) (at_ t (es q)) (at_ t (ee q)).
  (* After a flip at one instant no flip that names one of its edges begins before that instant. *)
  Hypothesis instants : forall later middle earlier c c' k t lo' hi', past = later ++ c' :: middle ++ c :: earlier ->
    bracket_of k c = Some (t, t) -> bracket_of k c' = Some (lo', hi') -> (t <= lo')%Z.

  Let start : diagram := PositiveMap.elements (edges P).
  Let W t : forall g, wall (at_ t g) = Pos.eqb g container := walls at_ motion t.
  Let Pr t : forall g, proper (at_ t g).
  Proof. intros g. apply (Local.moving_proper at_ motion). Qed.

  Definition good (t : R) : Prop := exists D, allowed P past t D /\ voronoi gens (at_ t) (map snd D).

  Lemma finite t : exists L, forall D, In D L <-> allowed P past t D.
  Proof.
    destruct (all_from (late t) (soon t) past start (late_or_not t) (soon_or_not t)) as (L & HL). exists L. intros D. rewrite HL. symmetry. apply allowed_from.
  Qed.

  Lemma good_or_not t : good t \/ ~ good t.
  Proof.
    destruct (finite t) as (L & HL). destruct (list_or_not (fun D => voronoi gens (at_ t) (map snd D)) L) as [(D & I & V)|N].
    - intros D. destruct (voronoi_dec gens (at_ t) (map snd D)); tauto.
    - left. exists D. split; [apply HL, I|exact V].
    - right. intros (D & A & V). apply N. exists D. split; [apply HL, A|exact V].
  Qed.

  (* What a flip says. *)
  Section Flip.
    Variables (later earlier : list claim) (s lo hi : Z) (f : edge) (k0 k1 k2 k3 k4 : positive).
    Hypothesis Past : past = later ++ Flip s f lo hi k0 k1 k2 k3 k4 :: earlier.

    Lemma begins : (0 < lo <= hi)%Z.
    Proof. destruct (claims_true P past true_ _ _ _ Past) as (_ & _ & B & _). lia. Qed.

    Lemma end_entered : (lo < hi)%Z -> is entered (at_ (IZR hi)) f.
    Proof.
      intros L. pose proof begins as B. destruct (claims_true P past true_ _ _ _ Past) as (_ & _ & _ & _ & _ & _ & E & _). specialize (E L).
      unfold is. assert (IZR lo <= IZR hi <= IZR hi) by (split; [apply IZR_le; lia|lra]).
      rewrite !(lines _ _ _ _ _ _ _ _ _ _ _ _ _ Past) by (try assumption; cbn [In]; tauto). exact E.
    Qed.

    Lemma instant_pinched : lo = hi -> is pinched (at_ (IZR lo)) f.
    Proof.
      intros L. destruct (claims_true P past true_ _ _ _ Past) as (_ & _ & _ & _ & _ & _ & _ & E & _). destruct (E L) as [E' _].
      unfold is. assert (IZR lo <= IZR lo <= IZR hi) by (rewrite <- L; lra).
      rewrite !(lines _ _ _ _ _ _ _ _ _ _ _ _ _ Past) by (try assumption; cbn [In]; tauto). exact E'.
    Qed.

    Lemma tracked_here : tracked P ((later ++ [Flip s f lo hi k0 k1 k2 k3 k4]) ++ earlier).
    Proof. rewrite <- app_assoc. cbn [app]. rewrite <- Past. exact names. Qed.

    Lemma own_number : In k0 (numbers P).
    Proof. apply number_found. apply (five P past names _ _ _ _ _ _ _ _ _ _ _ Past). left. reflexivity. Qed.

    (* Its edge in a diagram that is allowed before. *)
    Lemma own_edge u E : IZR lo <= u -> allowed P earlier u E -> exists q, In (k0, q) E /\ (q = f \/ q = reversed f).
    Proof.
      intros U A. destruct (in_diagram P earlier u E k0 A own_number) as (q & I). exists q. split; [exact I|].
      apply (own_name P past names _ _ _ _ _ _ _ _ _ _ _ u q Past U). apply (allowed_names P earlier u E); assumption.
    Qed.

    Lemma four_in g : In g [el f; er f; es f; ee f] -> In g gens.
    Proof.
      intros G. destruct (some_suffix P _ earlier (IZR lo) tracked_here) as (E & A). destruct (own_edge (IZR lo) E) as (q & I & H); [lra|exact A|].
      destruct (all_fit P gens _ earlier (IZR lo) E first tracked_here A) as (_ & _ & N). apply (N k0 q); [exact I|].
      destruct H as [->| ->]; [exact G|]. cbn [reversed el er es ee In] in *. tauto.
    Qed.

    Lemma four_apart : el f <> er f /\ el f <> es f /\ el f <> ee f /\ er f <> es f /\ er f <> ee f.
    Proof. apply (distinct_four P past names _ _ _ _ _ _ _ _ _ _ _ Past). Qed.
  End Flip.

  (* At the start no flip has begun. *)
  Lemma start_allowed earlier later : past = later ++ earlier -> allowed P earlier 0 start.
  Proof.
    revert later. induction earlier as [|c earlier IH]; intros later E; [apply at_start|]. apply not_over.
    - intros k lo hi B. destruct c as [s f l h k0 k1 k2 k3 k4| |]; try discriminate. apply c_bracket in B as [-> ->].
      pose proof (begins _ _ _ _ _ _ _ _ _ _ _ E). apply IZR_lt. lia.
    - apply (IH (later ++ [c])). rewrite <- app_assoc. exact E.
  Qed.

  Lemma good_start : good 0.
  Proof. exists start. split; [apply (start_allowed past []); reflexivity|exact voronoi_first]. Qed.

  (* From the left: the flips that end at t are done, or are done now. *)
  Section Left.
    Variable t : R.
    Hypothesis Ht : 0 < t < IZR (horizon P).

    Lemma finish earlier later D : past = later ++ earlier -> from (late_before t) (soon_before t) past start D -> voronoi gens (at_ t) (map snd D) ->
      exists E D', allowed P earlier t E /\ from (late_before t) (soon_before t) later E D' /\ voronoi gens (at_ t) (map snd D').
    Proof.
      intros Past From V. revert later Past. induction earlier as [|c earlier IH]; intros later Past.
      - exists start, D. split; [apply at_start|]. rewrite app_nil_r in Past. rewrite <- Past. split; assumption.
      - destruct (IH (later ++ [c])) as (E & D0 & A & Fr & V0); [rewrite <- app_assoc; exact Past|]. clear IH From V D.
        apply from_app in Fr as (F & F1 & F2). apply from_one in F1 as [[Wc ->]|[Dc Re]].
        2: { exists F, D0. split; [|split; assumption]. apply (already P c earlier t E); try assumption.
             intros k lo hi B. pose proof (Dc k lo hi B). lra. }
        destruct (late_or_not t c) as [L|L]; [exists E, D0; split; [apply not_over; assumption|split; assumption]|].
        destruct c as [s f lo hi k0 k1 k2 k3 k4| |]; try (exfalso; apply L; intros k l h B; discriminate).
        set (c := Flip s f lo hi k0 k1 k2 k3 k4) in *. pose proof (begins _ _ _ _ _ _ _ _ _ _ _ Past) as Be.
        assert (Hi : t = IZR hi).
        { pose proof (Wc k0 lo hi (c_bracket_own s lo hi f k0 k1 k2 k3 k4)). destruct (Rle_lt_or_eq_dec t (IZR hi)) as [X|X]; [assumption| |exact X].
          exfalso. apply L. intros k l h B. apply c_bracket in B as [-> ->]. exact X. }
        assert (Apart : forall c', In c' later -> soon_before t c' -> forall k l h l' h', bracket_of k c = Some (l, h) -> bracket_of k c' = Some (l', h') -> own k c = true \/ l = h -> False).
        { intros c' I S k l h l' h' B B' O. apply in_split in I as (m1 & m2 & E'). assert (E2 : past = m1 ++ c' :: m2 ++ c :: earlier).
          { rewrite Past, E', <- app_assoc. reflexivity. }
          pose proof B as B2. apply c_bracket in B2 as [-> ->]. assert (X : (hi <= l')%Z).
          { destruct O as [O|O]; [apply (alone P past names _ _ _ _ _ _ _ _ _ _ E2 (or_introl O) B B')|].
            subst lo. apply (instants _ _ _ _ _ _ _ _ _ E2 B B'). }
          apply IZR_le in X. pose proof (S k l' h' B'). lra. }
        assert (Lo : IZR lo <= t) by (rewrite Hi; apply IZR_le; lia).
        destruct (own_edge _ _ _ _ _ _ _ _ _ _ _ Past t E Lo A) as (q & Iq & Q).
        assert (IqD : In (k0, q) D0).
        { apply (from_keeps (late_before t) (soon_before t) later E D0 k0 q); [|exact F2|exact Iq]. intros c' I S. destruct (bracket_of k0 c') as [[l' h']|] eqn:B; [|reflexivity].
          exfalso. apply (Apart c' I S k0 lo hi l' h'); [apply c_bracket_own|exact B|left; apply c_own]. }
        pose proof (four_in _ _ _ _ _ _ _ _ _ _ _ Past) as Four. apply (in_map snd) in IqD. cbn [snd] in IqD.
        destruct (Z_lt_le_dec lo hi) as [X|X].
        + exfalso. apply (not_entered (at_ t) (W t) (Pr t) gens (map snd D0) f V0).
          * destruct Q as [->| ->]; tauto.
          * apply (four_apart _ _ _ _ _ _ _ _ _ _ _ Past).
          * exact Four.
          * rewrite Hi. apply (end_entered _ _ _ _ _ _ _ _ _ _ _ Past X).
        + assert (lo = hi) as Same by lia.
          destruct (all_rename P later c earlier t E) as (E' & Re); [rewrite <- Past; exact names|intros k l h B; apply c_bracket in B as [-> ->]; exact Lo|exact A|].
          destruct (from_apart (late_before t) (soon_before t) later c E E' D0) with (2 := F2) (3 := Re) as (D' & F2' & ReD).
          { intros c' k I S. destruct (bracket_of k c) as [[l h]|] eqn:B; [|left; reflexivity]. destruct (bracket_of k c') as [[l' h']|] eqn:B'; [|right; reflexivity].
            exfalso. apply (Apart c' I S k l h l' h' B B'). right. apply c_bracket in B as [-> ->]. exact Same. }
          exists E', D'. split; [apply (already P c earlier t E); [intros k l h B; apply c_bracket in B as [-> ->]; exact Lo|exact A|exact Re]|]. split; [exact F2'|].
          apply (change_voronoi (at_ t) (W t) (Pr t) gens f (map snd D0)); [exact Four| |exact V0| |].
          * rewrite Hi, <- Same. apply (instant_pinched _ _ _ _ _ _ _ _ _ _ _ Past Same).
          * exists q. split; [exact IqD|]. unfold five_of. tauto.
          * intros q'. apply (renames_moved s lo hi f k0 k1 k2 k3 k4 D0 D' q' ReD).
    Qed.

    (* Elsewhere no name ends. *)
    Lemma names_stay k earlier : (forall c lo hi, In c earlier -> bracket_of k c = Some (lo, hi) -> IZR hi <> t) ->
      before t (fun u => forall q, In q (names_at P k earlier u) -> In q (names_at P k earlier t)).
    Proof.
      induction earlier as [|c earlier IH]; intros N; [exists 1; split; [lra|]; intros u _ q I; exact I|].
      assert (B := IH ltac:(intros c' lo hi I; apply (N c' lo hi); right; exact I)). cbn [names_at].
      destruct (bracket_of k c) as [[lo hi]|] eqn:E; [|exact B]. specialize (N c lo hi (or_introl eq_refl) E).
      apply (before_impl t) with (2 := before_and _ _ _ B (before_numbers t (IZR lo) (IZR hi))). intros u [Sub [X Y]] q.
      assert (R : In q (renamed k c (names_at P k earlier u)) -> In q (renamed k c (names_at P k earlier t))).
      { unfold renamed. rewrite !in_flat_map. intros (p & I & J). exists p. split; [apply Sub, I|exact J]. }
      specialize (Sub q). destruct (Rle_dec (IZR hi) u), (Rle_dec (IZR hi) t), (Rle_dec (IZR lo) u), (Rle_dec (IZR lo) t); rewrite ?in_app_iff; tauto || (exfalso; lra).
    Qed.

    Lemma stands_end k q : before t (fun u => In q (names_at P k past u)) -> is stands (at_ t) q.
    Proof.
      intros B. destruct (list_or_not (fun c => exists lo hi, bracket_of k c = Some (lo, hi) /\ IZR hi = t) past) as [(c & I & lo & hi & E & <-)|N].
      - intros c. destruct (bracket_of k c) as [[lo hi]|]; [|right; intros (lo & hi & E & _); discriminate].
        destruct (Req_dec (IZR hi) t) as [X|X]; [left; exists lo, hi; tauto|right]. intros (l & h & E & Y). injection E as -> ->. exact (X Y).
      - destruct Ht as [H0 H1]. apply lt_IZR in H0, H1. apply (stands_closed c k lo hi q I E); [split; assumption|exact B].
      - assert (Stay := names_stay k past ltac:(intros c lo hi I E X; apply N; exists c; split; [exact I|exists lo, hi; tauto])).
        destruct (before_and _ _ _ B Stay) as (d & Hd & H).
        destruct (H (t - d / 2) ltac:(lra)) as [I S]. apply (edges_stand P past true_ k q t); [lra|apply S, I].
    Qed.

    Lemma limit : (forall d, 0 < d -> exists u, t - d < u < t /\ 0 <= u /\ good u) -> good t.
    Proof.
      intros Often. destruct (good_or_not t) as [G|N]; [exact G|exfalso].
      destruct (before_list t (fun c u => (late u c <-> late_before t c) /\ (soon u c <-> soon_before t c)) past) as (d & Hd & H); [intros c _; apply before_claim|].
      assert (Same : forall u D, t - d < u < t -> (allowed P past u D <-> from (late_before t) (soon_before t) past start D)).
      { intros u D U. rewrite allowed_from. split; apply from_change; intros c I; apply (H u U c I). }
      destruct (finite (t - d / 2)) as (L & HL). assert (U0 : t - d < t - d / 2 < t) by lra.
      apply (before_all t (fun D u => ~ voronoi gens (at_ u) (map snd D)) L).
      - intros D I X. apply HL in I. pose proof (proj1 (Same _ D U0) I) as Fr.
        assert (V : voronoi gens (at_ t) (map snd D)).
        { apply (closed_unless gens at_ (map snd D) t motion); [apply (allowed_fits P gens past (t - d / 2)); assumption|exact X|].
          assert (St : forall p, In p (map snd D) -> is stands (at_ t) p).
          { intros p Ip. apply in_map_iff in Ip as ([k p'] & E & Ip). cbn [snd] in E. subst p'. apply (stands_end k p).
            exists d. split; [exact Hd|]. intros u U. apply (allowed_names P past u D); [|exact Ip]. apply Same; assumption. }
          intros q [[Iq|Iq] D0]; apply (stands_both (at_ t) (W t) (Pr t)); try exact D0; [apply St, Iq|]. apply St, stands_back in Iq.
          rewrite back_back in Iq. exact Iq. }
        destruct (finish past [] D eq_refl Fr V) as (E & D' & A & F' & V'). apply from_nothing in F'. rewrite F' in V'. apply N. exists E. split; assumption.
      - intros (d' & Hd' & H'). pose proof (Rmin_l d d'). pose proof (Rmin_r d d'). destruct (Often (Rmin d d')) as (u & U & _ & D & A & V); [apply Rmin_glb_lt; assumption|].
        apply (H' u ltac:(lra) D); [|exact V]. apply HL, Same; [exact U0|]. apply (Same u); [lra|exact A].
    Qed.
  End Left.

  (* To the right: of each pinched edge under way that is not legal the flip is done, or taken back. *)
  Lemma apart_own t c c2 k lo hi lo2 hi2 : In c past -> In c2 past -> own k c2 = true -> bracket_of k c = Some (lo, hi) -> bracket_of k c2 = Some (lo2, hi2) ->
    IZR lo <= t < IZR hi -> IZR lo2 <= t < IZR hi2 -> c = c2.
  Proof.
    intros I I2 O B B2 U U2. apply in_split in I as (l1 & l2 & E). pose proof I2 as I3. rewrite E in I3. apply in_app_or in I3 as [I3|[I3|I3]]; [exfalso| exact I3|exfalso].
    - apply in_split in I3 as (m1 & m2 & E'). assert (E2 : past = m1 ++ c2 :: m2 ++ c :: l2) by (rewrite E, E', <- app_assoc; reflexivity).
      pose proof (IZR_le _ _ (alone P past names _ _ _ _ _ _ _ _ _ _ E2 (or_intror O) B B2)). lra.
    - apply in_split in I3 as (m1 & m2 & E'). rewrite E' in E.
      pose proof (IZR_le _ _ (alone P past names _ _ _ _ _ _ _ _ _ _ E (or_introl O) B2 B)). lra.
  Qed.

  Lemma one_name t D k q q' : allowed P past t D -> In (k, q) D -> In (k, q') D -> q = q'.
  Proof.
    intros A. pose proof (numbers_once P) as N. rewrite <- (allowed_numbers P past t D A) in N. clear A. induction D as [|[m p] D IH]; [contradiction|].
    cbn [map fst] in N. apply NoDup_cons_iff in N as [Out N]. intros [I|I] [I'|I'].
    - congruence.
    - injection I as -> ->. destruct Out. apply in_map_iff. exists (k, q'). split; [reflexivity|exact I'].
    - injection I' as -> ->. destruct Out. apply in_map_iff. exists (k, q). split; [reflexivity|exact I].
    - apply IH; assumption.
  Qed.

  Lemma turned_twice q : turned_over (turned_over q) = reversed q.
  Proof. destruct q; reflexivity. Qed.
  Lemma turned_back q : turned_over (reversed q) = reversed (turned_over q).
  Proof. destruct q; reflexivity. Qed.

  Section Right.
    Variables t u : R.
    Hypothesis Ht : 0 <= t < IZR (horizon P).
    Hypothesis Hu : 0 <= u < IZR (horizon P).
    Hypothesis Same : forall D, allowed P past t D -> allowed P past u D.
    Hypothesis Two : forall D, allowed P past t D -> forall p, In p D -> voronoi gens (at_ t) (map snd D) -> is pinched (at_ t) (snd p) ->
      is legal (at_ u) (snd p) \/ is legal (at_ u) (turned_over (snd p)).
    Hypothesis Others : forall D, allowed P past t D -> forall p, In p D -> ~ flipping (fst p) past t -> is pinched (at_ t) (snd p) -> is legal (at_ u) (snd p).

    Lemma stands_at v D k q : 0 <= v < IZR (horizon P) -> allowed P past v D -> In (k, q) D -> is stands (at_ v) q.
    Proof. intros Hv A I. apply (edges_stand P past true_ k q v Hv). apply (allowed_names P past v D); assumption. Qed.

    Lemma pinched_turned q : voronoi gens (at_ t) [] -> (forall g, In g [el q; er q; es q; ee q] -> In g gens) -> is pinched (at_ t) q -> is pinched (at_ t) (turned_over q).
    Proof.
      intros V G (z & Z). exists z. cbn [In] in G. destruct q as [l r s e]. cbn [turned_over el er es ee] in *.
      apply (one_circle_after gens (at_ t) (W t) (fun g _ => Pr t g) (all_right _ _ _ V)); try (apply G; tauto). exact Z.
    Qed.

    Definition settled (D : diagram) (c : claim) : Prop := forall k q lo hi, own k c = true -> bracket_of k c = Some (lo, hi) -> IZR lo <= t < IZR hi ->
      In (k, q) D -> is pinched (at_ t) q -> is legal (at_ u) q.

    Lemma settle_one c S D : (forall c2, In c2 (c :: S) -> In c2 past) -> allowed P past t D -> voronoi gens (at_ t) (map snd D) ->
      (forall c2, In c2 S -> settled D c2) ->
      exists D', allowed P past t D' /\ voronoi gens (at_ t) (map snd D') /\ forall c2, In c2 (c :: S) -> settled D' c2.
    Proof.
      intros Sub A V Done. assert (Keep : settled D c -> exists D', allowed P past t D' /\ voronoi gens (at_ t) (map snd D') /\ forall c2, In c2 (c :: S) -> settled D' c2).
      { intros X. exists D. split; [exact A|]. split; [exact V|]. intros c2 [<-|I]; [exact X|apply Done, I]. }
      destruct c as [s f lo hi k0 k1 k2 k3 k4| |]; try (apply Keep; intros k q l h O; discriminate). set (c := Flip s f lo hi k0 k1 k2 k3 k4) in *.
      assert (U : IZR lo <= t < IZR hi \/ ~ IZR lo <= t < IZR hi) by (destruct (Rle_dec (IZR lo) t), (Rlt_dec t (IZR hi)); tauto || (right; lra)).
      destruct U as [U|U]; [|apply Keep; intros k q l h O B X; exfalso; apply c_bracket in B as [-> ->]; exact (U X)].
      assert (Ic : In c past) by (apply Sub; left; reflexivity). pose proof Ic as Ic'. apply in_split in Ic' as (later & earlier & Past).
      destruct (in_diagram P past t D k0 A (own_number _ _ _ _ _ _ _ _ _ _ _ Past)) as (q & Iq).
      assert (Is : In q (map snd D)) by (apply in_map_iff; exists (k0, q); tauto).
      assert (Own : forall k, own k c = true -> k = k0) by (intros k O; apply Pos.eqb_eq, O).
      destruct (pinched_or_not (at_ t) (W t) (Pr t) q (stands_at t D k0 q Ht A Iq)) as [Pq|Nq].
      2: { apply Keep. intros k p l h O B _ I Z. exfalso. apply Nq. rewrite (Own k O) in I. rewrite (one_name t D k0 q p A Iq I). exact Z. }
      destruct (legal_or_not (at_ u) (W u) (Pr u) q (stands_at u D k0 q Hu (Same D A) Iq)) as [Lq|Nq].
      1: { apply Keep. intros k p l h O B _ I _. rewrite (Own k O) in I. rewrite <- (one_name t D k0 q p A Iq I). exact Lq. }
      assert (Tq : is legal (at_ u) (turned_over q)) by (destruct (Two D A (k0, q) Iq V Pq) as [H|H]; [contradiction|exact H]).
      pose proof (four_in _ _ _ _ _ _ _ _ _ _ _ Past) as Four. pose proof (four_apart _ _ _ _ _ _ _ _ _ _ _ Past) as (_ & N).
      assert (V0 : voronoi gens (at_ t) []). { split; [apply (all_right _ _ _ V)| |]; intros p; [intros [[[]|[]] _]|intros v g [[[]|[]] _]]. }
      destruct (exchange P s lo hi f k0 k1 k2 k3 k4 past t D names Ic U A) as (D' & A' & Ways). fold c in Ways. exists D'. split; [exact A'|].
      assert (X : is pinched (at_ t) f /\ five_of f q /\ (forall q', In (k0, q') D' -> is legal (at_ u) q') /\
        (forall q', In q' (map snd D') -> exists q, In q (map snd D) /\ moved f q q') /\
        (forall k p, bracket_of k c = None -> In (k, p) D' -> In (k, p) D)).
      { destruct Ways as [[St Re]|[St Re]].
        - assert (F : q = f \/ q = reversed f) by (apply St, Iq).
          split; [destruct F as [->| ->]; [exact Pq|rewrite <- (back_back f); apply pinched_back, Pq]|]. split; [unfold five_of; tauto|]. split; [|split].
          + intros q' I. destruct (renamed_of _ _ _ _ _ Re I) as (p & _ & E). unfold c in E. cbn [after_flip] in E. rewrite (c_own s lo hi f k0 k1 k2 k3 k4) in E. injection E as <-.
            change (is legal (at_ u) (turned_over f)). destruct F as [E|E]; rewrite E in Tq; [exact Tq|].
            rewrite turned_back in Tq. rewrite <- (back_back (turned_over f)). apply circles_back, Tq.
          + intros q'. apply (renames_moved s lo hi f k0 k1 k2 k3 k4 D D' q' Re).
          + intros k p B I. destruct (renamed_of _ _ _ _ _ Re I) as (p0 & Ip & E). rewrite (not_named k c p0 B) in E. injection E as <-. exact Ip.
        - destruct (renamed_of _ _ _ _ _ Re Iq) as (p0 & Ip0 & E0). unfold c in E0. cbn [after_flip] in E0. rewrite (c_own s lo hi f k0 k1 k2 k3 k4) in E0.
          assert (F : q = turned_over f) by (injection E0 as <-; reflexivity). clear E0.
          split; [|split; [unfold five_of; tauto|split; [|split]]].
          + rewrite <- (back_back f). apply pinched_back. rewrite <- turned_twice. apply pinched_turned; [exact V0| |rewrite <- F; exact Pq].
            intros g G. apply Four. destruct f as [f1 f2 f3 f4]. cbn [turned_over el er es ee In] in *. tauto.
          + intros q' I. rewrite F, turned_twice in Tq. destruct (St q' I) as [->| ->]; [|exact Tq]. rewrite <- (back_back f). apply circles_back, Tq.
          + intros q' I. apply (renames_moved_back s lo hi f k0 k1 k2 k3 k4 D' D q' N St Re I).
          + intros k p B I. destruct (renamed_to _ _ _ _ _ Re I) as (p1 & Ip & E). rewrite (not_named k c p B) in E. injection E as <-. exact Ip. }
      destruct X as (Pf & Five & Legal & Moved & Else). split; [|].
      - apply (change_voronoi (at_ t) (W t) (Pr t) gens f (map snd D)); [exact Four|exact Pf|exact V|exists q; tauto|exact Moved].
      - assert (Mine : settled D' c) by (intros k p l h O B _ I _; rewrite (Own k O) in I; apply Legal, I).
        intros c2 [<-|I2]; [exact Mine|]. intros k p l h O B U2 I Z. destruct (bracket_of k c) as [[l1 h1]|] eqn:B1.
        + assert (c = c2) as <-. { apply (apart_own t c c2 k l1 h1 l h); try assumption; [apply Sub; right; exact I2|]. apply c_bracket in B1 as [-> ->]. exact U. }
          apply (Mine k p l h); assumption.
        + apply (Done c2 I2 k p l h); try assumption. apply Else; assumption.
    Qed.

    Lemma settle_all S D : (forall c, In c S -> In c past) -> allowed P past t D -> voronoi gens (at_ t) (map snd D) ->
      exists D', allowed P past t D' /\ voronoi gens (at_ t) (map snd D') /\ forall c, In c S -> settled D' c.
    Proof.
      induction S as [|c S IH]; intros Sub A V; [exists D; split; [exact A|split; [exact V|intros c []]]|].
      destruct IH as (D1 & A1 & V1 & Done); [intros c2 I; apply Sub; right; exact I|exact A|exact V|].
      apply (settle_one c S D1); assumption.
    Qed.

    Lemma all_legal D : allowed P past t D -> voronoi gens (at_ t) (map snd D) ->
      exists D', allowed P past t D' /\ voronoi gens (at_ t) (map snd D') /\ short_legal at_ (map snd D') t u.
    Proof.
      intros A V. destruct (settle_all past D) as (D' & A' & V' & Done); try assumption; [auto|]. exists D'. split; [exact A'|]. split; [exact V'|].
      intros q I Z. apply in_map_iff in I as ([k q'] & E & I). cbn [snd] in E. subst q'.
      destruct (sig_not_dec (flipping k past t)) as [Y|N]; [|apply (Others D' A' (k, q) I N Z)].
      destruct (legal_or_not (at_ u) (W u) (Pr u) q (stands_at u D' k q Hu (Same D' A') I)) as [L|N]; [exact L|].
      exfalso. apply Y. intros (c & lo & hi & Ic & O & B & U). apply N. apply (Done c Ic k q lo hi O B U I Z).
    Qed.
  End Right.

  Lemma lasting t : 0 <= t < IZR (horizon P) -> good t -> exists d, 0 < d /\ forall u, t < u < t + d -> u < IZR (horizon P) -> good u.
  Proof.
    intros Ht (D & A & V). destruct (finite t) as (L & HL).
    assert (A1 : after t (fun u => forall c, In c past -> (late u c <-> late t c) /\ (soon u c <-> soon t c))) by (apply after_list; intros c _; apply after_claim).
    assert (A2 : after t (fun u => forall D, In D L -> voronoi gens (at_ t) (map snd D) -> short_legal at_ (map snd D) t u -> voronoi gens (at_ u) (map snd D))).
    { apply after_list. intros E I. destruct (voronoi_dec gens (at_ t) (map snd E)) as [VE|N]; [|apply after_always; contradiction].
      apply (after_impl t) with (2 := local gens at_ (map snd E) t motion (allowed_fits P gens past t E first names (proj1 (HL E) I)) VE). auto. }
    assert (A3 : after t (fun u => forall D, In D L -> forall p, In p D -> voronoi gens (at_ t) (map snd D) -> is pinched (at_ t) (snd p) ->
      is legal (at_ u) (snd p) \/ is legal (at_ u) (turned_over (snd p)))).
    { apply after_list. intros E I. apply after_list. intros [k q] Ip. cbn [snd]. apply HL in I.
      destruct (voronoi_dec gens (at_ t) (map snd E)) as [VE|N]; [|apply after_always; contradiction].
      destruct (pinched_or_not (at_ t) (W t) (Pr t) q (stands_at t E k q Ht I Ip)) as [Z|N]; [|apply after_always; contradiction].
      assert (Iq : In q (map snd E)) by (apply in_map_iff; exists (k, q); tauto).
      apply (after_impl t) with (2 := two_ways gens at_ (map snd E) t q motion (allowed_fits P gens past t E first names I) VE Iq Z). auto. }
    assert (A4 : after t (fun u => forall D, In D L -> forall p, In p D -> ~ flipping (fst p) past t -> is pinched (at_ t) (snd p) -> is legal (at_ u) (snd p))).
    { apply after_list. intros E I. apply after_list. intros [k q] Ip. cbn [fst snd]. apply HL in I.
      destruct (sig_not_dec (flipping k past t)) as [Y|N]; [apply after_always; intros v N; contradiction|].
      destruct (edges_last P past true_ k q t Ht (allowed_names P past t E k q I Ip) N) as [_ [C|(v & Hv & Lg)]].
      - apply after_always. intros v _ Z. exfalso. apply (pinched_cotangent (at_ t) (W t) (Pr t) q (stands_at t E k q Ht I Ip) Z C).
      - exists (v - t). split; [lra|]. intros w Hw _ _. apply Lg. lra. }
    destruct (after_and _ _ _ (after_and _ _ _ A1 A2) (after_and _ _ _ A3 A4)) as (d & Hd & H). clear A1 A2 A3 A4.
    exists d. split; [exact Hd|]. intros u Hu Hh. destruct (H u ltac:(lra)) as [[B1 B2] [B3 B4]].
    assert (Same : forall D, allowed P past t D -> allowed P past u D).
    { intros E. rewrite !allowed_from. apply from_change; intros c I; apply (B1 c I). }
    destruct (all_legal t u Ht ltac:(lra) Same) with (D := D) as (D' & A' & V' & S'); try assumption.
    - intros E AE. apply B3, HL, AE.
    - intros E AE. apply B4, HL, AE.
    - exists D'. split; [apply Same, A'|]. apply B2; try assumption. apply HL, A'.
  Qed.

  Theorem global : forall t, 0 <= t < IZR (horizon P) -> exists D, allowed P past t D /\ voronoi gens (at_ t) (map snd D).
  Proof.
    apply (march (IZR (horizon P)) good good_or_not good_start); [|exact lasting]. intros t Ht. apply limit, Ht.
  Qed.
End Global.
