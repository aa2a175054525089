#include "filtered/collapse.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "exact/dual.h"
#include "filtered/bernstein.h"
#include "filtered/newton_step.h"

namespace voroproof {

ExactTime time_of(const Tower& t) {
  if (t.is_rational()) return ExactTime(t.rational());
  // The root of x - t, between binary64 neighbours made distinct.
  const auto [lo, hi] = double_interval(t);
  constexpr double inf = std::numeric_limits<double>::infinity();
  return ExactTime(
      Polynomial<Tower>{-t, Tower(1)},
      RootInterval{to_rational(std::nextafter(lo, -inf)), to_rational(std::nextafter(hi, inf))});
}

std::array<GenId, 3> disk_first(GenId a, GenId b, GenId c) {
  if (a != container_id) return {a, b, c};
  return {b, c, a};
}

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// What becomes of the edge at an isolated root: seen from a time just after it.
enum class Verdict { collapses, stays, unknown };

// Signs of the two in-circle functions of a quadruplet whose sites are given at one
// time, f the sign of their cotangency there; and of the existence of both circles,
// sites given perhaps over an interval.
template <class T>
struct EdgeSigns {
  Sign end_in_start, start_in_end;  // e in (l,s,r), s in (r,e,l)
};

template <class T>
TangentTriple<T> triple_of(const std::array<GenId, 3>& v, const Site<T>& a, const Site<T>& b,
                           const Site<T>& c) {
  // a, b, c in the order of the vertex before disk_first.
  const bool container = v[1] == container_id || v[2] == container_id;
  return {a, b, c, container};
}

template <class T>
struct EdgeTriples {
  TangentTriple<T> start, end;
  static EdgeTriples of(const Quad& q, const std::array<Site<T>, 4>& at) {
    const auto pick = [&](GenId a, const Site<T>& sa, GenId b, const Site<T>& sb, GenId c,
                          const Site<T>& sc) {
      const auto v = disk_first(a, b, c);
      return a != container_id ? triple_of(v, sa, sb, sc) : triple_of(v, sb, sc, sa);
    };
    return {pick(q.l, at[0], q.s, at[2], q.r, at[1]), pick(q.r, at[1], q.e, at[3], q.l, at[0])};
  }
};

// Reads the verdict off the signs just after the root. Both circles must exist from
// the root to that time: `exist` is evaluated over the whole interval.
template <class T, class SitesAfter>
Verdict judge(const Quad& q, const std::array<Site<T>, 4>& at_hull, SitesAfter&& sites_after,
              Sign f_after) {
  const EdgeTriples<T> hull = EdgeTriples<T>::of(q, at_hull);
  const Sign start_exists = circle_exists(hull.start);
  if (start_exists == Sign::negative) return Verdict::stays;
  const Sign end_exists = circle_exists(hull.end);
  if (end_exists == Sign::negative) return Verdict::stays;
  const auto in_start = [&](const EdgeTriples<T>& t, const std::array<Site<T>, 4>& at) {
    return incircle(t.start, at[3], q.e == container_id, f_after);
  };
  const auto in_end = [&](const EdgeTriples<T>& t, const std::array<Site<T>, 4>& at) {
    return incircle(t.end, at[2], q.s == container_id, f_after);
  };
  // Near the root of a generic quadruplet the factor that decides is far from zero,
  // so the hull will do; equal radii need the time after the root.
  Sign a = in_start(hull, at_hull);
  Sign b = in_end(hull, at_hull);
  if (a == Sign::unknown || b == Sign::unknown) {
    if (!keeps_tangencies(at_hull)) return Verdict::unknown;
    const std::array<Site<T>, 4> at_after = sites_after();
    const EdgeTriples<T> after = EdgeTriples<T>::of(q, at_after);
    a = in_start(after, at_after);
    b = in_end(after, at_after);
  }
  if (a == Sign::positive || b == Sign::positive) {
    return start_exists == Sign::positive && end_exists == Sign::positive ? Verdict::stays
                                                                          : Verdict::unknown;
  }
  if (a == Sign::negative && b == Sign::negative && start_exists == Sign::positive &&
      end_exists == Sign::positive) {
    return Verdict::collapses;
  }
  return Verdict::unknown;
}

template <class T>
std::array<Site<T>, 4> sites(const Motion& m, const Quad& q, const T& t) {
  return {m.site(q.l, t), m.site(q.r, t), m.site(q.s, t), m.site(q.e, t)};
}

// The sign of f just after a root of the flip polynomial phi, whose sign there is s:
// phi is f itself, or C where f = -C^2.
Sign cotangency_sign(Sign s, bool cocircular) { return cocircular ? Sign::negative : s; }

Site<double> plain_site(const Motion& motion, GenId g, double t) {
  const DoubleMotion& m = motion.doubles(g);
  const double dt = t - m.t;
  return {m.x + m.vx * dt, m.y + m.vy * dt, m.r};
}

Verdict judge_in_doubles(const Motion& m, const Quad& q, double after, Sign f) {
  const std::array<Site<double>, 4> at{plain_site(m, q.l, after), plain_site(m, q.r, after),
                                       plain_site(m, q.s, after), plain_site(m, q.e, after)};
  return judge(
      q, at, [&] { return at; }, f);
}

// ---- The double tier: subdivision of one Bernstein form. ----

// Levels of de Casteljau's scheme: w[k] becomes at(w[k], w[k + 1]). The loops are unrolled by
// recursion on constants, so that w stays in registers.
template <int k, int last, class At>
[[gnu::always_inline]] inline void combine(double* w, const At& at) {
  if constexpr (k < last) {
    w[k] = at(w[k], w[k + 1]);
    combine<k + 1, last>(w, at);
  }
}

template <int degree, class At, class Then>
[[gnu::always_inline]] inline void each_level(double* w, const At& at, const Then& then) {
  if constexpr (degree > 0) {
    combine<0, degree>(w, at);
    then(std::integral_constant<int, degree - 1>());
    each_level<degree - 1>(w, at, then);
  }
}

template <int degree>
void halve(const double* c, double* left, double* right) {
  double w[degree + 1];
  for (int k = 0; k <= degree; ++k) w[k] = c[k];
  left[0] = w[0];
  right[degree] = w[degree];
  each_level<degree>(
      w, [](double a, double b) { return 0.5 * (a + b); },
      [&](auto rest) {
        left[degree - rest] = w[0];
        right[rest] = w[rest];
      });
}

void halve(int degree, const double* c, double* left, double* right) {
  degree == 8 ? halve<8>(c, left, right) : halve<4>(c, left, right);
}

// Value and derivative with respect to the parameter in [0, 1].
template <int degree>
double value(const double* c, double x, double& slope) {
  double w[degree + 1];
  for (int k = 0; k <= degree; ++k) w[k] = c[k];
  const double y = 1 - x;
  each_level<degree>(
      w, [&](double a, double b) { return y * a + x * b; },
      [&](auto rest) {
        if constexpr (rest == 1) slope = degree * (w[1] - w[0]);
      });
  return w[0];
}

double value(int degree, const double* c, double x, double& slope) {
  return degree == 8 ? value<8>(c, x, slope) : value<4>(c, x, slope);
}

struct Piece {
  double u0, u1;  // the part of the window
  std::array<double, 9> c;
};

// How many roots a piece has: 0, 1 (a simple one, with certain signs at both ends), or
// -1: not known yet.
int count_roots(const Piece& p, int degree, double err) {
  int variations = 0;
  int last = 0;
  int uncertain = 0;  // since the last certain sign
  for (int k = 0; k <= degree; ++k) {
    const int s = p.c[k] > err ? 1 : p.c[k] < -err ? -1 : 0;
    if (s == 0) {
      if (k == 0 || k == degree) return -1;
      ++uncertain;
      continue;
    }
    if (last != 0) {
      if (s != last) {
        // One uncertain coefficient between different signs changes nothing.
        if (uncertain > 1) return -1;
        ++variations;
      } else if (uncertain > 0) {
        return -1;
      }
    }
    last = s;
    uncertain = 0;
  }
  return variations <= 1 ? variations : -1;
}

constexpr int kMaxDepth = 24;

struct DoubleRoot {
  double lo, hi;    // times; the only root of the piece lies between
  double piece_hi;  // end of the piece, as a time
  Sign after;       // of the polynomial beyond the root
};

// The times of a piece's parameters; rounding moves them by less than `slack`.
struct TimeMap {
  double a, width, slack;
  TimeMap(double from, double to)
      : a(from), width(to - from), slack(4 * 0x1p-53 * (std::fabs(from) + std::fabs(to))) {}
  double operator()(double x) const { return a + width * x; }
};

// Narrows the root of a piece. False where the ends of the piece are too near.
bool narrow(const Piece& p, int degree, double err, const TimeMap& time, DoubleRoot& root) {
  double xl = 0, xr = 1;
  const double sl = p.c[0];
  const double fl = std::fabs(p.c[0]), fr = std::fabs(p.c[degree]);
  double x = fl / (fl + fr);
  double slope = 0;
  for (int step = 0; step < 60; ++step) {
    const double f = value(degree, p.c.data(), x, slope);
    if (std::fabs(f) <= err) break;
    ((f > 0) == (sl > 0) ? xl : xr) = x;
    const double newton = f / slope;
    if (std::fabs(newton) < 0x1p-44) break;
    const double next = x - newton;
    x = next > xl && next < xr ? next : 0.5 * (xl + xr);
  }
  const double width = p.u1 - p.u0;
  double delta = 8 * err / std::fabs(slope) + 0x1p-42;
  for (int attempt = 0; attempt < 4; ++attempt, delta *= 64) {
    const double a = std::fmax(x - delta, xl), b = std::fmin(x + delta, xr);
    double unused = 0;
    const double fa = a > 0 ? value(degree, p.c.data(), a, unused) : p.c[0];
    const double fb = b < 1 ? value(degree, p.c.data(), b, unused) : p.c[degree];
    if (!((sl > 0 ? fa : -fa) > err) || !((sl > 0 ? fb : -fb) < -err)) continue;
    root.lo = time(p.u0 + width * a) - time.slack;
    root.hi = time(p.u0 + width * b) + time.slack;
    root.piece_hi = time(p.u1) - time.slack;
    root.after = sl > 0 ? Sign::negative : Sign::positive;
    return root.lo > time(p.u0) + time.slack && root.hi < root.piece_hi;
  }
  return false;
}

// Roots of the form, first to last: calls `on_root(root)`, which says whether to go
// on. Returns the time up to which everything is decided: the end of the window
// unless the search was stopped or a piece cannot be decided.
template <class OnRoot>
double each_root(const BernsteinForm& form, double start, double end, OnRoot&& on_root) {
  const TimeMap time(start, end);
  Piece stack[kMaxDepth + 2];
  int top = 0;
  stack[0] = {0, 1, form.c};
  while (top >= 0) {
    const int roots = count_roots(stack[top], form.degree, form.err);
    if (roots == 0) {
      --top;
      continue;
    }
    if (roots == 1) {
      const Piece piece = stack[top];
      --top;
      DoubleRoot root;
      if (!narrow(piece, form.degree, form.err, time, root)) {
        return piece.u0 == 0 ? start : time(piece.u0) - time.slack;
      }
      if (!on_root(root)) return root.lo;
      continue;
    }
    const Piece piece = stack[top];
    if (piece.u1 - piece.u0 < 0x1p-23) {
      return piece.u0 == 0 ? start : time(piece.u0) - time.slack;
    }
    const double mid = 0.5 * (piece.u0 + piece.u1);
    stack[top].u0 = mid;
    stack[top].u1 = piece.u1;
    stack[top + 1].u0 = piece.u0;
    stack[top + 1].u1 = mid;
    halve(form.degree, piece.c.data(), stack[top + 1].c.data(), stack[top].c.data());
    ++top;
  }
  return end;
}

// ---- The double-double and ball tiers: the same subdivision, value by value. ----

struct MakeDd {
  DdBall operator()(const Rational& q) const {
    const double hi = voroproof::round_nearest(q);
    const Rational rest = q - to_rational(hi);
    const double lo = voroproof::round_nearest(rest);
    const Rational left = rest - to_rational(lo);
    return {hi, lo,
            sgn(left) == 0 ? 0.0 : std::fabs(lo) * 0x1p-52 + std::numeric_limits<double>::min()};
  }
  // A ball around the interval.
  DdBall hull(const Rational& lo, const Rational& hi) const {
    DdBall m = (*this)(Rational((lo + hi) / 2));
    m.rad = (m.rad + voroproof::round_up(Rational((hi - lo) / 2))) * (1 + 0x1p-50);
    return m;
  }
};

struct MakeBall {
  int bits;
  Ball operator()(const Rational& q) const { return Ball(q, bits); }
  Ball hull(const Rational& lo, const Rational& hi) const {
    Ball m(Rational((lo + hi) / 2), bits);
    const Rational half = (hi - lo) / 2;
    if (sgn(half) > 0) {
      // 2^e >= half, from the sizes of numerator and denominator.
      const long e = static_cast<long>(mpz_sizeinbase(half.get_num_mpz_t(), 2)) -
                     static_cast<long>(mpz_sizeinbase(half.get_den_mpz_t(), 2)) + 1;
      m.widen(Magnitude::power_of_two(e));
    }
    return m;
  }
};

template <class T>
using Coefficients = std::vector<T>;

// Product of two polynomials in the scaled Bernstein basis.
template <class T>
Coefficients<T> multiply(const Coefficients<T>& p, const Coefficients<T>& q) {
  std::vector<std::optional<T>> r(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      T term = p[i] * q[j];
      auto& slot = r[i + j];
      slot = slot ? *slot + term : term;
    }
  }
  Coefficients<T> out;
  out.reserve(r.size());
  for (auto& slot : r) out.push_back(std::move(*slot));
  return out;
}

