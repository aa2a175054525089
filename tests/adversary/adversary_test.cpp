// Some thousand wrong worlds of fixed seeds, and the finds of earlier campaigns (cases/).
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/adversary/campaign.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::adversary {
namespace {

std::string told(const Made& m, Truth truth, const Judgement& j) {
  std::ostringstream out;
  out << name(find_of(j)) << ": seed " << m.recipe.seed << ", family " << name(m.recipe.family)
      << ", " << kind_of(m.recipe) << ", truth " << name(truth) << "\ncertifier "
      << name(j.certifier.verdict) << " " << j.certifier.reason << "\nkernel "
      << name(j.kernel.verdict) << " " << j.kernel.reason << "\noracle "
      << (j.opinion ? j.opinion->why : "not asked");
  return out.str();
}

void expect_no_find(const Made& m, Truth truth, const Judgement& j) {
  EXPECT_EQ(find_of(j), Find::none) << told(m, truth, j);
}

TEST(Adversary, NoFindInMixedWorlds) {
  Campaign campaign(false);
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    campaign.run(seed, {}, {}, expect_no_find);
  }
  EXPECT_GT(campaign.histories(), 1500);
}

// So many histories of each fault are made and refuted that a generator that makes nothing is seen.
TEST(Adversary, EachFaultIsMadeAndRefuted) {
  Campaign campaign(false);
  for (int kind = 1; kind < static_cast<int>(FaultKind::count); ++kind) {
    for (std::uint64_t seed = 100000; seed < 100120; ++seed) {
      campaign.run(seed, {}, static_cast<FaultKind>(kind), expect_no_find);
    }
    // Faults of special scenes find their place there.
    for (const Family family :
         {Family::touching, Family::touch_maneuver, Family::inelastic, Family::lattice}) {
      for (std::uint64_t seed = 200000; seed < 200025; ++seed) {
        campaign.run(seed, family, static_cast<FaultKind>(kind), expect_no_find);
      }
    }
  }
  for (int kind = 1; kind < static_cast<int>(FaultKind::count); ++kind) {
    const std::string fault(fault_names[static_cast<std::size_t>(kind)]);
    for (const Truth truth : truths) {
      const auto found = campaign.by_kind().find({fault, static_cast<int>(truth)});
      ASSERT_NE(found, campaign.by_kind().end()) << fault;
      const Count& c = found->second;
      EXPECT_GE(c.made, 5) << fault;
      EXPECT_GE(c.certifier[static_cast<std::size_t>(Verdict::refuted)], 3) << fault;
    }
  }
}

// Right histories of scenes in general position are found right by the oracle, nearly all.
TEST(Adversary, RightWorldsAreRight) {
  Campaign campaign(false);
  for (std::uint64_t seed = 300000; seed < 300300; ++seed) {
    campaign.run(seed, static_cast<Family>(seed % 9), FaultKind::none, expect_no_find);
  }
  for (const Truth truth : truths) {
    const Count& c = campaign.by_kind().at({"none", static_cast<int>(truth)});
    EXPECT_GE(c.oracle_right * 10, c.made * 9);
    EXPECT_GE(c.certifier[static_cast<std::size_t>(Verdict::certified)] * 10, c.made * 9);
  }
}

// A disk that turns late is outside the container for a moment and comes back beside another edge.
// The oracle looks soon after a turn, too, and not where a disk is outside.
TEST(Adversary, LooksSoonAfterATurn) {
  Campaign campaign(false);
  int wrong = 0;
  campaign.run(1400080019, Family::crowded, {}, [&](const Made& m, Truth truth, const auto& j) {
    expect_no_find(m, truth, j);
    wrong += j.opinion && j.opinion->finding == Finding::wrong;
  });
  EXPECT_EQ(wrong, 1);
}

// Two flips that are wrong only together, and nothing is looked at between them and the horizon.
TEST(Adversary, OracleLeavesOpenWhatTheHorizonHides) {
  Campaign campaign(false);
  campaign.run(1900138724, Family::crowded, {}, expect_no_find);
  EXPECT_EQ(campaign.by_kind().at({"rewritten", static_cast<int>(Truth::recorded)}).oracle_unclear,
            1);
}

struct ExpectedVerdict {
  Truth truth;
  std::string verdict;
  Asking asking{};
};

// The lines "truth verdict", with a tolerance and a number of bits behind where they are not the
// usual ones.
std::vector<ExpectedVerdict> read_verdicts(const std::filesystem::path& path) {
  std::vector<ExpectedVerdict> all;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string truth, tolerance;
    int bits;
    ExpectedVerdict expected;
    words >> truth >> expected.verdict;
    expected.truth = truth == name(Truth::exact) ? Truth::exact : Truth::recorded;
    if (words >> tolerance) expected.asking.tolerance = parse_rational(tolerance).value();
    if (words >> bits) expected.asking.bits = bits;
    all.push_back(expected);
  }
  return all;
}

