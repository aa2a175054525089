#include "certify/rootless.h"

#include <algorithm>
#include <array>
#include <bit>

#include "exact/predicates.h"
#include "exact/rounding.h"
#include "filtered/motion/motion_lanes.h"
#include "filtered/numbers/bound.h"

namespace voroproof::internal {

namespace {

constexpr double u = unit_roundoff;

// Where the pairs of the four generators l, r, s, e stand, so that the products of the first two,
// of the next and of the last are the a, b and c of cotangency_of().
constexpr int I[6] = {0, 2, 0, 1, 0, 1};
constexpr int J[6] = {1, 3, 2, 3, 3, 2};

// cotangency_of() the six tangencies of four generators: forms or bounds of them.
template <class P>
[[gnu::always_inline]] inline auto cotangency_of_pairs(const P (&p)[6]) {
  return cotangency_of(p[0] * p[1], p[2] * p[3], p[4] * p[5]);
}

// The error of all its coefficients where those of the tangencies have these bounds.
Lanes cotangency_error(const Bound<Lanes> (&tangencies)[6]) {
  const Bound<Lanes> f = cotangency_of_pairs(tangencies);
  return (f.err + u * (80 * f.size)) * bound_up + 1e-290;
}

// The bits of a set strictly between its lowest and its highest.
unsigned inside(unsigned bits) {
  return bits == 0 ? 0 : (std::bit_floor(bits) - 1) & ~((bits & -bits) * 2 - 1);
}

constexpr std::array<int, 9> scale = binomials<8>();

// Whether every tangency is positive, between a disk and the container negative, over the whole
// time: p within its bound, coefficient by coefficient.
LaneMask separated(const Lanes (&radius)[4], const Form<Lanes, 2> (&p)[6],
                   const Bound<Lanes> (&bound)[6]) {
  LaneMask all = ~LaneMask{};
  for (int k = 0; k < 6; ++k) {
    const LaneMask wall = (radius[I[k]] < 0) ^ (radius[J[k]] < 0);
    for (int i = 0; i < 3; ++i) {
      const Lanes limit = (i == 1 ? 2 : 1) * bound[k].err * bound_up;
      all &= (wall & (p[k].c[i] < -limit)) | (~wall & (p[k].c[i] > limit));
    }
  }
  return all;
}

// A tangency on each lane, at one time.
struct Tangency {
  Lanes value;
  Bound<Lanes> bound;
};

// The lanes with these numbers, from 4 on of b.
template <int... lane>
Lanes lanes_of(const Lanes& a, const Lanes& b) {
  return __builtin_shufflevector(a, b, lane...);
}
template <int... lane>
Tangency lanes_of(const Tangency& a, const Tangency& b) {
  return {
      lanes_of<lane...>(a.value, b.value),
      {lanes_of<lane...>(a.bound.size, b.bound.size), lanes_of<lane...>(a.bound.err, b.bound.err)}};
}
Lanes exchanged(const Lanes& halves) { return lanes_of<2, 3, 0, 1>(halves, halves); }

}  // namespace

// Four generators on each lane, over an interval [a, b] of each.
//
// Error bound. A coordinate at an end of the interval is x + v dt: dt, the product and the sum are
// rounded once each, which is below 4u times all the magnitudes together, and the motion's own
// errors add ex + ev |dt|; ex is that of the radius as well. The rest is by the rules of Bound.
struct RootlessBatch::Window {
  Window(const std::array<MotionLanes, 4>& generators, const Lanes& a, const Lanes& b);

