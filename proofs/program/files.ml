(* Scenes and histories as their files say (docs/formats.md). Numbers become exact fractions. *)

exception Invalid of string

let invalid format = Printf.ksprintf (fun text -> raise (Invalid text)) format

type json = Yojson.Raw.t

(* The fields of an object. One that may have extensions (section 14) may have others whose names begin with "x-". *)
let fields ?(extended = false) ~required ~optional = function
  | `Assoc list ->
      let all = List.map fst list in
      if List.length (List.sort_uniq compare all) <> List.length all then invalid "a field occurs twice";
      let extension name = extended && String.length name > 1 && String.sub name 0 2 = "x-" in
      let names = List.filter (fun name -> not (extension name)) all in
      List.iter (fun n -> if not (List.mem n names) then invalid "the field '%s' is missing" n) required;
      List.iter (fun n -> if not (List.mem n (required @ optional)) then invalid "an unknown field '%s'" n) names;
      fun name -> List.assoc_opt name list
  | _ -> invalid "not a JSON object"

let required get name = match get name with Some value -> value | None -> invalid "the field '%s' is missing" name

let list = function `List items -> items | _ -> invalid "not a list"

let text = function
  | `Stringlit raw -> String.sub raw 1 (String.length raw - 2)
  | _ -> invalid "not a string"

let whole = function
  | `Intlit digits -> ( match int_of_string_opt digits with Some k -> k | None -> invalid "an integer beyond its limits")
  | _ -> invalid "not an integer"

let power base exponent = if exponent >= 0 then Q.of_bigint (Z.pow base exponent) else Q.inv (Q.of_bigint (Z.pow base (-exponent)))

(* A decimal, with what follows the 'e' as a power of ten: exactly. *)
let decimal word =
  let mantissa, exponent =
    match String.index_from_opt (String.lowercase_ascii word) 0 'e' with
    | None -> (word, 0)
    | Some k -> (String.sub word 0 k, int_of_string (String.sub word (k + 1) (String.length word - k - 1) |> fun e ->
        if e <> "" && e.[0] = '+' then String.sub e 1 (String.length e - 1) else e))
  in
  if abs exponent > 400 then invalid "an exponent beyond its limits";
  let whole, places =
    match String.index_opt mantissa '.' with
    | None -> (mantissa, 0)
    | Some k ->
        let after = String.length mantissa - k - 1 in
        (String.sub mantissa 0 k ^ String.sub mantissa (k + 1) after, after)
  in
  Q.mul (Q.of_bigint (Z.of_string whole)) (power (Z.of_int 10) (exponent - places))

let exact word =
  let only letters text = String.for_all (String.contains letters) text in
  try
    match String.index_opt word '/' with
    | Some k when only "0123456789+-/" word ->
        let denominator = Z.of_string (String.sub word (k + 1) (String.length word - k - 1)) in
        if Z.sign denominator = 0 then raise Division_by_zero;
        Q.make (Z.of_string (String.sub word 0 k)) denominator
    | Some _ -> raise Not_found
    | None ->
        if String.contains word 'x' || String.contains word 'X' then Q.of_float (float_of_string word)
        else if only "0123456789+-.eE" word then decimal word
        else raise Not_found
  with Invalid_argument _ | Failure _ | Division_by_zero | Not_found -> invalid "not a number: \"%s\"" word

