#include "filtered/branch_search.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace voroproof {

namespace {

// The in-circle function of the start of an edge, and its slope over an interval.
class Branch {
 public:
  Branch(const Motion& motion, const Quad& q) : motion_(motion), q_(q) {}

  template <class T>
  T value(const T& t) const {
    return start_incircle(q_, sites(motion_, q_, t));
  }
  // Precondition of both: no tangency of the four vanishes in [a, b].
  Dual<DoubleBall> over(double a, double b) const {
    return start_incircle(q_, moving_sites(motion_, q_, DoubleBall::hull(a, b)));
  }
  // The conjugate, whose circle is the other one that touches the same three.
  Dual<DoubleBall> conjugate_over(double a, double b) const {
    const auto at = moving_sites(motion_, q_, DoubleBall::hull(a, b));
    TangentTriple<Dual<DoubleBall>> triple = EdgeTriples<Dual<DoubleBall>>::of(q_, at).start;
    triple.with_container = !triple.with_container;
    return incircle_value(triple, at[3], q_.e == container_id);
  }

 private:
  const Motion& motion_;
  const Quad& q_;
};

struct Interval {
  double lo, hi;
};

// The zero of a branch that falls from certainly positive at a to certainly negative at b, between
// times of the same kind that are near.
Interval narrow(const Branch& branch, double a, double b) {
  double lo = a, hi = b;
  for (int step = 0; step < 60; ++step) {
    const double m = 0.5 * (lo + hi);
    const DoubleBall root = DoubleBall(m) - branch.value(DoubleBall(m)) / branch.over(lo, hi).slope;
    const double left = std::max(lo, std::nextafter(root.mid - root.rad, a));
    const double right = std::min(hi, std::nextafter(root.mid + root.rad, b));
    if (!(right - left < 0.5 * (hi - lo))) break;
    lo = left;
    hi = right;
  }
  const double m = 0.5 * (lo + hi);
  for (double reach = 2 * (hi - m) + 0x1p-48 * (b - a); reach < b - a; reach *= 8) {
    const Interval near{std::max(a, m - reach), std::min(b, m + reach)};
    if (sign(branch.value(DoubleBall(near.lo))) == Sign::positive &&
        sign(branch.value(DoubleBall(near.hi))) == Sign::negative) {
      return near;
    }
  }
  return {a, b};
}

enum class Finding { free, collapse, unknown };

// What the start of q's edge shows of [a, b]; a collapse in `root`.
Finding look(const Motion& motion, const Quad& q, double a, double b,
             const std::array<Site<DoubleBall>, 4>& at, Interval& root) {
  const TangentTriple<DoubleBall> triple = EdgeTriples<DoubleBall>::of(q, at).start;
  // Beyond a contact of the three, which comes first, no circle touches them.
  if (sign(gamma(triple)) != Sign::positive) return Finding::unknown;
  if (circle_exists(triple) == Sign::negative) return Finding::free;
  const Branch branch(motion, q);
  const Dual<DoubleBall> over = branch.over(a, b);
  const double m = 0.5 * (a + b);
  const DoubleBall by_slope =
      branch.value(DoubleBall(m)) + over.slope * DoubleBall::hull(a - m, b - m);
  if (sign(over.value) != Sign::unknown || sign(by_slope) != Sign::unknown) return Finding::free;
  // At a collapse the function falls.
  const Sign slope = sign(over.slope);
  if (slope == Sign::positive) return Finding::free;
  if (slope != Sign::negative) return Finding::unknown;
  const Sign before = sign(branch.value(DoubleBall(a)));
  const Sign after = sign(branch.value(DoubleBall(b)));
  if (before == Sign::negative || after == Sign::positive) return Finding::free;
  if (before != Sign::positive || after != Sign::negative) return Finding::unknown;
  root = narrow(branch, a, b);
  const auto at_root = sites(motion, q, DoubleBall::hull(root.lo, root.hi));
  if (circle_exists(EdgeTriples<DoubleBall>::of(q, at_root).start) != Sign::positive) {
    return Finding::unknown;
  }
  const Sign order = contact_order(q, at_root);
  if (order == Sign::negative) return Finding::free;
  if (order != Sign::positive) return Finding::unknown;
  // The other function may touch zero here too, but once.
  const Dual<DoubleBall> conjugate = branch.conjugate_over(root.lo, root.hi);
  const bool few = sign(conjugate.value) != Sign::unknown || sign(conjugate.slope) != Sign::unknown;
  return few ? Finding::collapse : Finding::unknown;
}

Finding look(const Motion& motion, const Quad& q, double a, double b, Interval& root) {
  const std::array<Site<DoubleBall>, 4> at = sites(motion, q, DoubleBall::hull(a, b));
  if (!keeps_tangencies(at)) return Finding::unknown;
  const Finding start = look(motion, q, a, b, at, root);
  if (start != Finding::unknown) return start;
  return look(motion, reversed(q), a, b, {at[1], at[0], at[3], at[2]}, root);
}

}  // namespace

Collapse search_branches(const Motion& motion, const Quad& q, double start, double end) {
  constexpr int kMaxLooks = 200;
  std::vector<Interval> pieces{{start, end}};
  for (int looks = 0; !pieces.empty(); ++looks) {
    const Interval piece = pieces.back();
    Interval root;
    const Finding finding = look(motion, q, piece.lo, piece.hi, root);
    if (finding == Finding::collapse) return {Collapse::Kind::root, root.lo, root.hi, nullptr};
    if (finding == Finding::free) {
      pieces.pop_back();
      continue;
    }
    const double middle = 0.5 * (piece.lo + piece.hi);
    if (looks == kMaxLooks || piece.hi - piece.lo < 0x1p-30 * (end - start) ||
        !(piece.lo < middle && middle < piece.hi)) {
      return Collapse::none_until(piece.lo);
    }
    pieces.back() = {middle, piece.hi};
    pieces.push_back({piece.lo, middle});
  }
  return Collapse::none_until(end);
}

DdBall refine_branch(const Motion& motion, const Quad& q, double lo, double hi) {
  const double c = 0.5 * (lo + hi);
  const auto newton = [&](const Quad& edge) {
    const Branch branch(motion, edge);
    const DoubleBall slope = branch.over(lo, hi).slope;
    return DdBall(c) - branch.value(DdBall(c)) / DdBall(slope.mid, 0, slope.rad);
  };
  const DdBall root = newton(q);
  return std::isfinite(root.rad) ? root : newton(reversed(q));
}

}  // namespace voroproof
