(* What the statement speaks of at one instant: generators, circles, vertices. No proofs. *)
From Coq Require Import Reals Bool.
Open Scope R_scope.

(* A generator at an instant. A disk has its radius; the container, of radius R, has radius -R and wall = true. *)
Record generator := Generator { cx : R; cy : R; radius : R; wall : bool }.

Definition length (x y : R) : R := sqrt (x * x + y * y).

(* The distance of a point to a generator: to a disk's boundary, negative inside; to the container's from within. *)
Definition distance (g : generator) (x y : R) : R :=
  let d := length (x - cx g) (y - cy g) in
  if wall g then - radius g - d else d - radius g.

Record circle := Circle { ox : R; oy : R; size : R }.

Definition touches (c : circle) (g : generator) : Prop := distance g (ox c) (oy c) = size c.
Definition empty_of (c : circle) (g : generator) : Prop := size c <= distance g (ox c) (oy c).

(* The unit vector from the circle's centre to the point where it touches g. *)
Definition contact_x (c : circle) (g : generator) : R :=
  (if wall g then -1 else 1) * (cx g - ox c) / length (cx g - ox c) (cy g - oy c).
Definition contact_y (c : circle) (g : generator) : R :=
  (if wall g then -1 else 1) * (cy g - oy c) / length (cx g - ox c) (cy g - oy c).

(* The contacts with i, j, k follow each other counterclockwise. *)
Definition counterclockwise (c : circle) (i j k : generator) : Prop :=
  0 < (contact_x c j - contact_x c i) * (contact_y c k - contact_y c i) -
      (contact_y c j - contact_y c i) * (contact_x c k - contact_x c i).

(* c is the circle of the vertex [i,j,k]. *)
Definition vertex_circle (c : circle) (i j k : generator) : Prop :=
  touches c i /\ touches c j /\ touches c k /\ counterclockwise c i j k.

(* Neither of two generators lies in the other: disks have a common tangent from outside; a disk does not surround the container. *)
Definition right_pair (g h : generator) : Prop :=
  let p := (cx g - cx h) * (cx g - cx h) + (cy g - cy h) * (cy g - cy h) - (radius g - radius h) * (radius g - radius h) in
  if wall g || wall h then p < 0 else 0 < p.

(* The circles of the vertices [l,s,r] and [l,r,e] of an edge [l,r,s,e], and the generator at its other end: e for that of the
   start, s for that of the end. *)
Definition circles (say : circle -> generator -> Prop) (l r s e : generator) : Prop :=
  (exists c, vertex_circle c l s r /\ say c e) /\ (exists c, vertex_circle c l r e /\ say c s).

(* The edge is there; it is legal; both its circles touch all four; they are entered; they touch or are entered. *)
Definition there : generator -> generator -> generator -> generator -> Prop := circles (fun _ _ => True).
Definition legal : generator -> generator -> generator -> generator -> Prop := circles empty_of.
Definition cotangent : generator -> generator -> generator -> generator -> Prop := circles touches.
Definition entered : generator -> generator -> generator -> generator -> Prop := circles (fun c g => ~ empty_of c g).
Definition passed : generator -> generator -> generator -> generator -> Prop := circles (fun c g => touches c g \/ ~ empty_of c g).

(* The four of an edge have no common tangent circle where an end of the edge is. *)
Definition not_cotangent (l r s e : generator) : Prop :=
  (exists c, vertex_circle c l s r /\ ~ touches c e) \/ (exists c, vertex_circle c l r e /\ ~ touches c s).

(* The edge is pinched: its vertices are one, their circle touches all four. (There may be two circles that touch all four.) *)
Definition pinched (l r s e : generator) : Prop := exists c, vertex_circle c l s r /\ vertex_circle c l r e.

(* The edge stands: it is there, and of its generators those that share a vertex are right. *)
Definition stands (l r s e : generator) : Prop :=
  there l r s e /\ right_pair l r /\ right_pair l s /\ right_pair l e /\ right_pair r s /\ right_pair r e.

(* The edge lasts at t, while the four move: it stands, and it has a length, or it is legal for a while from t on. *)
Definition lasts (l r s e : R -> generator) (t : R) : Prop :=
  stands (l t) (r t) (s t) (e t) /\
  (not_cotangent (l t) (r t) (s t) (e t) \/ exists u, t < u /\ forall w, t <= w < u -> legal (l w) (r w) (s w) (e w)).

(* Two generators do not overlap: disks are apart or touch, a disk lies within the container. *)
Definition apart (i j : generator) : Prop :=
  let d := length (cx i - cx j) (cy i - cy j) in
  if wall i || wall j then d <= - (radius i + radius j) else radius i + radius j <= d.

(* Two generators touch: disks from outside, a disk and the container from within. *)
Definition in_contact (i j : generator) : Prop :=
  length (cx i - cx j) (cy i - cy j) = if wall i || wall j then - (radius i + radius j) else radius i + radius j.
