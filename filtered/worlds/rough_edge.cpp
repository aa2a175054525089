#include "filtered/worlds/rough_edge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "filtered/numbers/subdivision.h"
#include "filtered/worlds/edge_ends.h"

namespace voroproof::internal {
namespace {

using Generators = std::array<GenId, 4>;

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
// as in filtered/search/bernstein.cpp. It is infinite where a sum of coefficients may overflow
// (filtered/numbers/bound.h).
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
  out.err = (error + unit_roundoff * (30.0 * degree * size)) * (1 + 0x1p-40) + 1e-290;
  return out;
}

Quad from_disk(const Quad& q) { return q.l == container_id ? reversed(q) : q; }

EdgeEnds<DoubleBall> ends_at(const RoughRows& rows, const Quad& q, const DoubleBall& t) {
  const Site<DoubleBall> l = rows.site(q.l, t);
  const auto row = [&](GenId g) { return rows.row_of(l, g, t); };
  return {l, row(q.s), row(q.r), row(q.e)};
}

DoubleBall value(const RootExpression<DoubleBall>& x) { return x.u + sqrt(x.gamma) * x.v; }

using Kind = RoughCollapse::Kind;

// The edge at a root of its polynomial, which is C if that is `square`.
Kind judge_fall(const RoughRows& rows, const Quad& q, const DoubleRoot& root, bool square) {
  const DoubleBall t = DoubleBall::hull(root.lo, root.hi);
  const EdgeEnds<DoubleBall> ends = ends_at(rows, q, t);
  const auto conflict = [&](const RootExpression<DoubleBall>& x) {
    if (square) return root.after;
    return sign(root.after == Sign::positive ? x.u : x.v);
  };
  const Sign start = conflict(ends.conflict_at_start()), end = conflict(ends.conflict_at_end());
  if (start == Sign::positive && end == Sign::positive) return Kind::none;
  if (!is_certain(start) || !is_certain(end)) return Kind::unknown;
  if (start != end) return Kind::fails;
  const Sign same = sign(value(ends.same_circle()));
  if (same == Sign::negative) return Kind::fails;
  const Generators all{q.l, q.r, q.s, q.e};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      if (!are_apart(rows, all[i], all[j], root.lo, root.hi)) return Kind::unknown;
    }
  }
  return same == Sign::positive ? Kind::collapses : Kind::unknown;
}

Kind judge_collapse(const RoughRows& rows, const Quad& q, const DoubleRoot& root, bool square) {
  const Kind kind = judge_fall(rows, q, root, square);
  return kind == Kind::fails ? Kind::none : kind;
}

// That the circle at the start of the edge exists, whose end is infinity.
Kind judge_circle(const RoughRows& rows, const Quad& q, const DoubleRoot& root, bool square) {
  const RootExpression<DoubleBall> x =
      ends_at(rows, q, DoubleBall::hull(root.lo, root.hi)).conflict_at_start();
  const Sign s = square ? root.after : sign(root.after == Sign::positive ? x.u : x.v);
  return s == Sign::positive ? Kind::none : s == Sign::negative ? Kind::fails : Kind::unknown;
}

