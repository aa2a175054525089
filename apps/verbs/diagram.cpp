// voroproof diagram: the weighted Voronoi diagram of any disks at rest.
#include <array>
#include <cmath>
#include <memory>
#include <sstream>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/verbs/verbs.h"
#include "history/compressor.h"
#include "history/disk_table.h"
#include "history/error.h"
#include "history/json_text.h"
#include "history/output_file.h"
#include "voroproof/static_diagram.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string input, output, frame, box, tolerance;
};

// The numbers of an option, separated by commas.
template <std::size_t N>
std::array<double, N> numbers(const std::string& option, const std::string& text) {
  std::array<double, N> all{};
  std::istringstream words(text);
  std::string word;
  for (double& x : all) {
    if (!std::getline(words, word, ',')) throw UsageError(option + ": too few numbers");
    x = round_nearest(number_argument(option, word));
  }
  if (std::getline(words, word)) throw UsageError(option + ": too many numbers");
  return all;
}

std::string pair_text(const Vector& v) {
  return "[" + number_text(v[0]) + "," + number_text(v[1]) + "]";
}

std::string edge_text(const voroproof::Edge& e) {
  return "[" + std::to_string(e.l) + "," + std::to_string(e.r) + "," + std::to_string(e.s) + "," +
         std::to_string(e.e) + "]";
}

void write_json(OutputFile& file, const StaticDiagram& diagram) {
  file.write("{\"format\":\"voroproof-static-diagram\",\"version\":1,\n\"frame\":");
  if (const auto& frame = diagram.frame()) {
    file.write("{\"center\":" + pair_text(frame->center) +
               ",\"radius\":" + number_text(frame->radius) + "}");
  } else {
    file.write("\"none\"");
  }
  const auto list = [&](const char* name, const auto& items, const auto& text) {
    file.write(std::string(",\n\"") + name + "\":[");
    for (std::size_t k = 0; k < items.size(); ++k) file.write((k == 0 ? "\n" : ",\n") + text(k));
    file.write("]");
  };
  list("disks", diagram.disks(), [&](std::size_t k) {
    const auto& [center, radius] = diagram.disks()[k];
    const int host = diagram.hosts()[k];
    return "{\"center\":" + pair_text(center) + ",\"radius\":" + number_text(radius) +
           (host == StaticDiagram::visible ? "" : ",\"hidden_by\":" + std::to_string(host)) + "}";
  });
  list("vertices", diagram.vertices(), [&](std::size_t k) {
    const voroproof::Vertex& v = diagram.vertices()[k];
    return "{\"generators\":[" + std::to_string(v.generators[0]) + "," +
           std::to_string(v.generators[1]) + "," + std::to_string(v.generators[2]) +
           "],\"center\":" + pair_text(v.center) + ",\"radius\":" + number_text(v.radius) + "}";
  });
  list("edges", diagram.edges(), [&](std::size_t k) { return edge_text(diagram.edges()[k]); });
  file.write("}\n");
}

void write_csv(OutputFile& file, const StaticDiagram& diagram) {
  file.write("left,right,start,end\n");
  for (const voroproof::Edge& e : diagram.edges()) {
    const std::string text = edge_text(e);
    file.write(text.substr(1, text.size() - 2) + "\n");
  }
}

ExitCode make_diagram(const Request& request) {
  require_distinct({request.input}, {request.output});
  const std::string_view name = without_compression(request.output);
  const bool geojson = name.ends_with(".geojson"), csv = name.ends_with(".csv");
  if (!geojson && !csv && !name.ends_with(".json")) {
    throw UsageError("--output: none of .geojson, .json and .csv");
  }
  if (!geojson && !(request.box.empty() && request.tolerance.empty())) {
    throw UsageError("--box and --tolerance are for cells: --output ends in .geojson");
  }
  std::optional<Circle> frame;
  if (!request.frame.empty()) {
    const auto [x, y, r] = numbers<3>("--frame", request.frame);
    if (!(r > 0)) throw UsageError("--frame: its radius is not positive");
    frame = Circle{{x, y}, r};
  }
  const CooperativeInterruption interruption;
  const DiskTable table = read_disk_table(request.input);
  std::vector<Circle> disks;
  for (std::size_t k = 0; k < table.disks.size(); ++k) {
    const TableDisk& d = table.disks[k];
    if (frame && d.radius < 0) {
      throw InputError(request.input, 0, "radius",
                       "disk " + std::to_string(k) + ": negative, in a frame");
    }
    disks.push_back({{d.x, d.y}, d.radius});
  }
  const StaticDiagram diagram(std::move(disks), frame);
  Box box = diagram.box();
  if (!request.box.empty()) {
    const auto [x0, y0, x1, y1] = numbers<4>("--box", request.box);
    box = {{x0, y0}, {x1, y1}};
    if (!(x0 < x1 && y0 < y1)) throw UsageError("--box: no area");
  }
  double tolerance = StaticDiagram::tolerance(box);
  if (!request.tolerance.empty()) {
    const double least = 1e-6 * tolerance;
    tolerance = round_nearest(number_argument("--tolerance", request.tolerance));
    if (!(tolerance >= least)) {
      throw UsageError("--tolerance: less than 1e-9 of the box's size");
    }
  }
  OutputFile file(request.output);
  if (geojson) {
    file.write(diagram.geojson(box, tolerance, table.rest));
  } else if (csv) {
    write_csv(file, diagram);
  } else {
    write_json(file, diagram);
  }
  file.commit();
  return ExitCode::ok;
}

}  // namespace

void add_diagram(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb(
      "diagram", "Write the weighted Voronoi diagram of any disks at rest, or a map of its cells");
  verb.input("table", request->input,
             "A line a disk: x, y and radius (weight), with a heading or without one. Disks may "
             "overlap, lie in each other and coincide; radii may be negative.")
      .required();
  verb.text("--frame", request->frame, "X,Y,R",
            "The circle in which the disks are: centre and radius. Without one they are in the "
            "plane.");
  verb.text("--box", request->box, "X0,Y0,X1,Y1",
            "The box that cells are cut to. Without one it is that of all disks and a tenth of its "
            "size around, or that of the frame.");
  verb.text("--tolerance", request->tolerance, "LENGTH",
            "How far the sides of a cell may be from its true arcs; a thousandth of the box's size "
            "where none is given.");
  verb.output(request->output,
              "The cells as a map (.geojson), edges and vertices (.json), or edges (.csv).")
      .required();
  verb.example("voroproof diagram towns.csv -o towns.geojson");
  verb.does([request] { return make_diagram(*request); });
}

}  // namespace voroproof::internal
