// The laws of exact/predicates.h by their numbers, over rationals.
#include "exact/predicates.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "exact/ball.h"
#include "exact/rational.h"
#include "tests/exact/fraction.h"
#include "tests/exact/predicate_invariants.h"
#include "tests/exact/predicate_sites.h"

namespace voroproof::internal::testing {
namespace {

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

}  // namespace
}  // namespace voroproof::internal::testing
