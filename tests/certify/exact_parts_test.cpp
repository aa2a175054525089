// The exact truth is proved in parts of any size, on any number of threads, with the verdict that
// one piece has.
#include "certify/exact_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/report.h"
#include "certify/wording.h"
#include "history/error.h"
#include "history/scene_motion.h"
#include "tests/certify/broken_history.h"
#include "tests/certify/claimed_history.h"
#include "tests/certify/handmade_history.h"
#include "tests/certify/mutation.h"
#include "tests/certify/mutation_scenes.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

namespace fs = std::filesystem;

// The verdict of a certificate and what it is about. Enclosures of roots are left out: a root is
// isolated from the begin of the life on, which a cut may be.
std::string told(const Certificate& c) {
  std::string text =
      std::string(verdict_line(c.verdict)) + " " + c.reason + " " + std::to_string(c.reason_line);
  for (const std::string& remark : c.remarks) text += "; " + remark;
  if (!c.divergence) return text;
  const Divergence& d = *c.divergence;
  text +=
      std::string(fault_names[static_cast<std::size_t>(d.fault)]) + " " + std::to_string(d.line);
  if (d.claim) text += " claimed at " + std::to_string(time(*d.claim));
  if (d.true_flip) text += " flip " + text_of(*d.true_flip);
  if (d.true_contact) text += " contact " + text_of(d.true_contact->first, d.true_contact->second);
  return text;
}

// What is proved is counted once, in whatever parts.
std::array<std::int64_t, 6> counts(const Certificate& c) {
  return {c.flips, c.collisions, c.maneuvers, c.swaps, c.resolved, c.prefix_events};
}

CertifyOptions in_one_piece() {
  CertifyOptions options;
  options.least_part = std::size_t{1} << 40;
  return options;
}

// Where the whole is undecided, for want of bits, shorter lives may be decided.
Verdict expect_the_same_in_parts(const Scene& scene, const ClaimedHistory& h,
                                 const std::string& what, CertifyOptions options = {}) {
  options.least_part = in_one_piece().least_part;
  const Certificate whole = certify(scene, h, options);
  for (const std::size_t least : {1, 7}) {
    CertifyOptions in_parts = options;
    in_parts.least_part = least;
    in_parts.threads = least == 1 ? 1 : 2;
    const Certificate parts = certify(scene, h, in_parts);
    const bool more_is_decided =
        whole.verdict == Verdict::undecided && parts.verdict != Verdict::undecided;
    if (more_is_decided && options.motion.max_bits < CertifyOptions{}.motion.max_bits) continue;
    EXPECT_EQ(told(parts), told(whole)) << what << ", parts of " << least << "\n" << text(h);
    if (whole.verdict != Verdict::certified) continue;
    EXPECT_EQ(counts(parts), counts(whole)) << what << ", parts of " << least;
  }
  return whole.verdict;
}

// How a history is certified in parts, and which part is judged with all that follows it.
struct InParts {
  Certificate certificate;
  std::size_t parts = 0;
  std::optional<std::size_t> rest;
  bool rest_is_last = false;
};

InParts certify_by_parts(const Scene& scene, const ClaimedHistory& h,
                         const CertifyOptions& options) {
  MemoryHistory source(h);
  const MotionInput input = motion_input(scene);
  ExactParts exact(scene, input, source.header(), options);
  PartTruth truth = exact.truth();
  InParts out;
  PartTruth counted{.prove = truth.prove,
                    .lead =
                        [&](Part& part, HistorySource& turns, const CertifyOptions& o) {
                          ++out.parts;
                          out.rest_is_last = !part.end;
                          return truth.lead(part, turns, o);
                        },
                    .rest =
                        [&](Part& part, const CertifyOptions& o) {
                          out.rest = part.number;
                          return truth.rest(part, o);
                        }};
  out.certificate = certify_in_parts(scene, input, source, options, counted);
  return out;
}

// A right history is proved in its parts: only the last is judged as one piece is.
TEST(ExactParts, OfARightHistoryOnlyTheLastIsTheRest) {
  Random random(3);
  for (const int maneuvers : {0, 12}) {
    const Scene scene = random_scene({.n = 20, .horizon = 60, .maneuvers = maneuvers}, random);
    ClaimedHistory h = claimed_history(scene, run(scene));
    ASSERT_GT(h.events.size(), 150u);
    for (const bool velocities : {true, false}) {
      if (!velocities) {
        for (auto& event : h.events) {
          if (auto* c = std::get_if<CollideEvent>(&event)) c->v = {};
        }
      }
      CertifyOptions options;
      options.least_part = 8;
      const InParts p = certify_by_parts(scene, h, options);
      EXPECT_EQ(p.certificate.verdict, Verdict::certified) << reason_line(p.certificate);
      EXPECT_GT(p.parts, 8u);
      EXPECT_EQ(p.rest, p.parts - 1);
      EXPECT_TRUE(p.rest_is_last);
      expect_the_same_in_parts(scene, h, "velocities " + std::to_string(velocities));
    }
  }
}

