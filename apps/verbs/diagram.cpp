// voroproof diagram: the weighted Voronoi diagram of any disks at rest.
#include <algorithm>
#include <cmath>
#include <memory>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/numbers_argument.h"
#include "apps/draw/picture.h"
#include "apps/draw/static_picture.h"
#include "apps/verbs/frame_argument.h"
#include "apps/verbs/verbs.h"
#include "history/compressor.h"
#include "history/disk_table.h"
#include "history/error.h"
#include "history/json_text.h"
#include "history/output_file.h"
#include "history/utf8.h"
#include "history/world.h"
#include "voroproof/static_diagram.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string input, output, frame, box, tolerance, at;
  int size = 1000;
  bool has_size = false;
};

enum class Kind { map, diagram, edges, picture };

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
  } else if (const auto& walls = diagram.walls()) {
    file.write("{\"low\":" + pair_text(walls->low) + ",\"high\":" + pair_text(walls->high) + "}");
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

// By the name of the output. Throws UsageError for options that are for others.
Kind checked_kind(const Request& request) {
  const std::string_view name = without_compression(request.output);
  const bool is_map = name.ends_with(".geojson"), is_picture = names_picture(request.output);
  if (!request.tolerance.empty() && !is_map) {
    throw UsageError("--tolerance is for maps: --output ends in .geojson");
  }
  if (!request.box.empty() && !is_map && !is_picture) {
    throw UsageError("--box is for maps and pictures: --output ends in .json or .csv");
  }
  if (request.has_size && !is_picture) {
    throw UsageError("--size is for pictures: --output ends in .svg, .png or .pdf");
  }
  if (is_map) return Kind::map;
  if (is_picture) return Kind::picture;
  if (name.ends_with(".json")) return Kind::diagram;
  if (name.ends_with(".csv")) return Kind::edges;
  throw UsageError("--output: none of .geojson, .json, .csv, .svg, .png and .pdf");
}

std::optional<Box> box_of(const Request& request) {
  if (request.box.empty()) return {};
  const auto [x0, y0, x1, y1] = numbers_argument<4>("--box", request.box);
  if (!(x0 < x1 && y0 < y1)) throw UsageError("--box: no area");
  return Box{{x0, y0}, {x1, y1}};
}

double tolerance_of(const Request& request, const Box& box) {
  const double usual = StaticDiagram::tolerance(box);
  if (request.tolerance.empty()) return usual;
  const double tolerance = round_nearest(number_argument("--tolerance", request.tolerance));
  if (!(tolerance >= 1e-6 * usual)) {
    throw UsageError("--tolerance: less than 1e-9 of the box's size");
  }
  return tolerance;
}

struct Disks {
  DiskTable table;
  FrameArgument frame;
};

// The disks of a world at one time, rounded to nearest, by their ids.
Disks disks_of_world(const Request& request) {
  if (!request.frame.empty()) throw UsageError("--frame: a world has its own");
  if (request.at.empty()) throw UsageError("a world is drawn at one time: give --at");
  if (checked_kind(request) != Kind::picture) {
    throw UsageError("a world has pictures: --output ends in .svg, .png or .pdf");
  }
  const Rational t = time_argument("--at", request.at);
  const World world = read_world(request.input);
  if (t > world.horizon) throw UsageError("--at: beyond the horizon of the world");
  const WorldMotion motion = world.motion();
  Disks disks;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < motion.paths.size(); ++k) {
    const auto state = state_at(motion.paths[k], t);
    if (!state) continue;
    disks.table.disks.push_back(
        {round_nearest(state->x), round_nearest(state->y), round_nearest(state->radius)});
    names.push_back(std::to_string(k));
  }
  disks.table.rest.emplace_back("name", std::move(names));
  if (motion.circle) {
    const WorldCircle& c = *motion.circle;
    disks.frame.circle = Circle{{round_nearest(c.center.x), round_nearest(c.center.y)},
                                round_nearest(Rational(c.radius + c.growth * t))};
  }
  return disks;
}

Disks disks_of(const Request& request) {
  if (is_world_file(request.input)) return disks_of_world(request);
  if (!request.at.empty()) throw UsageError("--at: the disks of a table are at rest");
  return {read_disk_table(request.input), frame_argument(request.frame)};
}

