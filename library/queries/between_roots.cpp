#include "library/queries/between_roots.h"

#include <algorithm>

#include "exact/roots.h"

namespace voroproof::internal {
namespace {

// The root, which is one of the product of the candidates, as that of one of them, if it changes
// its sign there. Equal roots of different products are soon known as equal by that.
AlgebraicTime of_one(const std::vector<Polynomial<Rational>>& candidates, AlgebraicTime root) {
  if (root.is_point()) return root;
  const auto& [lo, hi] = root.interval();
  for (const Polynomial<Rational>& f : candidates) {
    if (sign_at(f, lo) != sign_at(f, hi)) return AlgebraicTime(f, root.interval());
  }
  return root;
}

}  // namespace

bool same_time(const AlgebraicTime& a, const AlgebraicTime& b) {
  if (a.is_point() || b.is_point()) return compare(a, b) == 0;
  const Rational lo = std::max(a.interval().lo, b.interval().lo),
                 hi = std::min(a.interval().hi, b.interval().hi);
  if (lo >= hi) return false;
  // Each has one root in its interval, and none at the ends: a common one is where the divisor
  // changes its sign.
  const Polynomial<Rational> f = a.polynomial(), g = b.polynomial();
  const Polynomial<Rational> common = f == g ? f : gcd(f, g);
  return sign_at(common, lo) != sign_at(common, hi);
}

void between_roots(const Rational& from, const Rational& to,
                   const std::vector<Polynomial<Rational>>& candidates,
                   const std::function<void(const AlgebraicTime&, const Rational&)>& part) {
  Polynomial<Rational> product{1};
  for (const Polynomial<Rational>& f : candidates) {
    if (!f.is_zero() && !is_plainly_rootless(f, from, to)) product = product * f;
  }
  std::vector<AlgebraicTime> roots = real_roots(product, from, to);
  const Rational width = (1 + to) / Rational(Integer(1) << 60);
  for (AlgebraicTime& root : roots) {
    root.refine(width);
    root = of_one(candidates, root);
  }
  AlgebraicTime since(from);
  for (std::size_t k = 0; k <= roots.size(); ++k) {
    const Rational& before = since.interval().hi;
    const Rational& next = k < roots.size() ? roots[k].interval().lo : to;
    // Nothing lies between the start or the end and a root just there; between two roots there is
    // always something, if only the common end of their intervals.
    const bool inner = 0 < k && k < roots.size();
    if (inner || before < next) part(since, Rational((before + next) / 2));
    if (k < roots.size()) since = roots[k];
  }
}

}  // namespace voroproof::internal
