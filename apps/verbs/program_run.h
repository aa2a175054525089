// The options of verbs that run another program on scenes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "apps/cli/verb.h"
#include "apps/corpus/run.h"

namespace voroproof::internal {

struct ProgramRun {
  std::string command, truth = "both", events = "all";
  double seconds = 60;
  std::uint64_t megabytes = 4096;
  std::size_t jobs = 1;

  // Adds --against, --truth, --events, --timeout, --memory and --jobs, which go to this object.
  void add_to(Verb& verb, bool required);
  // Throws UsageError where the command names no scene or no history, or the time is not positive.
  void require_valid() const;
  CorpusRunOptions options(std::function<bool(std::size_t finished)> progress) const;
};

}  // namespace voroproof::internal