template <class T>
Coefficients<T> subtract(Coefficients<T> p, const Coefficients<T>& q) {
  for (std::size_t k = 0; k < p.size(); ++k) p[k] = p[k] - q[k];
  return p;
}

// The flip polynomial over [a, b], unscaled Bernstein coefficients.
template <class T, class Make>
Coefficients<T> form_in(const Motion& motion, const Quad& q, const Rational& a, const Rational& b,
                        bool cocircular, const Make& make) {
  const std::array<Site<T>, 4> s0 = sites(motion, q, make(a));
  const std::array<Site<T>, 4> s1 = sites(motion, q, make(b));
  const T two = make(2);
  const auto tangency2 = [&](int i, int j) {
    const T ax = s0[i].x - s0[j].x, ay = s0[i].y - s0[j].y;
    const T bx = s1[i].x - s1[j].x, by = s1[i].y - s1[j].y;
    const T dr = s0[i].r - s0[j].r;
    const T dr2 = dr * dr;
    return Coefficients<T>{ax * ax + ay * ay - dr2, two * (ax * bx + ay * by - dr2),
                           bx * bx + by * by - dr2};
  };
  Coefficients<T> f;
  if (cocircular) {
    const auto term = [&](int k, int i, int j) {
      const T x0i = s0[i].x - s0[3].x, y0i = s0[i].y - s0[3].y;
      const T x1i = s1[i].x - s1[3].x, y1i = s1[i].y - s1[3].y;
      const T x0j = s0[j].x - s0[3].x, y0j = s0[j].y - s0[3].y;
      const T x1j = s1[j].x - s1[3].x, y1j = s1[j].y - s1[3].y;
      return multiply(
          tangency2(k, 3),
          Coefficients<T>{x0i * y0j - y0i * x0j, (x0i * y1j - y0i * x1j) + (x1i * y0j - y1i * x0j),
                          x1i * y1j - y1i * x1j});
    };
    f = term(0, 1, 2);
    for (const auto& t : {term(1, 2, 0), term(2, 0, 1)}) {
      for (std::size_t k = 0; k < f.size(); ++k) f[k] = f[k] + t[k];
    }
  } else {
    const auto ta = multiply(tangency2(0, 1), tangency2(2, 3));
    const auto tb = multiply(tangency2(0, 2), tangency2(1, 3));
    const auto tc = multiply(tangency2(0, 3), tangency2(1, 2));
    const auto g = subtract(subtract(ta, tb), tc);
    auto bc = multiply(tb, tc);
    const T four = make(4);
    for (T& c : bc) c = c * four;
    f = subtract(multiply(g, g), bc);
  }
  const int degree = static_cast<int>(f.size()) - 1;
  long binomial = 1;
  for (int k = 0; k <= degree; ++k) {
    if (binomial != 1) f[k] = f[k] * make(Rational(1, binomial));
    binomial = binomial * (degree - k) / (k + 1);
  }
  return f;
}

