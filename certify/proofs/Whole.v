(* What the checker accepts is right at every instant: one of the diagrams that the claims allow is the Voronoi diagram. *)
From Coq Require Import ZArith List Bool Reals Lra Lia FMapPositive.
From Voroproof Require Import Geometry Vertex Scale History Replay LifeSound Invariant StepSound Initial Start Checker Arc Spread Envelope Closed Topology Tracked Global.
Import ListNotations.
Open Scope R_scope.

Section Whole.
  Variable P : problem.
  Hypothesis tolerance_nonneg : (0 <= tolerance P)%Z.
  Variables (claims : list claim) (s : state) (n : Z).
  Hypothesis ran : run P (first_state P) claims 0 = (Good s, n).
  Let past := rev claims.
  Let gens : list gen := map fst (PositiveMap.elements (bodies P)).
  Hypothesis true_ : true_history P past.
  Hypothesis start : initial_ok P = true.
  Hypothesis arcs : start_ok P = true.
  Hypothesis box : PositiveMap.mem container (bodies P) = true.

  Lemma in_scene g : In g gens <-> PositiveMap.find g (bodies P) <> None.
  Proof.
    unfold gens. rewrite in_map_iff. split.
    - intros ([h b] & E & I). cbn [fst] in E. subst h. apply PositiveMap.elements_complete in I. congruence.
    - intros F. destruct (PositiveMap.find g (bodies P)) as [b|] eqn:E; [|congruence]. exists (g, b). split; [reflexivity|].
      apply PositiveMap.elements_correct, E.
  Qed.

  (* Turns come at 0 or later. *)
  Lemma later_turns cs : forall s s' n n', (0 <= now s)%Z -> run P s cs n = (Good s', n') ->
    forall c, In c cs -> forall g u v, turn_of c g = Some (u, v) -> (0 <= u)%Z.
  Proof.
    induction cs as [|c cs IH]; cbn [run]; intros s0 s' n0 n' H E d I g u v T; [contradiction|].
    destruct (step P s0 c) as [s1|w] eqn:E1; [|discriminate].
    assert (N : (0 <= now s1)%Z /\ forall g u v, turn_of c g = Some (u, v) -> (0 <= u)%Z).
    { clear - H E1. destruct c as [t f lo hi k k1 k2 k3 k4|t i j vi vj ps b a k ar|t h w ps ar]; cbn [step] in E1.
      - unfold flip in E1. apply try_good in E1 as (sl & _ & E1). apply need_good in E1 as [_ E1]. apply need_good in E1 as [_ E1].
        apply need_good in E1 as [_ E1]. apply try_good in E1 as (gone & _ & E1). apply need_good in E1 as [_ E1].
        apply try_good in E1 as (s2 & E2 & E1). injection E1 as <-. cbn [now]. split; [|discriminate].
        assert (now s2 = now s0) as ->; [|lia].
        revert E2. generalize [k; k1; k2; k3; k4]. intros ks. revert s0 H s2. induction ks as [|m ks IH]; cbn [each]; intros s0 H s2 E2; [injection E2 as <-; reflexivity|].
        apply try_good in E2 as (s3 & E3 & E2). rewrite (IH s3) with (s2 := s2); try assumption.
        + unfold flip_one in E3. apply try_good in E3 as (a1 & _ & E3). apply try_good in E3 as (a2 & _ & E3). injection E3 as <-. reflexivity.
        + unfold flip_one in E3. apply try_good in E3 as (a1 & _ & E3). apply try_good in E3 as (a2 & _ & E3). injection E3 as <-. exact H.
      - unfold collide in E1. apply need_good in E1 as [N E1]. apply Z.leb_le in N.
        apply try_good in E1 as (a1 & _ & E1). apply need_good in E1 as [_ E1]. apply try_good in E1 as (a2 & _ & E1). apply try_good in E1 as (a3 & _ & E1).
        apply need_good in E1 as [_ E1]. apply need_good in E1 as [_ E1]. apply need_good in E1 as [_ E1].
        apply try_good in E1 as (a4 & _ & E1). apply try_good in E1 as (a5 & _ & E1). apply try_good in E1 as (a6 & _ & E1). injection E1 as <-.
        split; [cbn [now at_time]; lia|]. intros g u v T. cbn [turn_of] in T. destruct (Pos.eqb g container); [discriminate|].
        destruct (Pos.eqb g i); [injection T as <- _; lia|]. destruct (Pos.eqb g j); [injection T as <- _; lia|discriminate].
      - unfold manoeuvre in E1. apply need_good in E1 as [N E1]. apply Z.leb_le in N.
        apply try_good in E1 as ([a1 rest] & _ & E1). apply need_good in E1 as [_ E1]. apply need_good in E1 as [_ E1].
        apply try_good in E1 as (a4 & _ & E1). apply try_good in E1 as (a5 & _ & E1). injection E1 as <-.
        split; [cbn [now]; lia|]. intros g u v T. cbn [turn_of] in T. destruct (Pos.eqb g container); [discriminate|].
        destruct (Pos.eqb g h); [injection T as <- _; lia|discriminate]. }
    destruct I as [<-|I]; [exact (proj2 N g u v T)|]. exact (IH s1 s' _ n' (proj1 N) E d I g u v T).
  Qed.

  Lemma place_first l g : all_orderly P l -> (forall c, In c l -> forall h u v, turn_of c h = Some (u, v) -> (0 <= u)%Z) ->
    place P l 0 g = place P [] 0 g.
  Proof.
    induction l as [|c l IH]; intros O L; [reflexivity|].
    pose proof (all_orderly_tail P c l O) as [_ O']. rewrite <- IH; [|exact O'|intros d I; apply L; right; exact I].
    apply place_until; [exact O|]. intros w v E. apply IZR_le. apply (L c (or_introl eq_refl) g w v E).
  Qed.

  Lemma place_at_start g : place P past 0 g = place P [] 0 g.
  Proof.
    apply place_first; [apply (run_good P tolerance_nonneg claims s n ran)|].
    intros c I. apply (later_turns claims (first_state P) s 0 n); [apply Z.le_refl|exact ran|]. apply in_rev, I.
  Qed.

  Lemma radius_proper g : if Pos.eqb g container then IZR (radius_of P g) < 0 else 0 <= IZR (radius_of P g).
  Proof.
    unfold start_ok in arcs. apply andb_prop in arcs as [A _]. apply andb_prop in A as [A _]. rewrite forallb_forall in A.
    assert (B : forall b, PositiveMap.find g (bodies P) = Some b -> Piece.is_proper (Initial.still b g) = true).
    { intros b F. apply (A (g, Initial.still b g)). unfold all_still.
      apply (in_map (fun b => (fst b, Initial.still (snd b) (fst b))) _ (g, b)), PositiveMap.elements_correct, F. }
    unfold radius_of. destruct (PositiveMap.find g (bodies P)) as [b|] eqn:F.
    - specialize (B b eq_refl). unfold Piece.is_proper, Initial.still, span in B. cbn [Piece.mwall Piece.mr size_] in B.
      destruct (Pos.eqb g container); [apply Z.ltb_lt, IZR_lt in B|apply Z.leb_le, IZR_le in B]; exact B.
    - destruct (Pos.eqb_spec g container) as [->|]; [|lra]. rewrite PositiveMap.mem_find, F in box. discriminate.
  Qed.

  Lemma motion : moves (fun t g => place P past t g).
  Proof.
    split; try reflexivity.
    - intros t g N. pose proof (radius_proper g) as R. destruct (Pos.eqb_spec g container); [contradiction|exact R].
    - intros t. exact (radius_proper container).
    - intros g. apply (paths_continuous P tolerance_nonneg claims s n ran).
    - intros g. apply (paths_continuous P tolerance_nonneg claims s n ran).
  Qed.

  Theorem whole : forall t, 0 <= t < IZR (horizon P) -> exists D, allowed P past t D /\ voronoi_at P past t D.
  Proof.
    intros t Ht. destruct (start_sound P start arcs) as [V0 F0]. fold gens in V0, F0.
    pose proof (run_tracked P tolerance_nonneg claims s n ran) as T.
    destruct (global P past true_ T F0 motion) with (t := t) as (D & A & V).
    - replace (place P past 0) with (fun g => place P [] 0 g); [exact V0|]. apply FunctionalExtensionality.functional_extensionality.
      intros g. symmetry. apply place_at_start.
    - exact (flip_lines P tolerance_nonneg claims s n ran).
    - exact (run_stands_closed P tolerance_nonneg claims s n ran).
    - exact (run_instants P tolerance_nonneg claims s n ran).
    - exact Ht.
    - exists D. split; [exact A|]. pose proof (allowed_fits P gens past t D F0 T A) as F. fold gens in V.
      assert (W : forall g, wall (place P past t g) = Pos.eqb g container) by reflexivity.
      assert (Pr : forall g, proper (place P past t g)).
      { intros g. pose proof (radius_proper g) as R. unfold proper. rewrite W. exact R. }
      assert (Side : forall k q a b c, In (k, q) D -> side_of q a b c -> side (map snd D) a b c /\ a <> b).
      { intros k q a b c I S. split; [exists q; split; [apply (in_map snd _ (k, q)), I|exact S]|].
        destruct (edges_stand P past true_ k q t Ht (allowed_names P past t D k q A I)) as (_ & R & _).
        assert (N : el q <> er q).
        { intros E. rewrite E in R. unfold right_pair in R. destruct (wall _ || wall _); lra. }
        destruct S as [(-> & -> & _)|(-> & -> & _)]; congruence. }
      split.
      + intros k q a b c I S. destruct (Side k q a b c I S) as [Sd N].
        destruct (circles_empty gens (place P past t) (map snd D) a b c W Pr F V Sd) as (o & Vo & E); [destruct (Pos.eq_dec a container); [right; left; congruence|left; assumption]|].
        exists o. split; [exact Vo|]. intros g Fg. apply E, in_scene, Fg.
      + intros k q a b c I S. destruct (sides_turn gens (map snd D) F a b c (proj1 (Side k q a b c I S))) as (q' & I' & S').
        apply in_map_iff in I' as ([k' q''] & E & I'). cbn [snd] in E. subst q''. exists k', q'. split; assumption.
      + intros g Fg. destruct (each_has_one gens (map snd D) F g (proj2 (in_scene g) Fg)) as (q & I & H).
        apply in_map_iff in I as ([k q''] & E & I). cbn [snd] in E. subst q''. exists k, q. split; assumption.
      + intros i j Fi Fj N O.
        destruct (overlap_of_neighbours gens (place P past t) (map snd D) i j W Pr F V (proj2 (in_scene i) Fi) (proj2 (in_scene j) Fj) N O) as (q & a & b & I & B & Or & Oab).
        apply in_map_iff in I as ([k q''] & E & I). cbn [snd] in E. subst q''. exists k, q, a, b.
        split; [exact I|]. split; [exact B|]. split; [exact Or|]. split; [exact Oab|].
        destruct (pairs_apart P past true_ k q t Ht (allowed_names P past t D k q A I)) as [X|X].
        * exfalso. apply Oab. destruct B as [[<- <-]|[<- <-]]; [exact X|]. unfold apart in *. rewrite orb_comm, Rplus_comm.
          replace (cx (place P past t (er q)) - cx (place P past t (el q))) with (- (cx (place P past t (el q)) - cx (place P past t (er q)))) by ring.
          replace (cy (place P past t (er q)) - cy (place P past t (el q))) with (- (cy (place P past t (el q)) - cy (place P past t (er q)))) by ring.
          unfold length. rewrite !Rmult_opp_opp. exact X.
        * destruct B as [[<- <-]|[<- <-]]; tauto.
  Qed.
End Whole.
