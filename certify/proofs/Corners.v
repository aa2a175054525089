(* Near an instant at which the diagram is right, the circle of every vertex stays empty, if the edges without length stay legal. *)
From Coq Require Import Reals Lra List Bool PArith.
From Voroproof Require Import Geometry Vertex Scale History Arc Cyclic Cover Spread Envelope Near Link.
Import ListNotations.
Open Scope R_scope.

Lemma cont_plus f g t : continuity_pt f t -> continuity_pt g t -> continuity_pt (fun u => f u + g u) t.
Proof. exact (continuity_pt_plus f g t). Qed.
Lemma cont_minus f g t : continuity_pt f t -> continuity_pt g t -> continuity_pt (fun u => f u - g u) t.
Proof. exact (continuity_pt_minus f g t). Qed.
Lemma cont_mult f g t : continuity_pt f t -> continuity_pt g t -> continuity_pt (fun u => f u * g u) t.
Proof. exact (continuity_pt_mult f g t). Qed.
Lemma cont_opp f t : continuity_pt f t -> continuity_pt (fun u => - f u) t.
Proof. exact (continuity_pt_opp f t). Qed.
Lemma cont_const x t : continuity_pt (fun _ => x) t.
Proof. apply continuity_pt_const. intros u v. reflexivity. Qed.

(* The difference of the values of an affine function at two unit vectors, by its slopes there. *)
Lemma two_values f p r : unit p -> unit r -> (at_ f r - at_ f p) * (1 + dot p r) = cross p r * (slope f p + slope f r).
Proof.
  destruct f as [[a b] e], p as [c d], r as [c' d']. unfold unit, at_, slope, dot, cross, turn; simpl. intros Up Ur. apply Rminus_diag_uniq.
  transitivity ((a * c + b * d) * (c' * c' + d' * d' - 1) - (a * c' + b * d') * (c * c + d * d - 1)); [ring|]. rewrite Up, Ur. ring.
Qed.

(* Of two functions, one that rises and one that falls from p to r: where the one vanishes at r and is not negative at p, the way from
   p to r is that on which the other rises. *)
Lemma carried f f' p r : unit p -> unit r -> 0 < 1 + dot p r -> (slope f p + slope f r) * (slope f' p + slope f' r) < 0 ->
  at_ f r = 0 -> 0 <= at_ f p -> 0 <= at_ f' p -> 0 <= at_ f' r.