template <class T>
void halve_in(const Coefficients<T>& c, const T& half, Coefficients<T>& left,
              Coefficients<T>& right) {
  Coefficients<T> w = c;
  const std::size_t degree = c.size() - 1;
  left.assign(1, w[0]);
  right.assign(c.size(), w[degree]);
  for (std::size_t level = 1; level <= degree; ++level) {
    for (std::size_t k = 0; k + level <= degree; ++k) w[k] = half * (w[k] + w[k + 1]);
    left.push_back(w[0]);
    right[degree - level] = w[degree - level];
  }
}

template <class T>
int count_roots_in(const Coefficients<T>& c) {
  int variations = 0;
  Sign last = Sign::unknown;
  int uncertain = 0;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const Sign s = sign(c[k]);
    if (s == Sign::unknown || s == Sign::zero) {
      if (k == 0 || k + 1 == c.size()) return -1;
      ++uncertain;
      continue;
    }
    if (last != Sign::unknown) {
      if (s != last) {
        if (uncertain > 1) return -1;
        ++variations;
      } else if (uncertain > 0) {
        return -1;
      }
    }
    last = s;
    uncertain = 0;
  }
  return variations <= 1 ? variations : -1;
}

// The answer of a tier that may give up: then it is decided up to `reached` only.
struct Attempt {
  bool decided = false;
  Collapse answer;
  Rational reached;
};

Collapse make_root(const Rational& lo, const Rational& hi) {
  Collapse c;
  c.kind = Collapse::Kind::root;
  c.lo = voroproof::round_down(lo);
  c.hi = voroproof::round_up(hi);
  c.fine = std::make_shared<RootInterval>(RootInterval{lo, hi});
  return c;
}

