#include "corpus/truth/times.h"

#include <cmath>
#include <limits>

#include "corpus/truth/generators.h"

namespace voroproof::truth {

Rounded rounded(const Time& t) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double nearest = round_nearest(t);
  const auto order = compare(t, internal::to_rational(nearest));
  if (order == 0) return {nearest, nearest};
  return order < 0 ? Rounded{std::nextafter(nearest, -infinity), nearest}
                   : Rounded{nearest, std::nextafter(nearest, infinity)};
}

std::string text(const Rounded& t) { return text(t.lo) + ' ' + text(t.hi); }

}  // namespace voroproof::truth
