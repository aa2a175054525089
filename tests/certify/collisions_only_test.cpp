// Histories without flips, as event-driven molecular dynamics writes them (EventKinds::collisions).
#include <gtest/gtest.h>

#include <algorithm>

#include "certify/evidence/evidence.h"
#include "certify/report.h"
#include "tests/certify/handmade_history.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

CertifyOptions collisions_only(Truth truth) {
  CertifyOptions options;
  options.truth = truth;
  options.events = EventKinds::collisions;
  return options;
}

void drop_flips(History& h) {
  std::erase_if(h.events, [](const auto& e) { return std::holds_alternative<FlipEvent>(e); });
  h.header.initial.reset();
  h.count();
}

History without_flips(const Scene& scene) {
  History h = claimed_history(scene, run(scene));
  drop_flips(h);
  return h;
}

// Refuted under both truths for the missing contact of this pair, at this time, and confirmed by
// CGAL where the motion is rational.
void expect_missing(const Scene& scene, const History& h, std::pair<GenId, GenId> pair, double t) {
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    const Certificate c = certify(scene, h, collisions_only(truth));
    ASSERT_EQ(c.verdict, Verdict::refuted) << reason_line(c) << text(scene) << text(h);
    const Divergence& d = *c.divergence;
    EXPECT_EQ(d.fault, truth == Truth::exact ? Fault::missing_event : Fault::overlap)
        << reason_line(c);
    EXPECT_EQ(d.true_contact, pair) << reason_line(c);
    EXPECT_NEAR(d.t, t, 1e-9 * std::max(1.0, t)) << reason_line(c);
    const auto before = std::count_if(h.events.begin(), h.events.end(),
                                      [&](const auto& e) { return time(e) < d.t; });
    EXPECT_EQ(d.line, before + 2) << reason_line(c);
    const EvidenceCheck evidence = check_evidence(d);
    if (truth == Truth::recorded) {
      EXPECT_EQ(evidence.evidence, Evidence::confirmed) << evidence.sentence;
    } else {
      EXPECT_NE(evidence.evidence, Evidence::contradicted) << evidence.sentence;
    }
  }
}

// Whoever knows no flips is told what to ask for.
TEST(CollisionsOnly, IsWhatAHistoryWithoutFlipsIsPointedTo) {
  Random random(7);
  const Scene scene = random_scene({.n = 12, .horizon = 30}, random);
  const History whole = claimed_history(scene, run(scene));
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    CertifyOptions all;
    all.truth = truth;
    all.propose_initial = [&](Motion&) { return *whole.header.initial; };
    const Certificate c = certify(scene, without_flips(scene), all);
    ASSERT_EQ(c.verdict, Verdict::refuted);
    ASSERT_FALSE(c.remarks.empty());
    EXPECT_NE(c.remarks.back().find("--events collisions"), std::string::npos);
    EXPECT_TRUE(certify(scene, whole, all).remarks.empty());
  }
}

// Two gases in one container that pass through each other: each is simulated alone. The first
// contact of a disk of the one and a disk of the other is what is missing.
struct TwoWorlds {
  Scene scene;
  History merged;
  std::optional<CollideEvent> first_missed;
};

TwoWorlds two_worlds(const Scene& scene) {
  TwoWorlds w{scene, {}, {}};
  for (const int world : {0, 1}) {
    Scene alone = scene;
    alone.disks.clear();
    for (std::size_t k = world; k < scene.disks.size(); k += 2)
      alone.disks.push_back(scene.disks[k]);
    const auto id = [&](GenId g) { return g == container_id ? g : 2 * g + world; };
    for (auto& e : without_flips(alone).events) {
      auto& c = std::get<CollideEvent>(e);
      c.i = id(c.i);
      c.j = id(c.j);
      w.merged.events.push_back(e);
    }
  }
  std::stable_sort(w.merged.events.begin(), w.merged.events.end(),
                   [](const auto& a, const auto& b) { return time(a) < time(b); });
  w.merged.header.horizon = scene.horizon;
  w.merged.count();
  for (const auto& e : without_flips(scene).events) {
    const auto& c = std::get<CollideEvent>(e);
    if (c.i == container_id || (c.i + c.j) % 2 == 0) continue;
    w.first_missed = c;
    break;
  }
  return w;
}

TEST(CollisionsOnly, RightHistoriesAreCertifiedWithAndWithoutTheirFlips) {
  Random random(1);
  for (int k = 0; k < 30; ++k) {
    const Scene scene = random_scene({.n = 1 + 2 * k, .horizon = 40}, random);
    History all = claimed_history(scene, run(scene));
    const std::int64_t flips = all.claimed_counts.flips;
    for (const bool with_flips : {true, false}) {
      if (!with_flips) drop_flips(all);
      for (const Truth truth : {Truth::exact, Truth::recorded}) {
        const CertifyOptions options = collisions_only(truth);
        const Certificate c = certify(scene, all, options);
        EXPECT_EQ(c.verdict, Verdict::certified) << reason_line(c) << text(scene);
        EXPECT_EQ(c.collisions, all.claimed_counts.collisions);
        EXPECT_EQ(c.flips, 0);
        EXPECT_EQ(c.flips_not_judged, with_flips ? flips : 0);
        EXPECT_EQ(words_of(options, scene.horizon, c).verdict, "CERTIFIED (collisions alone)");
      }
    }
  }
}

