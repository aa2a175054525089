#include "apps/cli/limits.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "engine/engine.h"
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

void add_limits(Verb& verb) {
  Option& time = verb.add({.names = {"--time-limit"},
                           .type = "SECONDS",
                           .help = "The seconds after which the run ends, undecided."});
  time.take = [](const std::vector<std::string>& values) {
    const Rational limit = time_argument("--time-limit", values[0]);
    seconds = round_nearest(limit);
    if (limit == 0 || seconds > longest_time) {
      throw UsageError("--time-limit: " + printable(values[0]) + ": not in (0, 1e9]");
    }
  };
  verb.whole("--max-memory", megabytes, 1, 1 << 30,
             "The megabytes (private and writable) beyond which the run ends, undecided.");
}

}  // namespace

void add_process_limits(Verb& program) {
  if (program.verbs().empty()) add_limits(program);
  for (Verb& verb : program.verbs()) add_process_limits(verb);
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

void add_max_bits(Verb& verb, int& bits) {
  verb.whole("--max-bits", bits, least_bits, most_bits,
             "The bits of precision beyond which a decision is undecided (exit code 3).");
}

void add_max_events(Verb& verb, std::uint64_t& events) {
  verb.whole("--max-events", events, 1, std::uint64_t{1} << 62,
             "The number of events beyond which a history is undecided (exit code 3).");
}

void add_computing_limits(Verb& verb, EngineOptions& options) {
  add_max_bits(verb, options.motion.max_bits);
  add_max_events(verb, options.max_events);
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