Collapse none_until(double t) {
  Collapse c;
  c.kind = Collapse::Kind::none;
  c.lo = c.hi = t;
  return c;
}

// Of an edge whose start circle touches e too: whether the contact points of r, e, l follow each
// other counterclockwise (positive) or not (negative). Only in that order are both circles of the
// edge one, and the edge a point. Two circles may touch all four and the edge lead from one to the
// other: mirror images in pairs are always such. `t` may be an interval.
Sign contact_order(const Motion& motion, const Quad& q, const Ball& t) {
  const std::array<Site<Ball>, 4> at = sites(motion, q, t);
  const std::array<Ball, 3> circle = tangent_circle(EdgeTriples<Ball>::of(q, at).start);
  std::array<Ball, 2> direction[3];
  for (int k = 0; k < 3; ++k) {
    const Site<Ball>& s = at[k == 0 ? 1 : k == 1 ? 3 : 0];
    const Ball reach = circle[2] + s.r;
    direction[k] = {(s.x - circle[0]) / reach, (s.y - circle[1]) / reach};
  }
  const auto& [r, e, l] = direction;
  return sign((e[0] - r[0]) * (l[1] - r[1]) - (e[1] - r[1]) * (l[0] - r[0]));
}

// Of four generators that stay cotangent, perhaps only with the circle of the other kind: both
// in-circle signs tell, at a time t of the interval. nullopt: not decided.
std::optional<Collapse> while_cotangent(const Motion& motion, const Quad& q,
                                        const std::array<Sign, 2>& s, const Ball& t) {
  const bool cotangent = s[0] == Sign::zero && s[1] == Sign::zero;
  const bool in_conflict = s[0] == Sign::negative && s[1] == Sign::negative;
  if (!in_conflict && (!cotangent || legal_while_cotangent(q))) return none_until(kInfinity);
  if (cotangent) {
    const Sign order = contact_order(motion, q, t);
    if (order == Sign::negative) return none_until(kInfinity);
    if (order != Sign::positive) return std::nullopt;
  }
  Collapse illegal;
  illegal.kind = Collapse::Kind::now;
  return illegal;
}

// Searches [start, end]; a root that is not certainly later than `now` is left to the
// exact tier. `max_halvings` bounds the depth.
template <class T, class Make>
Attempt search_in(const Motion& motion, const Quad& q, const Rational& start, const Rational& end,
                  const Instant* now, int max_halvings, const Make& make) {
  const bool cocircular = flip_polynomial_is_cocircularity(motion, q);
  struct Part {
    Rational a, b;
    Coefficients<T> c;
    int depth;
  };
  std::vector<Part> stack;
  stack.push_back({start, end, form_in<T>(motion, q, start, end, cocircular, make), 0});
  const T half = make(Rational(1, 2));
  while (!stack.empty()) {
    Part part = std::move(stack.back());
    stack.pop_back();
    const int roots = count_roots_in(part.c);
    if (roots == 0) continue;
    if (roots == 1) {
      // Narrow until the verdict is known.
      const Sign before = sign(part.c.front());
      for (;;) {
        const T hull = make.hull(part.a, part.b);
        const auto at_hull = sites(motion, q, hull);
        const auto after = [&] { return sites(motion, q, make(part.b)); };
        const Verdict verdict = judge(q, at_hull, after, cotangency_sign(-before, cocircular));
        const bool near_now = now != nullptr && part.a <= to_rational(now->hi);
        if (verdict == Verdict::stays && !near_now) break;
        if (verdict == Verdict::collapses && !near_now &&
            voroproof::round_up(part.b) - voroproof::round_down(part.a) <
                1e-6 * (1 + std::fabs(voroproof::round_down(part.a)))) {
          return {true, make_root(part.a, part.b), {}};
        }
        if (++part.depth > max_halvings) return {false, {}, part.a};
        Coefficients<T> left, right;
        halve_in(part.c, half, left, right);
        const Sign middle = sign(right.front());
        const Rational m = (part.a + part.b) / 2;
        if (middle == before) {
          part.a = m;
          part.c = std::move(right);
        } else if (middle == -before) {
          part.b = m;
          part.c = std::move(left);
        } else {
          return {false, {}, part.a};
        }
      }
      continue;
    }
    if (++part.depth > max_halvings) return {false, {}, part.a};
    const Rational m = (part.a + part.b) / 2;
    Part right{m, part.b, {}, part.depth};
    Part left{part.a, m, {}, part.depth};
    halve_in(part.c, half, left.c, right.c);
    stack.push_back(std::move(right));
    stack.push_back(std::move(left));
  }
  return {true, none_until(voroproof::round_down(end)), {}};
}

// ---- The exact tier. ----

std::array<Site<Polynomial<Tower>>, 4> paths(const Quad& q, ExactMotion& exact) {
  std::array<Site<Polynomial<Tower>>, 4> out;
  const GenId ids[4] = {q.l, q.r, q.s, q.e};
  for (int k = 0; k < 4; ++k) {
    const ExactMotion::State& s = exact.state(ids[k]);
    const Tower t(s.t_ref);
    out[k] = {Polynomial<Tower>{s.x - s.vx * t, s.vx}, Polynomial<Tower>{s.y - s.vy * t, s.vy},
              Polynomial<Tower>{exact.radius(ids[k])}};
  }
  return out;
}

bool equal_radii(const Quad& q, ExactMotion& exact) {
  const Tower r = exact.radius(q.l);
  return exact.radius(q.r) == r && exact.radius(q.s) == r && exact.radius(q.e) == r;
}

Polynomial<Tower> flip_polynomial(const Quad& q, ExactMotion& exact) {
  const auto p = paths(q, exact);
  return equal_radii(q, exact) ? cocircularity(p[3], p[0], p[1], p[2])
                               : cotangency(p[0], p[1], p[2], p[3]);
}

std::array<Site<Tower>, 4> exact_sites(const Quad& q, const Rational& t, ExactMotion& exact) {
  const Tower at(t);
  return {exact.site(q.l, at), exact.site(q.r, at), exact.site(q.s, at), exact.site(q.e, at)};
}

