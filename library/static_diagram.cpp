#include "voroproof/static_diagram.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/resting_diagram.h"
#include "filtered/numbers/dd_ball.h"
#include "filtered/search/collapse.h"
#include "library/places.h"
#include "library/values.h"

namespace voroproof {
namespace internal {
namespace {

void require_number(double x, const char* name, std::size_t disk) {
  const double size = std::fabs(x);
  if (std::isfinite(x) && (x == 0 || (size >= 1e-100 && size <= 1e100))) return;
  throw std::invalid_argument("disk " + std::to_string(disk) + ": " + name +
                              ": not finite, or beyond 1e-100 to 1e100 in magnitude");
}

void require_disks(const std::vector<Circle>& disks, bool framed) {
  for (std::size_t k = 0; k < disks.size(); ++k) {
    const auto& [center, radius] = disks[k];
    require_number(center[0], "center", k);
    require_number(center[1], "center", k);
    require_number(radius, "radius", k);
    if (framed && radius < 0) {
      throw std::invalid_argument("disk " + std::to_string(k) + ": radius: negative, in a frame");
    }
  }
}

// In the plane radii may be made larger by one number: by that of the least, which is negative.
MotionInput motion_input(const std::vector<Circle>& disks, const std::optional<Circle>& frame) {
  MotionInput input;
  Rational least = 0;
  if (frame) {
    input.container_x = to_rational(frame->center[0]);
    input.container_y = to_rational(frame->center[1]);
    input.container_radius = to_rational(frame->radius);
  } else if (!disks.empty()) {
    // Any place near the disks.
    input.container_x = to_rational(disks[0].center[0]);
    input.container_y = to_rational(disks[0].center[1]);
    input.container_radius = 1;
    for (const Circle& d : disks) least = std::min(least, to_rational(d.radius));
  }
  input.disks.reserve(disks.size());
  for (const auto& [center, radius] : disks) {
    input.disks.push_back({to_rational(center[0]), to_rational(center[1]),
                           Rational(to_rational(radius) - least), 0, 0, 1});
  }
  return input;
}

// The double to which all values of the ball round.
std::optional<double> nearest(const DdBall& b) {
  const double off = b.rad * (1 + 0x1p-40) + std::fabs(b.lo) * 0x1p-51;
  const double low = b.hi + (b.lo - off), high = b.hi + (b.lo + off);
  if (!(low == high) || !std::isfinite(low)) return std::nullopt;
  return low == 0 ? 0 : low;
}

// The circles of vertices, rounded to nearest.
class Circles {
 public:
  Circles(const std::vector<Circle>& disks, const std::optional<Circle>& frame)
      : disks_(disks), frame_(frame) {}

  // None where the circle is a line, so that the vertex is at infinity.
  std::optional<Vertex> of(const Triple& name) {
    const auto at = tangent_circle(triple<DdBall>(name, [](double x) { return DdBall(x); }));
    const auto x = nearest(at[0]), y = nearest(at[1]), r = nearest(at[2]);
    if (x && y && r) return Vertex{name, {*x, *y}, *r};
    if (circle_exists(triple<Rational>(name, to_rational)) == Sign::zero) return std::nullopt;
    const Places::Rounded circle = exactly().circle(name);
    return Vertex{name, circle.center, circle.radius};
  }

 private:
  template <class T, class Number>
  TangentTriple<T> triple(const Triple& name, const Number& number) const {
    const auto site = [&](GenId g) {
      const auto& [c, r] = g == container_id ? *frame_ : disks_[g];
      return Site<T>{number(c[0]), number(c[1]), number(g == container_id ? -r : r)};
    };
    const auto [i, j, k] = disk_first(name[0], name[1], name[2]);
    return {site(i), site(j), site(k), j == container_id || k == container_id};
  }

  // All generators with more bits, and exactly.
  Places& exactly() {
    if (places_) return *places_;
    const auto site = [](const Circle& c, int sign) {
      return MovingSite<Rational>{to_rational(c.center[0]), to_rational(c.center[1]), 0, 0,
                                  to_rational(sign * c.radius)};
    };
    std::vector<MovingSite<Rational>> sites{site(frame_.value_or(Circle{{}, 1}), -1)};
    for (const Circle& d : disks_) sites.push_back(site(d, 1));
    return places_.emplace(std::move(sites));
  }

  const std::vector<Circle>& disks_;
  const std::optional<Circle>& frame_;
  std::optional<Places> places_;
};

// All vertices that are not at infinity.
std::vector<Vertex> vertices_of(const std::vector<Circle>& disks,
                                const std::optional<Circle>& frame,
                                const std::vector<Quad>& edges) {
  std::vector<Triple> names;
  for (const Quad& q : edges) {
    for (const Triple& name : {start_vertex(q), end_vertex(q)}) {
      if (frame || name[0] != container_id) names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  Circles circles(disks, frame);
  std::vector<Vertex> vertices;
  vertices.reserve(names.size());
  for (const Triple& name : names) {
    if (const auto vertex = circles.of(name)) vertices.push_back(*vertex);
  }
  return vertices;
}

}  // namespace
}  // namespace internal

StaticDiagram::StaticDiagram(std::vector<Circle> disks, std::optional<Circle> frame)
    : disks_(std::move(disks)), frame_(frame) {
  internal::with_public_errors([&] {
    internal::require_disks(disks_, frame_.has_value());
    if (frame_) {
      internal::require_disks({*frame_}, true);
      if (!(frame_->radius > 0)) throw std::invalid_argument("frame: no radius");
    }
    internal::TierCounts counts;
    internal::RestingDiagram diagram = internal::resting_diagram(
        internal::motion_input(disks_, frame_),
        frame_ ? internal::Frame::circle : internal::Frame::plane, {}, counts);
    vertices_ = internal::vertices_of(disks_, frame_, diagram.edges);
    hosts_ = std::move(diagram.host);
    for (const internal::Quad& q : diagram.edges) edges_.push_back(internal::edge_value(q));
  });
}

double StaticDiagram::tolerance(const Box& box) {
  return std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]) / 1000;
}

Box StaticDiagram::box() const {
  if (frame_) {
    const auto& [c, r] = *frame_;
    return {{c[0] - r, c[1] - r}, {c[0] + r, c[1] + r}};
  }
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
