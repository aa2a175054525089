#include "certify/edge_proof.h"

#include "certify/edge_signs.h"
#include "filtered/bernstein.h"

namespace voroproof {

namespace {

// Parts are halved at most this often: what is left then is near a root or a degeneracy.
constexpr int kMaxDepth = 14;

EdgeSigns signs_over(const Motion& m, const Quad& q, const DoubleBall& t, Sign f) {
  const Site<DoubleBall> l = m.site(q.l, t), r = m.site(q.r, t), s = m.site(q.s, t),
                         e = m.site(q.e, t);
  if (f == Sign::unknown) f = sign(cotangency(l, r, s, e));
  return edge_signs(q, l, r, s, e, f);
}

bool no_collapse(const EdgeSigns& s) {
  return s.start_exists == Sign::negative || s.end_exists == Sign::negative ||
         (s.start_exists == Sign::positive && s.end_in_start == Sign::positive) ||
         (s.end_exists == Sign::positive && s.start_in_end == Sign::positive);
}

bool free_in(const Motion& m, const Quad& q, double a, double b, int depth) {
  BernsteinForm form;
  if (form_flip_polynomial<true>(m, q, a, b, form)) return true;
  if (no_collapse(signs_over(m, q, DoubleBall::hull(a, b), Sign::unknown))) return true;
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
  const DdBall root = search.refine(q, a, b);
  if (!(root.rad < 0.25 * (b - a)) || sign(root - DdBall(a)) != Sign::positive ||
      sign(root - DdBall(b)) != Sign::negative) {
    return std::nullopt;
  }
  Sign after = Sign::negative;
  if (!flip_polynomial_is_cocircularity(motion, q)) {
    const DdBall t(b);
    after = sign(cotangency(motion.site(q.l, t), motion.site(q.r, t), motion.site(q.s, t),
                            motion.site(q.e, t)));
    if (after != Sign::positive && after != Sign::negative) return std::nullopt;
  }
  if (!collapses_at_root(motion, q, a, b, after)) return std::nullopt;
  return root;
}

bool proved_not_cotangent(const Motion& motion, const Quad& q, double a, double b) {
  const DoubleBall t = DoubleBall::hull(a, b);
  const Sign f = sign(cotangency(motion.site(q.l, t), motion.site(q.r, t), motion.site(q.s, t),
                                 motion.site(q.e, t)));
  return f == Sign::positive || f == Sign::negative;
}

}  // namespace voroproof
