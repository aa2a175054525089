// The laws of exact/predicates.h by their numbers, over rationals; which number type is the first
// to decide hard cases; that no type contradicts another.
#include "exact/predicates.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "exact/ball.h"
#include "exact/rational.h"
#include "exact/tower.h"
#include "filtered/numbers/dd_ball.h"
#include "filtered/numbers/double_ball.h"
#include "tests/exact/powers.h"

namespace voroproof::internal::testing {
namespace {

template <class T>
using Sites = std::array<Site<T>, 4>;

// Four sites, one of which may be the container.
struct Four {
  Sites<Rational> at;
  int wall = -1;  // which, -1 for none
};

void showValue(const Four& four, std::ostream& out) {
  for (int k = 0; k < 4; ++k) {
    const Site<Rational>& s = four.at[k];
    out << (k == four.wall ? "container " : "disk ") << s.x << " " << s.y << " radius " << s.r
        << "\n";
  }
}

Rational fraction(long n, long d) {
  Rational q(n, d);
  q.canonicalize();
  return q;
}

// A unit vector, by the tangent of half its angle: counterclockwise as that grows.
struct Unit {
  Rational x, y;
};
Unit unit(const Rational& half) {
  const Rational square = half * half;
  return {(1 - square) / (1 + square), 2 * half / (1 + square)};
}

// The site of signed radius r at the place where the circle meets it in this direction. That of
// the container is seen on the other side of the circle's centre: rho + r is negative.
Site<Rational> set_on(const Site<Rational>& circle, const Unit& to, const Rational& r,
                      const Rational& stretch = 1) {
  const Rational reach = (circle.r + r) * stretch;
  return {circle.x + reach * to.x, circle.y + reach * to.y, r};
}

// What a description of small integers says, one after the other.
class Reader {
 public:
  explicit Reader(const std::vector<int>& numbers) : numbers_(numbers) {}
  int integer() { return numbers_[next_++ % numbers_.size()]; }
  Rational any() {
    constexpr int denominators[] = {1, 1, 2, 3, 5};
    const int n = integer();
    return fraction(n, denominators[std::abs(integer()) % 5]);
  }
  Rational size() { return abs(any()) / 4; }
  Unit direction() { return unit(any() / 3); }

 private:
  const std::vector<int>& numbers_;
  std::size_t next_ = 0;
};

enum class Kind {
  general,
  equal_radii,  // of the disks
  points,
  touching,   // each with the one before it
  contained,  // likewise, but from inside: the tangency vanishes
  collinear,
  cotangent,   // one circle touches all four
  cocircular,  // likewise, the disks of one radius
  on_line,     // a line touches all four
  lattice,     // coincident sites are frequent
};
const std::vector<Kind> all_kinds = {
    Kind::general,   Kind::equal_radii, Kind::points,     Kind::touching, Kind::contained,
    Kind::collinear, Kind::cotangent,   Kind::cocircular, Kind::on_line,  Kind::lattice};

Four make(Kind kind, int wall, const std::vector<int>& numbers) {
  Reader read(numbers);
  Four four{{}, wall};
  const Site<Rational> circle{read.any(), read.any(), read.size() + 1};
  const Rational common = read.size();
  const Unit line = read.direction();
  for (int k = 0; k < 4; ++k) {
    Site<Rational>& s = four.at[k];
    s = {read.any(), read.any(), read.size()};
    if (kind == Kind::equal_radii || kind == Kind::cocircular) s.r = common;
    if (kind == Kind::points) s.r = 0;
    if (kind == Kind::lattice) {
      s = {read.integer() % 3, read.integer() % 3, std::abs(read.integer() % 2)};
    }
    if (k == wall) s.r = -20 - s.r;
    const Unit to = read.direction();
    if (kind == Kind::cotangent || kind == Kind::cocircular) s = set_on(circle, to, s.r);
    if (kind == Kind::on_line) {
      s = {circle.x + line.x * s.x - line.y * s.r, circle.y + line.y * s.x + line.x * s.r, s.r};
    }
    if (kind == Kind::collinear) s = {circle.x + line.x * s.x, circle.y + line.y * s.x, s.r};
    if (k > 0 && (kind == Kind::touching || kind == Kind::contained)) {
      const Site<Rational>& last = four.at[k - 1];
      const Rational reach = last.r + (kind == Kind::touching ? s.r : Rational(-s.r));
      s = {last.x + reach * to.x, last.y + reach * to.y, s.r};
    }
  }
  return four;
}

// Of any size of the test case.
rc::Gen<int> number(int low, int high) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
}
rc::Gen<std::vector<int>> numbers() {
  return rc::gen::container<std::vector<int>>(48, number(-12, 12));
}
rc::Gen<Four> fours(const std::vector<Kind>& kinds = all_kinds) {
  return rc::gen::apply(make, rc::gen::elementOf(kinds), number(-1, 3), numbers());
}

// Disks of which none lies in another, and that reach into the container if there is one.
bool are_separate(const Four& four) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      const bool wall = i == four.wall || j == four.wall;
      const Sign wanted = wall ? Sign::negative : Sign::positive;
      if (sign(tangency(four.at[i], four.at[j])) != wanted) return false;
    }
  }
  return true;
}

