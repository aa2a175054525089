(* The cyclic order of unit vectors: what the walk (Cover.v) asks for. *)
From Coq Require Import Reals Lra.
From Voroproof Require Import Arc.
Open Scope R_scope.

Definition ccw (a b c : vec) : Prop := 0 < cross (minus b a) (minus c a).

Lemma ccw_turn a b c : ccw a b c -> ccw b c a.
Proof. unfold ccw, cross, minus; simpl. lra. Qed.

Lemma ccw_not a b c : ccw a b c -> ~ ccw a c b.
Proof. unfold ccw, cross, minus; simpl. lra. Qed.

Lemma ccw_distinct a b c : ccw a b c -> b <> a /\ c <> a.
Proof. unfold ccw, cross, minus; simpl. split; intros ->; lra. Qed.

Lemma ccw_dec a b c : {ccw a b c} + {~ ccw a b c}.
Proof. apply Rlt_dec. Qed.

(* From a, counterclockwise is falling key. *)
Lemma cross_key a b c : unit a -> unit b -> unit c -> b <> a -> c <> a ->
  cross (minus b a) (minus c a) = (1 - dot a b) * (1 - dot a c) * (key a b - key a c).
Proof.
  intros Ua Ub Uc Nb Nc. pose proof (chord_key a c b Ua Uc Ub Nc Nb) as E.
  replace (cross (minus b a) (minus c a)) with (chord c b a) by (unfold chord, cross, minus; simpl; ring). rewrite E. ring.
Qed.

Lemma ccw_key a b c : unit a -> unit b -> unit c -> b <> a -> c <> a -> (ccw a b c <-> key a c < key a b).
Proof.
  intros Ua Ub Uc Nb Nc. unfold ccw. rewrite cross_key by assumption.
  pose proof (not_one a b Ua Ub Nb) as P1. pose proof (not_one a c Ua Uc Nc) as P2.
  assert (P : 0 < (1 - dot a b) * (1 - dot a c)) by (apply Rmult_lt_0_compat; assumption). split; intros H.
  - apply Rnot_le_lt. intros L. assert (0 <= (1 - dot a b) * (1 - dot a c) * (key a c - key a b)) by (apply Rmult_le_pos; lra). lra.
  - apply Rmult_lt_0_compat; lra.
Qed.

Lemma ccw_trans a b c d : unit a -> unit b -> unit c -> unit d -> ccw a b c -> ccw a c d -> ccw a b d.
Proof.
  intros Ua Ub Uc Ud H1 H2. destruct (ccw_distinct _ _ _ H1) as [N1 N2]. destruct (ccw_distinct _ _ _ H2) as [_ N3].
  apply ccw_key in H1; try assumption. apply ccw_key in H2; try assumption. apply ccw_key; try assumption. lra.
Qed.

(* The key is one to one: u is the second point of the line through v with that direction. *)
Lemma key_one v p q : unit v -> unit p -> unit q -> p <> v -> q <> v -> key v p = key v q -> p = q.
Proof.
  intros Uv Up Uq Np Nq E. pose proof (not_one v p Uv Up Np) as P1. pose proof (not_one v q Uv Uq Nq) as P2.
  (* cross = key (1 - dot) and dot^2 + cross^2 = 1 give 1 + dot = key^2 (1 - dot) *)
  assert (D : forall u, unit u -> 0 < 1 - dot v u -> 1 + dot v u = key v u * key v u * (1 - dot v u)).
  { intros u Uu P. apply (Rmult_eq_reg_r (1 - dot v u)); [|lra].
    replace (key v u * key v u * (1 - dot v u) * (1 - dot v u)) with (cross v u * cross v u) by (unfold key; field; lra).
    unfold dot, cross, unit in *.
    replace ((1 + (vx v * vx u + vy v * vy u)) * (1 - (vx v * vx u + vy v * vy u))) with
      (1 - (vx v * vx v + vy v * vy v) * (vx u * vx u + vy u * vy u) + (vx v * vy u - vy v * vx u) * (vx v * vy u - vy v * vx u)) by ring.
    rewrite Uv, Uu. ring. }
  pose proof (D p Up P1) as D1. pose proof (D q Uq P2) as D2. rewrite E in D1.
  assert (S : 0 < 1 + key v q * key v q) by (pose proof (sq (key v q)); lra).
  assert (dot v p = dot v q) as Ed.
  { apply (Rmult_eq_reg_r (1 + key v q * key v q)); lra. }
  assert (cross v p = cross v q) as Ec.
  { replace (cross v p) with (key v p * (1 - dot v p)) by (unfold key; field; lra).
    replace (cross v q) with (key v q * (1 - dot v q)) by (unfold key; field; lra). rewrite E, Ed. reflexivity. }
  destruct p as [a b], q as [c d], v as [e f]. unfold dot, cross, unit in *; simpl in *. f_equal.
  - replace a with ((e * e + f * f) * a) by (rewrite Uv; ring). replace c with ((e * e + f * f) * c) by (rewrite Uv; ring).
    replace ((e * e + f * f) * a) with (e * (e * a + f * b) - f * (e * b - f * a)) by ring. rewrite Ed, Ec. ring.
  - replace b with ((e * e + f * f) * b) by (rewrite Uv; ring). replace d with ((e * e + f * f) * d) by (rewrite Uv; ring).
    replace ((e * e + f * f) * b) with (f * (e * a + f * b) + e * (e * b - f * a)) by ring. rewrite Ed, Ec. ring.
Qed.

Lemma ccw_total a b c : unit a -> unit b -> unit c -> a <> b -> b <> c -> a <> c -> ccw a b c \/ ccw a c b.
Proof.
  intros Ua Ub Uc N1 N2 N3. destruct (Rtotal_order (key a b) (key a c)) as [H|[H|H]].
  - right. apply ccw_key; congruence || assumption.
  - destruct N2. apply (key_one a); congruence || assumption.
  - left. apply ccw_key; congruence || assumption.
Qed.

(* Three affine functions that rise along the circle near a point: one order of their zeros decides all. Here along any
   set on which "before" is a linear order; f, g, h = f + g rise, with zeros p, q, r. *)
Section Rising.
  Variables (A : Type) (before : A -> A -> Prop) (f g : A -> R) (p q r : A).
  Hypothesis total : forall a b, before a b \/ a = b \/ before b a.
  Hypothesis rise_f : forall a b, before a b -> f a < f b.
  Hypothesis rise_g : forall a b, before a b -> g a < g b.
  Hypothesis fp : f p = 0. Hypothesis gq : g q = 0. Hypothesis hr : f r + g r = 0.
  (* f = K_k - K_j (zero p = jk), g = K_m - K_k (zero q = km), f + g = K_m - K_j (zero r = jm) *)
  Lemma rising : (g p <= 0 <-> 0 <= f q) /\ (g p <= 0 <-> 0 <= f r).
  Proof.
    assert (T : forall x y, (f x < f y /\ g x < g y) \/ (f x = f y /\ g x = g y) \/ (f y < f x /\ g y < g x)).
    { intros x y. destruct (total x y) as [H|[H|H]]; [left|right; left|right; right]; [|rewrite H|]; auto. }
    destruct (T p q) as [H|[H|H]]; destruct (T p r) as [I|[I|I]]; destruct (T q r) as [J|[J|J]]; lra.
  Qed.
End Rising.
