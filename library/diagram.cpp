#include "voroproof/diagram.h"

#include <algorithm>

#include "history/error.h"
#include "library/snapshot.h"
#include "library/values.h"

namespace voroproof {
namespace internal {

voroproof::Diagram diagram_value(const DiagramFile& file) {
  voroproof::Diagram out;
  out.t = file.t_text.empty() ? voroproof::Number(file.t) : voroproof::Number(file.t_text);
  out.scene_sha256 = file.scene_sha256;
  out.container_center = file.container_center;
  out.container_radius = file.container_radius;
  out.extensions = file.extensions;
  for (const DiagramDisk& d : file.disks) out.disks.push_back({d.center, d.velocity, d.radius});
  for (const DiagramVertex& v : file.vertices) {
    out.vertices.push_back({v.generators, v.center, v.radius});
  }
  for (const Quad& q : file.edges) out.edges.push_back(edge_value(q));
  return out;
}

DiagramFile diagram_file(const voroproof::Diagram& diagram) {
  DiagramFile file;
  file.t = diagram.t.nearest();
  if (!diagram.t.is_double()) file.t_text = diagram.t.text();
  file.scene_sha256 = diagram.scene_sha256;
  file.container_center = diagram.container_center;
  file.container_radius = diagram.container_radius;
  file.extensions = diagram.extensions;
  for (const PlacedDisk& d : diagram.disks) file.disks.push_back({d.center, d.radius, d.velocity});
  for (const Vertex& v : diagram.vertices) {
    file.vertices.push_back({v.generators, v.center, v.radius});
  }
  for (const voroproof::Edge& e : diagram.edges) file.edges.push_back(quad(e));
  return file;
}

}  // namespace internal

using internal::with_public_errors;

Diagram diagram_at(const Scene& scene, const Number& t, int max_bits) {
  return with_public_errors([&] {
    return internal::diagram_value(internal::snapshot(
        internal::checked_scene(scene), internal::instant(t), internal::engine_options(max_bits)));
  });
}

Diagram diagram_at(const Scene& scene, const History& history, const Number& t, int max_bits,
                   bool checked) {
  return with_public_errors([&] {
    const internal::Claim claim = internal::memory_claim(scene, history);
    return internal::diagram_value(internal::snapshot(claim.scene, *claim.history, "history",
                                                      internal::instant(t),
                                                      internal::engine_options(max_bits), checked));
  });
}

std::vector<int> neighbours(const Diagram& diagram, int generator) {
  std::vector<int> out;
  for (const Edge& edge : diagram.edges) {
    if (edge.l == generator) out.push_back(edge.r);
    if (edge.r == generator) out.push_back(edge.l);
  }
  // A lone disk shares the one edge there is with the container; it has no quadruplet.
  if (diagram.disks.size() == 1 && (generator == 0 || generator == container)) {
    out.push_back(generator == 0 ? container : 0);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

Diagram read_diagram(const std::string& path) {
  return with_public_errors([&] { return internal::diagram_value(internal::read_diagram(path)); });
}

void write_diagram(const std::string& path, const Diagram& diagram) {
  with_public_errors([&] { internal::write_diagram(path, internal::diagram_file(diagram)); });
}

}  // namespace voroproof