template <class T>
T f_of(const Sites<T>& at) {
  return cotangency(at[0], at[1], at[2], at[3]);
}
template <class T>
T c_of(const Sites<T>& at) {
  return cocircularity(at[0], at[1], at[2], at[3]);
}

// Three of the four in cyclic order, the first no container.
using Order = std::array<int, 3>;
Order disk_leads(const Order& o, int wall) { return o[0] == wall ? Order{o[1], o[2], o[0]} : o; }
template <class T>
TangentTriple<T> triple(const Sites<T>& at, const Order& o, int wall) {
  return {at[o[0]], at[o[1]], at[o[2]], o[1] == wall || o[2] == wall};
}

// a + b sqrt(Gamma): laws of such numbers are laws of a and b, whatever Gamma is.
struct Rooted {
  Rooted(Rational plain, Rational with_root = 0) : a(std::move(plain)), b(std::move(with_root)) {}
  Rational a, b;
  bool operator==(const Rooted& o) const { return a == o.a && b == o.b; }
  Rooted conjugate() const { return {a, -b}; }
  Rooted operator-() const { return {-a, -b}; }
};
Rooted operator-(const Rooted& x, const Rooted& y) { return {x.a - y.a, x.b - y.b}; }
Rooted operator*(const Rational& c, const Rooted& x) { return {c * x.a, c * x.b}; }
Rooted product(const Rooted& x, const Rooted& y, const Rational& gamma) {
  return {x.a * y.a + x.b * y.b * gamma, x.a * y.b + x.b * y.a};
}
Sign sign_of(const Rooted& x, const Rational& gamma) {
  RadicalField field;
  return sign(Tower(x.a) + Tower(x.b) * field.sqrt(Tower(gamma)));
}
void showValue(const Rooted& x, std::ostream& out) { out << x.a << " + root " << x.b; }

// The numbers whose signs incircle, for a disk, and circle_exists tell.
Rooted q_of(const TangentTriple<Rational>& t, const Site<Rational>& e) {
  const InCircleParts<Rational> parts(t, e);
  const Rational c = parts.c();
  return {parts.g(), t.with_container ? Rational(-c) : c};
}
Rooted h_of(const TangentTriple<Rational>& t) {
  return {t.xp * t.xs + t.yp * t.ys, t.with_container ? Rational(-t.xy) : t.xy};
}
Rational n_of(const TangentTriple<Rational>& t) { return t.xp * t.xp + t.yp * t.yp; }

// What laws are about: of four sites, and of a triple and the fourth.
struct Invariants {
  Rational f, c, gamma, n;
  Rooted q, h;
  std::array<Rational, 6> p;
  Sign exists, in_circle;
};

// Of the triple 0, 1, 2 and the site 3; or of 0, 2, 1.
Invariants invariants(const Four& four, bool exchanged = false) {
  Order o = disk_leads({0, 1, 2}, four.wall);
  if (exchanged) std::swap(o[1], o[2]);
  const auto t = triple(four.at, o, four.wall);
  Invariants all{f_of(four.at), c_of(four.at), gamma(t), n_of(t), q_of(t, four.at[3]), h_of(t), {},
                 Sign::unknown, Sign::unknown};
  int k = 0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) all.p[k++] = tangency(four.at[i], four.at[j]);
  }
  all.exists = circle_exists(t);
  all.in_circle = incircle(t, four.at[3], four.wall == 3, sign(all.f));
  return all;
}

// That the signs are those of q and h, where Gamma is positive.
void require_signs(const Invariants& all, const Four& four) {
  if (!are_separate(four)) return;
  const Sign q = sign_of(all.q, all.gamma);
  RC_ASSERT(all.in_circle == (four.wall == 3 ? -q : q));
  RC_ASSERT(all.exists == sign_of(all.h, all.gamma));
}

void require_equal(const Invariants& x, const Invariants& y) {
  RC_ASSERT(x.f == y.f);
  RC_ASSERT(x.c == y.c);
  RC_ASSERT(x.p == y.p);
  RC_ASSERT(x.gamma == y.gamma);
  RC_ASSERT(x.n == y.n);
  RC_ASSERT(x.q == y.q);
  RC_ASSERT(x.h == y.h);
  RC_ASSERT(x.exists == y.exists);
  RC_ASSERT(x.in_circle == y.in_circle);
}

