#include "engine/world/rough_edge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/world/edge_ends.h"
#include "filtered/numbers/subdivision.h"

namespace voroproof::internal {
namespace {

using Generators = std::array<GenId, 4>;

// Four disks of one radius, which grow alike, or three and infinity: then f = -C^2, and C is the
// polynomial.
bool has_square(const MovingRows& rows, const Quad& q) {
  const TimePolynomial* radius = nullptr;
  for (const GenId g : Generators{q.l, q.r, q.s, q.e}) {
    if (g == container_id) {
      if (rows.has_circle()) return false;
      continue;
    }
    const TimePolynomial& r = rows.site(g).r;
    if (radius != nullptr && !(r == *radius)) return false;
    radius = &r;
  }
  return true;
}

// Four times f over a window, the cotangency.
template <class T>
Form<T, 8> cotangency_over(const RoughRows& rows, const Quad& q, double a, double b) {
  const Generators all{q.l, q.s, q.r, q.e};
  std::array<SiteForm<T>, 4> at;
  for (int i = 0; i < 4; ++i) at[i] = rows.over<T>(all[i], a, b);
  const auto p = [&](int i, int j) { return rows.tangency_over(all[i], at[i], all[j], at[j]); };
  return cotangency_of(p(0, 1) * p(2, 3), p(0, 2) * p(1, 3), p(0, 3) * p(1, 2));
}

// C over a window. Precondition: q.l is a disk.
template <class T>
Form<T, 4> cocircularity_over(const RoughRows& rows, const Quad& q, double a, double b) {
  const SiteForm<T> base = rows.over<T>(q.l, a, b);
  struct RowForm {
    Form<T, 1> x, y;
    Form<T, 2> p;
  };
  const auto row = [&](GenId g) -> RowForm {
    const SiteForm<T> at = rows.over<T>(g, a, b);
    const Form<T, 2> p = rows.tangency_over(q.l, base, g, at);
    if (g == container_id) return {{}, {}, p};
    return {at.x - base.x, at.y - base.y, p};
  };
  const RowForm s = row(q.s), r = row(q.r), e = row(q.e);
  return cocircularity_term(e.p, s.x, s.y, r.x, r.y) + cocircularity_term(r.p, e.x, e.y, s.x, s.y) +
         cocircularity_term(s.p, r.x, r.y, e.x, e.y);
}

// The coefficients with one bound, which pays for their later use: for subdivisions and evaluations
// as in filtered/search/bernstein.cpp.
template <int degree>
BernsteinForm bounded(const Form<DoubleBall, degree>& f) {
  constexpr std::array<int, degree + 1> scale = binomials<degree>();
  BernsteinForm out{};
  out.degree = degree;
  double error = 0, size = 0;
  for (int k = 0; k <= degree; ++k) {
    const DoubleBall c = f.c[k] / DoubleBall(scale[k]);
    out.c[k] = c.mid;
    error = std::max(error, c.rad);
    size = std::max(size, std::fabs(c.mid));
    if (!(c.rad < std::numeric_limits<double>::infinity())) error = c.rad;
  }
  out.err = (error + 30.0 * degree * unit_roundoff * size) * (1 + 0x1p-40) + 1e-290;
  return out;
}

Quad from_disk(const Quad& q) { return q.l == container_id ? reversed(q) : q; }

EdgeEnds<DoubleBall> ends_at(const RoughRows& rows, const Quad& q, const DoubleBall& t) {
  const Site<DoubleBall> l = rows.site(q.l, t);
  const auto row = [&](GenId g) { return rows.row_of(l, g, t); };
  return {l, row(q.s), row(q.r), row(q.e)};
}

DoubleBall value(const RootExpression<DoubleBall>& x) { return x.u + sqrt(x.gamma) * x.v; }

enum class Judgement { stays, collapses, unknown };

// As MovingEdge::collapses_at() does, where all signs are certain.
Judgement judge(const RoughRows& rows, const Quad& q, const DoubleRoot& root, bool is_square) {
  const DoubleBall t = DoubleBall::hull(root.lo, root.hi);
  const EdgeEnds<DoubleBall> ends = ends_at(rows, q, t);
  const auto conflict = [&](const RootExpression<DoubleBall>& x) {
    if (is_square) return root.after;
    return sign(root.after == Sign::positive ? x.u : x.v);
  };
  const Sign start = conflict(ends.conflict_at_start()), end = conflict(ends.conflict_at_end());
  if (start == Sign::positive || end == Sign::positive) return Judgement::stays;
  if (start != Sign::negative || end != Sign::negative) return Judgement::unknown;
  const Generators all{q.l, q.r, q.s, q.e};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      if (!is_certain(sign(rows.tangency_of(all[i], all[j], t)))) return Judgement::unknown;
    }
  }
  const Sign same = sign(value(ends.same_circle()));
  if (!is_certain(same)) return Judgement::unknown;
  return same == Sign::positive ? Judgement::collapses : Judgement::stays;
}

// The search in one window after the other, as long as they are of use.
class Search {
 public:
  Search(const MovingRows& rows, const Quad& q)
      : rows_(rows.rough()), q_(from_disk(q)), is_square_(has_square(rows, q)) {}

