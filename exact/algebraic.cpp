#include "exact/algebraic.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace voroproof::internal {
namespace {

// Bisections before equality is asked for: numbers that differ mostly part sooner,
// and a greatest common divisor over a tower is expensive.
constexpr unsigned long bisections_before_gcd = 256;

}  // namespace

// ---- Construction ------------------------------------------------------------------

template <class T>
AlgebraicNumber<T>::AlgebraicNumber(std::shared_ptr<const Equation> equation,
                                    const RootInterval& root)
    : interval_(root), equation_(std::move(equation)) {
  at_lo_ = equation_->sign_at(root.lo);
}

// A root of even multiplicity becomes a simple one of the square-free part.
template <class T>
AlgebraicNumber<T> AlgebraicNumber<T>::make(const std::shared_ptr<const Equation>& equation,
                                            const RootInterval& root) {
  if (root.is_point()) return root.lo;
  if (equation->sign_at(root.lo) != equation->sign_at(root.hi)) return {equation, root};
  return {std::make_shared<const Equation>(square_free_part(equation->polynomial)), root};
}

template <class T>
AlgebraicNumber<T>::AlgebraicNumber(const Polynomial<T>& f, const RootInterval& root)
    : AlgebraicNumber(make(std::make_shared<const Equation>(f), root)) {}

template <class T>
Polynomial<T> AlgebraicNumber<T>::polynomial() const {
  if (equation_) return equation_->polynomial;
  return {T(-interval_.lo), T(1)};
}

template <class T>
std::vector<AlgebraicNumber<T>> real_roots(const Polynomial<T>& f, const Rational& lo,
                                           const Rational& hi) {
  using Number = AlgebraicNumber<T>;
  const std::vector<RootInterval> intervals = isolate_roots(f, lo, hi);
  if (intervals.empty()) return {};
  const auto equation = std::make_shared<const typename Number::Equation>(f);
  std::vector<Number> roots;
  for (const RootInterval& interval : intervals) roots.push_back(Number::make(equation, interval));
  return roots;
}

// ---- Refinement and order ------------------------------------------------------------

template <class T>
void AlgebraicNumber<T>::halve() {
  voroproof::internal::halve(equation_->sign_at, at_lo_, interval_);
}

template <class T>
void AlgebraicNumber<T>::refine(const Rational& width) {
  if (is_point()) return;
  voroproof::internal::refine(equation_->sign_at, at_lo_, interval_, width);
}

template <class T>
std::strong_ordering compare(const AlgebraicNumber<T>& x, const Rational& q) {
  const RootInterval& interval = x.interval_;
  if (interval.is_point()) return cmp(interval.lo, q) <=> 0;
  if (q <= interval.lo) return std::strong_ordering::greater;
  if (q >= interval.hi) return std::strong_ordering::less;
  const Sign at_q = x.equation_->sign_at(q);
  if (at_q == Sign::zero) return std::strong_ordering::equal;
  return at_q == x.at_lo_ ? std::strong_ordering::greater : std::strong_ordering::less;
}

// The intervals overlap, and neither of them is a point. A common root of both polynomials in both
// intervals is x and is y. The ends of the common interval are ends of an isolating interval, so no
// roots of the divisor; it has at most one root in between, whose multiplicity is the smaller one
// of two odd numbers. So it has one iff its sign changes.
template <class T>
bool AlgebraicNumber<T>::equal(const AlgebraicNumber& x, const AlgebraicNumber& y) {
  const SignEvaluator<T> common(y.is_root_of(x.equation_->polynomial)
                                    ? x.equation_->polynomial
                                    : gcd(x.equation_->polynomial, y.equation_->polynomial));
  const Rational lo = std::max(x.interval_.lo, y.interval_.lo);
  const Rational hi = std::min(x.interval_.hi, y.interval_.hi);
  return common(lo) != common(hi);
}

template <class T>
std::strong_ordering compare(const AlgebraicNumber<T>& x, const AlgebraicNumber<T>& y) {
  AlgebraicNumber<T> a = x;
  AlgebraicNumber<T> b = y;
  const bool conjugate =
      a.equation_ && (a.equation_ == b.equation_ || b.is_root_of(a.equation_->polynomial));
  for (unsigned long bisections = 0;; ++bisections) {
    if (b.is_point()) return compare(a, b.interval_.lo);
    if (a.is_point()) return 0 <=> compare(b, a.interval_.lo);
    if (a.interval_.hi <= b.interval_.lo) return std::strong_ordering::less;
    if (b.interval_.hi <= a.interval_.lo) return std::strong_ordering::greater;
    const bool ask = bisections == (conjugate ? 0 : bisections_before_gcd);
    if (ask && AlgebraicNumber<T>::equal(a, b)) return std::strong_ordering::equal;
    const Rational width_a = a.interval_.hi - a.interval_.lo;
    const Rational width_b = b.interval_.hi - b.interval_.lo;
    (width_a < width_b ? b : a).halve();
  }
}

