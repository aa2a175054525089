// voroproof snapshot: the diagram at one instant.
#include "library/snapshot.h"

#include <memory>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/verbs/verbs.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string scene, history, t, output;
  std::string move, construct;  // "1", "2", ...; empty where not given
  bool unchecked = false;
  EngineOptions options;
};

ExitCode take_snapshot(const Request& request) {
  require_distinct({request.scene, request.history}, {request.output});
  const Rational t = time_argument("--at", request.t);
  if (request.history.empty() &&
      !(request.move.empty() && request.construct.empty() && !request.unchecked)) {
    throw UsageError(
        "--move, --construct and --unchecked say how to follow a history: none is given");
  }
  SnapshotWay way;
  way.checked = !request.unchecked;
  if (!request.move.empty()) way.move = static_cast<Move>(std::stoi(request.move));
  if (!request.construct.empty()) {
    way.construct = static_cast<Construct>(std::stoi(request.construct));
  }
  const Scene scene = read_scene(request.scene);
  const DiagramFile diagram = request.history.empty()
                                  ? snapshot(scene, t, request.options)
                                  : snapshot(scene, request.history, t, request.options, way);
  const CooperativeInterruption interruption;
  write_diagram(request.output, diagram);
  return ExitCode::ok;
}

}  // namespace

void add_snapshot(CLI::App& app, Action& action) {
  auto request = std::make_shared<Request>();
  CLI::App* verb = app.add_subcommand("snapshot", "Write the diagram at one instant");
  add_file(*verb, "scene", request->scene, "the scene")->required();
  add_file(*verb, "history", request->history,
           "a history of the scene: the diagram follows from its flips and recorded\n"
           "positions; without one, from nothing but the true positions at the time");
  add_text(*verb, "--at", request->t, "TIME",
           "the time, whose events have happened, exactly: a decimal (0.1 is one\n"
           "tenth), a fraction (1/3) or a hexadecimal float (0x1.8p-3)")
      ->required();
  verb->add_option("--move", request->move,
                   "how the history brings the disks to their places: 1 all disks at each\n"
                   "event, 2 all at each collision, 3 the colliding ones alone (default)")
      ->check(CLI::IsMember({"1", "2", "3"}))
      ->type_name("WAY");
  verb->add_option("--construct", request->construct,
                   "how it gives the diagram: 1 from scratch at the positions that its\n"
                   "collisions lead to, 2 by its flips (default); see docs/snapshots.md")
      ->check(CLI::IsMember({"1", "2"}))
      ->type_name("WAY");
  verb->add_flag("--unchecked", request->unchecked,
                 "write the diagram of the history's flips also where one of its edges is\n"
                 "illegal beyond tolerances");
  add_output(*verb, request->output, "the diagram to write");
  add_max_bits(*verb, request->options.motion.max_bits);
  add_max_events(*verb, request->options.max_events);
  verb->footer("Example:\n  voroproof snapshot a.scene.json --at 1/3 -o a.diagram.json");
  verb->callback([request, &action] { action = [request] { return take_snapshot(*request); }; });
}

}  // namespace voroproof::internal