  RoughCollapse after(double lo, double hi, double end) const {
    constexpr int kMostWindows = 64, kMostFailures = 6;
    double from = lo, length = rows_.time_scale(q_, lo);
    if (!(length > 0)) length = end - lo;
    int failures = 0;
    for (int windows = 0; windows < kMostWindows && failures < kMostFailures; ++windows) {
      if (from >= end) return {RoughCollapse::Kind::none};
      const double to = length < end - from ? from + length : end;
      if (!(from < to)) break;
      RoughCollapse found;
      const double reached = in_window(from, to, hi, found);
      if (found.kind != RoughCollapse::Kind::none) return found;
      if (reached < to) {
        length *= 0.25;
        if (reached == from) ++failures;
      } else {
        length *= 4;
        failures = 0;
      }
      from = reached;
    }
    return {};
  }

 private:
  // The time up to which there is no collapse; or one is found.
  double in_window(double from, double to, double hi, RoughCollapse& found) const {
    const BernsteinForm form = is_square_
                                   ? bounded(cocircularity_over<DoubleBall>(rows_, q_, from, to))
                                   : bounded(cotangency_over<DoubleBall>(rows_, q_, from, to));
    found.kind = RoughCollapse::Kind::none;
    if (!(std::fabs(form.c[0]) > form.err)) return from;
    return each_root(form, from, to, [&](const DoubleRoot& root) {
      // One that may be at the instant itself.
      const Judgement what = root.lo > hi ? judge(rows_, q_, root, is_square_) : Judgement::unknown;
      if (what == Judgement::stays) return true;
      found.kind =
          what == Judgement::collapses ? RoughCollapse::Kind::found : RoughCollapse::Kind::unknown;
      found.root = root;
      return false;
    });
  }

  const RoughRows& rows_;
  Quad q_;
  bool is_square_;
};

// One step of the interval Newton method: the mean slope between the middle and any time of the
// window is between the least and the greatest difference of neighbouring coefficients.
DdBall newton(const Coefficients<DdBall>& c, double lo, double hi) {
  const DdBall half(0.5);
  Coefficients<DdBall> left, right;
  halve_in(c, half, left, right);
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (std::size_t k = 0; k + 1 < c.size(); ++k) {
    double below = 0, above = 0;
    enclose(c[k + 1] - c[k], below, above);
    least = std::min(least, below);
    greatest = std::max(greatest, above);
  }
  const DoubleBall slopes = DoubleBall::hull(least, greatest);
  const DdBall slope =
      DdBall(slopes.mid, 0, slopes.rad) * DdBall(static_cast<double>(c.size() - 1));
  const DdBall width = DdBall(hi) - DdBall(lo), middle = DdBall(lo) + half * width;
  return middle - right.front() / slope * width;
}

}  // namespace

bool are_apart(const RoughRows& rows, GenId g, GenId h, double lo, double hi) {
  return sign(rows.tangency_of(g, h, DoubleBall::hull(lo, hi))) == Sign::positive;
}

bool stay_apart(const RoughRows& rows, GenId g, GenId h, double lo, double end) {
  const auto over = [&](GenId k) { return rows.over<DoubleBall>(k, lo, end); };
  const Form<DoubleBall, 2> p = rows.tangency_over(g, over(g), h, over(h));
  if (sign(p.c[0]) != Sign::positive || sign(p.c[2]) != Sign::positive) return false;
  if (sign(p.c[1]) == Sign::positive) return true;
  // c0 (1-x)^2 + c1 x (1-x) + c2 x^2, where the coefficients in between is negative.
  return sign(p.c[1] * p.c[1] - DoubleBall(4) * p.c[0] * p.c[2]) == Sign::negative;
}

bool is_legal_edge(const RoughRows& rows, const Quad& edge, double lo, double hi) {
  const EdgeEnds<DoubleBall> ends = ends_at(rows, from_disk(edge), DoubleBall::hull(lo, hi));
  return sign(value(ends.conflict_at_start())) == Sign::positive ||
         sign(value(ends.conflict_at_end())) == Sign::positive;
}

RoughCollapse rough_collapse(const MovingRows& rows, const Quad& q, double lo, double hi,
                             double end) {
  return Search(rows, q).after(lo, hi, end);
}

DdBall narrowed_root(const MovingRows& rows, const Quad& edge, double lo, double hi) {
  const Quad q = from_disk(edge);
  const bool is_square = has_square(rows, q);
  DdBall best(0.5 * lo + 0.5 * hi, 0, hi - lo);
  for (int step = 0; step < 4 && lo < hi; ++step) {
    Coefficients<DdBall> c;
    if (is_square) {
      c = unscaled(cocircularity_over<DdBall>(rows.rough(), q, lo, hi), MakeDd{});
    } else {
      c = unscaled(cotangency_over<DdBall>(rows.rough(), q, lo, hi), MakeDd{});
    }
    const DdBall next = newton(c, lo, hi);
    if (!(next.rad < 0.5 * best.rad)) break;
    best = next;
    if (rounds_to_leading(best)) break;
    double below = 0, above = 0;
    enclose(best, below, above);
    lo = std::max(lo, below);
    hi = std::min(hi, above);
  }
  return best;
}

}  // namespace voroproof::internal
