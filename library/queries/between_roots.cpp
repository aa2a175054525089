#include "library/queries/between_roots.h"

#include "exact/roots.h"

namespace voroproof::internal {

void between_roots(const Rational& from, const Rational& to,
                   const std::vector<Polynomial<Rational>>& candidates,
                   const std::function<void(const AlgebraicTime&, const Rational&)>& part) {
  Polynomial<Rational> product{1};
  for (const Polynomial<Rational>& f : candidates) {
    if (!f.is_zero() && !is_plainly_rootless(f, from, to)) product = product * f;
  }
  std::vector<AlgebraicTime> roots = real_roots(product, from, to);
  const Rational width = (1 + to) / Rational(Integer(1) << 60);
  for (AlgebraicTime& root : roots) root.refine(width);
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