(* A JSON number is the binary64 nearest to it, a string what it says. *)
let number = function
  | `Intlit word | `Floatlit word ->
      let x = float_of_string word in
      if Float.is_finite x then Q.of_float x else invalid "beyond the range of binary64"
  | `Stringlit _ as s -> exact (text s)
  | _ -> invalid "not a number"

let pair item read = match list item with [ a; b ] -> (read a, read b) | _ -> invalid "not a pair"
let vector item = pair item number

type disk = { center : Q.t * Q.t; radius : Q.t; velocity : Q.t * Q.t; mass : Q.t }
type maneuver = { time : Q.t; disk : int; turned : Q.t * Q.t }

type scene = {
  origin : Q.t * Q.t;
  size : Q.t;
  restitution : Q.t;
  wall : Q.t;
  whole_law : bool;
  scene_horizon : Q.t;
  disks : disk array;
  maneuvers : maneuver list;
}

type event =
  | Flipped of int array
  | Collided of int * int * (json * json) option * (json * json) option
  | Maneuvered of int * (Q.t * Q.t) option * (Q.t * Q.t) option

type history = { horizon : Q.t; sha : string; initial : int array list option; events : (int * Q.t * event) list; stopped : bool; counts : int list }

let format_is get name = if text (required get "format") <> name || whole (required get "version") <> 1 then invalid "another format or version"

let scene json =
  let get = fields json ~extended:true ~required:[ "format"; "version"; "container"; "horizon"; "disks" ]
      ~optional:[ "name"; "comment"; "seed"; "container_law"; "restitution"; "maneuvers" ] in
  format_is get "voroproof-scene";
  let wall = fields (required get "container") ~required:[ "center"; "radius" ] ~optional:[ "restitution" ] in
  let or_one = function Some value -> number value | None -> Q.one in
  let disk item =
    let get = fields item ~extended:true ~required:[ "center"; "radius"; "velocity" ] ~optional:[ "mass" ] in
    let radius = number (required get "radius") in
    { center = vector (required get "center"); radius; velocity = vector (required get "velocity");
      mass = (match get "mass" with Some m -> number m | None -> Q.mul radius radius) }
  in
  let maneuver item =
    let get = fields item ~extended:true ~required:[ "t"; "disk"; "velocity" ] ~optional:[] in
    { time = number (required get "t"); disk = whole (required get "disk"); turned = vector (required get "velocity") }
  in
  { origin = vector (required wall "center"); size = number (required wall "radius"); restitution = or_one (get "restitution");
    wall = or_one (wall "restitution");
    whole_law = (match Option.map text (get "container_law") with
      | None | Some "normal" -> false | Some "whole" -> true | _ -> invalid "an unknown law");
    scene_horizon = number (required get "horizon");
    disks = Array.of_list (List.map disk (list (required get "disks")));
    maneuvers = List.map maneuver (match get "maneuvers" with Some m -> list m | None -> []) }

let quadruple item = match List.map whole (list item) with [ _; _; _; _ ] as ids -> Array.of_list ids | _ -> invalid "not a quadruple"

let has json name = match json with `Assoc list -> List.mem_assoc name list | _ -> false

let event json =
  let has = has json in
  let kind = if has "flip" then "flip" else if has "collide" then "collide" else "maneuver" in
  let get = fields json ~extended:true ~required:[ "t"; kind ] ~optional:(if kind = "flip" then [] else [ "v"; "p" ]) in
  let both = Option.map (fun item -> pair item Fun.id) in
  let what = required get kind in
  ( number (required get "t"),
    match kind with
    | "flip" -> Flipped (quadruple what)
    | "collide" ->
        let i, j = pair what whole in
        Collided (i, j, both (get "v"), both (get "p"))
    | _ -> Maneuvered (whole what, Option.map vector (get "v"), Option.map vector (get "p")) )

let history lines =
  match lines with
  | [] -> invalid "an empty file"
  | head :: rest ->
      let get = fields (Yojson.Raw.from_string head) ~extended:true ~required:[ "format"; "version"; "scene_sha256"; "horizon"; "producer" ] ~optional:[ "initial" ] in
      format_is get "voroproof-history";
      let horizon = number (required get "horizon") in
      let rec follow line events = function
        | [] -> invalid "the file ends without its last line"
        | one :: rest -> (
            let json = try Yojson.Raw.from_string one with Yojson.Json_error e -> invalid "line %d: %s" line e in
            match List.find_opt (has json) [ "end"; "stopped" ] with
            | Some word ->
                let last = required (fields json ~extended:true ~required:[ word ] ~optional:[]) word in
                if rest <> [] then invalid "line %d: something follows the last line" line;
                let counts = if word = "stopped" then [] else
                    let get = fields last ~required:[ "t"; "flips"; "collisions"; "maneuvers" ] ~optional:[] in
                    List.map (fun n -> whole (required get n)) [ "flips"; "collisions"; "maneuvers" ] in
                (List.rev events, word = "stopped", counts)
            | None ->
                let t, what = try event json with Invalid e -> invalid "line %d: %s" line e in
                let before = match events with (_, t, _) :: _ -> t | [] -> Q.zero in
                if Q.lt t before then invalid "line %d: the times decrease" line;
                follow (line + 1) ((line, t, what) :: events) rest)
      in
      let events, stopped, counts = follow 2 [] rest in
      { horizon; sha = text (required get "scene_sha256"); initial = Option.map (fun q -> List.map quadruple (list q)) (get "initial");
        events; stopped; counts }
