// Times as a line has them: rounded both ways.
#pragma once

#include <string>

#include "exact/algebraic.h"

namespace voroproof::truth {

using Time = internal::AlgebraicNumber<internal::Rational>;

// Equal where the time is a binary64, else neighbours around it.
struct Rounded {
  double lo = 0, hi = 0;
};
Rounded rounded(const Time& t);
// `LO HI`.
std::string text(const Rounded& t);

}  // namespace voroproof::truth
