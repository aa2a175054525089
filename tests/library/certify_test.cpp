// The certifier of the library: verdicts, and what it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include "tests/library/scenes.h"
#include "voroproof/voroproof.h"

namespace {

using namespace voroproof;
using namespace voroproof::internal::testing;

TEST(LibraryCertify, RightUnderBothTruths) {
  const Scene scene = reference(40, 60);
  const History history = simulate(scene);
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    CertifyOptions options;
    options.truth = truth;
    options.strict = true;
    const Report report = certify(scene, history, options);
    EXPECT_EQ(report.verdict, Verdict::certified) << report.reason;
    EXPECT_EQ(report.prefix_events, static_cast<std::int64_t>(history.events.size()));
    EXPECT_NE(report.json.find("voroproof-report"), std::string::npos);
  }
}

TEST(LibraryCertify, EachKindOfWrong) {
  const Scene scene = reference(20, 60);
  const History right = simulate(scene);
  ASSERT_GT(right.events.size(), 40u);
  {
    History h = right;
    h.events.erase(h.events.begin() + 20);
    const Report report = certify(scene, h);
    EXPECT_EQ(report.verdict, Verdict::refuted);
    ASSERT_TRUE(report.divergence.has_value());
    EXPECT_EQ(report.divergence->line, 22);  // the header is line 1
    EXPECT_NE(report.evidence, "");
  }
  {
    History h = right;
    for (Event& event : h.events) {
      if (auto* collision = std::get_if<CollisionEvent>(&event)) {
        (*collision->velocity[1])[0] += 0.01;
        break;
      }
    }
    const Report report = certify(scene, h);
    EXPECT_EQ(report.verdict, Verdict::refuted);
    EXPECT_EQ(report.divergence->fault, "wrong response");
  }
  {
    History h = right;
    h.ending = {false, 30, "enough"};
    while (time(h.events.back()) > 30) h.events.pop_back();
    const Report report = certify(scene, h);
    EXPECT_EQ(report.verdict, Verdict::undecided);
    EXPECT_EQ(report.prefix_events, static_cast<std::int64_t>(h.events.size()));
  }
}

TEST(LibraryCertify, AWitnessIsExact) {
  const Scene scene = two_disks();
  History history = simulate(scene);
  history.events.erase(std::find_if(
      history.events.begin(), history.events.end(),
      [](const Event& event) { return std::holds_alternative<CollisionEvent>(event); }));
  const Report report = certify(scene, history);
  ASSERT_EQ(report.verdict, Verdict::refuted);
  const Witness& witness = report.divergence->witness;
  ASSERT_EQ(witness.generators.size(), 2u);
  // Centres -3 + t and 3 - t, that meet at the distance 2: (6 - 2 t)^2 - 4.
  EXPECT_EQ(witness.generators[0].vx.lower, Number(1));
  EXPECT_EQ(witness.generators[0].vx.upper, Number(1));
  ASSERT_EQ(witness.polynomial.size(), 3u);
  EXPECT_EQ(witness.polynomial[0].lower, Number(32));
  EXPECT_EQ(witness.polynomial[1].lower, Number(-24));
  EXPECT_EQ(witness.polynomial[2].upper, Number(4));
  ASSERT_TRUE(witness.root.has_value());
  EXPECT_LE((*witness.root)[0].nearest(), 2);
  EXPECT_GE((*witness.root)[1].nearest(), 2);
  const std::string words = explain(report);
  EXPECT_NE(words.find("missing event"), std::string::npos) << words;
  EXPECT_NE(words.find("-24"), std::string::npos) << words;
  EXPECT_NE(explain(certify(scene, simulate(scene))).find("CERTIFIED"), std::string::npos);
}

TEST(LibraryCertify, RefusesWhatIsNoHistory) {
  const Scene scene = two_disks();
  const History right = simulate(scene);
  const auto refused = [&](const char* field, const auto& spoil) {
    History h = right;
    spoil(h);
    try {
      certify(scene, h);
      ADD_FAILURE() << field;
    } catch (const InputError& error) {
      EXPECT_EQ(error.file(), "history");
      EXPECT_EQ(error.field(), field) << error.what();
    }
  };
  refused("scene_sha256", [](History& h) { h.scene_sha256[0] ^= 1; });
  refused("t", [](History& h) { h.events.push_back(FlipEvent{1, {0, 1, -1, -1}}); });
  refused("t", [](History& h) { h.events.push_back(FlipEvent{9, {0, 1, -1, -1}}); });
  refused("t", [](History& h) { h.events[0] = FlipEvent{std::nan(""), {0, 1, -1, -1}}; });
  refused("t", [](History& h) { h.events[0] = FlipEvent{-1, {0, 1, -1, -1}}; });
  refused("flip", [](History& h) { h.events[0] = FlipEvent{1, {0, 2, -1, -1}}; });
  refused("flip", [](History& h) { h.events[0] = FlipEvent{1, {0, 0, -1, -1}}; });
  refused("collide", [](History& h) { h.events[0] = CollisionEvent{1, 1, 0, {}, {}}; });
  refused("collide", [](History& h) { h.events[0] = CollisionEvent{1, 0, 2, {}, {}}; });
  refused("collide", [](History& h) { h.events[0] = CollisionEvent{1, -2, 0, {}, {}}; });
  refused("v", [](History& h) {
    h.events[0] = CollisionEvent{1, 0, 1, {Vector{1, 0}, std::nullopt}, {}};
  });
  refused("v", [](History& h) {
    h.events[0] = CollisionEvent{1, -1, 1, {Vector{1, 0}, Vector{1, 0}}, {}};
  });
  refused("maneuver", [](History& h) { h.events[0] = ManeuverEvent{1, -1, {}, {}}; });
  refused("initial", [](History& h) { h.initial->push_back(h.initial->front()); });
  refused("initial", [](History& h) { h.initial->front().l = 7; });
  refused("t", [](History& h) { h.ending = {false, 1, "too early"}; });
}

TEST(LibraryCertify, TolerancesMustMeanSomething) {
  const Scene scene = two_disks();
  const History history = simulate(scene);
  CertifyOptions options;
  options.tolerance = 9;
  EXPECT_THROW(certify(scene, history, options), std::invalid_argument);
  options.tolerance = -1;
  EXPECT_THROW(certify(scene, history, options), std::invalid_argument);
  options.tolerance = 0;
  EXPECT_EQ(certify(scene, history, options).verdict, Verdict::certified);
}

TEST(LibraryCertify, AMonitorInterrupts) {
  const Scene scene = reference(60, 400);
  const History history = simulate(scene);
  CertifyOptions options;
  options.monitor = [](double, std::int64_t) { return false; };
  EXPECT_THROW(certify(scene, history, options), Interrupted);
}

}  // namespace
