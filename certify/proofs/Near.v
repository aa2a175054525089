(* What holds near an instant: limits of the motion carried through the functions of Envelope.v. *)
From Coq Require Import Reals Lra List Bool PArith.
From Voroproof Require Import Geometry History Arc Spread Envelope.
Import ListNotations.
Open Scope R_scope.

Lemma after_and t P Q : after t P -> after t Q -> after t (fun u => P u /\ Q u).
Proof.
  intros (d & Hd & H) (e & He & I). exists (Rmin d e). split; [apply Rmin_glb_lt; assumption|].
  intros u Hu. pose proof (Rmin_l d e). pose proof (Rmin_r d e). split; [apply H|apply I]; lra.
Qed.
Lemma after_impl t (P Q : R -> Prop) : (forall u, P u -> Q u) -> after t P -> after t Q.
Proof. intros S (d & Hd & H). exists d. split; [exact Hd|]. intros u Hu. apply S, H, Hu. Qed.
Lemma after_list {A} t (P : A -> R -> Prop) (l : list A) : (forall a, In a l -> after t (P a)) -> after t (fun u => forall a, In a l -> P a u).
Proof.
  induction l as [|b l IH]; intros H.
  - exists 1. split; [lra|]. intros u _ a [].
  - apply after_impl with (P := fun u => P b u /\ (forall a, In a l -> P a u)).
    + intros u [B L] a [<-|I]; [exact B|exact (L a I)].
    + apply after_and; [apply H; left; reflexivity|]. apply IH. intros a I. apply H. right. exact I.
Qed.

Lemma before_and t P Q : before t P -> before t Q -> before t (fun u => P u /\ Q u).
Proof.
  intros (d & Hd & H) (e & He & I). exists (Rmin d e). split; [apply Rmin_glb_lt; assumption|].
  intros u Hu. pose proof (Rmin_l d e). pose proof (Rmin_r d e). split; [apply H|apply I]; lra.
Qed.
Lemma before_impl t (P Q : R -> Prop) : (forall u, P u -> Q u) -> before t P -> before t Q.
Proof. intros S (d & Hd & H). exists d. split; [exact Hd|]. intros u Hu. apply S, H, Hu. Qed.
Lemma before_list {A} t (P : A -> R -> Prop) (l : list A) : (forall a, In a l -> before t (P a)) -> before t (fun u => forall a, In a l -> P a u).
Proof.
  induction l as [|b l IH]; intros H.
  - exists 1. split; [lra|]. intros u _ a [].
  - apply before_impl with (P := fun u => P b u /\ (forall a, In a l -> P a u)).
    + intros u [B L] a [<-|I]; [exact B|exact (L a I)].
    + apply before_and; [apply H; left; reflexivity|]. apply IH. intros a I. apply H. right. exact I.
Qed.

(* A continuous function stays positive on both sides of an instant. *)
Lemma near_positive f t : continuity_pt f t -> 0 < f t -> exists d, 0 < d /\ forall u, t - d < u < t + d -> 0 < f u.
Proof.
  intros C P. destruct (C (f t) P) as (d & Hd & H). exists d. split; [exact Hd|]. intros u Hu.
  destruct (Req_dec u t) as [->|N]; [exact P|].
  assert (X : Rabs (f u - f t) < f t).
  { apply H. split; [split; [exact I|congruence]|]. simpl. unfold R_dist. apply Rabs_def1; lra. }
  apply Rabs_def2 in X. lra.
Qed.
Lemma after_positive f t : continuity_pt f t -> 0 < f t -> after t (fun u => 0 < f u).
Proof. intros C P. destruct (near_positive f t C P) as (d & Hd & H). exists d. split; [exact Hd|]. intros u Hu. apply H. lra. Qed.
Lemma before_positive f t : continuity_pt f t -> 0 < f t -> before t (fun u => 0 < f u).
Proof. intros C P. destruct (near_positive f t C P) as (d & Hd & H). exists d. split; [exact Hd|]. intros u Hu. apply H. lra. Qed.

(* The rules of continuity, for functions that are written out. *)
Lemma same_continuity f g t : (forall u, f u = g u) -> continuity_pt g t -> continuity_pt f t.
Proof.
  intros E C e He. destruct (C e He) as (d & Hd & H). exists d. split; [exact Hd|]. intros u Hu. rewrite !E. apply H, Hu.
