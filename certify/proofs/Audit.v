(* The axioms on which the theorems rest. scripts/check-proofs.sh compares what this prints. *)
From Voroproof Require Import Statement.
Print Assumptions certified_is_true.
Print Assumptions diagram_is_voronoi.
Print Assumptions verdict_is_true.
