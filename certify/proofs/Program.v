(* The whole program, but for reading files: the verdict about a scene and a history. *)
From Coq Require Import ZArith QArith List Bool FMapPositive String.
From Voroproof Require Import History Replay Initial Checker Files Units Search.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

Inductive verdict := Certified | Undecided (line : Z) (why : string) | Invalid (why : string).

Definition words (why : reason) : string :=
  match why with
  | UnknownGenerator => "a generator is not there"
  | UnknownEdge => "an edge is not there"
  | NotBeside => "an edge beside the flip does not fit"
  | WrongName => "no such edge is there"
  | BadBracket => "the bracket of the flip is not within the tolerance, or wide"
  | EdgeTooYoung => "an edge changes within the bracket of another flip"
  | MotionTooYoung => "a generator turns within the life that is to be proved"
  | NotLegal => "an edge that ends its life here is not proved legal"
  | NotLasting => "an edge beside the flip is not proved legal within its bracket"
  | Tied => "an edge that ends its life here is not proved to be the one of its four while they are cotangent"
  | Overlap => "a pair whose life ends here is not proved apart"
  | NoCollapse => "the edge is not proved to collapse here"
  | Slides => "a disk touches the container at the horizon and moves along it"
  | OutOfOrder => "a turn within the bracket of an earlier flip"
  | NotNeighbours => "the two are no neighbours"
  | NoContact => "no contact is proved within the tolerance"
  | NotTheLaw => "the velocities are not proved to be those of the law"
  | CentreElsewhere => "a centre is not proved to be on its path"
  | NoSuchManeuver => "the scene has no such maneuver next"
  | ManeuverLeftOut => "a maneuver of the scene is left out"
  | BadInitial => "the initial diagram is not proved"
  | NoMultiple => "a number is no multiple of its unit"
  | NoVelocity => "velocities are not given"
  | NoBracket => "no bracket of the collapse was found"
  end.

(* What no scene may have: a disk that is not inside the container, or touches it and moves along it, or overlaps another;
   maneuvers that are not in order, or two of a disk at one instant. *)
Definition place_wrong (box d : body) : option string :=
  let off := (x (start d) - x (start box), y (start d) - y (start box)) in
  let room := - body_radius box - body_radius d in
  let v := velocity (start d) in
  if (room <=? 0) || (room * room <? dot off off) then Some "a disk is not inside the container"
  else if slides room off v then Some "a disk touches the container and moves along it"
  else None.

Definition apart_at_start (a b : body) : bool :=
  let dx := x (start a) - x (start b) in
  let reach := body_radius a + body_radius b in
  (reach <? Z.abs dx) ||
  (let dy := y (start a) - y (start b) in let d := dx * dx + dy * dy in (reach * reach <=? d) && (0 <? d)).

Fixpoint all_apart (l : list body) : bool :=
  match l with [] => true | a :: l => forallb (apart_at_start a) l && all_apart l end.

Fixpoint in_order (same : list maneuver) (ms : list maneuver) : option string :=
  match ms with
  | [] => None
  | n :: ms =>
      if existsb (fun o => due n <? due o) same then Some "the maneuvers are not sorted by their times"
      else
        let same := filter (fun o => due o =? due n) same in
        if existsb (fun o => Pos.eqb (who o) (who n)) same then Some "two maneuvers of a disk at one instant"
        else in_order (n :: same) ms
  end.

Definition first_of {A} (a b : option A) : option A := match a with Some _ => a | None => b end.

Definition scene_wrong (P : problem) : option string :=
  match PositiveMap.find container (bodies P) with
  | None => Some "no container"
  | Some box =>
      let disks := map snd (PositiveMap.elements (PositiveMap.remove container (bodies P))) in
      first_of (in_order [] (schedule P)) (first_of (fold_left (fun why d => first_of why (place_wrong box d)) disks None)
        (if all_apart disks then None else Some "two disks overlap"))
  end.

Definition count_events {A} (es : list (event A)) : Z * Z * Z :=
  fold_left (fun n e =>
    let '(f, c, m) := n in
    match e with Flipped _ _ => (f + 1, c, m) | Collided _ _ _ _ _ => (f, c + 1, m) | Maneuvered _ _ _ _ => (f, c, m + 1) end) es (0, 0, 0).
Definition counted (h : history) : bool :=
  let '(f, c, m) := count_events (events h) in let '(f', c', m') := counts h in (f =? f') && (c =? c') && (m =? m').

(* The line of the event after the first n: the header is line 1. At the end there is none. *)
Definition line_after (h : history) (n : Z) : Z := if n <? fold_left (fun k _ => k + 1) (events h) 0 then n + 2 else 0.

Definition of_claims (P : problem) (h : history) (es : list (event Z)) : verdict :=
  match search P (first_finder P) es (limits P es) [] 0 with
  | (Bad why, n) => Undecided (line_after h n) (words why)
  | (Good claims, _) =>
      match check P claims with
      | (Good _, _) => Certified
      | (Bad why, n) => Undecided (match why with BadInitial => 1 | _ => line_after h n end) (words why)
      end
  end.

Definition judge (s : scene) (h : history) (tau lambda : Q) : verdict :=
  let t := unit_of_time s h tau in
  let v := unit_of_velocity s h t in
  match problem_of t v (unit_of_mass s) s h tau lambda with
  | Bad why => Undecided 0 (words why)
  | Good P =>
      match scene_wrong P with
      | Some why => Invalid why
      | None =>
          if stops h then Undecided 0 "the history stops before its horizon"
          else if negb (counted h) then Undecided 0 "the last line has other counts"
          else match first_edges h, disks s with
          | None, _ => Undecided 0 "no initial diagram is given"
          | _, [] | _, [_] => Undecided 0 "fewer than two disks"
          | Some _, _ =>
              match all (event_of t v) (events h) with
              | Bad why => Undecided 0 (words why)
              | Good es => of_claims P h es
              end
          end
      end
  end.
