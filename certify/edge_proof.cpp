#include "certify/edge_proof.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "certify/edge_circles.h"
#include "certify/edge_signs.h"
#include "certify/rootless.h"
#include "filtered/numbers/de_casteljau.h"
#include "filtered/numbers/lanes.h"
#include "filtered/numbers/sign_variations.h"
#include "filtered/search/bernstein.h"
#include "filtered/search/edge_predicates.h"
#include "filtered/search/flip_polynomial.h"
#include "filtered/search/rough_circles.h"
#include "filtered/search/rough_judge.h"

namespace voroproof::internal {

namespace {

// Parts are halved at most this often: what is left then is near a root or a degeneracy.
constexpr int kMaxDepth = 14;

// Pieces are looked at this often in all, some milliseconds: where that does not do, isolating the
// roots tells.
constexpr int kMaxLooks = 1 << 14;

// Whether the edge collapses at no time of [a, b], where its flip polynomial may have roots: one
// of its circles exists at no time of it, or exists and is free of the other's third generator.
bool legal_throughout(const Motion& m, const Quad& q, double a, double b) {
  const EdgeCircles circles(m, q, DoubleBall::hull(a, b));
  const auto idle = [](Sign exists, Sign free) {
    return exists == Sign::negative || (exists == Sign::positive && free == Sign::positive);
  };
  return idle(circles.start_exists(), circles.end_in_start(Sign::unknown)) ||
         idle(circles.end_exists(), circles.start_in_end(Sign::unknown));
}

// Whether one of the edge's in-circle functions is positive throughout [a, b]: there it is not just
// after a collapse. `f`: the sign of the cotangency.
bool legal_over(const Motion& m, const Quad& q, double a, double b, Sign f) {
  if (f != Sign::unknown) {
    const RoughCircles circles(m, q, a, b);
    if (circles.usable()) {
      const auto [e, s] = circles.in_circle(f);
      if (e == Sign::positive || s == Sign::positive) return true;
    }
  }
  const DoubleBall t = DoubleBall::hull(a, b);
  if (f == Sign::unknown) {
    const auto [l, r, s, e] = sites(m, q, t);
    f = sign(cotangency(l, r, s, e));
  }
  const EdgeCircles circles(m, q, t);
  return circles.end_in_start(f) == Sign::positive || circles.start_in_end(f) == Sign::positive;
}

// A polynomial in the Bernstein basis over a part of the life.
struct Piece {
  double a, b;  // the part
  int degree;
  std::array<double, 9> c;
  double err;  // error of each coefficient
};

// The times of a piece are rounded: each cut within one adds at most 16u of the greatest.
double slop(const Piece& p) { return 0x1p-45 * std::fmax(std::fabs(p.a), std::fabs(p.b)); }

// The coefficients beyond the error on either side, a bit for each. What is not a number is on
// none.
struct Sides {
  unsigned all, positive, negative;

