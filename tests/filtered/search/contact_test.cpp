// The search for contacts against the quadratic over the rationals.
#include "filtered/search/contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "engine/static_diagram.h"
#include "library/maneuver_input.h"
#include "tests/filtered/search/end_of_runs.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/random_scenes.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

using Kind = NextContact::Kind;

std::vector<MotionOptions> both_paths() {
  MotionOptions slow;
  slow.filters = false;
  return {MotionOptions{}, slow};
}

std::uint64_t searches(const TierCounts& counts, Tier tier) {
  return counts.decided[static_cast<int>(Predicate::contact_search)][static_cast<int>(tier)];
}

// The roots of |d + w t|^2 = reach^2, as a polynomial in t; the contact is the smaller root, of
// a disk with the wall the larger one.
std::optional<ExactTime> true_contact(const MotionInput& in, GenId i, GenId j,
                                      const Rational& now) {
  const bool wall = i == container_id;
  const DiskInput& b = in.disks[j];
  DiskInput a{in.container_x, in.container_y, Rational(-in.container_radius), 0, 0, 1};
  if (!wall) a = in.disks[i];
  const auto off = [](const CompactRational& p, const CompactRational& q) {
    return Tower(Rational(p - q));
  };
  const Polynomial<Tower> x{off(b.x, a.x), off(b.vx, a.vx)};
  const Polynomial<Tower> y{off(b.y, a.y), off(b.vy, a.vy)};
  const Tower reach(a.radius + b.radius);
  const Polynomial<Tower> f = x * x + y * y - Polynomial<Tower>{Tower(reach * reach)};
  if (f.degree() < 2) return std::nullopt;
  const Rational far = Rational(Integer(1) << 100);
  const auto roots = real_roots(f, Rational(-far), far);
  if (roots.size() < 2) return std::nullopt;  // grazing, if it has one
  const ExactTime& root = wall ? roots[1] : roots[0];
  if (compare(root, now) < 0) return std::nullopt;
  return root;
}

// The search answers as the quadratic does, and every enclosure of the time contains it.
void expect_contact(const Scene& scene, GenId i, GenId j, const Rational& now,
                    TierCounts* tiers = nullptr) {
  const double end = 1000;
  for (const MotionOptions& options : both_paths()) {
    ComputedMotion motion(motion_input(scene), options);
    TierCounts counts;
    ContactSearch search(motion, counts);
    const auto truth = true_contact(motion.input(), i, j, now);
    const NextContact c = search.from(i, j, Moment::at(now), end);
    if (tiers != nullptr) *tiers += counts;
    if (!options.filters) {
      EXPECT_EQ(searches(counts, Tier::filter) + searches(counts, Tier::dd), 0u);
    }
    const bool later = truth && compare(*truth, now) > 0;
    if (!truth || compare(*truth, to_rational(end)) > 0) {
      ASSERT_EQ(c.kind, Kind::none) << text(scene);
      continue;
    }
    ASSERT_EQ(c.kind, later ? Kind::at : Kind::now) << text(scene);
    if (!later) continue;
    ASSERT_TRUE(compare(*truth, to_rational(c.lo)) >= 0) << text(scene);
    ASSERT_TRUE(compare(*truth, to_rational(c.hi)) <= 0) << text(scene);
    const DdBall dd = search.refine(i, j, c.lo);
    const Rational mid = to_rational(dd.hi) + to_rational(dd.lo);
    if (std::isfinite(dd.rad)) {
      ASSERT_TRUE(compare(*truth, Rational(mid - to_rational(dd.rad))) >= 0);
      ASSERT_TRUE(compare(*truth, Rational(mid + to_rational(dd.rad))) <= 0);
    }
    ExactMotion exact(motion);
    ASSERT_EQ(ContactSearch::exact_time(i, j, to_rational(c.lo), exact), *truth);
    // An end before it.
    const Rational early = now + (to_rational(c.lo) - now) / 2;
    EXPECT_EQ(search.from(i, j, Moment::at(now), round_down(early)).kind, Kind::none);
  }
}

