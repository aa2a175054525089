// The largest empty circles between disks at rest.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "library/box_border.h"
#include "library/static_slopes.h"
#include "library/values.h"
#include "voroproof/static_diagram.h"

namespace voroproof {
namespace internal {
namespace {

// The vertices of a diagram, those together that are at one place, or at both ends of an edge that
// is level.
class Summits {
 public:
  Summits(const StaticDiagram& diagram, const std::vector<ClearanceEdge>& edges)
      : vertices_(diagram.vertices()), parent_(vertices_.size()), rises_(vertices_.size(), false) {
    std::iota(parent_.begin(), parent_.end(), 0);
    const StaticSlopes slopes(diagram);
    for (const ClearanceEdge& edge : edges) {
      const bool starts = edge.start != ClearanceEdge::none, ends = edge.end != ClearanceEdge::none;
      if (starts && ends && (is_point(edge) || slopes.is_level(edge))) {
        parent_[find(edge.start)] = find(edge.end);
        continue;
      }
      if (starts && slopes.rises_from_start(edge)) rises_[edge.start] = true;
      if (ends && slopes.rises_from_end(edge)) rises_[edge.end] = true;
    }
  }

  // The groups from which no edge rises, each at its first vertex for which `counts`.
  template <class Counts>
  std::vector<EmptyCircle> circles(const Counts& counts) {
    std::vector<bool> is_done(vertices_.size(), false);
    std::vector<std::vector<int>> members(vertices_.size());
    for (int k = 0; k < size(); ++k) {
      members[find(k)].push_back(k);
      if (rises_[k]) is_done[find(k)] = true;
    }
    std::vector<EmptyCircle> all;
    for (int k = 0; k < size(); ++k) {
      if (is_done[find(k)] || !counts(vertices_[k].center)) continue;
      is_done[find(k)] = true;
      EmptyCircle circle{vertices_[k].center, vertices_[k].radius, {}};
      auto& touched = circle.generators;
      for (const int m : members[find(k)]) {
        if (!is_same(k, m)) continue;
        const auto& names = vertices_[m].generators;
        touched.insert(touched.end(), names.begin(), names.end());
      }
      std::sort(touched.begin(), touched.end());
      touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
      all.push_back(std::move(circle));
    }
    return all;
  }

 private:
  int size() const { return static_cast<int>(vertices_.size()); }
  // Places that are rounded to nearest differ where these do.
  bool is_same(int a, int b) const {
    return vertices_[a].center == vertices_[b].center && vertices_[a].radius == vertices_[b].radius;
  }
  bool is_point(const ClearanceEdge& edge) const { return is_same(edge.start, edge.end); }
  int find(int k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }

  const std::vector<Vertex>& vertices_;
  std::vector<int> parent_;
  std::vector<bool> rises_;
};

// The greatest clearances in a frame that are at no vertex: at far points, anywhere on a level edge
// around a lone disk, and in the centre where no disk is seen.
std::vector<EmptyCircle> places_in_frame(const StaticDiagram& diagram,
                                         const std::vector<ClearanceEdge>& edges) {
  const auto& frame = diagram.frame();
  if (!frame) return {};
  if (edges.empty()) return {{frame->center, frame->radius, {container_id}}};
  const StaticSlopes slopes(diagram);
  std::vector<EmptyCircle> all;
  for (const ClearanceEdge& edge : edges) {
    if (slopes.has_far_point(edge)) all.push_back(slopes.far_point(edge));
    if (edge.start != ClearanceEdge::none || !slopes.is_level(edge)) continue;
    const double r = generator_of(diagram, edge.disk).radius;
    all.push_back({{frame->center[0] + (frame->radius + r) / 2, frame->center[1]},
                   (frame->radius - r) / 2,
                   {container_id, edge.disk}});
  }
  return all;
}

void require_box(const Box& box) {
  for (const int axis : {0, 1}) {
    const double low = box.low[axis], high = box.high[axis];
    if (low < high && std::fabs(low) <= 1e100 && std::fabs(high) <= 1e100) continue;
    throw std::invalid_argument("box: no area, or beyond 1e100 in magnitude");
  }
}

// The places in the box where the clearance is greatest around, the largest circle first; the first
// place is the one of greatest clearance of all, also where doubles deny it.
std::vector<EmptyCircle> greatest_places(const StaticDiagram& diagram, const Box& box) {
  require_box(box);
  if (diagram.walls()) throw std::invalid_argument("voids: not made between walls");
  const std::vector<ClearanceEdge> edges = clearance_edges(diagram);
  const auto is_inside = [&](const Vector& p) {
    return box.low[0] < p[0] && p[0] < box.high[0] && box.low[1] < p[1] && p[1] < box.high[1];
  };
  std::vector<BorderPlace> places = border_places(diagram, edges, box);
  for (EmptyCircle& circle : Summits(diagram, edges).circles(is_inside)) {
    places.push_back({std::move(circle), true});
  }
  for (EmptyCircle& circle : places_in_frame(diagram, edges)) {
    if (is_inside(circle.center)) places.push_back({std::move(circle), true});
  }
  std::sort(places.begin(), places.end(), [](const BorderPlace& a, const BorderPlace& b) {
    return std::tuple(-a.circle.radius, a.circle.center) <
           std::tuple(-b.circle.radius, b.circle.center);
  });
  std::vector<EmptyCircle> all;
  for (BorderPlace& place : places) {
    if (all.empty() || place.is_greatest) all.push_back(std::move(place.circle));
  }
  return all;
}

}  // namespace
}  // namespace internal

std::optional<EmptyCircle> StaticDiagram::largest_empty_circle(const Box& box) const {
  return internal::with_public_errors([&]() -> std::optional<EmptyCircle> {
    EmptyCircle largest = internal::greatest_places(*this, box).front();
    if (largest.radius < 0) return std::nullopt;
    return largest;
  });
}

std::vector<EmptyCircle> StaticDiagram::voids(const Box& box, double probe) const {
  return internal::with_public_errors([&] {
    if (!(probe >= 0)) throw std::invalid_argument("probe: negative, or no number");
    std::vector<EmptyCircle> all = internal::greatest_places(*this, box);
    std::erase_if(all, [&](const EmptyCircle& circle) { return circle.radius < probe; });
    return all;
  });
}

}  // namespace voroproof