// No test of a pair may be left out by the windows: what is refuted with all flips is refuted
// without them, for the same contact.
TEST(CollisionsOnly, EachDroppedCollisionIsMissed) {
  Random random(2);
  for (int k = 0; k < 6; ++k) {
    const Scene scene = random_scene({.n = 4 + 12 * k, .horizon = 30}, random);
    const History right = without_flips(scene);
    for (std::size_t e = 0; e < right.events.size(); e += 1 + right.events.size() / 8) {
      History wrong = right;
      const auto hit = std::get<CollideEvent>(right.events[e]);
      wrong.events.erase(wrong.events.begin() + static_cast<std::ptrdiff_t>(e));
      wrong.count();
      expect_missing(scene, wrong, {hit.i, hit.j}, hit.t);
    }
  }
}

TEST(CollisionsOnly, WorldsThatPassThroughEachOther) {
  Random random(3);
  int missed = 0;
  for (int k = 0; k < 40; ++k) {
    const Scene scene = random_scene({.n = 2 + 2 * k, .horizon = 20}, random);
    const TwoWorlds w = two_worlds(scene);
    if (!w.first_missed) {
      expect(Verdict::certified, scene, w.merged, Truth::exact, collisions_only(Truth::exact));
      continue;
    }
    ++missed;
    expect_missing(scene, w.merged, {w.first_missed->i, w.first_missed->j}, w.first_missed->t);
  }
  EXPECT_GT(missed, 20);
}

// Tiny disks that are through each other in a millionth of the time between two claims, far from
// the places at which a coarse search would look.
TEST(CollisionsOnly, TinyFastDisks) {
  const Rational tiny(1, 1'000'000);
  for (const int others : {0, 30}) {
    std::vector<DiskInput> disks{disk(-50, 0, tiny, 90, 0, 1), disk(40, 0, tiny, -90, 0, 1)};
    for (int k = 0; k < others; ++k) disks.push_back(disk(3 * k - 45, 60, 1, 0, 0));
    const Scene scene = scene_of(100, 1, disks);
    const History right = without_flips(scene);
    ASSERT_GE(right.events.size(), 1u);
    History wrong = history_of(scene, {}, {});
    wrong.header.initial.reset();
    // They have exchanged their places: their ways to the wall are those of the other.
    for (const auto& e : two_worlds(scene).merged.events) wrong.events.push_back(e);
    wrong.count();
    expect_missing(scene, wrong, {0, 1}, (90 - 2e-6) / 180);
  }
}

TEST(CollisionsOnly, AtTheStart) {
  const Scene scene = scene_of(100, 10, {disk(-1, 0, 1, 1, 0), disk(1, 0, 1, -1, 0)});
  History h = history_of(scene, {}, {collision(0, 0, 1, Vec2{-1, 0}, {1, 0})});
  h.header.initial.reset();
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect(Verdict::certified, scene, h, truth, collisions_only(truth));
  }
  h.events.clear();
  h.count();
  expect_missing(scene, h, {0, 1}, 0);
}

// A maneuver turns a disk towards another that it touches already.
TEST(CollisionsOnly, AtAManeuver) {
  Scene scene = scene_of(100, 10, {disk(-1, 0, 1, 0, 0), disk(1, 0, 1, 0, 0)});
  scene.maneuvers.push_back({2, 0, 1, 0});
  History h = without_flips(scene);
  ASSERT_EQ(h.events.size(), 2u);
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect(Verdict::certified, scene, h, truth, collisions_only(truth));
  }
  h.events.pop_back();
  h.count();
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    const Certificate c = certify(scene, h, collisions_only(truth));
    EXPECT_EQ(c.verdict, Verdict::refuted) << reason_line(c);
    EXPECT_EQ(c.divergence->true_contact, std::pair(0, 1)) << reason_line(c);
  }
  // And the maneuver itself.
  h.events.clear();
  h.count();
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect(Verdict::refuted, scene, h, truth, collisions_only(truth));
  }
}