// What the engine writes of the scene must be right under the exact truth, whatever the case's own
// history claims. (Under the recorded one rounded velocities may break a tie.) The tolerance is no
// less than what rounding does to times.
void expect_own_history_certified(const std::string& scene_path, const ExpectedVerdict& asked) {
  const Scene scene = read_scene(scene_path);
  MotionOptions options;
  options.max_bits = asked.asking.bits;
  const testing::RecordedRun run = testing::run(scene, options);
  if (!run.complete()) {
    EXPECT_NE(asked.verdict, name(Verdict::certified)) << "no own history of " << scene_path;
    return;
  }
  const auto history = testing::claimed_history(scene, run);
  CertifyOptions judged;
  judged.truth = voroproof::internal::Truth::exact;
  const double end = round_up(scene.horizon);
  judged.tolerance =
      std::max<Rational>(asked.asking.tolerance, to_rational(std::nextafter(end, HUGE_VAL) - end));
  judged.motion.max_bits = asked.asking.bits;
  const Certificate c = testing::certify(scene, history, judged);
  EXPECT_EQ(c.verdict, voroproof::internal::Verdict::certified)
      << "the engine's own history of " << scene_path << ": "
      << (c.divergence ? c.divergence->truth : c.reason);
}

// cases/NAME.scene.json, NAME.history.jsonl and NAME.verdict.
TEST(Adversary, SavedCases) {
  const std::filesystem::path folder(VOROPROOF_ADVERSARY_CASES);
  int replayed = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".verdict") continue;
    const std::string stem = (folder / entry.path().stem()).string();
    for (const ExpectedVerdict& expected : read_verdicts(entry.path())) {
      const std::string truth = name(expected.truth), verdict = expected.verdict;
      const Judgement j = judge_files(stem + ".scene.json", stem + ".history.jsonl", expected.truth,
                                      expected.asking);
      if (expected.truth == Truth::exact) {
        expect_own_history_certified(stem + ".scene.json", expected);
      }
      EXPECT_EQ(verdict, name(j.certifier.verdict))
          << stem << ", " << truth << ": " << j.certifier.reason;
      // The kernel leaves open what takes irrational numbers.
      if (j.kernel.verdict != Verdict::absent && j.kernel.verdict != Verdict::undecided) {
        EXPECT_EQ(verdict, name(j.kernel.verdict))
            << stem << ", " << truth << ": kernel " << j.kernel.reason;
      }
      ++replayed;
    }
  }
  EXPECT_GT(replayed, 0);
}

// Where the last claim that was looked at is undecided, too, the earliest fault is named.
TEST(Adversary, TheEarliestFaultIsNamed) {
  const std::string stem = VOROPROOF_ADVERSARY_CASES "/a-point-and-before-it-a-disk-leave";
  const Judgement j =
      judge_files(stem + ".scene.json", stem + ".history.jsonl", Truth::recorded, {});
  EXPECT_NE(j.certifier.reason.find("generators [-1,4] touch"), std::string::npos)
      << j.certifier.reason;
}

}  // namespace
}  // namespace voroproof::internal::adversary
