// voroproof snapshot: the diagram at one instant.
#include "apps/snapshot.h"

#include <memory>

#include "apps/command_line.h"
#include "apps/interruption.h"

namespace voroproof {
namespace {

struct Request {
  std::string scene, history, t, output;
};

ExitCode take_snapshot(const Request& request) {
  require_distinct({request.scene, request.history}, {request.output});
  const Rational t = time_argument("--at", request.t);
  const CooperativeInterruption interruption;
  const Scene scene = read_scene(request.scene);
  EngineOptions options;
  options.monitor = [&](double, std::uint64_t) { return !interruption.requested(); };
  const DiagramFile diagram = request.history.empty()
                                  ? snapshot(scene, t, options)
                                  : snapshot(scene, request.history, t, options);
  interruption.check();
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
  add_output(*verb, request->output, "the diagram to write");
  verb->footer("Example:\n  voroproof snapshot a.scene.json --at 1/3 -o a.diagram.json");
  verb->callback([request, &action] { action = [request] { return take_snapshot(*request); }; });
}

}  // namespace voroproof
