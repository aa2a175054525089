#include "certify/kernel/edge.h"

#include <algorithm>

namespace voroproof_kernel {
namespace {

// f by Casey's theorem, of the tangencies of lr, ls, le, rs, re, se.
template <class T>
T casey(const std::array<T, 6>& p) {
  const T u = p[0] * p[5], v = p[1] * p[4], w = p[2] * p[3], d = u - v - w;
  return d * d - (v + v) * (w + w);
}

constexpr int kPairs[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

// The circle of a vertex, [l,s,r] or [l,r,e], based on a disk.
template <class T>
Circle<T> circle(const std::array<Site<T>, 4>& s, const Quad& q, bool start) {
  const int j = start ? 2 : 1, k = start ? 1 : 3;
  return q.l == container ? Circle<T>(s[j], s[k], s[0]) : Circle<T>(s[0], s[j], s[k]);
}

// Four at a time, and the signs that their edge asks for.
class Now {
 public:
  Now(const Quad& quad, Sites sites) : quad_(quad), site_(std::move(sites)) {}
  Now(const Four& four, const Rat& t) : Now(four.quad, sites(four.legs, {t})[0]) {}

  // The sign of the in-circle function q; `f` is the sign of f there, if it is not 2.
  int incircle(bool start, int f = 2) const {
    const Circle<Int> circle = voroproof_kernel::circle(site_, quad_, start);
    const Site<Int>& e = site_[start ? 3 : 2];
    const int g = f == -1 ? 0 : sgn(circle.g(e)), c = f == 1 ? 0 : -eps(start) * sgn(circle.c(e));
    if (f == 2 && g != c) {
      std::array<Int, 6> p;
      for (int n = 0; n < 6; ++n) p[n] = tangency(site_[kPairs[n][0]] - site_[kPairs[n][1]]);
      f = sgn(casey(p));
    }
    const int q = g == c || f > 0 ? g : f < 0 ? c : g == 0 ? c : c == 0 ? g : 0;
    return (start ? quad_.e : quad_.s) == container ? -q : q;
  }

  // q of the start or, where both vanish throughout, the rule of the largest id: the edge is there
  // iff its dual joins the largest of the four to its opposite.
  int legal(int f, bool always) const {
    int q = incircle(true, f);
    if (q == 0 && always) q = incircle(false, f);
    if (q != 0 || !always) return q;
    return std::max(quad_.l, quad_.r) > std::max(quad_.s, quad_.e) ? 1 : -1;
  }

  int exists(bool start) const {
    const Circle<Int> c = circle(site_, quad_, start);
    const Int u = c.xp * c.xs + c.yp * c.ys, gamma = c.gamma();
    return gamma <= 0 ? 0 : sign_with_root(u, -eps(start) * c.xy, gamma);
  }

 private:
  int eps(bool start) const {
    const bool wall = quad_.l == container || quad_.r == container;
    return wall || (start ? quad_.s : quad_.e) == container ? 1 : -1;
  }

  Quad quad_;
  Sites site_;
};

// Four over an interval.
class Span {
 public:
  Span(const Four& four, const Rat& a, const Rat& b)
      : quad_(four.quad), ends_(sites(four.legs, {a, b})) {
    for (int n = 0; n < 6; ++n) {
      const auto [i, j] = kPairs[n];
      const Site<Int> u = ends_[0][i] - ends_[0][j], v = ends_[1][i] - ends_[1][j];
      p_[n] = {tangency(u), 2 * (u.x * v.x + u.y * v.y - u.r * v.r), tangency(v)};
    }
  }

  // The four at a + (b - a) k / 2^depth.
  Now at(const Int& k, unsigned depth) const {
    const Int rest = (Int(1) << depth) - k;
    const auto between = [&](const Int& u, const Int& v) { return rest * u + k * v; };
    Sites s;
    for (int i = 0; i < 4; ++i) {
      const Site<Int>&u = ends_[0][i], &v = ends_[1][i];
      s[i] = {between(u.x, v.x), between(u.y, v.y), between(u.r, v.r)};
    }
    return Now(quad_, std::move(s));
  }

  // Where the tangencies have their right signs: in [a, b], in (a, b), nowhere, or who knows.
  enum class Apart { yes, inside, no, unknown };
  Apart apart(std::set<int>& touched) const {
    bool all = true, inside = true, never = false;
    const int id[4] = {quad_.l, quad_.r, quad_.s, quad_.e};
    for (int n = 0; n < (quad_.s == quad_.e ? 5 : 6); ++n) {
      const int i = id[kPairs[n][0]], j = id[kPairs[n][1]], right = i < 0 || j < 0 ? -1 : 1;
      const Form& t = p_[n];
      const int roots = variations(t);
      const bool ends = sgn(t[0]) == right && sgn(t[2]) == right;
      if (ends && (roots == 0 || t[1] * t[1] < 4 * t[0] * t[2])) continue;
      touched.insert({i, j});
      all = false;
      inside = inside && roots == 0;
      never |= roots == 0 &&
               std::none_of(t.begin(), t.end(), [&](const Int& c) { return sgn(c) == right; });
    }
    return all ? Apart::yes : never ? Apart::no : inside ? Apart::inside : Apart::unknown;
  }

  // f by Casey's theorem, C where the radii are equal, G where f vanishes identically.
  Form polynomial() {
    const Sites& s = ends_[0];
    const bool equal = std::all_of(s.begin(), s.end(), [&](auto& one) { return one.r == s[0].r; });
    Form f = equal ? circle(forms(), quad_, true).c(forms()[3]) : casey(p_);
    always_ = is_zero(f);
    return always_ && !equal ? circle(forms(), quad_, true).g(forms()[3]) : f;
  }
  bool always() const { return always_; }
  std::array<Site<Form>, 4> forms() const {
    std::array<Site<Form>, 4> all;
    for (int i = 0; i < 4; ++i) {
      const Site<Int>&u = ends_[0][i], &v = ends_[1][i];
      all[i] = {{u.x, v.x}, {u.y, v.y}, {u.r, v.r}};
    }
    return all;
  }

 private:
  Quad quad_;
  std::vector<Sites> ends_;
  std::array<Form, 6> p_;
  bool always_ = false;
};

// f and a tangency may have one root.
constexpr int deepest_tangency = 512;

// The rules of docs/kernel.md, section 6, on pieces from left to right.
class Search {
 public:
  Search(const Four& four, Notes& notes, bool fresh) : four_(four), notes_(notes), fresh_(fresh) {}
  bool owes_proof() const { return fresh_; }

  std::optional<Collapse> first(const Rat& a, const Rat& b, int depth = 0) {
    Span span(four_, a, b);
    const Span::Apart apart = span.apart(notes_.touched);
    const bool left_out =
        apart == Span::Apart::no || (apart == Span::Apart::unknown && depth >= 64 &&
                                     (depth >= deepest_tangency || !may_collapse(span, a)));
    fresh_ |= left_out || apart == Span::Apart::inside;
    if (left_out) return {};
    if (apart != Span::Apart::unknown) {
      auto found = in_piece(span, {a, b - a}, span.polynomial(), 0, 0);
      if (fresh_) prove_anew(a, b, found);
      return found;
    }
    const Rat middle = (a + b) / 2;
    if (auto found = first(a, middle, depth + 1)) return found;
    return first(middle, b, depth + 1);
  }

 private:
  // However short the piece from a on is, the edge may collapse in it where f has a root, or at a.
  bool may_collapse(Span& span, const Rat& a) const {
    if (variations(span.polynomial()) != 0) return true;
    return four_.apart(a, a) && Now(four_, a).legal(2, span.always()) <= 0;
  }

  // The collapse in [k, k + 1] / 2^depth of the span, where the tangencies have their right signs.
  std::optional<Collapse> in_piece(const Span& span, const std::array<Rat, 2>& interval, Form f,
                                   const Int& k, unsigned depth) {
    const bool deep = depth >= 30, always = span.always();
    const auto time = [&](const Int& at, unsigned of) {
      return interval[0] + interval[1] * Rat(at, Int(1) << of);
    };
    if (depth == 30) f = squarefree(f);
    const int roots = variations(f);
    if (roots == 0) {
      // q does not vanish inside: one time decides. Where C stands for f, f is negative.
      int sign = always || deep ? 2 : f.size() < 9 ? -1 : 0;
      for (const Int& c : f) sign = sign == 0 ? sgn(c) : sign;
      const int q = span.at(2 * k + 1, depth + 1).legal(sign, always);
      if (q == 0) undecided("an in-circle function vanishes where it cannot");
      if (q > 0) return {};
      return Collapse{at(time(k, depth)), time(2 * k + 1, depth + 1)};
    }
    if (roots == 1) {
      // A collapse makes q negative until the end of the piece.
      const int from = span.at(k, depth).legal(2, always);
      const int to = span.at(k + 1, depth).legal(2, always);
      if (from > 0 && to > 0) return {};
      const Rat lo = time(k, depth), hi = time(k + 1, depth);
      if (from > 0 && to < 0) return Collapse{{lo, hi, four_, deep}, hi};
    }
    if (depth > 2000) undecided("an edge's polynomial cannot be divided further");
    const std::array<Form, 2> half = halves(f);
    if (auto found = in_piece(span, interval, half[0], 2 * k, depth + 1)) return found;
    return in_piece(span, interval, half[1], 2 * k + 1, depth + 1);
  }

  // Proves anew, after tangencies of the wrong sign, that both circles exist and are empty
  // somewhere before a collapse: soon, as the life may end long before b, the upper end of a
  // bracket. Where they are not, there is a collapse at a.
  void prove_anew(const Rat& a, const Rat& b, std::optional<Collapse>& found) {
    fresh_ = false;
    ++notes_.fresh_proofs;
    const Rat t = a + ((found ? found->at.lo : b) - a) * power(2, -20);
    if (t == a) return;
    const Now now(four_, t);
    for (const bool start : {true, false}) {
      if (now.exists(start) > 0 && now.incircle(start) >= 0) continue;
      found = Collapse{at(a), found ? found->after : t};
    }
  }

  const Four& four_;
  Notes& notes_;
  bool fresh_;  // a proof anew is due
};

}  // namespace

Leg::Leg(const Rat& start_, const Vec& from_, const Vec& velocity_, const Rat& radius_,
         std::size_t claim_)
    : start(start_), from(from_), velocity(velocity_), radius(radius_), claim(claim_), scale(1) {
  const Vec origin = at(0);
  Int* to[] = {&x, &y, &vx, &vy, &r};
  const Rat* of[] = {&origin[0], &origin[1], &velocity[0], &velocity[1], &radius};
  for (const Rat* q : of) scale = lcm(scale, denominator(*q));
  for (int k = 0; k < 5; ++k) *to[k] = numerator(*of[k]) * (scale / denominator(*of[k]));
}

std::vector<Sites> sites(const std::array<const Leg*, 4>& legs, const std::vector<Rat>& times) {
  Int scale = 1, d = 1;
  for (const Leg* leg : legs) scale = leg->scale == scale ? scale : lcm(scale, leg->scale);
  for (const Rat& t : times) d = lcm(d, denominator(t));
  std::vector<Int> scaled;
  for (const Rat& t : times) scaled.push_back(numerator(t) * (d / denominator(t)));
  std::vector<Sites> all(times.size());
  for (int i = 0; i < 4; ++i) {
    const Leg& leg = *legs[i];
    const Int by = scale / leg.scale, fine = d * by;
    const Int x = leg.x * fine, y = leg.y * fine, r = leg.r * fine;
    for (std::size_t k = 0; k < times.size(); ++k) {
      const Int t = scaled[k] * by;
      all[k][i] = {x + leg.vx * t, y + leg.vy * t, r};
    }
  }
  return all;
}

template <class T>
Circle<T>::Circle(const Site<T>& i, const Site<T>& j, const Site<T>& k) : base(i) {
  const Site<T> u = j - i, v = k - i;
  const T p = tangency(u), o = tangency(v);
  xp = u.x * o - p * v.x;
  yp = u.y * o - p * v.y;
  sp = u.r * o - p * v.r;
  xs = u.x * v.r - u.r * v.x;
  ys = u.y * v.r - u.r * v.y;
  xy = u.x * v.y - u.y * v.x;
}

template <class T>
T Circle<T>::g(const Site<T>& e) const {
  const Site<T> d = e - base;
  const T p = tangency(d);
  return xp * (d.x * sp - d.r * xp + p * xs) + yp * (d.y * sp - d.r * yp + p * ys);
}

template <class T>
T Circle<T>::c(const Site<T>& e) const {
  const Site<T> d = e - base;
  return d.x * yp - d.y * xp + tangency(d) * xy;
}

int sign_with_root(const Int& u, const Int& v, const Int& gamma) {
  const int a = sgn(u), b = gamma == 0 ? 0 : sgn(v);
  if (a == b || b == 0) return a;
  return a == 0 ? b : a * sgn(Int(u * u - gamma * v * v));
}

Form Four::polynomial(const Rat& a, const Rat& b) const { return Span(*this, a, b).polynomial(); }
int Four::incircle(const Rat& t, bool start) const { return Now(*this, t).incircle(start); }
int Four::exists(const Rat& t, bool start) const { return Now(*this, t).exists(start); }
bool Four::apart(const Rat& a, const Rat& b) const {
  std::set<int> unused;
  return Span(*this, a, b).apart(unused) == Span::Apart::yes;
}

Instant at(const Rat& t) { return {t, t}; }

Form Instant::form(const Rat& a, const Rat& b) const {
  const Form f = four.polynomial(a, b);
  return multiple ? squarefree(f) : f;
}

void Instant::split(const Rat& t) {
  if (variations(form(lo, t)) % 2 == 1) {
    hi = t;
  } else if (variations(form(t, hi)) % 2 == 1) {
    lo = t;
  } else {
    lo = hi = t;
  }
}

int compare(Instant& x, const Rat& t) {
  if (x.lo < t && t < x.hi) x.split(t);
  if (x.is_point()) return x.lo < t ? -1 : x.lo > t;
  return t <= x.lo ? 1 : -1;
}

int compare(Instant& x, Instant& y) {
  for (int round = 0;; ++round) {
    if (y.is_point()) return compare(x, Rat(y.lo));
    if (x.is_point()) return -compare(y, Rat(x.lo));
    if (x.hi <= y.lo) return -1;
    if (y.hi <= x.lo) return 1;
    const Rat lo = std::max(x.lo, y.lo), hi = std::min(x.hi, y.hi);
    if (round % 16 == 8 && variations(common(x.form(lo, hi), y.form(lo, hi))) % 2 == 1) return 0;
    x.split((x.lo + x.hi) / 2);
    if (!y.is_point()) y.split((y.lo + y.hi) / 2);
  }
}

std::optional<Collapse> first_collapse(const Four& four, const Rat& a, const Rat& b, Notes& notes,
                                       bool fresh) {
  if (four.quad.s == four.quad.e || a >= b) return std::nullopt;
  Search search(four, notes, fresh);
  auto found = search.first(a, b);
  // The next life sees wrong tangencies at its beginning, but not those that end just before it.
  if (search.owes_proof() && Span(four, b, b).apart(notes.touched) == Span::Apart::yes) {
    undecided("a generator lies inside another until just before " + about(b));
  }
  return found;
}

std::optional<Collapse> collapse_near(const Four& four, const Rat& a, const Rat& t) {
  // A bracket of 2^-37 with short ends.
  const Rat scaled = t * power(2, 40);
  const Int middle = numerator(scaled) / denominator(scaled);
  const Rat lo = (middle - 4) * power(2, -40), hi = (middle + 5) * power(2, -40);
  if (a >= lo) return std::nullopt;
  Span span(four, a, hi);
  if (!four.apart(a, hi)) return std::nullopt;
  const Form f = span.polynomial();
  if (variations(f) != 1 || span.always() || f.back() == 0) return std::nullopt;
  const Now end = span.at(1, 0);
  const int sign = f.size() < 9 ? -1 : sgn(f.back());
  if (end.incircle(true, sign) >= 0 || end.incircle(false, sign) >= 0) return std::nullopt;
  if (Now(four, lo).incircle(true) <= 0) return std::nullopt;
  return Collapse{{lo, hi, four}, hi};
}

// With w = (D_xp, D_yp) of the end vertex and d the direction from the common base to the start's
// circle, w x d = -sp (w x w1) - eps sqrt(Gamma) (w . w1) in terms of the start; the circles of
// both orientations lie on either side of w, the end's on the side of -eps of the end.
bool one_circle(const Four& four, Instant& t) {
  const auto [l, r, s, e] = four.quad;
  const bool turned = l == container, wall = turned || r == container;
  const int eps1 = wall || s == container ? 1 : -1, eps2 = wall || e == container ? 1 : -1;
  for (int round = 0; round < 200; ++round) {
    const std::array<Site<Form>, 4> at = Span(four, t.lo, t.hi).forms();
    const Circle c1 = turned ? Circle(at[1], at[0], at[2]) : Circle(at[0], at[2], at[1]);
    const Circle c2 = turned ? Circle(at[1], at[3], at[0]) : Circle(at[0], at[1], at[3]);
    const Form u = c1.sp * (c1.xp * c2.yp - c1.yp * c2.xp), v = c2.xp * c1.xp + c2.yp * c1.yp;
    const Form gamma = c1.gamma(), norm = u * u - gamma * v * v;
    if (norm[0] != 0 && norm.back() != 0 && variations(norm) == 0) {
      return sign_with_root(u[0], -eps1 * v[0], gamma[0]) == -eps2;
    }
    if (t.is_point()) break;
    t.split((t.lo + t.hi) / 2);
  }
  undecided("whether two circles touch the same four");
}

template struct Circle<Int>;

}  // namespace voroproof_kernel
