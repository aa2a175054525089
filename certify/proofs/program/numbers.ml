(* The numbers of files and options (docs/formats.md, section 1), as exact fractions. *)

exception Invalid of string

let invalid format = Printf.ksprintf (fun text -> raise (Invalid text)) format

let fraction = Str.regexp {|\(-?\)\([0-9]+\)/\([0-9]+\)|}
let decimal = Str.regexp {|\(-?\)\([0-9]+\)\(\.\([0-9]+\)\)?\([eE]\([-+]?[0-9]+\)\)?|}
let hexadecimal = Str.regexp {|\(-?\)0[xX]\([0-9a-fA-F]+\)\(\.\([0-9a-fA-F]+\)\)?\([pP]\([-+]?[0-9]+\)\)?|}
let json_number = Str.regexp {|-?\(0\|[1-9][0-9]*\)\(\.[0-9]+\)?\([eE][-+]?[0-9]+\)?|}

(* The whole text is of the pattern. *)
let is pattern text = Str.string_match pattern text 0 && Str.match_end () = String.length text

let power base exponent =
  let size = Q.of_bigint (Z.pow (Z.of_int base) (abs exponent)) in
  if exponent < 0 then Q.inv size else size

let longest = 4096

(* The digits that [decimal] or [hexadecimal] has just found in the text; each behind the point counts as [step] of the exponent. *)
let scaled text prefix base step most =
  let group k = try Str.matched_group k text with Not_found -> "" in
  let exponent = match group 6 with "" -> 0 | e -> ( match int_of_string_opt e with Some e -> e | None -> max_int) in
  if exponent > most || exponent < -most then invalid "an exponent beyond its limits: \"%s\"" text;
  let behind = group 4 in
  Q.mul (Q.of_bigint (Z.of_string (prefix ^ group 2 ^ behind))) (power base (exponent - (step * String.length behind)))

(* What a string says: a fraction, a decimal or a hexadecimal float. *)
let exact text =
  if String.length text > longest then invalid "a number of more than %d characters" longest;
  let size =
    if is fraction text then (
      let above = Z.of_string (Str.matched_group 2 text) and below = Z.of_string (Str.matched_group 3 text) in
      if Z.equal below Z.zero then invalid "a fraction with the denominator 0: \"%s\"" text;
      Q.make above below)
    else if is hexadecimal text then scaled text "0x" 2 4 1200
    else if is decimal text then scaled text "" 10 1 400
    else invalid "not a number: \"%s\"" text
  in
  if text.[0] = '-' then Q.neg size else size

let out_of_range text = invalid "beyond the range of binary64: %s" text

(* The binary64 nearest to a JSON number. *)
let nearest word =
  if String.length word > longest then invalid "a number of more than %d characters" longest;
  if not (is json_number word) then invalid "not a JSON number: %s" word;
  let mantissa = List.hd (String.split_on_char 'e' (String.lowercase_ascii word)) in
  let is_zero = String.for_all (fun c -> c < '1' || c > '9') mantissa in
  let x = float_of_string word in
  if (not (Float.is_finite x)) || (x = 0. && not is_zero) then out_of_range word;
  Q.of_float x

(* That the binary64 nearest to what a string says is finite, and zero only for zero. *)
let in_range text x =
  let size = Q.abs x and half = power 2 in
  if Q.sign x <> 0 && (Q.leq size (half (-1075)) || Q.geq size (Q.sub (half 1024) (half 970))) then out_of_range text;
  x
