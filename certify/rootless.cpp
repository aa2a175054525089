#include "certify/rootless.h"

#include <algorithm>
#include <array>
#include <bit>

#include "exact/predicates.h"
#include "exact/rounding.h"
#include "filtered/motion/motion_lanes.h"
#include "filtered/motion/window_places.h"
#include "filtered/numbers/bound.h"

namespace voroproof::internal {

namespace {

constexpr double u = unit_roundoff;

// Where the pairs of the four generators l, r, s, e stand, so that the products of the first two,
// of the next and of the last are the a, b and c of cotangency_of().
constexpr int I[6] = {0, 2, 0, 1, 0, 1};
constexpr int J[6] = {1, 3, 2, 3, 3, 2};

// cotangency_of() the six tangencies of four generators, which are forms.
template <class P>
[[gnu::always_inline]] inline auto cotangency_of_pairs(const P (&p)[6]) {
  return cotangency_of(p[0] * p[1], p[2] * p[3], p[4] * p[5]);
}

// How far apart the four generators on a lane are, and how far each may be from where it is
// computed: one bound for all of them.
struct Extent {
  Lanes square{};  // dx^2 + dy^2 + dr^2 of two generators at an end of the window, at most
  Lanes error{};   // most error of a coordinate and a radius

  // A pair of generators with this tangency at most, and radii that differ by dr.
  void include(const Lanes& tangency, const Lanes& dr) {
    square = larger(square, tangency + 2 * (dr * dr));
  }

  // The error of the coefficients of every tangency, before they are multiplied by binomials.
  // |dx| + |dy| + |dr| is at most the square root of 3 dx^2 + 3 dy^2 + 3 dr^2.
  Lanes of_tangency() const {
    return tangency_bound_of<Lanes>(square_root(3 * square), square, 2 * error).err * bound_up;
  }
};

// The error of the coefficients of the cotangency, before they are multiplied by binomials. Those
// of the six tangencies are at most `size` in magnitude, and err by at most `err`.
Lanes cotangency_error(const Lanes (&size)[6], const Lanes& err) {
  const Lanes products = size[0] * size[1] + size[2] * size[3] + size[4] * size[5];
  const Lanes all = size[0] + size[1] + size[2] + size[3] + size[4] + size[5];
  const Bound<Lanes> f =
      cotangency_bound<Lanes>({products, err * (all + 3 * err) + (8 * u * products + bound_tiny)});
  return (f.err + u * (80 * f.size)) * bound_up + 1e-290;
}

// Whether the cotangency is not zero, the tangencies being constants.
LaneMask beyond_error(const Form<Lanes, 0> (&p)[6], const Extent& extent) {
  Lanes size[6];
  for (int k = 0; k < 6; ++k) size[k] = abs(p[k].c[0]);
  return abs(cotangency_of_pairs(p).c[0]) > cotangency_error(size, extent.of_tangency());
}

// The bits of a set strictly between its lowest and its highest.
unsigned inside(unsigned bits) {
  return bits == 0 ? 0 : (std::bit_floor(bits) - 1) & ~((bits & -bits) * 2 - 1);
}

constexpr std::array<int, 9> scale = binomials<8>();

// Whether every tangency is positive, between a disk and the container negative, over the whole
// time: p within the error, coefficient by coefficient.
LaneMask separated(const Lanes (&radius)[4], const Form<Lanes, 2> (&p)[6], const Lanes& err) {
  LaneMask all = ~LaneMask{};
  for (int k = 0; k < 6; ++k) {
    const LaneMask wall = (radius[I[k]] < 0) ^ (radius[J[k]] < 0);
    for (int i = 0; i < 3; ++i) {
      const Lanes limit = i == 1 ? 2 * err : err;
      all &= (wall & (p[k].c[i] < -limit)) | (~wall & (p[k].c[i] > limit));
    }
  }
  return all;
}

// The lanes with these numbers, from 4 on of b.
template <int... lane>
Lanes lanes_of(const Lanes& a, const Lanes& b) {
  return __builtin_shufflevector(a, b, lane...);
}
Lanes largest(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
  return larger(larger(a, b), larger(c, d));
}
Lanes exchanged(const Lanes& halves) { return lanes_of<2, 3, 0, 1>(halves, halves); }

}  // namespace

// Four generators on each lane, over an interval [a, b] of each. What is not a number stays that
// way in sizes, though it is lost where the larger of two is taken.
struct RootlessBatch::Window {
  using Places = WindowPlaces<Lanes>;

  Window(const std::array<MotionLanes, 4>& generators, const Lanes& a, const Lanes& b);