TEST(ContactSearch, RandomPairsAreDecidedInDoubles) {
  Random random(1);
  TierCounts tiers;
  for (int k = 0; k < 20; ++k) {
    const Scene scene = random_scene({.n = 5, .rmin = 3, .rmax = 20}, random);
    for (GenId i = container_id; i < 5; ++i) {
      for (GenId j = i + 1; j < 5; ++j) {
        if (j != container_id) expect_contact(scene, i, j, Rational(k, 300), &tiers);
      }
    }
  }
  EXPECT_GT(searches(tiers, Tier::filter), 200u);
  EXPECT_LT(searches(tiers, Tier::dd), 5u);
  EXPECT_GT(searches(tiers, Tier::ball), 200u);  // without filters
  EXPECT_EQ(searches(tiers, Tier::exact), 0u);
}

// The contacts of any two disks whose motion is known to an error, against balls of 300 bits.
TEST(ContactSearch, AfterCollisions) {
  int contacts = 0, none = 0;
  at_end_of_runs({.n = 12, .rmin = 0.5, .rmax = 6}, "20", 8, [&](Engine& engine) {
    Motion& motion = engine.motion();
    TierCounts tiers;
    ContactSearch search(motion, tiers);
    const double now = 20, end = 1e6;
    const Ball t(now, 300);
    for (GenId j = 0; j < motion.size(); ++j) {
      for (GenId i = container_id; i < j; ++i) {
        // These two have just collided: they part, and the contact lies behind.
        if (i != container_id && motion.state_id(i) == motion.state_id(j)) continue;
        const Contact<Ball> k(motion.moving_site(i, t), motion.moving_site(j, t));
        const Ball discriminant = k.b * k.b - k.a * k.c;
        const bool wall = i == container_id;
        const bool meet =
            wall || (sign(k.b) == Sign::negative && sign(discriminant) == Sign::positive);
        const NextContact c = search.from(i, j, Moment::at(to_rational(now)), end);
        ASSERT_EQ(c.kind, meet ? Kind::at : Kind::none) << i << " " << j;
        ++(meet ? contacts : none);
        if (!meet) continue;
        const Ball root = sqrt(discriminant);
        const Ball at = t + (wall ? (root - k.b) / k.a : k.c / (root - k.b));
        EXPECT_EQ(sign(at - Ball(c.lo, 300)), Sign::positive);
        EXPECT_EQ(sign(Ball(c.hi, 300) - at), Sign::positive);
        EXPECT_LT(c.hi - c.lo, 1e-9 * c.hi);
      }
    }
    EXPECT_EQ(searches(tiers, Tier::dd), 0u);
  });
  EXPECT_GT(contacts, 100);
  EXPECT_GT(none, 100);
}

// Past each other at a distance of the sum of the radii, and a hair's breadth more and less.
TEST(ContactSearch, Grazing) {
  for (const int exponent : {20, 45, 60, 100, 300}) {
    const Rational hair(Integer(1), Integer(1) << exponent);
    for (const Rational& offset : {Rational(0), hair, Rational(-hair)}) {
      expect_contact(scene_of(100, 50, {disk(0, 0, 2, 0, 0), disk(-20, 5 + offset, 3, 1, 0)}), 0, 1,
                     0);
    }
  }
  // Balls of short numbers prove the zero; of thirds only the fourth tier does.
  TierCounts tiers;
  const Rational third(1, 3);
  expect_contact(
      scene_of(100, 50, {disk(0, 0, 2 * third, 0, 0), disk(-20, 5 * third, third * 3, third, 0)}),
      0, 1, 0, &tiers);
  EXPECT_EQ(searches(tiers, Tier::exact), 2u);
  // Neither axis is the line of flight.
  expect_contact(scene_of(100, 50, {disk(0, 0, 2, 0, 0), disk(-4 - 12, 3 - 16, 3, 3, 4)}), 0, 1, 0);
}

