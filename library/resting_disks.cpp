#include "library/resting_disks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "filtered/numbers/dd_ball.h"
#include "filtered/search/collapse.h"

namespace voroproof::internal {

namespace {

void require_numbers(const Circle& circle, const std::string& name) {
  const auto require = [&](double x, const char* field) {
    const double size = std::fabs(x);
    if (std::isfinite(x) && (x == 0 || (size >= 1e-100 && size <= 1e100))) return;
    throw std::invalid_argument(name + ": " + field +
                                ": not finite, or beyond 1e-100 to 1e100 in magnitude");
  };
  require(circle.center[0], "center");
  require(circle.center[1], "center");
  require(circle.radius, "radius");
}

// The double to which all values of the ball round.
std::optional<double> nearest(const DdBall& b) {
  const double off = b.rad * (1 + 0x1p-40) + std::fabs(b.lo) * 0x1p-51;
  const double low = b.hi + (b.lo - off), high = b.hi + (b.lo + off);
  if (!(low == high) || !std::isfinite(low)) return std::nullopt;
  return low == 0 ? 0 : low;
}

}  // namespace

void require_disks(const std::vector<Circle>& disks, const std::optional<Circle>& frame) {
  for (std::size_t k = 0; k < disks.size(); ++k) {
    const std::string name = "disk " + std::to_string(k);
    require_numbers(disks[k], name);
    if (frame && disks[k].radius < 0) {
      throw std::invalid_argument(name + ": radius: negative, in a frame");
    }
  }
  if (!frame) return;
  require_numbers(*frame, "frame");
  if (!(frame->radius > 0)) throw std::invalid_argument("frame: no radius");
}

MotionInput resting_input(const std::vector<Circle>& disks, const std::optional<Circle>& frame) {
  MotionInput input;
  CompactRational least = 0.0;
  if (frame) {
    input.container_x = to_rational(frame->center[0]);
    input.container_y = to_rational(frame->center[1]);
    input.container_radius = to_rational(frame->radius);
  } else if (!disks.empty()) {
    // Any place near the disks.
    input.container_x = to_rational(disks[0].center[0]);
    input.container_y = to_rational(disks[0].center[1]);
    input.container_radius = 1;
    const auto by_radius = [](const Circle& a, const Circle& b) { return a.radius < b.radius; };
    least = std::min(0.0, std::min_element(disks.begin(), disks.end(), by_radius)->radius);
  }
  input.disks.reserve(disks.size());
  for (const auto& [center, radius] : disks) {
    input.disks.push_back({center[0], center[1], radius - least, 0.0, 0.0, 1.0});
  }
  return input;
}

std::optional<Vertex> VertexCircles::of(const Triple& name) {
  const auto at = tangent_circle(triple<DdBall>(name, [](double x) { return DdBall(x); }));
  const auto x = nearest(at[0]), y = nearest(at[1]), r = nearest(at[2]);
  if (x && y && r) return Vertex{name, {*x, *y}, *r};
  if (circle_exists(triple<Rational>(name, to_rational)) == Sign::zero) return std::nullopt;
  const Places::Rounded circle = exactly().circle(name);
  return Vertex{name, circle.center, circle.radius};
}

template <class T, class Number>
TangentTriple<T> VertexCircles::triple(const Triple& name, const Number& number) const {
  const auto site = [&](GenId g) {
    const auto& [c, r] = g == container_id ? *frame_ : disks_[g];
    return Site<T>{number(c[0]), number(c[1]), number(g == container_id ? -r : r)};
  };
  const auto [i, j, k] = disk_first(name[0], name[1], name[2]);
  return {site(i), site(j), site(k), j == container_id || k == container_id};
}

// All generators with more bits, and exactly.
Places& VertexCircles::exactly() {
  if (places_) return *places_;
  const auto site = [](const Circle& c, int sign) {
    return MovingSite<Rational>{to_rational(c.center[0]), to_rational(c.center[1]), 0, 0,
                                to_rational(sign * c.radius)};
  };
  std::vector<MovingSite<Rational>> sites{site(frame_.value_or(Circle{{}, 1}), -1)};
  for (const Circle& d : disks_) sites.push_back(site(d, 1));
  return places_.emplace(std::move(sites));
}

}  // namespace voroproof::internal
