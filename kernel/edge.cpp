#include "kernel/edge.h"

#include <algorithm>

namespace voroproof_kernel {
namespace {

constexpr int kUnknown = 2;
constexpr int kPairs[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
// Contact order of the two vertices' circles, then the fourth generator.
constexpr int kStart[4] = {0, 2, 1, 3}, kEnd[4] = {0, 1, 3, 2};

void add_product(Int& to, const Int& a, const Int& b) {
  boost::multiprecision::backends::eval_multiply_add(to.backend(), a.backend(), b.backend());
}

}  // namespace

Leg::Leg(const Rat& start_, const Vec& from_, const Vec& velocity_, const Rat& signed_radius)
    : start(start_), radius(signed_radius), from(from_), velocity(velocity_) {
  const Vec origin{Rat(from[0] - velocity[0] * start), Rat(from[1] - velocity[1] * start)};
  Int d = 1;
  for (const Rat& q : {origin[0], origin[1], velocity[0], velocity[1], radius}) {
    d = lcm(d, Int(denominator(q)));
  }
  shift = static_cast<unsigned>(lsb(d));
  odd = d >> shift;
  const auto scaled = [&](const Rat& q) { return Int(numerator(q) * (d / denominator(q))); };
  x = scaled(origin[0]);
  y = scaled(origin[1]);
  vx = scaled(velocity[0]);
  vy = scaled(velocity[1]);
  r = scaled(radius);
}

Vec Leg::at(const Rat& t) const {
  const Rat s = t - start;
  return {Rat(from[0] + velocity[0] * s), Rat(from[1] + velocity[1] * s)};
}

template <class T>
Circle<T>::Circle(const Site<T>& i, const Site<T>& j, const Site<T>& k) : base(i) {
  const T xj = j.x - i.x, yj = j.y - i.y, sj = j.r - i.r, pj = xj * xj + yj * yj - sj * sj;
  const T xk = k.x - i.x, yk = k.y - i.y, sk = k.r - i.r, pk = xk * xk + yk * yk - sk * sk;
  xp = xj * pk - pj * xk;
  yp = yj * pk - pj * yk;
  sp = sj * pk - pj * sk;
  xs = xj * sk - sj * xk;
  ys = yj * sk - sj * yk;
  xy = xj * yk - yj * xk;
}

template <class T>
T Circle<T>::g(const Site<T>& e) const {
  const T x = e.x - base.x, y = e.y - base.y, s = e.r - base.r, p = x * x + y * y - s * s;
  const T a = x * sp - s * xp + p * xs, b = y * sp - s * yp + p * ys;
  return xp * a + yp * b;
}

template <class T>
T Circle<T>::c(const Site<T>& e) const {
  const T x = e.x - base.x, y = e.y - base.y, s = e.r - base.r, p = x * x + y * y - s * s;
  return x * yp - y * xp + p * xy;
}

int sign_with_root(const Int& u, const Int& v, const Int& gamma) {
  const int a = sgn(u), b = gamma == 0 ? 0 : sgn(v);
  if (a == b || b == 0) return a;
  if (a == 0) return b;
  const Int rest = u * u - gamma * v * v;
  return sgn(rest) * a;
}

void Edge4::set(const Quad& quad, const std::array<const Leg*, 4>& legs) {
  quad_ = quad;
  legs_ = legs;
  const int id[4] = {quad.l, quad.r, quad.s, quad.e};
  wall_ = static_cast<int>(std::find(id, id + 4, container) - id);
  equal_ = true;
  for (const Leg* leg : legs) equal_ = equal_ && leg->radius == legs[0]->radius;
}

// The sites at a and at b as whole numbers on one scale: times the denominators of all.
void Edge4::place(const Rat& a, const Rat& b) {
  const Int da = denominator(a), db = denominator(b), d = da == db ? da : Int(lcm(da, db));
  const Int t[2] = {Int(numerator(a) * (d / da)), Int(numerator(b) * (d / db))};
  unsigned shift = 0;
  Int odd = 1;
  for (const Leg* leg : legs_) {
    shift = std::max(shift, leg->shift);
    if (leg->odd != 1 && leg->odd != odd) odd = lcm(odd, leg->odd);
  }
  for (int i = 0; i < 4; ++i) {
    const Leg& leg = *legs_[i];
    r_[i] = leg.r * d;
    for (int k = 0; k < 2; ++k) {
      x_[i][k] = leg.x * d;
      y_[i][k] = leg.y * d;
      add_product(x_[i][k], leg.vx, t[k]);
      add_product(y_[i][k], leg.vy, t[k]);
    }
    const Int scale = leg.odd == odd ? Int(1) : Int(odd / leg.odd);
    for (Int* n : {&x_[i][0], &x_[i][1], &y_[i][0], &y_[i][1], &r_[i]}) {
      if (scale != 1) *n *= scale;
      *n <<= shift - leg.shift;
    }
  }
}

void Edge4::tangencies() {
  Int dx[2], dy[2], s, s2;
  for (int n = 0; n < 6; ++n) {
    const int i = kPairs[n][0], j = kPairs[n][1];
    for (int k = 0; k < 2; ++k) {
      dx[k] = x_[i][k] - x_[j][k];
      dy[k] = y_[i][k] - y_[j][k];
    }
    s = r_[i] - r_[j];
    s2 = s * s;
    p_[n][1] = dx[0] * dx[1];
    add_product(p_[n][1], dy[0], dy[1]);
    p_[n][1] -= s2;
    p_[n][1] <<= 1;
    for (int k = 0; k < 2; ++k) {
      p_[n][2 * k] = dx[k] * dx[k];
      add_product(p_[n][2 * k], dy[k], dy[k]);
      p_[n][2 * k] -= s2;
    }
  }
}

// Whether all tangencies have their right sign in the closed interval, or at least inside.
Edge4::Separated Edge4::separated() {
  Separated all = Separated::yes;
  const int id[4] = {quad_.l, quad_.r, quad_.s, quad_.e};
  for (int n = 0; n < 6; ++n) {
    const bool wall = kPairs[n][0] == wall_ || kPairs[n][1] == wall_;
    const int sign = wall ? -1 : 1;
    const int c0 = sign * sgn(p_[n][0]), c1 = sign * sgn(p_[n][1]), c2 = sign * sgn(p_[n][2]);
    if (quad_.s == quad_.e && n == 5) continue;
    if (c0 > 0 && c1 >= 0 && c2 > 0) continue;
    const bool inside = c0 < 0 || c2 < 0 || (c0 == 0 && c1 == 0 && c2 == 0) ||
                        (c1 < 0 && p_[n][1] * p_[n][1] >= 4 * p_[n][0] * p_[n][2]);
    if (!inside && c0 > 0 && c2 > 0) continue;
    touched.insert({id[kPairs[n][0]], id[kPairs[n][1]]});
    if (inside)
      all = Separated::no;
    else if (all == Separated::yes)
      all = Separated::touching;
  }
  return all;
}

// f by Casey's theorem, C where the radii are equal, G where f vanishes identically.
const Form& Edge4::form() {
  always_ = false;
  std::array<Site<Form>, 4> site;
  if (equal_) {
    for (int i = 0; i < 4; ++i) {
      site[i] = {Form{x_[i][0], x_[i][1]}, Form{y_[i][0], y_[i][1]}, Form{r_[i], r_[i]}};
    }
    form_ = Circle<Form>(site[0], site[2], site[1]).c(site[3]);
    always_ = is_zero(form_);
    return form_;
  }
  constexpr int factors[3][2] = {{0, 5}, {1, 4}, {2, 3}};
  for (int n = 0; n < 3; ++n) {
    terms_[n].assign(5, 0);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        add_product(terms_[n][i + j], p_[factors[n][0]][i], p_[factors[n][1]][j]);
      }
    }
  }
  terms_[3].resize(5);
  for (int k = 0; k < 5; ++k) {
    terms_[3][k] = terms_[0][k] - terms_[1][k];
    terms_[3][k] -= terms_[2][k];
    terms_[2][k] *= -4;
  }
  form_.assign(9, 0);
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < i; ++j) add_product(form_[i + j], terms_[3][i], terms_[3][j]);
  }
  for (Int& c : form_) c <<= 1;
  for (int i = 0; i < 5; ++i) {
    add_product(form_[2 * i], terms_[3][i], terms_[3][i]);
    for (int j = 0; j < 5; ++j) add_product(form_[i + j], terms_[1][i], terms_[2][j]);
  }
  if (!is_zero(form_)) return form_;
  always_ = true;
  for (int i = 0; i < 4; ++i) {
    site[i] = {Form{x_[i][0], x_[i][1]}, Form{y_[i][0], y_[i][1]}, Form{r_[i], r_[i]}};
  }
  const int b = wall_ == 0 ? 2 : 0, j = wall_ == 0 ? 1 : 2, k = wall_ == 0 ? 0 : 1;
  form_ = Circle<Form>(site[b], site[j], site[k]).g(site[3]);
  return form_;
}

