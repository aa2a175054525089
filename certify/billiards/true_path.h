// The true path of a disk of a billiard. Fractions say where it runs as long as all times are
// fractions, and not too long; balls say it always.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "filtered/billiards/billiard_gaps.h"
#include "filtered/billiards/number_kinds.h"

namespace voroproof::internal {

// Thrown where balls are too wide to decide: more bits may.
class TooCoarse : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct TrueTime {
  std::optional<Rational> exact;  // where it is known to be a fraction
  Ball ball;
  DoubleBall near;

  TrueTime(const Rational& q, int bits) : exact(q), ball(q, bits), near(enclosed(q)) {}
  explicit TrueTime(Ball b) : ball(std::move(b)), near(enclosed(ball)) {}
};

// The sign of x - y; unknown where balls do not tell, and no fractions do.
inline Sign order(const TrueTime& x, const TrueTime& y) {
  const Sign rough = sign(x.near - y.near);
  if (is_certain(rough)) return rough;
  if (x.exact && y.exact) return sign(Rational(*x.exact - *y.exact));
  const Sign fine = sign(x.ball - y.ball);
  return is_certain(fine) ? fine : Sign::unknown;
}

// A piece of a path, from a turn to the next one.
struct TrueLine {
  TrueTime from;
  std::optional<Flight<Rational>> exact;
  Flight<Ball> ball;
  Flight<DoubleBall> near;
  std::int64_t claim = -1, line = 1;  // by which the disk turned, from 0; -1 at the start
  std::optional<BilliardPair> by{};   // the collision that it was
};

// The lines of one disk in a window of time: the one that it is on at the beginning comes first.
using TruePath = std::vector<TrueLine>;

}  // namespace voroproof::internal
