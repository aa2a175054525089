(* voroproof-proved SCENE HISTORY [--tolerance T] [--law-tolerance R]: the verdict of the proved checker. *)

let usage = "usage: voroproof-proved SCENE HISTORY [--tolerance T] [--law-tolerance R]\n"

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

(* The verdict; prints the lines before it. *)
let judge scene_text history_text tolerance law =
  let scene = Files.scene (Files.json scene_text) in
  let history, sha = Files.history (List.length scene.disks) (lines history_text) in
  if sha <> Sha256.to_hex (Sha256.string scene_text) then Numbers.invalid "the history is that of another scene";
  let (flips, collisions), maneuvers = Checker.count_events history.events in
  Printf.printf "c %s flips, %s collisions, %s maneuvers\n" (Z.to_string flips) (Z.to_string collisions) (Z.to_string maneuvers);
  let known (x : Checker.q) = Q.make x.qnum x.qden in
  let horizon = known history.history_horizon and whole = known scene.scene_horizon in
  if not (Q.equal horizon whole) then Printf.printf "c horizon %s of the scene's %s\n" (Q.to_string horizon) (Q.to_string whole);
  if Q.sign tolerance < 0 || Q.gt tolerance (Q.max (Q.of_float 1e-6) horizon) then Numbers.invalid "a tolerance is from 0 to the horizon, or to 1e-6";
  if Q.sign law < 0 || Q.gt law Q.one then Numbers.invalid "a tolerance of velocities is from 0 to 1";
  Checker.judge scene history (Files.fraction tolerance) (Files.fraction law)

let () =
  let finish code line = print_string ("s " ^ line ^ "\n"); exit code in
  match options [] (Q.of_float 1e-6) (Q.of_float 1e-9) (List.tl (Array.to_list Sys.argv)) with
  | None -> prerr_string usage; exit 2
  | exception Numbers.Invalid e -> prerr_string (e ^ "\n"); exit 2
  | Some (scene, history, tolerance, law) -> (
      match judge (read scene) (read history) tolerance law with
      | Certified -> finish 0 "CERTIFIED"
      | Undecided (line, why) ->
          if Z.sign line > 0 then Printf.printf "c line %s: %s\n" (Z.to_string line) why else Printf.printf "c %s\n" why;
          finish 3 "UNDECIDED"
      | Invalid e | exception (Numbers.Invalid e | Yojson.Json_error e | Sys_error e) -> Printf.printf "c %s\n" e; finish 2 "INVALID"
      | exception (Stack_overflow | Out_of_memory) -> prerr_string "out of memory\n"; exit 5
      | exception e -> prerr_string (Printexc.to_string e ^ "\n"); exit 4)
