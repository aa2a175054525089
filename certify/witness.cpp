#include "certify/witness.h"

#include <algorithm>
#include <array>

#include "exact/polynomial.h"
#include "filtered/motion/exact_motion.h"
#include "filtered/search/bernstein.h"

namespace voroproof::internal {

namespace {

// Longer numbers are given as enclosures.
constexpr std::size_t kMaxExactBits = 2048;

EvidenceNumber number(const Rational& q) {
  EvidenceNumber n;
  n.exact = q.get_str();
  return n;
}

std::string decimal(mpfr_srcptr x, mpfr_rnd_t direction) {
  char* text = nullptr;
  mpfr_asprintf(&text, direction == MPFR_RNDD ? "%.40RDe" : "%.40RUe", x);
  std::string out(text);
  mpfr_free_str(text);
  return out;
}

EvidenceNumber number(const Ball& b) {
  EvidenceNumber n;
  mpfr_t lo, hi;
  mpfr_init2(lo, 160);
  mpfr_init2(hi, 160);
  b.to_interval(lo, hi);
  n.lower = decimal(lo, MPFR_RNDD);
  n.upper = decimal(hi, MPFR_RNDU);
  mpfr_clears(lo, hi, nullptr);
  return n;
}

EvidenceMotion motion_of(GenId g, const Rational& t0, const MovingSite<Rational>& q) {
  return {g, t0, number(q.x), number(q.y), number(q.vx), number(q.vy), number(q.r)};
}

// The path of a generator as polynomials in t; its place is that at t0.
Site<Polynomial<Rational>> path_of(const Rational& t0, const MovingSite<Rational>& q) {
  return {Polynomial<Rational>{Rational(q.x - q.vx * t0), q.vx},
          Polynomial<Rational>{Rational(q.y - q.vy * t0), q.vy}, Polynomial<Rational>{q.r}};
}

// The exact states where they are rational and not too long.
class Evidence {
 public:
  Evidence(const Motion& motion, const Rational& t0) : motion_(motion), t0_(t0), exact_(motion) {}

  bool rational(GenId g, MovingSite<Rational>& out) {
    if (!motion_.is_rational(g)) return false;
    try {
      const MovingSite<Tower> s = exact_.moving_site(g, t0_);
      for (const Tower* x : {&s.x, &s.y, &s.vx, &s.vy}) {
        if (bit_size(x->rational()) > kMaxExactBits) return false;
      }
      const auto& o = motion_.input().origin;
      out = {Rational(s.x.rational() + o[0]), Rational(s.y.rational() + o[1]), s.vx.rational(),
             s.vy.rational(), s.r.rational()};
      return true;
    } catch (const BudgetExceeded&) {
      return false;
    }
  }

  EvidenceMotion motion(GenId g) {
    MovingSite<Rational> q;
    if (rational(g, q)) {
      return motion_of(g, t0_, q);
    }
    const Ball::Precision bits = motion_.goal_bits() + 32;
    const MovingSite<Ball> b = motion_.moving_site(g, Ball(t0_, bits));
    const auto placed = [&](const Ball& x, int axis) {
      return number(x + Ball(motion_.input().origin[axis], bits));
    };
    return {g, t0_, placed(b.x, 0), placed(b.y, 1), number(b.vx), number(b.vy), number(b.r)};
  }

  Witness of(const std::vector<GenId>& generators) {
    Witness w;
    for (const GenId g : generators) w.generators.push_back(motion(g));
    return w;
  }

  // The path of g as polynomials in t; false where it is not rational.
  bool path(GenId g, Site<Polynomial<Rational>>& out) {
    MovingSite<Rational> q;
    if (!rational(g, q)) return false;
    out = path_of(t0_, q);
    return true;
  }

 private:
  const Motion& motion_;
  Rational t0_;
  ExactMotion exact_;
};

void add_polynomial(Witness& w, const std::string& is, const Polynomial<Rational>& f) {
  w.polynomial_is = is;
  for (const Rational& c : f.coefficients()) w.polynomial.push_back(number(c));
}

// Narrows the interval of a contact to the side of the nearest time, or of the farthest from the
// container's centre, on which they approach. Where that has no root, the two overlap in it.
void locate_contact(Witness& w, const Polynomial<Rational>& f, bool wall) {
  const std::vector<Rational>& c = f.coefficients();
  auto& [lo, hi] = *w.root;
  if (c.size() == 3) {
    const Rational turn = -c[1] / (2 * c[2]);
    if (wall ? lo < turn : turn < hi) (wall ? lo : hi) = std::max(lo, std::min(turn, hi));
  }
  const auto apart = [&](const Rational& t) { return sgn(f.evaluate(t)) * (wall ? -1 : 1); };
  if (apart(lo) >= 0 && apart(hi) <= 0) return;
  w.t = apart(lo) < 0 ? lo : hi;
  w.root.reset();
}

// The contact of two on these paths, in the interval that the witness has.
void add_contact(Witness& w, const Site<Polynomial<Rational>>& a,
                 const Site<Polynomial<Rational>>& b, bool wall) {
  const auto dx = b.x - a.x, dy = b.y - a.y, reach = a.r + b.r;
  const Polynomial<Rational> f = dx * dx + dy * dy - reach * reach;
  add_polynomial(w, "contact", f);
  locate_contact(w, f, wall);
}

}  // namespace

Witness collapse_witness(const Motion& motion, const Quad& q, const Rational& lo,
                         const Rational& hi) {
  Evidence evidence(motion, to_rational(round_nearest(lo)));
  Witness w = evidence.of({q.l, q.r, q.s, q.e});
  w.root = {lo, hi};
  std::array<Site<Polynomial<Rational>>, 4> s;
  if (evidence.path(q.l, s[0]) && evidence.path(q.r, s[1]) && evidence.path(q.s, s[2]) &&
      evidence.path(q.e, s[3])) {
    if (flip_polynomial_is_cocircularity(motion, q)) {
      add_polynomial(w, "cocircularity", cocircularity(s[3], s[0], s[1], s[2]));
    } else {
      add_polynomial(w, "cotangency", cotangency(s[0], s[1], s[2], s[3]));
    }
  }
  return w;
}

Witness contact_witness(const Motion& motion, GenId i, GenId j, const Rational& lo,
                        const Rational& hi) {
  Evidence evidence(motion, to_rational(round_nearest(lo)));
  Witness w = evidence.of({i, j});
  w.root = {lo, hi};
  Site<Polynomial<Rational>> a, b;
  if (evidence.path(i, a) && evidence.path(j, b)) add_contact(w, a, b, i == container_id);
  return w;
}

Witness contact_witness(const RecordedContacts::Motions& motions, GenId i, GenId j, double lo,
                        double hi) {
  const auto& [at, first, second] = motions;
  Witness w;
  w.generators = {motion_of(i, at, first), motion_of(j, at, second)};
  w.root = {to_rational(lo), to_rational(hi)};
  add_contact(w, path_of(at, first), path_of(at, second), i == container_id);
  return w;
}

Witness motion_witness(const Motion& motion, const std::vector<GenId>& generators,
                       const Rational& t) {
  Evidence evidence(motion, to_rational(round_nearest(t)));
  return evidence.of(generators);
}

Witness conflict_witness(const Motion& motion, const Triple& vertex, GenId conflict,
                         const Rational& t) {
  Witness w = motion_witness(motion, {vertex[0], vertex[1], vertex[2], conflict}, t);
  w.t = t;
  w.vertex = vertex;
  w.conflict = conflict;
  return w;
}

}  // namespace voroproof::internal