Form Edge4::roots_over(const Rat& a, const Rat& b) {
  place(a, b);
  tangencies();
  return form();
}

// The sites at a + (b - a) above / 2^depth.
void Edge4::sites_at(const Int& above, unsigned depth) {
  const Int whole = Int(1) << depth, below = whole - above;
  for (int i = 0; i < 4; ++i) {
    at_[i].x = x_[i][0] * below + x_[i][1] * above;
    at_[i].y = y_[i][0] * below + y_[i][1] * above;
    at_[i].r = r_[i] * whole;
  }
}

// The sign of q at the sites; of f there, if it is known.
int Edge4::incircle(bool start, int f) {
  const int* order = start ? kStart : kEnd;
  const int turn = order[0] == wall_ ? 1 : 0;
  const int i = order[turn], j = order[(turn + 1) % 3], k = order[(turn + 2) % 3], e = order[3];
  const Circle<Int> circle(at_[i], at_[j], at_[k]);
  const bool with_wall = j == wall_ || k == wall_;
  int g = 0, c = 0;
  if (f != -1) g = sgn(circle.g(at_[e]));
  if (f != 1) c = sgn(circle.c(at_[e])) * (with_wall ? -1 : 1);
  int q;
  if (f == kUnknown && g != c) {
    const auto p = [&](int m, int n) {
      const Int x = at_[m].x - at_[n].x, y = at_[m].y - at_[n].y, s = at_[m].r - at_[n].r;
      return Int(x * x + y * y - s * s);
    };
    const Int u = p(0, 1) * p(2, 3), v = p(0, 2) * p(1, 3), w = p(0, 3) * p(1, 2);
    const Int rest = u - v - w;
    f = sgn(Int(rest * rest - 4 * v * w));
  }
  if (f == kUnknown) {
    q = g;
  } else {
    q = f > 0 ? g : f < 0 ? c : g == c ? g : g == 0 ? c : c == 0 ? g : 0;
  }
  return e == wall_ ? -q : q;
}