TEST(ExactParts, AnyNumberOfThreads) {
  Random random(11);
  const Scene scene = random_scene({.n = 30, .horizon = 60, .maneuvers = 5}, random);
  const ClaimedHistory right = claimed_history(scene, run(scene));
  ASSERT_GT(right.events.size(), 300u);
  std::vector<ClaimedHistory> histories{right};
  for (const std::size_t k : {20u, 200u, 290u}) {
    ClaimedHistory wrong = right;
    wrong.events.erase(wrong.events.begin() + static_cast<std::ptrdiff_t>(k));
    wrong.count();
    histories.push_back(wrong);
    for (auto& event : wrong.events) {
      if (auto* c = std::get_if<CollideEvent>(&event); c != nullptr && c->t > time(right.events[k]))
        (*c->v[1])[0] += 1e-3;
    }
    histories.push_back(wrong);
  }
  ClaimedHistory stops = right;
  stops.events.resize(250);
  stops.stop.emplace();
  stops.stop->t = time(stops.events.back());
  stops.stop->reason = "enough";
  histories.push_back(stops);
  for (const ClaimedHistory& history : histories) {
    std::string first;
    for (const int threads : {1, 2, 3, 8}) {
      CertifyOptions options;
      options.least_part = 20;
      options.threads = threads;
      const std::string report = report_text({}, options, certify(scene, history, options));
      if (first.empty()) first = report;
      EXPECT_EQ(report, first) << threads << " threads";
    }
    expect_the_same_in_parts(scene, history, first);
  }
}

TEST(ExactParts, MutantsAreJudgedAsInOnePiece) {
  Random random(5);
  std::array<int, 3> verdicts{};
  for (const Scene& scene : some_scenes(random, 1)) {
    const RecordedRun r = run(scene);
    if (!r.complete()) continue;
    const ClaimedHistory right = claimed_history(scene, r);
    expect_the_same_in_parts(scene, right, "right");
    for (int kind = 0; kind < static_cast<int>(Mutation::count); ++kind) {
      const auto wrong = mutate(scene, right, static_cast<Mutation>(kind), 1e-6, 0, random);
      if (!wrong) continue;
      ++verdicts[static_cast<int>(
          expect_the_same_in_parts(scene, *wrong, std::string(mutation_names[kind])))];
    }
  }
  std::cout << verdicts[0] << " certified, " << verdicts[1] << " refuted, " << verdicts[2]
            << " undecided\n";
  EXPECT_GT(verdicts[static_cast<int>(Verdict::refuted)], 100);
}

// The histories of the corpus, right and wrong, with ties, points, maneuvers and few bits; and
// without orientation.
TEST(ExactParts, Corpus) {
  std::array<int, 3> verdicts{};
  int in_parts = 0;
  for (const auto& entry : fs::recursive_directory_iterator(VOROPROOF_CASES)) {
    const std::string path = entry.path().string();
    if (!path.ends_with(".history.jsonl")) continue;
    fs::path folder = entry.path().parent_path();
    if (folder.filename() == "wrong") folder = folder.parent_path();
    const Scene scene = read_scene((folder / "scene.scene.json").string());
    if (scene.disks.size() > 12) continue;
    auto h = read_claimed_history(path, scene);
    if (!h || h->events.size() > 60) continue;
    CertifyOptions options;
    options.motion.max_bits = 1024;
    options.motion.max_radicals = 2;
    ++verdicts[static_cast<int>(expect_the_same_in_parts(scene, *h, path, options))];
    options.least_part = 1;
    in_parts += certify_by_parts(scene, *h, options).rest.value_or(0) > 0;
    h->header.oriented = false;
    for (auto& event : h->events) {
      auto* flip = std::get_if<FlipEvent>(&event);
      if (flip != nullptr && flip->quad.s > flip->quad.e) std::swap(flip->quad.s, flip->quad.e);
    }
    expect_the_same_in_parts(scene, *h, path + " without orientation", options);
  }
  std::cout << verdicts[0] << " certified, " << verdicts[1] << " refuted, " << verdicts[2]
            << " undecided, " << in_parts << " in parts\n";
  EXPECT_GT(verdicts[static_cast<int>(Verdict::certified)], 100);
  EXPECT_GT(in_parts, 100);
}

// What comes before a line that cannot be read may be refuted.
TEST(ExactParts, ALineThatCannotBeRead) {
  Random random(4);
  const Scene scene = random_scene({.n = 10, .horizon = 40}, random);
  const ClaimedHistory right = claimed_history(scene, run(scene));
  ASSERT_GT(right.events.size(), 40u);
  ClaimedHistory wrong = right;
  wrong.events.erase(wrong.events.begin() + 12);
  for (const std::size_t least : {std::size_t{1}, std::size_t{9}, in_one_piece().least_part}) {
    for (const int threads : {1, 3}) {
      CertifyOptions options;
      options.least_part = least;
      options.threads = threads;
      for (const std::size_t readable : {0u, 1u, 20u, 38u}) {
        BrokenHistory source(right, readable);
        EXPECT_THROW(internal::certify(scene, source, options), InputError) << readable;
      }
      BrokenHistory source(wrong, 38);
      EXPECT_EQ(internal::certify(scene, source, options).verdict, Verdict::refuted) << least;
    }
  }
}

