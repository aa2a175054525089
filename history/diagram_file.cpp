#include "history/diagram_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>

#include "history/error.h"
#include "history/file_bytes.h"
#include "history/format_version.h"
#include "history/json_reader.h"
#include "history/json_text.h"
#include "history/output_file.h"
#include "history/scene.h"

namespace voroproof::internal {
namespace {

constexpr auto bit = JsonReader::bit;

// ---- Writing

std::string vector_text(const Vec2& v) {
  return '[' + number_text(v[0]) + ',' + number_text(v[1]) + ']';
}

template <std::size_t N>
std::string ids_text(const std::array<GenId, N>& ids) {
  std::string text;
  for (GenId id : ids) text += (text.empty() ? '[' : ',') + std::to_string(id);
  return text + ']';
}

// Writes ,"name":[...] with one element a line.
template <class T, class Text>
void write_list(OutputFile& file, const char* name, const std::vector<T>& list, Text&& text) {
  file.write(",\n\"" + std::string(name) + "\":[");
  const char* separator = "\n";
  for (const T& element : list) {
    file.write(separator + text(element));
    separator = ",\n";
  }
  file.write("]");
}

// ---- Reading

class DiagramReader {
 public:
  DiagramReader(std::string_view bytes, const std::string& file)
      : file_(file), json_(bytes, file) {}

  DiagramFile read() {
    enum { format, version, t, scene_sha256, container, disks, vertices, edges };
    static constexpr std::array<std::string_view, 8> names = {
        "format", "version", "t", "scene_sha256", "container", "disks", "vertices", "edges"};
    json_.object(
        names, (1u << names.size()) - 1,
        [&](std::size_t member) {
          switch (member) {
            case format:
              if (json_.text() != "voroproof-diagram") json_.fail("not \"voroproof-diagram\"");
              break;
            case version:
              read_version(json_);
              break;
            case t:
              read_time();
              break;
            case scene_sha256:
              read_hash();
              break;
            case container:
              read_container();
              break;
            case disks:
              json_.array([&](std::size_t) { read_disk(); });
              break;
            case vertices:
              vertices_line_ = json_.line();
              json_.array([&](std::size_t) { read_vertex(); });
              break;
            case edges:
              edges_line_ = json_.line();
              json_.array([&](std::size_t) { read_edge(); });
          }
        },
        &diagram_.extensions);
    json_.finish();
    check_topology();
    std::sort(diagram_.edges.begin(), diagram_.edges.end());
    std::sort(diagram_.vertices.begin(), diagram_.vertices.end(),
              [](const auto& a, const auto& b) { return a.generators < b.generators; });
    return std::move(diagram_);
  }

 private:
  void read_time() {
    if (json_.text_is_next()) {
      diagram_.t_text = json_.text();
      const auto exact = parse_rational(diagram_.t_text);
      if (!exact) json_.fail("not an exact number");
      diagram_.t = round_nearest(*exact);
    } else {
      diagram_.t = json_.number().nearest;
    }
    if (!(diagram_.t >= 0 && diagram_.t <= max_scene_value)) json_.fail("not in [0, 1e100]");
  }

  void read_hash() {
    diagram_.scene_sha256 = json_.text();
    if (diagram_.scene_sha256.size() != 64 ||
        diagram_.scene_sha256.find_first_not_of("0123456789abcdef") != std::string::npos)
      json_.fail("not 64 lower-case hexadecimal digits");
  }

  void read_vector(Vec2& v) {
    json_.array_of<2>([&](std::size_t i) { v[i] = json_.number().nearest; });
  }

  void read_radius(double& radius) {
    radius = json_.number().nearest;
    if (radius < 0) json_.fail("negative");
  }

  GenId read_id() { return static_cast<GenId>(json_.integer(container_id, max_disks - 1)); }

  void read_container() {
    enum { center, radius };
    static constexpr std::array<std::string_view, 2> names = {"center", "radius"};
    json_.object(names, bit(center) | bit(radius), [&](std::size_t member) {
      if (member == center)
        read_vector(diagram_.container_center);
      else
        read_radius(diagram_.container_radius);
    });
  }

  void read_disk() {
    enum { center, radius, velocity };
    static constexpr std::array<std::string_view, 3> names = {"center", "radius", "velocity"};
    DiagramDisk disk{};
    json_.object(names, bit(center) | bit(radius) | bit(velocity), [&](std::size_t member) {
      switch (member) {
        case center:
          read_vector(disk.center);
          break;
        case radius:
          read_radius(disk.radius);
          break;
        case velocity:
          read_vector(disk.velocity);
      }
    });
    diagram_.disks.push_back(disk);
  }

  void read_vertex() {
    enum { generators, center, radius };
    static constexpr std::array<std::string_view, 3> names = {"generators", "center", "radius"};
    DiagramVertex vertex{};
    json_.object(names, bit(generators) | bit(center) | bit(radius), [&](std::size_t member) {
      switch (member) {
        case generators: {
          Triple& g = vertex.generators;
          json_.array_of<3>([&](std::size_t i) { g[i] = read_id(); });
          if (g[0] == g[1] || g[1] == g[2] || g[2] == g[0]) json_.fail("generators not distinct");
          g = canonical(g);
          if (!edges_at_.emplace(g, 0).second) json_.fail("a vertex of the same name came before");
          vertex_lines_.push_back(json_.line());
          break;
        }
        case center:
          read_vector(vertex.center);
          break;
        case radius:
          read_radius(vertex.radius);
      }
    });
    diagram_.vertices.push_back(vertex);
  }

