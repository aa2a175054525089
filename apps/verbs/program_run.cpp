#include "apps/verbs/program_run.h"

#include <utility>

#include "apps/cli/command_line.h"

namespace voroproof::internal {

namespace {

constexpr std::uint64_t bytes_per_megabyte = std::uint64_t{1} << 20;

std::vector<Truth> truths_of(const std::string& word) {
  if (word == "exact") return {Truth::exact};
  if (word == "recorded") return {Truth::recorded};
  return {Truth::exact, Truth::recorded};
}

}  // namespace

void ProgramRun::add_to(Verb& verb, bool required) {
  Option& against = verb.text(
      "--against", command, "COMMAND",
      "The program, run by the shell for each scene, in this folder: {scene} stands for the scene "
      "to read, {history} for the history or event sequence to write. Both are put in quotes where "
      "they need them.");
  if (required) against.required();
  Option& truths = verb.choice(
      "--truth", {"exact", "recorded", "both"}, truth,
      "What the program's histories are certified against: the true motion, the motion that each "
      "history itself records, or either, whichever holds.");
  Option& kinds = verb.choice("--events", {"all", "collisions"}, events,
                              "Which events of the program's histories are judged: with "
                              "\"collisions\" flips and initial diagrams are passed over.");
  if (!required) {
    truths.needs("--against");
    kinds.needs("--against");
  }
  verb.real("--timeout", seconds,
            "The seconds for each run of the program and for each certification.");
  verb.whole("--memory", megabytes, 0, 1 << 30,
             "The megabytes for each of these processes; 0: no limit.");
  verb.whole("--jobs", jobs, 1, 1024,
             "The number of scenes side by side; more than 1 makes the seconds longer.");
}

void ProgramRun::require_valid() const {
  for (const char* placeholder : {"{scene}", "{history}"}) {
    if (!command.empty() && command.find(placeholder) == std::string::npos) {
      throw UsageError(std::string("--against: the command does not name ") + placeholder);
    }
  }
  if (!(seconds > 0)) throw UsageError("--timeout: must be more than 0");
}

CorpusRunOptions ProgramRun::options(std::function<bool(std::size_t finished)> progress) const {
  CorpusRunOptions options;
  options.command = command;
  options.truths = truths_of(truth);
  options.events = events == "all" ? EventKinds::all : EventKinds::collisions;
  options.limits = {.seconds = seconds, .bytes = megabytes * bytes_per_megabyte};
  options.jobs = jobs;
  options.progress = std::move(progress);
  return options;
}

}  // namespace voroproof::internal