  explicit Sides(const Piece& p) : all((2U << p.degree) - 1) {
    const auto beyond = [&p](double side) {
      const Lanes err = p.err + Lanes{};
      unsigned bits = exceeding(side * load(p.c.data()), err);
      if (p.degree == 8) bits |= exceeding(side * load(p.c.data() + 4), err) << 4;
      return bits | static_cast<unsigned>(side * p.c[p.degree] > p.err) << p.degree;
    };
    positive = beyond(1);
    negative = beyond(-1);
  }
};

// How many roots a piece has at most: 0, 1, or 2 for more.
int most_roots(const Piece& p) {
  const Sides of(p);
  return voroproof::internal::most_roots(of.all & ~of.negative, of.all & ~of.positive);
}

// The sign of the polynomial at the end of the piece.
Sign end_sign(const Piece& p) {
  const double last = p.c[p.degree];
  return last > p.err ? Sign::positive : last < -p.err ? Sign::negative : Sign::unknown;
}

// The sign of the cotangency there: for four equal radii the form is C, and f = -C^2.
Sign end_sign_of_cotangency(const Piece& p) {
  const Sign s = end_sign(p);
  return s == Sign::unknown ? s : cotangency_sign(s, p.degree == 4);
}

// Where a piece is cut, as a share of its length: 1 - share is a power of two.
constexpr double kHalf = 0.5;
// Just before its end, where the root is that is wanted.
constexpr double kNearEnd = 31.0 / 32;

double time_in(const Piece& p, double share) { return p.a + share * (p.b - p.a); }

// Cuts a piece there, at the time `at`, by de Casteljau's algorithm. Each of its at most 8 rounds
// computes (1 - share) c + share c', which errs by at most 2u times the largest coefficient.
template <int degree>
void cut(const Piece& p, double share, double at, Piece& left, Piece& right) {
  double largest = 0;
  for (int k = 0; k <= degree; ++k) largest = std::max(largest, std::fabs(p.c[k]));
  const double err = (p.err + 32 * 0x1p-53 * largest) * (1 + 0x1p-40);
  std::array<double, 9> c = p.c;
  left.a = p.a;
  left.b = right.a = at;
  right.b = p.b;
  left.degree = right.degree = degree;
  left.err = right.err = err;
  if constexpr (degree < 8) left.c = right.c = {};  // those that are not written below
  left.c[0] = c[0];
  right.c[degree] = c[degree];
  const double rest = 1 - share;
  each_level<degree>(
      c.data(), [&](double x, double y) { return rest * x + share * y; },
      [&](auto last) {
        left.c[degree - last] = c[0];
        right.c[last] = c[last];
      });
}

void cut(const Piece& p, double share, double at, Piece& left, Piece& right) {
  p.degree == 8 ? cut<8>(p, share, at, left, right) : cut<4>(p, share, at, left, right);
}

// Exactly one root, not at an end.
bool has_one_root(const Piece& p) {
  const Sides of(p);
  return roots_by_signs(of.positive, of.negative, p.degree) == 1;
}

// The sign at the parameter x, at which the value errs by no more than the bound of the
// coefficients: it pays for one evaluation (bernstein.cpp).
template <int degree>
Sign sign_of_form(const Piece& p, double x) {
  std::array<double, 9> c = p.c;
  const double y = 1 - x;
  each_level<degree>(
      c.data(), [&](double a, double b) { return y * a + x * b; }, [](auto) {});
  return c[0] > p.err ? Sign::positive : c[0] < -p.err ? Sign::negative : Sign::unknown;
}
Sign sign_of_form(const Piece& p, double x) {
  return p.degree == 8 ? sign_of_form<8>(p, x) : sign_of_form<4>(p, x);
}

// Pieces are cut at most this often one within the other.
constexpr int kMaxCuts = 12;

// Pieces this often cut are looked at by their circles over all of their time.
constexpr int kShort = 7;

// `looks`: so many pieces may still be looked at.
bool piece_free(const Motion& m, const Quad& q, const Piece& p, int cuts, int& looks) {
  if (looks-- <= 0) return false;
  const int roots = most_roots(p);
  if (roots == 0) return true;
  // For four equal radii C is the in-circle function of both circles: it has risen, or no root.
  if (roots == 1 && p.degree == 4 && end_sign(p) == Sign::positive) return true;
  // With one root at most, what is positive at the end has been so throughout, or since the root.
  const double a = p.a - slop(p), b = p.b + slop(p);
  if (roots == 1 && legal_over(m, q, p.b - slop(p), b, end_sign_of_cotangency(p)) &&
      are_separated(m, q, a, b)) {
    return true;
  }
  if (cuts >= kShort && legal_throughout(m, q, a, b)) return true;
  const double at = time_in(p, kHalf);
  if (cuts == kMaxCuts || !(p.a < at && at < p.b)) return false;
  Piece left, right;
  cut(p, kHalf, at, left, right);
  return piece_free(m, q, left, cuts + 1, looks) && piece_free(m, q, right, cuts + 1, looks);
}

// Cuts off what comes before the last root of the piece, before the time `until`, as long as that
// is free of collapses. Whether what is left certainly has one root, not at an end.
bool cut_to_one_root(const Motion& m, const Quad& q, double until, Piece& piece, int& looks) {
  for (int cuts = 0; !has_one_root(piece); ++cuts) {
    const double at = time_in(piece, kNearEnd);
    if (cuts == kMaxCuts || !(piece.a < at && at < until)) return false;
    Piece left, right;
    cut(piece, kNearEnd, at, left, right);
    if (!piece_free(m, q, left, cuts + 1, looks)) return false;
    piece = right;
  }
  return true;
}

// The rest of [from, b] that certainly has one root, not at an end, after a time before `until` up
// to which the edge does not collapse. What is left where the form of the whole does not tell has a
// form of its own, with smaller errors.
std::optional<Piece> piece_of_one_root(const Motion& m, const Quad& q, double from, double until,
                                       double b) {
  int looks = kMaxLooks;
  double begin = from;
  for (int forms = 0; forms < 2; ++forms) {
    BernsteinForm form;
    if (form_flip_polynomial<true>(m, q, begin, b, form)) break;
    Piece piece{begin, b, form.degree, form.c, form.err};
    if (cut_to_one_root(m, q, until, piece, looks)) return piece;
    const double left = piece.a - slop(piece);
    if (!(begin < left)) break;
    begin = left;
  }
  return std::nullopt;
}

bool free_in(const Motion& m, const Quad& q, double a, double b, int depth, int& looks) {
  BernsteinForm form;
  if (form_for_collapse(m, q, a, b, form)) return true;
  // For nearly equal radii roots come in pairs, which pieces do not tell apart.
  if (form.spread > 0) return false;
  if (piece_free(m, q, {a, b, form.degree, form.c, form.err}, 0, looks)) return true;
  const double middle = 0.5 * (a + b);
  if (depth == kMaxDepth || looks <= 0 || !(a < middle && middle < b)) return false;
  // Each half has a form of its own, so that the error bound shrinks with the part.
  return free_in(m, q, a, middle, depth + 1, looks) && free_in(m, q, middle, b, depth + 1, looks);
}

// Whether the edge collapses at the one root in [a, b], beyond which the flip polynomial, C if
// `cocircular`, has the sign `beyond`.
bool collapses_at_root(const Motion& motion, const Quad& q, double a, double b, bool cocircular,
                       Sign beyond) {
  const Sign after = cotangency_sign(beyond, cocircular);
  const Judgement verdict = cocircular ? judge_cocircular(motion, q, a, b, 0, beyond)
                                       : judge_roughly(motion, q, a, b, after);
  if (verdict == Judgement::collapses) return true;
  const DoubleBall hull = DoubleBall::hull(a, b);
  const EdgeCircles over(motion, q, hull);
  if (over.start_exists() != Sign::positive || over.end_exists() != Sign::positive) return false;
  const Sign start = over.end_in_start(after), end = over.start_in_end(after);
  if (start != Sign::unknown && end != Sign::unknown) {
    return start == Sign::negative && end == Sign::negative;
  }
  if (!keeps_tangencies(sites(motion, q, hull))) return false;
  const EdgeCircles at_end(motion, q, DoubleBall(b));
  return at_end.end_in_start(after) == Sign::negative &&
         at_end.start_in_end(after) == Sign::negative;
}

EdgeSigns signs_at(const Quad& q, const std::array<Site<Ball>, 4>& at) {
  const auto& [l, r, s, e] = at;
  return edge_signs(q, l, r, s, e, sign(cotangency(l, r, s, e)));
}

}  // namespace

bool proved_free(const Motion& motion, const Quad& q, double a, double b) {
  int looks = kMaxLooks;
  return q.s == q.e || !(a < b) || free_in(motion, q, a, b, 0, looks);  // Lemma 8: s = e: never
}

bool proved_free_of_one(const Motion& motion, const Quad& q, double b, Sign f) {
  return q.s == q.e || legal_over(motion, q, b, b, f);
}

bool proved_collapse(const Motion& motion, const Quad& q, double a, double b) {
  BernsteinForm form;
  if (q.s == q.e || !(a < b) || form_flip_polynomial<true>(motion, q, a, b, form)) return false;
  const Piece piece{a, b, form.degree, form.c, form.err};
  return has_one_root(piece) &&
         collapses_at_root(motion, q, a, b, piece.degree == 4, end_sign(piece));
}

bool proved_first_collapse(const Motion& motion, const Quad& q, double from, double a, double b) {
  if (q.s == q.e || !(from < a && a < b)) return false;
  const std::optional<Piece> found = piece_of_one_root(motion, q, from, a, b);
  if (!found) return false;
  const Piece& piece = *found;
  // It is in [a, b] if the sign at a is that before it. The parameter x of a is rounded, and the
  // ends of the piece err: each cut rounds three times, by at most u M, M = |from| + |b|, each, and
  // keeps the errors of the two ends between which it lies, so that after kMaxCuts of them the
  // start errs by 3 kMaxCuts u M, the length by twice that. Numerator, length and quotient are
  // rounded once each, which is 3 u M in time or less. A sign a little later will do as well:
  // `slack` = 512 u M later than a, the true time of the point is after a in any case.
  static_assert(9 * kMaxCuts + 3 < 512);
  const double slack = 512 * unit_roundoff * (std::fabs(from) + std::fabs(b));
  const double x = (a + slack - piece.a) / (piece.b - piece.a);
  const Sign before = piece.c[0] > 0 ? Sign::positive : Sign::negative;
  return x > 0 && x < 1 && sign_of_form(piece, x) == before &&
         collapses_at_root(motion, q, a, b, piece.degree == 4, end_sign(piece));
}

std::optional<DdBall> newton_collapse(const Motion& motion, const CollapseSearch& search,
                                      const Quad& q, double a, double b) {
  if (q.s == q.e || !(a < b)) return std::nullopt;
  const DdBall root = search.newton(q, a, b);
  if (!(root.rad < 0.25 * (b - a)) || sign(root - DdBall(a)) != Sign::positive ||
      sign(root - DdBall(b)) != Sign::negative) {
    return std::nullopt;
  }
  const bool cocircular = flip_polynomial_is_cocircularity(motion, q);
  const Sign beyond = sign(flip_value(motion, q, DdBall(b), cocircular));
  if (!is_certain(beyond) || !collapses_at_root(motion, q, a, b, cocircular, beyond)) {
    return std::nullopt;
  }
  return root;
}

namespace {

// Whether the tangency of some two of the sites of q has a sign that `is(sign, right)`, where
// `right` is that of two generators of which none lies in the other.
template <class Is>
bool any_tangency(const Quad& q, const std::array<Site<Ball>, 4>& at, Is&& is) {
  const std::array<GenId, 4> ids{q.l, q.r, q.s, q.e};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      const bool wall = ids[i] == container_id || ids[j] == container_id;
      if (is(sign(tangency(at[i], at[j])), wall ? Sign::negative : Sign::positive)) return true;
    }
  }
  return false;
}

}  // namespace

bool proved_illegal(const Motion& motion, const Quad& q, const Rational& t) {
  const auto at = sites(motion, q, Ball(t, motion.goal_bits() + 32));
  if (any_tangency(q, at, [](Sign s, Sign right) { return s != right; })) return false;
  const EdgeSigns signs = signs_at(q, at);
  return signs.end_in_start == Sign::negative && signs.start_in_end == Sign::negative;
}

bool proved_no_flip(const Motion& motion, const Quad& q, const Rational& lo, const Rational& hi) {
  const auto is_not = [&](const Rational& t, Sign legality) {
    const auto at = sites(motion, q, Ball(t, motion.goal_bits() + 32));
    if (any_tangency(q, at, [](Sign s, Sign right) { return s == -right; })) return true;
    const EdgeSigns signs = signs_at(q, at);
    return signs.start_exists == Sign::negative || signs.end_exists == Sign::negative ||
           signs.end_in_start == -legality || signs.start_in_end == -legality;
  };
  return is_not(lo, Sign::positive) || is_not(hi, Sign::negative);
}

}  // namespace voroproof::internal
