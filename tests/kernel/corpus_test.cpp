// The kernel's verdict on every history of the corpus whose verdict is known.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "certify/kernel/kernel.h"

namespace voroproof_kernel {
namespace {

namespace fs = std::filesystem;

std::string file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in) << path;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

Result judged(const fs::path& scene, const fs::path& history, Truth truth, int jobs = 1) {
  Options options;
  options.truth = truth;
  options.jobs = jobs;
  return check(file(scene), file(history), options);
}

std::vector<fs::path> cases() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(VOROPROOF_CORPUS) / "cases")) {
    if (entry.path().filename() == "case.json") found.push_back(entry.path().parent_path());
  }
  EXPECT_GT(found.size(), 300U);
  return found;
}

std::string name(const fs::path& folder) {
  return folder.parent_path().filename().string() + "/" + folder.filename().string();
}

// Under the recorded truth all right histories but these are certified.
TEST(KernelCorpus, RecordedRight) {
  const std::set<std::string> stopped = {"collapse/four-in-line",
                                         "collapse/point-touches-at-start",
                                         "collapse/points-meet",
                                         "collapse/settling-on-the-wall",
                                         "collapse/slides-by-maneuver",
                                         "collapse/three-in-line",
                                         "collapse/slides-after-a-collision"};
  // Velocities are rounded: the recorded motion has flips that the true one has not.
  const std::set<std::string> refuted = {"lattices/turning-by-maneuvers-3x3"};
  for (const fs::path& folder : cases()) {
    const Result r =
        judged(folder / "scene.scene.json", folder / "exact.history.jsonl", Truth::recorded);
    if (stopped.count(name(folder)) == 1) {
      EXPECT_EQ(r.verdict, Verdict::undecided) << folder;
      EXPECT_EQ(r.reason, "the history stops before its horizon") << folder;
    } else {
      EXPECT_EQ(r.verdict, refuted.count(name(folder)) ? Verdict::refuted : Verdict::certified)
          << folder << ": " << r.reason;
    }
  }
}

// Under the exact truth only histories of rational times are decided; none is refuted.
TEST(KernelCorpus, ExactRight) {
  int certified = 0;
  for (const fs::path& folder : cases()) {
    const Result r =
        judged(folder / "scene.scene.json", folder / "exact.history.jsonl", Truth::exact);
    certified += r.verdict == Verdict::certified;
    if (r.verdict == Verdict::certified) continue;
    EXPECT_EQ(r.verdict, Verdict::undecided) << folder << ": " << r.reason;
    EXPECT_TRUE(r.reason.find("is irrational") != std::string::npos ||
                r.reason.find("the history ") == 0)
        << folder << ": " << r.reason;
  }
  EXPECT_EQ(certified, 240);
}

// The wrong ones are wrong under the exact truth; none of them is certified.
TEST(KernelCorpus, ExactWrong) {
  int refuted = 0, undecided = 0;
  for (const fs::path& folder : cases()) {
    if (!fs::exists(folder / "wrong")) continue;
    for (const auto& wrong : fs::directory_iterator(folder / "wrong")) {
      const Result r = judged(folder / "scene.scene.json", wrong.path(), Truth::exact);
      refuted += r.verdict == Verdict::refuted;
      undecided += r.verdict == Verdict::undecided;
      EXPECT_TRUE(r.verdict == Verdict::refuted || r.verdict == Verdict::undecided) << wrong.path();
    }
  }
  EXPECT_EQ(refuted, 292);
  EXPECT_EQ(undecided, 52);
}

// Wrong histories are right under the recorded truth where rounding, or the file's own order at one
// recorded time, leaves no other motion.
TEST(KernelCorpus, RecordedWrong) {
  const std::set<std::string> right = {"collision-order", "graze-taken-for-hit", "maneuver-first"};
  const std::set<std::string> near = {"multiple-roots/simple-at-the-horizon",
                                      "near-misses/inside-1e-15", "zero/horizon-zero"};
  int refuted = 0, certified = 0;
  for (const fs::path& folder : cases()) {
    if (!fs::exists(folder / "wrong")) continue;
    for (const auto& wrong : fs::directory_iterator(folder / "wrong")) {
      const Result r = judged(folder / "scene.scene.json", wrong.path(), Truth::recorded);
      const std::string kind = wrong.path().stem().stem().string();
      refuted += r.verdict == Verdict::refuted;
      certified += r.verdict == Verdict::certified;
      if (r.verdict == Verdict::certified) {
        EXPECT_TRUE(right.count(kind) || near.count(name(folder))) << wrong.path();
      }
    }
  }
  EXPECT_EQ(refuted, 324);
  EXPECT_EQ(certified, 20);
}

// What corpus/cases.txt says of the recorded truth.
TEST(KernelCorpus, ListedCases) {
  const fs::path corpus(VOROPROOF_CORPUS);
  const std::map<std::string, Verdict> words = {{"certified", Verdict::certified},
                                                {"refuted", Verdict::refuted},
                                                {"invalid", Verdict::invalid},
                                                {"undecided", Verdict::undecided}};
  // The kernel constructs no diagram, and quadruplets without orientation need their option.
  const std::map<std::string, Verdict> otherwise = {
      {"certified/disks-without-initial.history.jsonl", Verdict::undecided},
      {"certified/disks-quadruplets-not-oriented.history.jsonl", Verdict::refuted}};
  std::istringstream lines(file(corpus / "cases.txt"));
  int count = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words_of(line);
    std::string history, scene, truth;
    words_of >> history >> scene >> truth;
    if (line[0] == '#' || history.find(".evtsq") != std::string::npos) continue;
    if (truth == "exact" && history.find("invalid/") != 0) continue;
    const fs::path scene_file = corpus / "scenes" / (scene + ".scene.json");
    const auto other = otherwise.find(history);
    const Verdict due =
        other != otherwise.end() ? other->second : words.at(history.substr(0, history.find('/')));
    const Result r = judged(scene_file, corpus / history, Truth::recorded);
    EXPECT_EQ(r.verdict, due) << history << ": " << r.reason;
    ++count;
  }
  EXPECT_GT(count, 40);
  Options options;
  options.unoriented = true;
  EXPECT_EQ(check(file(corpus / "scenes/disks.scene.json"),
                  file(corpus / "certified/disks-quadruplets-not-oriented.history.jsonl"), options)
                .verdict,
            Verdict::certified);
}

TEST(KernelCorpus, ProcessesFindTheSame) {
  const fs::path corpus(VOROPROOF_CORPUS);
  for (const char* history : {"certified/grid", "refuted/velocity-turned"}) {
    const char* scene = history[0] == 'c' ? "grid" : "disks";
    const fs::path scene_file = corpus / "scenes" / (std::string(scene) + ".scene.json");
    const fs::path history_file = corpus / (std::string(history) + ".history.jsonl");
    const Result one = judged(scene_file, history_file, Truth::recorded);
    const Result three = judged(scene_file, history_file, Truth::recorded, 3);
    EXPECT_EQ(one.verdict, three.verdict);
    EXPECT_EQ(one.reason, three.reason);
    EXPECT_EQ(one.line, three.line);
    EXPECT_EQ(one.counts.lives, three.counts.lives);
    EXPECT_EQ(one.counts.pair_lives, three.counts.pair_lives);
  }
}

}  // namespace
}  // namespace voroproof_kernel
