(* With right tangencies the difference of two of the functions always takes both signs, and its slope at a zero is known. *)
From Coq Require Import Reals Lra.
From Voroproof Require Import Arc.
Open Scope R_scope.

(* A generator seen from the base: centre x, signed radius s, tangency p. *)
Record seen := Seen { xx : R; xy : R; xs : R }.
Definition tang (g : seen) : R := xx g * xx g + xy g * xy g - xs g * xs g.
Definition tang2 (g h : seen) : R := (xx g - xx h) * (xx g - xx h) + (xy g - xy h) * (xy g - xy h) - (xs g - xs h) * (xs g - xs h).
Definition K (g : seen) : affine := Affine (Vec (xx g / tang g) (xy g / tang g)) (xs g / tang g).

Lemma spread g h : tang g <> 0 -> tang h <> 0 ->
  norm (diff (K g) (K h)) * norm (diff (K g) (K h)) - fb (diff (K g) (K h)) * fb (diff (K g) (K h)) = tang2 g h / (tang g * tang h).
Proof.
  intros Hg Hh. rewrite norm_square. unfold diff, minus, K; simpl.
  apply (Rmult_eq_reg_r (tang g * tang g * (tang h * tang h))); [|repeat apply Rmult_integral_contrapositive_currified; assumption].
  replace (((xx g / tang g - xx h / tang h) * (xx g / tang g - xx h / tang h) + (xy g / tang g - xy h / tang h) * (xy g / tang g - xy h / tang h) -
    (xs g / tang g - xs h / tang h) * (xs g / tang g - xs h / tang h)) * (tang g * tang g * (tang h * tang h))) with
    ((xx g * tang h - xx h * tang g) * (xx g * tang h - xx h * tang g) + (xy g * tang h - xy h * tang g) * (xy g * tang h - xy h * tang g) -
     (xs g * tang h - xs h * tang g) * (xs g * tang h - xs h * tang g)) by (field; split; assumption).
  replace (tang2 g h / (tang g * tang h) * (tang g * tang g * (tang h * tang h))) with (tang2 g h * (tang g * tang h)) by (field; split; assumption).
  unfold tang2, tang. ring.
Qed.

(* Order: near the point z, where f falls counterclockwise, of two directions p, q with f q = 0 <= f p the first comes first. *)
Lemma order f p q : unit p -> unit q -> 0 < 1 + dot p q -> at_ f q = 0 -> 0 <= at_ f p ->
  slope f q * (1 + dot p q) + Rabs (dot (fa f) q) * Rabs (cross q p) < 0 -> 0 <= cross p q.
Proof.
  intros Up Uq D Z H S. set (z := cross q p). assert (cross p q = - z) as -> by (unfold z, cross; ring).
  assert (E : at_ f p * (1 + dot p q) = z * (slope f q * (1 + dot p q) - z * dot (fa f) q)).
  { assert (F : at_ f p = dot (fa f) (minus p q)) by (unfold at_, dot, minus in *; simpl in *; lra). rewrite F.
    unfold z, slope, cross, dot, turn, minus; simpl. unfold unit in Up, Uq.
    set (a := vx (fa f)). set (b := vy (fa f)). set (c := vx p) in *. set (d := vy p) in *. set (e := vx q) in *. set (g := vy q) in *.
    assert (Q1 : e * e = 1 - g * g) by lra. assert (Q2 : c * c = 1 - d * d) by lra.
    replace ((a * (c - e) + b * (d - g)) * (1 + (c * e + d * g))) with
      (a * (c - e) + b * (d - g) + a * (c * c * e + c * d * g - e * e * c - d * e * g) + b * (c * d * e + d * d * g - c * e * g - d * (g * g))) by ring.
    replace ((e * d - g * c) * ((a * - g + b * e) * (1 + (c * e + d * g)) - (e * d - g * c) * (a * e + b * g))) with
      ((e * d - g * c) * (a * - g + b * e) + (e * d - g * c) * ((a * - g + b * e) * (c * e + d * g) - (e * d - g * c) * (a * e + b * g))) by ring.
    replace ((a * - g + b * e) * (c * e + d * g) - (e * d - g * c) * (a * e + b * g)) with ((e * e + g * g) * (b * c - a * d)) by ring.
    rewrite Uq. 
    replace (c * c * e) with ((1 - d * d) * e) by (rewrite Q2; ring). replace (e * e * c) with ((1 - g * g) * c) by (rewrite Q1; ring).
    assert (X : (e * d - g * c) * (a * - g + b * e) = - a * g * e * d + a * g * g * c + b * (e * e) * d - b * g * c * e) by ring.
    rewrite X, Q1. assert (Y : (e * d - g * c) * (1 * (b * c - a * d)) = b * c * d * e - a * (d * d) * e - b * g * (c * c) + a * c * d * g) by ring.
    rewrite Y, Q2. ring. }
  apply Rnot_lt_le. intros L. assert (0 < z) by lra.
  assert (B : slope f q * (1 + dot p q) - z * dot (fa f) q < 0).
  { assert (- (z * dot (fa f) q) <= Rabs (dot (fa f) q) * Rabs z); [|fold z in S; lra].
    rewrite Ropp_mult_distr_r, Rmult_comm. rewrite (Rabs_right z) by lra. apply Rmult_le_compat_r; [lra|]. rewrite <- Rabs_Ropp. apply Rle_abs. }
  assert (0 <= at_ f p * (1 + dot p q)) by (apply Rmult_le_pos; lra).
  assert (0 < z * - (slope f q * (1 + dot p q) - z * dot (fa f) q)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
