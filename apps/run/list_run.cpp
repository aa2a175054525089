#include "apps/run/list_run.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "apps/cli/limits.h"
#include "apps/run/process.h"
#include "history/descriptor.h"
#include "history/error.h"
#include "history/file_bytes.h"
#include "history/output_file.h"
#include "history/sha256.h"

namespace voroproof::internal {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double for_ever = 1e9;  // seconds: the runs end themselves
constexpr std::chrono::seconds between_tables{3};
constexpr std::size_t longest_reason = 2000;

// A folder for the results of runs, which goes with its owner.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "voroproof.XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw OutputError(name, "cannot make the folder");
    folder_ = name;
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::string file(std::size_t row, const char* ending) const {
    return (folder_ / (std::to_string(row) + ending)).string();
  }

 private:
  std::filesystem::path folder_;
};

// In a process of its own: becomes this program. Returns only where that fails.
int become_program(const std::vector<std::string>& arguments, const std::string& messages) {
  std::vector<char*> words{const_cast<char*>("voroproof")};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  const int told = open(messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (nothing >= 0 && told >= 0) {
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDOUT_FILENO);
    dup2(told, STDERR_FILENO);
    execv("/proc/self/exe", words.data());
  }
  return static_cast<int>(ExitCode::internal);
}

// The hash of the content; empty where it cannot be read, and of a pipe or a device, whose content
// is another one each time, or has no end.
std::string content_hash(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  try {
    return sha256_of_file(path);
  } catch (const InputError&) {
    return {};
  }
}

ExitCode code_of(const ProcessEnd& end) {
  // It was asked to end before it was this program.
  if (end.kind == ProcessEnd::Kind::signalled && end.code == SIGTERM) return ExitCode::interrupted;
  const bool known = end.kind == ProcessEnd::Kind::exited && end.code >= 0 &&
                     end.code <= static_cast<int>(ExitCode::interrupted);
  return known ? static_cast<ExitCode>(end.code) : ExitCode::internal;
}

// The lines that the run wrote to standard error, without the program's name.
std::string message_in(const std::string& path) {
  constexpr std::string_view name = "voroproof: ";
  std::istringstream lines(file_bytes(path, longest_reason, true));
  std::string message;
  for (std::string line; std::getline(lines, line);) {
    message += message.empty() ? "" : "; ";
    message += line.starts_with(name) ? line.substr(name.size()) : line;
  }
  return message;
}

// The options without those that only say when a run gives up.
std::vector<std::string> without_limits(const std::vector<std::string>& options) {
  std::vector<std::string> rest;
  for (std::size_t k = 0; k < options.size(); ++k) {
    if (options[k] == "--time-limit" || options[k] == "--max-memory") {
      ++k;
    } else {
      rest.push_back(options[k]);
    }
  }
  return rest;
}

// Streams get the last ones only.
void write_tables(const ListRequest& request, const RunTable& table, bool last) {
  const auto write = [last](const std::string& path, const std::string& text) {
    if (path.empty() || (!last && (is_stream(path) || is_standard_output(path)))) return;
    OutputFile file(path);
    file.write(text);
    file.commit();
  };
  write(request.json, table_json(table));
  write(request.csv, table_csv(table));
}

class ListOfRuns {
 public:
  ListOfRuns(const ListRequest& request, const ListedVerb& verb)
      : request_(request), verb_(verb), table_{verb.name, producer(), {}} {
    for (ListedRun& run : read_list()) {
      table_.rows.push_back({.run = std::move(run),
                             .code = {},
                             .words = {},
                             .says = {},
                             .reason = {},
                             .scene_sha256 = {},
                             .history_sha256 = {},
                             .options = request.options,
                             .events = {},
                             .t = {}});
    }
    if (verb.writes_history) require_different_histories();
    if (!request.json.empty() && std::filesystem::is_regular_file(request.json)) keep_done();
  }