// The roots of a polynomial after an instant in [lo, hi], in one window after the other as long as
// windows are of use: the first that judge(root) does not pass over. `form_over` gives it over a
// window, `scale` is a length of a window to begin with.
template <class FormOver, class Judge>
RoughCollapse search(const FormOver& form_over, const Judge& judge, double scale, double lo,
                     double hi, double end) {
  constexpr int kMostWindows = 64, kMostFailures = 6;
  double from = lo, length = scale > 0 ? scale : end - lo;
  int failures = 0;
  for (int windows = 0; windows < kMostWindows && failures < kMostFailures; ++windows) {
    if (from >= end) return {Kind::none};
    const double to = length < end - from ? from + length : end;
    if (!(from < to)) break;
    const BernsteinForm form = form_over(from, to);
    RoughCollapse found{Kind::none};
    double reached = from;
    if (std::fabs(form.c[0]) > form.err) {
      reached = each_root(form, from, to, [&](const DoubleRoot& root) {
        // Another one may be at the instant itself.
        found = {root.lo > hi ? judge(root) : Kind::unknown, root};
        return found.kind == Kind::none;
      });
    }
    if (found.kind != Kind::none) return found;
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

using Judge = Kind (*)(const RoughRows&, const Quad&, const DoubleRoot&, bool square);

// Along the roots of an edge's polynomial. Precondition: q.l is a disk.
RoughCollapse search(const RoughRows& rows, const Quad& q, Judge judge, double lo, double hi,
                     double end) {
  const bool square = rows.have_one_radius(q);
  const auto form = [&](double a, double b) {
    return square ? bounded(cocircularity_over<DoubleBall>(rows, q, a, b))
                  : bounded(cotangency_over<DoubleBall>(rows, q, a, b));
  };
  const auto judged = [&](const DoubleRoot& root) { return judge(rows, q, root, square); };
  return search(form, judged, rows.time_scale(q, lo), lo, hi, end);
}

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

RoughCollapse rough_meeting(const RoughRows& rows, GenId g, GenId h, double lo, double hi,
                            double end) {
  const auto form = [&](double a, double b) {
    const Form<DoubleBall, 2> p =
        rows.tangency_over(g, rows.over<DoubleBall>(g, a, b), h, rows.over<DoubleBall>(h, a, b));
    return bounded(p * Form<DoubleBall, 2>{{1.0, 2.0, 1.0}});  // elevated to degree 4
  };
  const auto judge = [](const DoubleRoot&) { return Kind::fails; };
  return search(form, judge, rows.time_scale({g, h, h, h}, lo), lo, hi, end);
}

bool is_legal_edge(const RoughRows& rows, const Quad& edge, double lo, double hi) {
  const EdgeEnds<DoubleBall> ends = ends_at(rows, from_disk(edge), DoubleBall::hull(lo, hi));
  return sign(value(ends.conflict_at_start())) == Sign::positive &&
         sign(value(ends.conflict_at_end())) == Sign::positive;
}

namespace {

// The edge with that circle at its start and infinity at its end.
Quad towards_infinity(GenId i, GenId j, GenId k) { return {i, k, j, container_id}; }

}  // namespace

bool has_circle(const RoughRows& rows, GenId i, GenId j, GenId k, double lo, double hi) {
  const EdgeEnds<DoubleBall> ends =
      ends_at(rows, towards_infinity(i, j, k), DoubleBall::hull(lo, hi));
  return sign(value(ends.conflict_at_start())) == Sign::positive;
}

RoughCollapse rough_end_of_circle(const RoughRows& rows, GenId i, GenId j, GenId k, double lo,
                                  double hi, double end) {
  return search(rows, towards_infinity(i, j, k), judge_circle, lo, hi, end);
}

RoughCollapse rough_fall(const RoughRows& rows, const Quad& q, double lo, double hi, double end) {
  return search(rows, from_disk(q), judge_fall, lo, hi, end);
}

RoughCollapse rough_collapse(const RoughRows& rows, const Quad& q, double lo, double hi,
                             double end) {
  return search(rows, from_disk(q), judge_collapse, lo, hi, end);
}

DdBall narrowed_root(const RoughRows& rows, const Quad& edge, double lo, double hi) {
  const Quad q = from_disk(edge);
  const bool square = rows.have_one_radius(q);
  DdBall best(0.5 * lo + 0.5 * hi, 0, hi - lo);
  for (int step = 0; step < 4 && lo < hi; ++step) {
    const Coefficients<DdBall> c =
        square ? unscaled(cocircularity_over<DdBall>(rows, q, lo, hi), MakeDd{})
               : unscaled(cotangency_over<DdBall>(rows, q, lo, hi), MakeDd{});
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
