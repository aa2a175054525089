// voroproof clearance: how near disks come to each other on given paths.
#include <algorithm>
#include <memory>
#include <ostream>

#include "apps/answers/billiard_paths.h"
#include "apps/answers/clearance_answer.h"
#include "apps/answers/history_paths.h"
#include "apps/answers/world_paths.h"
#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/verbs/verbs.h"
#include "filtered/motion/options.h"
#include "history/billiard.h"
#include "history/error.h"
#include "history/event_limit.h"
#include "history/output_file.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string paths, history, radius, below, required, height, output;
  bool stay = false, vanish = false, may_touch = false, frames_only = false;
  EngineOptions options;
};

std::optional<Rational> distance(const std::string& option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  return time_argument(option, text);
}

// A scene says the radii, and when its disks are there.
void refuse_options_of_tables(const Request& request) {
  if (!request.radius.empty()) throw UsageError("--radius: the scene gives the radii");
  if (request.stay || request.vanish)
    throw UsageError("--stay, --vanish: the scene says when its disks are there");
  if (request.frames_only) throw UsageError("--frames-only: a scene has no frames");
  if (!request.height.empty())
    throw UsageError("--height: the disks of a scene are near each other at all heights");
}

GivenPaths paths_of(const Request& request) {
  const bool is_billiard = is_billiard_file(request.paths);
  if (is_world_file(request.paths) && !is_billiard) {
    refuse_options_of_tables(request);
    if (!request.history.empty())
      throw UsageError("history: the scene of a world says all of its motion");
    return world_paths(read_world(request.paths));
  }
  if (request.history.empty()) {
    GivenPaths given = read_paths(request.paths, distance("--radius", request.radius),
                                  request.stay     ? Beyond::stays
                                  : request.vanish ? Beyond::vanishes
                                                   : Beyond::unsaid);
    if (request.frames_only) note_missing_frames(given);
    return given;
  }
  refuse_options_of_tables(request);
  require_order(request.paths, request.history);
  if (is_billiard)
    return billiard_paths(read_billiard(request.paths), request.paths, request.history);
  return history_paths(read_scene(request.paths), request.history, request.options);
}

ClearanceQuestion question_of(const Request& request, const GivenPaths& given) {
  ClearanceQuestion question{request.paths, distance("--below", request.below), {}, {}, {}};
  if (!request.required.empty())
    question.required = number_argument("--required", request.required);
  question.touching = request.may_touch ? Touching::is_allowed : Touching::is_too_near;
  question.rules.at_waypoints = request.frames_only;
  question.rules.height = distance("--height", request.height);
  Rational radius;
  for (const GivenPath& path : given.paths) radius = std::max(radius, path.greatest_radius());
  for (const Rational& side : given.sides) {
    if (side != 0 && question.below && *question.below + 2 * radius > 1000 * side)
      throw UsageError("--below: with the radii more than 1000 sides of the periodic box");
  }
  if (question.below && question.rules.height && given.sides[2] != 0 &&
      *question.rules.height > 1000 * given.sides[2])
    throw UsageError("--height: more than 1000 sides of the periodic box");
  if (question.rules.height && *question.rules.height == 0)
    throw UsageError("--height: 0 is given, a positive number is wanted");
  if (question.rules.height && !given.in_space)
    throw UsageError("--height: the file has no column z, which is the height");
  return question;
}

// Whether the answer is to be a table of the approaches.
bool is_table(const std::string& output) { return output.ends_with(".csv"); }

ExitCode tell_clearance(const Request& request) {
  if (is_table(request.output) && request.below.empty())
    throw UsageError("-o FILE.csv is the table of the approaches that --below asks for");

  require_distinct({request.paths, request.history}, {request.output});
  const CooperativeInterruption interruption;
  const EventLimit limit(request.options.max_events);
  const GivenPaths given = paths_of(request);
  const ClearanceAnswer told = answer_clearance(question_of(request, given), given, [&] {
    interruption.check();
    return true;
  });
  if (is_table(request.output)) {
    write_output(request.output, told.table);
    words_beside({request.output}) << told.answer.table;
  } else {
    give(told.answer, request.output, words_beside({request.output}));
  }
  switch (told.freedom) {
    case Freedom::refuted:
      return ExitCode::refuted;
    case Freedom::undecided:
      return ExitCode::undecided;
    default:
      return ExitCode::ok;
  }
}

}  // namespace

void add_clearance(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb(
      "clearance", "The exact least gap of all pairs of disks on given paths (docs/others.md)");
  verb.input(
          "paths", request->paths,
          "A table of waypoints (disk,t,x,y and perhaps z and radius) or of polynomial pieces "
          "(disk,t,duration,x^0,x^1,...,y^0,...), the log of a CCBS plan (XML), a world, or, with "
          "a history, a scene.")
      .required();
  verb.input("history", request->history,
             "A history of the scene: its recorded paths are judged, gaps to the container too.");
  verb.text("--radius", request->radius, "LENGTH",
            "The radius of every disk, where the file does not give it.");
  verb.flag("--stay", request->stay,
            "Before its first waypoint and after its last a disk stays where it is, as long as "
            "others have waypoints.");
  verb.flag("--vanish", request->vanish,
            "Before its first waypoint and after its last a disk is nowhere.")
      .excludes({"--stay"});
  verb.text("--below", request->below, "LENGTH",
            "List every interval in which a gap is less than this.");
  verb.text("--required", request->required, "LENGTH",
            "Prove that every gap is at least this, and positive where it is 0, or refute it. "
            "Negative: so much overlap is allowed.");
  verb.flag("--may-touch", request->may_touch, "With --required 0: a gap of exactly 0 is allowed.");
  verb.text(
      "--height", request->height, "LENGTH",
      "Two count as near each other only while their heights z differ by less than this; a gap "
      "is horizontal.");
  verb.flag("--frames-only", request->frames_only,
            "Judge the instants of the waypoints alone: what is between two frames is no motion.");
  verb.output("-o,--output", request->output,
              "Write the answer here besides the lines, as JSON, or as a table of the approaches "
              "where it ends in .csv.");
  verb.note(
      "Judged are the piecewise linear paths between the waypoints, the polynomials of the "
      "pieces, or the motion of the world's disks, which may grow. A negative gap is an overlap. "
      "Paths that do not all begin and end together need --stay or --vanish. "
      "With --required the last line is s FREE (exit code 0), s REFUTED (1), s INVALID (2) or "
      "s UNDECIDED (3): no gap is too small, but there is none, or the input lacks what the line "
      "c missing names.");
  verb.example("voroproof clearance plan_log.xml --radius 0.25 --stay --required 0 --below 0.1");
  verb.example("voroproof clearance a.scene.json a.history.jsonl --required 1/2");
  add_computing_limits(verb, request->options);
  verb.does([request] {
    // The last line is a verdict where one is asked for, whatever came in between.
    const auto end_with = [&](const char* verdict) {
      if (!request->required.empty()) words_beside({request->output}) << verdict;
    };
    try {
      return tell_clearance(*request);
    } catch (const InputError&) {
      end_with("s INVALID\n");
      throw;
    } catch (const Undecided&) {
      end_with("s UNDECIDED\n");
      throw;
    } catch (const EventLimitReached&) {
      end_with("s UNDECIDED\n");
      throw;
    }
  });
}

}  // namespace voroproof::internal
