#include "apps/kernel_verdict.h"

#include <stdexcept>

#include "apps/command_line.h"
#include "certify/report.h"
#include "history/file_bytes.h"
#include "kernel/kernel.h"

namespace voroproof {

namespace {

// Of a file: the kernel has it in memory as a whole.
constexpr std::size_t kMost = std::size_t{1} << 32;

std::string word(voroproof_kernel::Verdict verdict) {
  switch (verdict) {
    case voroproof_kernel::Verdict::certified:
      return "CERTIFIED";
    case voroproof_kernel::Verdict::refuted:
      return "REFUTED";
    case voroproof_kernel::Verdict::undecided:
      return "UNDECIDED";
    case voroproof_kernel::Verdict::invalid:
      break;
  }
  return "INVALID";
}

}  // namespace

std::string judged_by_kernel(Certificate& certificate, const std::string& scene_path,
                             const std::string& history_path, const CertifyOptions& options) {
  const std::string scene = file_bytes(scene_path, kMost),
                    history = file_bytes(history_path, kMost);
  if (!history.starts_with('{') || !scene.starts_with('{')) {
    throw UsageError(
        "--kernel: the kernel reads scene and history files, not those of other engines");
  }
  voroproof_kernel::Options asked;
  asked.truth = options.truth == Truth::exact ? voroproof_kernel::Truth::exact
                                              : voroproof_kernel::Truth::recorded;
  asked.tolerance = options.tolerance.get_str();
  asked.law_tolerance = options.law_tolerance.get_str();
  asked.strict = options.strict;
  asked.unoriented = options.unoriented;
  asked.jobs = options.threads;
  using Verdict2 = voroproof_kernel::Verdict;
  const voroproof_kernel::Result result = voroproof_kernel::check(scene, history, asked);
  std::string line = word(result.verdict);
  if (!result.reason.empty()) {
    line += ": ";
    if (result.line > 0) line += "line " + std::to_string(result.line) + ": ";
    line += result.reason;
  }
  const bool first = certificate.verdict == Verdict::certified;
  if (first ? result.verdict == Verdict2::refuted || result.verdict == Verdict2::invalid
            : certificate.verdict == Verdict::refuted && result.verdict == Verdict2::certified) {
    throw std::logic_error("the two checkers disagree; please report it with the files " +
                           scene_path + " and " + history_path + ": the certifier says " +
                           std::string(verdict_line(certificate.verdict).substr(2)) +
                           (first ? "" : " (" + reason_line(certificate) + ")") + ", the kernel " +
                           line);
  }
  if (first && result.verdict == Verdict2::undecided) {
    certificate.verdict = Verdict::undecided;
    certificate.reason = "the kernel does not decide it: " + result.reason;
    certificate.reason_line = result.line;
  }
  return line;
}

}  // namespace voroproof
