// Shards of a history, put together, are the whole: its verdict, its counts, its report. And a cut
// between them is bound to all that it depends on.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "certify/fingerprint.h"
#include "certify/replay.h"
#include "certify/report.h"
#include "history/history_reader.h"
#include "history/history_writer.h"
#include "tests/certify/claimed_history.h"
#include "tests/certify/mutation.h"
#include "tests/history/temporary_directory.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

CertifyOptions recorded(std::size_t least) {
  CertifyOptions options;
  options.truth = Truth::recorded;
  options.least_part = least;
  return options;
}

std::string report_of(const Certificate& c) { return report_text({}, recorded(1), c); }

Shard shard(const Scene& scene, const ClaimedHistory& history, const CertifyOptions& options,
            const ShardTask& task) {
  MemoryHistory source(history);
  return certify_shard(scene, source, options, task);
}

// The same of the history as a file, the bytes of which a cut is bound to.
Shard shard_of_file(const Scene& scene, const ClaimedHistory& history,
                    const CertifyOptions& options, const ShardTask& task) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.history.jsonl");
  HistoryWriter writer(path);
  HistoryHeader header = history.header;
  header.scene_sha256 = std::string(64, '0');
  writer.header(header);
  for (const auto& event : history.events) writer.write(event);
  writer.end();
  writer.close();
  const auto source = open_history(path, static_cast<int>(scene.disks.size()));
  return certify_shard(scene, *source, options, task);
}

// All shards up to the first that is not certified.
std::vector<Shard> shards_of(const Scene& scene, const ClaimedHistory& history,
                             const CertifyOptions& options, int of) {
  std::vector<Shard> all;
  for (int k = 1; k <= of; ++k) {
    all.push_back(shard(scene, history, options, {.number = k, .of = of}));
    if (all.back().certificate.verdict != Verdict::certified) break;
  }
  return all;
}

// The certificate of all, each of which goes on where the one before it ended.
Certificate joined(std::vector<Shard> shards) {
  EXPECT_EQ(shards.front().begin.value().claims, HistoryCounts{});
  Certificate whole = std::move(shards.front().certificate);
  for (std::size_t k = 1; k < shards.size(); ++k) {
    EXPECT_EQ(shards[k].begin, shards[k - 1].end) << k;
    if (shards[k].begin == shards[k].end && shards[k].certificate.verdict == Verdict::certified) {
      EXPECT_EQ(shards[k].certificate.prefix_events, 0);
      continue;
    }
    append(whole, std::move(shards[k].certificate));
  }
  if (whole.verdict == Verdict::certified) {
    EXPECT_EQ(shards.back().end, std::nullopt);
  }
  return whole;
}

Scene some_scene(Random& random, int n = 14) {
  return random_scene({.n = n, .rmin = 0.1, .rmax = 30, .horizon = 30, .density = 0.3}, random);
}

TEST(Shards, TogetherAreTheWhole) {
  Random random(3);
  std::array<int, 3> verdicts{};
  for (int k = 0; k < 60; ++k) {
    const Scene scene = some_scene(random);
    const RecordedRun r = run(scene);
    if (!r.complete()) continue;
    const ClaimedHistory right = claimed_history(scene, r);
    std::vector<ClaimedHistory> histories{right, right};
    histories[1].header.oriented = false;
    const auto kind = static_cast<Mutation>(k % static_cast<int>(Mutation::count));
    if (auto wrong = mutate(scene, right, kind, 1e-6, 1e-9, random)) histories.push_back(*wrong);
    const CertifyOptions options = recorded(k % 2 == 0 ? 1 : 25);
    for (const ClaimedHistory& history : histories) {
      const Certificate whole = certify(scene, history, options);
      ++verdicts[static_cast<int>(whole.verdict)];
      for (const int of : {1, 2, 7}) {
        const Certificate together = joined(shards_of(scene, history, options, of));
        ASSERT_EQ(report_of(together), report_of(whole)) << k << ", " << of << " shards";
      }
    }
  }
  EXPECT_GT(verdicts[static_cast<int>(Verdict::certified)], 50);
  EXPECT_GT(verdicts[static_cast<int>(Verdict::refuted)], 30);
}

// Where a history is over early, or has no event, or its scene has no disk.
TEST(Shards, WithoutAPart) {
  Random random(4);
  const Scene scene = some_scene(random, 3);
  const ClaimedHistory right = claimed_history(scene, run(scene));
  std::size_t empty = 0;
  for (const Shard& s : shards_of(scene, right, recorded(1), 500)) empty += s.begin == s.end;
  EXPECT_GT(empty, 100u);
  EXPECT_EQ(report_of(joined(shards_of(scene, right, recorded(1), 500))),
            report_of(certify(scene, right, recorded(1))));
  for (const int disks : {0, 1}) {
    Scene little = scene;
    little.disks.resize(disks);
    little.maneuvers.clear();
    const ClaimedHistory told = claimed_history(little, run(little));
    EXPECT_EQ(report_of(joined(shards_of(little, told, recorded(1), 3))),
              report_of(certify(little, told, recorded(1))));
  }
}

// From every cut at which a run may have been broken off.
TEST(Shards, TakenUpAnywhere) {
  Random random(5);
  const Scene scene = some_scene(random);
  const ClaimedHistory right = claimed_history(scene, run(scene));
  ClaimedHistory wrong = right;
  wrong.events.erase(wrong.events.end() - 20);
  wrong.count();
  for (const ClaimedHistory& history : {right, wrong}) {
    const CertifyOptions options = recorded(10);
    const std::string whole = report_of(certify(scene, history, options));
    std::vector<Shard> begun;
    shard(
        scene, history, options,
        {.is_due = [] { return true; }, .proved = [&](Shard s) { begun.push_back(std::move(s)); }});
    ASSERT_GT(begun.size(), 10u);
    for (const Shard& before : begun) {
      ASSERT_TRUE(before.end);
      Shard rest = shard(scene, history, options, {.from = before.end});
      ASSERT_EQ(rest.begin, before.end);
      ASSERT_EQ(report_of(joined({before, std::move(rest)})), whole);
    }
  }
}