TEST(ExactParts, Interrupted) {
  Random random(9);
  const Scene scene = random_scene({.n = 40, .horizon = 60}, random);
  const ClaimedHistory h = claimed_history(scene, run(scene));
  const auto all = static_cast<std::int64_t>(h.events.size());
  ASSERT_GT(all, 600);
  for (const int threads : {1, 2, 8}) {
    std::int64_t last = 0;
    CertifyOptions options;
    options.least_part = 16;
    options.threads = threads;
    const std::int64_t most = all / 2;
    options.monitor = [&](double, std::int64_t events) {
      EXPECT_GE(events + 16 * 300, last);
      last = events;
      return events < most;
    };
    try {
      certify(scene, h, options);
      ADD_FAILURE() << threads << " threads: nobody asked";
    } catch (const CertificationInterrupted& c) {
      EXPECT_GE(c.prefix_events, most);
      EXPECT_LT(c.prefix_events, all);
      EXPECT_NEAR(c.prefix_t, time(h.events[static_cast<std::size_t>(c.prefix_events)]), 1);
    }
  }
}

// ---- What a checker asks of the leader. ----

// A right history of which something in the second part is changed after it was led: the number of
// the part from which on all is judged by the rest.
class Changed {
 public:
  Changed() {
    Random random(3);
    scene_ = random_scene({.n = 20, .horizon = 60, .maneuvers = 30}, random);
    history_ = claimed_history(scene_, run(scene_));
    options_.least_part = 60;
  }

  std::optional<std::size_t> rest_after(const std::function<void(Part&)>& change) const {
    MemoryHistory source(history_);
    const MotionInput input = motion_input(scene_);
    ExactParts exact(scene_, input, source.header(), options_);
    const PartTruth truth = exact.truth();
    std::optional<std::size_t> rest;
    PartTruth other = truth;
    other.lead = [&](Part& part, HistorySource& turns, const CertifyOptions& o) {
      if (!truth.lead(part, turns, o)) return false;
      if (part.number == 1) change(part);
      return true;
    };
    other.rest = [&](Part& part, const CertifyOptions& o) {
      rest = part.number;
      return truth.rest(part, o);
    };
    const Certificate c = certify_in_parts(scene_, input, source, options_, other);
    EXPECT_EQ(c.verdict, Verdict::certified);
    return rest;
  }

 private:
  Scene scene_;
  ClaimedHistory history_;
  CertifyOptions options_;
};

TEST(ExactParts, TurnsOfTheLeaderThatAreOthersProveNothing) {
  const Changed changed;
  const auto rest_after = [&](const std::function<void(std::vector<TrueTurn>&)>& change) {
    return changed.rest_after([&](Part& part) {
      auto led = std::make_shared<LedPart>(*part.led);
      change(led->turns);
      part.led = led;
    });
  };
  using Turns = std::vector<TrueTurn>;
  const auto is_maneuver = [](const TrueTurn& turn) {
    return turn.maneuver != TrueTurn::no_maneuver;
  };
  const auto collision = [&](Turns& turns) {
    return std::find_if_not(turns.begin(), turns.end(), is_maneuver);
  };
  const auto maneuver = [&](Turns& turns) {
    return std::find_if(turns.begin(), turns.end(), is_maneuver);
  };
  const auto unchanged = rest_after([&](Turns& turns) {
    ASSERT_NE(collision(turns), turns.end());
    ASSERT_NE(maneuver(turns), turns.end());
  });
  ASSERT_GT(unchanged, 1u);
  EXPECT_EQ(rest_after([](Turns& turns) { turns.push_back(turns.back()); }), 1u);
  EXPECT_EQ(rest_after([](Turns& turns) { turns.pop_back(); }), 1u);
  EXPECT_EQ(rest_after([&](Turns& turns) { collision(turns)->near += 1e-3; }), 1u);
  EXPECT_EQ(rest_after([&](Turns& turns) { collision(turns)->led.i ^= 1; }), 1u);
  EXPECT_EQ(rest_after([&](Turns& turns) { collision(turns)->led.j ^= 1; }), 1u);
  EXPECT_EQ(rest_after([&](Turns& turns) { collision(turns)->maneuver = 0; }), 1u);
  EXPECT_EQ(rest_after([&](Turns& turns) { ++maneuver(turns)->maneuver; }), 1u);
}

// An end that is no later than the last event, as a cut between claims that are as near each other
// as binary64 allows: what happens up to there would be proved for a time before.
TEST(ExactParts, APartThatEndsWithItsLastEvent) {
  const Changed changed;
  const auto last = [](const Part& part) { return time(*part.list->event(part.list->size() - 1)); };
  ASSERT_GT(changed.rest_after([&](Part& part) { ASSERT_GT(part.end->t, last(part)); }), 1u);
  EXPECT_EQ(changed.rest_after([&](Part& part) { part.end->t = last(part) - 1e-9; }), 1u);
}

}  // namespace
}  // namespace voroproof::internal::testing
