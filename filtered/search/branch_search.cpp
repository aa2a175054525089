#include "filtered/search/branch_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "filtered/search/symmetry.h"

namespace voroproof::internal {

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
  // Whether f has no root but those of this function: the conjugate, whose circle is the other one
  // that touches the same three, vanishes nowhere in `during`.
  template <class T>
  bool conjugate_is_certain(const T& during) const {
    return is_certain(sign(conjugate(sites(motion_, q_, during))));
  }
  // Whether the zero of this function in [a, b] is the one of the conjugate, too.
  bool shares_its_zero(double a, double b) const {
    const auto symmetry = motion_.symmetry();
    return symmetry != nullptr &&
           is_certain(sign(conjugate(moving_sites(motion_, q_, DoubleBall::hull(a, b))).slope)) &&
           symmetry->mirrored_between(states_of(motion_, q_), a, b);
  }
  // The zero of a function that has one in [a, b], by two steps of the interval Newton method: the
  // error of the first is that of the slope. The radius is infinite where that cannot say.
  DdBall newton(double a, double b) const {
    const DoubleBall over_all = over(a, b).slope;
    const DdBall slope(over_all.mid, 0, over_all.rad);
    const auto step = [&](const DdBall& c) { return c - value(c) / slope; };
    const DdBall near = step(DdBall(0.5 * (a + b)));
    // The slope is not known at a time beyond the ends.
    const bool inside = a < near.hi && near.hi < b;
    return inside && std::isfinite(near.rad) ? step(DdBall(near.hi, near.lo)) : near;
  }

 private:
  template <class T>
  T conjugate(const std::array<Site<T>, 4>& at) const {
    TangentTriple<T> triple = EdgeTriples<T>::of(q_, at).start;
    triple.with_container = !triple.with_container;
    return incircle_value(triple, at[3], q_.e == container_id);
  }

  const Motion& motion_;
  const Quad& q_;
};

struct Interval {
  double lo, hi;
};

