// voroproof clearance: how near disks come to each other on given paths.
#include <memory>
#include <ostream>

#include "apps/answers/clearance_answer.h"
#include "apps/answers/history_paths.h"
#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/verbs/verbs.h"
#include "filtered/motion/options.h"
#include "history/error.h"
#include "history/event_limit.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string paths, history, radius, below, required, output;
  bool stay = false, vanish = false;
  EngineOptions options;
};

std::optional<Rational> distance(const std::string& option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  return time_argument(option, text);
}

GivenPaths paths_of(const Request& request) {
  if (request.history.empty()) {
    return read_paths(request.paths, distance("--radius", request.radius),
                      request.stay     ? Beyond::stays
                      : request.vanish ? Beyond::vanishes
                                       : Beyond::unsaid);
  }
  if (!request.radius.empty()) throw UsageError("--radius: the scene gives the radii");
  if (request.stay || request.vanish) {
    throw UsageError("--stay, --vanish: the disks of a scene are there all the time");
  }
  require_order(request.paths, request.history);
  return history_paths(read_scene(request.paths), request.history, request.options);
}

ExitCode tell_clearance(const Request& request) {
  require_distinct({request.paths, request.history}, {request.output});
  const CooperativeInterruption interruption;
  const EventLimit limit(request.options.max_events);
  const GivenPaths given = paths_of(request);
  const ClearanceAnswer told = answer_clearance(
      {request.paths, distance("--below", request.below), distance("--required", request.required)},
      given, [&] { return !interruption.requested(); });
  give(told.answer, request.output, words_beside({request.output}));
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
  verb.input("paths", request->paths,
             "A table of waypoints (disk,t,x,y and perhaps radius), the log of a CCBS plan (XML), "
             "or, with a "
             "history, a scene.")
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
            "Prove that every gap is at least this, and positive, or refute it.");
  verb.output("-o,--output", request->output, "Write the answer here, as JSON, besides the lines.");
  verb.note(
      "Judged are the piecewise linear paths between the waypoints. A negative gap is an overlap. "
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
