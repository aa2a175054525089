#include "apps/cli/limits.h"

#include <sys/resource.h>

#include <algorithm>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "history/error.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

constexpr double longest_time = 1e9;  // seconds
constexpr std::uint64_t bytes_per_megabyte = std::uint64_t{1} << 20;

// The limits of this process, which are set once, from its command line.
double seconds = 0;
std::uint64_t megabytes = 0;
rlim_t memory_before = RLIM_INFINITY;

std::vector<CLI::App*> verbs_below(CLI::App& app) {
  std::vector<CLI::App*> verbs;
  for (CLI::App* verb : app.get_subcommands({})) {
    const std::vector<CLI::App*> below = verbs_below(*verb);
    if (below.empty()) verbs.push_back(verb);
    verbs.insert(verbs.end(), below.begin(), below.end());
  }
  return verbs;
}

}  // namespace

void add_process_limits(CLI::App& app) {
  for (CLI::App* verb : verbs_below(app)) {
    const auto read = [](const std::string& text) {
      const Rational limit = time_argument("--time-limit", text);
      seconds = round_nearest(limit);
      if (limit == 0 || seconds > longest_time) {
        throw UsageError("--time-limit: " + printable(text) + ": not in (0, 1e9]");
      }
    };
    verb->add_option_function<std::string>("--time-limit", read,
                                           "seconds after which the run ends, undecided")
        ->type_name("SECONDS");
    verb->add_option("--max-memory", megabytes,
                     "megabytes (private and writable) beyond which it ends, undecided")
        ->type_name("MB")
        ->check(whole_number())
        ->check(CLI::Range(1, 1 << 30));
  }
}

void start_process_limits() {
  if (seconds > 0) start_time_limit(seconds);
  if (megabytes == 0) return;
  rlimit limit{};
  if (getrlimit(RLIMIT_DATA, &limit) != 0) return;
  memory_before = limit.rlim_cur;
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_cur, megabytes * bytes_per_megabyte);
  setrlimit(RLIMIT_DATA, &limit);
}

void add_max_bits(CLI::App& verb, int& bits) {
  verb.add_option("--max-bits", bits, "what needs more precision is undecided (exit code 3)")
      ->check(whole_number())
      ->check(CLI::Range(least_bits, most_bits))
      ->capture_default_str();
}

void add_max_events(CLI::App& verb, std::uint64_t& events) {
  verb.add_option("--max-events", events, "a history that has more is undecided (exit code 3)")
      ->check(whole_number())
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 62));
}

std::string time_limit_reason() {
  return "the time limit of " + number_text(seconds) + " s is reached (--time-limit)";
}

std::string memory_limit_reason() {
  return "the memory limit of " + std::to_string(megabytes) + " MB is reached (--max-memory)";
}

std::string event_limit_reason(std::uint64_t events) {
  return "the limit of " + std::to_string(events) + " events is reached (--max-events)";
}

bool has_memory_limit() { return megabytes > 0; }

void lift_memory_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = memory_before;
  setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace voroproof::internal