// The sign of the first in-circle function. Where both vanish throughout, that of the rule of the
// largest id: the edge is there iff its dual joins the largest of the four to its opposite.
int Edge4::legal(int f) {
  const int q = incircle(true, f);
  if (q != 0 || !always_) return q;
  const int other = incircle(false, f);
  if (other != 0) return other;
  return std::max(quad_.l, quad_.r) > std::max(quad_.s, quad_.e) ? 1 : -1;
}

int Edge4::exists(bool start) const {
  const int* order = start ? kStart : kEnd;
  const int turn = order[0] == wall_ ? 1 : 0;
  const int i = order[turn], j = order[(turn + 1) % 3], k = order[(turn + 2) % 3];
  const Circle<Int> c(at_[i], at_[j], at_[k]);
  const Int u = c.xp * c.xs + c.yp * c.ys, gamma = c.xp * c.xp + c.yp * c.yp - c.sp * c.sp;
  if (gamma <= 0) return kTouching;
  return sign_with_root(u, j == wall_ || k == wall_ ? Int(-c.xy) : c.xy, gamma);
}

int Edge4::incircle_at(const Rat& t, bool start) {
  place(t, t);
  sites_at(0, 0);
  return incircle(start, kUnknown);
}

const Site<Int>* Edge4::sites(const std::array<const Leg*, 4>& legs, const Rat& t) {
  legs_ = legs;
  place(t, t);
  sites_at(0, 0);
  return at_;
}

