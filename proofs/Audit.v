(* The axioms on which the theorem rests. scripts/check-proofs.sh compares what this prints. *)
From Voroproof Require Import Statement.
Print Assumptions certified_is_true.