// In contact at the start: approaching is a contact now, parting and staying is none. No double
// tells that a disk that moves aside approaches by a hair.
TEST(ContactSearch, TouchingAtTheStart) {
  const Rational hair(Integer(1), Integer(1) << 60);
  for (const Rational& speed :
       {Rational(1), Rational(-1), Rational(1, 3), Rational(0), hair, Rational(-hair)}) {
    for (const Rational& side : {Rational(0), Rational(1), Rational(1, 7)}) {
      const Scene scene = scene_of(100, 50, {disk(3, 4, 2, speed, side), disk(8, 4, 3, 0, 0)});
      expect_contact(scene, 0, 1, 0);
      ComputedMotion motion(motion_input(scene), {});
      TierCounts tiers;
      EXPECT_EQ(ContactSearch(motion, tiers).from(0, 1, Moment::at(0), 50).kind,
                speed > 0 ? Kind::now : Kind::none);
    }
  }
  // At an instant that no double holds: the gap of 1/3 closes at time 1/3.
  expect_contact(scene_of(100, 50, {disk(0, 0, 2, 1, 0), disk(5 + Rational(1, 3), 0, 3, 0, 0)}), 0,
                 1, Rational(1, 3));
}

TEST(ContactSearch, Container) {
  for (const Rational& vx : {Rational(1), Rational(-1), Rational(1, 3)}) {
    for (const Rational& vy : {Rational(0), Rational(2)}) {
      // From the middle, from elsewhere, and from the wall: outwards now, inwards across.
      for (const Rational& x : {Rational(0), Rational(17, 3), Rational(9)}) {
        expect_contact(scene_of(10, 50, {disk(x, 0, 1, vx, vy)}), container_id, 0, 0);
      }
    }
  }
  // At rest: never. Along the wall: not in this model.
  expect_contact(scene_of(10, 50, {disk(9, 0, 1, 0, 0)}), container_id, 0, 0);
  ComputedMotion motion(motion_input(scene_of(10, 50, {disk(9, 0, 1, 0, 1)})), {});
  TierCounts tiers;
  EXPECT_THROW(ContactSearch(motion, tiers).from(container_id, 0, Moment::at(0), 50), Undecided);
}

TEST(ContactSearch, EqualVelocities) {
  for (const Rational& v : {Rational(3), Rational(1, 3)}) {
    for (const Rational& gap : {Rational(0), Rational(1)}) {
      expect_contact(scene_of(100, 50, {disk(0, 0, 2, v, 1), disk(5 + gap, 0, 3, v, 1)}), 0, 1, 0);
    }
  }
  // Nearly equal: the contact is far away.
  const Rational slow(Integer(1), Integer(1) << 40);
  expect_contact(scene_of(100, 50, {disk(0, 0, 2, 1 + slow, 0), disk(6, 0, 3, 1, 0)}), 0, 1, 0);
}

// Two points never overlap; head-on they are announced, for Motion::collide to refuse, whichever
// tier finds out: short numbers are exact in balls, thirds are not.
TEST(ContactSearch, Points) {
  for (const MotionOptions& options : both_paths()) {
    for (const Rational& x : {Rational(6), Rational(1, 3)}) {
      ComputedMotion motion(
          motion_input(scene_of(100, 50, {disk(0, 0, 0, 1, 0, 1), disk(x, 0, 0, 0, 0, 1)})),
          options);
      TierCounts tiers;
      const NextContact c = ContactSearch(motion, tiers).from(0, 1, Moment::at(0), 50);
      ASSERT_EQ(c.kind, Kind::at) << x;
      EXPECT_LE(to_rational(c.lo), x);
      EXPECT_GE(to_rational(c.hi), x);
      EXPECT_THROW(motion.collide(0, 1, c.lo), Undecided);
    }
  }
  expect_contact(scene_of(100, 50, {disk(0, 1, 0, 1, 0, 1), disk(6, 0, 0, 0, 0, 1)}), 0, 1, 0);
}

}  // namespace
}  // namespace voroproof::internal::testing
