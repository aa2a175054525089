#include "library/conic_arc.h"

#include <algorithm>

namespace voroproof::internal {
namespace {

using Control = ConicArc::Control;

// Halves of doubles are exact.
DoubleBall middle(const DoubleBall& a, const DoubleBall& b) {
  const DoubleBall sum = a + b;
  return {sum.mid / 2, sum.rad / 2 + double_ball_detail::kTiny};
}
Control middle(const Control& a, const Control& b) {
  return {middle(a.x, b.x), middle(a.y, b.y), middle(a.weight, b.weight)};
}

// A power of two, so that it multiplies exactly, of about the reciprocal of the distance.
double reciprocal_size(const BallPoint& p) {
  const double size = std::fabs(p.x.mid) + std::fabs(p.y.mid);
  int exponent = 0;
  std::frexp(size, &exponent);
  return std::ldexp(1.0, std::clamp(-exponent, -400, 400));
}

Control scaled(double k, const BallPoint& p) {
  return {{k * p.x.mid, k * p.x.rad}, {k * p.y.mid, k * p.y.rad}, k};
}

}  // namespace

ConicArc ConicArc::segment(const BallPoint& start, const BallPoint& end) {
  const Control from = scaled(reciprocal_size(start), start),
                to = scaled(reciprocal_size(end), end);
  ConicArc arc({from, middle(from, to), to});
  arc.straight_ = true;
  return arc;
}

BallPoint ConicArc::point(int k) const {
  const auto& [x, y, weight] = controls_[k];
  return {x / weight, y / weight};
}

bool ConicArc::is_proper() const {
  return std::all_of(controls_.begin(), controls_.end(),
                     [](const Control& c) { return sign(c.weight) == Sign::positive; });
}

bool ConicArc::has_proper_ends() const {
  return sign(controls_[0].weight) == Sign::positive && sign(controls_[2].weight) == Sign::positive;
}

std::array<ConicArc, 2> ConicArc::halves() const {
  const auto& [a, b, c] = controls_;
  const Control left = middle(a, b), right = middle(b, c), top = middle(left, right);
  std::array<ConicArc, 2> both{ConicArc({a, left, top}), ConicArc({top, right, c})};
  for (ConicArc& half : both) half.straight_ = straight_;
  return both;
}

// 1 - s and 1 - t are exact.
ConicArc::Control ConicArc::blossom(double s, double t) const {
  if (s == t && (t == 0 || t == 1)) return controls_[t == 0 ? 0 : 2];
  const DoubleBall u(1 - s), v(1 - t);
  const DoubleBall first = u * v, second = DoubleBall(s) * v + u * DoubleBall(t),
                   third = DoubleBall(s) * DoubleBall(t);
  const auto& [a, b, c] = controls_;
  return {first * a.x + second * b.x + third * c.x, first * a.y + second * b.y + third * c.y,
          first * a.weight + second * b.weight + third * c.weight};
}

ConicArc ConicArc::part(double from, double to) const {
  if (from == 0 && to == 1) return *this;
  ConicArc arc({blossom(from, from), blossom(from, to), blossom(to, to)});
  arc.straight_ = straight_;
  return arc;
}

ConicArc ConicArc::reversed() const {
  ConicArc arc = *this;
  std::swap(arc.controls_[0], arc.controls_[2]);
  return arc;
}

DoubleBall ConicArc::roundness() const {
  const DoubleBall &a = controls_[0].weight, &b = controls_[1].weight, &c = controls_[2].weight;
  return DoubleBall(1) - (b / a) * (b / c);
}

}  // namespace voroproof::internal