StaticDiagram diagram_of(const Request& request, const Disks& read) {
  const auto& [table, frame] = read;
  std::vector<Circle> disks;
  for (std::size_t k = 0; k < table.disks.size(); ++k) {
    const TableDisk& d = table.disks[k];
    if ((frame.circle || frame.walls) && d.radius < 0) {
      throw InputError(request.input, 0, "radius",
                       "disk " + std::to_string(k) + ": negative, in a frame");
    }
    disks.push_back({{d.x, d.y}, d.radius});
  }
  if (frame.walls) return StaticDiagram::between_walls(std::move(disks), *frame.walls);
  return StaticDiagram(std::move(disks), frame.circle);
}

// Bytes that are not UTF-8 become U+FFFD, as in maps.
std::string readable(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = utf8_character(text);
    if (length > 0) {
      out += text.substr(0, length);
    } else {
      append_utf8(out, 0xFFFD);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

// The column `name`, or ids where the table has none.
std::vector<std::string> labels_of(const DiskTable& table) {
  std::vector<std::string> labels;
  for (const auto& [name, values] : table.rest) {
    if (name != "name") continue;
    for (const std::string& value : values) labels.push_back(readable(value));
    return labels;
  }
  for (std::size_t k = 0; k < table.disks.size(); ++k) labels.push_back(std::to_string(k));
  return labels;
}

ExitCode make_diagram(const Request& request) {
  require_distinct({request.input}, {request.output});
  const Kind kind = checked_kind(request);
  const std::optional<Box> asked = box_of(request);
  const CooperativeInterruption interruption;
  const Disks disks = disks_of(request);
  const DiskTable& table = disks.table;
  const StaticDiagram diagram = diagram_of(request, disks);
  const Box box = asked.value_or(diagram.box());
  if (kind == Kind::picture) {
    draw_static_diagram(diagram, box, labels_of(table), request.output, request.size);
    return ExitCode::ok;
  }
  const double tolerance = tolerance_of(request, box);
  OutputFile file(request.output);
  if (kind == Kind::map) file.write(diagram.geojson(box, tolerance, table.rest));
  if (kind == Kind::diagram) write_json(file, diagram);
  if (kind == Kind::edges) write_csv(file, diagram);
  file.commit();
  return ExitCode::ok;
}

}  // namespace

void add_diagram(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb(
      "diagram",
      "Write the weighted Voronoi diagram of any disks at rest, a map or a picture of it");
  verb.input(
          "table", request->input,
          "A line a disk: x, y and radius (weight), with a heading or without one. Disks may "
          "overlap, lie in each other and coincide; radii may be negative. Or a world, a scene of "
          "version 2.")
      .required();
  verb.text("--frame", request->frame, "X,Y,R|X0,Y0,X1,Y1",
            "The circle in which the disks are: centre and radius; or the rectangle: two corners. "
            "Without one they are in the plane.");
  verb.text(
      "--at", request->at, "TIME",
      "Of a world: the time at which its disks are drawn, rounded to nearest, just after what "
      "happens then. Labels are their ids.");
  verb.text("--box", request->box, "X0,Y0,X1,Y1",
            "The box that cells, or the picture, are cut to. Without one it is that of all disks "
            "and a tenth of its size around, or that of the frame.");
  verb.text("--tolerance", request->tolerance, "LENGTH",
            "How far the sides of a cell may be from its true arcs; a thousandth of the box's size "
            "where none is given.");
  verb.whole("--size", request->size, 16, 20000,
             "The width and the height of a picture in pixels, 96 an inch.");
  verb.output(request->output,
              "The cells as a map (.geojson), edges and vertices (.json), edges (.csv), or a "
              "picture (.svg, .png, .pdf), with the column `name` or else ids as labels.")
      .required();
  verb.example("voroproof diagram towns.csv -o towns.geojson");
  verb.example("voroproof diagram towns.csv --size 600 -o towns.png");
  verb.example("voroproof diagram tracks.scene.json --at 7/2 -o tracks.svg");
  verb.does([request, &verb] {
    request->has_size = verb.given("--size");
    return make_diagram(*request);
  });
}

}  // namespace voroproof::internal
