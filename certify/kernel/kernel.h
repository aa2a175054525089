// A second, independent checker of event histories: the rules of docs/kernel.md and nothing else.
// Whole numbers and fractions only; it shares no code with the rest of the project.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace voroproof_kernel {

enum class Truth { exact, recorded };
enum class Verdict { certified, refuted, undecided, invalid };

struct Options {
  Truth truth = Truth::recorded;
  std::string tolerance = "1e-6";      // for claimed times
  std::string law_tolerance = "1e-9";  // for claimed velocities, relative to the speeds that meet
  bool strict = false;                 // refute claims out of order and foreign horizons
  bool unoriented = false;             // a quadruplet [l,r,s,e] may stand for [l,r,e,s]
  int jobs = 1;                        // processes
  // Told, if it is there, which claim of how many a rule has come to.
  std::function<void(const char* rule, std::size_t claim, std::size_t of)> progress{};
};

// Counts of what was claimed and proved, and of the leniencies used.
struct Counts {
  std::int64_t flips = 0, collisions = 0, maneuvers = 0;
  std::int64_t lives = 0, pair_lives = 0, fresh_proofs = 0;
  std::int64_t swaps = 0, grazes = 0, rounding_overlaps = 0, horizon_events = 0, unoriented = 0;
};

// Where a fault can be seen. It is for pictures: no rule uses it.
struct Sight {
  double t = 0;
  int named = 0;  // generators; four are those of an edge
  int generators[4] = {};
};

struct Result {
  Verdict verdict = Verdict::undecided;
  std::string reason;     // empty if certified
  std::int64_t line = 0;  // line of the history, from 1; 0 where it is about no line
  bool is_first = true;   // no earlier claim is false: not known of most refutations
  Counts counts;
  std::string horizon_note;  // where the history's horizon is not its scene's
  Sight sight;               // if it is not that of the claim
};

// The verdict on the history of a scene, both given as the text of their files. Never throws for
// what the texts say; std::bad_alloc may pass.
Result check(const std::string& scene_text, const std::string& history_text, const Options&);
// The result as voroproof-kernel prints it.
std::string lines_of(const Result&);

}  // namespace voroproof_kernel
