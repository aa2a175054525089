// What the program says of a scene and of a history, within bounds.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "certify/certifier.h"
#include "tests/certify/claimed_history.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::metamorphic {

inline constexpr std::array both_truths{Truth::exact, Truth::recorded};
const char* name_of(Truth truth);

struct Run : testing::RecordedRun {
  bool endless() const { return outcome.kind == Outcome::Kind::interrupted; }
};
// The engine's run, interrupted where it takes too long.
Run simulated(const Scene& scene, EngineOptions options = {});

struct Answer {
  // A verdict, or "invalid", "failed", "endless".
  std::string verdict;
  std::string reason{};
  // Of a refutation.
  std::int64_t line = 0;
  std::optional<Fault> fault{};
  std::optional<Quad> flip{};
  std::optional<std::pair<GenId, GenId>> contact{};
  // Whether a pair meets, or does not meet, but for roundings.
  bool contacts_by_rounding = false;
  // Whether velocities were computed, and rounded to binary64.
  bool velocities_by_law = false;
  // Whether claims were taken out of order, within the tolerance.
  bool swapped = false;
  // Whether it is left open since a generator may lie inside another.
  bool hidden = false;
};
std::string text(const Answer& answer);

// What is judged, and how.
struct Case {
  Scene scene;
  std::optional<testing::ClaimedHistory> claim{};  // none: what simulate says of the scene
  Rational tolerance{1, 1000000};
  std::string answer{};
};

// With CGAL's word on a witness: where that contradicts, the verdict is "failed".
Answer certified(const Case& of, Truth truth, CertifyOptions options = {});
// The kernel's verdict alone; "absent" where the build has none.
std::string kernel_verdict(const Case& of, Truth truth);

// What one comparison may cost.
struct Budget {
  int bits = 4096;
  std::size_t radicals = 2;  // of the numbers in which ties are decided
  double seconds = 0.25;     // of the processor
};
Budget& budget();
// The time of a comparison begins. What takes longer is "endless", and that comparison says
// nothing.
void begin_comparison();
bool took_too_long();

// While it lives, the budget is so great that what is left open is not a question of cost.
class Generosity {
 public:
  Generosity() { budget() = {32768, 4, 16}; }
  Generosity(const Generosity&) = delete;
  Generosity& operator=(const Generosity&) = delete;
  ~Generosity() { budget() = {}; }
};

}  // namespace voroproof::internal::metamorphic
