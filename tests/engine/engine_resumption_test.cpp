// Runs that take up another's history, against that other, whole.
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <utility>

#include "corpus/generate.h"
#include "engine/kept_run.h"
#include "library/maneuver_input.h"
#include "tests/support/random_scenes.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

// Takes the run up after so many events, for `cuts` numbers of events between none and all. Whether
// it could be taken up in some place, kept in either way.
bool is_same_from_everywhere(const Scene& scene, std::size_t cuts,
                             const EngineOptions& options = {}) {
  const RecordedRun whole = run_with(scene, options);
  const std::size_t all = whole.events.size();
  std::array<std::size_t, 2> taken_up{};
  for (std::size_t k = 0; k < 2 * cuts; ++k) {
    const std::size_t cut = k / 2;
    const Keeping keeping = k % 2 == 0 ? Keeping::asked_for : Keeping::at_end;
    std::size_t kept = 0;
    const RecordedRun resumed = resume(scene, all * cut / cuts, options, keeping, kept);
    if (kept > 0) ++taken_up[k % 2];
    EXPECT_EQ(difference(whole, resumed), "")
        << "after " << kept << " of " << all << ": " << resumed.outcome.reason;
    EXPECT_EQ(whole.outcome.t, resumed.outcome.t);
    EXPECT_EQ(whole.outcome.reason, resumed.outcome.reason);
    EXPECT_EQ(whole.final_diagram, resumed.final_diagram);
    EXPECT_EQ(whole.stats.flips, resumed.stats.flips);
    EXPECT_EQ(whole.stats.disk_collisions, resumed.stats.disk_collisions);
    EXPECT_EQ(whole.stats.wall_collisions, resumed.stats.wall_collisions);
    EXPECT_EQ(whole.stats.maneuvers, resumed.stats.maneuvers);
    EXPECT_EQ(resumed.begins, 1);
  }
  return taken_up[0] > 0 && taken_up[1] > 0;
}

TEST(EngineResumption, Reference) {
  for (const double density : {0.05, 0.4}) {
    ReferenceOptions options;
    options.n = 40;
    options.horizon = 60;
    options.density = density;
    EXPECT_TRUE(is_same_from_everywhere(generate_reference(options), 12));
  }
}

// Ties, and collisions whose ties are proved by symmetry much later.
TEST(EngineResumption, TiesAndMirrorSymmetry) {
  GridOptions options;
  options.n = 25;
  options.spacing = 2.5;
  options.horizon = 20;
  for (const auto motion : {GridOptions::Motion::random, GridOptions::Motion::shear}) {
    options.motion = motion;
    EXPECT_TRUE(is_same_from_everywhere(generate_grid(options), 12));
  }
}

TEST(EngineResumption, LawsAndManeuvers) {
  Random random(6);
  for (int k = 0; k < 6; ++k) {
    Scene scene = random_scene({.n = 15, .rmin = 3, .rmax = 12, .maneuvers = 3 * k}, random);
    if (k % 3 == 1) scene.restitution = Rational(4, 5);
    if (k % 3 == 2) scene.law = ContainerLaw::whole;
    if (k % 3 == 2) scene.container_restitution = Rational(9, 10);
    EXPECT_TRUE(is_same_from_everywhere(scene, 8));
  }
}

// What is told must be what the run that was kept told.
TEST(EngineResumption, RefusesWhatDoesNotFit) {
  ReferenceOptions reference;
  reference.n = 20;
  reference.horizon = 40;
  const Scene scene = generate_reference(reference);
  std::optional<KeptRun> left;
  RecordedRun whole;
  EngineOptions options;
  options.is_to_keep = [] { return true; };
  options.mark = [] {};
  options.keep = [&](KeptRun&& kept) { left = std::move(kept); };
  whole = run_with(scene, options);
  ASSERT_TRUE(left);
  ASSERT_FALSE(left->disks.empty());
  const auto refused = [&](const KeptRun& kept) {
    Engine engine(motion_input(scene), maneuver_input(scene), {});
    NoSink sink;
    EXPECT_THROW(engine.resume(
                     kept, [](EventSink&) {}, sink),
                 OtherRun);
  };
  refused(*left);  // no turn is told
  KeptRun wrong = *left;
  wrong.disks.clear();
  wrong.diagram.pop_back();
  refused(wrong);
  wrong = *left;
  wrong.disks.clear();
  wrong.collapses.resize(1);
  refused(wrong);
}

// In slices of time it is kept where two of them join.
TEST(EngineResumption, OfSlices) {
  ReferenceOptions reference;
  reference.n = 60;
  reference.horizon = 60;
  EngineOptions options;
  options.threads = 2;
  options.least_sliced = 3;
  options.slice_hooks.work = [](int) { return 50; };
  EXPECT_TRUE(is_same_from_everywhere(generate_reference(reference), 6, options));
}

// Collisions at right angles and cradles at one instant, a maneuver at that of a collision.
TEST(EngineResumption, InstantsOfManyEvents) {
  Scene cradle = scene_of(20, 160,
                          {disk(-6, 0, 1, 1, 0), disk(0, 0, 1, 0, 0), disk(6, 0, 1, -1, 0),
                           disk(0, 6, 1, 0, -1), disk(0, -6, 1, 0, 1)});
  EXPECT_TRUE(is_same_from_everywhere(cradle, 5));
  cradle.maneuvers.push_back({4, 1, Rational(1, 2), Rational(1, 3)});
  cradle.maneuvers.push_back({4, 3, Rational(0), Rational(1)});
  EXPECT_TRUE(is_same_from_everywhere(cradle, 5));
}

// A run that sees a collapse coming does so again where it is taken up.
TEST(EngineResumption, OfARunThatWillCollapse) {
  Scene scene = scene_of(10, 1000, {disk(9, 0, 1, 0, Rational(1, 2))});
  scene.container_restitution = Rational(9, 10);
  scene.disks[0].vx = 1;
  EXPECT_TRUE(is_same_from_everywhere(scene, 6));
}

// States of many bits, and a supply that was raised.
TEST(EngineResumption, OfManyBits) {
  ReferenceOptions reference;
  reference.n = 12;
  reference.horizon = 1500;
  reference.density = 0.3;
  EngineOptions options;
  options.motion.start_bits = 64;
  EXPECT_TRUE(is_same_from_everywhere(generate_reference(reference), 4, options));
}

}  // namespace
}  // namespace voroproof::internal::testing
