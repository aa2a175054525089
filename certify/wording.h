// How times, and by exact/names.h generators, appear in the sentences of a certificate.
#pragma once

#include <cmath>
#include <string>

#include "exact/names.h"
#include "exact/rational.h"
#include "history/json_text.h"

namespace voroproof::internal {

// A number for a person, rounded.
inline std::string rounded_text(const Rational& q) {
  const double x = round_nearest(q);
  return std::isfinite(x) ? number_text(x) : "more than 1e308";
}

inline std::string between(double lo, double hi) {
  return "at a time in [" + number_text(lo) + ", " + number_text(hi) + "]";
}

}  // namespace voroproof::internal
