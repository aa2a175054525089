// When two of a billiard meet, in numbers of any kind.
#pragma once

#include <optional>
#include <stdexcept>

#include "exact/ball.h"
#include "filtered/billiards/billiard_gaps.h"

namespace voroproof::internal {

// Thrown where a ball is too wide to decide.
class MoreBits : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
// Thrown where a root is no fraction, or one of too many digits.
struct NoFraction {};
// Thrown where the run cannot go on.
class BilliardStop : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The square root of a positive number.
Rational exact_root(const Rational& x);  // throws NoFraction
inline Ball exact_root(const Ball& x) { return sqrt(x); }

// The first time u >= 0 at which a gap with that form of degree 2 falls below zero; none where it
// never does. `parting`: the two have just collided, so that the form is zero at 0 and does not
// fall. Throws MoreBits, NoFraction, and BilliardStop where they are in touch and pressed together.
template <class T>
std::optional<T> meeting_time(const GapForm<T>& form, bool parting);

}  // namespace voroproof::internal