int Edge4::existence_at(const Rat& t, bool start) {
  place(t, t);
  sites_at(0, 0);
  return exists(start);
}

std::optional<Collapse> Edge4::first_collapse(const Rat& a, const Rat& b, bool fresh) {
  if (quad_.s == quad_.e || a >= b) return std::nullopt;
  place(a, b);
  tangencies();
  const Separated apart = separated();
  if (apart == Separated::no) return between_contacts(a, b);
  struct Piece {
    Form form;
    Int k;
    unsigned depth;
    bool squarefree;
  };
  std::vector<Piece> pieces;
  std::optional<Collapse> found;
  const auto time = [&](const Int& k, unsigned depth) {
    return Rat(a + (b - a) * Rat(k, Int(Int(1) << depth)));
  };
  form();
  pieces.push_back({form_, 0, 0, false});
  while (!pieces.empty() && !found) {
    Piece piece = std::move(pieces.back());
    pieces.pop_back();
    const int roots = variations(piece.form);
    const unsigned d = piece.depth;
    if (roots == 0) {
      // Inside the piece q does not vanish: one point decides.
      int f = kUnknown;
      if (!always_ && equal_) f = -1;
      if (!always_ && !equal_ && !piece.squarefree) {
        f = 0;
        for (const Int& c : piece.form) f |= sgn(c);
      }
      sites_at(2 * piece.k + 1, d + 1);
      const int q = legal(f);
      if (q == 0) undecided("an in-circle function vanishes where it cannot");
      if (q < 0) found = Collapse{at(time(piece.k, d)), time(2 * piece.k + 1, d + 1)};
      continue;
    }
    if (roots == 1) {
      // A collapse makes q negative until the end of the piece.
      sites_at(piece.k, d);
      const int from = legal(kUnknown);
      sites_at(piece.k + 1, d);
      const int to = legal(kUnknown);
      if (from > 0 && to > 0) continue;
      if (from > 0 && to < 0) {
        const Rat lo = time(piece.k, d), hi = time(piece.k + 1, d);
        found = Collapse{{lo, hi, std::move(piece.form), lo, hi}, hi};
        continue;
      }
    }
    if (d >= 30 && !piece.squarefree) {
      piece.form = squarefree(piece.form);
      piece.squarefree = true;
      pieces.push_back(std::move(piece));
      continue;
    }
    if (d > 4000) undecided("an edge's polynomial cannot be divided further");
    Form left, right;
    halve(piece.form, left, right);
    pieces.push_back({std::move(right), 2 * piece.k + 1, d + 1, piece.squarefree});
    pieces.push_back({std::move(left), 2 * piece.k, d + 1, piece.squarefree});
  }
  if (fresh || apart == Separated::touching) {
    ++fresh_proofs;
    const Rat t = (a + (found ? found->at.lo : b)) / 2;
    if (t > a) {
      place(t, t);
      sites_at(0, 0);
      for (const bool start : {true, false}) {
        if (exists(start) <= 0 || incircle(start, kUnknown) < 0) {
          if (!found)
            found = Collapse{at(a), t};
          else
            found->at = at(a);
        }
      }
    }
  }
  return found;
}