  void read_edge() {
    std::array<GenId, 4> ids{};
    json_.array_of<4>([&](std::size_t i) { ids[i] = read_id(); });
    const Quad edge{ids[0], ids[1], ids[2], ids[3]};
    if (!names_an_edge(edge)) json_.fail("names no edge: its generators are not distinct");
    diagram_.edges.push_back(canonical(edge));
    edge_lines_.push_back(json_.line());
  }

  void check_topology() {
    const std::size_t n = diagram_.disks.size();
    const std::size_t vertex_count = n >= 2 ? 2 * (n + 1) - 4 : 0;
    const std::size_t edge_count = n >= 2 ? 3 * (n + 1) - 6 : 0;
    if (diagram_.vertices.size() != vertex_count)
      fail(vertices_line_, "vertices",
           "not the " + std::to_string(vertex_count) + " of " + std::to_string(n) + " disks");
    if (diagram_.edges.size() != edge_count)
      fail(edges_line_, "edges",
           "not the " + std::to_string(edge_count) + " of " + std::to_string(n) + " disks");
    for (std::size_t i = 0; i < diagram_.vertices.size(); ++i) {
      const Triple& g = diagram_.vertices[i].generators;
      if (std::max({g[0], g[1], g[2]}) >= static_cast<int>(n))
        fail(vertex_lines_[i], "vertices[" + std::to_string(i) + "].generators", "no such disk");
    }
    for (std::size_t i = 0; i < diagram_.edges.size(); ++i) {
      const Quad& edge = diagram_.edges[i];
      check_end(i, start_vertex(edge), edge.s);
      check_end(i, end_vertex(edge), edge.e);
    }
  }

  // Three edges end in a vertex, and each faces another of its generators, `third`. There are
  // 3(n+1) - 6 edges for 2(n+1) - 4 vertices, so all vertices have theirs if none has one twice.
  void check_end(std::size_t edge, const Triple& end, GenId third) {
    const std::string field = "edges[" + std::to_string(edge) + "]";
    const auto vertex = edges_at_.find(end);
    if (vertex == edges_at_.end())
      fail(edge_lines_[edge], field, "ends at " + ids_text(end) + ", which is no vertex");
    const unsigned faced = third == end[0] ? 1 : third == end[1] ? 2 : 4;
    if (vertex->second & faced)
      fail(edge_lines_[edge], field, "ends at " + ids_text(end) + " like another before it");
    vertex->second |= faced;
  }

  [[noreturn]] void fail(std::int64_t line, const std::string& field,
                         const std::string& reason) const {
    throw InputError(file_, line, field, reason);
  }

  const std::string& file_;
  JsonReader json_;
  DiagramFile diagram_;
  std::map<Triple, unsigned> edges_at_;  // for each vertex a bit set: the edges seen there
  std::int64_t vertices_line_ = 0, edges_line_ = 0;
  std::vector<std::int64_t> vertex_lines_, edge_lines_;
};

}  // namespace

void write_diagram(const std::string& path, const DiagramFile& diagram) {
  std::vector<DiagramVertex> vertices = diagram.vertices;
  for (DiagramVertex& vertex : vertices) vertex.generators = canonical(vertex.generators);
  std::sort(vertices.begin(), vertices.end(),
            [](const auto& a, const auto& b) { return a.generators < b.generators; });
  std::vector<Quad> edges = diagram.edges;
  for (Quad& edge : edges) edge = canonical(edge);
  std::sort(edges.begin(), edges.end());

  OutputFile file(path);
  file.write("{\"format\":\"voroproof-diagram\",\"version\":1,\"t\":" +
             (diagram.t_text.empty() ? number_text(diagram.t) : string_text(diagram.t_text)) +
             ",\"scene_sha256\":" + string_text(diagram.scene_sha256) +
             ",\n\"container\":{\"center\":" + vector_text(diagram.container_center) +
             ",\"radius\":" + number_text(diagram.container_radius) + "}");
  write_list(file, "disks", diagram.disks, [](const DiagramDisk& disk) {
    return "{\"center\":" + vector_text(disk.center) + ",\"radius\":" + number_text(disk.radius) +
           ",\"velocity\":" + vector_text(disk.velocity) + "}";
  });
  write_list(file, "vertices", vertices, [](const DiagramVertex& vertex) {
    return "{\"generators\":" + ids_text(vertex.generators) +
           ",\"center\":" + vector_text(vertex.center) +
           ",\"radius\":" + number_text(vertex.radius) + "}";
  });
  write_list(file, "edges", edges, [](const Quad& edge) {
    return ids_text(std::array<GenId, 4>{edge.l, edge.r, edge.s, edge.e});
  });
  const std::string extensions = members_text(diagram.extensions);
  file.write(extensions.empty() ? "}\n" : ",\n" + extensions.substr(1) + "}\n");
  file.commit();
}

DiagramFile parse_diagram(std::string_view bytes, const std::string& file_name) {
  return of_this_version(bytes, file_name, "voroproof-diagram",
                         [&] { return DiagramReader(bytes, file_name).read(); });
}

DiagramFile read_diagram(const std::string& path) {
  return parse_diagram(file_bytes(path, max_diagram_bytes), path);
}

}  // namespace voroproof::internal
