(* The forms of design/predicates.md, over any kind of number. They are used three times: over R in the proofs, over
   polynomials with whole coefficients and over whole numbers in the program. *)
From Coq Require Import ZArith.

Set Implicit Arguments.

(* A generator seen from a base disk: differences of centre and signed radius, and the tangency of the two. *)
Record row (A : Type) := Row { rx : A; ry : A; rs : A; rp : A }.

Section Forms.
  Variable A : Type.
  Variables add sub mul : A -> A -> A.
  Infix "+" := add.
  Infix "-" := sub.
  Infix "*" := mul.

  Definition row_of (x y s : A) : row A := Row x y s (x * x + y * y - s * s).

  (* The minors of two rows. *)
  Definition dxy (j k : row A) := rx j * ry k - ry j * rx k.
  Definition dxs (j k : row A) := rx j * rs k - rs j * rx k.
  Definition dys (j k : row A) := ry j * rs k - rs j * ry k.
  Definition dxp (j k : row A) := rx j * rp k - rp j * rx k.
  Definition dyp (j k : row A) := ry j * rp k - rp j * ry k.
  Definition dsp (j k : row A) := rs j * rp k - rp j * rs k.

  (* The tangency of the two generators of two rows. *)
  Definition tangency (j k : row A) :=
    let x := rx j - rx k in let y := ry j - ry k in let s := rs j - rs k in x * x + y * y - s * s.

  (* The determinants of the paper's Eq. (3). *)
  Definition form_a (j k e : row A) := rx e * dsp j k - rs e * dxp j k + rp e * dxs j k.
  Definition form_b (j k e : row A) := ry e * dsp j k - rs e * dyp j k + rp e * dys j k.
  Definition form_c (j k e : row A) := rx e * dyp j k - ry e * dxp j k + rp e * dxy j k.

  (* In-circle: g + sigma sqrt(gamma) c, times its conjugate n f. *)
  Definition form_g (j k : row A) (a b : A) := dxp j k * a + dyp j k * b.
  Definition form_f (a b c : A) := a * a + b * b - c * c.

  (* Existence: u + sigma sqrt(gamma) dxy, times its conjugate n m. *)
  Definition form_u (j k : row A) := dxp j k * dxs j k + dyp j k * dys j k.
  Definition form_m (j k : row A) := let a := dxs j k in let b := dys j k in let c := dxy j k in a * a + b * b - c * c.
End Forms.

(* A map that keeps the operations keeps the forms. *)
Section Homomorphism.
  Variables A B : Type.
  Variables adda suba mula : A -> A -> A.
  Variables addb subb mulb : B -> B -> B.
  Variable h : A -> B.
  Hypothesis h_add : forall x y, h (adda x y) = addb (h x) (h y).
  Hypothesis h_sub : forall x y, h (suba x y) = subb (h x) (h y).
  Hypothesis h_mul : forall x y, h (mula x y) = mulb (h x) (h y).

  Definition row_map (j : row A) : row B := Row (h (rx j)) (h (ry j)) (h (rs j)) (h (rp j)).

  Ltac by_parts := intros; cbv delta [tangency form_a form_b form_c form_g form_f form_u form_m dxy dxs dys dxp dyp dsp row_of row_map]; simpl;
    repeat (rewrite h_add || rewrite h_sub || rewrite h_mul); reflexivity.

  Lemma map_row x y s : row_map (row_of adda suba mula x y s) = row_of addb subb mulb (h x) (h y) (h s).
  Proof. by_parts. Qed.
  Lemma map_dxy j k : h (dxy suba mula j k) = dxy subb mulb (row_map j) (row_map k).
  Proof. by_parts. Qed.
  Lemma map_tangency j k : h (tangency adda suba mula j k) = tangency addb subb mulb (row_map j) (row_map k).
  Proof. by_parts. Qed.
  Lemma map_a j k e : h (form_a adda suba mula j k e) = form_a addb subb mulb (row_map j) (row_map k) (row_map e).
  Proof. by_parts. Qed.
  Lemma map_b j k e : h (form_b adda suba mula j k e) = form_b addb subb mulb (row_map j) (row_map k) (row_map e).
  Proof. by_parts. Qed.
  Lemma map_c j k e : h (form_c adda suba mula j k e) = form_c addb subb mulb (row_map j) (row_map k) (row_map e).
  Proof. by_parts. Qed.
  Lemma map_g j k a b : h (form_g adda suba mula j k a b) = form_g addb subb mulb (row_map j) (row_map k) (h a) (h b).
  Proof. by_parts. Qed.
  Lemma map_f a b c : h (form_f adda suba mula a b c) = form_f addb subb mulb (h a) (h b) (h c).
  Proof. by_parts. Qed.
  Lemma map_u j k : h (form_u adda suba mula j k) = form_u addb subb mulb (row_map j) (row_map k).
  Proof. by_parts. Qed.
  Lemma map_m j k : h (form_m adda suba mula j k) = form_m addb subb mulb (row_map j) (row_map k).
  Proof. by_parts. Qed.
End Homomorphism.