  RunTable run(const std::function<bool()>& go_on) {
    std::vector<std::shared_ptr<ProcessJob>> jobs;
    for (std::size_t k = 0; k < table_.rows.size(); ++k) {
      if (table_.rows[k].code) continue;
      jobs.push_back(std::make_shared<ProcessJob>());
      jobs.back()->push_back(step(k));
    }
    std::size_t written = 0;
    Clock::time_point last = Clock::now();
    run_jobs(std::move(jobs), request_.jobs, [&](std::size_t finished) {
      if (finished > written && Clock::now() - last >= between_tables) {
        write_tables(request_, table_, false);
        written = finished;
        last = Clock::now();
      }
      return go_on();
    });
    return std::move(table_);
  }

 private:
  // It may come through a pipe.
  std::vector<ListedRun> read_list() const {
    const TimeLimitOfWaiting limit;
    return read_run_list(request_.list);
  }
  void require_different_histories() const {
    std::set<std::string> names;
    for (const RunRow& row : table_.rows) {
      if (names.insert(row.run.history).second) continue;
      throw InputError(request_.list, 0, "",
                       printable(row.run.history) + " is named for two histories to write");
    }
  }

  void keep_done() {
    const RunTable before = read_run_table(request_.json, verb_.name);
    if (before.producer != table_.producer) return;
    std::map<std::pair<std::string, std::string>, const RunRow*> rows;
    for (const RunRow& row : before.rows) rows[{row.run.scene, row.run.history}] = &row;
    for (RunRow& row : table_.rows) {
      const auto found = rows.find({row.run.scene, row.run.history});
      if (found != rows.end() && holds(*found->second)) row = *found->second;
    }
  }

  // Whether a run would give this row again.
  bool holds(const RunRow& row) const {
    if (!row.code || row.scene_sha256.empty() || row.history_sha256.empty()) return false;
    const bool decided = *row.code == ExitCode::ok || *row.code == ExitCode::refuted;
    const bool same =
        decided ? without_limits(row.options) == without_limits(request_.options)
                : row.options == request_.options &&
                      (*row.code == ExitCode::undecided || *row.code == ExitCode::bad_input);
    return same && content_hash(row.run.scene) == row.scene_sha256 &&
           content_hash(row.run.history) == row.history_sha256;
  }

  ProcessStep step(std::size_t k) {
    const std::string result = scratch_.file(k, ".json"), messages = scratch_.file(k, ".err");
    std::vector<std::string> arguments = verb_.arguments(table_.rows[k].run, result);
    arguments.insert(arguments.begin() + 1, request_.options.begin(), request_.options.end());
    return {.work = [=] { return become_program(arguments, messages); },
            .limits = {.seconds = for_ever, .bytes = 0},
            .on_end = [this, k, result, messages](
                          const ProcessEnd& end) { finish(table_.rows[k], end, result, messages); },
            .answers = true};
  }

  void finish(RunRow& row, const ProcessEnd& end, const std::string& result,
              const std::string& messages) const {
    row.code = code_of(end);
    row.scene_sha256 = content_hash(row.run.scene);
    row.history_sha256 = content_hash(row.run.history);
    if (*row.code != ExitCode::ok) {
      row.reason = end.kind == ProcessEnd::Kind::exited ? message_in(messages) : description(end);
    }
    if (std::filesystem::exists(result)) verb_.read(result, row);
    std::error_code ignored;
    std::filesystem::remove(result, ignored);
    std::filesystem::remove(messages, ignored);
  }

  const ListRequest& request_;
  const ListedVerb& verb_;
  Scratch scratch_;
  RunTable table_;
};

}  // namespace

RunTable run_list(const ListRequest& request, const ListedVerb& verb,
                  const std::function<bool()>& go_on) {
  return ListOfRuns(request, verb).run(go_on);
}

void write_run_tables(const ListRequest& request, const RunTable& table) {
  write_tables(request, table, true);
}

}  // namespace voroproof::internal
