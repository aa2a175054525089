// Two edges with one name but for the orientation: which of them a flip means.
#include "certify/orientation.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/certify/claimed_history.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

CertifyOptions unoriented(const Rational& tolerance = Rational(1, 1000000)) {
  CertifyOptions options;
  options.truth = Truth::recorded;
  options.tolerance = tolerance;
  options.unoriented = true;
  return options;
}

Quad mirrored(const Quad& q) { return {q.l, q.r, q.e, q.s}; }

FlipEvent flip_at(const Rational& t, const Quad& q) {
  auto exact = std::make_shared<ExactValues>();
  exact->t = t;
  return {round_nearest(t), q, exact};
}

// Two large disks, a small one in the gap between them. The edges of the two above and below it
// have the four generators in common: {0, 1}, 2 and the container.
Scene gap(const Rational& small_vy, const Rational& apart) {
  return scene_of(10, 5,
                  {disk(-3, 0, 2, -apart, 0), disk(3, 0, 2, apart, 0),
                   disk(0, 0, Rational(1, 2), 0, small_vy)});
}

// The one above, walked with disk 0 on the left, starts at 2 and ends at the container.
constexpr Quad kAbove{0, 1, container_id, 2}, kBelow{0, 1, 2, container_id};

// The time at which the first flip of the engine's history is, and of which edge.
std::pair<double, Quad> first_flip(const Scene& scene) {
  for (const Event& e : run(scene).events) {
    if (e.kind == Event::Kind::flip) return {e.t, e.edge};
  }
  ADD_FAILURE() << "nothing flips" << text(scene);
  return {};
}

class Orientation : public ::testing::Test {
 protected:
  static bool means_mirrored(const Scene& scene, const FlipEvent& claim,
                             const Rational& tolerance = Rational(1, 1000000)) {
    const CertifyOptions options = unoriented(tolerance);
    const Replay replay(scene, options);
    return voroproof::internal::means_mirrored(replay, scene, options, claim, mirrored(claim.quad));
  }
};

TEST_F(Orientation, TheOneThatCollapsesIsMeant) {
  for (const int direction : {1, -1}) {
    const Scene scene = gap(direction, 0);
    const auto [t, collapses] = first_flip(scene);
    const Quad other = mirrored(collapses);
    // The two go by different names, whichever it is that the small disk leaves through.
    EXPECT_TRUE(canonical(collapses) == kAbove || canonical(collapses) == kBelow);
    EXPECT_FALSE(means_mirrored(scene, {t, collapses}));
    EXPECT_TRUE(means_mirrored(scene, {t, other}));
    // Also walked backwards.
    EXPECT_FALSE(means_mirrored(scene, {t, reversed(collapses)}));
    EXPECT_TRUE(means_mirrored(scene, {t, reversed(other)}));
  }
  EXPECT_NE(first_flip(gap(1, 0)).second, first_flip(gap(-1, 0)).second);
}

// Who is right is up to the time of the claim, to the tolerance.
TEST_F(Orientation, WithinTheToleranceOfTheClaimedTime) {
  const Scene scene = gap(1, 0);
  const auto [rounded, collapses] = first_flip(scene);
  const Rational t = to_rational(rounded), tolerance(1, 1000);
  const Quad other = mirrored(collapses);
  for (const int side : {-1, 1}) {
    const Rational in = t + side * Rational(999, 1000) * tolerance,
                   out = t + side * Rational(1001, 1000) * tolerance;
    EXPECT_TRUE(means_mirrored(scene, flip_at(in, other), tolerance));
    EXPECT_TRUE(means_mirrored(scene, {round_nearest(in), other}, tolerance));
    EXPECT_FALSE(means_mirrored(scene, flip_at(out, other), tolerance));
    EXPECT_FALSE(means_mirrored(scene, {round_nearest(out), other}, tolerance));
  }
}

TEST_F(Orientation, NeitherCollapses) {
  const Scene moving = gap(1, 0);
  const double t = first_flip(moving).first;
  for (const Quad& q : {kAbove, kBelow}) {
    EXPECT_FALSE(means_mirrored(moving, {t - 0.5, q}));
    EXPECT_FALSE(means_mirrored(moving, {t + 0.5, q}));
    // Nothing moves at all.
    EXPECT_FALSE(means_mirrored(gap(0, 0), {1, q}));
  }
}

// The two large ones go apart: both edges collapse at one instant, and then the name is right.
TEST_F(Orientation, BothCollapse) {
  const Scene scene = gap(0, 1);
  const double t = first_flip(scene).first;
  EXPECT_FALSE(means_mirrored(scene, {t, kAbove}));
  EXPECT_FALSE(means_mirrored(scene, {t, kBelow}));
}

