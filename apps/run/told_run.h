// How a verb ends that has written a history, of whichever kind.
#pragma once

#include <iostream>
#include <string>

#include "apps/cli/verb.h"
#include "history/error.h"
#include "history/json_text.h"

namespace voroproof::internal {

// Closes a history, and says where it is if one of its name is complete and stays.
template <class Writer>
void close_history(Writer& writer, const std::string& path, bool replace) {
  if (replace) return writer.close();
  const std::string written = writer.close_beside_complete();
  if (written == path) return;
  std::cerr << "voroproof: " << printable(path, 4096)
            << ": is complete and stays; the history that stopped is in "
            << printable(written, 4096) << '\n';
}

// Says to stderr how a run ended that did not come to its horizon, and gives the exit code.
template <class Outcome>
ExitCode told_end(const Outcome& outcome) {
  using Kind = decltype(outcome.kind);
  if (outcome.kind == Kind::complete) return ExitCode::ok;
  const bool stopped = outcome.kind == Kind::stopped;
  std::cerr << "voroproof: " << (stopped ? "stopped" : "interrupted")
            << " at t = " << number_text(outcome.t);
  if (stopped) std::cerr << ": " << printable(outcome.reason, 4096);
  std::cerr << '\n';
  return stopped ? ExitCode::undecided : ExitCode::interrupted;
}

}  // namespace voroproof::internal