// Narrowing an isolated root did not show what becomes of its edge there.
class RootTooBlurred : public std::runtime_error {
 public:
  RootTooBlurred(const std::string& what, int bits)
      : std::runtime_error(what + ": " + std::to_string(bits) + " bits of its time do not tell") {}
};

// Both in-circle signs at an exact time at which the circles exist.
std::array<Sign, 2> exact_incircles(const Quad& q, const Rational& t, ExactMotion& exact) {
  const auto at = exact_sites(q, t, exact);
  const auto triples = EdgeTriples<Tower>::of(q, at);
  const Sign f = sign(cotangency(at[0], at[1], at[2], at[3]));
  return {incircle(triples.start, at[3], q.e == container_id, f),
          incircle(triples.end, at[2], q.s == container_id, f)};
}

std::array<Sign, 2> exact_existence(const Quad& q, const Rational& t, ExactMotion& exact) {
  const auto at = exact_sites(q, t, exact);
  const auto triples = EdgeTriples<Tower>::of(q, at);
  return {circle_exists(triples.start), circle_exists(triples.end)};
}

}  // namespace

namespace {

// The flip polynomial and its derivative in time, at moving sites.
template <class T>
struct ValueAndSlope {
  T value, slope;
};

template <class T>
ValueAndSlope<T> cotangency_and_slope(const std::array<MovingSite<T>, 4>& s) {
  struct Pair {
    T p, d;
  };
  const auto pair = [&](int i, int j) {
    const T dx = s[i].x - s[j].x, dy = s[i].y - s[j].y, dr = s[i].r - s[j].r;
    const T h = dx * (s[i].vx - s[j].vx) + dy * (s[i].vy - s[j].vy);
    return Pair{dx * dx + dy * dy - dr * dr, h + h};
  };
  const auto product = [](const Pair& a, const Pair& b) {
    return Pair{a.p * b.p, a.p * b.d + a.d * b.p};
  };
  const Pair a = product(pair(0, 1), pair(2, 3));
  const Pair b = product(pair(0, 2), pair(1, 3));
  const Pair c = product(pair(0, 3), pair(1, 2));
  const T g = a.p - b.p - c.p;
  const T gd = a.d - b.d - c.d;
  const T bc = b.p * c.p;
  const T bcd = b.p * c.d + b.d * c.p;
  const T bc2 = bc + bc, bcd2 = bcd + bcd, ggd = g * gd;
  return {g * g - (bc2 + bc2), ggd + ggd - (bcd2 + bcd2)};
}

template <class T>
ValueAndSlope<T> cocircularity_and_slope(const std::array<MovingSite<T>, 4>& s) {
  struct Row {
    T x, y, vx, vy, p, d;
  };
  const auto row = [&](int i) {
    const T x = s[i].x - s[3].x, y = s[i].y - s[3].y;
    const T vx = s[i].vx - s[3].vx, vy = s[i].vy - s[3].vy;
    const T h = x * vx + y * vy;
    return Row{x, y, vx, vy, x * x + y * y, h + h};
  };
  const std::array<Row, 3> r{row(0), row(1), row(2)};
  const auto term = [&](int k, int i, int j) {
    const T cross = r[i].x * r[j].y - r[i].y * r[j].x;
    const T slope = (r[i].vx * r[j].y - r[i].vy * r[j].x) + (r[i].x * r[j].vy - r[i].y * r[j].vx);
    return ValueAndSlope<T>{r[k].p * cross, r[k].p * slope + r[k].d * cross};
  };
  const auto a = term(0, 1, 2), b = term(1, 2, 0), c = term(2, 0, 1);
  return {a.value + b.value + c.value, a.slope + b.slope + c.slope};
}

template <class T>
ValueAndSlope<T> flip_value_and_slope(const Motion& m, const Quad& q, const T& t, bool cocircular) {
  const std::array<MovingSite<T>, 4> s{m.moving_site(q.l, t), m.moving_site(q.r, t),
                                       m.moving_site(q.s, t), m.moving_site(q.e, t)};
  return cocircular ? cocircularity_and_slope(s) : cotangency_and_slope(s);
}

template <class T>
T flip_value(const Motion& m, const Quad& q, const T& t, bool cocircular) {
  const auto s = sites(m, q, t);
  // The base is the last site, as in cocircularity_and_slope: another base may turn the sign.
  return cocircular ? cocircularity(s[3], s[0], s[1], s[2]) : cotangency(s[0], s[1], s[2], s[3]);
}

}  // namespace

// The first tier, of a form whose coefficients are not all of one sign. Undecided where
// the filter cannot say what happens just after the start; undecided parts further on
// wait for their turn (`none` up to there).
std::optional<Collapse> CollapseSearch::filter(const Quad& q, const BernsteinForm& form,
                                               double start, double end) const {
  std::optional<Collapse> answer;
  bool decided = true;
  const double reached = each_root(form, start, end, [&](const DoubleRoot& root) {
    const DoubleBall hull = DoubleBall::hull(root.lo, root.hi);
    const auto at_hull = sites(motion_, q, hull);
    const auto after = [&] { return sites(motion_, q, DoubleBall(root.hi)); };
    const Verdict verdict = judge(q, at_hull, after, cotangency_sign(root.after, form.degree == 4));
    if (verdict == Verdict::stays) return true;
    decided = verdict == Verdict::collapses;
    if (decided) answer = Collapse{Collapse::Kind::root, root.lo, root.hi, nullptr};
    return false;
  });
  if (answer) return answer;
  if (decided && reached == end) return none_until(end);
  if (reached - start > 0.05 * (end - start)) return none_until(reached);
  return std::nullopt;
}

Collapse CollapseSearch::after(const Quad& q, double start, double end, const RootInterval* fine) {
  if (q.s == q.e || at_relative_rest(q)) return none_until(kInfinity);  // Lemma 8
  if (fine != nullptr) return slow(q, fine->hi, nullptr, end);
  if (!(start < end)) return none_until(end);
  if (!motion_.options().filters) return slow(q, to_rational(start), nullptr, end);
  BernsteinForm form;
  std::optional<Collapse> answer;
  if (form_flip_polynomial<true>(motion_, q, start, end, form)) {
    answer = none_until(end);
  } else {
    answer = filter(q, form, start, end);
  }
  if (!answer) {
    const double near = start + 0x1p-5 * (end - start);
    if (start < near && form_flip_polynomial<true>(motion_, q, start, near, form)) {
      answer = none_until(near);
    }
  }
  if (!answer) return slow(q, to_rational(start), nullptr, end);
  counts_.count(Predicate::flip_search, Tier::filter);
  return *answer;
}

