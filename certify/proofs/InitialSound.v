(* The check of the initial diagram is sound. *)
From Coq Require Import ZArith List Bool Reals Lra FMapPositive.
From Voroproof Require Import Forms Polynomial Geometry Circle Vertex Piece PieceSound EdgeSound History Replay LifeSound Initial.
Import ListNotations.
Open Scope R_scope.

Lemma not_negative_at_true f x y n root : 0 < root -> 0 < n ->
  IZR x * IZR x - root * root * (IZR y * IZR y) = n * IZR f -> not_negative_at f x y = true -> 0 <= IZR x + root * IZR y.
Proof.
  intros Hr Hn Q H. apply (not_negative_by_f _ _ (IZR f) n _ Hr Hn Q). unfold not_negative_at in H.
  apply orb_prop in H as [H|H]; [apply orb_prop in H as [H|H]|]; apply andb_prop in H as [H1 H2];
    apply Z.leb_le, IZR_le in H1; apply Z.leb_le, IZR_le in H2; tauto.
Qed.

Lemma outside_is w we j k e :
  outside w (dsp Z.sub Z.mul j k) (dxp Z.sub Z.mul j k) (dyp Z.sub Z.mul j k) (dxs Z.sub Z.mul j k) (dys Z.sub Z.mul j k)
    (dxy Z.sub Z.mul j k) we e =
  not_negative_at (z_f (z_a j k e) (z_b j k e) (z_c j k e)) (with_sign we (z_g j k (z_a j k e) (z_b j k e)))
    (with_sign (xorb we w) (z_c j k e)) && (negb we || (rp e <? 0)%Z).
Proof. reflexivity. Qed.

Lemma triple_eqb_true s t : triple_eqb s t = true -> s = t.
Proof.
  destruct s as [[a b] c], t as [[d e] f]. simpl. intros H. apply andb_prop in H as [H H1]. apply andb_prop in H as [H H2].
  apply Pos.eqb_eq in H, H1, H2. congruence.
Qed.

Section Initial.
Variable P : problem.

Lemma still_at b g : PositiveMap.find g (bodies P) = Some b -> at_z (still b g) 0 = place P [] 0 g.
Proof.
  intros F. unfold still. rewrite (span_start P) by (unfold radius_of; rewrite F; reflexivity).
  unfold place. cbn [leg_at last_leg path]. rewrite F. reflexivity.
Qed.

(* o is the circle of the vertex, empty of all. *)
Definition empty_vertex (a b c : gen) : Prop :=
  exists o, vertex_circle o (place P [] 0 a) (place P [] 0 b) (place P [] 0 c) /\
    forall g, PositiveMap.find g (bodies P) <> None -> empty_of o (place P [] 0 g).

Lemma empty_vertex_turn a b c : empty_vertex a b c -> empty_vertex b c a.
Proof. intros (o & V & E). exists o. split; [apply Scale.vertex_turn, V|exact E]. Qed.

Lemma empty_circle_true a b c ba bb bc :
  PositiveMap.find a (bodies P) = Some ba -> PositiveMap.find b (bodies P) = Some bb -> PositiveMap.find c (bodies P) = Some bc ->
  empty_circle (all_still P) (still ba a) (still bb b) (still bc c) = true -> empty_vertex a b c.
Proof.
  intros Fa Fb Fc H. unfold empty_circle in H. cbv zeta in H. apply andb_prop in H as [H All]. apply andb_prop in H as [H C].
  apply andb_prop in H as [Hi Pi]. apply negb_true_iff in Hi.
  set (i := still ba a) in *. set (j := still bb b) in *. set (k := still bc c) in *.
  destruct (there_parts _ _ _ C 0 (Rle_refl 0)) as (W & Rj & Rk & Rjk).
  pose proof (there_gamma _ _ _ C 0 (Rle_refl 0)) as G. pose proof (there_norm _ _ _ C 0 (Rle_refl 0)) as N.
  destruct (vertex_exists (at_z i 0) (at_z j 0) (at_z k 0) Hi W Rj Rk Rjk (there_true _ _ _ C 0 (Rle_refl 0))) as (o & V & E).
  exists o. unfold i, j, k in V. rewrite !still_at in V by assumption. split; [exact V|].
  intros g Fg. destruct (PositiveMap.find g (bodies P)) as [bg|] eqn:F; [|congruence]. clear Fg.
  rewrite <- (still_at bg g F).
  rewrite forallb_forall in All.
  assert (I : In (g, still bg g) (all_still P)).
  { unfold all_still. apply (in_map (fun b => (fst b, still (snd b) (fst b))) _ (g, bg)), PositiveMap.elements_correct, F. }
  specialize (All _ I). cbn [snd] in All. apply andb_prop in All as [Pg O]. rewrite outside_is in O. apply andb_prop in O as [O Rg].
  destruct (E (at_z (still bg g) 0) (proper_at _ _ (Rle_refl 0) Pg) (proper_at _ _ (Rle_refl 0) Pi)) as (E1 & _ & _).
  - unfold right. change (wall (at_z (still bg g) 0)) with (mwall (still bg g)).
    destruct (mwall (still bg g)); [left|right; reflexivity]. apply Z.ltb_lt, IZR_lt in Rg.
    rewrite <- zrow_at. exact Rg.
  - apply E1. rewrite start_incircle.
    apply (not_negative_at_true _ _ _ _ _ (sqrt_lt_R0 _ G) N (start_product i j k (still bg g) _ _ G) O).
Qed.

