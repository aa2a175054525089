// voroproof render: the picture of a diagram or of a plan.
#include <memory>
#include <stdexcept>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/draw/plan_picture.h"
#include "apps/draw/render.h"
#include "apps/verbs/verbs.h"
#include "history/error.h"
#include "history/file_format.h"

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

void add_render(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb("render", "Draw a diagram or a plan as SVG, PNG or PDF");
  verb.input("input", request->input,
             "A diagram file; or the report of a plan, of which starts, goals, ways, changes of "
             "speed, avoided conjunctions (crosses) and the nearest pair (red) are drawn.")
      .required();
  verb.output(request->output, "The picture to write; its name ends in .svg, .png or .pdf.")
      .required();
  verb.whole("--size", request->options.size, 16, 20000,
             "The width and the height in pixels, 96 an inch.");
  verb.text("--probe", request->probe, "RADIUS",
            "Draw the voids of a probe in colours, the tunnels it passes as strong lines and the "
            "offset of the disks and the container in red, instead of the cells.");
  verb.example("voroproof render a.diagram.json -o a.svg");
  verb.does([request] { return render(*request); });
}

}  // namespace voroproof::internal