// What happens at the horizon belongs to the history; under the recorded truth what comes within
// the tolerance of it may be left out, and is counted.
TEST(CollisionsOnly, AtTheHorizon) {
  for (const bool before : {true, false}) {
    const Rational horizon = before ? Rational(4) : Rational(4) - Rational(1, 100'000'000);
    const Scene scene = scene_of(100, horizon, {disk(-5, 0, 1, 1, 0), disk(5, 0, 1, -1, 0)});
    History h = history_of(scene, {}, {});
    h.header.initial.reset();
    const Certificate exact = certify(scene, h, collisions_only(Truth::exact));
    EXPECT_EQ(exact.verdict, before ? Verdict::refuted : Verdict::certified) << reason_line(exact);
    const Certificate recorded = certify(scene, h, collisions_only(Truth::recorded));
    EXPECT_EQ(recorded.verdict, Verdict::certified) << reason_line(recorded);
  }
  const Scene scene = scene_of(100, Rational(4) + Rational(1, 100'000),
                               {disk(-5, 0, 1, 1, 0), disk(5, 0, 1, -1, 0)});
  History h = history_of(scene, {}, {});
  h.header.initial.reset();
  expect_missing(scene, h, {0, 1}, 4);
}

// Disks and walls that are never reached, none at all, and points.
TEST(CollisionsOnly, SmallScenes) {
  for (const int disks : {0, 1, 2}) {
    for (const int radius : {0, 1}) {
      std::vector<DiskInput> all;
      for (int k = 0; k < disks; ++k) all.push_back(disk(4 * k, 1, radius, 1, 0, 1));
      const Scene scene = scene_of(10, 3, all);
      for (const Truth truth : {Truth::exact, Truth::recorded}) {
        expect(Verdict::certified, scene, without_flips(scene), truth, collisions_only(truth));
      }
    }
  }
  // One that leaves the container.
  const Scene scene = scene_of(10, 30, {disk(0, 0, 1, 1, 0)});
  History h = history_of(scene, {}, {});
  h.header.initial.reset();
  expect_missing(scene, h, {container_id, 0}, 9);
}

// Two that are through each other and turn away, all within the tolerance: an answer may still come
// when their boxes have parted, and does not.
// They have no law; a collision of the two that is claimed soon after is none of their meeting.
TEST(CollisionsOnly, PointsThatMeetBeforeTheirClaim) {
  const Scene scene =
      scene_of(16, 2, {disk(4.875, -0.875, 0, 0.25, 1.75), disk(4.75, 0, 0, 0.5, 0)});
  CollideEvent late{.t = 0.5000004998509884, .i = 0, .j = 1};
  late.p = {Vec2{5.000000124962747, 8.747392296615253e-7}, Vec2{5.0000002499254945, 0}};
  const Certificate c =
      certify(scene, history_of(scene, {}, {late}), collisions_only(Truth::recorded));
  EXPECT_EQ(c.verdict, Verdict::undecided) << reason_line(c);
  EXPECT_NE(reason_line(c).find("meet"), std::string::npos) << reason_line(c);
}

TEST(CollisionsOnly, NeverAnsweredAfterTurningAway) {
  const Rational tiny(1, 1'000'000);
  Scene scene = scene_of(100, 2, {disk(-40, 0, tiny, 40, 0, 1), disk(40, 0, tiny, -40, 0, 1)});
  const Rational turn = Rational(1) + Rational(1, 4'000'000);
  scene.maneuvers.push_back({turn, 0, 50, 0});
  scene.maneuvers.push_back({turn, 1, -50, 0});
  History h = history_of(scene, {},
                         {ManeuverEvent{.t = turn.get_d(), .disk = 0, .v = Vec2{50, 0}},
                          ManeuverEvent{.t = turn.get_d(), .disk = 1, .v = Vec2{-50, 0}}});
  h.header.initial.reset();
  const Certificate c = certify(scene, h, collisions_only(Truth::recorded));
  ASSERT_EQ(c.verdict, Verdict::refuted) << reason_line(c);
  EXPECT_EQ(c.divergence->true_contact, std::pair(0, 1)) << reason_line(c);
}

TEST(CollisionsOnly, SpuriousAndMistimedCollisions) {
  const Scene scene = scene_of(100, 10, {disk(-5, 0, 1, 1, 0), disk(5, 0, 1, -1, 0)});
  const History right = without_flips(scene);
  ASSERT_EQ(right.events.size(), 1u);
  for (const double shift : {-1e-4, 1e-4, -1.0}) {
    History wrong = right;
    auto& c = std::get<CollideEvent>(wrong.events[0]);
    c.t += shift;
    c.p = {};
    for (const Truth truth : {Truth::exact, Truth::recorded}) {
      expect(Verdict::refuted, scene, wrong, truth, collisions_only(truth));
    }
  }
  History twice = right;
  twice.events.push_back(twice.events[0]);
  twice.count();
  History wrong_velocity = right;
  std::get<CollideEvent>(wrong_velocity.events[0]).v = {Vec2{-1, 1e-3}, Vec2{1, 0}};
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect(Verdict::refuted, scene, twice, truth, collisions_only(truth));
    expect(Verdict::refuted, scene, wrong_velocity, truth, collisions_only(truth));
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