// Disks that have turned are on their new paths, and what lies before the turn does not count.
TEST_F(Orientation, OnThePathsOfTheReplay) {
  Scene scene = gap(0, 0);
  scene.maneuvers = {{1, 2, 0, 1}};
  const auto [t, collapses] = first_flip(scene);
  EXPECT_GT(t, 1);
  const Quad other = mirrored(collapses);
  const CertifyOptions options = unoriented();
  Replay replay(scene, options);
  const auto meant = [&](const FlipEvent& claim) {
    return voroproof::internal::means_mirrored(replay, scene, options, claim, mirrored(claim.quad));
  };
  EXPECT_FALSE(meant({t, other}));  // so far the disk is at rest
  ASSERT_FALSE(replay.take(ManeuverEvent{1, 2}).is_none());
  EXPECT_TRUE(meant({t, other}));
  EXPECT_FALSE(meant({t, collapses}));
  // The disk jumps over the instant: it turns back right before it would be there.
  Scene back = scene;
  back.maneuvers.push_back({to_rational(t) - Rational(1, 10000), 2, 0, -1});
  Replay turned(back, options);
  ASSERT_FALSE(turned.take(ManeuverEvent{1, 2}).is_none());
  ASSERT_FALSE(turned.take(ManeuverEvent{t - 1e-4, 2}).is_none());
  EXPECT_FALSE(voroproof::internal::means_mirrored(turned, back, options, {t, other}, collapses));
}

// A root of the new line that lies before its turn is none, though within the tolerance.
TEST_F(Orientation, NotBeforeTheTurn) {
  const Scene scene = gap(1, 0);
  const auto [t, collapses] = first_flip(scene);
  const Rational tolerance(1, 100);
  const CertifyOptions options = unoriented(tolerance);
  for (const auto& [delay, meant] : {std::pair(-1, true), std::pair(1, false)}) {
    // The disk goes on as it went, but anew, just before or just after its edge collapses.
    const double turn = t + delay * 1e-3;
    Scene again = scene;
    again.maneuvers = {{to_rational(turn), 2, 0, 1}};
    Replay replay(again, options);
    ASSERT_FALSE(replay.take(ManeuverEvent{turn, 2}).is_none());
    EXPECT_EQ(voroproof::internal::means_mirrored(replay, again, options, {t, mirrored(collapses)},
                                                  collapses),
              meant);
  }
}

// The names of the four do not matter: others come between them.
TEST_F(Orientation, AmongOtherDisks) {
  const Scene small = gap(1, 0);
  const auto [t, collapses] = first_flip(small);
  Scene large = small;
  large.disks = {disk(-9, 0, Rational(1, 8), 0, 0), small.disks[2],
                 disk(9, 0, Rational(1, 8), 0, 0),  small.disks[1],
                 disk(0, 9, Rational(1, 8), 0, 0),  small.disks[0]};
  const auto renamed = [](GenId g) { return g == container_id ? g : GenId{5 - 2 * g}; };
  const auto named = [&](const Quad& q) {
    return Quad{renamed(q.l), renamed(q.r), renamed(q.s), renamed(q.e)};
  };
  EXPECT_FALSE(means_mirrored(large, {t, named(collapses)}));
  EXPECT_TRUE(means_mirrored(large, {t, named(mirrored(collapses))}));
}

// In histories of all kinds of scenes: whenever both names are edges, the flip of the truth is
// recognized by either.
TEST_F(Orientation, OfRandomHistories) {
  Random random(5);
  int ambiguous = 0, other_collapses = 0;
  for (int k = 0; k < 60; ++k) {
    const Scene scene =
        random_scene({.n = 6, .rmin = 0.1, .rmax = 40, .horizon = 20, .density = 0.3}, random);
    const RecordedRun history = run(scene);
    if (!history.complete()) continue;
    const CertifyOptions options = unoriented();
    CertifyOptions oriented = options;
    oriented.unoriented = false;
    Replay replay(scene, oriented);
    replay.diagram() = diagram_of(6, history.initial);
    for (const auto& claim : claimed_history(scene, history).events) {
      const auto* flip = std::get_if<FlipEvent>(&claim);
      if (flip != nullptr && replay.find_mirrored(flip->quad) >= 0) {
        ++ambiguous;
        const Quad other = mirrored(flip->quad);
        EXPECT_FALSE(voroproof::internal::means_mirrored(replay, scene, options, *flip, other));
        other_collapses += voroproof::internal::means_mirrored(replay, scene, options,
                                                               {flip->t, other}, flip->quad);
      }
      ASSERT_FALSE(replay.take(claim).is_none());
    }
  }
  EXPECT_GT(ambiguous, 20);
  // Not where both collapse at once, of which there is none here.
  EXPECT_EQ(other_collapses, ambiguous);
}

}  // namespace
}  // namespace voroproof::internal::testing
