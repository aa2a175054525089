// Work in processes of their own, several at a time, each within limits of time and memory.
//
// Whatever happens to the work (it crashes, it hangs, it eats all memory) happens to its process
// alone. A process leads a group of its own; the whole group is killed when its time is over, when
// the leader has ended, and when the run is given up. Of another program's work no descendant
// survives, whatever group it is in, not even where this process is killed outright. No other
// thread of this process does anything meanwhile, so that a forked one may do anything.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace voroproof::internal {

struct ProcessLimits {
  double seconds = 60;      // by the clock
  std::uint64_t bytes = 0;  // memory (private and writable) for each process; 0: no limit
};

// How a process ended.
struct ProcessEnd {
  enum class Kind { exited, signalled, timed_out };
  Kind kind = Kind::exited;
  int code = 0;        // exit code, or the number of the signal
  double seconds = 0;  // that it took

  bool success() const { return kind == Kind::exited && code == 0; }
};

// "exit code 3", "exit code 139, signal 11 (Segmentation fault)", "signal 9 (Killed)", "time out".
std::string description(const ProcessEnd& end);

// One process: what it does, and what is done about its end.
struct ProcessStep {
  // Run in the process, which then ends with the exit code returned.
  std::function<int()> work;
  ProcessLimits limits;
  // Run in this process.
  std::function<void(const ProcessEnd&)> on_end;
  // The work is another program's, whose processes may leave the group: they are ended, too.
  bool foreign = false;
};

// Steps one after the other; on_end may add some.
using ProcessJob = std::deque<ProcessStep>;

// Runs the jobs, at most `at_once` (>= 1) side by side, started in their order. After each finished
// job `progress` is called; several times a second it is asked too, without a finished job, and
// where it returns false everything is ended. Returns whether all jobs were finished. Throws
// std::system_error where the system gives no process.
bool run_jobs(std::vector<std::shared_ptr<ProcessJob>> jobs, std::size_t at_once,
              const std::function<bool(std::size_t finished)>& progress);

// In a forked process: becomes the shell that runs the command, its output going to the given
// files and its input empty. Returns, with an exit code, only where that fails.
int become_shell(const std::string& command, const std::string& out, const std::string& err);

// The text as one word of a shell's command.
std::string shell_word(const std::string& text);

}  // namespace voroproof::internal
