(* The whole checker. *)
From Coq Require Import ZArith List Bool FMapPositive.
From Voroproof Require Import History Replay Initial Start.
Import ListNotations.
Open Scope Z_scope.

(* Accepts, or says why not and at which claim: the number of claims taken before. *)
Definition check (P : problem) (claims : list claim) : outcome unit * Z :=
  if negb ((0 <=? tolerance P) && initial_ok P && PositiveMap.mem container (bodies P) && start_ok P) then (Bad BadInitial, 0)
  else match run P (first_state P) claims 0 with
  | (Good s, done) => (ending P s, done)
  | (Bad why, done) => (Bad why, done)
  end.
