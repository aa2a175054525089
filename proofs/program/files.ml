(* Scenes and histories as their files say (docs/formats.md). Numbers become exact fractions. *)

open Numbers

(* Yojson reads more than JSON: comments, names without quotes, tuples, NaN. Outside strings only the characters of JSON may
   stand; numbers are looked at where they are read. *)
let json source =
  let quoted = ref false and escaped = ref false in
  String.iter (fun c ->
      if !quoted then (
        if c < ' ' then invalid "a control character within a string";
        if !escaped then escaped := false else if c = '\\' then escaped := true else if c = '"' then quoted := false)
      else if c = '"' then quoted := true
      else if not (String.contains " \t\r\n{}[]:,0123456789+-.eEtrufalsn" c) then invalid "not JSON: %C" c) source;
  Yojson.Raw.from_string source

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

let whole least most = function
  | `Intlit digits -> (
      match int_of_string_opt digits with
      | Some k when least <= k && k <= most -> k
      | _ -> invalid "an integer beyond its limits: %s" digits)
  | _ -> invalid "not an integer"

(* A JSON number is the binary64 nearest to it, a string what it says. *)
let number = function
  | `Intlit word | `Floatlit word -> nearest word
  | `Stringlit _ as s -> in_range (text s) (exact (text s))
  | _ -> invalid "not a number"

let pair item read = match list item with [ a; b ] -> (read a, read b) | _ -> invalid "not a pair"
let vector read item = pair item read
let within least most what x = if Q.lt x least || Q.gt x most then invalid "%s beyond its limits" what else x
let positive what x = if Q.sign x <= 0 then invalid "%s that is not positive" what else x
let not_negative what x = if Q.sign x < 0 then invalid "a negative %s" what else x

(* A number of a scene: zero, or in size from the binary64 nearest to 1e-100 to that nearest to 1e100. *)
let scene_number item =
  let x = number item in
  if Q.sign x <> 0 then ignore (within (nearest "1e-100") (nearest "1e100") "a number of a scene" (Q.abs x));
  x

type vec = Q.t * Q.t
type disk = { center : vec; radius : Q.t; velocity : vec; mass : Q.t }
type maneuver = { time : Q.t; disk : int; turned : vec }

type scene = {
  origin : vec;
  size : Q.t;
  restitution : Q.t;
  wall : Q.t;
  whole_law : bool;
  scene_horizon : Q.t;
  disks : disk array;
  maneuvers : maneuver list;
}

(* What a collision gives of its two: nothing of the container, but always of the second. *)
type of_two = vec option * vec

type event =
  | Flipped of int array
  | Collided of int * int * of_two option * of_two option
  | Maneuvered of int * vec option * vec option

type history = { horizon : Q.t; sha : string; initial : int array list option; events : (int * Q.t * event) list; stopped : bool; counts : int list }

let format_is get name =
  if text (required get "format") <> name || whole 0 max_int (required get "version") <> 1 then invalid "another format or version"

let minus (a, b) (c, d) = (Q.sub a c, Q.sub b d)
let dot (a, b) (c, d) = Q.add (Q.mul a c) (Q.mul b d)
let square x = Q.mul x x

(* Disks lie in the container, none moves along it in contact, and no two overlap: by a sweep over their abscissas. *)
let check_places scene =
  let check disk =
    let n = minus disk.center scene.origin in
    let inside = Q.compare (dot n n) (square (Q.sub scene.size disk.radius)) in
    if Q.geq disk.radius scene.size || inside > 0 then invalid "a disk is not inside the container";
    let moves = Q.sign (dot disk.velocity disk.velocity) > 0 in
    if inside = 0 && moves && Q.sign (dot n disk.velocity) = 0 then invalid "a disk touches the container and moves along it"
  in
  Array.iter check scene.disks;
  let order = Array.copy scene.disks in
  Array.stable_sort (fun a b -> Q.compare (fst a.center) (fst b.center)) order;
  let widest = Array.fold_left (fun w d -> Q.max w d.radius) Q.zero order in
  Array.iteri (fun k a ->
      let rec sweep m =
        if m < Array.length order && Q.leq (Q.sub (fst order.(m).center) (fst a.center)) (Q.add a.radius widest) then (
          let n = minus order.(m).center a.center in
          let apart = dot n n in
          if Q.lt apart (square (Q.add a.radius order.(m).radius)) || Q.sign apart = 0 then invalid "two disks overlap";
          sweep (m + 1))
      in
      sweep (k + 1)) order

