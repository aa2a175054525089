// Early ends of a run: signals, and the limits that its user sets.
#pragma once

#include "exact/patience.h"

namespace voroproof::internal {

// From here on SIGINT, SIGTERM, SIGHUP (where it is not ignored, as by nohup) and SIGQUIT end the
// process at once, with a message, the exit code of an interruption and no unfinished file. That
// suits all work that has nothing to say about how far it came. A file that grows beyond what the
// system allows is an error of writing and not a signal.
void install_signal_handlers();

// The process ends after so many seconds (> 0) as by a signal, but undecided.
void start_time_limit(double seconds);

// While it lives, the first signal, and the end of the time limit, are only noted, for the work to
// ask for. Where that does not happen, because of a system call that waits or a step that takes
// long, the process ends all the same a second later, or on a second signal, half a second after
// the first or later. At most one lives at a time.
class CooperativeInterruption {
 public:
  CooperativeInterruption();
  CooperativeInterruption(const CooperativeInterruption&) = delete;
  CooperativeInterruption& operator=(const CooperativeInterruption&) = delete;
  ~CooperativeInterruption();

  // Whether an interruption was requested, by a signal or because the time is over.
  bool requested() const;
  // Whether it was the time.
  bool late() const;
  // Throws Interrupted or Undecided where it is requested.
  void check() const;
  // The work is done or given up, and the result is to be written: it is waited for, however long
  // the disk takes.
  void wind_up();
};

}  // namespace voroproof::internal
