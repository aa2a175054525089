(* The checker as an OCaml program: checker.ml. Whole numbers become Zarith's by the table ExtrOcamlZBigInt of Coq's
   library, booleans, lists, pairs and options OCaml's by ExtrOcamlBasic, the words of reasons OCaml's strings by
   ExtrOcamlNativeString. Three comparisons are added to the table. *)
From Coq Require Import ZArith Extraction ExtrOcamlBasic ExtrOcamlZBigInt ExtrOcamlNativeString.
From Voroproof Require Import History Replay Files Program.
Extract Constant Pos.eqb => "Big_int_Z.eq_big_int".
Extract Constant Z.ltb => "Big_int_Z.lt_big_int".
Extract Constant Z.leb => "Big_int_Z.le_big_int".
Extraction "checker.ml" judge count_events.
