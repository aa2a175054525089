// voroproof render: the picture of a diagram file.
#include <memory>
#include <stdexcept>

#include "apps/command_line.h"
#include "apps/render.h"
#include "history/error.h"

namespace voroproof {
namespace {

struct Request {
  std::string diagram, output, probe;
  RenderOptions options;
};

ExitCode render(const Request& request) {
  require_distinct({request.diagram}, {request.output});
  const DiagramFile diagram = read_diagram(request.diagram);
  RenderOptions options = request.options;
  if (!request.probe.empty()) {
    options.probe = round_nearest(time_argument("--probe", request.probe));
  }
  try {
    render_diagram(diagram, request.output, options);
  } catch (const std::invalid_argument& fault) {
    throw UsageError(printable(request.diagram) + ": " + fault.what());
  }
  return ExitCode::ok;
}

}  // namespace

void add_render(CLI::App& app, Action& action) {
  auto request = std::make_shared<Request>();
  CLI::App* verb = app.add_subcommand("render", "Draw a diagram as SVG or PNG");
  add_file(*verb, "diagram", request->diagram, "the diagram file")->required();
  add_output(*verb, request->output, "the picture to write; its name ends in .svg or .png");
  verb->add_option("--size", request->options.size, "width and height in pixels")
      ->check(whole_number())
      ->check(CLI::Range(16, 20000))
      ->capture_default_str();
  add_text(*verb, "--probe", request->probe, "RADIUS",
           "the voids of a probe in colours, the tunnels it passes as strong lines and the\n"
           "offset of the disks and the container in red, instead of the cells");
  verb->footer("Example:\n  voroproof render a.diagram.json -o a.svg");
  verb->callback([request, &action] { action = [request] { return render(*request); }; });
}

}  // namespace voroproof
