#include "certify/edge_proof.h"

#include <algorithm>
#include <cmath>

#include "certify/edge_signs.h"
#include "filtered/bernstein.h"
#include "filtered/de_casteljau.h"

namespace voroproof {

namespace {

// Parts are halved at most this often: what is left then is near a root or a degeneracy.
constexpr int kMaxDepth = 14;

// `f`: the sign of the cotangency.
EdgeSigns signs_over(const Motion& m, const Quad& q, const DoubleBall& t, Sign f) {
  const Site<DoubleBall> l = m.site(q.l, t), r = m.site(q.r, t), s = m.site(q.s, t),
                         e = m.site(q.e, t);
  return edge_signs(q, l, r, s, e, f);
}

// Whether the edge collapses at no time of [a, b], where its flip polynomial may have roots: one
// of its circles exists at no time of it, or exists and is free of the other's third generator.
bool legal_throughout(const Motion& m, const Quad& q, double a, double b) {
  const DoubleBall t = DoubleBall::hull(a, b);
  const Site<DoubleBall> l = m.site(q.l, t), r = m.site(q.r, t), s = m.site(q.s, t),
                         e = m.site(q.e, t);
  const auto idle = [](const TangentTriple<DoubleBall>& circle, GenId id,
                       const Site<DoubleBall>& other) {
    const Sign exists = circle_exists(circle);
    if (exists == Sign::negative) return true;
    return exists == Sign::positive &&
           incircle(circle, other, id == container_id, Sign::unknown) == Sign::positive;
  };
  return idle(tangent_triple(q.l, l, q.s, s, q.r, r), q.e, e) ||
         idle(tangent_triple(q.r, r, q.e, e, q.l, l), q.s, s);
}

// A polynomial in the Bernstein basis over a part of the life.
struct Piece {
  double a, b;  // the part
  int degree;
  std::array<double, 9> c;
  double err;  // of each coefficient
};

// The sign of all coefficients, or unknown.
Sign one_sign(const Piece& p) {
  bool positive = true, negative = true;
  for (int k = 0; k <= p.degree; ++k) {
    positive = positive && p.c[k] > p.err;
    negative = negative && p.c[k] < -p.err;
  }
  return positive ? Sign::positive : negative ? Sign::negative : Sign::unknown;
}

// Splits a piece at s of its length, 0 < s < 1, at the time `at`, by de Casteljau's algorithm: left
// of it, and right of it. Each of its at most 8 rounds computes (1 - s) c + s c', which errs by at
// most 4u times the largest coefficient.
template <int degree>
void split(const Piece& p, double s, double at, Piece& left, Piece& right) {
  double largest = 0;
  for (int k = 0; k <= degree; ++k) largest = std::max(largest, std::fabs(p.c[k]));
  const double err = (p.err + 32 * 0x1p-53 * largest) * (1 + 0x1p-40);
  const double rest = 1 - s;
  std::array<double, 9> c = p.c;
  left = {p.a, at, degree, {}, err};
  right = {at, p.b, degree, {}, err};
  left.c[0] = c[0];
  right.c[degree] = c[degree];
  each_level<degree>(
      c.data(), [&](double x, double y) { return rest * x + s * y; },
      [&](auto last) {
        left.c[degree - last] = c[0];
        right.c[last] = c[last];
      });
}

void split(const Piece& p, double s, double at, Piece& left, Piece& right) {
  p.degree == 8 ? split<8>(p, s, at, left, right) : split<4>(p, s, at, left, right);
}

// Where in [0, 1] a polynomial whose first and last coefficient differ in sign vanishes, roughly:
// a hint.
template <int degree>
double near_root(const Piece& p) {
  double lo = 0, hi = 1, s = p.c[0] / (p.c[0] - p.c[degree]);
  for (int step = 0; step < 6; ++step) {
    std::array<double, 9> c = p.c;
    double slope = 0;
    each_level<degree>(
        c.data(), [&](double x, double y) { return x + s * (y - x); },
        [&](auto last) {
          if constexpr (last == 1) slope = degree * (c[1] - c[0]);
        });
    const double value = c[0];
    ((value > 0) == (p.c[0] > 0) ? lo : hi) = s;
    const double next = s - value / slope;
    const double moved = std::fabs(next - s);
    s = lo < next && next < hi ? next : 0.5 * (lo + hi);
    if (moved < 0x1p-12) break;
  }
  return s;
}

// Around a root so much of a piece is looked at by its circles, on both sides.
constexpr double kAround = 0x1p-8;

// Pieces are cut at most this often one within the other.
constexpr int kMaxCuts = 12;

// `around_root`: the piece has been cut out around a root. There the circles tell nearly always, in
// other pieces nearly never while they can be cut.
bool piece_free(const Motion& m, const Quad& q, const Piece& p, int cuts, bool around_root) {
  if (one_sign(p) != Sign::unknown) return true;
  const bool crosses =
      (p.c[0] > p.err && p.c[p.degree] < -p.err) || (p.c[0] < -p.err && p.c[p.degree] > p.err);
  if (around_root || (!crosses && cuts > 0) || cuts == kMaxCuts) {
    // The times of a piece are rounded: each cut within one adds at most 16u of the greatest.
    const double slop = 0x1p-45 * std::fmax(std::fabs(p.a), std::fabs(p.b));
    if (legal_throughout(m, q, p.a - slop, p.b + slop)) return true;
  }
  if (cuts == kMaxCuts) return false;
  const double length = p.b - p.a;
  const auto time_at = [&](double s) { return p.a + s * length; };
  Piece left, right;
  if (crosses) {
    const double s = p.degree == 8 ? near_root<8>(p) : near_root<4>(p);
    const double s0 = s - kAround, s1 = s + kAround;
    // What is left beside the root may be nothing much.
    const bool at_left = s0<kAround, at_right = s1> 1 - kAround;
    Piece middle = p;
    if (!at_right) {
      split(middle, s1, time_at(s1), left, right);
      if (!piece_free(m, q, right, cuts + 1, false)) return false;
      middle = left;
    }
    if (!at_left) {
      split(middle, at_right ? s0 : s0 / s1, time_at(s0), left, right);
      if (!piece_free(m, q, left, cuts + 1, false)) return false;
      middle = right;
    }
    return piece_free(m, q, middle, cuts + 1, true);
  }
  const double half = time_at(0.5);
  if (!(p.a < half && half < p.b)) return false;
  split(p, 0.5, half, left, right);
  return piece_free(m, q, left, cuts + 1, false) && piece_free(m, q, right, cuts + 1, false);
}

bool free_in(const Motion& m, const Quad& q, double a, double b, int depth) {
  BernsteinForm form;
  if (form_flip_polynomial<true>(m, q, a, b, form)) return true;
  if (piece_free(m, q, {a, b, form.degree, form.c, form.err}, 0, false)) return true;
  const double middle = 0.5 * (a + b);
  if (depth == kMaxDepth || !(a < middle && middle < b)) return false;
  // From both halves' own ends, so that the error bound shrinks with the part.
  return free_in(m, q, a, middle, depth + 1) && free_in(m, q, middle, b, depth + 1);
}

// Whether the edge collapses at the one root in [a, b], `after` being the sign of the cotangency
// just after it.
bool collapses_at_root(const Motion& motion, const Quad& q, double a, double b, Sign after) {
  EdgeSigns s = signs_over(motion, q, DoubleBall::hull(a, b), after);
  if (s.start_exists != Sign::positive || s.end_exists != Sign::positive) return false;
  if (s.end_in_start == Sign::unknown || s.start_in_end == Sign::unknown) {
    const DoubleBall t = DoubleBall::hull(a, b);
    const std::array<Site<DoubleBall>, 4> sites{motion.site(q.l, t), motion.site(q.r, t),
                                                motion.site(q.s, t), motion.site(q.e, t)};
    if (!keeps_tangencies(sites)) return false;
    s = signs_over(motion, q, DoubleBall(b), after);
  }
  return s.end_in_start == Sign::negative && s.start_in_end == Sign::negative;
}

}  // namespace

bool proved_free(const Motion& motion, const Quad& q, double a, double b) {
  return q.s == q.e || !(a < b) || free_in(motion, q, a, b, 0);  // Lemma 8: s = e never collapses
}

bool proved_collapse(const Motion& motion, const Quad& q, double a, double b) {
  BernsteinForm form;
  if (q.s == q.e || !(a < b) || form_flip_polynomial<true>(motion, q, a, b, form)) return false;
  // Exactly one sign change, between certain signs, over at most one uncertain coefficient.
  int last = 0, changes = 0, uncertain = 0;
  for (int k = 0; k <= form.degree; ++k) {
    const int s = form.c[k] > form.err ? 1 : form.c[k] < -form.err ? -1 : 0;
    if (s == 0) {
      if (k == 0 || k == form.degree) return false;
      ++uncertain;
      continue;
    }
    if (last != 0 && s != last) {
      if (uncertain > 1) return false;
      ++changes;
    } else if (last != 0 && uncertain > 0) {
      return false;
    }
    last = s;
    uncertain = 0;
  }
  if (changes != 1) return false;
  // Of the cotangency just after the root: for four equal radii the form is C, and f = -C^2.
  const Sign after = form.degree == 4 ? Sign::negative : sign_of(last);
  return collapses_at_root(motion, q, a, b, after);
}

std::optional<DdBall> newton_collapse(const Motion& motion, const CollapseSearch& search,
                                      const Quad& q, double a, double b) {
  if (q.s == q.e || !(a < b)) return std::nullopt;
  const DdBall root = search.newton(q, a, b);
  if (!(root.rad < 0.25 * (b - a)) || sign(root - DdBall(a)) != Sign::positive ||
      sign(root - DdBall(b)) != Sign::negative) {
    return std::nullopt;
  }
  Sign after = Sign::negative;
  if (!flip_polynomial_is_cocircularity(motion, q)) {
    const DdBall t(b);
    after = sign(cotangency(motion.site(q.l, t), motion.site(q.r, t), motion.site(q.s, t),
                            motion.site(q.e, t)));
    if (!is_certain(after)) return std::nullopt;
  }
  if (!collapses_at_root(motion, q, a, b, after)) return std::nullopt;
  return root;
}

bool proved_not_cotangent(const Motion& motion, const Quad& q, double a, double b) {
  const DoubleBall t = DoubleBall::hull(a, b);
  return is_certain(sign(cotangency(motion.site(q.l, t), motion.site(q.r, t), motion.site(q.s, t),
                                    motion.site(q.e, t))));
}

}  // namespace voroproof
