(* The program's checks of a few generators that move on lines over an interval. All numbers are whole. *)
From Coq Require Import ZArith List Bool.
From Voroproof Require Import Forms Polynomial.
Import ListNotations.
Open Scope Z_scope.

(* A generator that moves from (ax, ay) to (bx, by), both in one unit of length, with its signed radius. *)
Record moving := Moving { ax : Z; ay : Z; bx : Z; by_ : Z; mr : Z; mwall : bool }.

(* Over [a, b] put t = (a + z b)/(1 + z), z in [0, oo): 1 + z times a place is a + z b. *)
Definition prow (i g : moving) : row poly :=
  row_of add sub mul [ax g - ax i; bx g - bx i] [ay g - ay i; by_ g - by_ i] [mr g - mr i; mr g - mr i].
(* The same at the interval's beginning. *)
Definition zrow (i g : moving) : row Z := row_of Z.add Z.sub Z.mul (ax g - ax i) (ay g - ay i) (mr g - mr i).

Definition has_right_sign (w : bool) (p : poly) : bool := is_positive (if w then neg p else p).
Definition with_sign (w : bool) (x : Z) : Z := if w then - x else x.
Definition poly_sign (w : bool) (p : poly) : poly := if w then neg p else p.
Definition is_proper (g : moving) : bool := if mwall g then mr g <? 0 else 0 <=? mr g.

(* A test of x + root y, where m has the sign of (x + root y)(x - root y); x0 and y0 are x and y at the beginning. *)
Definition sum_test := poly -> (unit -> Z) -> (unit -> Z) -> (unit -> poly) -> (unit -> poly) -> bool.

(* x + root y is positive throughout, or not negative. *)
Definition sum_positive : sum_test := fun m x0 y0 x y =>
  if is_positive m then 0 <? x0 tt
  else if is_positive (neg m) then 0 <? y0 tt
  else let px := x tt in let py := y tt in
    (is_positive px && never_negative py) || (never_negative px && is_positive py).

Definition sum_not_negative : sum_test := fun m x0 y0 x y =>
  if is_positive m then 0 <? x0 tt
  else if is_positive (neg m) then 0 <? y0 tt
  else let px := x tt in let py := y tt in
    (never_negative px && never_negative py) || (never_negative m && never_negative px) ||
    (never_negative (neg m) && never_negative py).

Definition sum_not_positive : sum_test := fun m x0 y0 x y =>
  sum_not_negative m (fun u => - x0 u) (fun u => - y0 u) (fun u => neg (x u)) (fun u => neg (y u)).

Notation p_dxy := (dxy sub mul).
Notation p_a := (form_a add sub mul).
Notation p_b := (form_b add sub mul).
Notation p_c := (form_c add sub mul).
Notation p_g := (form_g add sub mul).
Notation p_f := (form_f add sub mul).
Notation p_u := (form_u add sub mul).
Notation p_m := (form_m add sub mul).
Notation p_tangency := (tangency add sub mul).
Notation z_dxy := (dxy Z.sub Z.mul).
Notation z_a := (form_a Z.add Z.sub Z.mul).
Notation z_b := (form_b Z.add Z.sub Z.mul).
Notation z_c := (form_c Z.add Z.sub Z.mul).
Notation z_g := (form_g Z.add Z.sub Z.mul).
Notation z_f := (form_f Z.add Z.sub Z.mul).
Notation z_u := (form_u Z.add Z.sub Z.mul).

(* The circle that touches the disk i and j, k counterclockwise is there. *)
Definition circle_there (wj wk : bool) (j k : row poly) (zj zk : row Z) : bool :=
  has_right_sign wj (rp j) && has_right_sign wk (rp k) && has_right_sign (wj || wk) (p_tangency j k) &&
  negb (wj && wk) &&
  sum_positive (p_m j k) (fun _ => z_u zj zk) (fun _ => with_sign (wj || wk) (z_dxy zj zk))
    (fun _ => p_u j k) (fun _ => poly_sign (wj || wk) (p_dxy j k)).

(* A fan: a disk i and three others; the circles of (i,a,b) and (i,b,c). *)
Definition fan_there (i a b c : moving) : bool :=
  let pa := prow i a in let pb := prow i b in let pc := prow i c in
  let za := zrow i a in let zb := zrow i b in let zc := zrow i c in
  negb (mwall i) && is_proper i && is_proper a && is_proper b && is_proper c &&
  circle_there (mwall a) (mwall b) pa pb za zb && circle_there (mwall b) (mwall c) pb pc zb zc.

(* The in-circle function of c about the first circle, and that of a about the second: the test of both, or of one of them. *)
Definition fan_sums (test : sum_test) (both : bool) (i a b c : moving) : bool :=
  let pa := prow i a in let pb := prow i b in let pc := prow i c in
  let fa := p_a pa pb pc in let fb := p_b pa pb pc in let fc := p_c pa pb pc in
  let f := p_f fa fb fc in
  let za := zrow i a in let zb := zrow i b in let zc := zrow i c in
  let ga := z_a za zb zc in let gb := z_b za zb zc in let gc := z_c za zb zc in
  let first := test f (fun _ => with_sign (mwall c) (z_g za zb ga gb)) (fun _ => with_sign (xorb (mwall c) (mwall a || mwall b)) gc)
    (fun _ => poly_sign (mwall c) (p_g pa pb fa fb)) (fun _ => poly_sign (xorb (mwall c) (mwall a || mwall b)) fc) in
  if eqb first both then
    test f (fun _ => with_sign (mwall a) (z_g zb zc ga gb)) (fun _ => with_sign (xorb (mwall a) (mwall b || mwall c)) gc)
      (fun _ => poly_sign (mwall a) (p_g pb pc fa fb)) (fun _ => poly_sign (xorb (mwall a) (mwall b || mwall c)) fc)
  else first.
(* c does not enter the first circle, a does not enter the second. *)
Definition fan_empty : moving -> moving -> moving -> moving -> bool := fan_sums sum_not_negative true.
Definition sum_positive_at (f x y : Z) : bool :=
  ((0 <? f) && (0 <? x)) || ((f <? 0) && (0 <? y)) || ((0 <? x) && (0 <=? y)) || ((0 <=? x) && (0 <? y)).

(* At the interval's beginning, where the first circle touches c: its contacts with i, b, c are counterclockwise, so that it is the
   second circle, too. (There may be two circles that touch all four.) *)
Definition fan_short (i a b c : moving) : bool :=
  let za := zrow i a in let zb := zrow i b in let zc := zrow i c in
  let dxp := dxp Z.sub Z.mul in let dyp := dyp Z.sub Z.mul in let dsp := dsp Z.sub Z.mul in
  let x := - dsp za zb * (dxp zb zc * dyp za zb - dyp zb zc * dxp za zb) in
  let y := dxp zb zc * dxp za zb + dyp zb zc * dyp za zb in
  let gamma := rp za * rp zb * tangency Z.add Z.sub Z.mul za zb in
  sum_positive_at (x * x - gamma * (y * y)) (with_sign (mwall b || mwall c) x) (with_sign (xorb (mwall b || mwall c) (mwall a || mwall b)) y).

(* The first circle is not empty of c but for a touch, nor the second of a. *)
Definition fan_past : moving -> moving -> moving -> moving -> bool := fan_sums sum_not_positive true.
(* The first circle does not touch c, or the second does not touch a. *)
Definition fan_long : moving -> moving -> moving -> moving -> bool := fan_sums sum_positive false.

(* The halves of the interval, in half the unit of length. *)
Definition left (g : moving) : moving := Moving (2 * ax g) (2 * ay g) (ax g + bx g) (ay g + by_ g) (2 * mr g) (mwall g).
Definition right_ (g : moving) : moving := Moving (ax g + bx g) (ay g + by_ g) (2 * bx g) (2 * by_ g) (2 * mr g) (mwall g).

Section Halving.
  Variable test : moving -> moving -> moving -> moving -> bool.
  Fixpoint halving (depth : nat) (i a b c : moving) : bool :=
    if test i a b c then true
    else match depth with
    | O => false
    | S d => halving d (left i) (left a) (left b) (left c) && halving d (right_ i) (right_ a) (right_ b) (right_ c)
    end.
End Halving.

(* Of an edge [l,r,s,e] the fan about l, or about r where l is the container. *)
Definition by_fan {T} (test : moving -> moving -> moving -> moving -> T) (l r s e : moving) : T :=
  if mwall l then test r e l s else test l s r e.

Definition depth : nat := 64.
Definition edge_there : moving -> moving -> moving -> moving -> bool := by_fan (halving fan_there depth).
(* At each instant it is legal for a while, or it has a length. *)
Definition edge_lasts : moving -> moving -> moving -> moving -> bool :=
  by_fan (halving (fun i a b c => fan_there i a b c && (fan_empty i a b c || fan_long i a b c)) depth).
Definition edge_legal : moving -> moving -> moving -> moving -> bool :=
  by_fan (halving (fun i a b c => fan_there i a b c && fan_empty i a b c) depth).

(* At the interval's beginning: neither circle is empty of the generator opposite. *)
Definition sum_negative_at (f x y : Z) : bool :=
  ((0 <? f) && (x <? 0)) || ((f <? 0) && (y <? 0)) || ((x <? 0) && (y <=? 0)) || ((x <=? 0) && (y <? 0)).
Definition fan_entered (i a b c : moving) : bool :=
  let za := zrow i a in let zb := zrow i b in let zc := zrow i c in
  let ga := z_a za zb zc in let gb := z_b za zb zc in let gc := z_c za zb zc in
  let f := z_f ga gb gc in
  sum_negative_at f (with_sign (mwall c) (z_g za zb ga gb)) (with_sign (xorb (mwall c) (mwall a || mwall b)) gc) &&
  sum_negative_at f (with_sign (mwall a) (z_g zb zc ga gb)) (with_sign (xorb (mwall a) (mwall b || mwall c)) gc).

(* At the interval's beginning: both circles touch all four. *)
Definition sum_zero_at (f x y : Z) : bool := (f =? 0) && ((x =? 0) && (y =? 0) || (x <? 0) && (0 <? y) || (0 <? x) && (y <? 0)).
Definition fan_tied (i a b c : moving) : bool :=
  let za := zrow i a in let zb := zrow i b in let zc := zrow i c in
  let ga := z_a za zb zc in let gb := z_b za zb zc in let gc := z_c za zb zc in
  let f := z_f ga gb gc in
  sum_zero_at f (with_sign (mwall c) (z_g za zb ga gb)) (with_sign (xorb (mwall c) (mwall a || mwall b)) gc) &&
  sum_zero_at f (with_sign (mwall a) (z_g zb zc ga gb)) (with_sign (xorb (mwall a) (mwall b || mwall c)) gc).

(* At the interval's beginning: the first circle of the fan does not touch c, or the second not a. *)
Definition fan_strict (i a b c : moving) : bool :=
  let za := zrow i a in let zb := zrow i b in let zc := zrow i c in
  let ga := z_a za zb zc in let gb := z_b za zb zc in let gc := z_c za zb zc in
  let f := z_f ga gb gc in
  sum_positive_at f (with_sign (mwall c) (z_g za zb ga gb)) (with_sign (xorb (mwall c) (mwall a || mwall b)) gc) ||
  sum_positive_at f (with_sign (mwall a) (z_g zb zc ga gb)) (with_sign (xorb (mwall a) (mwall b || mwall c)) gc).

(* The same where the circles are there. *)
Definition fan_strict_at (i a b c : moving) : bool := fan_there i a b c && fan_strict i a b c.
Definition fan_legal_at (i a b c : moving) : bool := fan_there i a b c && fan_empty i a b c.
Definition fan_tied_at (i a b c : moving) : bool := fan_there i a b c && fan_tied i a b c.
Definition fan_short_at (i a b c : moving) : bool := fan_tied_at i a b c && fan_short i a b c.
Definition fan_past_at (i a b c : moving) : bool := fan_there i a b c && fan_past i a b c.
Definition fan_entered_at (i a b c : moving) : bool := fan_there i a b c && fan_entered i a b c.

(* Two generators do not overlap. *)
Definition pair_gap (i j : moving) : poly :=
  let x := [ax j - ax i; bx j - bx i] in let y := [ay j - ay i; by_ j - by_ i] in let r := [mr i + mr j; mr i + mr j] in
  sub (add (mul x x) (mul y y)) (mul r r).
(* A quadratic without sign changes of its coefficients, or with at most one root. *)
Definition quadratic_not_negative (p : poly) : bool :=
  never_negative p ||
  match p with [c; b; a] => (0 <=? c) && (0 <=? a) && (b * b <=? 4 * a * c) | _ => false end.
Fixpoint pair_apart (depth : nat) (i j : moving) : bool :=
  if quadratic_not_negative (poly_sign (mwall i || mwall j) (pair_gap i j)) then
    if mwall i || mwall j then mr i + mr j <=? 0 else 0 <=? mr i + mr j
  else match depth with
  | O => false
  | S d => pair_apart d (left i) (left j) && pair_apart d (right_ i) (right_ j)
  end.
