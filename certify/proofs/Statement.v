(* The theorem. Geometry.v and History.v define every word of it; docs/proved.md says it at length.

   Disks move in a circular container. Each runs on a line until a claimed collision or maneuver turns it. The Voronoi
   diagram of disks and container is given by its edges: [l,r,s,e] lies between l and r and leads from the vertex [l,s,r] to
   the vertex [l,r,e]. A vertex is a point at one distance from three generators, the contacts of its circle being
   counterclockwise in the order of its name.

   A history claims what the edges are at time 0, which of them flip and when, which disks collide when and with what
   velocities, and which maneuvers take place. All numbers are whole multiples of some units. [rev claims] is the history with
   the last claim first; the program has found, for each flip, a bracket around its time.

   The theorem: if the program accepts, then

   - true_initial: at time 0 the edges fit together, they name generators of the scene, and the circle of each vertex is there and
     enters no generator at all;
   - true_history, claims_true: each claim is true after those before it. A flip's edge is legal when its bracket begins and
     entered when it ends, the bracket lies within the tolerance of the claimed time and is no wider than rounding asks for, and in between
     the circle of a vertex touches all four generators. A collision is of two neighbours that come into contact within the tolerance, and obeys
     the law. A maneuver is the scene's next of that disk;
   - maneuvers_done: no maneuver is left out;
   - edges_remain: each number of an edge names an edge at all times;
   - edges_legal: at every real time from 0 on, before the horizon, each edge outside its brackets has both circles, and neither
     enters the generator at the edge's other end;
   - edges_stand, edges_last: within a bracket of a flip beside it, an edge has both circles by each name that it may have, and has a length or
     is legal for a while;
   - pairs_apart: at every time, by each name, its two generators do not overlap but near a claimed collision of the two: within the
     tolerance before its time, or after it where they overlap at its time.

   The second theorem is about the whole diagram: at every real time from 0 on, before the horizon, one of the diagrams that the claims
   allow (each flip whose bracket holds the time is over, or is not) is the Voronoi diagram: voronoi_at. The circle of each of its
   vertices is empty of all generators, and whatever overlaps does so beside a neighbour, near a claimed collision.

   The third theorem says the same of the whole program but for the reading of files: of the fractions that files give. Its units,
   whole numbers and claims are those of Files.v, and it says that they stand for these fractions. *)
From Coq Require Import ZArith QArith List Bool Reals FMapPositive.
From Voroproof Require Import History Replay Initial Start Checker StepSound InitialSound Whole Files Units Search UnitsSound Program.
Import ListNotations.
Open Scope Z_scope.

(* What the program accepts is true: the initial diagram at time 0, every claim after those before it, and the diagram and
   the paths at every instant from 0 to the horizon that is in no bracket of a flip. *)
Theorem certified_is_true : forall (P : problem) (claims : list claim) (n : Z),
  check P claims = (Good tt, n) -> true_initial P /\ true_history P (rev claims).
Proof.
  intros P claims n H. unfold check in H.
  destruct ((0 <=? tolerance P)%Z && initial_ok P && PositiveMap.mem container (bodies P) && start_ok P) eqn:I; [|discriminate].
  apply andb_prop in I as [I _]. apply andb_prop in I as [I _]. apply andb_prop in I as [T I]. apply Z.leb_le in T.
  simpl negb in H. cbv iota in H. split; [apply initial_sound, I|].
  destruct (run P (first_state P) claims 0) as [[s|w] done_] eqn:R; [|discriminate]. injection H as E _.
  destruct (run_sound P T claims [] (first_state P) 0 s done_ (first_good P)) as [G A]; [intros [|? ?] ? ? X; discriminate|exact R|].
  rewrite app_nil_r in *. apply (ending_sound P _ s); assumption.
Qed.

(* At every instant one of the diagrams that the claims allow is the Voronoi diagram. *)
Theorem diagram_is_voronoi : forall (P : problem) (claims : list claim) (n : Z), check P claims = (Good tt, n) ->
  forall t : R, (0 <= t < IZR (horizon P))%R -> exists D, allowed P (rev claims) t D /\ voronoi_at P (rev claims) t D.
Proof.
  intros P claims n H. pose proof (proj2 (certified_is_true P claims n H)) as True_. unfold check in H.
  destruct ((0 <=? tolerance P)%Z && initial_ok P && PositiveMap.mem container (bodies P) && start_ok P) eqn:I; [|discriminate].
  apply andb_prop in I as [I A]. apply andb_prop in I as [I B]. apply andb_prop in I as [T I]. apply Z.leb_le in T.
  simpl negb in H. cbv iota in H.
  destruct (run P (first_state P) claims 0) as [[s|w] done_] eqn:R; [|discriminate].
  exact (whole P T claims s done_ R True_ I A B).
Qed.

(* The same of the fractions that files give, which are those of the scene s and the history h. *)
Theorem verdict_is_true : forall (s : scene) (h : history) (tau lambda : Q),
  judge s h tau lambda = Certified ->
  exists (t v m : Z) (P : problem) (claims : list claim), 0 < t /\ 0 < v /\ 0 < m /\
    problem_is t v m s h tau lambda P /\ Forall2 (event_is t v) (events h) claims /\
    true_initial P /\ true_history P (rev claims) /\
    forall u : R, (0 <= u < IZR (horizon P))%R -> exists D, allowed P (rev claims) u D /\ voronoi_at P (rev claims) u D.
Proof.
  intros s h tau lambda H. unfold judge in H. set (t := unit_of_time s h tau) in *. set (v := unit_of_velocity s h t) in *.
  destruct (problem_of t v (unit_of_mass s) s h tau lambda) as [P|] eqn:E; [|discriminate].
  destruct (problem_ok _ _ _ _ _ _ _ _ E) as (Ht & Hv & Hm & I).
  destruct (scene_wrong P); [discriminate|]. destruct (stops h); [discriminate|]. destruct (negb (counted h)); [discriminate|].
  destruct (first_edges h); [|discriminate]. destruct (disks s) as [|? [|? ?]]; [discriminate|discriminate|].
  destruct (all (event_of t v) (events h)) as [es|] eqn:A; [|discriminate]. unfold of_claims in H.
  destruct (search P (first_finder P) es (limits P es) [] 0) as [[claims|] n] eqn:S; [|discriminate].
  apply search_ok in S as (cs & -> & <-). simpl in H.
  destruct (check P cs) as [[[]|] k] eqn:C; [|discriminate]. destruct (certified_is_true P cs k C).
  exists t, v, (unit_of_mass s), P, cs. repeat (split; [assumption|]).
  split; [|split; [assumption|split; [assumption|exact (diagram_is_voronoi P cs k C)]]].
  apply all_ok in A. clear - A. revert A. generalize (events h). induction cs as [|c cs IH]; simpl; intros l A; inversion A; constructor.
  - apply event_ok. assumption.
  - apply IH. assumption.
Qed.
