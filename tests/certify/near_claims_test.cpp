// Claims nearer to each other than the tolerance: their order in the file may be another than that
// of their true times.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "certify/report.h"
#include "tests/certify/claimed_history.h"
#include "tests/certify/near_collisions.h"

namespace voroproof::internal::testing {
namespace {

// Far from each other two squares of disks, of each of which the last disk closes a circle of all
// four: on the left at t = 1, on the right so much later.
Scene two_squares(const Rational& later) {
  return scene_of(60, 2,
                  {disk(-20, 5, 1, 0, 0), disk(-15, 0, 1, 0, 0), disk(-25, 0, 1, 0, 0),
                   disk(-20, -4, 1, 0, -1), disk(20, 5, 1, 0, 0), disk(25, 0, 1, 0, 0),
                   disk(15, 0, 1, 0, 0), disk(20, later - 4, 1, 0, -1)});
}

class NearFlips : public ::testing::Test {
 protected:
  // Or, `oriented` or not, with the quadruplets that an engine without orientation writes.
  Certificate certified(const Scene& scene, bool exchanged, Truth truth, bool strict,
                        bool oriented = true) {
    ClaimedHistory h = claimed_history(scene, run(scene));
    std::vector<FlipEvent*> flips;
    for (auto& e : h.events) {
      auto* f = std::get_if<FlipEvent>(&e);
      if (f != nullptr && f->t > 0.99 && f->t < 1.01) flips.push_back(f);
    }
    EXPECT_EQ(flips.size(), 2u);
    if (exchanged) std::swap(flips[0]->quad, flips[1]->quad);
    if (!oriented) {
      h.header.oriented = false;
      for (FlipEvent* f : flips) std::swap(f->quad.s, f->quad.e);
    }
    CertifyOptions options;
    options.truth = truth;
    options.strict = strict;
    return certify(scene, h, options);
  }
};

// As near as doubles, double-doubles and neither can tell.
TEST_F(NearFlips, MayBeToldInAnyOrder) {
  for (const int digits : {7, 9, 12, 20, 40}) {
    Integer big;
    mpz_ui_pow_ui(big.get_mpz_t(), 10, digits);
    const Scene scene = two_squares(Rational(Integer(1), big));
    for (const Truth truth : {Truth::exact, Truth::recorded}) {
      SCOPED_TRACE(digits);
      EXPECT_EQ(certified(scene, false, truth, true).verdict, Verdict::certified);
      const Certificate c = certified(scene, true, truth, false);
      EXPECT_EQ(c.verdict, Verdict::certified) << reason_line(c);
      EXPECT_EQ(c.swaps, 1);
      const Certificate strict = certified(scene, true, truth, true);
      ASSERT_EQ(strict.verdict, Verdict::refuted);
      EXPECT_EQ(strict.divergence->fault, Fault::wrong_order);
    }
  }
}

TEST_F(NearFlips, MayBeToldInAnyOrderWithoutOrientation) {
  const Scene scene = two_squares(Rational(1, 10'000'000));
  for (const bool exchanged : {false, true}) {
    const Certificate c = certified(scene, exchanged, Truth::recorded, false, false);
    EXPECT_EQ(c.verdict, Verdict::certified) << reason_line(c);
    EXPECT_EQ(c.swaps, exchanged ? 1 : 0);
    EXPECT_EQ(c.resolved, 2);
  }
}

// Far from each other, at irrational times 1e-45 apart.
TEST(NearCollisions, MayBeToldInAnyOrder) {
  const Scene scene = near_collisions();
  const ClaimedHistory right = claimed_history(scene, run(scene));
  ClaimedHistory exchanged = right;
  std::vector<voroproof::internal::Event*> hits;
  for (auto& e : exchanged.events) {
    if (std::holds_alternative<CollideEvent>(e)) hits.push_back(&e);
  }
  ASSERT_EQ(hits.size(), 2u);
  std::swap(*hits[0], *hits[1]);
  CertifyOptions options;
  EXPECT_EQ(certify(scene, right, options).verdict, Verdict::certified);
  const Certificate swapped = certify(scene, exchanged, options);
  EXPECT_EQ(swapped.verdict, Verdict::certified) << reason_line(swapped);
  EXPECT_EQ(swapped.swaps, 1);
  options.strict = true;
  EXPECT_EQ(certify(scene, exchanged, options).verdict, Verdict::refuted);
}

// At one instant neither is before the other.
TEST_F(NearFlips, AreNotExchangedAtOneInstant) {
  const Scene scene = two_squares(0);
  for (const bool exchanged : {false, true}) {
    const Certificate c = certified(scene, exchanged, Truth::exact, true);
    EXPECT_EQ(c.verdict, Verdict::certified) << reason_line(c);
    EXPECT_EQ(c.swaps, 0);
  }
}

// An edge collapses only because one of its disks turns less than the tolerance before, and its
// flip is told first: by its name, or by one without orientation.
TEST(NearManeuvers, MayBeToldAfterAFlipOfTheirDisk) {
  const Rational soon(1, 10'000'000);
  Scene scene = scene_of(
      60, 2,
      {disk(0, 5, 1, 0, 0), disk(5, 0, 1, 0, 0), disk(-5, 0, 1, 0, 0), disk(0, soon - 5, 1, 0, 0)});
  scene.maneuvers = {{1, 3, 0, -1}};
  const ClaimedHistory right = claimed_history(scene, run(scene));
  ASSERT_EQ(right.events.size(), 2u);
  // It turns away, or comes there later than the tolerance.
  Scene away = scene, late = scene;
  away.maneuvers[0].vy = 1;
  late.disks[3].y = Rational(20 * soon - 5);
  for (const bool oriented : {true, false}) {
    ClaimedHistory exchanged = right;
    std::swap(exchanged.events[0], exchanged.events[1]);
    Quad& q = std::get<FlipEvent>(exchanged.events[0]).quad;
    if (!oriented) q = canonical(Quad{q.l, q.r, q.e, q.s});
    for (const Truth truth : {Truth::exact, Truth::recorded}) {
      CertifyOptions options;
      options.truth = truth;
      options.unoriented = !oriented;
      const Certificate c = certify(scene, exchanged, options);
      EXPECT_EQ(c.verdict, Verdict::certified) << reason_line(c);
      EXPECT_EQ(c.swaps, 1);
      EXPECT_EQ(c.resolved, oriented ? 0 : 1);
      for (const Scene* wrong : {&away, &late}) {
        ClaimedHistory told = exchanged;
        const Vec2 v{0, wrong == &away ? 1.0 : -1.0};
        std::get<ManeuverEvent>(told.events[1]) = {.t = 1, .disk = 3, .v = v};
        std::get<FlipEvent>(told.events[0]).t = 1;
        EXPECT_EQ(certify(*wrong, told, options).verdict, Verdict::refuted);
      }
      options.unoriented = false;
      EXPECT_EQ(certify(scene, exchanged, options).verdict,
                oriented ? Verdict::certified : Verdict::refuted);
    }
  }
}

// Of maneuvers within the tolerance the first is claimed last. Beyond the claims that are looked at
// together it comes too late to be put first, which is no fault of the history.
TEST(NearManeuvers, NotBeforeManyOthers) {
  constexpr int count = 60;
  std::vector<DiskInput> disks;
  for (int k = 0; k < count; ++k) {
    disks.push_back(disk((5 + k) * std::cos(2.4 * k), (5 + k) * std::sin(2.4 * k), 1, 0, 0));
  }
  Scene scene = scene_of(100, 2, disks);
  for (int k = 0; k < count; ++k) {
    scene.maneuvers.push_back({1 + Rational(k, 1'000'000'000), k, 0, 0});
  }
  ClaimedHistory h = claimed_history(scene, run(scene));
  ASSERT_EQ(h.events.size(), static_cast<std::size_t>(count));
  for (auto& e : h.events) std::get<ManeuverEvent>(e).t = 1;
  EXPECT_EQ(certify(scene, h, {}).verdict, Verdict::certified);
  std::rotate(h.events.begin(), h.events.begin() + 1, h.events.end());
  for (const std::size_t together : {count - 1, count}) {
    CertifyOptions options;
    options.most_near = together;
    const Certificate c = certify(scene, h, options);
    EXPECT_EQ(c.verdict, together < count ? Verdict::undecided : Verdict::certified)
        << reason_line(c);
    EXPECT_EQ(c.swaps, 1);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
