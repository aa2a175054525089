#include "apps/run/kernel_verdict.h"

#include <cstdio>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>

#include "apps/cli/command_line.h"
#include "apps/run/process.h"
#include "certify/report.h"
#include "history/error.h"
#include "history/file_bytes.h"
#include "kernel/kernel.h"

namespace voroproof::internal {

namespace {

// The most bytes of a file: the kernel has it in memory as a whole.
constexpr std::size_t kMost = std::size_t{1} << 32;

// How the process ends in which the kernel works, if not with a verdict.
constexpr int told_nothing = 1, out_of_memory = 5;
constexpr double for_ever = 1e9;  // seconds

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

using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// Writes the result as the judging process tells it: in three lines.
int tell(const voroproof_kernel::Result& result, std::FILE* out) {
  std::fprintf(out, "%d\n%lld\n%s\n", static_cast<int>(result.verdict),
               static_cast<long long>(result.line), result.reason.c_str());
  return std::fflush(out) == 0 ? 0 : told_nothing;
}

voroproof_kernel::Result told(std::FILE* in) {
  voroproof_kernel::Result result;
  int verdict = 0;
  long long line = 0;
  std::rewind(in);
  if (std::fscanf(in, "%d\n%lld", &verdict, &line) != 2 || std::fgetc(in) != '\n') {
    throw std::logic_error("the kernel's process tells nothing");
  }
  result.verdict = static_cast<voroproof_kernel::Verdict>(verdict);
  result.line = static_cast<decltype(result.line)>(line);
  for (int c = std::fgetc(in); c != EOF; c = std::fgetc(in)) {
    result.reason += static_cast<char>(c);
  }
  if (result.reason.ends_with('\n')) result.reason.pop_back();
  return result;
}

// The kernel asks nobody whether to go on: it works in a process that can be killed. Returns
// nothing where the process was killed.
std::optional<voroproof_kernel::Result> checked_apart(const std::string& scene,
                                                      const std::string& history,
                                                      const voroproof_kernel::Options& options,
                                                      const std::function<bool()>& go_on) {
  const Stream stream(std::tmpfile(), &std::fclose);
  if (!stream) throw OutputError("the kernel's verdict", "no temporary file");
  ProcessEnd ended;
  const auto work = [&] {
    try {
      return tell(voroproof_kernel::check(scene, history, options), stream.get());
    } catch (const std::bad_alloc&) {
      return out_of_memory;
    }
  };
  auto job = std::make_shared<ProcessJob>();
  job->push_back({.work = work,
                  .limits = {.seconds = for_ever, .bytes = 0},
                  .on_end = [&](const ProcessEnd& end) { ended = end; }});
  if (!run_jobs({std::move(job)}, 1, [&](std::size_t finished) { return finished > 0 || go_on(); }))
    return std::nullopt;
  if (ended.kind == ProcessEnd::Kind::exited && ended.code == out_of_memory) throw std::bad_alloc();
  if (!ended.success()) {
    throw std::logic_error("the kernel's process ends with " + description(ended));
  }
  return told(stream.get());
}

}  // namespace

std::string judged_by_kernel(Certificate& certificate, const std::string& scene_path,
                             const std::string& history_path, const CertifyOptions& options,
                             const std::function<bool()>& go_on) {
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
  const std::optional<voroproof_kernel::Result> given = checked_apart(scene, history, asked, go_on);
  if (!given) return {};
  const voroproof_kernel::Result& result = *given;
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

}  // namespace voroproof::internal
