// A history dealt out in parts: nothing is lost, parts end where they may and nowhere else, and
// depend on the file alone.
#include "certify/part_reader.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "history/scene_motion.h"
#include "tests/certify/claimed_history.h"
#include "tests/certify/dealt_parts.h"
#include "tests/certify/same_claim.h"
#include "tests/support/lattice_scene.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

TEST(PartReader, ShortHistoriesAreOnePart) {
  const CertifyOptions options = in_parts_of(CertifyOptions{}.least_part);
  for (const std::vector<double>& times : {std::vector<double>{}, std::vector{0.0},
                                           std::vector{50.0}, std::vector{0.0, 0.0, 1.0, 99.0}}) {
    const ClaimedHistory h = hits(times);
    const Dealt dealt = deal(lone(), h, options);
    EXPECT_EQ(sizes(dealt), std::vector{times.size()});
    expect_all(dealt, lone(), h, options);
  }
  const Scene none = scene_of(10, 1, {});
  EXPECT_EQ(sizes(deal(none, hits({}), options)), std::vector<std::size_t>{0});
}

TEST(PartReader, EmptyHistoriesAreOnePartHoweverSmall) {
  EXPECT_EQ(sizes(deal(lone(), hits({}), in_parts_of(1))), std::vector<std::size_t>{0});
  const Scene scene = scene_of(10, 1, {disk(-3, 0, 1, 0, 0), disk(3, 0, 1, 0, 0)});
  const ClaimedHistory h = claimed_history(scene, run(scene));
  ASSERT_TRUE(h.events.empty());
  const Dealt dealt = deal(scene, h, in_parts_of(1));
  EXPECT_EQ(sizes(dealt), std::vector<std::size_t>{0});
  EXPECT_EQ(dealt.parts[0].replay.diagram().quads(), *h.header.initial);
}

