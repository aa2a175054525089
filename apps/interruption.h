// SIGINT and SIGTERM: runs that write files stop in good order.
#pragma once

#include <stdexcept>

namespace voroproof {

// Work that was given up because of a signal.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

// From here on SIGINT and SIGTERM end the process at once, with a message and the exit code of an
// interruption. That suits all work that has no file begun.
void install_signal_handlers();

// While it lives, the first signal is only noted, for the work to ask for; a second one ends the
// process at once. At most one lives at a time.
class CooperativeInterruption {
 public:
  CooperativeInterruption();
  CooperativeInterruption(const CooperativeInterruption&) = delete;
  CooperativeInterruption& operator=(const CooperativeInterruption&) = delete;
  ~CooperativeInterruption();

  bool requested() const;
  // Throws Interrupted where it is.
  void check() const;
};

}  // namespace voroproof