Collapse CollapseSearch::from(const Quad& q, const Instant& now, double end) {
  if (q.s == q.e) return none_until(kInfinity);
  if (at_relative_rest(q)) return at_rest(q, now);
  if (now.lo < end && motion_.options().filters) {
    BernsteinForm form;
    std::optional<Collapse> answer;
    if (form_flip_polynomial<true>(motion_, q, now.lo, end, form)) {
      answer = none_until(end);
    } else if (std::fabs(form.c[0]) > form.err) {
      answer = filter(q, form, now.lo, end);
      if (answer && !(answer->lo > now.hi)) answer.reset();
    }
    if (answer) {
      counts_.count(Predicate::flip_search, Tier::filter);
      return *answer;
    }
  }
  return slow(q, to_rational(now.lo), &now, end);
}

bool CollapseSearch::at_relative_rest(const Quad& q) const {
  return motion_.same_velocity(q.l, q.r) && motion_.same_velocity(q.l, q.s) &&
         motion_.same_velocity(q.l, q.e);
}

bool CollapseSearch::has_rational_motion(const Quad& q) const {
  return motion_.is_rational(q.l) && motion_.is_rational(q.r) && motion_.is_rational(q.s) &&
         motion_.is_rational(q.e);
}

// Four generators at rest relative to each other: the edge is legal for good unless
// they are cotangent now and the rule of the largest id is against it.
Collapse CollapseSearch::at_rest(const Quad& q, const Instant& now) {
  const Collapse legal = none_until(kInfinity);
  if (legal_while_cotangent(q)) return legal;
  if (sign(flip_value(motion_, q, DoubleBall::hull(now.lo, now.hi), false)) != Sign::unknown) {
    counts_.count(Predicate::flip_search, Tier::filter);
    return legal;
  }
  if (sign(flip_value(motion_, q, now.dd, false)) != Sign::unknown) {
    counts_.count(Predicate::flip_search, Tier::dd);
    return legal;
  }
  try {
    ExactMotion exact(motion_);
    const auto s = exact_incircles(q, to_rational(now.hi), exact);
    counts_.count(Predicate::flip_search, Tier::exact);
    if (s[0] != Sign::zero || s[1] != Sign::zero) return legal;
  } catch (const BudgetExceeded& e) {
    throw Undecided(std::string("four generators at relative rest may be cotangent: ") + e.what(),
                    q);
  }
  const Ball t(to_rational(now.hi), motion_.goal_bits() + 32);
  const auto answer = while_cotangent(motion_, q, {Sign::zero, Sign::zero}, t);
  if (!answer) throw Undecided("the order of four generators on their circle is not decided", q);
  return *answer;
}

Collapse CollapseSearch::slow(const Quad& q, const Rational& start, const Instant* now,
                              double end) {
  const Rational finish = std::max<Rational>(to_rational(end), start + Rational(1, 1L << 40));
  Attempt attempt;
  // Generators that look cotangent at the instant mostly are. Nothing but the exact tier can say
  // so, and while their motion is rational it is quick.
  const bool exact_first = motion_.options().filters && now != nullptr && has_rational_motion(q) &&
                           sign(flip_value(motion_, q, now->dd, false)) == Sign::unknown;
  if (motion_.options().filters && !exact_first) {
    attempt = search_in<DdBall>(motion_, q, start, finish, now, 48, MakeDd{});
    if (!attempt.decided) {
      // What is hard later in the window can wait: an event may come first.
      const double from = now != nullptr ? now->hi : voroproof::round_up(start);
      const double reached = voroproof::round_down(attempt.reached);
      attempt.decided = reached - from > 0.01 * (end - from);
      attempt.answer = none_until(reached);
    }
    if (attempt.decided) {
      counts_.count(Predicate::flip_search, Tier::dd);
      return attempt.answer;
    }
  }
  if (const auto answer = by_symmetry(q, start, now, end)) return *answer;
  std::string budget;
  for (bool tried_exact = false;;) {
    if (tried_exact || !exact_first) {
      const int bits = motion_.goal_bits() + 32;
      attempt =
          search_in<Ball>(motion_, q, start, finish, now, std::min(bits / 2, 512), MakeBall{bits});
      if (attempt.decided) {
        counts_.count(Predicate::flip_search, Tier::ball);
        return attempt.answer;
      }
    }
    if (!tried_exact) {
      tried_exact = true;
      try {
        const Collapse c = exactly(q, start, now, end);
        counts_.count(Predicate::flip_search, Tier::exact);
        return c;
      } catch (const BudgetExceeded& e) {
        budget = e.what();
      } catch (const RootTooBlurred& e) {
        budget = e.what();
      }
    }
    if (!motion_.raise_precision()) {
      throw Undecided("the next flip of an edge is not decided with " +
                          std::to_string(motion_.options().max_bits) + " bits; exactly: " + budget,
                      q);
    }
  }
}

