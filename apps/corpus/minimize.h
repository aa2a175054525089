// The smallest scene on which a program still makes a mistake.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "apps/corpus/run.h"
#include "history/scene.h"

namespace voroproof::internal {

// The mistake: how the run ended, and the kind of the first divergence where it was refuted.
struct Mistake {
  CaseOutcome outcome = CaseOutcome::certified;
  std::string kind;
  double t = 0;  // when the histories part
  std::string reason;

  bool is_one() const { return outcome != CaseOutcome::certified; }
  bool is_like(const Mistake& o) const { return outcome == o.outcome && kind == o.kind; }
};

// Makes a scene smaller for as long as the program makes the same mistake on it: an earlier
// horizon, fewer maneuvers and disks (by halves, then smaller parts: A. Zeller, R. Hildebrandt,
// "Simplifying and isolating failure-inducing input", IEEE Trans. Software Eng. 28, 2002), numbers
// of fewer bits. What it comes to cannot lose a disk, a maneuver or such a number more.
class Minimization {
 public:
  // `options` as for against_program. Judges the scene as it is. Throws as against_program.
  Minimization(Scene scene, const CorpusRunOptions& options);

  const Mistake& mistake() const { return mistake_; }
  // The smallest scene so far.
  const Scene& scene() const { return scene_; }
  std::size_t runs() const { return runs_; }

  // Precondition: there is a mistake. Throws as against_program; scene() is as small as it came to.
  void run();

 private:
  using Change = std::function<void(Scene&)>;
  using Erase = void (*)(Scene& scene, std::size_t first, std::size_t count);
  std::vector<Mistake> judge(const std::vector<Scene>& scenes);
  bool take(const std::vector<Change>& changes);
  bool shorten();
  bool drop(const std::function<std::size_t(const Scene&)>& size, Erase erase);
  bool simplify_numbers();

  Scene scene_;
  CorpusRunOptions options_;
  Mistake mistake_;
  std::size_t runs_ = 0;
};

}  // namespace voroproof::internal
