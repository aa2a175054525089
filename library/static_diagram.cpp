#include "voroproof/static_diagram.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <string>

#include "engine/resting_diagram.h"
#include "library/resting_disks.h"
#include "library/values.h"

namespace voroproof {
namespace internal {
namespace {

// All vertices that are not at infinity.
std::vector<Vertex> vertices_of(const std::vector<Circle>& disks, const RestingFrame& frame,
                                const std::vector<Edge>& edges) {
  std::vector<Triple> names;
  names.reserve(2 * edges.size());
  for (const Edge& e : edges) {
    for (const Triple& name : {start_vertex(quad(e)), end_vertex(quad(e))}) {
      if (frame.circle || name[0] != container_id) names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  const VertexCircles circles(disks, frame);
  std::vector<Vertex> vertices;
  vertices.reserve(names.size());
  for (const Triple& name : names) {
    if (const auto vertex = circles.of(name)) vertices.push_back(*vertex);
  }
  return vertices;
}

}  // namespace
}  // namespace internal

struct StaticDiagram::Vertices {
  std::once_flag once;
  std::vector<Vertex> all;
};

StaticDiagram::StaticDiagram(std::vector<Circle> disks, std::optional<Circle> frame)
    : StaticDiagram(std::move(disks), frame, std::nullopt) {}

StaticDiagram StaticDiagram::between_walls(std::vector<Circle> disks, const Box& walls) {
  return {std::move(disks), std::nullopt, walls};
}

StaticDiagram::StaticDiagram(std::vector<Circle> disks, std::optional<Circle> frame,
                             std::optional<Box> walls)
    : disks_(std::move(disks)),
      frame_(frame),
      walls_(walls),
      vertices_(std::make_shared<Vertices>()) {
  internal::with_public_errors([&] {
    const internal::RestingFrame around{frame_, walls_};
    internal::require_disks(disks_, around);
    internal::TierCounts counts;
    internal::RestingDiagram diagram = internal::resting_diagram(
        internal::resting_input(disks_, around), around.kind(), {}, counts);
    hosts_ = std::move(diagram.host);
    hosts_.resize(disks_.size());
    edges_.reserve(diagram.edges.size());
    for (const internal::Quad& q : diagram.edges) edges_.push_back(internal::edge_value(q));
  });
}

const std::vector<Vertex>& StaticDiagram::vertices() const {
  std::call_once(vertices_->once, [&] {
    internal::with_public_errors([&] {
      vertices_->all = internal::vertices_of(disks_, {frame_, walls_}, edges_);
    });
  });
  return vertices_->all;
}

double StaticDiagram::tolerance(const Box& box) {
  return std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]) / 1000;
}

Box StaticDiagram::box() const {
  if (frame_) {
    const auto& [c, r] = *frame_;
    return {{c[0] - r, c[1] - r}, {c[0] + r, c[1] + r}};
  }
  if (walls_) return *walls_;
  Box box;
  bool first = true;
  for (std::size_t k = 0; k < disks_.size(); ++k) {
    if (hosts_[k] != visible) continue;
    const auto& [c, radius] = disks_[k];
    const double r = std::max(radius, 0.0);
    for (const int axis : {0, 1}) {
      box.low[axis] = first ? c[axis] - r : std::min(box.low[axis], c[axis] - r);
      box.high[axis] = first ? c[axis] + r : std::max(box.high[axis], c[axis] + r);
    }
    first = false;
  }
  const double size = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  const double margin = size > 0 ? size / 10 : 1;
  return {{box.low[0] - margin, box.low[1] - margin}, {box.high[0] + margin, box.high[1] + margin}};
}

}  // namespace voroproof
