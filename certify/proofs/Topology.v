(* The diagrams that the claims allow at a time: of the flips whose brackets hold it, each is over, or not. Their edges fit together. *)
From Coq Require Import ZArith Reals Lra Lia List Bool PArith FMapPositive.
From Voroproof Require Import Geometry History Arc Spread Envelope.
Import ListNotations.
Open Scope R_scope.

Section Topology.
  Variable P : problem.

  Local Notation allowed := (History.allowed P).
  Definition numbers : list positive := map fst (PositiveMap.elements (edges P)).

  (* What the checker knows of names. *)
  Record tracked (past : list claim) : Prop := {
    own_name : forall later earlier t f lo hi k0 k1 k2 k3 k4 u q, past = later ++ Flip t f lo hi k0 k1 k2 k3 k4 :: earlier ->
      IZR lo <= u -> In q (names_at P k0 earlier u) -> q = f \/ q = reversed f;
    five : forall later earlier t f lo hi k0 k1 k2 k3 k4, past = later ++ Flip t f lo hi k0 k1 k2 k3 k4 :: earlier ->
      NoDup [k0; k1; k2; k3; k4] /\ forall k, In k [k0; k1; k2; k3; k4] -> PositiveMap.find k (edges P) <> None;
    distinct_four : forall later earlier t f lo hi k0 k1 k2 k3 k4, past = later ++ Flip t f lo hi k0 k1 k2 k3 k4 :: earlier ->
      el f <> er f /\ el f <> es f /\ el f <> ee f /\ er f <> es f /\ er f <> ee f;
    ordered : forall later earlier t f lo hi k0 k1 k2 k3 k4, past = later ++ Flip t f lo hi k0 k1 k2 k3 k4 :: earlier -> (lo <= hi)%Z;
    alone : forall later middle earlier c c' k lo hi lo' hi', past = later ++ c' :: middle ++ c :: earlier -> own k c = true \/ own k c' = true ->
      bracket_of k c = Some (lo, hi) -> bracket_of k c' = Some (lo', hi') -> (hi <= lo')%Z;
    can_rename : forall later c earlier k lo hi u q, past = later ++ c :: earlier -> bracket_of k c = Some (lo, hi) ->
      IZR lo <= u -> In q (names_at P k earlier u) -> after_flip k c q <> None
  }.

  (* The initial diagram: each side once, each vertex closed, each generator there. *)
  Record first_fits (gens : list gen) : Prop := {
    once : forall k k' q q' a b c, PositiveMap.find k (edges P) = Some q -> PositiveMap.find k' (edges P) = Some q' ->
      side_of q a b c -> side_of q' a b c -> k = k';
    closed_sides : forall k q a b c, PositiveMap.find k (edges P) = Some q -> side_of q a b c ->
      exists k' q', PositiveMap.find k' (edges P) = Some q' /\ side_of q' b c a;
    proper_edges : forall k q, PositiveMap.find k (edges P) = Some q -> el q <> er q;
    one_each : forall g, In g gens -> exists k q, PositiveMap.find k (edges P) = Some q /\ (el q = g \/ er q = g);
    in_list : forall k q g, PositiveMap.find k (edges P) = Some q -> In g [el q; er q; es q; ee q] -> In g gens
  }.

  (* A flip leaves the edges that it does not name. *)
  Lemma not_named k c q : bracket_of k c = None -> after_flip k c q = Some q.
  Proof.
    destruct c as [t f lo hi k0 k1 k2 k3 k4| |]; try reflexivity. cbn [bracket_of after_flip own corner].
    destruct (Pos.eqb k k0), (Pos.eqb k k1), (Pos.eqb k k2), (Pos.eqb k k3), (Pos.eqb k k4); cbn [orb]; try discriminate. reflexivity.
  Qed.

  Lemma renamed_of c D D' k q' : renames c D D' -> In (k, q') D' -> exists q, In (k, q) D /\ after_flip k c q = Some q'.
  Proof.
    unfold renames. induction 1 as [|[m p] [m' p'] D D' [E A] _ IH]; [contradiction|]. cbn [fst snd] in E, A. subst m'. intros [I|I].
    - injection I as -> ->. exists p. split; [left; reflexivity|exact A].
    - destruct (IH I) as (q & Iq & B). exists q. split; [right; exact Iq|exact B].
  Qed.

  Lemma renamed_to c D D' k q : renames c D D' -> In (k, q) D -> exists q', In (k, q') D' /\ after_flip k c q = Some q'.
  Proof.
    unfold renames. induction 1 as [|[m p] [m' p'] D D' [E A] _ IH]; [contradiction|]. cbn [fst snd] in E, A. subst m'. intros [I|I].
    - injection I as -> ->. exists p'. split; [left; reflexivity|exact A].
    - destruct (IH I) as (q' & Iq & B). exists q'. split; [right; exact Iq|exact B].
  Qed.

  Theorem allowed_names past t D k q : allowed past t D -> In (k, q) D -> In q (names_at P k past t).
  Proof.
    intros A. revert k q. induction A as [t|c past t D Late A IH|c past t D D' Soon A IH Re]; intros k q I.
    - apply PositiveMap.elements_complete in I. cbn [names_at last_edge]. rewrite I. left. reflexivity.
    - specialize (IH k q I). cbn [names_at]. destruct (bracket_of k c) as [[lo hi]|] eqn:B; [|exact IH]. specialize (Late k lo hi B).
      destruct (Rle_dec (IZR hi) t); [lra|]. destruct (Rle_dec (IZR lo) t); [apply in_or_app; right|]; exact IH.
    - destruct (renamed_of _ _ _ _ _ Re I) as (p & Ip & F). specialize (IH k p Ip). cbn [names_at].
      destruct (bracket_of k c) as [[lo hi]|] eqn:B.
      + specialize (Soon k lo hi B). assert (R : In q (renamed k c (names_at P k past t))).
        { unfold renamed. apply in_flat_map. exists p. split; [exact IH|]. rewrite F. left. reflexivity. }
        destruct (Rle_dec (IZR hi) t); [exact R|]. destruct (Rle_dec (IZR lo) t); [|contradiction]. apply in_or_app. left. exact R.
      + rewrite (not_named k c p B) in F. injection F as <-. exact IH.
  Qed.

  Lemma renames_numbers c D D' : renames c D D' -> map fst D' = map fst D.
  Proof. unfold renames. induction 1 as [|p p' D D' [E _] _ IH]; [reflexivity|]. cbn [map]. rewrite E, IH. reflexivity. Qed.

  Theorem allowed_numbers past t D : allowed past t D -> map fst D = numbers.
  Proof.
    induction 1 as [t|c past t D _ _ IH|c past t D D' _ _ IH Re]; [reflexivity|exact IH|]. rewrite (renames_numbers _ _ _ Re). exact IH.
  Qed.

  Lemma numbers_once : NoDup numbers.
  Proof.
    unfold numbers. pose proof (PositiveMap.elements_3w (edges P)) as N. induction N as [|[k q] L Out _ IH]; [constructor|].
    cbn [map fst]. constructor; [|exact IH]. intros I. apply Out. apply in_map_iff in I as ([k' q'] & E & I). cbn [fst] in E. subst k'.
    apply SetoidList.InA_alt. exists (k, q'). split; [reflexivity|exact I].
  Qed.

  Lemma number_found k : PositiveMap.find k (edges P) <> None -> In k numbers.
  Proof.
    destruct (PositiveMap.find k (edges P)) as [q|] eqn:F; [intros _|contradiction]. unfold numbers. apply in_map_iff. exists (k, q).
    split; [reflexivity|apply PositiveMap.elements_correct, F].
  Qed.

  Lemma in_diagram past t D k : allowed past t D -> In k numbers -> exists q, In (k, q) D.
  Proof.
    intros A I. rewrite <- (allowed_numbers past t D A) in I. apply in_map_iff in I as ([m q] & E & I). cbn [fst] in E. subst m. exists q. exact I.
  Qed.

  (* The half-edges of a diagram with a side, counted. *)
  Definition half_edge (x y z a b c : gen) : Z := if Pos.eqb x a && Pos.eqb y b && Pos.eqb z c then 1%Z else 0%Z.
  Definition weight (a b c : gen) (q : edge) : Z := (half_edge (el q) (er q) (ee q) a b c + half_edge (er q) (el q) (es q) a b c)%Z.
  Definition total (w : positive * edge -> Z) (D : diagram) : Z := fold_right (fun p n => (w p + n)%Z) 0%Z D.
  Definition count (D : diagram) (a b c : gen) : Z := total (fun p => weight a b c (snd p)) D.
  Definition balanced (D : diagram) : Prop := forall a b c, count D a b c = count D b c a.

  Lemma one_turns x y z a b c : half_edge x y z b c a = half_edge z x y a b c.
  Proof. unfold half_edge. destruct (Pos.eqb x b), (Pos.eqb y c), (Pos.eqb z a); reflexivity. Qed.

  Lemma one_same x y z a b c : half_edge x y z a b c = 0%Z \/ half_edge x y z a b c = 1%Z /\ x = a /\ y = b /\ z = c.
  Proof.
    unfold half_edge. destruct (Pos.eqb_spec x a); [|left; reflexivity]. destruct (Pos.eqb_spec y b); [|left; reflexivity].
    destruct (Pos.eqb_spec z c); [|left; reflexivity]. right. repeat split; assumption.
  Qed.

  Lemma one_is a b c : half_edge a b c a b c = 1%Z.
  Proof. unfold half_edge. rewrite !Pos.eqb_refl. reflexivity. Qed.

  Lemma weight_not_negative a b c q : (0 <= weight a b c q)%Z.
  Proof.
    unfold weight. destruct (one_same (el q) (er q) (ee q) a b c) as [->|[-> _]], (one_same (er q) (el q) (es q) a b c) as [->|[-> _]]; lia.
  Qed.

  Lemma weight_side a b c q : (0 < weight a b c q)%Z <-> side_of q a b c.
  Proof.
    unfold weight, side_of. split.
    - destruct (one_same (el q) (er q) (ee q) a b c) as [->|(-> & <- & <- & <-)]; [|intros _; left; repeat split].
      destruct (one_same (er q) (el q) (es q) a b c) as [->|(-> & <- & <- & <-)]; [lia|intros _; right; repeat split].
    - intros [(-> & -> & ->)|(-> & -> & ->)]; rewrite one_is.
      + destruct (one_same (er q) (el q) (es q) (el q) (er q) (ee q)) as [->|[-> _]]; lia.
      + destruct (one_same (el q) (er q) (ee q) (er q) (el q) (es q)) as [->|[-> _]]; lia.
  Qed.

  Lemma weight_at_most_one a b c q : el q <> er q -> (weight a b c q <= 1)%Z.
  Proof.
    intros N. unfold weight. destruct (one_same (el q) (er q) (ee q) a b c) as [->|(-> & E & _)], (one_same (er q) (el q) (es q) a b c) as [->|(-> & E' & _)]; lia.
  Qed.

  Lemma count_side D a b c : (0 < count D a b c)%Z <-> exists k q, In (k, q) D /\ side_of q a b c.
  Proof.
    unfold count. induction D as [|[k q] D IH]; cbn [total fold_right snd].
    - split; [lia|]. intros (k & q & [] & _).
    - fold (total (fun p => weight a b c (snd p)) D). pose proof (weight_not_negative a b c q) as W.
      assert (T : (0 <= total (fun p => weight a b c (snd p)) D)%Z).
      { clear. induction D as [|[k q] D IH]; cbn [total fold_right snd]; [lia|]. pose proof (weight_not_negative a b c q). unfold total in IH. lia. }
      split.
      + intros S. destruct (Z.eq_dec (weight a b c q) 0) as [E|E].
        * assert (S' : (0 < total (fun p => weight a b c (snd p)) D)%Z) by lia. apply IH in S' as (m & p & I & S'). exists m, p. split; [right; exact I|exact S'].
        * exists k, q. split; [left; reflexivity|]. apply weight_side. lia.
      + intros (m & p & [I|I] & S).
        * injection I as -> ->. apply weight_side in S. lia.
        * assert (S' : (0 < total (fun p => weight a b c (snd p)) D)%Z) by (apply IH; exists m, p; split; assumption). lia.
  Qed.

  (* Where each side occurs at most once, it is counted at most once. *)
  Lemma count_at_most_one D a b c : NoDup (map fst D) -> (forall k q, In (k, q) D -> el q <> er q) ->
    (forall k k' q q', In (k, q) D -> In (k', q') D -> side_of q a b c -> side_of q' a b c -> k = k') -> (count D a b c <= 1)%Z.
  Proof.
    intros N Proper Once. induction D as [|[k q] D IH]; [unfold count; cbn; lia|].
    change (count ((k, q) :: D) a b c) with (weight a b c q + count D a b c)%Z. cbn [map fst] in N. apply NoDup_cons_iff in N as [Out N].
    assert (C : (count D a b c <= 1)%Z).
    { apply IH; [exact N| |].
      - intros m p I. apply (Proper m). right. exact I.
      - intros m m' p p' I I'. apply (Once m m' p p'); right; assumption. }
    assert (W : (weight a b c q <= 1)%Z) by (apply weight_at_most_one, (Proper k); left; reflexivity).
    destruct (Z_lt_le_dec 0 (weight a b c q)) as [S|S]; [|lia]. destruct (Z_lt_le_dec 0 (count D a b c)) as [S'|S']; [|lia].
    exfalso. apply weight_side in S. apply count_side in S' as (m & p & I & S'). apply Out.
    rewrite (Once k m q p); [|left; reflexivity|right; exact I|exact S|exact S']. apply in_map_iff. exists (m, p). split; [reflexivity|exact I].
  Qed.

  Lemma count_not_negative D a b c : (0 <= count D a b c)%Z.
  Proof.
    unfold count. induction D as [|[k q] D IH]; cbn [total fold_right snd]; [lia|]. pose proof (weight_not_negative a b c q). unfold total in IH. lia.
  Qed.

  Lemma start_balanced gens : first_fits gens -> balanced (PositiveMap.elements (edges P)).
  Proof.
    intros F. set (D := PositiveMap.elements (edges P)).
    assert (Find : forall k q, In (k, q) D -> PositiveMap.find k (edges P) = Some q) by (intros; apply PositiveMap.elements_complete; assumption).
    assert (Most : forall a b c, (count D a b c <= 1)%Z).
    { intros a b c. apply count_at_most_one; [exact numbers_once| |].
      - intros k q I. apply (proper_edges _ F k), Find, I.
      - intros k k' q q' I I' S S'. apply (once _ F k k' q q' a b c); try (apply Find; assumption); assumption. }
    assert (Next : forall a b c, (0 < count D a b c -> 0 < count D b c a)%Z).
    { intros a b c C. apply count_side in C as (k & q & I & S). destruct (closed_sides _ F k q a b c (Find k q I) S) as (k' & q' & I' & S').
      apply count_side. exists k', q'. split; [apply PositiveMap.elements_correct, I'|exact S']. }
    intros a b c. pose proof (Most a b c). pose proof (Most b c a). pose proof (count_not_negative D a b c). pose proof (count_not_negative D b c a).
    destruct (Z_lt_le_dec 0 (count D a b c)) as [C|C]; [pose proof (Next a b c C); lia|].
    destruct (Z_lt_le_dec 0 (count D b c a)) as [C'|C']; [|lia]. apply Next, Next in C'. lia.
  Qed.

  (* What a flip changes in the count: the sum over its five edges. *)
  Section Flipped.
    Variables (t lo hi : Z) (f : edge) (k0 k1 k2 k3 k4 : positive).
    Let c := Flip t f lo hi k0 k1 k2 k3 k4.
    Variables x y z : gen.
    Let is a b d := half_edge a b d x y z.

    Definition gain0 : Z := (is (es f) (ee f) (el f) + is (ee f) (es f) (er f) - is (el f) (er f) (ee f) - is (er f) (el f) (es f))%Z.
    Definition gain1 : Z := (is (el f) (es f) (ee f) - is (el f) (es f) (er f))%Z.
    Definition gain2 : Z := (is (es f) (er f) (ee f) - is (es f) (er f) (el f))%Z.
    Definition gain3 : Z := (is (er f) (ee f) (es f) - is (er f) (ee f) (el f))%Z.
    Definition gain4 : Z := (is (ee f) (el f) (es f) - is (ee f) (el f) (er f))%Z.
    Definition only_at (k : positive) (n : Z) (m : positive) : Z := if Pos.eqb m k then n else 0%Z.
    Definition gain (k : positive) : Z := (only_at k0 gain0 k + only_at k1 gain1 k + only_at k2 gain2 k + only_at k3 gain3 k + only_at k4 gain4 k)%Z.

    Lemma beside_weight a b d e q q' : beside a b d e q = Some q' -> weight x y z q' = (weight x y z q + (is a b e - is a b d))%Z.
    Proof.
      unfold beside, weight, is. destruct q as [l r s g]; cbn [el er es ee].
      destruct (Pos.eqb_spec l a) as [A|_], (Pos.eqb_spec r b) as [B|_], (Pos.eqb_spec g d) as [G|_]; cbn [andb];
        try (intros E; injection E as <-; subst; cbn [el er es ee]; lia);
        destruct (Pos.eqb_spec l b) as [B'|_], (Pos.eqb_spec r a) as [A'|_], (Pos.eqb_spec s d) as [G'|_]; cbn [andb]; try discriminate;
        intros E; injection E as <-; subst; cbn [el er es ee]; lia.
    Qed.

    Lemma weight_changes k q q' : NoDup [k0; k1; k2; k3; k4] -> (k = k0 -> q = f \/ q = reversed f) -> after_flip k c q = Some q' ->
      weight x y z q' = (weight x y z q + gain k)%Z.
    Proof.
      intros N Own A. unfold c in A. cbn [after_flip own corner] in A. unfold gain, only_at.
      assert (k0 <> k1 /\ k0 <> k2 /\ k0 <> k3 /\ k0 <> k4 /\ k1 <> k2 /\ k1 <> k3 /\ k1 <> k4 /\ k2 <> k3 /\ k2 <> k4 /\ k3 <> k4) as Apart.
      { repeat match goal with H : NoDup (_ :: _) |- _ => apply NoDup_cons_iff in H as [? ?] end. cbn [In] in *. intuition congruence. }
      clear N. destruct (Pos.eqb_spec k k0) as [E0|E0].
      - subst k. destruct (Pos.eqb_spec k0 k1); [tauto|]. destruct (Pos.eqb_spec k0 k2); [tauto|]. destruct (Pos.eqb_spec k0 k3); [tauto|].
        destruct (Pos.eqb_spec k0 k4); [tauto|]. injection A as <-. unfold gain0, weight, is. cbn [el er es ee].
        destruct (Own eq_refl) as [->| ->]; cbn [reversed el er es ee]; lia.
      - clear Own. destruct (Pos.eqb_spec k k1) as [E1|E1].
        { subst k. destruct (Pos.eqb_spec k1 k2); [tauto|]. destruct (Pos.eqb_spec k1 k3); [tauto|]. destruct (Pos.eqb_spec k1 k4); [tauto|].
          rewrite (beside_weight _ _ _ _ _ _ A). unfold gain1. lia. }
        destruct (Pos.eqb_spec k k2) as [E2|E2].
        { subst k. destruct (Pos.eqb_spec k2 k3); [tauto|]. destruct (Pos.eqb_spec k2 k4); [tauto|].
          rewrite (beside_weight _ _ _ _ _ _ A). unfold gain2. lia. }
        destruct (Pos.eqb_spec k k3) as [E3|E3].
        { subst k. destruct (Pos.eqb_spec k3 k4); [tauto|]. rewrite (beside_weight _ _ _ _ _ _ A). unfold gain3. lia. }
        destruct (Pos.eqb_spec k k4) as [E4|E4]; [rewrite (beside_weight _ _ _ _ _ _ A); unfold gain4; lia|].
        injection A as <-. lia.
    Qed.

    Definition sum_over (g : positive -> Z) (L : list positive) : Z := fold_right (fun k n => (g k + n)%Z) 0%Z L.

    Lemma sum_nowhere k n L : ~ In k L -> sum_over (only_at k n) L = 0%Z.
    Proof.
      induction L as [|m L IH]; intros N; [reflexivity|]. unfold sum_over in *. cbn [fold_right]. cbn [In] in N. rewrite IH by tauto. unfold only_at.
      destruct (Pos.eqb_spec m k); [tauto|lia].
    Qed.

    Lemma sum_where k n L : NoDup L -> In k L -> sum_over (only_at k n) L = n.
    Proof.
      induction L as [|m L IH]; intros N I; [contradiction|]. apply NoDup_cons_iff in N as [Out N].
      change (sum_over (only_at k n) (m :: L)) with (only_at k n m + sum_over (only_at k n) L)%Z. destruct (Pos.eq_dec m k) as [->|Other].
      - rewrite sum_nowhere by exact Out. unfold only_at. rewrite Pos.eqb_refl. lia.
      - destruct I as [E|I]; [contradiction|]. rewrite IH by assumption. unfold only_at. destruct (Pos.eqb_spec m k); [contradiction|lia].
    Qed.

    Lemma sum_gain L : NoDup L -> (forall k, In k [k0; k1; k2; k3; k4] -> In k L) -> sum_over gain L = (gain0 + gain1 + gain2 + gain3 + gain4)%Z.
    Proof.
      intros N I. rewrite <- (sum_where k0 gain0 L), <- (sum_where k1 gain1 L), <- (sum_where k2 gain2 L), <- (sum_where k3 gain3 L), <- (sum_where k4 gain4 L)
        by (try exact N; apply I; cbn [In]; tauto).
      clear. unfold sum_over, gain. induction L as [|m L IH]; cbn [fold_right]; [reflexivity|]. rewrite IH. lia.
    Qed.

    Lemma count_changes D D' : NoDup [k0; k1; k2; k3; k4] -> (forall q, In (k0, q) D -> q = f \/ q = reversed f) -> renames c D D' ->
      count D' x y z = (count D x y z + sum_over gain (map fst D))%Z.
    Proof.
      intros N Own Re. unfold renames in Re. induction Re as [|[k q] [k' q'] D D' [E A] _ IH]; [reflexivity|]. cbn [fst snd] in E, A. subst k'.
      change (count ((k, q') :: D') x y z) with (weight x y z q' + count D' x y z)%Z. change (count ((k, q) :: D) x y z) with (weight x y z q + count D x y z)%Z.
      cbn [map fst]. change (sum_over gain (k :: map fst D)) with (gain k + sum_over gain (map fst D))%Z.
      rewrite (weight_changes k q q' N) by (try exact A; intros ->; apply Own; left; reflexivity).
      rewrite IH by (intros p I; apply Own; right; exact I). lia.
    Qed.
  End Flipped.

  Lemma gain_turns f a b c : (gain0 f a b c + gain1 f a b c + gain2 f a b c + gain3 f a b c + gain4 f a b c =
    gain0 f b c a + gain1 f b c a + gain2 f b c a + gain3 f b c a + gain4 f b c a)%Z.
  Proof. unfold gain0, gain1, gain2, gain3, gain4. rewrite !(one_turns _ _ _ a b c). lia. Qed.

  Lemma flip_balanced t f lo hi k0 k1 k2 k3 k4 D D' : NoDup [k0; k1; k2; k3; k4] -> (forall k, In k [k0; k1; k2; k3; k4] -> In k numbers) ->
    map fst D = numbers -> (forall q, In (k0, q) D -> q = f \/ q = reversed f) -> renames (Flip t f lo hi k0 k1 k2 k3 k4) D D' -> balanced D -> balanced D'.
  Proof.
    intros N All M Own Re B a b c. rewrite (count_changes t lo hi f k0 k1 k2 k3 k4 a b c D D' N Own Re), (count_changes t lo hi f k0 k1 k2 k3 k4 b c a D D' N Own Re), M.
    rewrite !sum_gain by (try exact numbers_once; exact All). rewrite (B a b c), (gain_turns f a b c). reflexivity.
  Qed.

  (* Beside the edge itself, names keep their two generators. *)
  Lemma beside_keeps a b c d q q' : beside a b c d q = Some q' -> el q' = el q /\ er q' = er q /\ (el q = a /\ er q = b \/ el q = b /\ er q = a) /\
    (forall g, In g [el q'; er q'; es q'; ee q'] -> g = d \/ In g [el q; er q; es q; ee q]).
  Proof.
    unfold beside. destruct (Pos.eqb_spec (el q) a) as [A|_], (Pos.eqb_spec (er q) b) as [B|_], (Pos.eqb_spec (ee q) c) as [G|_]; cbn [andb];
      try (intros E; injection E as <-; cbn [el er es ee In]; rewrite A, B; intuition congruence);
      destruct (Pos.eqb_spec (el q) b) as [B'|_], (Pos.eqb_spec (er q) a) as [A'|_], (Pos.eqb_spec (es q) c) as [G'|_]; cbn [andb]; try discriminate;
      intros E; injection E as <-; cbn [el er es ee In]; rewrite A', B'; intuition congruence.
  Qed.

  Lemma other_keeps t f lo hi k0 k1 k2 k3 k4 k q q' : k <> k0 -> after_flip k (Flip t f lo hi k0 k1 k2 k3 k4) q = Some q' ->
    el q' = el q /\ er q' = er q /\ (forall g, In g [el q'; er q'; es q'; ee q'] -> In g [el f; er f; es f; ee f] \/ In g [el q; er q; es q; ee q]).
  Proof.
    intros N A. cbn [after_flip own corner] in A. destruct (Pos.eqb_spec k k0); [contradiction|].
    destruct (Pos.eqb k k1); [|destruct (Pos.eqb k k2); [|destruct (Pos.eqb k k3); [|destruct (Pos.eqb k k4)]]];
      try (apply beside_keeps in A as (L & R & _ & I); repeat split; try assumption; intros g G; destruct (I g G) as [->|G']; [left; cbn [In]; tauto|right; exact G']).
    injection A as <-. repeat split. intros g G. right. exact G.
  Qed.

  Lemma no_flip c D D' : (forall k, bracket_of k c = None) -> renames c D D' -> D' = D.
  Proof.
    intros N. unfold renames. induction 1 as [|[k q] [k' q'] D D' [E A] _ IH]; [reflexivity|]. cbn [fst snd] in E, A. subst k'.
    rewrite (not_named k c q (N k)) in A. injection A as <-. rewrite IH. reflexivity.
  Qed.

  Definition fits_so_far (gens : list gen) (D : diagram) : Prop :=
    balanced D /\ (forall g, In g gens -> exists k q, In (k, q) D /\ (el q = g \/ er q = g)) /\
    (forall k q g, In (k, q) D -> In g [el q; er q; es q; ee q] -> In g gens).

  Lemma flip_fits gens t f lo hi k0 k1 k2 k3 k4 D D' : NoDup [k0; k1; k2; k3; k4] -> (forall k, In k [k0; k1; k2; k3; k4] -> In k numbers) ->
    map fst D = numbers -> (forall q, In (k0, q) D -> q = f \/ q = reversed f) -> renames (Flip t f lo hi k0 k1 k2 k3 k4) D D' ->
    fits_so_far gens D -> fits_so_far gens D'.
  Proof.
    intros N All M Own Re (B & Each & Names). set (c := Flip t f lo hi k0 k1 k2 k3 k4) in *.
    assert (There : forall k, In k [k0; k1; k2; k3; k4] -> exists q q', In (k, q) D /\ In (k, q') D' /\ after_flip k c q = Some q').
    { intros k I. apply All in I. rewrite <- M in I. apply in_map_iff in I as ([m q] & E & I). cbn [fst] in E. subst m.
      destruct (renamed_to _ _ _ _ _ Re I) as (q' & I' & A). exists q, q'. repeat split; assumption. }
    assert (Four : forall g, In g [el f; er f; es f; ee f] -> In g gens).
    { intros g G. destruct (There k0) as (q & q' & I & _ & _); [left; reflexivity|]. apply (Names k0 q); [exact I|].
      destruct (Own q I) as [->| ->]; cbn [reversed el er es ee In] in *; tauto. }
    assert (k1 <> k0 /\ k2 <> k0 /\ k2 <> k1) as (N1 & N2 & N3).
    { repeat match goal with H : NoDup (_ :: _) |- _ => apply NoDup_cons_iff in H as [? ?] end. cbn [In] in *. intuition congruence. }
    split; [apply (flip_balanced t f lo hi k0 k1 k2 k3 k4 D D'); assumption|]. split.
    - intros g G. destruct (Each g G) as (k & q & I & Ends). destruct (Pos.eq_dec k k0) as [->|Other].
      + assert (Lr : g = el f \/ g = er f) by (destruct (Own q I) as [->| ->]; cbn [reversed el er] in Ends; intuition congruence).
        destruct Lr as [->| ->].
        * destruct (There k1) as (p & p' & _ & I' & A); [cbn [In]; tauto|]. exists k1, p'. split; [exact I'|]. unfold c in A. cbn [after_flip own corner] in A.
          destruct (Pos.eqb_spec k1 k0); [contradiction|]. rewrite Pos.eqb_refl in A. apply beside_keeps in A as (-> & -> & L & _). tauto.
        * destruct (There k2) as (p & p' & _ & I' & A); [cbn [In]; tauto|]. exists k2, p'. split; [exact I'|]. unfold c in A. cbn [after_flip own corner] in A.
          destruct (Pos.eqb_spec k2 k0); [contradiction|]. destruct (Pos.eqb_spec k2 k1); [contradiction|]. rewrite Pos.eqb_refl in A.
          apply beside_keeps in A as (-> & -> & L & _). tauto.
      + destruct (renamed_to _ _ _ _ _ Re I) as (q' & I' & A). exists k, q'. split; [exact I'|].
        destruct (other_keeps _ _ _ _ _ _ _ _ _ _ _ _ Other A) as (-> & -> & _). exact Ends.
    - intros k q' g I' G. destruct (renamed_of _ _ _ _ _ Re I') as (q & I & A). destruct (Pos.eq_dec k k0) as [->|Other].
      + unfold c in A. cbn [after_flip own] in A. rewrite Pos.eqb_refl in A. injection A as <-. cbn [el er es ee In] in G. apply Four. cbn [In]. tauto.
      + destruct (other_keeps _ _ _ _ _ _ _ _ _ _ _ _ Other A) as (_ & _ & Few). destruct (Few g G) as [H|H]; [apply Four, H|apply (Names k q); assumption].
  Qed.

  Lemma start_fits gens : first_fits gens -> fits_so_far gens (PositiveMap.elements (edges P)).
  Proof.
    intros F. split; [apply (start_balanced gens F)|]. split.
    - intros g G. destruct (one_each _ F g G) as (k & q & I & Ends). exists k, q. split; [apply PositiveMap.elements_correct, I|exact Ends].
    - intros k q g I G. apply (in_list _ F k q); [apply PositiveMap.elements_complete, I|exact G].
  Qed.

  Lemma all_fit gens later past t D : first_fits gens -> tracked (later ++ past) -> allowed past t D -> fits_so_far gens D.
  Proof.
    intros F T A. revert later T. induction A as [t|c past t D Late A IH|c past t D D' Soon A IH Re]; intros later T.
    - apply start_fits, F.
    - apply (IH (later ++ [c])). rewrite <- app_assoc. exact T.
    - assert (H : fits_so_far gens D) by (apply (IH (later ++ [c])); rewrite <- app_assoc; exact T).
      destruct c as [s f lo hi k0 k1 k2 k3 k4| |].
      + destruct (five _ T later past s f lo hi k0 k1 k2 k3 k4 eq_refl) as [N All].
        apply (flip_fits gens s f lo hi k0 k1 k2 k3 k4 D D'); try assumption.
        * intros k I. apply number_found, All, I.
        * apply (allowed_numbers past t D A).
        * intros q I. apply (own_name _ T later past s f lo hi k0 k1 k2 k3 k4 t q eq_refl).
          -- apply (Soon k0 lo hi). cbn [bracket_of]. rewrite Pos.eqb_refl. reflexivity.
          -- apply (allowed_names past t D); assumption.
      + apply no_flip in Re as ->; [exact H|reflexivity].
      + apply no_flip in Re as ->; [exact H|reflexivity].
  Qed.

  Theorem allowed_fits gens past t D : first_fits gens -> tracked past -> allowed past t D -> fits gens (map snd D).
  Proof.
    intros F T A. destruct (all_fit gens [] past t D F T A) as (B & Each & Names). constructor.
    - intros a b c (q & I & S). apply in_map_iff in I as ([k p] & E & I). cbn [snd] in E. subst p.
      assert (C : (0 < count D a b c)%Z) by (apply count_side; exists k, q; split; assumption). rewrite (B a b c) in C.
      apply count_side in C as (k' & q' & I' & S'). exists q'. split; [|exact S']. apply in_map_iff. exists (k', q'). split; [reflexivity|exact I'].
    - intros g G. destruct (Each g G) as (k & q & I & Ends). exists q. split; [|exact Ends]. apply in_map_iff. exists (k, q). split; [reflexivity|exact I].
    - intros q g I G. apply in_map_iff in I as ([k p] & E & I). cbn [snd] in E. subst p. apply (Names k q g); assumption.
  Qed.

  (* A claim whose brackets have begun can rename all edges. *)
  Lemma all_rename later c earlier u D : tracked (later ++ c :: earlier) -> (forall k lo hi, bracket_of k c = Some (lo, hi) -> IZR lo <= u) ->
    allowed earlier u D -> exists D', renames c D D'.
  Proof.
    intros T Soon A. assert (Can : forall k q, In (k, q) D -> after_flip k c q <> None).
    { intros k q I. destruct (bracket_of k c) as [[lo hi]|] eqn:B; [|rewrite (not_named k c q B); discriminate].
      apply (can_rename _ T later c earlier k lo hi u q eq_refl B); [apply (Soon k lo hi B)|]. apply (allowed_names earlier u D); assumption. }
    clear A. unfold renames. induction D as [|[k q] D IH]; [exists []; constructor|].
    destruct IH as [D' Re]; [intros m p I; apply Can; right; exact I|].
    destruct (after_flip k c q) as [q'|] eqn:E; [|exfalso; apply (Can k q); [left; reflexivity|exact E]].
    exists ((k, q') :: D'). constructor; [|exact Re]. cbn [fst snd]. split; [reflexivity|exact E].
  Qed.

  (* The brackets of a claim all end after t, or all have ended by then. *)
  Lemma one_bracket c t : (forall k lo hi, bracket_of k c = Some (lo, hi) -> t < IZR hi) \/ (forall k lo hi, bracket_of k c = Some (lo, hi) -> IZR hi <= t).
  Proof.
    destruct c as [s f lo hi k0 k1 k2 k3 k4| |]; try (left; discriminate).
    destruct (Rle_dec (IZR hi) t); [right|left]; intros k lo' hi' B; cbn [bracket_of] in B;
      destruct (Pos.eqb k k0 || Pos.eqb k k1 || Pos.eqb k k2 || Pos.eqb k k3 || Pos.eqb k k4); try discriminate; injection B as <- <-; lra.
  Qed.

  Lemma some_suffix later past t : tracked (later ++ past) -> exists D, allowed past t D.
  Proof.
    revert later. induction past as [|c past IH]; intros later T; [eexists; apply at_start|].
    destruct (IH (later ++ [c])) as [D A]; [rewrite <- app_assoc; exact T|].
    destruct (one_bracket c t) as [Late|Over]; [exists D; apply not_over; assumption|].
    assert (Soon : forall k lo hi, bracket_of k c = Some (lo, hi) -> IZR lo <= t).
    { intros k lo hi B. specialize (Over k lo hi B). destruct c as [s f lo' hi' k0 k1 k2 k3 k4| |]; try discriminate. cbn [bracket_of] in B.
      destruct (Pos.eqb k k0 || Pos.eqb k k1 || Pos.eqb k k2 || Pos.eqb k k3 || Pos.eqb k k4); [|discriminate]. injection B as <- <-.
      pose proof (IZR_le _ _ (ordered _ T later past s f lo' hi' k0 k1 k2 k3 k4 eq_refl)). lra. }
    destruct (all_rename later c past t D T Soon A) as [D' Re]. exists D'. apply (already P c past t D); assumption.
  Qed.

  Lemma beside_cases a b x y q p : beside a b x y q = Some p ->
    (exists s, q = Edge a b s x /\ p = Edge a b s y) \/ (exists e, q = Edge b a x e /\ p = Edge b a y e).
  Proof.
    unfold beside. destruct q as [l m s e]; cbn [el er es ee].
    destruct (Pos.eqb_spec l a) as [->|_], (Pos.eqb_spec m b) as [->|_], (Pos.eqb_spec e x) as [->|_]; cbn [andb];
      try (intros E; injection E as <-; left; exists s; split; reflexivity);
      match goal with |- (if Pos.eqb ?g b && Pos.eqb ?h a && _ then _ else _) = _ -> _ =>
        destruct (Pos.eqb_spec g b), (Pos.eqb_spec h a), (Pos.eqb_spec s x); cbn [andb]; try discriminate end;
      intros E; injection E as <-; right; subst; eexists; split; reflexivity.
  Qed.

  Lemma beside_last a b x y s : beside a b x y (Edge a b s x) = Some (Edge a b s y).
  Proof. unfold beside. cbn [el er es ee]. rewrite !Pos.eqb_refl. reflexivity. Qed.

  Lemma beside_first a b x y e : a <> b -> beside a b x y (Edge b a x e) = Some (Edge b a y e).
  Proof. intros N. unfold beside. cbn [el er es ee]. destruct (Pos.eqb_spec b a); [congruence|]. rewrite !Pos.eqb_refl. reflexivity. Qed.

  (* Flips at different ends of an edge commute; at the same end not both can be. *)
  Lemma beside_commute a b x y a' b' x' y' q p p' r : a <> b -> x <> y -> beside a b x y q = Some p -> beside a' b' x' y' q = Some p' ->
    beside a' b' x' y' p = Some r -> beside a b x y p' = Some r.
  Proof.
    intros N Nx A A' R. apply beside_cases in A as [(s & -> & ->)|(e & -> & ->)], A' as [(s' & E & ->)|(e' & E & ->)];
      injection E; intros; subst; apply beside_cases in R as [(s2 & E2 & ->)|(e2 & E2 & ->)]; injection E2; intros; subst; try congruence;
      first [apply beside_last|apply beside_first; congruence].
  Qed.

  Lemma corner_of_bracket k c lo hi : bracket_of k c = Some (lo, hi) -> own k c = false -> exists a b x y, corner k c = Some (a, b, x, y).
  Proof.
    destruct c as [t f lo' hi' k0 k1 k2 k3 k4| |]; try discriminate. cbn [bracket_of own corner]. intros B O. rewrite O in B. cbn [orb] in B.
    destruct (Pos.eqb k k1), (Pos.eqb k k2), (Pos.eqb k k3), (Pos.eqb k k4); cbn [orb] in B; try discriminate; repeat eexists.
  Qed.

  Lemma corner_distinct past later c earlier k a b x y : tracked past -> past = later ++ c :: earlier -> corner k c = Some (a, b, x, y) -> a <> b /\ x <> y.
  Proof.
    intros T E C. destruct c as [t f lo hi k0 k1 k2 k3 k4| |]; try discriminate. cbn [corner] in C.
    destruct (distinct_four _ T later earlier t f lo hi k0 k1 k2 k3 k4 E) as (N1 & N2 & N3 & N4 & N5).
    destruct (Pos.eqb k k1); [|destruct (Pos.eqb k k2); [|destruct (Pos.eqb k k3); [|destruct (Pos.eqb k k4); [|discriminate]]]];
      injection C as <- <- <- <-; split; congruence.
  Qed.

  Lemma after_corner k c a b x y q : own k c = false -> corner k c = Some (a, b, x, y) -> after_flip k c q = beside a b x y q.
  Proof. destruct c as [t f lo hi k0 k1 k2 k3 k4| |]; try discriminate. intros O C. unfold after_flip. rewrite O, C. reflexivity. Qed.

  (* Two claims under way rename each edge in either order. *)
  Lemma names_commute past later c' middle c earlier u k q p p' r : tracked past -> past = later ++ c' :: middle ++ c :: earlier ->
    (forall k lo hi, bracket_of k c = Some (lo, hi) -> u < IZR hi) -> (forall k lo hi, bracket_of k c' = Some (lo, hi) -> IZR lo <= u) ->
    after_flip k c q = Some p -> after_flip k c' q = Some p' -> after_flip k c' p = Some r -> after_flip k c p' = Some r.
  Proof.
    intros T E Late Soon A A' R.
    destruct (bracket_of k c) as [[lo hi]|] eqn:B; [|rewrite (not_named k c q B) in A; rewrite (not_named k c p' B); congruence].
    destruct (bracket_of k c') as [[lo' hi']|] eqn:B'; [|rewrite (not_named k c' q B') in A'; rewrite (not_named k c' p B') in R; congruence].
    specialize (Late k lo hi B). specialize (Soon k lo' hi' B').
    assert (Beside : own k c = false /\ own k c' = false).
    { destruct (own k c) eqn:O, (own k c') eqn:O'; try (split; reflexivity); exfalso;
        assert (Or : own k c = true \/ own k c' = true) by tauto;
        pose proof (IZR_le _ _ (alone _ T later middle earlier c c' k lo hi lo' hi' E Or B B')); lra. }
    destruct Beside as [O O']. destruct (corner_of_bracket k c lo hi B O) as (a & b & x & y & C).
    destruct (corner_of_bracket k c' lo' hi' B' O') as (a' & b' & x' & y' & C').
    assert (E2 : past = (later ++ c' :: middle) ++ c :: earlier) by (rewrite E, <- app_assoc; reflexivity).
    destruct (corner_distinct past _ c earlier k a b x y T E2 C) as [N Nx].
    rewrite (after_corner k c a b x y q O C) in A. rewrite (after_corner k c a b x y p' O C).
    rewrite (after_corner k c' a' b' x' y' q O' C') in A'. rewrite (after_corner k c' a' b' x' y' p O' C') in R.
    apply (beside_commute a b x y a' b' x' y' q p p' r); assumption.
  Qed.

  Lemma renames_commute past later c' middle c earlier u D E D' E' : tracked past -> past = later ++ c' :: middle ++ c :: earlier ->
    (forall k lo hi, bracket_of k c = Some (lo, hi) -> u < IZR hi) -> (forall k lo hi, bracket_of k c' = Some (lo, hi) -> IZR lo <= u) ->
    renames c D E -> renames c' D D' -> renames c' E E' -> renames c D' E'.
  Proof.
    intros T Past Late Soon Re. unfold renames in *. revert D' E'.
    induction Re as [|[k q] [k1 p] D E [F A] _ IH]; intros D' E' Re' Re2; inversion Re' as [|? [k2 p'] ? D2 [F' A'] Re3]; subst;
      inversion Re2 as [|? [k3 r] ? E2 [G R] Re4]; subst; constructor.
    - cbn [fst snd] in *. subst. split; [reflexivity|].
      apply (names_commute _ later c' middle c earlier u k q p p' r T eq_refl Late Soon A A' R).
    - apply IH; assumption.
  Qed.

End Topology.
