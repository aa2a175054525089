// The recorded truth is proved in parts of any size with the verdict that one piece has, also where
// quadruplets are not oriented and name two edges of the diagram.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>

#include "certify/report.h"
#include "exact/topology/diagram.h"
#include "tests/certify/claimed_history.h"
#include "tests/certify/mutation.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

namespace fs = std::filesystem;

// Histories of more disks or events are like smaller ones; and those of some families have few
// events, and expensive ones.
constexpr std::size_t kDisks = 12, kEvents = 60;
constexpr std::array<std::string_view, 4> kDear{"cancelled", "close-roots", "multiple-roots",
                                                "symmetry"};

Quad without_orientation(const Quad& q) {
  return {std::min(q.l, q.r), std::max(q.l, q.r), std::min(q.s, q.e), std::max(q.s, q.e)};
}

void strip_orientation(ClaimedHistory& h) {
  h.header.oriented = false;
  for (auto& event : h.events) {
    if (auto* flip = std::get_if<FlipEvent>(&event)) flip->quad = without_orientation(flip->quad);
  }
}

Diagram::HalfEdge find(const Diagram& d, const Quad& q) {
  for (Diagram::HalfEdge h = 0; h < 2 * d.edges(); ++h) {
    if (d.quad(h) == q) return h;
  }
  return -1;
}

// How many flips of a right history are of an edge whose name without orientation is that of
// another edge of the diagram.
int misnamed(const Scene& scene, const ClaimedHistory& right) {
  if (scene.disks.size() < 2) return 0;
  int count = 0;
  Diagram d = diagram_of(static_cast<int>(scene.disks.size()), *right.header.initial);
  for (const auto& event : right.events) {
    const auto* flip = std::get_if<FlipEvent>(&event);
    if (flip == nullptr) continue;
    const Quad name = without_orientation(flip->quad);
    count += name != canonical(flip->quad) && find(d, name) >= 0;
    d.flip(find(d, flip->quad));
  }
  return count;
}

std::string told(const Certificate& c) {
  return std::string(verdict_line(c.verdict)) + (c.divergence ? " " + reason_line(c) : "");
}

// In one piece, and in parts as small as can be.
Verdict expect_the_same_in_parts(const Scene& scene, const ClaimedHistory& h,
                                 const std::string& what) {
  CertifyOptions options;
  options.truth = Truth::recorded;
  options.least_part = std::size_t{1} << 40;
  const Certificate whole = certify(scene, h, options);
  for (const std::size_t least : {1, 7}) {
    options.least_part = least;
    const Certificate parts = certify(scene, h, options);
    EXPECT_EQ(verdict_line(parts.verdict), verdict_line(whole.verdict))
        << what << ", parts of " << least << "\n"
        << told(parts) << "\n"
        << reason_line(parts) << "\n"
        << told(whole);
    if (parts.verdict == Verdict::certified) {
      EXPECT_EQ(parts.resolved, whole.resolved) << what << ", parts of " << least;
    }
  }
  return whole.verdict;
}

TEST(Parts, CorpusWithAndWithoutOrientation) {
  int histories = 0, ambiguous = 0;
  std::array<int, 3> verdicts{};
  for (const auto& entry : fs::recursive_directory_iterator(VOROPROOF_CASES)) {
    const std::string path = entry.path().string();
    if (!path.ends_with(".history.jsonl")) continue;
    fs::path folder = entry.path().parent_path();
    if (folder.filename() == "wrong") folder = folder.parent_path();
    const std::string family = folder.parent_path().filename().string();
    if (std::find(kDear.begin(), kDear.end(), family) != kDear.end()) continue;
    const Scene scene = read_scene((folder / "scene.scene.json").string());
    if (scene.disks.size() > kDisks) continue;
    auto h = read_claimed_history(path, scene);
    if (!h || !h->header.initial || h->events.size() > kEvents) continue;
    ++histories;
    expect_the_same_in_parts(scene, *h, path);
    if (entry.path().filename() == "exact.history.jsonl") ambiguous += misnamed(scene, *h);
    strip_orientation(*h);
    ++verdicts[static_cast<int>(
        expect_the_same_in_parts(scene, *h, path + " without orientation"))];
  }
  std::cout << histories << " histories, " << ambiguous << " ambiguous quadruplets, " << verdicts[0]
            << " certified, " << verdicts[1] << " refuted, " << verdicts[2] << " undecided\n";
  EXPECT_GT(histories, 200);
  EXPECT_GT(ambiguous, 0);
  EXPECT_GT(verdicts[static_cast<int>(Verdict::certified)], 100);
}

TEST(Parts, RandomHistoriesAndMutantsWithoutOrientation) {
  Random random(21);
  int ambiguous = 0, certified = 0, certified_ambiguous = 0;
  for (int k = 0; k < 150; ++k) {
    const Scene scene = random_scene({.n = 5 + static_cast<int>(random() % 6),
                                      .rmin = 0.1,
                                      .rmax = 40,
                                      .horizon = 20,
                                      .density = 0.3},
                                     random);
    const RecordedRun r = run(scene);
    if (!r.complete()) continue;
    const ClaimedHistory right = claimed_history(scene, r);
    const int here = misnamed(scene, right);
    ClaimedHistory h = right;
    strip_orientation(h);
    const Verdict verdict = expect_the_same_in_parts(scene, h, "scene " + std::to_string(k));
    ambiguous += here;
    certified += verdict == Verdict::certified;
    certified_ambiguous += here > 0 && verdict == Verdict::certified;
    const auto kind = static_cast<Mutation>(random() % static_cast<int>(Mutation::count));
    if (auto wrong = mutate(scene, right, kind, 1e-6, 1e-9, random)) {
      if (random() % 2 == 0) strip_orientation(*wrong);
      expect_the_same_in_parts(
          scene, *wrong,
          "scene " + std::to_string(k) + " " + std::string(mutation_names[static_cast<int>(kind)]));
    }
  }
  std::cout << ambiguous << " ambiguous quadruplets, " << certified << " certified, "
            << certified_ambiguous << " of these with ambiguous ones\n";
  EXPECT_GT(ambiguous, 0);
  EXPECT_GT(certified_ambiguous, 0);
}

}  // namespace
}  // namespace voroproof::internal::testing