// ---- Rounding ------------------------------------------------------------------------

template <class T>
double round_nearest(const AlgebraicNumber<T>& x) {
  AlgebraicNumber<T> a = x;
  for (;;) {
    const double below = round_nearest(a.interval_.lo);
    const double above = round_nearest(a.interval_.hi);
    if (below == above) return below;
    if (std::nextafter(below, std::numeric_limits<double>::infinity()) == above) {
      // One breakpoint at most is left, and the exact comparison with it decides.
      const Rational breakpoint = rounding_breakpoint(below, above);
      const std::strong_ordering side = compare(a, breakpoint);
      if (side == 0) return round_nearest(breakpoint);
      return side < 0 ? below : above;
    }
    a.halve();
  }
}

// ---- Signs of other polynomials --------------------------------------------------------

template <class T>
Sign sign_at(const Polynomial<T>& g, const AlgebraicNumber<T>& x) {
  constexpr unsigned long halvings_at_once = 8;
  if (x.is_point()) return sign_at(g, x.interval().lo);
  if (g.is_zero() || x.is_root_of(g)) return Sign::zero;
  AlgebraicNumber<T> a = x;
  for (unsigned long halvings = 0;; halvings += halvings_at_once) {
    const RootInterval& interval = a.interval();
    if (a.is_point()) return sign_at(g, interval.lo);
    if (is_plainly_rootless(g, interval.lo, interval.hi)) return sign_at(g, interval.lo);
    if (halvings == bisections_before_gcd) {
      const Polynomial<T> common = gcd(g, a.polynomial());
      if (!isolate_roots(common, interval.lo, interval.hi).empty()) return Sign::zero;
    }
    a.refine((interval.hi - interval.lo) >> halvings_at_once);
  }
}

template <class T>
SignsAround signs_around(const Polynomial<T>& g, const AlgebraicNumber<T>& x) {
  if (g.is_zero()) throw std::invalid_argument("signs_around: the zero polynomial");
  if (!x.is_point() && x.is_root_of(g)) {
    return {sign_at(g, x.interval().lo), sign_at(g, x.interval().hi)};
  }
  const Sign at_x = sign_at(g, x);
  if (at_x != Sign::zero) return {at_x, at_x};
  AlgebraicNumber<T> a = x;
  for (unsigned long bits = 8;; bits *= 2) {  // until x is the only root of g there
    const RootInterval& interval = a.interval();
    const std::vector<RootInterval> roots = isolate_roots(g, interval.lo, interval.hi);
    if (roots.size() == 1) return signs_around(g, roots.front());
    a.refine((interval.hi - interval.lo) >> bits);
  }
}

// ---- Numbers beside others -------------------------------------------------------------

template <class T>
Rational rational_between(AlgebraicNumber<T> x, AlgebraicNumber<T> y) {
  if (compare(x, y) > 0) std::swap(x, y);
  const auto width = [](const AlgebraicNumber<T>& z) {
    return Rational(z.interval().hi - z.interval().lo);
  };
  while (x.interval().hi >= y.interval().lo) {
    AlgebraicNumber<T>& wider = width(x) < width(y) ? y : x;
    wider.refine(width(wider) / 2);
  }
  return (x.interval().hi + y.interval().lo) / 2;
}

template <class T>
RootInterval clear_of(const Polynomial<T>& g, const AlgebraicNumber<T>& x, RootInterval within) {
  if (g.is_zero()) return within;
  for (const AlgebraicNumber<T>& root : real_roots(g, within.lo, within.hi)) {
    const auto order = compare(root, x);
    if (order < 0) within.lo = rational_between(root, x);
    if (order > 0) {
      within.hi = rational_between(x, root);
      break;
    }
  }
  return within;
}

#define VOROPROOF_INSTANTIATE(T)                                                               \
  template class AlgebraicNumber<T>;                                                           \
  template std::vector<AlgebraicNumber<T>> real_roots(const Polynomial<T>&, const Rational&,   \
                                                      const Rational&);                        \
  template std::strong_ordering compare(const AlgebraicNumber<T>&, const AlgebraicNumber<T>&); \
  template std::strong_ordering compare(const AlgebraicNumber<T>&, const Rational&);           \
  template double round_nearest(const AlgebraicNumber<T>&);                                    \
  template Sign sign_at(const Polynomial<T>&, const AlgebraicNumber<T>&);                      \
  template SignsAround signs_around(const Polynomial<T>&, const AlgebraicNumber<T>&);          \
  template Rational rational_between(AlgebraicNumber<T>, AlgebraicNumber<T>);                  \
  template RootInterval clear_of(const Polynomial<T>&, const AlgebraicNumber<T>&, RootInterval);
VOROPROOF_INSTANTIATE(Rational)
VOROPROOF_INSTANTIATE(Tower)
#undef VOROPROOF_INSTANTIATE

}  // namespace voroproof::internal
