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

(* The edge [l,r,s,e] is legal: its vertices [l,s,r] and [l,r,e] have circles, that of the start is empty of e, that of
   the end is empty of s. *)
Definition legal (l r s e : generator) : Prop :=
  (exists c, vertex_circle c l s r /\ empty_of c e) /\
  (exists c, vertex_circle c l r e /\ empty_of c s).

(* The four of an edge have no common tangent circle where an end of the edge is. *)
Definition not_cotangent (l r s e : generator) : Prop :=
  (exists c, vertex_circle c l s r /\ ~ touches c e) \/ (exists c, vertex_circle c l r e /\ ~ touches c s).

(* Two generators do not overlap: disks are apart or touch, a disk lies within the container. *)
Definition apart (i j : generator) : Prop :=
  let d := length (cx i - cx j) (cy i - cy j) in
  if wall i || wall j then d <= - (radius i + radius j) else radius i + radius j <= d.

(* Two generators touch: disks from outside, a disk and the container from within. *)
Definition in_contact (i j : generator) : Prop :=
  length (cx i - cx j) (cy i - cy j) = if wall i || wall j then - (radius i + radius j) else radius i + radius j.
