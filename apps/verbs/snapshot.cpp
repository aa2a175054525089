// voroproof snapshot: the diagram at one instant.
#include "library/snapshot.h"

#include <memory>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/verbs/verbs.h"
#include "history/event_limit.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string scene, history, t, output, index;
  std::string move, construct;  // "1", "2", ...; empty where not given
  bool unchecked = false;
  EngineOptions options;
};

ExitCode take_snapshot(const Request& request) {
  require_distinct({request.scene, request.history, request.index}, {request.output});
  require_order(request.scene, request.history);
  const Rational t = time_argument("--at", request.t);
  if (request.history.empty() && !(request.move.empty() && request.construct.empty() &&
                                   !request.unchecked && request.index.empty())) {
    throw UsageError(
        "--move, --construct, --unchecked and --index say how to follow a history: none is given");
  }
  SnapshotWay way;
  way.checked = !request.unchecked;
  if (!request.move.empty()) way.move = static_cast<Move>(std::stoi(request.move));
  if (!request.construct.empty()) {
    way.construct = static_cast<Construct>(std::stoi(request.construct));
  }
  const EventLimit limit(request.options.max_events);
  const Scene scene = read_scene(request.scene);
  if (!request.index.empty()) way.index = {request.index, producer()};
  const DiagramFile diagram = request.history.empty()
                                  ? snapshot(scene, t, request.options)
                                  : snapshot(scene, request.history, t, request.options, way);
  const CooperativeInterruption interruption;
  write_diagram(request.output, diagram);
  return ExitCode::ok;
}

}  // namespace

void add_snapshot(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb("snapshot", "Write the diagram at one instant");
  verb.input("scene", request->scene, "The scene.").required();
  verb.input("history", request->history,
             "A history of the scene: the diagram follows from its flips and recorded positions. "
             "Without one it follows from nothing but the true positions at the time.");
  verb.text(
          "--at", request->t, "TIME",
          "The time, whose events have happened, exactly: a decimal (0.1 is one tenth), a fraction "
          "(1/3) or a hexadecimal float (0x1.8p-3).")
      .required();
  verb.choice(
      "--move", {"1", "2", "3"}, request->move,
      "How the history brings the disks to their places: 1 moves all disks at each event, 2 "
      "all at each collision, 3 (without this option) the colliding ones alone.");
  verb.choice(
      "--construct", {"1", "2"}, request->construct,
      "How the history gives the diagram: 1 constructs it from scratch at the positions that "
      "its collisions lead to, 2 (without this option) follows its flips; see "
      "docs/snapshots.md.");
  verb.flag(
      "--unchecked", request->unchecked,
      "Write the diagram of the history's flips also where one of its edges is illegal beyond "
      "tolerances.");
  verb.input("--index", request->index,
             "An index of the history (voroproof index): it is read from the last place before the "
             "time that the index names up to the time. The state there is believed.")
      .excludes({"--move", "--construct", "--max-events"});
  verb.output(request->output, "The diagram to write.").required();
  add_computing_limits(verb, request->options);
  verb.example("voroproof snapshot a.scene.json --at 1/3 -o a.diagram.json");
  verb.does([request] { return take_snapshot(*request); });
}

}  // namespace voroproof::internal