Lemma vertex_ok_true a b c : vertex_ok (all_still P) (find_still P) (a, b, c) = true -> empty_vertex a b c.
Proof.
  unfold vertex_ok, find_still. destruct (PositiveMap.find a (bodies P)) as [ba|] eqn:Fa; [|discriminate].
  destruct (PositiveMap.find b (bodies P)) as [bb|] eqn:Fb; [|discriminate].
  destruct (PositiveMap.find c (bodies P)) as [bc|] eqn:Fc; [|discriminate].
  destruct (mwall (still ba a)); intros H.
  - apply empty_vertex_turn, empty_vertex_turn. apply (empty_circle_true _ _ _ _ _ _ Fb Fc Fa H).
  - apply (empty_circle_true _ _ _ _ _ _ Fa Fb Fc H).
Qed.

(* Its generators are the scene's. *)
Definition there (a b c : gen) : Prop :=
  PositiveMap.find a (bodies P) <> None /\ PositiveMap.find b (bodies P) <> None /\ PositiveMap.find c (bodies P) <> None.

Lemma vertex_ok_there a b c : vertex_ok (all_still P) (find_still P) (a, b, c) = true -> there a b c.
Proof.
  unfold vertex_ok, find_still, there. destruct (PositiveMap.find a (bodies P)); [|discriminate].
  destruct (PositiveMap.find b (bodies P)); [|discriminate]. destruct (PositiveMap.find c (bodies P)); [|discriminate].
  intros _. repeat split; discriminate.
Qed.

Lemma canonical_turns a b c : canonical (a, b, c) = (a, b, c) \/ canonical (a, b, c) = (b, c, a) \/ canonical (a, b, c) = (c, a, b).
Proof. unfold canonical. destruct (_ && _); [tauto|]. destruct (_ && _); tauto. Qed.

Lemma side_in q a b c : side_of q a b c <-> In (a, b, c) (sides q).
Proof.
  unfold side_of, sides. simpl. split.
  - intros [(-> & -> & ->)|(-> & -> & ->)]; tauto.
  - intros [H|[H|[]]]; injection H as <- <- <-; tauto.
Qed.

Lemma initial_with_sound owner names numbers : initial_with P owner names numbers = true -> true_initial P.
Proof.
  unfold initial_with. intros H.
  apply andb_prop in H as [HE HV]. rewrite forallb_forall in HV, HE.
  assert (Each : forall k q a b c, PositiveMap.find k (edges P) = Some q -> side_of q a b c ->
    owned P owner k (a, b, c) = true /\ numbered names numbers (a, b, c) = true).
  { intros k q a b c F S. specialize (HE (k, q) (PositiveMap.elements_correct _ _ F)). cbn [fst snd] in HE.
    rewrite forallb_forall in HE. specialize (HE (a, b, c) (proj1 (side_in q a b c) S)). apply andb_prop in HE. exact HE. }
  assert (Vertex : forall k q a b c, PositiveMap.find k (edges P) = Some q -> side_of q a b c ->
    vertex_ok (all_still P) (find_still P) (canonical (a, b, c)) = true).
  { intros k q a b c F S. destruct (Each _ _ _ _ _ F S) as [_ N]. unfold numbered in N.
    destruct (find3 numbers (canonical (a, b, c))) as [v|]; [|discriminate].
    destruct (PositiveMap.find v names) as [u|] eqn:Fv; [|discriminate]. apply triple_eqb_true in N. subst u.
    exact (HV (v, canonical (a, b, c)) (PositiveMap.elements_correct _ _ Fv)). }
  assert (Closed : forall k q a b c, PositiveMap.find k (edges P) = Some q -> side_of q a b c ->
    exists k' q', PositiveMap.find k' (edges P) = Some q' /\ side_of q' b c a).
  { intros k q a b c F S. destruct (Each _ _ _ _ _ F S) as [O _]. unfold owned in O.
    destruct (find3 owner (a, b, c)); [|discriminate]. destruct (find3 owner (next_side (a, b, c))) as [k1|]; [|discriminate].
    apply andb_prop in O as [_ O]. destruct (PositiveMap.find k1 (edges P)) as [q1|] eqn:F1; [|discriminate].
    apply existsb_exists in O as (t & I & E). apply triple_eqb_true in E. subst t.
    exists k1, q1. split; [exact F1|]. apply side_in, I. }
  split.
  - intros k k' q q' a b c F F' S S'. destruct (Each _ _ _ _ _ F S) as [O _]. destruct (Each _ _ _ _ _ F' S') as [O' _].
    unfold owned in O, O'. destruct (find3 owner (a, b, c)) as [k0|]; [|discriminate].
    destruct (find3 owner (next_side (a, b, c))); [|discriminate].
    apply andb_prop in O as [O _]. apply andb_prop in O' as [O' _]. apply Pos.eqb_eq in O, O'. congruence.
  - exact Closed.
  - intros k q a b c F S. specialize (Vertex _ _ _ _ _ F S). change (there a b c).
    destruct (canonical_turns a b c) as [E|[E|E]]; rewrite E in Vertex; apply vertex_ok_there in Vertex; unfold there in *; tauto.
  - intros k q a b c F S. specialize (Vertex _ _ _ _ _ F S) as HV'. change (empty_vertex a b c).
    destruct (canonical_turns a b c) as [E|[E|E]]; rewrite E in HV'; apply vertex_ok_true in HV'.
    + exact HV'.
    + apply empty_vertex_turn, empty_vertex_turn, HV'.
    + apply empty_vertex_turn, HV'.
Qed.

Theorem initial_sound : initial_ok P = true -> true_initial P.
Proof. unfold initial_ok. destruct (fold_left _ _ _) as [[next names] numbers]. apply initial_with_sound. Qed.
End Initial.