Rational determinant(const std::array<std::array<Rational, 3>, 3>& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// Differences x, y, s and p of three sites to the base at[0], in three columns of the four.
Rational columns(const Sites<Rational>& at, const Order& which) {
  std::array<std::array<Rational, 3>, 3> m;
  for (int k = 0; k < 3; ++k) {
    const Site<Rational>& s = at[k + 1];
    const Rational row[4] = {s.x - at[0].x, s.y - at[0].y, s.r - at[0].r, tangency(s, at[0])};
    for (int c = 0; c < 3; ++c) m[k][c] = row[which[c]];
  }
  return determinant(m);
}

// Each site as `change` makes it.
template <class Change>
Four changed(const Four& four, Change&& change) {
  Four other = four;
  for (Site<Rational>& s : other.at) s = change(s);
  return other;
}

// All laws are tested over such sites: that none of the special positions is rare.
TEST(Sites, AreDegenerateInEveryWay) {
  int walls[5] = {}, equal = 0, points = 0, contacts = 0, no_tangent = 0, lines = 0, circles = 0,
      coincident = 0, separate = 0, without_circle = 0;
  const rc::Gen<Four> gen = fours();
  constexpr int count = 4000;
  for (int k = 0; k < count; ++k) {
    const Four four = gen(rc::Random(k), rc::kNominalSize).value();
    const auto& s = four.at;
    ++walls[four.wall + 1];
    separate += are_separate(four);
    circles += f_of(s) == 0;
    lines += columns(s, {0, 1, 2}) == 0;
    if (are_separate(four)) without_circle += invariants(four).exists != Sign::positive;
    for (int i = 0; i < 4; ++i) {
      ASSERT_EQ(s[i].r < 0, i == four.wall);
      points += s[i].r == 0;
      for (int j = 0; j < i; ++j) {
        const Rational x = s[i].x - s[j].x, y = s[i].y - s[j].y, reach = s[i].r + s[j].r;
        equal += s[i].r == s[j].r;
        contacts += reach != 0 && x * x + y * y == reach * reach;
        no_tangent += tangency(s[i], s[j]) == 0;
        coincident += x == 0 && y == 0;
      }
    }
  }
  for (const int n : walls) EXPECT_GT(n, count / 8);
  for (const int n : {equal, points, contacts, no_tangent, lines, circles, coincident, separate,
                      without_circle}) {
    EXPECT_GT(n, count / 20);
  }
}

RC_GTEST_PROP(PredicateLaw, L1CotangencyIsOneNumberInEveryOrder, ()) {
  const Four four = *fours();
  const Rational f = f_of(four.at);
  const auto& s = four.at;
  std::array<int, 4> o = {0, 1, 2, 3};
  do {
    RC_ASSERT(cotangency(s[o[0]], s[o[1]], s[o[2]], s[o[3]]) == f);
  } while (std::next_permutation(o.begin(), o.end()));
}

RC_GTEST_PROP(PredicateLaw, L2CocircularityAlternates, ()) {
  const Four four = *fours();
  const auto& s = four.at;
  const Rational c = c_of(s);
  RC_ASSERT(cocircularity(s[0], s[2], s[1], s[3]) == -c);
  RC_ASSERT(cocircularity(s[0], s[3], s[2], s[1]) == -c);
  RC_ASSERT(cocircularity(s[0], s[1], s[3], s[2]) == -c);
  RC_ASSERT(cocircularity(s[0], s[2], s[3], s[1]) == c);
  RC_ASSERT(cocircularity(s[0], s[3], s[1], s[2]) == c);
  const Rational area = columns(s, {0, 1, 2});
  for (int k = 1; k < 4; ++k) {
    Sites<Rational> other = s;
    std::swap(other[0], other[k]);
    const Rational step = s[k].r - s[0].r;
    RC_ASSERT(c_of(other) == -c - 2 * step * area);
    // So the sign turns where the two have one radius.
    other[k].r = other[0].r;
    Sites<Rational> back = other;
    std::swap(back[0], back[k]);
    RC_ASSERT(c_of(other) == -c_of(back));
  }
}

RC_GTEST_PROP(PredicateLaw, L3CotangencyIsThatOfTheDeterminants, ()) {
  const Four four = *fours();
  const auto& s = four.at;
  const Rational a = columns(s, {1, 2, 3}), b = columns(s, {0, 2, 3}), c = c_of(s);
  RC_ASSERT(c == columns(s, {0, 1, 3}));
  RC_ASSERT(f_of(s) == 4 * (a * a + b * b - c * c));
}

RC_GTEST_PROP(PredicateLaw, L3CotangencyOfEqualRadiiIsMinusASquare, ()) {
  Four four = *fours();
  const Rational r = four.at[0].r;
  for (Site<Rational>& s : four.at) s.r = r;
  const Rational c = c_of(four.at);
  RC_ASSERT(f_of(four.at) == -4 * c * c);
}

RC_GTEST_PROP(PredicateLaw, L4GammaIsTheProductOfTheTangencies, ()) {
  const Four four = *fours();
  const auto& s = four.at;
  const Rational product = tangency(s[0], s[1]) * tangency(s[1], s[2]) * tangency(s[2], s[0]);
  Order o = {0, 1, 2};
  do {
    RC_ASSERT(gamma(triple(s, o, four.wall)) == product);
  } while (std::next_permutation(o.begin(), o.end()));
}

RC_GTEST_PROP(PredicateLaw, L5NormsOfTheInCircleFunctionAndOfTheCurvature, ()) {
  const Four four = *fours();
  Order o = disk_leads({0, 1, 2}, four.wall);
  const Site<Rational>& e = four.at[3];
  const auto t = triple(four.at, o, four.wall);
  std::swap(o[1], o[2]);
  const auto reversed = triple(four.at, o, four.wall);
  const Rational f = f_of(four.at), n = n_of(t), g = gamma(t);
  RC_ASSERT(q_of(reversed, e) == q_of(t, e).conjugate());
  RC_ASSERT(h_of(reversed) == h_of(t).conjugate());
  const Rational rest = t.xs * t.xs + t.ys * t.ys - t.xy * t.xy;
  RC_ASSERT(4 * product(q_of(t, e), q_of(reversed, e), g) == n * Rooted(f));
  RC_ASSERT(product(h_of(t), h_of(reversed), g) == n * Rooted(rest));
  // The same of the signs, which is how these are found.
  const Invariants one = invariants(four), two = invariants(four, true);
  require_signs(one, four);
  require_signs(two, four);
  if (are_separate(four)) {
    RC_ASSERT(one.in_circle * two.in_circle == sign(f));
    RC_ASSERT(one.exists * two.exists == sign(rest));
  }
}

RC_GTEST_PROP(PredicateLaw, L6TheCircleDoesNotDependOnTheBase, ()) {
  const Four four = *fours();
  const auto& s = four.at;
  const Site<Rational>& e = s[3];
  const Order orders[3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};
  for (const Order& first : orders) {
    if (first[0] == four.wall) continue;
    const auto t = triple(s, first, four.wall);
    const Rational g = gamma(t), n = n_of(t);
    const Rooted q = q_of(t, e), h = h_of(t);
    // q = p h - d.n - N s, with n the direction times N. With z - base = n / 2h and rho + r = N /
    // 2h this is h times the power |z - c_e|^2 - (rho + r_e)^2.
    const auto plain = circle_direction(t, [](const Rational&) { return Rational(0); });
    const auto with_root = circle_direction(t, [](const Rational&) { return Rational(1); });
    const Rooted nx{plain[0], with_root[0] - plain[0]}, ny{plain[1], with_root[1] - plain[1]};
    const Rational dx = e.x - t.base.x, dy = e.y - t.base.y, dr = e.r - t.base.r;
    RC_ASSERT(q == tangency(e, t.base) * h - dx * nx - dy * ny - Rooted(n * dr));
    for (const Order& second : orders) {
      if (second[0] == four.wall) continue;
      const auto u = triple(s, second, four.wall);
      const Rooted of_h = h_of(u);
      RC_ASSERT(product(q, of_h, g) == product(q_of(u, e), h, g));
      // N / (2 h) - N' / (2 h') = r - r'.
      const Rational step = t.base.r - u.base.r;
      RC_ASSERT(n * of_h - n_of(u) * h == 2 * step * product(h, of_h, g));
      if (!are_separate(four)) continue;
      const Sign f = sign(f_of(s));
      const bool wall = four.wall == 3;
      RC_ASSERT(circle_exists(t) == circle_exists(u));
      RC_ASSERT(incircle(t, e, wall, f) == incircle(u, e, wall, f));
    }
  }
}

RC_GTEST_PROP(PredicateLaw, L7ReflectionExchangesTheTwoCircles, ()) {
  const Four four = *fours();
  const Four image = changed(four, [](const Site<Rational>& s) -> Site<Rational> {
    return {-s.x, s.y, s.r};
  });
  Invariants expected = invariants(four);
  expected.c = -expected.c;
  require_equal(invariants(image, true), expected);
}

RC_GTEST_PROP(PredicateLaw, L8Scaling, ()) {
  const Four four = *fours();
  const Rational scale = fraction(*number(1, 12), *number(1, 5));
  const Four image = changed(four, [&](const Site<Rational>& s) -> Site<Rational> {
    return {scale * s.x, scale * s.y, scale * s.r};
  });
  const auto power = [&](int n) {
    Rational x = 1;
    for (; n > 0; --n) x *= scale;
    return x;
  };
  Invariants expected = invariants(four);
  for (Rational& p : expected.p) p *= power(2);
  expected.c *= power(4);
  expected.gamma *= power(6);
  expected.n *= power(6);
  expected.f *= power(8);
  // The root of Gamma has three of the powers.
  expected.h = {power(5) * expected.h.a, power(2) * expected.h.b};
  expected.q = {power(7) * expected.q.a, power(4) * expected.q.b};
  require_equal(invariants(image), expected);
}

RC_GTEST_PROP(PredicateLaw, L9RotationsAndTranslations, ()) {
  const Four four = *fours();
  const std::vector<int> list = *numbers();
  Reader read(list);
  const Unit to = read.direction();
  const Rational x = read.any(), y = read.any();
  const Four image = changed(four, [&](const Site<Rational>& s) -> Site<Rational> {
    return {to.x * s.x - to.y * s.y + x, to.y * s.x + to.x * s.y + y, s.r};
  });
  require_equal(invariants(image), invariants(four));
}

RC_GTEST_PROP(PredicateLaw, L10CommonGrowthOfTheSignedRadii, ()) {
  const Four four = *fours();
  const std::vector<int> list = *numbers();
  const Rational by = Reader(list).any();
  const Four image = changed(four, [&](const Site<Rational>& s) -> Site<Rational> {
    return {s.x, s.y, s.r + by};
  });
  require_equal(invariants(image), invariants(four));
}

RC_GTEST_PROP(PredicateLaw, L11SignsOfTheRadiiTurned, ()) {
  const Four four = *fours();
  const Four image = changed(four, [](const Site<Rational>& s) -> Site<Rational> {
    return {s.x, s.y, -s.r};
  });
  const Invariants inner = invariants(image), outer = invariants(four);
  RC_ASSERT(inner.f == outer.f);
  RC_ASSERT(inner.c == outer.c);
  RC_ASSERT(inner.p == outer.p);
  RC_ASSERT(inner.gamma == outer.gamma);
  RC_ASSERT(inner.n == outer.n);
  RC_ASSERT(inner.q == -outer.q.conjugate());
  RC_ASSERT(inner.h == -outer.h.conjugate());
}

// Where a circle is known and sites are set on it, the predicates say what can be seen: the other
// way to the truth, by no formula of theirs.
RC_GTEST_PROP(PredicateLaw, L12CirclesThatAreKnownWithTheContainerInEveryPlace, ()) {
  const std::vector<int> list = *numbers();
  Reader read(list);
  const int wall = *number(-1, 3);
  const Site<Rational> circle{read.any(), read.any(), read.size() + fraction(1, 3)};
  // Three directions counterclockwise, and any for the fourth site.
  std::array<Unit, 4> to;
  Rational half = read.any() / 3;
  for (int k = 0; k < 3; ++k) {
    to[k] = unit(half);
    half += read.size() + fraction(1, 7);
  }
  to[3] = read.direction();
  const Rational stretch = fraction(read.integer(), 13);  // 0 if it touches as well
  Four four{{}, wall};
  for (int k = 0; k < 4; ++k) {
    const Rational r = read.size();
    const Rational signed_radius = k == wall ? Rational(-circle.r - 1 - r) : r;
    four.at[k] = set_on(circle, to[k], signed_radius, k == 3 ? Rational(1 + stretch) : 1);
  }
  const Site<Rational>& e = four.at[3];
  // A container that is farther away than where it touches does not contain the circle.
  const Sign expected = wall == 3 ? -sign(stretch) : sign(stretch);
  if (stretch == 0) RC_ASSERT(f_of(four.at) == 0);
  const auto own_root = [](const Rational& x) { return rational_sqrt(x).value(); };
  for (const Order& o : {Order{0, 1, 2}, Order{1, 2, 0}, Order{2, 0, 1}}) {
    if (o[0] == wall) continue;
    const auto t = triple(four.at, o, wall);
    RC_ASSERT(circle_exists(t) == Sign::positive);
    RC_ASSERT(incircle(t, e, wall == 3, sign(f_of(four.at))) == expected);
    const auto found = tangent_circle(t, own_root);
    RC_ASSERT(found[0] == circle.x);
    RC_ASSERT(found[1] == circle.y);
    RC_ASSERT(found[2] == circle.r);
    const auto direction = circle_direction(t, own_root);
    RC_ASSERT(direction[0] == -n_of(t) * to[o[0]].x);
    RC_ASSERT(direction[1] == -n_of(t) * to[o[0]].y);

    // What takes a root of its own, in balls.
    Sites<Ball> balls;
    const auto ball = [](const Rational& x) { return Ball(x, 300); };
    for (int k = 0; k < 4; ++k) {
      const Site<Rational>& s = four.at[k];
      balls[k] = {ball(s.x), ball(s.y), ball(s.r)};
    }
    const auto rough = triple(balls, o, wall);
    const Sign value = sign(incircle_value(rough, balls[3], wall == 3));
    RC_ASSERT(value == expected || (expected == Sign::zero && value == Sign::unknown));
    const ContactDirections<Ball> contacts(rough);
    const auto near = [](const Ball& x, const Rational& y) {
      const Ball off = x - Ball(y, 300);
      return !is_certain(sign(off)) && off.radius() < Magnitude::power_of_two(-150);
    };
    for (int k = 0; k < (stretch == 0 ? 4 : 3); ++k) {
      const auto at = contacts.of(balls[k]);
      RC_ASSERT(near(at[0], to[k].x));
      RC_ASSERT(near(at[1], to[k].y));
    }
  }
}

RC_GTEST_PROP(PredicateLaw, L13BothCirclesExistWithTheContainerInTheTriple, ()) {
  const Four four = *fours();
  RC_PRE(0 <= four.wall && four.wall < 3 && are_separate(four));
  RC_ASSERT(invariants(four).exists == Sign::positive);
  RC_ASSERT(invariants(four, true).exists == Sign::positive);
}

// The number types that a decision is tried in, cheapest first, by their bits: doubles and
// double-doubles with error bounds; balls of 32 bits more than the goal of a run's motion, 112,
// which doubles whenever the run asks for more; exact numbers.
constexpr int in_doubles = 53, in_double_doubles = 106, exactly = std::numeric_limits<int>::max();
constexpr int tiers[] = {in_doubles, in_double_doubles, 144, 256, 480, 928, 1824, exactly};

DoubleBall double_ball(const Rational& q) {
  const double mid = round_nearest(q);
  return {mid, round_up(abs(Rational(q - to_rational(mid))))};
}
DdBall dd_ball(const Rational& q) {
  const double hi = round_nearest(q);
  const Rational rest = q - to_rational(hi);
  const double lo = round_nearest(rest);
  return {hi, lo, round_up(abs(Rational(rest - to_rational(lo))))};
}

// The sites in another type; turned by 45 degrees and twice as large where the root of 2 is given,
// so that they have irrational coordinates and all signs are as before.
template <class T, class Make>
Sites<T> sites_in(const Sites<Rational>& at, Make&& make, const std::optional<T>& root2) {
  const auto site = [&](const Site<Rational>& s) -> Site<T> {
    if (!root2) return {make(s.x), make(s.y), make(s.r)};
    return {*root2 * make(s.x - s.y), *root2 * make(s.x + s.y), make(2 * s.r)};
  };
  return {site(at[0]), site(at[1]), site(at[2]), site(at[3])};
}

// visit(tier, sites) until that returns true.
template <class Visit>
void at_each_tier(const Sites<Rational>& at, bool turned, Visit&& visit) {
  const auto go = [&]<class T>(int tier, auto&& make, const T& root2) {
    return visit(tier, sites_in<T>(at, make, turned ? std::optional<T>(root2) : std::nullopt));
  };
  for (const int tier : tiers) {
    if (tier == in_doubles) {
      if (go(tier, double_ball, sqrt(DoubleBall(2)))) return;
    } else if (tier == in_double_doubles) {
      if (go(tier, dd_ball, sqrt(DdBall(2)))) return;
    } else if (tier == exactly) {
      RadicalField field;
      const auto element = [](const Rational& x) { return Tower(x); };
      if (go(tier, element, field.sqrt(Tower(2)))) return;
    } else {
      const auto ball = [tier](const Rational& x) { return Ball(x, tier); };
      if (go(tier, ball, sqrt(ball(2)))) return;
    }
  }
}

enum class Question { cotangency, cocircularity, in_circle, exists };
constexpr Question all_questions[] = {Question::cotangency, Question::cocircularity,
                                      Question::in_circle, Question::exists};

// Of the triple 0, 1, 2 and the site 3.
template <class T>
Sign answer(Question question, const Sites<T>& at, int wall) {
  const auto t = [&] { return triple(at, disk_leads({0, 1, 2}, wall), wall); };
  switch (question) {
    case Question::cotangency:
      return sign(f_of(at));
    case Question::cocircularity:
      return sign(c_of(at));
    case Question::in_circle:
      return incircle(t(), at[3], wall == 3, sign(f_of(at)));
    case Question::exists:
      return circle_exists(t());
  }
  return Sign::unknown;
}

struct Decision {
  Sign sign = Sign::unknown;
  int tier = 0;
  bool operator==(const Decision&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Decision& d) {
  return out << "sign " << static_cast<int>(d.sign) << " by " << d.tier << " bits";
}

Decision first_decision(Question question, const Four& four, bool turned) {
  Decision first;
  at_each_tier(four.at, turned, [&](int tier, const auto& at) {
    first = {answer(question, at, four.wall), tier};
    return first.sign != Sign::unknown;
  });
  return first;
}

struct HardCase {
  std::string name;
  Four four;
  Question question;
  Decision expected;
  bool turned = false;
};

void expect_decided(const std::vector<HardCase>& cases) {
  for (const HardCase& c : cases) {
    EXPECT_EQ(first_decision(c.question, c.four, c.turned), c.expected) << c.name;
  }
}

Rational hair(int bits) { return bits == 0 ? Rational(0) : power_of_two(-bits); }

// Counterclockwise on the unit circle, the last moved out by `gap`.
Four points_on_circle(const Rational& gap, const Rational& scale = 1) {
  const Rational s = scale;
  return {{{{s, 0, 0}, {0, s, 0}, {-s, 0, 0}, {0, -s * (1 + gap), 0}}}};
}

// Radii 1, 2, 3 and 5 or, in the place `wall`, the container of radius 10. Around the unit circle,
// which all touch; the last moved out by `gap`.
Four disks_on_circle(const Rational& gap, int wall = -1) {
  const Site<Rational> circle{0, 0, 1};
  const Unit to[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const int radii[4] = {1, 2, 3, 5};
  Four four{{}, wall};
  for (int k = 0; k < 4; ++k) {
    four.at[k] = set_on(circle, to[k], k == wall ? -10 : radii[k]);
  }
  four.at[3].y += wall == 3 ? gap : Rational(-gap);
  return four;
}

constexpr auto plus = Sign::positive, minus = Sign::negative, none = Sign::zero;

// f is minus the square of C for points, so that it takes twice the bits; the in-circle function
// of equal radii waits for it.
TEST(HardCase, NearlyCocircularPoints) {
  std::vector<HardCase> cases;
  struct Row {
    int bits, by_c, by_f;
  };
  for (const auto& [bits, by_c, by_f] :
       {Row{20, in_doubles, in_doubles}, Row{30, in_doubles, in_double_doubles},
        Row{60, in_double_doubles, 144}, Row{120, 144, 256}, Row{400, 480, 928}}) {
    for (const bool turned : {false, true}) {
      const std::string name = std::to_string(bits) + (turned ? " turned" : "");
      const Four out = points_on_circle(hair(bits)), in = points_on_circle(-hair(bits));
      cases.push_back({"outside " + name, out, Question::cocircularity, {plus, by_c}, turned});
      cases.push_back({"inside " + name, in, Question::cocircularity, {minus, by_c}, turned});
      cases.push_back({"outside, f " + name, out, Question::cotangency, {minus, by_f}, turned});
      cases.push_back({"inside, f " + name, in, Question::cotangency, {minus, by_f}, turned});
      cases.push_back({"outside, q " + name, out, Question::in_circle, {plus, by_f}, turned});
      cases.push_back({"inside, q " + name, in, Question::in_circle, {minus, by_f}, turned});
    }
  }
  expect_decided(cases);
}

// Disks of different radii: f has a simple zero and changes its sign with q.
TEST(HardCase, NearlyCotangentDisks) {
  std::vector<HardCase> cases;
  struct Row {
    int bits, tier;
  };
  for (const auto& [bits, tier] : {Row{30, in_doubles}, Row{60, in_double_doubles}, Row{120, 144},
                                   Row{200, 256}, Row{400, 480}}) {
    for (int wall = -1; wall < 4; ++wall) {
      const std::string name = std::to_string(bits) + " wall " + std::to_string(wall);
      const Sign outside = wall == 3 ? minus : plus;
      const Four out = disks_on_circle(hair(bits), wall), in = disks_on_circle(-hair(bits), wall);
      cases.push_back({"outside " + name, out, Question::in_circle, {outside, tier}});
      cases.push_back({"inside " + name, in, Question::in_circle, {-outside, tier}});
    }
  }
  expect_decided(cases);
}

// Nothing is called zero for being small: doubles and double-doubles cannot tell, balls only where
// nothing was rounded.
TEST(HardCase, Ties) {
  const Four points = points_on_circle(0);
  Four fractions = points;
  const Rational tangents[] = {fraction(1, 3), fraction(2, 5), 3, -7};
  for (int k = 0; k < 4; ++k) {
    fractions.at[k] = set_on({fraction(1, 3), 2, fraction(5, 7)}, unit(tangents[k]), 0);
  }
  // Of 301 bits. C has four times as many, f eight times. Where both parts of q vanish f is not
  // asked.
  const Four large = points_on_circle(0, 1 + hair(300));
  std::vector<HardCase> cases = {
      {"C of 301 bits", large, Question::cocircularity, {none, 1824}},
      {"f of 301 bits", large, Question::cotangency, {none, exactly}},
      {"q of 301 bits", large, Question::in_circle, {none, 1824}},
  };
  for (const Question question :
       {Question::cotangency, Question::cocircularity, Question::in_circle}) {
    cases.push_back({"integers", points, question, {none, 144}});
    cases.push_back({"fractions", fractions, question, {none, exactly}});
    cases.push_back({"irrational", points, question, {none, exactly}, true});
  }
  for (int wall = -1; wall < 4; ++wall) {
    const std::string name = "disks, wall " + std::to_string(wall);
    for (const Question question : {Question::cotangency, Question::in_circle}) {
      cases.push_back({name, disks_on_circle(0, wall), question, {none, 144}});
      cases.push_back({name, disks_on_circle(0, wall), question, {none, exactly}, true});
    }
  }
  expect_decided(cases);
}

// Two circles touch three disks in a row, one above and one below. A fourth that touches the upper
// makes f vanish, and is certainly outside of the lower.
TEST(HardCase, TieWithTheOtherCircle) {
  const Site<Rational> left{-5, 0, 2}, middle{0, 0, 1}, right{5, 0, 2}, top{0, 24, 1};
  const Four upper{{left, middle, right, top}}, lower{{right, middle, left, top}};
  expect_decided({
      {"f", lower, Question::cotangency, {none, 144}},
      {"f, irrational", lower, Question::cotangency, {none, exactly}, true},
      {"q of the upper", upper, Question::in_circle, {none, 144}},
      {"q of the lower", lower, Question::in_circle, {plus, in_doubles}},
      {"q of the lower, irrational", lower, Question::in_circle, {plus, in_doubles}, true},
      {"the upper exists", upper, Question::exists, {plus, in_doubles}},
      {"the lower exists", lower, Question::exists, {plus, in_doubles}},
  });
}

// A radius that is more than that of the others by a hair: f is no square any more, but hardly.
TEST(HardCase, NearlyEqualRadii) {
  std::vector<HardCase> cases;
  struct Row {
    int bits, tier;
  };
  for (const auto& [bits, tier] : {Row{20, in_doubles}, Row{30, in_double_doubles}, Row{60, 144},
                                   Row{120, 256}, Row{400, 928}}) {
    Four four = points_on_circle(0);
    four.at[3].r = hair(bits);
    cases.push_back({std::to_string(bits), four, Question::in_circle, {minus, tier}});
    four.at[3].y -= 2 * hair(bits);
    cases.push_back({std::to_string(bits) + " out", four, Question::in_circle, {plus, tier}});
  }
  expect_decided(cases);
}

// Far from the origin integers lose nothing, for their differences are exact; fractions do.
TEST(HardCase, FarFromTheOrigin) {
  const auto moved = [](const Four& four, const Rational& x, const Rational& y) {
    return changed(four, [&](const Site<Rational>& s) -> Site<Rational> {
      return {s.x + x, s.y + y, s.r};
    });
  };
  const Rational far = power_of_two(22), third = power_of_two(30) / 3,
                 seventh = power_of_two(30) / 7;
  const Four points = points_on_circle(hair(30)), disks = disks_on_circle(hair(30));
  constexpr int first = in_doubles, second = in_double_doubles;
  expect_decided({
      {"C, integers", moved(points, far, -far), Question::cocircularity, {plus, first}},
      {"C, fractions", moved(points, third, seventh), Question::cocircularity, {plus, second}},
      {"q, integers", moved(disks, far, -far), Question::in_circle, {plus, first}},
      {"q, fractions", moved(disks, third, seventh), Question::in_circle, {plus, second}},
      {"f, integers", moved(points, far, -far), Question::cotangency, {minus, second}},
      {"f, fractions", moved(points, third, seventh), Question::cotangency, {minus, second}},
  });
}

// f has the eighth power of the scale, which leaves the range of doubles long before C does.
TEST(HardCase, LargeAndSmallScales) {
  std::vector<HardCase> cases;
  for (const int bits : {-200, 200}) {
    const std::string name = "scale " + std::to_string(bits);
    const Four four = points_on_circle(hair(10), power_of_two(bits));
    cases.push_back({name + ", C", four, Question::cocircularity, {plus, in_doubles}});
    cases.push_back({name + ", f", four, Question::cotangency, {minus, 144}});
    cases.push_back({name + ", q", four, Question::in_circle, {plus, 144}});
  }
  for (const int bits : {-300, 300}) {
    const std::string name = "scale " + std::to_string(bits);
    const Four four = points_on_circle(hair(10), power_of_two(bits));
    cases.push_back({name + ", C", four, Question::cocircularity, {plus, 144}});
  }
  expect_decided(cases);
}

// Three in a row, and three disks on one line: where a circle begins to exist.
TEST(HardCase, CirclesThatNearlyExist) {
  std::vector<HardCase> cases;
  struct Row {
    int bits, tier;
  };
  for (const auto& [bits, tier] : {Row{20, in_doubles}, Row{60, in_double_doubles}, Row{120, 144},
                                   Row{200, 256}, Row{400, 480}}) {
    for (const Sign side : {plus, minus}) {
      const Rational off = side == plus ? hair(bits) : Rational(-hair(bits));
      const std::string name = std::to_string(bits) + (side == plus ? "+" : "-");
      // A turn to the left makes them counterclockwise.
      const Four row{{{{-3, -2, 1}, {0, 0, 1}, {3, 2 + off, 1}, {}}}};
      cases.push_back({"row " + name, row, Question::exists, {side, tier}});
      // On the line y = 0, seen from below: the one in the middle has to be above it.
      const Four line{{{{9, 3, 3}, {4, 2 + off, 2}, {0, 1, 1}, {}}}};
      cases.push_back({"line " + name, line, Question::exists, {side, tier}});
    }
  }
  const Four row{{{{-3, -2, 1}, {0, 0, 1}, {3, 2, 1}, {}}}};
  const Four line{{{{9, 3, 3}, {4, 2, 2}, {0, 1, 1}, {}}}};
  for (const Four& four : {row, line}) {
    cases.push_back({"tie", four, Question::exists, {none, 144}});
    cases.push_back({"tie, irrational", four, Question::exists, {none, exactly}, true});
  }
  expect_decided(cases);
}

// Sites that nearly are what a description says, by hairs down to 2^-1000.
Four nearly(const Four& four, const std::vector<int>& list) {
  Reader read(list);
  Four other = four;
  Site<Rational>& s = other.at[std::abs(read.integer()) % 4];
  const int bits = 7 * std::abs(read.integer() * read.integer());
  s.x += read.any() * hair(bits);
  s.y += read.any() * hair(bits);
  if (read.integer() % 2 == 0) s.r += abs(read.any()) * hair(bits) * (s.r < 0 ? -1 : 1);
  return other;
}
rc::Gen<Four> near_fours() {
  return rc::gen::apply(nearly,
                        fours({Kind::collinear, Kind::cotangent, Kind::cocircular, Kind::on_line}),
                        numbers());
}

RC_GTEST_PROP(AllTiersAgree, OnEverySignThatTheyTell, ()) {
  const Four four = *near_fours();
  const bool separate = are_separate(four);
  for (const Question question : all_questions) {
    const Sign truth = answer(question, four.at, four.wall);
    RC_ASSERT(truth != Sign::unknown);
    for (const bool turned : {false, true}) {
      at_each_tier(four.at, turned, [&](int tier, const auto& at) {
        const Sign told = answer(question, at, four.wall);
        RC_ASSERT(told == truth || (told == Sign::unknown && tier != exactly));
        return false;
      });
    }
  }
  const Sign in_circle = answer(Question::in_circle, four.at, four.wall);
  bool kept_exactly = true;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) kept_exactly &= tangency(four.at[i], four.at[j]) != 0;
  }
  at_each_tier(four.at, false, [&](int tier, const auto& at) {
    // No tangency that vanishes is called certain.
    const bool kept = keeps_tangencies(at);
    RC_ASSERT(kept == kept_exactly || (!kept && tier != exactly));
    if constexpr (requires { sqrt(at[0].x); }) {
      // The in-circle function itself has the sign that is told without it.
      if (separate) {
        const auto t = triple(at, disk_leads({0, 1, 2}, four.wall), four.wall);
        const Sign value = sign(incircle_value(t, at[3], four.wall == 3));
        RC_ASSERT(value == in_circle || value == Sign::unknown);
      }
    }
    return false;
  });
}

// The property above asks each of them something that coarser ones leave open.
TEST(AllTiersAgree, EachIsTheFirstToDecideSome) {
  const rc::Gen<Four> gen = near_fours();
  for (const Question question : all_questions) {
    std::array<int, std::size(tiers)> first{};
    for (int k = 0; k < 3000; ++k) {
      const Four four = gen(rc::Random(k), rc::kNominalSize).value();
      const Decision d = first_decision(question, four, k % 2 == 0);
      ++first[std::find(std::begin(tiers), std::end(tiers), d.tier) - std::begin(tiers)];
    }
    for (const int n : first) EXPECT_GT(n, 5) << static_cast<int>(question);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
