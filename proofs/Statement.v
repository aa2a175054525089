(* The theorem. Geometry.v and History.v define every word of it; docs/proved.md says it in prose. *)
From Coq Require Import ZArith List Bool FMapPositive.
From Voroproof Require Import History Replay Initial Checker StepSound InitialSound.
Import ListNotations.

(* What the program accepts is true: the initial diagram at time 0, every claim after those before it, and the diagram and
   the paths at every instant from 0 to the horizon that is in no bracket of a flip. *)
Theorem certified_is_true : forall (P : problem) (claims : list claim) (n : Z),
  check P claims = (Good tt, n) -> true_initial P /\ true_history P (rev claims).
Proof.
  intros P claims n H. unfold check in H.
  destruct ((0 <=? tolerance P)%Z && initial_ok P) eqn:I; [|discriminate]. apply andb_prop in I as [T I]. apply Z.leb_le in T.
  simpl negb in H. cbv iota in H. split; [apply initial_sound, I|].
  destruct (run P (first_state P) claims 0) as [[s|w] done_] eqn:R; [|discriminate]. injection H as E _.
  destruct (run_sound P T claims [] (first_state P) 0 s done_ (first_good P)) as [G A]; [intros [|? ?] ? ? X; discriminate|exact R|].
  rewrite app_nil_r in *. apply (ending_sound P _ s); assumption.
Qed.
