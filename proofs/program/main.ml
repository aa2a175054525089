(* voroproof-proved SCENE HISTORY [--tolerance T] [--law-tolerance R]: the verdict of the proved checker. *)

let usage = "usage: voroproof-proved SCENE HISTORY [--tolerance T] [--law-tolerance R]\n"

let why : Checker.reason -> string = function
  | UnknownGenerator -> "a generator is not there"
  | UnknownEdge -> "an edge is not there"
  | NotBeside -> "an edge beside the flip does not fit"
  | WrongName -> "no such edge is there"
  | BadBracket -> "the bracket of the flip is not within the tolerance"
  | EdgeTooYoung -> "the edge flips within the bracket of another flip"
  | MotionTooYoung -> "a generator turns within the life that is to be proved"
  | NotLegal -> "an edge that ends its life here is not proved legal"
  | Tied -> "an edge that ends its life here is not proved to be the one of its four while they are cotangent"
  | Overlap -> "a pair whose life ends here is not proved apart"
  | NoCollapse -> "the edge is not proved to collapse here"
  | OutOfOrder -> "a turn within the bracket of an earlier flip"
  | NotNeighbours -> "the two are no neighbours"
  | NoContact -> "no contact is proved within the tolerance"
  | NotTheLaw -> "the velocities are not proved to be those of the law"
  | CentreElsewhere -> "a centre is not proved to be on its path"
  | NoSuchManeuver -> "the scene has no such maneuver next"
  | ManeuverLeftOut -> "a maneuver of the scene is left out"
  | BadInitial -> "the initial diagram is not proved"

let read name =
  let file = open_in_bin name in
  Fun.protect ~finally:(fun () -> close_in file) (fun () -> really_input_string file (in_channel_length file))

let rec options files tolerance law = function
  | "--tolerance" :: value :: rest -> options files (Numbers.exact value) law rest
  | "--law-tolerance" :: value :: rest -> options files tolerance (Numbers.exact value) rest
  | word :: _ when String.length word > 1 && String.sub word 0 2 = "--" -> None
  | file :: rest -> options (file :: files) tolerance law rest
  | [] -> ( match files with [ history; scene ] -> Some (scene, history, tolerance, law) | _ -> None)

let lines text = match List.rev (String.split_on_char '\n' text) with "" :: rest -> List.rev rest | all -> List.rev all

(* The verdict, and the lines before it. *)
let judge scene_text history_text tolerance law =
  let scene = Files.scene (Files.json scene_text) in
  let history = Files.history (Array.length scene.disks) (lines history_text) in
  if history.sha <> Sha256.to_hex (Sha256.string scene_text) then Numbers.invalid "the history is that of another scene";
  let count kind = List.length (List.filter (fun (_, _, e) -> kind e) history.events) in
  let counts = List.map count [ (function Files.Flipped _ -> true | _ -> false); (function Files.Collided _ -> true | _ -> false);
      (function Files.Maneuvered _ -> true | _ -> false) ] in
  Printf.printf "c %d flips, %d collisions, %d maneuvers\n" (List.nth counts 0) (List.nth counts 1) (List.nth counts 2);
  if not (Q.equal history.horizon scene.scene_horizon) then
    Printf.printf "c horizon %s of the scene's %s\n" (Q.to_string history.horizon) (Q.to_string scene.scene_horizon);
  if history.stopped then Hints.undecided 0 "the history stops before its horizon";
  if counts <> history.counts then Hints.undecided 0 "the last line has other counts";
  if history.initial = None then Hints.undecided 0 "no initial diagram is given";
  if Array.length scene.disks < 2 then Hints.undecided 0 "fewer than two disks";
  let most = Q.max (Q.of_float 1e-6) history.horizon in
  if Q.sign tolerance < 0 || Q.gt tolerance most then Numbers.invalid "a tolerance is from 0 to the horizon, or to 1e-6";
  if Q.sign law < 0 || Q.gt law Q.one then Numbers.invalid "a tolerance of velocities is from 0 to 1";
  let units = Hints.units scene history tolerance in
  let problem = Hints.problem scene history tolerance law units in
  let claims = Hints.claims problem units history in
  match Checker.check problem claims with
  | Good (), _ -> ()
  | Bad reason, taken ->
      let line = match List.nth_opt history.events (Z.to_int taken) with Some (line, _, _) -> line | None -> 0 in
      Hints.undecided (if reason = BadInitial then 1 else line) "%s" (why reason)

let () =
  let finish code line = print_string ("s " ^ line ^ "\n"); exit code in
  match options [] (Q.of_float 1e-6) (Q.of_float 1e-9) (List.tl (Array.to_list Sys.argv)) with
  | None -> prerr_string usage; exit 2
  | exception Numbers.Invalid e -> prerr_string (e ^ "\n"); exit 2
  | Some (scene, history, tolerance, law) -> (
      match judge (read scene) (read history) tolerance law with
      | () -> finish 0 "CERTIFIED"
      | exception (Numbers.Invalid e | Yojson.Json_error e | Sys_error e) -> Printf.printf "c %s\n" e; finish 2 "INVALID"
      | exception Hints.Undecided (line, e) ->
          if line > 0 then Printf.printf "c line %d: %s\n" line e else Printf.printf "c %s\n" e;
          finish 3 "UNDECIDED"
      | exception (Stack_overflow | Out_of_memory) -> prerr_string "out of memory\n"; exit 5
      | exception e -> prerr_string (Printexc.to_string e ^ "\n"); exit 4)
