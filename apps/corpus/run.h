// The corpus put to the test: its own histories, or those that an external program writes.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/corpus/case.h"
#include "apps/corpus/judge.h"

namespace voroproof::internal {

struct CorpusRunOptions {
  std::string command;  // with {scene} and {history}; see against_program
  std::vector<Truth> truths{Truth::exact, Truth::recorded};
  EventKinds events = EventKinds::all;  // that are judged of a program's histories
  ProcessLimits limits;                 // for each run of the program, and for each certification
  std::size_t jobs = 1;                 // side by side
  // See run_jobs.
  std::function<bool(std::size_t finished)> progress;
};

// The outcome of a case.
enum class CaseOutcome { certified, refuted, undecided, invalid, crashed, timed_out, count };
inline constexpr std::array<std::string_view, static_cast<std::size_t>(CaseOutcome::count)>
    outcome_names{"certified", "refuted", "undecided", "invalid", "crashed", "timed out"};

// The result of an external program on a case.
struct ProgramResult {
  const CorpusCase* of = nullptr;
  CaseOutcome outcome = CaseOutcome::crashed;
  std::string reason;   // one line; empty where certified
  ProcessEnd end;       // how the program ended
  std::string message;  // its last line on stderr
  // Where it wrote a history that was judged.
  std::optional<CaseJudgement> exact, recorded;
  // Likewise, in a case made to be undecided: that of the case's own history.
  std::optional<CaseJudgement> own;

  // The judgement that the outcome rests on: of two, the better; null where there is none.
  const CaseJudgement* decisive() const;
  // Certified; or, in a case made to be undecided, undecided and as right as the case's own history
  // is: up to the same time, within the tolerance.
  bool passed() const;
};

// Runs the command by the shell on every case, with {scene} replaced by the name of a copy of the
// scene and {history} by that of the file to write, both quoted as the shell needs it, in the
// current folder; then certifies what it wrote, a history or an event sequence. The results are in
// the order of the cases. A program that ends by a signal or with an exit code other than 0 has
// crashed, but where it wrote a history that stops early and is right up to there, the case is
// undecided. A history is certified if it is so against one of the truths.
// Throws Interrupted where `progress` says so, and OutputError where there is no scratch folder.
std::vector<ProgramResult> against_program(const std::vector<CorpusCase>& cases,
                                           const CorpusRunOptions& options);

// One thing that the corpus says of itself, and what was found.
struct OwnCheck {
  std::string file;      // below the case's folder
  std::string expected;  // "certified", "refuted (exact): missing event", "same edges", ...
  std::string found;     // likewise
  std::string reason;    // one line, for a person
  double seconds = 0;
  bool passed() const { return expected == found; }
};

struct OwnResult {
  const CorpusCase* of = nullptr;
  std::vector<OwnCheck> checks;
  bool passed() const;
};

// Certifies every case's exact history under the exact truth and its wrong ones, and compares the
// expected diagrams with those that the exact history gives. `command`, `truths` and `events` of
// the options do not count. Throws as against_program.
std::vector<OwnResult> own_histories(const std::vector<CorpusCase>& cases,
                                     const CorpusRunOptions& options);

}  // namespace voroproof::internal
