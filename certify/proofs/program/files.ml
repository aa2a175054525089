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

(* Numbers and ids as the checker takes them: the container is 1, disk k is k + 2. *)
let fraction x = { Checker.qnum = Q.num x; qden = Q.den x }
let vector read item = pair item (fun x -> fraction (read x))
let generator least disks item = Z.of_int (whole least (disks - 1) item + 2)
let container = Z.one
let within least most what x = if Q.lt x least || Q.gt x most then invalid "%s beyond its limits" what else x
let positive what x = if Q.sign x <= 0 then invalid "%s that is not positive" what else x
let not_negative what x = if Q.sign x < 0 then invalid "a negative %s" what else x

(* A number of a scene: zero, or in size from the binary64 nearest to 1e-100 to that nearest to 1e100. *)
let scene_number item =
  let x = number item in
  if Q.sign x <> 0 then ignore (within (nearest "1e-100") (nearest "1e100") "a number of a scene" (Q.abs x));
  x

let format_is get name =
  if text (required get "format") <> name || whole 0 max_int (required get "version") <> 1 then invalid "another format or version"

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
    let mass = match get "mass" with Some m -> positive "a mass" (scene_number m) | None -> Q.mul radius radius in
    { Checker.disk_centre = vector scene_number (required get "center"); disk_radius = fraction radius;
      disk_velocity = vector scene_number (required get "velocity");
      disk_mass = fraction (if count > 1 then positive "a mass" mass else mass) }
  in
  let maneuver item =
    let get = fields item ~extended:true ~required:[ "t"; "disk"; "velocity" ] ~optional:[] in
    let time = fraction (not_negative "time" (scene_number (required get "t"))) in
    ((time, generator 0 count (required get "disk")), vector scene_number (required get "velocity"))
  in
  let restitution = within Q.zero Q.one "a restitution" in
  { Checker.box_centre = vector scene_number (required wall "center");
    box_radius = fraction (positive "a container's radius" (scene_number (required wall "radius")));
    restitution = fraction (restitution (or_one (get "restitution")));
    restitution_of_wall = fraction (positive "a restitution of the wall" (restitution (or_one (wall "restitution"))));
    law_is_whole = (match Option.map text (get "container_law") with
      | None | Some "normal" -> false | Some "whole" -> true | _ -> invalid "an unknown law");
    scene_horizon = fraction (not_negative "horizon" (scene_number (required get "horizon")));
    disks = List.map disk items;
    plan = List.map maneuver (match get "maneuvers" with Some m -> list m | None -> []) }

(* An edge: of its four only the two at its ends may be the same. *)
let quadruple disks item =
  match List.map (generator (-1) disks) (list item) with
  | [ el; er; es; ee ] ->
      if List.exists (fun (a, b) -> Z.equal a b) [ (el, er); (el, es); (el, ee); (er, es); (er, ee) ] then invalid "a quadruple that names no edge";
      { Checker.el; er; es; ee }
  | _ -> invalid "not a quadruple"

let has json name = match json with `Assoc list -> List.mem_assoc name list | _ -> false

let event disks json =
  let has = has json in
  let kind = if has "flip" then "flip" else if has "collide" then "collide" else "maneuver" in
  let get = fields json ~extended:true ~required:[ "t"; kind ] ~optional:(if kind = "flip" then [] else [ "v"; "p" ]) in
  let what = required get kind and velocities = get "v" and centres = get "p" in
  let t = number (required get "t") in
  let time = fraction t in
  ( t,
    match kind with
    | "flip" -> Checker.Flipped (time, quadruple disks what)
    | "collide" ->
        let i, j = pair what (generator (-1) disks) in
        if Z.geq i j then invalid "the smaller of two ids comes first";
        let rest = (fraction Q.zero, fraction Q.zero) in
        let first item =
          if not (Z.equal i container) then vector number item
          else if item = `Null then rest
          else invalid "the container has no velocity and no centre"
        in
        let two item = match list item with [ a; b ] -> (first a, vector number b) | _ -> invalid "not a pair" in
        let centres = match Option.map two centres with
          | None -> [] | Some (a, b) -> if Z.equal i container then [ (j, b) ] else [ (i, a); (j, b) ] in
        Checker.Collided (time, i, j, Option.map two velocities, centres)
    | _ ->
        let g = generator 0 disks what in
        let centres = match centres with None -> [] | Some c -> [ (g, vector number c) ] in
        Checker.Maneuvered (time, g, Option.map (vector number) velocities, centres) )

(* The numbers of events that a last line gives, if the history does not stop. *)
let last_line json word horizon =
  let last = required (fields json ~extended:true ~required:[ word ] ~optional:[]) word in
  if word = "stopped" then (
    let get = fields last ~required:[ "t"; "reason" ] ~optional:[ "events" ] in
    ignore (number (required get "t"), text (required get "reason"));
    None)
  else
    let get = fields last ~required:[ "t"; "flips"; "collisions"; "maneuvers" ] ~optional:[] in
    let t = number (required get "t") in
    if not (Q.equal t horizon || Q.equal t (Q.of_float (Q.to_float horizon))) then invalid "the last line has not the horizon's time";
    let count name = Z.of_int (whole 0 max_int (required get name)) in
    Some ((count "flips", count "collisions"), count "maneuvers")

(* The history, and the hash of the scene that it names. *)
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
                (List.rev events, counts)
            | None ->
                let t, what = located (fun () -> event disks item) in
                if Q.lt t before then invalid "line %d: the times decrease" line;
                if Q.gt t latest then invalid "line %d: an event after the horizon" line;
                follow (line + 1) t (what :: events) rest)
      in
      let events, counts = follow 2 Q.zero [] rest in
      ( { Checker.history_horizon = fraction horizon; first_edges = Option.map (fun q -> List.map (quadruple disks) (list q)) (get "initial");
          events; stops = counts = None; counts = Option.value counts ~default:((Z.zero, Z.zero), Z.zero) },
        text (required get "scene_sha256") )