let scene json =
  let get = fields json ~extended:true ~required:[ "format"; "version"; "container"; "horizon"; "disks" ]
      ~optional:[ "name"; "comment"; "seed"; "container_law"; "restitution"; "maneuvers" ] in
  format_is get "voroproof-scene";
  List.iter (fun word -> Option.iter (fun item -> ignore (text item)) (get word)) [ "name"; "comment" ];
  (match get "seed" with None | Some (`Intlit _ | `Stringlit _) -> () | _ -> invalid "a seed is an integer or a string");
  let wall = fields (required get "container") ~required:[ "center"; "radius" ] ~optional:[ "restitution" ] in
  let or_one = function Some value -> scene_number value | None -> Q.one in
  let items = list (required get "disks") in
  let count = List.length items in
  let disk item =
    let get = fields item ~extended:true ~required:[ "center"; "radius"; "velocity" ] ~optional:[ "mass" ] in
    let radius = not_negative "radius" (scene_number (required get "radius")) in
    let mass = match get "mass" with Some m -> positive "a mass" (scene_number m) | None -> square radius in
    { center = vector scene_number (required get "center"); radius; velocity = vector scene_number (required get "velocity");
      mass = (if count > 1 then positive "a mass" mass else mass) }
  in
  let maneuver item =
    let get = fields item ~extended:true ~required:[ "t"; "disk"; "velocity" ] ~optional:[] in
    { time = not_negative "time" (scene_number (required get "t")); disk = whole 0 (count - 1) (required get "disk");
      turned = vector scene_number (required get "velocity") }
  in
  let rec sorted seen = function
    | a :: rest ->
        if List.exists (fun b -> Q.gt b.time a.time) seen then invalid "the maneuvers are not sorted by their times";
        let same = List.filter (fun b -> Q.equal b.time a.time) seen in
        if List.exists (fun b -> b.disk = a.disk) same then invalid "two maneuvers of a disk at one instant";
        sorted (a :: same) rest
    | [] -> ()
  in
  let scene =
    { origin = vector scene_number (required wall "center"); size = positive "a container's radius" (scene_number (required wall "radius"));
      restitution = within Q.zero Q.one "a restitution" (or_one (get "restitution"));
      wall = positive "a restitution of the wall" (within Q.zero Q.one "a restitution" (or_one (wall "restitution")));
      whole_law = (match Option.map text (get "container_law") with
        | None | Some "normal" -> false | Some "whole" -> true | _ -> invalid "an unknown law");
      scene_horizon = not_negative "horizon" (scene_number (required get "horizon"));
      disks = Array.of_list (List.map disk items);
      maneuvers = List.map maneuver (match get "maneuvers" with Some m -> list m | None -> []) }
  in
  sorted [] scene.maneuvers;
  check_places scene;
  scene

(* An edge: of its four only the two at its ends may be the same. *)
let quadruple disks item =
  match List.map (whole (-1) (disks - 1)) (list item) with
  | [ l; r; s; e ] as ids ->
      if l = r || List.mem l [ s; e ] || List.mem r [ s; e ] then invalid "a quadruple that names no edge";
      Array.of_list ids
  | _ -> invalid "not a quadruple"

let has json name = match json with `Assoc list -> List.mem_assoc name list | _ -> false

let event disks json =
  let has = has json in
  let kind = if has "flip" then "flip" else if has "collide" then "collide" else "maneuver" in
  let get = fields json ~extended:true ~required:[ "t"; kind ] ~optional:(if kind = "flip" then [] else [ "v"; "p" ]) in
  let what = required get kind in
  ( number (required get "t"),
    match kind with
    | "flip" -> Flipped (quadruple disks what)
    | "collide" ->
        let i, j = pair what (whole (-1) (disks - 1)) in
        if i >= j then invalid "the smaller of two ids comes first";
        let first item = if i >= 0 then Some (vector number item) else if item = `Null then None else invalid "the container has no velocity and no centre" in
        let two item = match list item with [ a; b ] -> (first a, vector number b) | _ -> invalid "not a pair" in
        Collided (i, j, Option.map two (get "v"), Option.map two (get "p"))
    | _ -> Maneuvered (whole 0 (disks - 1) what, Option.map (vector number) (get "v"), Option.map (vector number) (get "p")) )

(* The numbers of events that a last line gives; of a history that stops, none. *)
let last_line json word horizon =
  let last = required (fields json ~extended:true ~required:[ word ] ~optional:[]) word in
  if word = "stopped" then (
    let get = fields last ~required:[ "t"; "reason" ] ~optional:[ "events" ] in
    ignore (number (required get "t"), text (required get "reason"));
    [])
  else
    let get = fields last ~required:[ "t"; "flips"; "collisions"; "maneuvers" ] ~optional:[] in
    let t = number (required get "t") in
    if not (Q.equal t horizon || Q.equal t (Q.of_float (Q.to_float horizon))) then invalid "the last line has not the horizon's time";
    List.map (fun n -> whole 0 max_int (required get n)) [ "flips"; "collisions"; "maneuvers" ]

let history disks lines =
  match lines with
  | [] -> invalid "an empty file"
  | head :: rest ->
      let get = fields (json head) ~extended:true ~required:[ "format"; "version"; "scene_sha256"; "horizon"; "producer" ] ~optional:[ "initial" ] in
      format_is get "voroproof-history";
      ignore (text (required get "producer"));
      let horizon = not_negative "horizon" (number (required get "horizon")) in
      let latest = Q.max horizon (Q.of_float (Q.to_float horizon)) in
      let rec follow line before events = function
        | [] -> invalid "the file ends without its last line"
        | one :: rest -> (
            let located work = try work () with Invalid e | Yojson.Json_error e -> invalid "line %d: %s" line e in
            let item = located (fun () -> json one) in
            match List.find_opt (has item) [ "end"; "stopped" ] with
            | Some word ->
                let counts = located (fun () -> last_line item word horizon) in
                if rest <> [] then invalid "line %d: something follows the last line" line;
                (List.rev events, word = "stopped", counts)
            | None ->
                let t, what = located (fun () -> event disks item) in
                if Q.lt t before then invalid "line %d: the times decrease" line;
                if Q.gt t latest then invalid "line %d: an event after the horizon" line;
                follow (line + 1) t ((line, t, what) :: events) rest)
      in
      let events, stopped, counts = follow 2 Q.zero [] rest in
      { horizon; sha = text (required get "scene_sha256"); initial = Option.map (fun q -> List.map (quadruple disks) (list q)) (get "initial");
        events; stopped; counts }
