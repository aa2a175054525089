// The certifier's judgement of a history of a corpus case, in a process of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "apps/run/process.h"
#include "certify/certifier.h"

namespace voroproof::internal {

struct CaseJudgement {
  enum class Verdict { certified, refuted, undecided, invalid };
  Verdict verdict = Verdict::undecided;
  std::string reason;  // one line; empty where certified
  // The first divergence, where the history is refuted: its kind, its line and its time.
  std::string kind;
  std::int64_t line = 0;
  double t = 0;
  // The first so many events are right, and nothing is missing before prefix_t.
  std::int64_t prefix_events = 0;
  double prefix_t = 0;
  double seconds = 0;
};

// "certified" and so on.
std::string_view name_of(CaseJudgement::Verdict verdict);

// The step that certifies the history against the truth, with the certifier's usual tolerances, and
// then hands on the judgement. Its process writes a report or a message to `report`, a file that
// it may overwrite. Where it exceeds the limits or fails, the judgement is undecided and says why.
ProcessStep judging(const std::string& scene, const std::string& history, Truth truth,
                    EventKinds events, const std::string& report, const ProcessLimits& limits,
                    std::function<void(const CaseJudgement&)> on_judgement);

}  // namespace voroproof::internal
