#include "library/resting_disks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "exact/tower.h"
#include "filtered/numbers/dd_ball.h"

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

Framed RestingFrame::framed(std::size_t disks) const {
  return Framed(kind(), static_cast<GenId>(disks + (walls ? wall_count : 0)));
}

void require_disks(const std::vector<Circle>& disks, const RestingFrame& frame) {
  for (std::size_t k = 0; k < disks.size(); ++k) {
    const std::string name = "disk " + std::to_string(k);
    require_numbers(disks[k], name);
    if (frame.kind() != Frame::plane && disks[k].radius < 0) {
      throw std::invalid_argument(name + ": radius: negative, in a frame");
    }
  }
  if (frame.circle && frame.walls) throw std::invalid_argument("frame: a circle and walls");
  if (frame.circle) {
    require_numbers(*frame.circle, "frame");
    if (!(frame.circle->radius > 0)) throw std::invalid_argument("frame: no radius");
  }
  if (!frame.walls) return;
  const auto& [low, high] = *frame.walls;
  for (const Vector& corner : {low, high}) require_numbers({corner, 0}, "frame");
  if (!(low[0] < high[0] && low[1] < high[1])) throw std::invalid_argument("frame: no area");
}

MotionInput resting_input(const std::vector<Circle>& disks, const RestingFrame& frame) {
  MotionInput input;
  CompactRational least = 0.0;
  if (frame.circle) {
    input.container_x = to_rational(frame.circle->center[0]);
    input.container_y = to_rational(frame.circle->center[1]);
    input.container_radius = to_rational(frame.circle->radius);
  } else if (frame.walls || !disks.empty()) {
    // Any place near the disks.
    const Vector& near = frame.walls ? frame.walls->low : disks[0].center;
    input.container_x = to_rational(near[0]);
    input.container_y = to_rational(near[1]);
    input.container_radius = 1;
    const auto by_radius = [](const Circle& a, const Circle& b) { return a.radius < b.radius; };
    const auto smallest = std::min_element(disks.begin(), disks.end(), by_radius);
    if (smallest != disks.end()) least = std::min(0.0, smallest->radius);
  }
  input.disks.reserve(disks.size() + wall_count);
  for (const auto& [center, radius] : disks) {
    input.disks.push_back({center[0], center[1], radius - least, 0.0, 0.0, 1.0});
  }
  for (int quarter = 0; frame.walls && quarter < wall_count; ++quarter) {
    const Vector at = frame.place(quarter);
    input.disks.push_back({at[0], at[1], 0.0, 0.0, 0.0, 1.0});
  }
  return input;
}

template <class T, class Number>
auto VertexCircles::sites(const Number& number) const {
  return [this, number](GenId g) {
    if (framed_.is_wall(g)) {
      const Vector at = frame_.place(framed_.quarter(g));
      return Site<T>{number(at[0]), number(at[1]), number(0)};
    }
    const auto& [c, r] = g == container_id ? *frame_.circle : disks_[g];
    return Site<T>{number(c[0]), number(c[1]), number(g == container_id ? -r : r)};
  };
}

template <class T, class Number, class Root>
std::array<T, 3> VertexCircles::circle(const Triple& name, const Number& number,
                                       const Root& root) const {
  const auto at = sites<T>(number);
  if (!framed_.has_disk(name)) {
    const Site<T> between = framed_.between_walls(at, name);
    return {between.x, between.y, T(-between.r)};
  }
  return tangent_circle(framed_.triple(at, name[0], name[1], name[2]), root);
}

std::optional<Vertex> VertexCircles::of(const Triple& name) const {
  const auto at = circle<DdBall>(
      name, [](double x) { return DdBall(x); }, OwnRoot{});
  const auto x = nearest(at[0]), y = nearest(at[1]), r = nearest(at[2]);
  if (x && y && r) return Vertex{name, {*x, *y}, *r};
  if (framed_.has_disk(name)) {
    const auto exact = sites<Rational>(to_rational);
    if (circle_exists(framed_.triple(exact, name[0], name[1], name[2])) == Sign::zero) {
      return std::nullopt;
    }
  }
  const auto near = circle<Ball>(
      name, [](double v) { return Ball(v, 160); }, OwnRoot{});
  Vertex vertex{name, {}, 0};
  if (near[0].round_to_double(vertex.center[0]) && near[1].round_to_double(vertex.center[1]) &&
      near[2].round_to_double(vertex.radius)) {
    return vertex;
  }
  try {
    RadicalField field;
    const auto exact = circle<Tower>(
        name, [](double v) { return Tower(to_rational(v)); },
        [&](const Tower& v) { return field.sqrt(v); });
    return Vertex{
        name, {round_nearest(exact[0]), round_nearest(exact[1])}, round_nearest(exact[2])};
  } catch (const BudgetExceeded& why) {
    throw Undecided(std::string("a vertex is too near the middle between two binary64: ") +
                    why.what());
  }
}

}  // namespace voroproof::internal
