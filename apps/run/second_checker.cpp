#include "apps/run/second_checker.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <vector>

#include "apps/cli/command_line.h"
#include "apps/run/process.h"
#include "certify/report.h"
#include "history/error.h"
#include "history/file_bytes.h"
#include "history/sha256.h"

namespace voroproof::internal {

namespace {

// The most bytes of a file: second checkers have it in memory as a whole.
constexpr std::size_t kMost = std::size_t{1} << 32;

// How the process ends in which a checker works where memory is not to be had.
constexpr int out_of_memory = 5;
constexpr double for_ever = 1e9;  // seconds

struct Opinion {
  std::string verdict;    // CERTIFIED, REFUTED, UNDECIDED or INVALID
  std::int64_t line = 0;  // line of the history, where the reason names one
  std::string reason;

  bool certifies() const { return verdict == "CERTIFIED"; }
  bool denies() const { return verdict == "REFUTED" || verdict == "INVALID"; }
  std::string text() const {
    std::string text = verdict;
    if (!reason.empty()) {
      text += ": ";
      if (line > 0) text += "line " + std::to_string(line) + ": ";
      text += reason;
    }
    return text;
  }
};

using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::vector<std::string> lines_in(std::FILE* in) {
  std::vector<std::string> lines;
  std::rewind(in);
  bool fresh = true;
  for (int c = std::fgetc(in); c != EOF; c = std::fgetc(in)) {
    if (fresh) lines.emplace_back();
    fresh = c == '\n';
    if (!fresh) lines.back() += static_cast<char>(c);
  }
  return lines;
}

// Reads the opinion from a checker's lines; nothing where the last one is no verdict.
std::optional<Opinion> opinion(const std::vector<std::string>& lines) {
  Opinion said;
  for (const char* verdict : {"CERTIFIED", "REFUTED", "UNDECIDED", "INVALID"}) {
    if (!lines.empty() && lines.back() == std::string("s ") + verdict) said.verdict = verdict;
  }
  if (said.verdict.empty()) return std::nullopt;
  if (said.certifies() || lines.size() < 2 || !lines[lines.size() - 2].starts_with("c ")) {
    return said;
  }
  said.reason = lines[lines.size() - 2].substr(2);
  constexpr std::string_view word = "line ";
  if (said.reason.starts_with(word)) {
    const char* end = said.reason.data() + said.reason.size();
    const auto read = std::from_chars(said.reason.data() + word.size(), end, said.line);
    if (said.line > 0 && end - read.ptr > 2 && read.ptr[0] == ':') {
      said.reason.erase(0, static_cast<std::size_t>(read.ptr + 2 - said.reason.data()));
    }
  }
  return said;
}

// The file's bytes, which are those of the hash.
std::string judged_bytes(const std::string& path, const std::string& sha256) {
  std::string bytes = file_bytes(path, kMost);
  if (sha256_hex(bytes) != sha256) {
    throw InputError(path, 0, "", "has other bytes now than those that the certifier judged");
  }
  return bytes;
}

// A checker asks nobody whether to go on: it works in a process that can be killed. Returns nothing
// where the process was killed.
std::optional<Opinion> asked_apart(const SecondChecker& second, const std::string& scene,
                                   const std::string& history, const CertifyOptions& options,
                                   const std::function<bool()>& go_on) {
  const std::string name = "the " + std::string(second.name);
  const Stream stream(std::tmpfile(), &std::fclose);
  if (!stream) throw OutputError(name + "'s verdict", "no temporary file");
  ProcessEnd ended;
  const auto work = [&] {
    dup2(fileno(stream.get()), STDOUT_FILENO);
    dup2(fileno(stream.get()), STDERR_FILENO);
    try {
      const int code = second.work(scene, history, options);
      return std::fflush(stdout) == 0 ? code : static_cast<int>(ExitCode::bad_input);
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
  const std::vector<std::string> lines = lines_in(stream.get());
  std::optional<Opinion> said = opinion(lines);
  // A library that gets no memory may end the process by itself.
  if ((ended.kind == ProcessEnd::Kind::exited && ended.code == out_of_memory) ||
      (!said && !lines.empty() && lines.back().find("memory") != std::string::npos)) {
    throw std::bad_alloc();
  }
  const bool has_no_room = ended.kind == ProcessEnd::Kind::signalled
                               ? ended.code == SIGXFSZ
                               : !said && ended.code == static_cast<int>(ExitCode::bad_input);
  if (has_no_room) throw OutputError(name + "'s verdict", "no room for a temporary file");
  if (!said || ended.kind != ProcessEnd::Kind::exited) {
    throw std::logic_error(name + "'s process ends with " + description(ended) + " and " +
                           (lines.empty() ? "says nothing" : "says: " + lines.back()));
  }
  return said;
}

}  // namespace

std::vector<SecondChecker> second_checkers(bool kernel, bool proved, const CertifyOptions& options,
                                           bool whole) {
  std::vector<SecondChecker> all;
  if (kernel) all.push_back(kernel_checker());
  if (proved) all.push_back(proved_checker());
  for (const SecondChecker& checker : all) {
    const std::string option = std::string(checker.option) + ": ";
    if (!whole) {
      throw UsageError(option + "the " + std::string(checker.name) +
                       " judges the whole history (without --part)");
    }
    if (const std::string why = checker.refusal(options); !why.empty()) {
      throw UsageError(option + why);
    }
  }
  return all;
}

std::string judged_by(const SecondChecker& second, Certificate& certificate,
                      const CertificationRun& run, const CertifyOptions& options,
                      const std::function<bool()>& go_on) {
  const std::string name = "the " + std::string(second.name);
  const std::string scene = judged_bytes(run.scene_file, run.scene_sha256),
                    history = judged_bytes(run.history_file, run.history_sha256);
  if (!history.starts_with('{') || !scene.starts_with('{')) {
    throw UsageError(std::string(second.option) + ": " + name +
                     " reads scene and history files, not those of other engines");
  }
  const std::optional<Opinion> said = asked_apart(second, scene, history, options, go_on);
  if (!said) return {};
  const bool first = certificate.verdict == Verdict::certified;
  if (first ? said->denies() : certificate.verdict == Verdict::refuted && said->certifies()) {
    throw std::logic_error("the two checkers disagree; please report it with the files " +
                           run.scene_file + " and " + run.history_file + ": the certifier says " +
                           std::string(verdict_line(certificate.verdict).substr(2)) +
                           (first ? "" : " (" + reason_line(certificate) + ")") + ", " + name +
                           " " + said->text());
  }
  if (first && !said->certifies()) {
    certificate.verdict = Verdict::undecided;
    certificate.reason = name + " does not decide it: " + said->reason;
    certificate.reason_line = said->line;
  }
  return said->text();
}

}  // namespace voroproof::internal
