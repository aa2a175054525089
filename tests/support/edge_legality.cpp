#include "tests/support/edge_legality.h"

#include <algorithm>
#include <optional>

namespace voroproof::internal::testing {

using oracle::Generators;
using oracle::TangentCircle;
using oracle::Work;

namespace {

std::optional<TangentCircle> counterclockwise_circle(const Generators& at, int i, int j, int k) {
  for (const TangentCircle& circle : at.tangent_circles(i, j, k)) {
    if (at.counterclockwise(i, j, k, circle)) return circle;
  }
  return std::nullopt;
}

}  // namespace

std::optional<int> legality(const Generators& at, const Quad& q) {
  const auto side = [&at](int i, int j, int k, int tested) -> std::optional<int> {
    const auto circle = counterclockwise_circle(at, i, j, k);
    if (!circle) return std::nullopt;
    const Work gap = at.gap(tested, *circle);
    if (abs(gap) < oracle::contact_tolerance()) return 0;
    return gap > 0 ? 1 : -1;
  };
  const auto start = side(q.l, q.s, q.r, q.e), end = side(q.r, q.e, q.l, q.s);
  // An edge between two circles, of which one touches all four generators and the other does not.
  if (start && end && *start + *end == 1) return 1;
  // Or both do, and the edge leads from the one to the other.
  if (start && end && *start == 0 && *end == 0) {
    const auto a = counterclockwise_circle(at, q.l, q.s, q.r);
    const auto b = counterclockwise_circle(at, q.r, q.e, q.l);
    if (!oracle::coincide(*a, *b)) return 1;
  }
  return start == end ? start : std::nullopt;
}

std::optional<bool> is_legal(const Generators& at, const Quad& q) {
  if (q.s == q.e) return true;
  const auto sign = legality(at, q);
  if (!sign) return std::nullopt;
  return *sign == 0 ? std::max(q.l, q.r) > std::max(q.s, q.e) : *sign > 0;
}

bool has_shrunk(const Generators& just_after, const Quad& q) {
  const auto start = counterclockwise_circle(just_after, q.l, q.s, q.r);
  return start && just_after.counterclockwise(q.r, q.e, q.l, *start);
}

}  // namespace voroproof::internal::testing