  Places at[4];
  Lanes radius[4];
  Lanes end;            // b
  Form<Lanes, 2> p[6];  // the tangencies of the pairs I, J
  Extent extent;
};

[[gnu::always_inline]] inline RootlessBatch::Window::Window(const std::array<MotionLanes, 4>& of,
                                                            const Lanes& a, const Lanes& b)
    : at{Places(of[0], a, b), Places(of[1], a, b), Places(of[2], a, b), Places(of[3], a, b)},
      radius{of[0].r, of[1].r, of[2].r, of[3].r},
      end(b) {
  extent.error = largest(at[0].error, at[1].error, at[2].error, at[3].error);
  for (int k = 0; k < 6; ++k) {
    const Places &i = at[I[k]], &j = at[J[k]];
    const Form<Lanes, 1> x{{i.x0 - j.x0, i.x1 - j.x1}}, y{{i.y0 - j.y0, i.y1 - j.y1}};
    const Lanes r = radius[I[k]] - radius[J[k]];
    p[k] = tangency_of(x, y, Form<Lanes, 0>{{r}});
    extent.include(larger(p[k].c[0], p[k].c[2]), r);
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
  Lanes size[6];
  for (int k = 0; k < 6; ++k) {
    const auto& c = w.p[k].c;
    size[k] = larger(abs(c[0]), abs(c[2])) + 0.5 * abs(c[1]);
  }
  const Lanes err = w.extent.of_tangency();
  const Form<Lanes, 8> f = cotangency_of_pairs(w.p);
  // Pays for the divisions by binomials, too.
  const Lanes total = cotangency_error(size, err);
  Lanes least = f.c[0], greatest = f.c[0];
  for (int k = 1; k < 9; ++k) {
    const Lanes c = f.c[k] * (1.0 / scale[k]);
    least = smaller(least, c);
    greatest = larger(greatest, c);
  }
  const LaneMask proved = (least > total) | (greatest < -total);
  for (std::size_t k = 0; k < count; ++k) {
    if (proved[k] != 0) found_[first + k] = Found::rootless;
  }
  if (!any(~proved)) return;
  const LaneMask asked = separated(w.radius, w.p, err) & ~proved;
  for (std::size_t k = 0; k < count; ++k) {
    if (asked[k] != 0) count_roots(f, total, k, first + k);
  }
}

// Counts the roots by Descartes' rule for the coefficients of one lane, each within `total`: notes
// where there is at most one.
void RootlessBatch::count_roots(const Form<Lanes, 8>& f, const Lanes& total, std::size_t lane,
                                std::size_t k) {
  unsigned above = 0, below = 0;  // a NaN may be both
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
  // On each lane: `own` is the one of s and e that the edge has before the flip and after it,
  // `other` the one that it gets. Of l and r it keeps r, l, l, r.
  constexpr int own_outer = 1, l_own = 2, r_outer = 3, l_outer = 4, r_own = 5;
  const auto before = [&](int k) -> const Lanes& { return w.p[k].c[2]; };
  Extent extent = w.extent;
  const Lanes x = exchanged(w.at[2].x1), y = exchanged(w.at[2].y1), r = exchanged(w.radius[2]);
  const auto with_other = [&](int i) -> Lanes {
    const Form<Lanes, 0> dx{{w.at[i].x1 - x}}, dy{{w.at[i].y1 - y}}, dr{{w.radius[i] - r}};
    const Lanes p = tangency_of(dx, dy, dr).c[0];
    extent.include(p, dr.c[0]);
    return p;
  };
  const Form<Lanes, 0> p[6] = {
      {{with_other(2)}},     {{lanes_of<0, 5, 6, 3>(before(r_outer), before(l_outer))}},
      {{before(own_outer)}}, {{lanes_of<2, 7, 4, 1>(before(r_own), before(l_own))}},
      {{with_other(3)}},     {{lanes_of<0, 5, 6, 3>(before(r_own), before(l_own))}}};
  extent.square = larger(extent.square, exchanged(extent.square));
  extent.error +=
      largest(w.at[0].speed, w.at[1].speed, w.at[2].speed, w.at[3].speed) * (w.end - since);
  extent.error = larger(extent.error, exchanged(extent.error)) * bound_up + 1e-290;
  const LaneMask proved = beyond_error(p, extent);
  for (std::size_t k = 0; k < kLanes; ++k) flipped_[k] = proved[k] != 0;
}

// Judges at one time with an uncertainty: the polynomials are constants. A coordinate moves by at
// most |v| + ev times half the interval from where it is at the middle.
void RootlessBatch::judge_at(const std::array<MotionLanes, 4>& generators, double a, double b,
                             std::size_t first, std::size_t count) {
  const DoubleBall hull = DoubleBall::hull(a, b);
  const Lanes middle = splat(hull.mid);
  const WindowPlaces<Lanes> at[4] = {{generators[0], middle, middle},
                                     {generators[1], middle, middle},
                                     {generators[2], middle, middle},
                                     {generators[3], middle, middle}};
  Extent extent;
  extent.error = largest(at[0].error, at[1].error, at[2].error, at[3].error) +
                 largest(at[0].speed, at[1].speed, at[2].speed, at[3].speed) * hull.rad;
  extent.error = extent.error * bound_up + 1e-290;
  Form<Lanes, 0> p[6];
  for (int k = 0; k < 6; ++k) {
    const int i = I[k], j = J[k];
    const Form<Lanes, 0> dx{{at[i].x0 - at[j].x0}}, dy{{at[i].y0 - at[j].y0}};
    const Form<Lanes, 0> dr{{generators[i].r - generators[j].r}};
    p[k] = tangency_of(dx, dy, dr);
    extent.include(p[k].c[0], dr.c[0]);
  }
  const LaneMask proved = beyond_error(p, extent);
  for (std::size_t k = 0; k < count; ++k) {
    if (proved[k] != 0) found_[first + k] = Found::rootless;
  }
}

}  // namespace voroproof::internal