// Tangencies are of the wrong sign for a while: the motion between those moments, each piece with a
// fresh proof. A tangency is convex: of two disks wrong between its roots, of the wall outside.
std::optional<Collapse> Edge4::between_contacts(const Rat& a, const Rat& b) {
  std::vector<std::array<Rat, 2>> good{{Rat(0), Rat(1)}};
  const auto cut = [&](const Rat& from, const Rat& to) {  // takes [from, to] away
    std::vector<std::array<Rat, 2>> rest;
    for (const auto& [lo, hi] : good) {
      if (from > lo) rest.push_back({lo, std::min(hi, from)});
      if (to < hi) rest.push_back({std::max(lo, to), hi});
    }
    good = std::move(rest);
  };
  for (int n = 0; n < 6; ++n) {
    // p = A u^2 + B u + C, u from 0 at a to 1 at b.
    const Int c = p_[n][0], b1 = p_[n][1] - 2 * c, a2 = c - p_[n][1] + p_[n][2];
    const bool wall = kPairs[n][0] == wall_ || kPairs[n][1] == wall_;
    const Int disc = b1 * b1 - 4 * a2 * c;
    if (a2 == 0) {  // at rest to each other
      if (wall ? c >= 0 : c <= 0) good.clear();
      continue;
    }
    if (disc < 0) {
      if (wall) good.clear();
      continue;
    }
    constexpr unsigned fine = 256;
    const Int root = sqrt(Int(disc << (2 * fine))), scale = (2 * a2) << fine;
    const Rat x_lo(Int(-(b1 << fine) - root - 1), scale), x_hi(Int(-(b1 << fine) - root), scale);
    const Rat y_lo(Int(-(b1 << fine) + root), scale), y_hi(Int(-(b1 << fine) + root + 1), scale);
    if (wall) {
      cut(-1, x_hi);
      cut(y_lo, 2);
    } else {
      cut(x_lo, y_hi);
    }
  }
  for (const auto& [lo, hi] : good) {
    if (lo >= hi) continue;
    if (auto found = first_collapse(a + (b - a) * lo, a + (b - a) * hi, lo > 0)) return found;
  }
  return std::nullopt;
}

// With w = (D_xp, D_yp) of the end vertex and d the direction from the common base to the start's
// circle, w x d = -sp (w x w1) - eps sqrt(Gamma) (w . w1) in terms of the start; the circles of
// both orientations lie on either side of w, the end's on the side of -eps of the end.
bool Edge4::one_circle(Instant& t) {
  const bool flip = wall_ == 0;
  const int b = flip ? 1 : 0, j1 = flip ? 0 : 2, k1 = flip ? 2 : 1, j2 = flip ? 3 : 1,
            k2 = flip ? 0 : 3;
  for (int round = 0; round < 200; ++round) {
    place(t.lo, t.hi);
    Site<Form> site[4];
    for (int i = 0; i < 4; ++i) {
      site[i] = {Form{x_[i][0], x_[i][1]}, Form{y_[i][0], y_[i][1]}, Form{r_[i], r_[i]}};
    }
    const Circle<Form> c1(site[b], site[j1], site[k1]), c2(site[b], site[j2], site[k2]);
    const int eps1 = j1 == wall_ || k1 == wall_ ? 1 : -1,
              eps2 = j2 == wall_ || k2 == wall_ ? 1 : -1;
    const Form u = c1.sp * (c1.xp * c2.yp - c1.yp * c2.xp);
    const Form v = c2.xp * c1.xp + c2.yp * c1.yp;
    const Form gamma = c1.xp * c1.xp + c1.yp * c1.yp - c1.sp * c1.sp;
    const Form norm = u * u - gamma * v * v;
    if (norm[0] != 0 && norm.back() != 0 && (t.is_point() || variations(norm) == 0)) {
      return sign_with_root(u[0], eps1 < 0 ? v[0] : Int(-v[0]), gamma[0]) == -eps2;
    }
    if (t.is_point()) break;
    t.refine();
  }
  undecided("whether two circles touch the same four");
}

std::optional<Collapse> Edge4::collapse_near(const Rat& a, const Rat& t) {
  // A bracket of 2^-37 with short ends.
  const Rat scaled = t * power_of_two(40);
  const Int middle = numerator(scaled) / denominator(scaled);
  const Rat lo = (middle - 4) * power_of_two(-40), hi = (middle + 5) * power_of_two(-40);
  if (a >= lo) return std::nullopt;
  place(a, hi);
  tangencies();
  if (separated() != Separated::yes || variations(form()) != 1 || always_) return std::nullopt;
  const int f = equal_ ? -1 : sgn(form_.back());
  if (f == 0) return std::nullopt;
  sites_at(1, 0);
  if (incircle(true, f) >= 0 || incircle(false, f) >= 0) return std::nullopt;
  place(lo, lo);
  sites_at(0, 0);
  if (incircle(true, kUnknown) <= 0) return std::nullopt;
  return Collapse{{lo, hi, form_, a, hi}, hi};
}

template struct Circle<Int>;

}  // namespace voroproof_kernel