Proof.
  intros Up Ur P S Z H H'. pose proof (two_values f p r Up Ur) as E. pose proof (two_values f' p r Up Ur) as E'. rewrite Z in E.
  set (s := slope f p + slope f r) in *. set (s' := slope f' p + slope f' r) in *. set (w := 1 + dot p r) in *. set (z := cross p r) in *.
  apply Rnot_lt_le. intros L. assert (N : s <> 0) by (intros X; rewrite X in S; lra).
  assert (Q : 0 < s * s) by (pose proof (Rsqr_pos_lt s N); unfold Rsqr in *; lra).
  assert (A : 0 < (at_ f' p - at_ f' r) * w * (s * s)) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra|exact Q]).
  assert (B : (at_ f' p - at_ f' r) * w * (s * s) = - (z * s') * (s * s)) by (rewrite <- E'; ring).
  assert (C : - (z * s') * (s * s) = at_ f p * w * (s * s')) by (transitivity (- (z * s) * (s * s')); [ring|rewrite <- E; ring]).
  assert (G : 0 <= at_ f p * w * - (s * s')) by (repeat apply Rmult_le_pos; lra). lra.
Qed.

(* The mirror image of Arc.no_exit. *)
Definition mirror (u : vec) : vec := Vec (vx u) (- vy u).
Lemma no_entry f p q : unit p -> unit q -> p <> q -> (forall u, unit u -> 0 <= chord p q u -> 0 <= at_ f u) -> at_ f p = 0 -> 0 <= slope f p.
Proof.
  intros Up Uq N H Z.
  assert (0 <= - slope (Affine (mirror (fa f)) (fb f)) (mirror p)) as X; [|unfold slope, dot, turn, mirror in *; simpl in *; lra].
  assert (slope (Affine (mirror (fa f)) (fb f)) (mirror p) <= 0); [|lra].
  apply (no_exit _ (mirror q) (mirror p)).
  - unfold unit, mirror in *; simpl; lra.
  - unfold unit, mirror in *; simpl; lra.
  - intros E. apply N. destruct p as [a b], q as [c d]. unfold mirror in E; simpl in E. injection E as E1 E2. f_equal; lra.
  - intros u Uu C. assert (0 <= at_ f (mirror u)) as G; [|unfold at_, dot, mirror in *; simpl in *; lra].
    apply H; [unfold unit, mirror in *; simpl; lra|]. unfold chord, cross, minus, mirror in *; simpl in *; lra.
  - unfold at_, dot, mirror in *; simpl in *; lra.
Qed.

(* Both functions and directions move: near the instant at which p and r are one, [carried] applies. *)
Section Carry.
  Variable t0 : R.
  Definition moving (f : R -> affine) : Prop :=
    continuity_pt (fun t => vx (fa (f t))) t0 /\ continuity_pt (fun t => vy (fa (f t))) t0 /\ continuity_pt (fun t => fb (f t)) t0.
  Definition turning_dir (u : R -> vec) : Prop := continuity_pt (fun t => vx (u t)) t0 /\ continuity_pt (fun t => vy (u t)) t0.

  Lemma slope_moving f u : moving f -> turning_dir u -> continuity_pt (fun t => slope (f t) (u t)) t0.
  Proof.
    intros (A & B & _) (C & E). unfold slope, dot, turn; simpl.
    apply cont_plus; apply cont_mult; try assumption. apply cont_opp, E.
  Qed.

  Lemma diff_moving f f' : moving f -> moving f' -> moving (fun t => diff (f t) (f' t)).
  Proof. intros (A & B & C) (A' & B' & C'). unfold moving, diff, minus; simpl. repeat split; apply cont_minus; assumption. Qed.

  Lemma carried_after f f' p r : moving f -> moving f' -> turning_dir p -> turning_dir r -> unit (r t0) -> p t0 = r t0 ->
    slope (f t0) (r t0) * slope (f' t0) (r t0) < 0 ->
    after t0 (fun t => unit (p t) -> unit (r t) -> at_ (f t) (r t) = 0 -> 0 <= at_ (f t) (p t) -> 0 <= at_ (f' t) (p t) -> 0 <= at_ (f' t) (r t)).
  Proof.
    intros Mf Mf' Tp Tr U E S.
    assert (A : after t0 (fun t => 0 < 1 + dot (p t) (r t))).
    { apply (after_positive (fun t => 1 + dot (p t) (r t))).
      - destruct Tp, Tr. unfold dot. apply cont_plus; [apply cont_const|]. apply cont_plus; apply cont_mult; assumption.
      - rewrite E. unfold dot. unfold unit in U. lra. }
    assert (B : after t0 (fun t => 0 < - ((slope (f t) (p t) + slope (f t) (r t)) * (slope (f' t) (p t) + slope (f' t) (r t))))).
    { apply (after_positive (fun t => - ((slope (f t) (p t) + slope (f t) (r t)) * (slope (f' t) (p t) + slope (f' t) (r t))))).
      - apply cont_opp, cont_mult; apply cont_plus; apply slope_moving; assumption.
      - rewrite E. lra. }
    pose proof (after_and _ _ _ A B) as C. revert C. apply after_impl.
    intros t [Ht Ht'] Up Ur Z H H'. apply (carried (f t) (f' t) (p t) (r t)); try assumption. lra.
  Qed.
End Carry.

Section Corners.
  Variable gens : list gen.
  Variable cfg : R -> gen -> generator.
  Variable D : list edge.
  Variable t0 : R.
  Hypothesis M : moves cfg.
  Hypothesis F : fits gens D.
  Hypothesis V : voronoi gens (cfg t0) D.

  (* Every edge that has no length at t0 is legal at t. *)
  Definition short_legal (t : R) : Prop := forall q, In q D ->
    pinched (cfg t0 (el q)) (cfg t0 (er q)) (cfg t0 (es q)) (cfg t0 (ee q)) ->
    legal (cfg t (el q)) (cfg t (er q)) (cfg t (es q)) (cfg t (ee q)).

  Lemma all_proper t g : proper (cfg t g).
  Proof.
    unfold proper. rewrite (walls _ M). destruct (Pos.eqb_spec g container) as [->|N]; [apply (proper_wall _ M)|apply (proper_disk _ M), N].
  Qed.

  Lemma one_wall t g h : g <> h -> wall (cfg t g) && wall (cfg t h) = false.
  Proof. intros N. rewrite !(walls _ M). destruct (Pos.eqb_spec g container), (Pos.eqb_spec h container); simpl; congruence. Qed.

  Lemma other_disk t g h : g <> h -> wall (cfg t g) = true -> wall (cfg t h) = false.
  Proof. intros N W. pose proof (one_wall t g h N) as X. rewrite W in X. exact X. Qed.

  Lemma three_distinct o t a b c : vertex_circle o (cfg t a) (cfg t b) (cfg t c) -> a <> b /\ b <> c /\ a <> c.
  Proof. intros (_ & _ & _ & H). unfold counterclockwise in H. repeat split; intros <-; lra. Qed.

  Lemma touching_empty o t g : touches o (cfg t g) -> empty_of o (cfg t g).
  Proof. unfold touches, empty_of. lra. Qed.

  (* What a vertex with base l says at t. *)
  Lemma clear_level t l j k g : vertex (cfg t l) (cfg t j) (cfg t k) -> right_pair (cfg t l) (cfg t g) ->
    ((forall o, vertex_circle o (cfg t l) (cfg t j) (cfg t k) -> empty_of o (cfg t g)) <->
      at_ (Kg (cfg t l) (cfg t g)) (dir (cfg t l) (cfg t j) (cfg t k)) <= level (cfg t l) (cfg t j) (cfg t k)).
  Proof.
    intros W R.
    assert (A : forall o, vertex_circle o (cfg t l) (cfg t j) (cfg t k) -> (empty_of o (cfg t g) <->
      at_ (Kg (cfg t l) (cfg t g)) (dir (cfg t l) (cfg t j) (cfg t k)) <= level (cfg t l) (cfg t j) (cfg t k))).
    { intros o Ho. eapply circle_and_other; try apply all_proper; assumption. }
    split.
    - intros H. destruct (circle_of_vertex (cfg t l) (cfg t j) (cfg t k)) as (o & Ho & _); try apply all_proper; [assumption|].
      apply (A o Ho), H, Ho.
    - intros H o Ho. apply (A o Ho), H.
  Qed.

  Lemma same_one o o' t l j k : vertex (cfg t l) (cfg t j) (cfg t k) -> vertex_circle o (cfg t l) (cfg t j) (cfg t k) ->
    vertex_circle o' (cfg t l) (cfg t j) (cfg t k) -> o = o'.
  Proof. intros W H H'. apply (one_circle o o' (cfg t l) (cfg t j) (cfg t k)); try apply all_proper; assumption. Qed.

  Lemma contact_dir o l j k : vertex (cfg t0 l) (cfg t0 j) (cfg t0 k) -> vertex_circle o (cfg t0 l) (cfg t0 j) (cfg t0 k) ->
    opposite (contact o (cfg t0 l)) = dir (cfg t0 l) (cfg t0 j) (cfg t0 k).
  Proof.
    intros W H. destruct (circle_of_vertex (cfg t0 l) (cfg t0 j) (cfg t0 k)) as (o' & Ho & C & _); try apply all_proper; [assumption|].
    rewrite (same_one o o' t0 l j k W H Ho), C. destruct (dir (cfg t0 l) (cfg t0 j) (cfg t0 k)) as [x y]. unfold opposite; simpl. f_equal; lra.
  Qed.

  (* Two vertices with one direction and one level have one circle. *)
  Lemma same_circle o l j k j' k' : vertex (cfg t0 l) (cfg t0 j) (cfg t0 k) -> vertex (cfg t0 l) (cfg t0 j') (cfg t0 k') -> j' <> k' ->
    dir (cfg t0 l) (cfg t0 j') (cfg t0 k') = dir (cfg t0 l) (cfg t0 j) (cfg t0 k) ->
    level (cfg t0 l) (cfg t0 j') (cfg t0 k') = level (cfg t0 l) (cfg t0 j) (cfg t0 k) ->
    vertex_circle o (cfg t0 l) (cfg t0 j) (cfg t0 k) -> vertex_circle o (cfg t0 l) (cfg t0 j') (cfg t0 k').
  Proof.
    intros W W' N Ed El H. pose proof (contact_dir o l j k W H) as C. destruct (vertex_dir _ _ _ W') as (_ & Z & S). rewrite Ed in Z, S.
    assert (L : at_ (Kg (cfg t0 l) (cfg t0 j')) (dir (cfg t0 l) (cfg t0 j) (cfg t0 k)) = level (cfg t0 l) (cfg t0 j) (cfg t0 k)).
    { rewrite <- El. unfold level. rewrite Ed. reflexivity. }
    destruct W' as (Hl & Rj & Rk & Rjk & Hw & _).
    assert (Tj : touches o (cfg t0 j')).
    { eapply (circle_and_other o (cfg t0 l) (cfg t0 j) (cfg t0 k) (cfg t0 j')); try apply all_proper; assumption. }
    assert (Tk : touches o (cfg t0 k')).
    { eapply (circle_and_other o (cfg t0 l) (cfg t0 j) (cfg t0 k) (cfg t0 k')); try apply all_proper; try assumption. lra. }
    destruct H as (Tl & _). repeat split; try assumption.
    apply contact_slopes; try apply all_proper; try assumption. rewrite C. exact S.
  Qed.

  (* Sides of D. *)
  Definition half (a b s c : gen) : Prop := In (Edge a b s c) D \/ In (Edge b a c s) D.

  Lemma half_of a b c : side D a b c -> exists s, half a b s c.
  Proof.
    intros (q & I & S). destruct q as [l r s e]. unfold side_of in S; simpl in S. destruct S as [(-> & -> & ->)|(-> & -> & ->)].
    - exists s. left. exact I.
    - exists e. right. exact I.
  Qed.

  Lemma half_sides a b s c : half a b s c -> side D a b c /\ side D a s b.
  Proof.
    intros H. assert (side D b a s) as G.
    { destruct H as [I|I]; [exists (Edge a b s c)|exists (Edge b a c s)]; (split; [exact I|]); [right|left]; simpl; tauto. }
    split; [|apply (sides_turn _ _ F), G].
    destruct H as [I|I]; [exists (Edge a b s c)|exists (Edge b a c s)]; (split; [exact I|]); [left|right]; simpl; tauto.
  Qed.

  Lemma half_legal t a b s c : half a b s c -> short_legal t -> pinched (cfg t0 a) (cfg t0 b) (cfg t0 s) (cfg t0 c) ->
    legal (cfg t a) (cfg t b) (cfg t s) (cfg t c).
  Proof.
    intros [I|I] L C; [exact (L _ I C)|]. apply circles_turn. apply (L _ I). apply pinched_turn. exact C.
  Qed.

  Lemma half_oriented a b s c : half a b s c -> wall (cfg t0 a) = false -> oriented (cfg t0) D (Edge a b s c).
  Proof. intros H W. split; [exact H|exact W]. Qed.
  Lemma half_turned a b s c : half a b s c -> half b a c s.
  Proof. unfold half. tauto. Qed.

  Lemma half_there a b s c : half a b s c -> wall (cfg t0 a) = false ->
    vertex (cfg t0 a) (cfg t0 s) (cfg t0 b) /\ vertex (cfg t0 a) (cfg t0 b) (cfg t0 c).
  Proof. intros H W. exact (all_there _ _ _ V _ (half_oriented _ _ _ _ H W)). Qed.

  Lemma side_in_gens a b c : side D a b c -> In a gens /\ In b gens /\ In c gens.
  Proof.
    intros (q & I & S). pose proof (fun g => names_in _ _ F q g I) as N. simpl in N.
    destruct S as [(-> & -> & ->)|(-> & -> & ->)]; repeat split; apply N; tauto.
  Qed.

  Lemma side_vertex a b c : side D a b c -> wall (cfg t0 a) = false -> vertex (cfg t0 a) (cfg t0 b) (cfg t0 c).
  Proof. intros S W. destruct (half_of _ _ _ S) as (s & H). apply (half_there _ _ _ _ H W). Qed.

  Lemma side_empty a b c g : side D a b c -> wall (cfg t0 a) = false -> In g gens -> g <> a ->
    at_ (Kg (cfg t0 a) (cfg t0 g)) (dir (cfg t0 a) (cfg t0 b) (cfg t0 c)) <= level (cfg t0 a) (cfg t0 b) (cfg t0 c).
  Proof.
    intros S W I N. destruct (Pos.eq_dec g b) as [->|N']; [unfold level; lra|]. destruct (half_of _ _ _ S) as (s & H).
    pose proof (half_oriented _ _ _ _ H W) as O. destruct (half_there _ _ _ _ H W) as (W1 & W2).
    apply (envelope _ _ _ V _ (dir (cfg t0 a) (cfg t0 b) (cfg t0 c)) g O); try assumption.
    - apply (vertex_dir _ _ _ W2).
    - unfold start_of, end_of; simpl. destruct (vec_dec (dir (cfg t0 a) (cfg t0 s) (cfg t0 b)) (dir (cfg t0 a) (cfg t0 b) (cfg t0 c))) as [E|E].
      + left. split; [exact E|]. symmetry. exact E.
      + right. split; [exact E|]. unfold chord, cross, minus; simpl. lra.
  Qed.

  (* The circle of [a,b,c] stays empty of g. *)
  Definition short_clear (a b c g : gen) : Prop := after t0 (fun t => short_legal t ->
    forall o, vertex_circle o (cfg t a) (cfg t b) (cfg t c) -> empty_of o (cfg t g)).

  Lemma short_clear_turn a b c g : short_clear a b c g -> short_clear b c a g.
  Proof. apply after_impl. intros t H L o Ho. apply (H L). do 2 apply vertex_turn. exact Ho. Qed.

  Lemma K_moving l g : wall (cfg t0 l) = false -> right_pair (cfg t0 l) (cfg t0 g) -> moving t0 (fun t => Kg (cfg t l) (cfg t g)).
  Proof.
    intros W R. apply K_continuous; [exact M|]. apply right_tang in R. rewrite W in R. simpl in R. destruct (wall (cfg t0 g)); lra.
  Qed.

  (* The base is l, the edge is that of l and m. Where its circles are one at t0, and the directions p and r of the two near t0: if the
     circle at p is empty of x (the third of r) and of g, that at r is empty of g. *)
  Lemma carry l m x j k j' k' g :
    vertex (cfg t0 l) (cfg t0 j) (cfg t0 k) -> vertex (cfg t0 l) (cfg t0 j') (cfg t0 k') ->
    dir (cfg t0 l) (cfg t0 j) (cfg t0 k) = dir (cfg t0 l) (cfg t0 j') (cfg t0 k') ->
    m = j \/ m = k -> (m = j' /\ x = k') \/ (m = k' /\ x = j') -> right_pair (cfg t0 l) (cfg t0 g) ->
    (let r := dir (cfg t0 l) (cfg t0 j') (cfg t0 k') in let s h := slope (Kg (cfg t0 l) (cfg t0 h)) r in (s m - s x) * (s m - s g) < 0) ->
    after t0 (fun t => at_ (Kg (cfg t l) (cfg t x)) (dir (cfg t l) (cfg t j) (cfg t k)) <= level (cfg t l) (cfg t j) (cfg t k) ->
      at_ (Kg (cfg t l) (cfg t g)) (dir (cfg t l) (cfg t j) (cfg t k)) <= level (cfg t l) (cfg t j) (cfg t k) ->
      at_ (Kg (cfg t l) (cfg t g)) (dir (cfg t l) (cfg t j') (cfg t k')) <= level (cfg t l) (cfg t j') (cfg t k')).
  Proof.
    intros W W' E Hm Hm' Rg S. assert (Wl : wall (cfg t0 l) = false) by apply W.
    assert (Rm : right_pair (cfg t0 l) (cfg t0 m)) by (destruct W as (_ & A & B & _); destruct Hm as [->| ->]; assumption).
    assert (Rx : right_pair (cfg t0 l) (cfg t0 x)) by (destruct W' as (_ & A & B & _); destruct Hm' as [[_ ->]|[_ ->]]; assumption).
    assert (C : after t0 (fun t => unit (dir (cfg t l) (cfg t j) (cfg t k)) -> unit (dir (cfg t l) (cfg t j') (cfg t k')) ->
      at_ (diff (Kg (cfg t l) (cfg t m)) (Kg (cfg t l) (cfg t x))) (dir (cfg t l) (cfg t j') (cfg t k')) = 0 ->
      0 <= at_ (diff (Kg (cfg t l) (cfg t m)) (Kg (cfg t l) (cfg t x))) (dir (cfg t l) (cfg t j) (cfg t k)) ->
      0 <= at_ (diff (Kg (cfg t l) (cfg t m)) (Kg (cfg t l) (cfg t g))) (dir (cfg t l) (cfg t j) (cfg t k)) ->
      0 <= at_ (diff (Kg (cfg t l) (cfg t m)) (Kg (cfg t l) (cfg t g))) (dir (cfg t l) (cfg t j') (cfg t k')))).
    { apply (carried_after t0 (fun t => diff (Kg (cfg t l) (cfg t m)) (Kg (cfg t l) (cfg t x))) (fun t => diff (Kg (cfg t l) (cfg t m)) (Kg (cfg t l) (cfg t g)))
        (fun t => dir (cfg t l) (cfg t j) (cfg t k)) (fun t => dir (cfg t l) (cfg t j') (cfg t k'))).
      - apply diff_moving; apply K_moving; assumption.
      - apply diff_moving; apply K_moving; assumption.
      - apply dir_continuous; assumption.
      - apply dir_continuous; assumption.
      - apply (vertex_dir _ _ _ W').
      - exact E.
      - replace (slope (diff (Kg (cfg t0 l) (cfg t0 m)) (Kg (cfg t0 l) (cfg t0 x))) (dir (cfg t0 l) (cfg t0 j') (cfg t0 k'))) with
          (slope (Kg (cfg t0 l) (cfg t0 m)) (dir (cfg t0 l) (cfg t0 j') (cfg t0 k')) - slope (Kg (cfg t0 l) (cfg t0 x)) (dir (cfg t0 l) (cfg t0 j') (cfg t0 k')))
          by (unfold slope, diff, dot, minus; simpl; ring).
        replace (slope (diff (Kg (cfg t0 l) (cfg t0 m)) (Kg (cfg t0 l) (cfg t0 g))) (dir (cfg t0 l) (cfg t0 j') (cfg t0 k'))) with
          (slope (Kg (cfg t0 l) (cfg t0 m)) (dir (cfg t0 l) (cfg t0 j') (cfg t0 k')) - slope (Kg (cfg t0 l) (cfg t0 g)) (dir (cfg t0 l) (cfg t0 j') (cfg t0 k')))
          by (unfold slope, diff, dot, minus; simpl; ring).
        exact S. }
    pose proof (after_and _ _ _ C (after_and _ _ _ (vertex_after cfg M t0 l j k W) (vertex_after cfg M t0 l j' k' W'))) as A.
    revert A. apply after_impl. intros t (H & Wt & Wt') Hx Hg.
    destruct (vertex_dir _ _ _ Wt) as (U & Z & _). destruct (vertex_dir _ _ _ Wt') as (U' & Z' & _).
    assert (Lp : level (cfg t l) (cfg t j) (cfg t k) = at_ (Kg (cfg t l) (cfg t m)) (dir (cfg t l) (cfg t j) (cfg t k))).
    { unfold level. destruct Hm as [->| ->]; congruence. }
    assert (Lr : level (cfg t l) (cfg t j') (cfg t k') = at_ (Kg (cfg t l) (cfg t m)) (dir (cfg t l) (cfg t j') (cfg t k')) /\
      at_ (Kg (cfg t l) (cfg t x)) (dir (cfg t l) (cfg t j') (cfg t k')) = at_ (Kg (cfg t l) (cfg t m)) (dir (cfg t l) (cfg t j') (cfg t k'))).
    { unfold level. destruct Hm' as [[-> ->]|[-> ->]]; split; congruence. }
    destruct Lr as [Lr Lx]. rewrite Lp in Hx, Hg. rewrite Lr.
    assert (Dv : forall h u, at_ (diff (Kg (cfg t l) (cfg t m)) (Kg (cfg t l) (cfg t h))) u = at_ (Kg (cfg t l) (cfg t m)) u - at_ (Kg (cfg t l) (cfg t h)) u)
      by (intros; unfold at_, diff, dot, minus; simpl; ring).
    rewrite !Dv in H. specialize (H U U'). lra.
  Qed.

  (* The side of a vertex on the circle Z of t0. *)
  Section At_circle.
    Variable Z : circle.
    Definition on_Z (a b c : gen) : Prop := side D a b c /\ vertex_circle Z (cfg t0 a) (cfg t0 b) (cfg t0 c).

    (* The edge between b and c, with the generators s and a at its ends, seen from a disk l of b, c; m is the other. *)
    Lemma step_clear b s c a g l m j k j' k' : half b c s a -> on_Z b s c -> on_Z b c a -> In g gens -> g <> b -> g <> c ->
      (l = b /\ m = c /\ j = s /\ k = c /\ j' = c /\ k' = a) \/ (l = c /\ m = b /\ j = b /\ k = s /\ j' = a /\ k' = b) ->
      vertex (cfg t0 l) (cfg t0 j) (cfg t0 k) -> vertex (cfg t0 l) (cfg t0 j') (cfg t0 k') ->
      dir (cfg t0 l) (cfg t0 j) (cfg t0 k) = dir (cfg t0 l) (cfg t0 j') (cfg t0 k') ->
      (let r := dir (cfg t0 l) (cfg t0 j') (cfg t0 k') in let s h := slope (Kg (cfg t0 l) (cfg t0 h)) r in (s m - s a) * (s m - s g) < 0) ->
      s = g \/ short_clear b s c g -> short_clear b c a g.
    Proof.
      intros H (S1 & Z1) (S2 & Z2) I Nb Nc Cases W W' E S Hs. destruct (side_in_gens _ _ _ S2) as (Ib & Ic & Ia).
      assert (Cot : pinched (cfg t0 b) (cfg t0 c) (cfg t0 s) (cfg t0 a)).
      { exists Z. split; assumption. }
      assert (Turn : forall o t, vertex_circle o (cfg t b) (cfg t c) (cfg t a) <-> vertex_circle o (cfg t l) (cfg t j') (cfg t k')).
      { intros o t. destruct Cases as [(-> & -> & -> & -> & -> & ->)|(-> & -> & -> & -> & -> & ->)]; [tauto|].
        split; intros X; [apply vertex_turn|do 2 apply vertex_turn]; exact X. }
      assert (Turn' : forall o t, vertex_circle o (cfg t b) (cfg t s) (cfg t c) <-> vertex_circle o (cfg t l) (cfg t j) (cfg t k)).
      { intros o t. destruct Cases as [(-> & -> & -> & -> & -> & ->)|(-> & -> & -> & -> & -> & ->)]; [tauto|].
        split; intros X; [do 2 apply vertex_turn|apply vertex_turn]; exact X. }
      destruct Hs as [->|Hs].
      - pose proof (vertex_after cfg M t0 l j' k' W') as A. revert A. apply after_impl. intros t Wt L o Ho.
        destruct (half_legal t _ _ _ _ H L Cot) as [_ (o' & Ho' & E')]. apply Turn in Ho. apply Turn in Ho'.
        rewrite (same_one o o' t l j' k' Wt Ho Ho'). exact E'.
      - assert (Ng : g <> l) by (destruct Cases as [(-> & _)|(-> & _)]; assumption).
        assert (Il : In l gens) by (destruct Cases as [(-> & _)|(-> & _)]; assumption).
        assert (Rg : right_pair (cfg t0 l) (cfg t0 g)) by (apply (all_right _ _ _ V); congruence).
        assert (Ca : after t0 (fun t => at_ (Kg (cfg t l) (cfg t a)) (dir (cfg t l) (cfg t j) (cfg t k)) <= level (cfg t l) (cfg t j) (cfg t k) ->
          at_ (Kg (cfg t l) (cfg t g)) (dir (cfg t l) (cfg t j) (cfg t k)) <= level (cfg t l) (cfg t j) (cfg t k) ->
          at_ (Kg (cfg t l) (cfg t g)) (dir (cfg t l) (cfg t j') (cfg t k')) <= level (cfg t l) (cfg t j') (cfg t k'))).
        { apply (carry l m a j k j' k' g); try assumption; destruct Cases as [(-> & -> & -> & -> & -> & ->)|(-> & -> & -> & -> & -> & ->)]; tauto. }
        pose proof (after_and _ _ _ (after_and _ _ _ Hs Ca) (after_and _ _ _ (right_after cfg M t0 l g Rg)
          (after_and _ _ _ (vertex_after cfg M t0 l j k W) (vertex_after cfg M t0 l j' k' W')))) as A.
        revert A. apply after_impl. intros t ((Ht & Ct) & Rt & Wt & Wt') L o Ho. apply Turn in Ho. revert o Ho. apply clear_level; try assumption.
        apply Ct.
        + pose proof (half_legal t _ _ _ _ H L Cot) as Le.
          destruct Cases as [(-> & -> & -> & -> & -> & ->)|(-> & -> & -> & -> & -> & ->)].
          * assert (X : legal (cfg t b) (cfg t c) (cfg t s) (cfg t a) <-> (at_ (Kg (cfg t b) (cfg t a)) (dir (cfg t b) (cfg t s) (cfg t c)) <= level (cfg t b) (cfg t s) (cfg t c) /\
              at_ (Kg (cfg t b) (cfg t s)) (dir (cfg t b) (cfg t c) (cfg t a)) <= level (cfg t b) (cfg t c) (cfg t a)))
              by (apply legal_link; try apply all_proper; assumption). apply X, Le.
          * assert (Le' : legal (cfg t c) (cfg t b) (cfg t a) (cfg t s)) by (apply circles_turn; exact Le).
            assert (X : legal (cfg t c) (cfg t b) (cfg t a) (cfg t s) <-> (at_ (Kg (cfg t c) (cfg t s)) (dir (cfg t c) (cfg t a) (cfg t b)) <= level (cfg t c) (cfg t a) (cfg t b) /\
              at_ (Kg (cfg t c) (cfg t a)) (dir (cfg t c) (cfg t b) (cfg t s)) <= level (cfg t c) (cfg t b) (cfg t s)))
              by (apply legal_link; try apply all_proper; assumption). apply X, Le'.
        + apply clear_level; try assumption. intros o Ho. apply Turn' in Ho. exact (Ht L o Ho).
    Qed.

    Lemma touching_value l j k g : vertex (cfg t0 l) (cfg t0 j) (cfg t0 k) -> vertex_circle Z (cfg t0 l) (cfg t0 j) (cfg t0 k) ->
      right_pair (cfg t0 l) (cfg t0 g) -> (touches Z (cfg t0 g) <-> 
      at_ (Kg (cfg t0 l) (cfg t0 g)) (dir (cfg t0 l) (cfg t0 j) (cfg t0 k)) = level (cfg t0 l) (cfg t0 j) (cfg t0 k)).
    Proof.
      intros W H R. assert (X := circle_and_other Z (cfg t0 l) (cfg t0 j) (cfg t0 k) (cfg t0 g)).
      apply X; try apply all_proper; assumption.
    Qed.

    Lemma step a b c g : on_Z b c a -> In g gens -> touches Z (cfg t0 g) -> counterclockwise Z (cfg t0 b) (cfg t0 g) (cfg t0 c) ->
      exists s, on_Z b s c /\ (s = g \/ short_clear b s c g -> short_clear b c a g).
    Proof.
      intros O I T C. pose proof O as (S & HZ). destruct (half_of _ _ _ S) as (s & H). exists s.
      destruct (side_in_gens _ _ _ S) as (Ib & Ic & Ia). destruct (half_sides _ _ _ _ H) as (_ & S1).
      assert (Tb : touches Z (cfg t0 b)) by apply HZ. assert (Tc : touches Z (cfg t0 c)) by apply HZ. assert (Ta : touches Z (cfg t0 a)) by apply HZ.
      assert (G : vertex_circle Z (cfg t0 b) (cfg t0 g) (cfg t0 c)) by (repeat split; assumption).
      destruct (three_distinct _ _ _ _ _ G) as (N1 & N2 & N3). destruct (three_distinct _ _ _ _ _ HZ) as (_ & N4 & N5).
      assert (Right : forall x y, In x gens -> In y gens -> x <> y -> right_pair (cfg t0 x) (cfg t0 y)) by apply (all_right _ _ _ V).
      destruct (wall (cfg t0 b)) eqn:Wb.
      - (* seen from c *)
        assert (Wc : wall (cfg t0 c) = false) by (apply (other_disk t0 b c); assumption).
        pose proof (half_turned _ _ _ _ H) as H'. destruct (half_there _ _ _ _ H' Wc) as (W2 & W1).
        assert (HZ' : vertex_circle Z (cfg t0 c) (cfg t0 a) (cfg t0 b)) by (apply vertex_turn; exact HZ).
        assert (G' : vertex_circle Z (cfg t0 c) (cfg t0 b) (cfg t0 g)) by (do 2 apply vertex_turn; exact G).
        pose proof (contact_dir Z c a b W2 HZ') as Cd.
        assert (Sl : slope (Kg (cfg t0 c) (cfg t0 b)) (dir (cfg t0 c) (cfg t0 a) (cfg t0 b)) < slope (Kg (cfg t0 c) (cfg t0 g)) (dir (cfg t0 c) (cfg t0 a) (cfg t0 b))).
        { rewrite <- Cd. apply (contact_slopes Z (cfg t0 c) (cfg t0 b) (cfg t0 g)); try apply all_proper; try assumption.
          - apply one_wall; congruence.
          - apply Right; congruence.
          - apply Right; congruence.
          - apply Right; congruence.
          - apply G'. }
        destruct (vertex_dir _ _ _ W2) as (U2 & Z2 & Sv). destruct (vertex_dir _ _ _ W1) as (U1 & Z1 & _).
        assert (Kg0 : at_ (Kg (cfg t0 c) (cfg t0 g)) (dir (cfg t0 c) (cfg t0 a) (cfg t0 b)) = level (cfg t0 c) (cfg t0 a) (cfg t0 b)).
        { apply touching_value; try assumption. apply Right; congruence. }
        assert (E : dir (cfg t0 c) (cfg t0 a) (cfg t0 b) = dir (cfg t0 c) (cfg t0 b) (cfg t0 s)).
        { destruct (vec_dec (dir (cfg t0 c) (cfg t0 a) (cfg t0 b)) (dir (cfg t0 c) (cfg t0 b) (cfg t0 s))) as [E|N]; [exact E|]. exfalso.
          assert (X : 0 <= slope (diff (Kg (cfg t0 c) (cfg t0 b)) (Kg (cfg t0 c) (cfg t0 g))) (dir (cfg t0 c) (cfg t0 a) (cfg t0 b))).
          { apply (no_entry _ _ (dir (cfg t0 c) (cfg t0 b) (cfg t0 s)) U2 U1 N).
            - intros u Uu Cu. assert (K_at (cfg t0) c g u <= K_at (cfg t0) c b u) as X; [|unfold K_at, at_, diff, dot, minus in *; simpl in *; lra].
              apply (envelope _ _ _ V _ u g (half_oriented _ _ _ _ H' Wc) Uu); [right; split; assumption|exact I|simpl; congruence|simpl; congruence].
            - unfold level, at_, diff, dot, minus in *; simpl in *; lra. }
          unfold slope, diff, dot, minus in *; simpl in *; lra. }
        assert (O1 : on_Z b s c).
        { split; [exact S1|]. apply vertex_turn. apply (same_circle Z c a b b s); try assumption.
          - intros <-. destruct W1 as (_ & _ & _ & _ & X & _). rewrite Wb in X. discriminate.
          - symmetry; exact E.
          - unfold level. rewrite <- E. exact Z2. }
        split; [exact O1|].
        apply (step_clear b s c a g c b b s a b); try assumption; try congruence.
        + right. tauto.
        + simpl. assert (P : forall x y z, x < y -> y < z -> (y - x) * (y - z) < 0).
          { intros x y z A B. assert (0 < (y - x) * (z - y)) by (apply Rmult_lt_0_compat; lra). lra. }
          apply P; assumption.
      - (* seen from b *)
        destruct (half_there _ _ _ _ H Wb) as (W1 & W2).
        pose proof (contact_dir Z b c a W2 HZ) as Cd.
        assert (Sl : slope (Kg (cfg t0 b) (cfg t0 g)) (dir (cfg t0 b) (cfg t0 c) (cfg t0 a)) < slope (Kg (cfg t0 b) (cfg t0 c)) (dir (cfg t0 b) (cfg t0 c) (cfg t0 a))).
        { rewrite <- Cd. apply (contact_slopes Z (cfg t0 b) (cfg t0 g) (cfg t0 c)); try apply all_proper; try assumption.
          - apply one_wall; congruence.
          - apply Right; congruence.
          - apply Right; congruence.
          - apply Right; congruence. }
        destruct (vertex_dir _ _ _ W2) as (U2 & Z2 & Sv). destruct (vertex_dir _ _ _ W1) as (U1 & Z1 & Sv1).
        assert (Kg0 : at_ (Kg (cfg t0 b) (cfg t0 g)) (dir (cfg t0 b) (cfg t0 c) (cfg t0 a)) = level (cfg t0 b) (cfg t0 c) (cfg t0 a)).
        { apply touching_value; try assumption. apply Right; congruence. }
        assert (E : dir (cfg t0 b) (cfg t0 s) (cfg t0 c) = dir (cfg t0 b) (cfg t0 c) (cfg t0 a)).
        { destruct (vec_dec (dir (cfg t0 b) (cfg t0 s) (cfg t0 c)) (dir (cfg t0 b) (cfg t0 c) (cfg t0 a))) as [E|N]; [exact E|]. exfalso.
          assert (X : slope (diff (Kg (cfg t0 b) (cfg t0 c)) (Kg (cfg t0 b) (cfg t0 g))) (dir (cfg t0 b) (cfg t0 c) (cfg t0 a)) <= 0).
          { apply (no_exit _ (dir (cfg t0 b) (cfg t0 s) (cfg t0 c)) _ U1 U2 N).
            - intros u Uu Cu. assert (K_at (cfg t0) b g u <= K_at (cfg t0) b c u) as X; [|unfold K_at, at_, diff, dot, minus in *; simpl in *; lra].
              apply (envelope _ _ _ V _ u g (half_oriented _ _ _ _ H Wb) Uu); [right; split; assumption|exact I|simpl; congruence|simpl; congruence].
            - unfold level, at_, diff, dot, minus in *; simpl in *; lra. }
          unfold slope, diff, dot, minus in *; simpl in *; lra. }
        assert (O1 : on_Z b s c).
        { split; [exact S1|]. apply (same_circle Z b c a s c); try assumption.
          - intros ->. lra.
          - unfold level. rewrite E in Z1 |- *. symmetry. exact Z1. }
        split; [exact O1|].
        apply (step_clear b s c a g b c s c c a); try assumption; try congruence.
        + left. tauto.
        + simpl. assert (P : forall x y z, x < y -> y < z -> (y - z) * (y - x) < 0).
          { intros x y z A B. assert (0 < (y - x) * (z - y)) by (apply Rmult_lt_0_compat; lra). lra. }
          apply P; assumption.
    Qed.

    (* The generators that touch Z, in the order of their contacts. *)
    Definition touching : list gen := filter (fun g => if Req_EM_T (distance (cfg t0 g) (ox Z) (oy Z)) (size Z) then true else false) gens.
    Lemma in_touching g : In g touching <-> In g gens /\ touches Z (cfg t0 g).
    Proof.
      unfold touching. rewrite filter_In. unfold touches. destruct (Req_EM_T _ _); intuition discriminate.
    Qed.
    Definition round (a b c : gen) : Prop :=
      In a touching /\ In b touching /\ In c touching /\ Cyclic.ccw (contact Z (cfg t0 a)) (contact Z (cfg t0 b)) (contact Z (cfg t0 c)).
    Lemma round_dec a b c : {round a b c} + {~ round a b c}.
    Proof.
      unfold round. destruct (in_dec Pos.eq_dec a touching); [|right; tauto]. destruct (in_dec Pos.eq_dec b touching); [|right; tauto].
      destruct (in_dec Pos.eq_dec c touching); [|right; tauto].
      destruct (Cyclic.ccw_dec (contact Z (cfg t0 a)) (contact Z (cfg t0 b)) (contact Z (cfg t0 c))); [left|right]; tauto.
    Qed.

    (* Some vertex with the circle Z. *)
    Variables a0 b0 c0 : gen.
    Hypothesis O0 : on_Z a0 b0 c0.
    Hypothesis disk0 : wall (cfg t0 a0) = false.

    Lemma unit_contact g : In g touching -> unit (contact Z (cfg t0 g)).
    Proof.
      intros I. apply in_touching in I as [I T]. destruct O0 as (S & H). destruct (side_in_gens _ _ _ S) as (Ia & Ib & _).
      destruct (three_distinct _ _ _ _ _ H) as (N & _). destruct (Pos.eq_dec g a0) as [->|N'].
      - apply (contact_unit Z (cfg t0 a0) (cfg t0 b0)); try apply all_proper; try assumption; [|apply H].
        apply (all_right _ _ _ V); congruence.
      - apply (contact_unit Z (cfg t0 a0) (cfg t0 g)); try apply all_proper; try assumption; [|apply H].
        apply (all_right _ _ _ V); congruence.
    Qed.

    Lemma round_total a b c : In a touching -> In b touching -> In c touching -> a <> b -> b <> c -> a <> c -> round a b c \/ round a c b.
    Proof.
      intros Ia Ib Ic N1 N2 N3.
      assert (Df : forall x y, In x touching -> In y touching -> x <> y -> contact Z (cfg t0 x) <> contact Z (cfg t0 y)).
      { intros x y Ix Iy N. pose proof (unit_contact x Ix). pose proof (unit_contact y Iy). apply in_touching in Ix as [Ix Tx]. apply in_touching in Iy as [Iy Ty].
        apply contacts_differ; try apply all_proper; try assumption; [apply one_wall, N|apply (all_right _ _ _ V); assumption]. }
      destruct (Cyclic.ccw_total (contact Z (cfg t0 a)) (contact Z (cfg t0 b)) (contact Z (cfg t0 c))) as [X|X]; try (apply unit_contact; assumption);
        try (apply Df; assumption); [left|right]; unfold round; tauto.
    Qed.

    Lemma round_turn a b c : round a b c -> round b c a.
    Proof. intros (A & B & C & H). repeat split; try assumption. apply Cyclic.ccw_turn, H. Qed.
    Lemma round_not a b c : round a b c -> ~ round a c b.
    Proof. intros (_ & _ & _ & H) (_ & _ & _ & H'). exact (Cyclic.ccw_not _ _ _ H H'). Qed.
    Lemma round_trans a b c d : round a b c -> round a c d -> round a b d.
    Proof.
      intros (A & B & C & H) (_ & _ & E & H'). repeat split; try assumption.
      apply (Cyclic.ccw_trans _ _ (contact Z (cfg t0 c))); try (apply unit_contact; assumption); assumption.
    Qed.

    Lemma walked a b c g : on_Z b c a -> In g touching -> round b g c -> short_clear b c a g.
    Proof.
      intros O I C.
      apply (walk_side gen Pos.eq_dec touching round round_dec round_turn round_not round_total round_trans on_Z) with
        (n := S (List.length (beyond gen touching round round_dec b c))); try assumption.
      - intros x y z (S & H). destruct (side_in_gens _ _ _ S) as (Ix & Iy & Iz). destruct H as (Tx & Ty & Tz & H).
        assert (In x touching /\ In y touching /\ In z touching) as (A1 & A2 & A3) by (rewrite !in_touching; tauto).
        apply counterclockwise_is in H. unfold round. tauto.
      - intros x y z (S & H). split; [apply (sides_turn _ _ F), S|apply vertex_turn, H].
      - intros x y z h. apply short_clear_turn.
      - intros x y z h Oy Ih (_ & _ & _ & Ch). apply in_touching in Ih as [Ih Th]. apply counterclockwise_is in Ch. apply step; assumption.
      - apply le_n.
    Qed.

    Lemma all_touching g : In g gens -> touches Z (cfg t0 g) -> g <> a0 -> g <> b0 -> g <> c0 -> short_clear a0 b0 c0 g.
    Proof.
      intros I T Na Nb Nc. assert (Ig : In g touching) by (apply in_touching; split; assumption).
      destruct O0 as (S & H). destruct (side_in_gens _ _ _ S) as (Ia & Ib & Ic).
      assert (A : In a0 touching) by (apply in_touching; split; [exact Ia|apply H]).
      assert (B : In b0 touching) by (apply in_touching; split; [exact Ib|apply H]).
      assert (C : In c0 touching) by (apply in_touching; split; [exact Ic|apply H]).
      destruct (three_distinct _ _ _ _ _ H) as (N1 & N2 & N3).
      assert (O1 : on_Z b0 c0 a0) by (split; [apply (sides_turn _ _ F), S|apply vertex_turn, H]).
      assert (O2 : on_Z c0 a0 b0) by (split; [apply (sides_turn _ _ F), O1|apply vertex_turn, O1]).
      destruct (round_total a0 g b0) as [X|X]; try assumption; try congruence.
      { apply (walked c0 a0 b0 g O0 Ig X). }
      destruct (round_total b0 g c0) as [Y|Y]; try assumption; try congruence.
      { apply short_clear_turn, short_clear_turn. apply (walked a0 b0 c0 g O1 Ig Y). }
      destruct (round_total c0 g a0) as [W|W]; try assumption; try congruence.
      { apply short_clear_turn. apply (walked b0 c0 a0 g O2 Ig W). }
      exfalso. apply round_turn, round_turn in Y. apply round_turn, round_turn in W. apply round_turn, round_turn in X.
      apply (round_not _ _ _ X). exact (round_trans _ _ _ _ Y W).
    Qed.
  End At_circle.

  Lemma disk_clear a b c g : side D a b c -> In g gens -> wall (cfg t0 a) = false -> short_clear a b c g.
  Proof.
    intros S I W. pose proof (side_vertex _ _ _ S W) as Wv. destruct (side_in_gens _ _ _ S) as (Ia & _).
    assert (Triv : g = a \/ g = b \/ g = c -> short_clear a b c g).
    { intros Hg. exists 1. split; [lra|]. intros t _ _ o (A & B & C & _). apply touching_empty. destruct Hg as [->|[->| ->]]; assumption. }
    destruct (Pos.eq_dec g a) as [Ea|Na]; [tauto|]. destruct (Pos.eq_dec g b) as [Eb|Nb]; [tauto|]. destruct (Pos.eq_dec g c) as [Ec|Nc]; [tauto|]. clear Triv.
    assert (R : right_pair (cfg t0 a) (cfg t0 g)) by (apply (all_right _ _ _ V); congruence).
    destruct (side_empty a b c g S W I Na) as [L|E].
    - assert (P : after t0 (fun t => 0 < level (cfg t a) (cfg t b) (cfg t c) - at_ (Kg (cfg t a) (cfg t g)) (dir (cfg t a) (cfg t b) (cfg t c)))).
      { apply (after_positive (fun t => level (cfg t a) (cfg t b) (cfg t c) - at_ (Kg (cfg t a) (cfg t g)) (dir (cfg t a) (cfg t b) (cfg t c)))); [|lra].
        apply cont_minus; [apply level_continuous; assumption|]. apply K_at_dir_continuous; try assumption.
        apply right_tang in R. rewrite W in R. simpl in R. destruct (wall (cfg t0 g)); lra. }
      pose proof (after_and _ _ _ P (after_and _ _ _ (right_after cfg M t0 a g R) (vertex_after cfg M t0 a b c Wv))) as A.
      revert A. apply after_impl. intros t (Pt & Rt & Wt) _. apply clear_level; try assumption. lra.
    - destruct (circle_of_vertex (cfg t0 a) (cfg t0 b) (cfg t0 c)) as (Z & HZ & _); try apply all_proper; [assumption|].
      apply (all_touching Z a b c); try assumption; [split; assumption|]. apply (touching_value Z a b c); assumption.
  Qed.

  Lemma any_clear a b c g : side D a b c -> In g gens -> short_clear a b c g.
  Proof.
    intros S I. destruct (wall (cfg t0 a)) eqn:Wa; [|apply disk_clear; assumption].
    destruct (Pos.eq_dec a b) as [->|N].
    { exists 1. split; [lra|]. intros t _ _ o Ho. destruct (three_distinct _ _ _ _ _ Ho) as (N & _). congruence. }
    apply short_clear_turn, short_clear_turn. apply disk_clear; try assumption; [apply (sides_turn _ _ F), S|].
    apply (other_disk t0 a b); assumption.
  Qed.

  Theorem corners : after t0 (fun t => short_legal t -> forall a b c g, side D a b c -> In g gens ->
    forall o, vertex_circle o (cfg t a) (cfg t b) (cfg t c) -> empty_of o (cfg t g)).
  Proof.
    assert (A : after t0 (fun t => forall q, In q D -> forall g, In g gens -> short_legal t -> forall a b c, side_of q a b c ->
      forall o, vertex_circle o (cfg t a) (cfg t b) (cfg t c) -> empty_of o (cfg t g))).
    { apply after_list. intros q Iq. apply after_list. intros g Ig.
      assert (S1 : side D (el q) (er q) (ee q)) by (exists q; split; [exact Iq|left; tauto]).
      assert (S2 : side D (er q) (el q) (es q)) by (exists q; split; [exact Iq|right; tauto]).
      pose proof (after_and _ _ _ (any_clear _ _ _ g S1 Ig) (any_clear _ _ _ g S2 Ig)) as A. revert A. apply after_impl.
      intros t (H1 & H2) L a b c [(-> & -> & ->)|(-> & -> & ->)]; [exact (H1 L)|exact (H2 L)]. }
    revert A. apply after_impl. intros t H L a b c g (q & Iq & S) Ig. exact (H q Iq g Ig L a b c S).
  Qed.
End Corners.