namespace {

// What becomes of an edge whose four generators touch one circle at an instant of the hull, in the
// rest of the hull: the slopes of its in-circle functions tell, if both circles exist and are the
// one that is touched. (The flip polynomial itself may have a double root, where two circles that
// touch three of them touch the fourth.)
Verdict departs(const Motion& motion, const Quad& q, const Ball& hull, bool every_circle) {
  const std::array<Site<Ball>, 4> at = sites(motion, q, hull);
  const EdgeTriples<Ball> circles = EdgeTriples<Ball>::of(q, at);
  const Sign start_exists = circle_exists(circles.start), end_exists = circle_exists(circles.end);
  if (start_exists == Sign::negative || end_exists == Sign::negative) return Verdict::stays;
  if (start_exists != Sign::positive || end_exists != Sign::positive || !keeps_tangencies(at)) {
    return Verdict::unknown;
  }
  if (!every_circle) {
    const Sign a = incircle(circles.start, at[3], q.e == container_id, Sign::zero);
    const Sign b = incircle(circles.end, at[2], q.s == container_id, Sign::zero);
    if (a == Sign::positive || b == Sign::positive) return Verdict::stays;
    if (a != Sign::zero || b != Sign::zero) return Verdict::unknown;
  }
  std::array<Site<Dual<Ball>>, 4> moving;
  const GenId ids[4] = {q.l, q.r, q.s, q.e};
  for (int k = 0; k < 4; ++k) {
    const MovingSite<Ball> m = motion.moving_site(ids[k], hull);
    moving[k] = {{m.x, m.vx}, {m.y, m.vy}, {m.r, Ball()}};
  }
  const EdgeTriples<Dual<Ball>> triples = EdgeTriples<Dual<Ball>>::of(q, moving);
  const Sign a = sign(incircle_value(triples.start, moving[3], q.e == container_id).slope);
  const Sign b = sign(incircle_value(triples.end, moving[2], q.s == container_id).slope);
  if (a == Sign::positive || b == Sign::positive) return Verdict::stays;
  if (a != Sign::negative || b != Sign::negative) return Verdict::unknown;
  const Sign order = contact_order(motion, q, hull);
  return order == Sign::negative   ? Verdict::stays
         : order == Sign::positive ? Verdict::collapses
                                   : Verdict::unknown;
}

}  // namespace

// Where the four are cotangent for good, or at the present instant, and symmetry proves it.
std::optional<Collapse> CollapseSearch::by_symmetry(const Quad& q, const Rational& start,
                                                    const Instant* now, double end) {
  if (has_rational_motion(q)) return std::nullopt;
  const Symmetry symmetry(motion_);
  if (symmetry.always_cotangent(symmetry.states(q))) {
    const Rational t = now != nullptr ? to_rational(now->hi) : start;
    const auto answer =
        while_cotangent(motion_, q, {Sign::zero, Sign::zero}, Ball(t, motion_.goal_bits() + 32));
    if (answer) counts_.count(Predicate::flip_search, Tier::symmetry);
    return answer;
  }
  if (now == nullptr || !now->known) return std::nullopt;
  const auto proved = symmetry.cotangency(symmetry.states(q), now->known(), now->lo, now->hi);
  if (proved == Symmetry::Cotangency::unknown) return std::nullopt;
  const bool every_circle =
      proved == Symmetry::Cotangency::every_circle || flip_polynomial_is_cocircularity(motion_, q);
  const MakeBall make{motion_.goal_bits() + 32};
  // As far beyond the instant as the signs are certain: a search is dear next to a root.
  const Rational last =
      std::max<Rational>(to_rational(end) - to_rational(now->hi), Rational(1, 1L << 40));
  for (int k = 4; k <= 60; k += 4) {
    const Rational beyond = to_rational(now->hi) + last / (Integer(1) << k);
    const Verdict verdict =
        departs(motion_, q, make.hull(to_rational(now->lo), beyond), every_circle);
    if (verdict == Verdict::unknown) continue;
    counts_.count(Predicate::flip_search, Tier::symmetry);
    if (verdict == Verdict::stays) return slow(q, beyond, nullptr, end);
    Collapse answer;
    answer.kind = Collapse::Kind::now;
    return answer;
  }
  return std::nullopt;
}

Collapse CollapseSearch::exactly(const Quad& q, const Rational& start, const Instant* now,
                                 double end) {
  ExactMotion exact(motion_);
  const Polynomial<Tower> phi = flip_polynomial(q, exact);
  const Rational finish = std::max<Rational>(to_rational(end), start);
  if (phi.is_zero()) {
    const Rational t = now != nullptr ? Rational(to_rational(now->hi)) : start;
    const auto answer = while_cotangent(motion_, q, exact_incircles(q, t, exact),
                                        Ball(t, motion_.goal_bits() + 32));
    if (!answer) {
      throw Undecided("four generators stay cotangent, in an order that is not decided", q);
    }
    return *answer;
  }
  Collapse answer;
  answer.kind = Collapse::Kind::now;
  // To which a root is narrowed so that its circles show whether they exist and which they touch.
  const int least = motion_.goal_bits() + 32;
  const int most = std::max(least, motion_.options().max_bits / 8);
  const Rational beyond = finish + 1;
  std::vector<ExactTime> roots = real_roots(phi, start, beyond);
  std::optional<ExactTime> instant;
  if (now != nullptr) instant = now->exact(exact);
  for (std::size_t k = 0; k < roots.size(); ++k) {
    const auto order = instant ? compare(roots[k], *instant) : compare(roots[k], start);
    if (order < 0) continue;
    if (order == 0 && !instant) continue;  // the search starts at a root: beyond it
    // A rational time after this root and before the next; near the root: later on the
    // generators may overlap.
    const Rational hair(Integer(1), Integer(1) << 64);
    const auto after_root = [&]() -> Rational {
      if (!roots[k].is_point()) return roots[k].interval().hi;
      const Rational next = k + 1 < roots.size() ? roots[k + 1].interval().lo : beyond;
      return std::min<Rational>((roots[k].interval().lo + next) / 2, roots[k].interval().lo + hair);
    };
    // The same before it, after the root before and after the start and the instant.
    const auto before_root = [&]() -> Rational {
      const Rational at = roots[k].interval().lo;
      if (!roots[k].is_point()) return at;
      const Rational last = k > 0 ? roots[k - 1].interval().hi : start;
      Rational t = std::max<Rational>((at + last) / 2, at - hair);
      while (instant && compare(*instant, t) >= 0) t = (t + at) / 2;
      return t;
    };
    // Whether both circles of the edge are in conflict after the root, and one at it.
    const auto shrinks = [&]() {
      const auto s = exact_incircles(q, after_root(), exact);
      if (s[0] != Sign::negative || s[1] != Sign::negative) return false;
      for (int bits = least;; bits *= 2) {
        const RootInterval& at = roots[k].interval();
        const Sign contacts = contact_order(motion_, q, MakeBall{bits}.hull(at.lo, at.hi));
        if (contacts == Sign::positive || contacts == Sign::negative) {
          return contacts == Sign::positive;
        }
        if (bits > most) throw RootTooBlurred("the order of the contacts at a flip", bits);
        roots[k].refine(Rational(Integer(1), Integer(1) << bits));
      }
    };
    if (order == 0) {
      roots[k].refine(hair);
      if (shrinks()) return answer;
      continue;
    }
    // Later: does the edge collapse here? Narrow until both circles certainly
    // exist, or one certainly does not, all the way from the root.
    if (compare(roots[k], finish) > 0) break;
    // Where that takes many bits it can wait: an event may come before the root.
    const double from = now != nullptr ? now->hi : voroproof::round_up(start);
    Verdict verdict = Verdict::unknown;
    for (int bits = 64; verdict == Verdict::unknown; bits *= 2) {
      const double reached = voroproof::round_down(before_root());
      const bool can_wait = reached > from;
      if (can_wait && bits > 256) return none_until(reached);
      if (bits > most) {
        throw RootTooBlurred("a circle through three generators may become a line at the flip",
                             most);
      }
      roots[k].refine(Rational(Integer(1), Integer(1) << bits));
      std::array<Sign, 2> exists;
      if (roots[k].is_point()) {
        exists = exact_existence(q, roots[k].interval().lo, exact);
        if (exists[0] == Sign::zero || exists[1] == Sign::zero) {
          if (can_wait) return none_until(reached);
          throw Undecided("a circle through three generators becomes a line at a flip", q);
        }
      } else {
        const MakeBall make{2 * bits};
        const auto at =
            sites(motion_, q, make.hull(roots[k].interval().lo, roots[k].interval().hi));
        const auto triples = EdgeTriples<Ball>::of(q, at);
        exists = {circle_exists(triples.start), circle_exists(triples.end)};
      }
      if (exists[0] == Sign::negative || exists[1] == Sign::negative) {
        verdict = Verdict::stays;
      } else if (exists[0] == Sign::positive && exists[1] == Sign::positive) {
        verdict = shrinks() ? Verdict::collapses : Verdict::stays;
      }
    }
    if (verdict == Verdict::collapses) {
      // A root that is a point needs an interval all the same: it may not be an end.
      return make_root(before_root(), after_root());
    }
  }
  return none_until(voroproof::round_down(finish));
}