// The zero of a branch that falls from certainly positive at a to certainly negative at b, between
// times of the same kind that are near. `slope`: over [a, b].
Interval narrow(const Branch& branch, double a, double b, DoubleBall slope) {
  double lo = a, hi = b;
  for (int step = 0; step < 60; ++step) {
    const double m = 0.5 * (lo + hi);
    const DoubleBall root = DoubleBall(m) - branch.value(DoubleBall(m)) / slope;
    const double left = std::max(lo, std::nextafter(root.mid - root.rad, a));
    const double right = std::min(hi, std::nextafter(root.mid + root.rad, b));
    const double gain = (right - left) / (hi - lo);
    if (!(gain < 0.5)) break;
    lo = left;
    hi = right;
    // Slopes are expensive: one is kept as long as it serves well.
    if (gain > 0x1p-6) slope = branch.over(lo, hi).slope;
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

// A zero of the branch at which the edge collapses, in an interval in which f has no other root:
// the one given, or if the conjugate may have another zero there a closer one. nullopt: not even
// that.
std::optional<Collapse> isolate(const Branch& branch, const Interval& zero) {
  if (branch.conjugate_is_certain(DoubleBall::hull(zero.lo, zero.hi)) ||
      branch.shares_its_zero(zero.lo, zero.hi)) {
    return Collapse{Collapse::Kind::root, zero.lo, zero.hi, nullptr};
  }
  DdBall near = branch.newton(zero.lo, zero.hi);
  near.rad *= 0x1p10;  // signs at the ends, and inside them the zero
  if (!(near.rad < 0.25 * (zero.hi - zero.lo)) || !branch.conjugate_is_certain(near)) {
    return std::nullopt;
  }
  const Rational mid = to_rational(near.hi) + to_rational(near.lo), rad = to_rational(near.rad);
  return Collapse::at_root(mid - rad, mid + rad);
}

enum class Finding { free, collapse, unknown };

// Judges [a, b] by the start of q's edge; a collapse goes into `found`.
Finding look(const Motion& motion, const Quad& q, double a, double b,
             const std::array<Site<DoubleBall>, 4>& at, Collapse& found) {
  const TangentTriple<DoubleBall> triple = EdgeTriples<DoubleBall>::of(q, at).start;
  // Beyond a contact of the three, which comes first, no circle touches them.
  if (sign(gamma(triple)) != Sign::positive) return Finding::unknown;
  if (circle_exists(triple) == Sign::negative) return Finding::free;
  const Branch branch(motion, q);
  const Dual<DoubleBall> over = branch.over(a, b);
  const double m = 0.5 * (a + b);
  const DoubleBall by_slope =
      branch.value(DoubleBall(m)) + over.slope * DoubleBall::hull(a - m, b - m);
  if (is_certain(sign(over.value)) || is_certain(sign(by_slope))) return Finding::free;
  // At a collapse the function falls.
  const Sign slope = sign(over.slope);
  if (slope == Sign::positive) return Finding::free;
  if (slope != Sign::negative) return Finding::unknown;
  const Sign before = sign(branch.value(DoubleBall(a)));
  const Sign after = sign(branch.value(DoubleBall(b)));
  if (before == Sign::negative || after == Sign::positive) return Finding::free;
  if (before != Sign::positive || after != Sign::negative) return Finding::unknown;
  const Interval root = narrow(branch, a, b, over.slope);
  const auto at_root = sites(motion, q, DoubleBall::hull(root.lo, root.hi));
  if (circle_exists(EdgeTriples<DoubleBall>::of(q, at_root).start) != Sign::positive) {
    return Finding::unknown;
  }
  const Sign order = contact_order(q, at_root);
  if (order == Sign::negative) return Finding::free;
  if (order != Sign::positive) return Finding::unknown;
  const std::optional<Collapse> collapse = isolate(branch, root);
  if (!collapse) return Finding::unknown;
  found = *collapse;
  return Finding::collapse;
}

Finding look(const Motion& motion, const Quad& q, double a, double b, Collapse& found) {
  const std::array<Site<DoubleBall>, 4> at = sites(motion, q, DoubleBall::hull(a, b));
  if (!keeps_tangencies(at)) return Finding::unknown;
  const Finding start = look(motion, q, a, b, at, found);
  if (start != Finding::unknown) return start;
  return look(motion, reversed(q), a, b, {at[1], at[0], at[3], at[2]}, found);
}

}  // namespace

Collapse search_branches(const Motion& motion, const Quad& q, double start, double end) {
  constexpr int kMaxLooks = 200;
  std::vector<Interval> pieces{{start, end}};
  for (int looks = 0; !pieces.empty(); ++looks) {
    const Interval piece = pieces.back();
    Collapse found;
    const Finding finding = look(motion, q, piece.lo, piece.hi, found);
    if (finding == Finding::collapse) return found;
    if (finding == Finding::free) {
      pieces.pop_back();
      continue;
    }
    const double middle = 0.5 * (piece.lo + piece.hi);
    if (looks >= kMaxLooks || piece.hi - piece.lo < 0x1p-30 * (end - start) ||
        !(piece.lo < middle && middle < piece.hi)) {
      return Collapse::none_until(piece.lo);
    }
    pieces.back() = {middle, piece.hi};
    pieces.push_back({piece.lo, middle});
  }
  return Collapse::none_until(end);
}

std::optional<Collapse> isolate_on_branch(const Motion& motion, const Quad& q, double lo,
                                          double hi) {
  const Branch branch(motion, q);
  const DoubleBall slope = branch.over(lo, hi).slope;
  if (sign(slope) != Sign::negative) return std::nullopt;
  return isolate(branch, narrow(branch, lo, hi, slope));
}

DdBall refine_branch(const Motion& motion, const Quad& q, double lo, double hi) {
  for (const Quad& edge : {q, reversed(q)}) {
    const DdBall root = Branch(motion, edge).newton(lo, hi);
    double left = 0, right = 0;
    enclose(root, left, right);
    // Inside [lo, hi] the step proves that there is a zero. (Of an edge that the flips of others
    // have ended one of its functions may have none where f has its root.)
    if (lo <= left && right <= hi) return root;
  }
  return DdBall(lo, 0, std::numeric_limits<double>::infinity());
}

}  // namespace voroproof::internal