// What differs before a cut makes it another cut, whatever it is.
TEST(Shards, ACutIsBoundToAllBeforeIt) {
  Random random(6);
  const Scene scene = some_scene(random);
  const ClaimedHistory right = claimed_history(scene, run(scene));
  const CertifyOptions options = recorded(10);
  const Cut cut = shard_of_file(scene, right, options, {.number = 2, .of = 2}).begin.value();
  ASSERT_GT(cut.claims.all(), 30);
  const auto refused = [&](const Scene& other_scene, const ClaimedHistory& other) {
    EXPECT_THROW(shard_of_file(other_scene, other, options, {.from = cut}), OtherHistory);
  };
  const std::size_t before = static_cast<std::size_t>(cut.claims.all());
  int collisions = 0;
  for (std::size_t k = 0; k < before; ++k) {
    ClaimedHistory other = right;
    if (auto* flip = std::get_if<FlipEvent>(&other.events[k])) {
      flip->t = std::nextafter(flip->t, 0);
      refused(scene, other);
    } else if (auto* c = std::get_if<CollideEvent>(&other.events[k])) {
      (*c->v[1])[0] = std::nextafter((*c->v[1])[0], 9);
      refused(scene, other);
      other = right;
      auto& same = std::get<CollideEvent>(other.events[k]);
      same.p[1].reset();
      same.p[0].reset();
      refused(scene, other);
      ++collisions;
    }
  }
  EXPECT_GT(collisions, 3);
  ClaimedHistory other = right;
  other.header.horizon += 1;
  refused(scene, other);
  other = right;
  other.header.producer += " 2";
  refused(scene, other);
  Scene heavier = scene;
  heavier.disks[3].mass = Rational(2 * heavier.disks[3].mass.value());
  refused(heavier, right);
  // What comes after the cut does not matter to it.
  other = right;
  other.events.pop_back();
  EXPECT_EQ(shard_of_file(scene, other, options, {.from = cut}).begin, cut);
}

// The claims are right, and what somebody says of the state is not.
TEST(Shards, ACutThatLies) {
  Random random(7);
  const Scene scene = some_scene(random);
  const ClaimedHistory right = claimed_history(scene, run(scene));
  const CertifyOptions options = recorded(10);
  const Cut cut = shard(scene, right, options, {.number = 2, .of = 2}).begin.value();
  const std::vector<std::function<void(Cut&)>> lies{[](Cut& c) { ++c.part; },
                                                    [](Cut& c) { c.t = std::nextafter(c.t, 0); },
                                                    [](Cut& c) { --c.claims.flips; },
                                                    [](Cut& c) { ++c.line; },
                                                    [](Cut& c) { c.bytes_sha256[5] ^= 1; },
                                                    [](Cut& c) { c.state_sha256[5] ^= 1; }};
  for (std::size_t k = 0; k < lies.size(); ++k) {
    Cut lie = cut;
    lies[k](lie);
    EXPECT_THROW(shard(scene, right, options, {.from = lie}), OtherHistory) << k;
  }
  EXPECT_NO_THROW(shard(scene, right, options, {.from = cut}));
}

std::string state_of(const Replay& replay) {
  Fingerprint fingerprint;
  replay.add_to(fingerprint);
  return fingerprint.hex();
}

// Each kind of claim changes the state, and two replays of the same claims have one.
TEST(Shards, AStateIsBoundToAllInIt) {
  Random random(9);
  Scene scene = some_scene(random);
  scene.maneuvers = {{Rational(1), 0, Rational(1), Rational(2)},
                     {Rational(1), 1, Rational(1), Rational(2)}};
  const ClaimedHistory right = claimed_history(scene, run(scene));
  const CertifyOptions options = recorded(1);
  Replay one(scene, options), other(scene, options);
  std::set<std::string> states{state_of(one)};
  for (Replay* replay : {&one, &other}) {
    replay->diagram() = diagram_of(replay->disks(), *right.header.initial);
  }
  EXPECT_TRUE(states.insert(state_of(one)).second);
  for (const auto& event : right.events) {
    ASSERT_FALSE(one.take(event).is_none());
    ASSERT_FALSE(other.take(event).is_none());
    EXPECT_TRUE(states.insert(state_of(one)).second) << time(event);
    EXPECT_EQ(state_of(one), state_of(other));
  }
  // One maneuver is claimed for the other, at the same time and with the same velocity.
  Replay first(scene, options), second(scene, options);
  first.note_maneuver(0, {.t = 1, .disk = 0});
  second.note_maneuver(1, {.t = 1, .disk = 0});
  EXPECT_NE(state_of(first), state_of(second));
}

TEST(Shards, AreOfTheRecordedTruthAndOfAllEvents) {
  Random random(8);
  const Scene scene = some_scene(random, 3);
  const ClaimedHistory right = claimed_history(scene, run(scene));
  CertifyOptions options = recorded(1);
  options.truth = Truth::exact;
  EXPECT_THROW(shard(scene, right, options, {}), std::invalid_argument);
  options = recorded(1);
  options.events = EventKinds::collisions;
  EXPECT_THROW(shard(scene, right, options, {}), std::invalid_argument);
}

}  // namespace
}  // namespace voroproof::internal::testing
