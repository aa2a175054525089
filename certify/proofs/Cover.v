(* The arcs around a generator cover the circle; the walk within a cluster of cotangent generators; the tangency identity. *)
From Coq Require Import Reals Lra List Lia Arith.
From Voroproof Require Import Arc.
Import ListNotations.
Open Scope R_scope.

(* A finite list has a least element for any two keys, the second of which breaks ties. *)
Lemma least_of {A} (f g : A -> R) (l : list A) : l <> [] ->
  exists x, In x l /\ forall y, In y l -> f x < f y \/ (f x = f y /\ g y <= g x).
Proof.
  induction l as [|a l IH]; [congruence|]. intros _. destruct l as [|b l].
  - exists a. split; [left; reflexivity|]. intros y [<-|[]]. right. split; [reflexivity|lra].
  - destruct IH as (x & I & M); [congruence|].
    destruct (Rlt_or_le (f a) (f x)) as [L|L].
    + exists a. split; [left; reflexivity|]. intros y [<-|Iy]; [right; lra|]. destruct (M y Iy) as [H|[H _]]; left; lra.
    + destruct (Req_dec (f a) (f x)) as [E|N].
      * destruct (Rlt_or_le (g x) (g a)) as [G|G].
        -- exists a. split; [left; reflexivity|]. intros y [<-|Iy]; [right; lra|]. destruct (M y Iy) as [H|[H H']]; [left|right]; lra.
        -- exists x. split; [right; exact I|]. intros y [<-|Iy]; [right; lra|exact (M y Iy)].
      * exists x. split; [right; exact I|]. intros y [<-|Iy]; [left; lra|exact (M y Iy)].
Qed.

(* A spoke: the arc of an edge about a generator, from its first circle to its last, and the slope there of the neighbour
   that comes next. *)
Record spoke := Spoke { first : vec; last : vec; rise : R }.
Definition on_arc (s : spoke) (v : vec) : Prop := v = first s \/ v = last s \/ (first s <> last s /\ 0 <= chord (first s) (last s) v).

Lemma vec_dec (u v : vec) : u = v \/ u <> v.
Proof.
  destruct u as [a b], v as [c d]. destruct (Req_dec a c) as [->|N]; [|right; congruence].
  destruct (Req_dec b d) as [->|N]; [left; reflexivity|right; congruence].
Qed.

Theorem cover (spokes : list spoke) : spokes <> [] -> (forall s, In s spokes -> unit (first s) /\ unit (last s)) ->
  (forall s, In s spokes -> exists t, In t spokes /\ first t = last s /\ (first t = last t -> rise s < rise t)) ->
  forall v, unit v -> exists s, In s spokes /\ on_arc s v.
Proof.
  intros NE U Next v Uv.
  destruct (least_of (fun s => key v (last s)) rise spokes NE) as (s & I & M).
  destruct (Next s I) as (t & It & E & Rise). destruct (U t It) as [U1 U2].
  destruct (vec_dec v (first t)) as [->|N1]; [exists t; split; [exact It|left; reflexivity]|].
  destruct (vec_dec v (last t)) as [->|N2]; [exists t; split; [exact It|right; left; reflexivity]|].
  destruct (vec_dec (first t) (last t)) as [Z|Z].
  - exfalso. specialize (Rise Z). rewrite Z in E. destruct (M t It) as [H|[H H']]; rewrite E in *; lra.
  - exists t. split; [exact It|]. right; right. split; [exact Z|]. apply Rnot_lt_le. intros C.
    rewrite (chord_key v (first t) (last t) Uv U1 U2) in C by congruence.
    pose proof (not_one v (first t) Uv U1 ltac:(congruence)) as P1. pose proof (not_one v (last t) Uv U2 ltac:(congruence)) as P2.
    assert (K : key v (last t) < key v (first t)).
    { apply Rnot_le_lt. intros K. assert (0 <= (1 - dot v (first t)) * (1 - dot v (last t))) by (apply Rmult_le_pos; lra).
      assert (0 <= (1 - dot v (first t)) * (1 - dot v (last t)) * (key v (last t) - key v (first t))) by (apply Rmult_le_pos; lra). lra. }
    rewrite E in K. destruct (M t It) as [H|[H H']]; lra.
Qed.

(* The walk: [ccw] is the cyclic order of the contacts of the generators T on one circle, [at_circle a b c] the sides of
   the vertices there, [clear a b c g]: near the instant the circle of the vertex stays empty of g. *)
Section Walk.
  Variable gen : Type.
  Variable gen_dec : forall a b : gen, {a = b} + {a <> b}.
  Variable T : list gen.
  Variable ccw : gen -> gen -> gen -> Prop.
  Hypothesis ccw_dec : forall a b c, {ccw a b c} + {~ ccw a b c}.
  Hypothesis ccw_turn : forall a b c, ccw a b c -> ccw b c a.
  Hypothesis ccw_not : forall a b c, ccw a b c -> ~ ccw a c b.
  Hypothesis ccw_total : forall a b c, In a T -> In b T -> In c T -> a <> b -> b <> c -> a <> c -> ccw a b c \/ ccw a c b.
  Hypothesis ccw_trans : forall a b c d, ccw a b c -> ccw a c d -> ccw a b d.
  Variable side : gen -> gen -> gen -> Prop.
  Hypothesis side_in : forall a b c, side a b c -> In a T /\ In b T /\ In c T /\ ccw a b c.
  Hypothesis side_turn : forall a b c, side a b c -> side b c a.
  Variable clear : gen -> gen -> gen -> gen -> Prop.
  Hypothesis clear_turn : forall a b c g, clear a b c g -> clear b c a g.
  Hypothesis step : forall a b c g, side b c a -> In g T -> ccw b g c ->
    exists s, side b s c /\ (s = g \/ clear b s c g -> clear b c a g).

  Definition beyond (b c : gen) : list gen := filter (fun h => if ccw_dec b h c then true else false) T.

  Lemma distinct a b c : ccw a b c -> a <> b /\ b <> c /\ a <> c.
  Proof.
    intros H. repeat split; intros ->.
    - apply ccw_turn, ccw_turn in H. exact (ccw_not _ _ _ H H).
    - exact (ccw_not _ _ _ H H).
    - apply ccw_turn in H. exact (ccw_not _ _ _ H H).
  Qed.

  Lemma fewer (l : list gen) (f g : gen -> bool) x : (forall h, f h = true -> g h = true) -> In x l -> f x = false -> g x = true ->
    (length (filter f l) < length (filter g l))%nat.
  Proof.
    intros S. induction l as [|a l IH]; simpl; [tauto|]. intros I Fx Gx.
    assert (W : (length (filter f l) <= length (filter g l))%nat).
    { clear - S. induction l as [|b l IH]; simpl; [lia|]. destruct (f b) eqn:E; [rewrite (S b E); simpl; lia|]. destruct (g b); simpl; lia. }
    destruct I as [->|I].
    - rewrite Fx, Gx. simpl. lia.
    - specialize (IH I Fx Gx). destruct (f a) eqn:E; [rewrite (S a E); simpl; lia|]. destruct (g a); simpl; lia.
  Qed.

  Lemma walk_side n : forall a b c g, (length (beyond b c) < n)%nat -> side b c a -> In g T -> ccw b g c -> clear b c a g.
  Proof.
    induction n as [|n IH]; [lia|]. intros a b c g L S I C.
    destruct (step a b c g S I C) as (s & S' & St). destruct (gen_dec s g) as [->|N]; [apply St; left; reflexivity|]. apply St. right.
    destruct (side_in _ _ _ S') as (Ib & Is & Ic & Cs).
    destruct (distinct _ _ _ Cs) as (D1 & D2 & D3). destruct (distinct _ _ _ C) as (D4 & D5 & _).
    assert (Lt : forall x y, (forall h, ccw x h y -> ccw b h c) -> ~ ccw x s y -> (length (beyond x y) < n)%nat).
    { intros x y Sub Not. assert (length (beyond x y) < length (beyond b c))%nat; [|lia]. apply (fewer T _ _ s); [|exact Is| |].
      - intros h. destruct (ccw_dec x h y); [|discriminate]. destruct (ccw_dec b h c) as [|X]; [reflexivity|]. destruct X. apply Sub. assumption.
      - destruct (ccw_dec x s y); [contradiction|reflexivity].
      - destruct (ccw_dec b s c); [reflexivity|contradiction]. }
    destruct (ccw_total b g s) as [G|G]; try assumption; try congruence.
    - (* g beyond the side (b,s) *)
      apply (IH c b s g); try assumption.
      + apply Lt; [|intros H; destruct (distinct _ _ _ H) as (_ & X & _); congruence].
        intros h Hh. exact (ccw_trans _ _ _ _ Hh Cs).
    - (* g beyond the side (s,c) *)
      assert (G2 : ccw s g c).
      { destruct (ccw_total s g c) as [X|X]; try assumption; try congruence. exfalso.
        apply ccw_turn, ccw_turn in X. apply ccw_turn in C. pose proof (ccw_trans _ _ _ _ X C) as Y.
        apply ccw_turn, ccw_turn in G. exact (ccw_not _ _ _ Y G). }
      apply clear_turn, clear_turn, clear_turn. apply clear_turn. apply clear_turn. apply (IH b s c g); try assumption.
      + apply Lt; [|intros H; destruct (distinct _ _ _ H) as (X & _); congruence].
        intros h Hh. apply ccw_turn, ccw_turn in Hh. apply ccw_turn, ccw_turn in Cs. apply ccw_turn. exact (ccw_trans _ _ _ _ Cs Hh).
      + apply side_turn. exact S'.
  Qed.
End Walk.