// The smallest parts end wherever they may: where the gap is wider than eight tolerances, and not
// where it is just that.
TEST(PartReader, PartsEndInGapsWiderThanEightTolerances) {
  const Rational tolerance = Rational(1) >> 20;
  const double eight = 0x1p-17;
  const double wider = std::nextafter(1 + eight, 2), b = 2, c = 3 + eight;
  const ClaimedHistory h =
      hits({1, 1, 1 + eight, b, std::nextafter(b, 3), b + 0.5 * eight, 3, c, c + 2 * eight});
  const CertifyOptions options = in_parts_of(1, tolerance);
  const Dealt dealt = deal(lone(), h, options);
  expect_all(dealt, lone(), h, options);
  // The first has none: what it proves is the diagram at the beginning.
  EXPECT_EQ(sizes(dealt), (std::vector<std::size_t>{0, 3, 3, 2, 1}));
  const ClaimedHistory just = hits({1, 1 + eight}), more = hits({1, wider});
  EXPECT_EQ(sizes(deal(lone(), just, options)), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(sizes(deal(lone(), more, options)), (std::vector<std::size_t>{0, 1, 1}));
  // With a tolerance that is no binary64 the gap is no smaller than eight of it.
  const CertifyOptions odd = in_parts_of(1, Rational(1, 3));
  for (const double t : {1 + 8.0 / 3, 1 + 8.0 / 3 - 1e-9, 1 + 8.0 / 3 + 1e-9}) {
    const ClaimedHistory two = hits({1, t});
    const Dealt parts = deal(lone(), two, odd);
    expect_all(parts, lone(), two, odd);
    EXPECT_EQ(parts.parts.size(), t - 1 > 8.0 / 3 + 1e-10 ? 2u : 1u);
  }
}

// Claims at t = 0 and near it belong to the first part.
TEST(PartReader, NothingEndsAtTheBeginning) {
  const CertifyOptions options = in_parts_of(1);
  const ClaimedHistory h = hits({0, 0, 1e-6, 5e-6, 1});
  const Dealt dealt = deal(lone(), h, options);
  expect_all(dealt, lone(), h, options);
  EXPECT_EQ(sizes(dealt), (std::vector<std::size_t>{4, 1}));
}

// Collisions at t = 0 have happened when the initial diagram is taken.
TEST(PartReader, CollisionsBeforeTheInitialDiagram) {
  const Scene scene =
      scene_of(20, 30, {disk(-1, 0, 1, 1, 0), disk(1, 0, 1, -1, 0), disk(0, 5, 1, 0, 1)});
  const ClaimedHistory h = claimed_history(scene, run(scene));
  ASSERT_FALSE(h.events.empty());
  ASSERT_EQ(time(h.events[0]), 0);
  const CertifyOptions options = in_parts_of(1);
  const Dealt dealt = deal(scene, h, options);
  expect_all(dealt, scene, h, options);
  EXPECT_GT(dealt.parts.size(), 1u);
  EXPECT_EQ(dealt.parts[0].replay.diagram().quads(), *h.header.initial);
  EXPECT_EQ(dealt.parts[0].replay.changes(), 0);
}

// Where the file gives no initial diagram it is asked for, once, with what has moved at t = 0.
TEST(PartReader, ProposedInitialDiagram) {
  const Scene scene =
      scene_of(20, 30, {disk(-1, 0, 1, 1, 0), disk(1, 0, 1, -1, 0), disk(0, 5, 1, 0, 1)});
  const ClaimedHistory with = claimed_history(scene, run(scene));
  ClaimedHistory h = with;
  h.header.initial.reset();
  CertifyOptions options = in_parts_of(1);
  int asked = 0;
  options.propose_initial = [&](Motion& motion) {
    ++asked;
    // The two have exchanged their velocities.
    EXPECT_EQ(motion.doubles(0).vx, -1);
    EXPECT_EQ(motion.doubles(1).vx, 1);
    return *with.header.initial;
  };
  const Dealt dealt = deal(scene, h, options);
  expect_all(dealt, scene, h, options);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(dealt.header.initial, with.header.initial);
  EXPECT_EQ(dealt.remarks, std::vector<std::string>{constructed_initial_remark});
  EXPECT_EQ(sizes(dealt), sizes(deal(scene, with, options)));
  // That of the file goes before it.
  EXPECT_TRUE(deal(scene, with, options).remarks.empty());
  EXPECT_EQ(asked, 1);
  // None, or none that is one, is left to the one part to say.
  options.propose_initial = nullptr;
  EXPECT_EQ(sizes(deal(scene, h, options)), std::vector{h.events.size()});
  h.header.initial = std::vector<Quad>{{0, 1, 2, 2}};
  const Dealt wrong = deal(scene, h, options);
  EXPECT_EQ(sizes(wrong), std::vector{h.events.size()});
  EXPECT_EQ(wrong.header.initial, h.header.initial);
}

// What comes after a claim that makes no sense is in the part that begins before it.
TEST(PartReader, ClaimsThatMakeNoSenseAreInTheLastPart) {
  ClaimedHistory h = hits({10, 20, 30, 40, 50});
  h.events.insert(h.events.begin() + 3, ManeuverEvent{35, 0});  // none is scheduled
  h.count();
  const CertifyOptions options = in_parts_of(1);
  const Dealt dealt = deal(lone(), h, options);
  expect_all(dealt, lone(), h, options);
  EXPECT_EQ(sizes(dealt), (std::vector<std::size_t>{0, 1, 1, 1, 3}));
  // At the very beginning: then there is one.
  ClaimedHistory at_once = hits({10, 20});
  at_once.events.insert(at_once.events.begin(), ManeuverEvent{0, 0});
  at_once.count();
  EXPECT_EQ(sizes(deal(lone(), at_once, options)), (std::vector<std::size_t>{3}));
}

// 1024 of them, at rest until the horizon 0.
Scene many_disks() {
  Scene scene = scene_of(100'000, 0, {});
  for (int k = 0; k < 1024; ++k) {
    scene.disks.push_back(disk(100 * (k % 32), 100 * (k / 32), 1, 0, 0));
  }
  return scene;
}

// A history of many disks and few claims is of two parts, the first half as long as the other,
// unless that is short even for few disks.
TEST(PartReader, ShorterHistoriesOfManyDisksAreTwoParts) {
  std::vector<double> times;
  for (int k = 1; k <= 99; ++k) times.push_back(k);
  const ClaimedHistory h = hits(times);
  EXPECT_EQ(sizes(deal(lone(), h, in_parts_of(400))), (std::vector<std::size_t>{50, 49}));
  EXPECT_EQ(sizes(deal(lone(), h, in_parts_of(1000))), (std::vector<std::size_t>{99}));
  const Scene scene = many_disks();
  ClaimedHistory many = h;
  many.header.initial = run(scene).initial;
  EXPECT_EQ(sizes(deal(scene, many, in_parts_of(200))), (std::vector<std::size_t>{33, 50, 16}));
  EXPECT_EQ(sizes(deal(scene, many, in_parts_of(400))), (std::vector<std::size_t>{50, 49}));
  EXPECT_EQ(sizes(deal(scene, many, in_parts_of(1000))), (std::vector<std::size_t>{99}));
}

// So many claims at least, but an eighth of it in the first part, and fewer towards the end.
TEST(PartReader, PartsAreOfTheSizeAskedFor) {
  std::vector<double> times;
  for (int k = 1; k <= 2000; ++k) times.push_back(0.05 * k);
  const ClaimedHistory h = hits(times);
  for (const std::size_t least : {std::size_t{8}, std::size_t{80}, std::size_t{400}}) {
    const CertifyOptions options = in_parts_of(least);
    const Dealt dealt = deal(lone(), h, options);
    expect_all(dealt, lone(), h, options);
    const std::vector<std::size_t> parts = sizes(dealt);
    ASSERT_GT(parts.size(), 2u);
    EXPECT_EQ(parts[0], least / 8);
    EXPECT_EQ(parts[1], least);
    for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
      EXPECT_GE(parts[k], least / 8);
      EXPECT_LE(parts[k], least);
      if (k > 1) {
        EXPECT_LE(parts[k], parts[k - 1]);
      }
    }
    EXPECT_LT(parts[parts.size() - 2], least);
  }
}

// Many disks make for larger parts: for each one in 512 of what is asked for.
TEST(PartReader, PartsGrowWithTheDisks) {
  Scene scene = many_disks();
  for (int k = 1; k < 500; ++k) scene.maneuvers.push_back({Rational(k), k, 0, 0});
  ClaimedHistory h;
  h.header.horizon = 1000;
  for (int k = 1; k < 500; ++k) h.events.emplace_back(ManeuverEvent{double(k), k});
  h.count();
  // Any diagram: it is taken for what it is.
  h.header.initial = run(many_disks()).initial;
  scene.horizon = 1000;
  const CertifyOptions options = in_parts_of(40);
  const std::vector<std::size_t> parts = sizes(deal(scene, h, options));
  ASSERT_GT(parts.size(), 2u);
  EXPECT_EQ(parts[0], 10u);
  EXPECT_EQ(parts[1], 80u);
}

RC_GTEST_PROP(PartReader, PartsOfTheEnginesHistoriesAreThese, ()) {
  const Scene scene = scene_of(*lattice_scenes({.maneuvers = true, .elastic = false}));
  const RecordedRun r = run(scene);
  RC_PRE(r.complete() && scene.disks.size() >= 1);
  const ClaimedHistory h = claimed_history(scene, r);
  const CertifyOptions options =
      in_parts_of(*rc::gen::element<std::size_t>(1, 2, 9),
                  *rc::gen::element(Rational(1, 1000000), Rational(1, 100), Rational(0)));
  const Dealt dealt = deal(scene, h, options);
  RC_CLASSIFY(dealt.parts.size() > 3, "some parts");
  expect_all(dealt, scene, h, options);
  RC_ASSERT(!::testing::Test::HasFailure());
}

// The same file gives the same parts, whoever proves them.
TEST(PartReader, PartsDependOnTheFileOnly) {
  Random random(2);
  const Scene scene = random_scene({.n = 8, .horizon = 60}, random);
  const ClaimedHistory h = claimed_history(scene, run(scene));
  CertifyOptions options = in_parts_of(5);
  const Dealt first = deal(scene, h, options);
  EXPECT_GT(first.parts.size(), 3u);
  expect_all(first, scene, h, options);
  options.threads = 7;
  options.strict = true;
  options.motion.filters = false;
  const Dealt second = deal(scene, h, options);
  ASSERT_EQ(second.parts.size(), first.parts.size());
  EXPECT_EQ(sizes(second), sizes(first));
  for (std::size_t k = 0; k < first.parts.size(); ++k) {
    EXPECT_EQ(second.parts[k].begin, first.parts[k].begin);
    EXPECT_TRUE(std::equal(second.parts[k].places.begin(), second.parts[k].places.end(),
                           first.parts[k].places.begin(), first.parts[k].places.end(),
                           [](const auto& a, const auto& b) { return same(a, b); }));
    EXPECT_EQ(second.parts[k].line_after, first.parts[k].line_after);
  }
  // Also where they are asked for while those before are still held.
  MemoryHistory source(h);
  const MotionInput input = checked_input(motion_input(scene), h.header);
  std::vector<std::string> remarks;
  PartReader reader(scene, input, source, options, remarks);
  std::vector<Part> held;
  while (auto part = reader.next()) held.push_back(std::move(*part));
  ASSERT_EQ(held.size(), first.parts.size());
  for (std::size_t k = held.size(); k-- > 0;) {
    const ReadPart part = told(std::move(held[k]));
    EXPECT_EQ(part.claims.size(), first.parts[k].claims.size());
    EXPECT_EQ(part.lines, first.parts[k].lines);
  }
}

// What the last part says of the file's end, others do not.
TEST(PartReader, TheLastPartEndsAsTheFile) {
  ClaimedHistory h = hits({10, 20, 30});
  h.claimed_counts.collisions = 4;
  MemoryHistory source(h);
  const CertifyOptions options = in_parts_of(1);
  const MotionInput input = checked_input(motion_input(lone()), h.header);
  const Scene scene = lone();
  std::vector<std::string> remarks;
  PartReader reader(scene, input, source, options, remarks);
  EXPECT_EQ(reader.header().horizon, 100);
  std::optional<Part> part;
  while ((part = reader.next()) && part->end) {
    EXPECT_EQ(part->claims->header().horizon, 100);
    EXPECT_EQ(part->claims->shadow_line({0, 1, 2, 3}, 0, 1), std::nullopt);
    while (part->claims->next()) {
    }
    EXPECT_TRUE(std::holds_alternative<HistoryEnd>(part->claims->ending()));
  }
  ASSERT_TRUE(part.has_value());
  EXPECT_EQ(part->claims->line(), 1);
  while (part->claims->next()) {
  }
  EXPECT_EQ(std::get<HistoryEnd>(part->claims->ending()).counts.collisions, 4);
  EXPECT_EQ(part->claims->counts().collisions, 3);
  EXPECT_FALSE(part->claims->counts_match());
}

}  // namespace
}  // namespace voroproof::internal::testing
