// What the certifier, the kernel and the oracle say of one history.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "history/scene.h"
#include "tests/adversary/claims.h"
#include "tests/adversary/truth.h"
#include "tests/certify/claimed_history.h"

namespace voroproof::internal::adversary {

enum class Truth { exact, recorded };
inline constexpr std::array truths{Truth::exact, Truth::recorded};
inline constexpr std::array truth_names{"exact", "recorded"};

enum class Verdict { certified, refuted, undecided, invalid, failed, absent };
inline constexpr std::array verdict_names{"certified", "refuted", "undecided",
                                          "invalid",   "failed",  "absent"};
inline const char* name(Verdict v) { return verdict_names[static_cast<std::size_t>(v)]; }
inline const char* name(Truth t) { return truth_names[static_cast<std::size_t>(t)]; }

struct Answer {
  Verdict verdict = Verdict::absent;
  std::string reason;
  std::optional<double> when{};  // of what is missing, by the one that refutes
};

struct Judgement {
  Answer certifier, kernel;        // the kernel's is absent where there is none
  std::optional<Opinion> opinion;  // where it was asked for
};

// Why a judgement is a find; the first that holds.
enum class Find {
  none,
  failure,        // an exception, or a file that only one of the two can read
  certifier_lax,  // certified, and the oracle refutes it
  kernel_lax,
  certifier_strict,  // refuted, and the oracle finds nothing
  kernel_strict,
  disagreement,  // one certifies what the other refutes
  count
};
inline constexpr std::array find_names{"none",
                                       "failure",
                                       "certifier: certified though wrong",
                                       "kernel: certified though wrong",
                                       "certifier: refuted though right",
                                       "kernel: refuted though right",
                                       "certifier and kernel disagree"};
inline const char* name(Find f) { return find_names[static_cast<std::size_t>(f)]; }

Find find_of(const Judgement& j);

// A scene as the certifier takes it; nothing where its reader refuses it.
struct ReadScene {
  std::string text;
  Scene scene;
};
std::optional<ReadScene> read(const SceneData& scene);

// The history as the certifier takes it.
testing::ClaimedHistory claimed(const ReadScene& scene, const History& history);

// The tolerance of times in these units.
Rational tolerance_in(const Units& units);

// Of the certifier. Ties that cost seconds are left undecided.
inline constexpr int most_bits = 4096;

struct Asking {
  bool long_decimals = false, with_kernel = true;
  Rational tolerance = tolerance_in({});
  int bits = most_bits;
};

// Asks the certifier and, where wanted, the kernel.
Judgement judge(const ReadScene& scene, const History& history, Truth truth, const Asking& asking);

// Asks the certifier and the kernel about files.
Judgement judge_files(const std::string& scene_path, const std::string& history_path, Truth truth,
                      const Asking& asking);

// Asks the oracle, too.
void ask_oracle(Judgement& j, const SceneData& scene, const History& history, Truth truth,
                const std::vector<double>& hints);

}  // namespace voroproof::internal::adversary