DdBall CollapseSearch::refine(const Quad& q, double lo, double hi) const {
  // One step of the interval Newton method: the root lies in c - f(c) / f'([lo, hi]).
  const bool cocircular = flip_polynomial_is_cocircularity(motion_, q);
  const double c = 0.5 * (lo + hi);
  if (!cocircular) {
    const DdBall root = newton_step(motion_, q, lo, hi);
    if (root.rad < kInfinity) return root;
  }
  const DoubleBall slope =
      flip_value_and_slope(motion_, q, DoubleBall::hull(lo, hi), cocircular).slope;
  const DdBall f = flip_value(motion_, q, DdBall(c), cocircular);
  return DdBall(c) - f / DdBall(slope.mid, 0, slope.rad);
}

Ball CollapseSearch::refine(const Quad& q, const Rational& lo, const Rational& hi, int bits) const {
  const bool cocircular = flip_polynomial_is_cocircularity(motion_, q);
  const MakeBall make{bits};
  Rational a = lo, b = hi;
  Ball root = make.hull(a, b);
  const Sign at_lo = sign(flip_value(motion_, q, make(lo), cocircular));
  const Sign at_hi = sign(flip_value(motion_, q, make(hi), cocircular));
  // Of a root of even order the polynomial tells nothing; next to one of high order the precision
  // may not tell an end of the interval from it.
  if (at_lo == Sign::unknown || at_lo == Sign::zero || at_hi != -at_lo) return root;
  for (;;) {
    const Rational middle = (a + b) / 2;
    const Ball center(middle, bits);
    const Ball f = flip_value(motion_, q, center, cocircular);
    const Ball slope = flip_value_and_slope(motion_, q, make.hull(a, b), cocircular).slope;
    const Ball next = center - f / slope;
    if (sign(slope) != Sign::unknown && next.radius().scaled(2) < root.radius()) {
      // The interval Newton method gains at least two bits.
      root = next;
      Rational mid, rad = 1;
      mpfr_get_q(mid.get_mpq_t(), root.midpoint());
      const long e = static_cast<long>(root.radius().exponent()) + 1;
      if (e >= 0) {
        rad <<= static_cast<unsigned long>(e);
      } else {
        rad >>= static_cast<unsigned long>(-e);
      }
      a = std::max<Rational>(a, mid - rad);
      b = std::min<Rational>(b, mid + rad);
      if (!(a < b)) return root;
    } else {
      // Not monotone enough yet, or at the limit of the precision: bisect.
      const Sign s = sign(f);
      if (s == at_lo) {
        a = middle;
      } else if (s == -at_lo && s != Sign::unknown) {
        b = middle;
      } else {
        return root;
      }
      root = make.hull(a, b);
    }
  }
}

ExactTime CollapseSearch::exact_root(const Quad& q, const Rational& lo, const Rational& hi,
                                     ExactMotion& exact) {
  if (lo == hi) return ExactTime(lo);
  const Polynomial<Tower> phi = flip_polynomial(q, exact);
  return ExactTime(phi, RootInterval{lo, hi});
}

Collapse collapse_in_doubles(const Motion& motion, const Quad& q, double start, double end) {
  if (q.s == q.e) return none_until(kInfinity);
  if (!(start < end)) return none_until(end);
  BernsteinForm form;
  if (form_flip_polynomial<false>(motion, q, start, end, form)) return none_until(end);
  Collapse answer;
  const double reached = each_root(form, start, end, [&](const DoubleRoot& root) {
    if (judge_in_doubles(motion, q, root.hi, cotangency_sign(root.after, form.degree == 4)) !=
        Verdict::collapses) {
      return true;
    }
    answer = {Collapse::Kind::root, root.lo, root.hi, nullptr};
    return false;
  });
  if (answer.kind == Collapse::Kind::root) return answer;
  // A root too near to the start to be told from it is passed over.
  return none_until(std::fmax(reached, start + 1e-7 * (end - start)));
}

}  // namespace voroproof