Qed.
Lemma constant_continuous c t : continuity_pt (fun _ => c) t.
Proof. apply continuity_pt_const. intros x y. reflexivity. Qed.
Lemma plus_continuous f g t : continuity_pt f t -> continuity_pt g t -> continuity_pt (fun u => f u + g u) t.
Proof. exact (continuity_pt_plus f g t). Qed.
Lemma minus_continuous f g t : continuity_pt f t -> continuity_pt g t -> continuity_pt (fun u => f u - g u) t.
Proof. exact (continuity_pt_minus f g t). Qed.
Lemma mult_continuous f g t : continuity_pt f t -> continuity_pt g t -> continuity_pt (fun u => f u * g u) t.
Proof. exact (continuity_pt_mult f g t). Qed.
Lemma opp_continuous f t : continuity_pt f t -> continuity_pt (fun u => - f u) t.
Proof. exact (continuity_pt_opp f t). Qed.
Lemma div_continuous f g t : continuity_pt f t -> continuity_pt g t -> g t <> 0 -> continuity_pt (fun u => f u / g u) t.
Proof. exact (continuity_pt_div f g t). Qed.
Lemma sqrt_continuous f t : continuity_pt f t -> 0 < f t -> continuity_pt (fun u => sqrt (f u)) t.
Proof. intros C P. exact (continuity_pt_comp f sqrt t C (sqrt_continuity_pt (f t) P)). Qed.
Lemma abs_continuous f t : continuity_pt f t -> continuity_pt (fun u => Rabs (f u)) t.
Proof. intros C. exact (continuity_pt_comp f Rabs t C (Rcontinuity_abs (f t))). Qed.

Ltac continuous := repeat first [assumption | apply constant_continuous | apply plus_continuous | apply minus_continuous |
  apply mult_continuous | apply opp_continuous].

(* An affine function at a direction, both of which move. *)
Lemma affine_continuous t0 (f : R -> affine) (u : R -> vec) : continuity_pt (fun t => vx (fa (f t))) t0 -> continuity_pt (fun t => vy (fa (f t))) t0 ->
  continuity_pt (fun t => fb (f t)) t0 -> continuity_pt (fun t => vx (u t)) t0 -> continuity_pt (fun t => vy (u t)) t0 ->
  continuity_pt (fun t => at_ (f t) (u t)) t0 /\ continuity_pt (fun t => slope (f t) (u t)) t0.
Proof. intros A B C X Y. unfold at_, slope, dot, turn; simpl. split; continuous. Qed.

(* The rising zero of an affine function that moves. *)
Lemma up_continuous t0 (f : R -> affine) : continuity_pt (fun t => vx (fa (f t))) t0 -> continuity_pt (fun t => vy (fa (f t))) t0 ->
  continuity_pt (fun t => fb (f t)) t0 -> crosses (f t0) ->
  continuity_pt (fun t => vx (up (f t))) t0 /\ continuity_pt (fun t => vy (up (f t))) t0.
Proof.
  intros A B C X. unfold crosses in X. unfold up; simpl.
  assert (N : vx (fa (f t0)) * vx (fa (f t0)) + vy (fa (f t0)) * vy (fa (f t0)) <> 0) by (pose proof (sq (fb (f t0))); lra).
  assert (S : continuity_pt (fun t => sqrt (vx (fa (f t)) * vx (fa (f t)) + vy (fa (f t)) * vy (fa (f t)) - fb (f t) * fb (f t))) t0).
  { apply sqrt_continuous; [continuous|lra]. }
  split; (apply div_continuous; [continuous|continuous|exact N]).
Qed.

