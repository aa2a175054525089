// voroproof render: the picture of a diagram or of a plan.
#include <memory>
#include <stdexcept>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/draw/plan_picture.h"
#include "apps/draw/render.h"
#include "apps/verbs/verbs.h"
#include "history/error.h"
#include "history/validate.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string input, output, probe;
  RenderOptions options;
};

void draw_diagram(const Request& request) {
  RenderOptions options = request.options;
  if (!request.probe.empty()) {
    options.probe = round_nearest(time_argument("--probe", request.probe));
  }
  const DiagramFile diagram = read_diagram(request.input);
  const CooperativeInterruption interruption;
  try {
    render_diagram(diagram, request.output, options);
  } catch (const std::invalid_argument& fault) {
    throw UsageError(printable(request.input) + ": " + fault.what());
  }
}

void draw_plan_report(const Request& request) {
  if (!request.probe.empty()) throw UsageError("--probe: a plan has no diagram");
  const PlanDrawing drawing = read_plan_report(request.input);
  const CooperativeInterruption interruption;
  draw_plan(drawing, request.output, request.options.size);
}

ExitCode render(const Request& request) {
  require_distinct({request.input}, {request.output});
  require_picture("--output", request.output);
  const FileFormat format = format_of_file(request.input);
  if (format.name == "voroproof-diagram") {
    draw_diagram(request);
  } else if (format.name == "voroproof-plan-report") {
    draw_plan_report(request);
  } else {
    throw InputError(request.input, format.line, "format",
                     "neither a diagram nor a report of a plan: " + printable(format.name));
  }
  return ExitCode::ok;
}

}  // namespace

void add_render(CLI::App& app, Action& action) {
  auto request = std::make_shared<Request>();
  CLI::App* verb = app.add_subcommand("render", "Draw a diagram or a plan as SVG or PNG");
  add_file(*verb, "input", request->input,
           "a diagram file; or the report of a plan, of which starts, goals, ways, changes of\n"
           "speed, avoided conjunctions (crosses) and the nearest pair (red) are drawn")
      ->required();
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

}  // namespace voroproof::internal