  Lanes x1[4], y1[4];         // at b
  Lanes radius[4], error[4];  // error: of a coordinate and the radius
  Lanes speed[4];             // at most
  Lanes end;                  // b
  Form<Lanes, 2> p[6];        // the tangencies of the pairs I, J
  Lanes far[6], dr[6];        // of these: |x| + |y| at most, and |r|
};

[[gnu::always_inline]] inline RootlessBatch::Window::Window(
    const std::array<MotionLanes, 4>& generators, const Lanes& a, const Lanes& b)
    : end(b) {
  Lanes x0[4], y0[4];
  for (int i = 0; i < 4; ++i) {
    const MotionLanes& g = generators[i];
    const Lanes ta = a - g.t, tb = b - g.t;
    x0[i] = g.x + g.vx * ta;
    y0[i] = g.y + g.vy * ta;
    x1[i] = g.x + g.vx * tb;
    y1[i] = g.y + g.vy * tb;
    radius[i] = g.r;
    speed[i] = abs(g.vx) + abs(g.vy) + g.ev;
    const Lanes size = abs(g.x) + abs(g.y) + abs(x0[i]) + abs(y0[i]) + abs(x1[i]) + abs(y1[i]);
    error[i] = 4 * u * size + g.ex + g.ev * (abs(ta) + abs(tb));
  }
  for (int k = 0; k < 6; ++k) {
    const int i = I[k], j = J[k];
    const Form<Lanes, 1> x{{x0[i] - x0[j], x1[i] - x1[j]}}, y{{y0[i] - y0[j], y1[i] - y1[j]}};
    const Lanes r = radius[i] - radius[j];
    p[k] = tangency_of(x, y, Form<Lanes, 0>{{r}});
    far[k] = larger(abs(x.c[0]) + abs(y.c[0]), abs(x.c[1]) + abs(y.c[1]));
    dr[k] = abs(r);
  }
}

int most_roots(unsigned above, unsigned below) {
  if (above == 0 || below == 0) return 0;
  return ((above & inside(below)) | (below & inside(above))) != 0 ? 2 : 1;
}

void RootlessBatch::prove() {
  found_.assign(spans_.size(), Found::nothing);
  end_signs_.resize(spans_.size());
  for (std::size_t k = 0; k < spans_.size(); k += kLanes) {
    const std::size_t count = std::min(kLanes, spans_.size() - k);
    const std::array<const Span*, kLanes> of = lanes(k, count);
    const Lanes a{of[0]->a, of[1]->a, of[2]->a, of[3]->a};
    const Lanes b{of[0]->b, of[1]->b, of[2]->b, of[3]->b};
    judge(Window(gather(of), a, b), k, count);
  }
}

void RootlessBatch::prove_instant() {
  found_.assign(spans_.size(), Found::nothing);
  for (std::size_t k = 0; k < spans_.size(); k += kLanes) {
    const std::size_t count = std::min(kLanes, spans_.size() - k);
    judge_at(gather(lanes(k, count)), spans_[k].a, spans_[k].b, k, count);
  }
}

// The cotangency is the same function in whatever order the four are.

void RootlessBatch::prove_around(const Quad& q, const std::array<GenId, 4>& outer,
                                 const std::array<double, 4>& from, double a, double b) {
  found_.assign(kLanes, Found::nothing);
  end_signs_.resize(kLanes);
  const DoubleMotion &s = motion_.doubles(q.s), &e = motion_.doubles(q.e);
  const std::array<MotionLanes, 4> g{
      MotionLanes(motion_.doubles(q.l)), MotionLanes(motion_.doubles(q.r)), MotionLanes(e, e, s, s),
      MotionLanes(motion_.doubles(outer[0]), motion_.doubles(outer[1]), motion_.doubles(outer[2]),
                  motion_.doubles(outer[3]))};
  const Window window(g, load(from.data()), splat(b));
  judge(window, 0, kLanes);
  judge_flipped(window, a);
}

// The last of them again where there are fewer.
std::array<const RootlessBatch::Span*, RootlessBatch::kLanes> RootlessBatch::lanes(
    std::size_t first, std::size_t count) const {
  std::array<const Span*, kLanes> of{};
  for (std::size_t k = 0; k < kLanes; ++k) of[k] = &spans_[first + std::min(k, count - 1)];
  return of;
}

std::array<MotionLanes, 4> RootlessBatch::gather(const std::array<const Span*, kLanes>& of) const {
  const auto role = [&](GenId Quad::*id) {
    return MotionLanes(motion_.doubles(of[0]->q.*id), motion_.doubles(of[1]->q.*id),
                       motion_.doubles(of[2]->q.*id), motion_.doubles(of[3]->q.*id));
  };
  return {role(&Quad::l), role(&Quad::r), role(&Quad::s), role(&Quad::e)};
}

// The flip polynomials f of four quadruplets in the Bernstein basis of degree 8 over [a, b]:
// without a root where all coefficients have one sign, and with one at most where they change it
// once.
void RootlessBatch::judge(const Window& w, std::size_t first, std::size_t count) {
  Bound<Lanes> bound[6];
  for (int k = 0; k < 6; ++k) {
    bound[k] = tangency_bound<Lanes>(w.far[k], w.dr[k], w.error[I[k]] + w.error[J[k]]);
  }
  const Form<Lanes, 8> f = cotangency_of_pairs(w.p);
  const Lanes total = cotangency_error(bound);
  LaneMask positive = f.c[0] > total, negative = f.c[0] < -total;
  for (int k = 1; k < 9; ++k) {
    const Lanes limit = total * static_cast<double>(scale[k]);
    positive &= f.c[k] > limit;
    negative &= f.c[k] < -limit;
  }
  const LaneMask proved = positive | negative;
  for (std::size_t k = 0; k < count; ++k) {
    if (proved[k] != 0) found_[first + k] = Found::rootless;
  }
  if (!any(~proved)) return;
  const LaneMask asked = separated(w.radius, w.p, bound) & ~proved;
  for (std::size_t k = 0; k < count; ++k) {
    if (asked[k] != 0) count_roots(f, total, k, first + k);
  }
}

// Counts the roots by Descartes' rule for the coefficients of one lane, each within `total`: notes
// where there is at most one.
void RootlessBatch::count_roots(const Form<Lanes, 8>& f, const Lanes& total, std::size_t lane,
                                std::size_t k) {
  unsigned above = 0, below = 0;  // what is not a number may be both
  for (int i = 0; i < 9; ++i) {
    const double limit = total[lane] * scale[i];
    above |= (f.c[i][lane] < -limit ? 0U : 1U) << i;
    below |= (f.c[i][lane] > limit ? 0U : 1U) << i;
  }
  if (most_roots(above, below) > 1) return;
  found_[k] = Found::one_root;
  const bool up = (above >> 8) != 0, down = (below >> 8) != 0;
  end_signs_[k] = up && down ? Sign::unknown : up ? Sign::positive : Sign::negative;
}

// Judges the edges of prove_around() as they are when q has flipped, over [since, b]. Their four
// are s, e, one of l and r, and the outer one: of the tangencies at b two alone are not those of
// before. A coordinate moves by at most |v| + ev times the interval from where it is at b.
void RootlessBatch::judge_flipped(const Window& w, double since) {
  const Lanes length = w.end - since;
  Lanes error[4];
  for (int i = 0; i < 4; ++i) {
    error[i] = (w.error[i] + w.speed[i] * length) * bound_up + 1e-290;
  }
  Tangency before[6];
  for (int k = 0; k < 6; ++k) {
    before[k] = {w.p[k].c[2], tangency_bound<Lanes>(w.far[k], w.dr[k], error[I[k]] + error[J[k]])};
  }
  // On each lane: `own` is the one of s and e that the edge has before the flip and after it,
  // `other` the one that it gets. Of l and r it keeps r, l, l, r.
  constexpr int own_outer = 1, l_own = 2, r_outer = 3, l_outer = 4, r_own = 5;
  const Lanes x = exchanged(w.x1[2]), y = exchanged(w.y1[2]), r = exchanged(w.radius[2]);
  const auto with_other = [&](int i) -> Tangency {
    const Form<Lanes, 0> dx{{w.x1[i] - x}}, dy{{w.y1[i] - y}}, dr{{w.radius[i] - r}};
    return {tangency_of(dx, dy, dr).c[0],
            tangency_bound<Lanes>(abs(dx.c[0]) + abs(dy.c[0]), abs(dr.c[0]),
                                  error[i] + exchanged(error[2]))};
  };
  const Tangency after[6] = {
      with_other(2),     lanes_of<0, 5, 6, 3>(before[r_outer], before[l_outer]),
      before[own_outer], lanes_of<2, 7, 4, 1>(before[r_own], before[l_own]),
      with_other(3),     lanes_of<0, 5, 6, 3>(before[r_own], before[l_own])};
  Form<Lanes, 0> p[6];
  Bound<Lanes> bound[6];
  for (int k = 0; k < 6; ++k) {
    p[k] = {{after[k].value}};
    bound[k] = after[k].bound;
  }
  const LaneMask proved = abs(cotangency_of_pairs(p).c[0]) > cotangency_error(bound);
  for (std::size_t k = 0; k < kLanes; ++k) flipped_[k] = proved[k] != 0;
}

// Judges at one time with an uncertainty: the polynomials are constants. A coordinate moves by at
// most |v| + ev times half the interval from where it is at the middle.
void RootlessBatch::judge_at(const std::array<MotionLanes, 4>& generators, double a, double b,
                             std::size_t first, std::size_t count) {
  const DoubleBall hull = DoubleBall::hull(a, b);
  Lanes x[4], y[4], radius[4], error[4];
  for (int i = 0; i < 4; ++i) {
    const MotionLanes& g = generators[i];
    const Lanes dt = hull.mid - g.t;
    x[i] = g.x + g.vx * dt;
    y[i] = g.y + g.vy * dt;
    radius[i] = g.r;
    const Lanes size = abs(g.x) + abs(g.y) + abs(x[i]) + abs(y[i]);
    const Lanes speed = abs(g.vx) + abs(g.vy) + g.ev;
    error[i] = (4 * u * size + g.ex + g.ev * abs(dt) + speed * hull.rad) * (1 + 0x1p-40) + 1e-290;
  }
  Form<Lanes, 0> p[6];
  Bound<Lanes> bound[6];
  for (int k = 0; k < 6; ++k) {
    const int i = I[k], j = J[k];
    const Form<Lanes, 0> dx{{x[i] - x[j]}}, dy{{y[i] - y[j]}}, dr{{radius[i] - radius[j]}};
    p[k] = tangency_of(dx, dy, dr);
    bound[k] =
        tangency_bound<Lanes>(abs(dx.c[0]) + abs(dy.c[0]), abs(dr.c[0]), error[i] + error[j]);
  }
  const LaneMask proved = abs(cotangency_of_pairs(p).c[0]) > cotangency_error(bound);
  for (std::size_t k = 0; k < count; ++k) {
    if (proved[k] != 0) found_[first + k] = Found::rootless;
  }
}

}  // namespace voroproof::internal
