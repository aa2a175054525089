#include "certify/billiards/ball_roots.h"

#include <algorithm>

#include "certify/billiards/true_path.h"

namespace voroproof::internal {
namespace {

using BallForm = std::vector<Ball>;

Ball whole_ball(std::size_t n) { return {static_cast<double>(n), 64}; }

Ball value_at(const BallForm& f, const Ball& x) {
  Ball value = f.back();
  for (std::size_t k = f.size() - 1; k-- > 0;) value = value * x + f[k];
  return value;
}

BallForm derivative(const BallForm& f) {
  BallForm slope;
  for (std::size_t k = 1; k < f.size(); ++k) slope.push_back(f[k] * whole_ball(k));
  return slope;
}

// The number of which all points of [lo, hi] are.
Ball hull(const Rational& lo, const Rational& hi, Ball::Precision bits) {
  Ball ball(Rational((lo + hi) / 2), bits);
  ball.widen(Magnitude::of(round_up(Rational(hi - lo))));
  return ball;
}

// Whether all coefficients in the Bernstein basis of [lo, hi] have that sign: then so has f there.
bool has_sign(Sign sign_of_all, const BallForm& f, const Rational& lo, const Rational& hi) {
  BallForm c = f;
  const std::size_t n = c.size() - 1;
  const Ball start(lo, f[0].precision()), width(Rational(hi - lo), f[0].precision());
  if (lo != 0) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = n; k-- > i;) c[k] = c[k] + start * c[k + 1];
    }
  }
  Ball power = width;
  for (std::size_t k = 1; k <= n; ++k) {
    c[k] = c[k] * power;
    power = power * width;
  }
  const auto choose = [](std::size_t m, std::size_t k) {
    std::size_t count = 1;
    for (std::size_t i = 0; i < k; ++i) count = count * (m - i) / (i + 1);
    return whole_ball(count);
  };
  for (std::size_t j = 0; j <= n; ++j) {
    Ball b = c[0];
    for (std::size_t k = 1; k <= j; ++k) b = b + choose(j, k) / choose(n, k) * c[k];
    if (sign(b) != sign_of_all) return false;
  }
  return true;
}

// The root between lo and hi, where f falls throughout.
Ball refined(const BallForm& f, const BallForm& slope, Rational lo, Rational hi) {
  const Ball::Precision bits = f[0].precision();
  for (;;) {
    const Rational width = hi - lo;
    const Rational middle = Ball(Rational((lo + hi) / 2), bits).midpoint();
    const Ball value = value_at(f, Ball(middle, bits));
    const Ball step = value / value_at(slope, hull(lo, hi, bits));
    if (step.is_finite()) {
      const Ball root = Ball(middle, bits) - step;
      const auto [first, last] = root.rational_interval();
      lo = std::max(lo, first);
      hi = std::min(hi, last);
      if (hi < lo) throw TooCoarse("when two touch is not told");
      if (Rational(2 * (hi - lo)) > width) return hull(lo, hi, bits);
      continue;
    }
    const Sign there = sign(value);
    if (!is_certain(there)) throw TooCoarse("when two touch is not told");
    (there == Sign::positive ? lo : hi) = middle;
  }
}

std::optional<Ball> fall_in(const BallForm& f, const BallForm& slope, const Rational& lo,
                            const Rational& hi, int halvings) {
  if (has_sign(Sign::positive, f, lo, hi)) return std::nullopt;
  if (has_sign(Sign::negative, slope, lo, hi)) {
    const Sign end = sign(value_at(f, Ball(hi, f[0].precision())));
    if (end == Sign::positive) return std::nullopt;
    if (end != Sign::negative) throw TooCoarse("whether two touch, or when, is not told");
    return refined(f, slope, lo, hi);
  }
  if (halvings == 0) throw TooCoarse("whether two touch is not told");
  // Nearly the middle: a root that is half of something would be on the edge of all parts.
  const Rational cut = lo + (hi - lo) * Rational(29, 64);
  if (auto root = fall_in(f, slope, lo, cut, halvings - 1)) return root;
  return fall_in(f, slope, cut, hi, halvings - 1);
}

}  // namespace

std::optional<Ball> first_fall(const std::vector<Ball>& f, const Rational& length) {
  constexpr int most_halvings = 256;
  if (length < 0) return std::nullopt;
  return fall_in(f, derivative(f), 0, length, most_halvings);
}

}  // namespace voroproof::internal