Section Motion.
  Variable cfg : R -> gen -> generator.
  Hypothesis M : moves cfg.
  Variable t0 : R.

  Lemma seen_continuous l g : continuity_pt (fun t => xx (seen_at (cfg t l) (cfg t g))) t0 /\
    continuity_pt (fun t => xy (seen_at (cfg t l) (cfg t g))) t0 /\ continuity_pt (fun t => xs (seen_at (cfg t l) (cfg t g))) t0.
  Proof using M.
    pose proof (cx_continuous _ M l t0). pose proof (cx_continuous _ M g t0). pose proof (cy_continuous _ M l t0). pose proof (cy_continuous _ M g t0).
    unfold seen_at; simpl. repeat split; [continuous|continuous|].
    apply same_continuity with (g := fun _ => radius (cfg t0 g) - radius (cfg t0 l)); [|apply constant_continuous].
    intros u. rewrite (radii _ M u t0 g), (radii _ M u t0 l). reflexivity.
  Qed.
  Lemma tang_continuous l g : continuity_pt (fun t => tang (seen_at (cfg t l) (cfg t g))) t0.
  Proof using M. destruct (seen_continuous l g) as (A & B & C). unfold tang. continuous. Qed.

  (* The coefficients of K about a base, where the pair is right. *)
  Lemma K_continuous l g : tang (seen_at (cfg t0 l) (cfg t0 g)) <> 0 ->
    continuity_pt (fun t => vx (fa (Kg (cfg t l) (cfg t g)))) t0 /\ continuity_pt (fun t => vy (fa (Kg (cfg t l) (cfg t g)))) t0 /\
    continuity_pt (fun t => fb (Kg (cfg t l) (cfg t g))) t0.
  Proof using M.
    intros N. destruct (seen_continuous l g) as (A & B & C). pose proof (tang_continuous l g) as T.
    split; [|split]; apply (div_continuous _ (fun t => tang (seen_at (cfg t l) (cfg t g)))); assumption.
  Qed.

  (* The sign that a right pair asks for. *)
  Definition right_sign (g h : gen) (t : R) : R :=
    if wall (cfg t0 g) || wall (cfg t0 h) then - tang (seen_at (cfg t g) (cfg t h)) else tang (seen_at (cfg t g) (cfg t h)).
  Lemma right_sign_is g h t : right_pair (cfg t g) (cfg t h) <-> 0 < right_sign g h t.
  Proof using M.
    rewrite right_tang. unfold right_sign. rewrite (walls _ M t g), (walls _ M t h), (walls _ M t0 g), (walls _ M t0 h).
    destruct (_ || _); split; lra.
  Qed.
  Lemma right_sign_continuous g h : continuity_pt (right_sign g h) t0.
  Proof using M.
    pose proof (tang_continuous g h) as T. unfold right_sign. destruct (_ || _); [|exact T]. apply opp_continuous, T.
  Qed.
  Lemma right_after g h : right_pair (cfg t0 g) (cfg t0 h) -> after t0 (fun t => right_pair (cfg t g) (cfg t h)).
  Proof using M.
    intros H. apply right_sign_is in H. apply after_impl with (P := fun t => 0 < right_sign g h t); [intros u; apply right_sign_is|].
    apply after_positive; [apply right_sign_continuous|exact H].
  Qed.
  Lemma right_tang_nonzero l g : wall (cfg t0 l) = false -> right_pair (cfg t0 l) (cfg t0 g) -> tang (seen_at (cfg t0 l) (cfg t0 g)) <> 0.
  Proof using M. intros W H. apply right_tang in H. destruct (_ || _); lra. Qed.

  Section Vertex.
    Variables l j k : gen.
    Hypothesis V : vertex (cfg t0 l) (cfg t0 j) (cfg t0 k).
    Lemma dir_continuous : continuity_pt (fun t => vx (dir (cfg t l) (cfg t j) (cfg t k))) t0 /\ continuity_pt (fun t => vy (dir (cfg t l) (cfg t j) (cfg t k))) t0.
    Proof using M V.
      destruct V as (Wl & Rj & Rk & Rjk & W & _).
      destruct (K_continuous l j (right_tang_nonzero l j Wl Rj)) as (A & B & C). destruct (K_continuous l k (right_tang_nonzero l k Wl Rk)) as (D & E & F).
      unfold dir. apply up_continuous; [| | |apply difference_crosses; assumption]; unfold diff, minus; cbv [fa fb Arc.vx Arc.vy];
        [exact (minus_continuous _ _ _ D A)|exact (minus_continuous _ _ _ E B)|exact (minus_continuous _ _ _ F C)].
    Qed.
    (* The value of another function there. *)
    Lemma K_at_dir_continuous g : tang (seen_at (cfg t0 l) (cfg t0 g)) <> 0 ->
      continuity_pt (fun t => at_ (Kg (cfg t l) (cfg t g)) (dir (cfg t l) (cfg t j) (cfg t k))) t0.
    Proof using M V.
      intros N. destruct dir_continuous as [X Y]. destruct (K_continuous l g N) as (A & B & C).
      exact (proj1 (affine_continuous t0 (fun t => Kg (cfg t l) (cfg t g)) (fun t => dir (cfg t l) (cfg t j) (cfg t k)) A B C X Y)).
    Qed.
    Lemma level_continuous : continuity_pt (fun t => level (cfg t l) (cfg t j) (cfg t k)) t0.
    Proof using M V. destruct V as (Wl & Rj & _). apply K_at_dir_continuous, right_tang_nonzero; assumption. Qed.
    Lemma vertex_after : after t0 (fun t => vertex (cfg t l) (cfg t j) (cfg t k)).
    Proof using M V.
      destruct V as (Wl & Rj & Rk & Rjk & W & L).
      pose proof (after_and _ _ _ (right_after _ _ Rj) (after_and _ _ _ (right_after _ _ Rk) (after_and _ _ _ (right_after _ _ Rjk)
        (after_positive _ _ level_continuous L)))) as H.
      apply (after_impl t0) with (2 := H). intros u (A & B & C & P). unfold vertex.
      rewrite (walls _ M u l), (walls _ M u j), (walls _ M u k), <- (walls _ M t0 l), <- (walls _ M t0 j), <- (walls _ M t0 k). tauto.
    Qed.
  End Vertex.

  (* Sums, products, roots of continuous functions are continuous: a composition rule for affine functions at moving directions. *)
  Lemma at_continuous (f : R -> affine) (u : R -> vec) : continuity_pt (fun t => vx (fa (f t))) t0 -> continuity_pt (fun t => vy (fa (f t))) t0 ->
    continuity_pt (fun t => fb (f t)) t0 -> continuity_pt (fun t => vx (u t)) t0 -> continuity_pt (fun t => vy (u t)) t0 ->
    continuity_pt (fun t => at_ (f t) (u t)) t0 /\ continuity_pt (fun t => slope (f t) (u t)) t0.
  Proof using M. exact (affine_continuous t0 f u). Qed.
End Motion.
