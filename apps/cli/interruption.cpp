#include "apps/cli/interruption.h"

#include <signal.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "apps/cli/command_line.h"
#include "apps/cli/limits.h"
#include "filtered/motion/options.h"
#include "history/atomic_file.h"

namespace voroproof::internal {
namespace {

constexpr unsigned grace = 1;  // seconds from a request to the end of the process
// Signals that follow the first so soon are the same request: timeout(1) sends its own twice, and a
// terminal's goes to a program and to what started it, which may pass it on.
constexpr std::int64_t one_request = 500'000'000;  // nanoseconds

enum class Cause { none, signal, time };

// A handler can reach nothing but globals.
std::atomic<bool> cooperative{false}, winding_up{false};
std::atomic<Cause> noted{Cause::none};
std::atomic<std::int64_t> first_at{0};  // when a signal came first, in nanoseconds
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<Cause>::is_always_lock_free &&
              std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t nanoseconds_since_first() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const std::int64_t at = std::int64_t{1'000'000'000} * now.tv_sec + now.tv_nsec;
  std::int64_t none = 0;
  return first_at.compare_exchange_strong(none, at) ? 0 : at - none;
}

[[noreturn]] void end(Cause cause) {
  AtomicFile::remove_unfinished();
  const bool late = cause == Cause::time;
  const std::string_view message =
      late ? "voroproof: the time limit is reached\n" : "voroproof: interrupted\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message.data(), message.size());
  _exit(static_cast<int>(late ? ExitCode::undecided : ExitCode::interrupted));
}

// One alarm clock serves for both: the time limit, and the grace once something is noted.
extern "C" void on_signal(int number) {
  const bool alarm_rings = number == SIGALRM;
  const bool same_request = !alarm_rings && nanoseconds_since_first() < one_request;
  Cause cause = Cause::none;
  const Cause wanted = alarm_rings ? Cause::time : Cause::signal;
  const bool first = noted.compare_exchange_strong(cause, wanted);
  if (alarm_rings && winding_up.load()) return;
  if (!first) {
    if (same_request && cause == Cause::signal) return;
    end(alarm_rings ? cause : Cause::signal);
  }
  if (!cooperative.load()) end(wanted);
  if (!winding_up.load()) alarm(grace);
}

// Nobody reads on: the process ends as such processes do, and leaves no unfinished file.
extern "C" void on_closed_pipe(int number) {
  AtomicFile::remove_unfinished();
  signal(number, SIG_DFL);
  raise(number);
}

void handle(int number, int flags) {
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = flags;
  sigaction(number, &action, nullptr);
}

}  // namespace

void install_signal_handlers() {
  for (const int number : {SIGINT, SIGTERM, SIGQUIT, SIGALRM}) handle(number, SA_RESTART);
  struct sigaction before {};
  if (sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) {
    handle(SIGHUP, SA_RESTART);
  }
  signal(SIGXFSZ, SIG_IGN);
  if (signal(SIGPIPE, on_closed_pipe) == SIG_IGN) signal(SIGPIPE, SIG_IGN);
}

void start_time_limit(double seconds) {
  const double whole = std::floor(seconds);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - whole) * 1e6);
  if (whole == 0 && timer.it_value.tv_usec == 0) timer.it_value.tv_usec = 1;  // 0 is no timer
  setitimer(ITIMER_REAL, &timer, nullptr);
}

CooperativeInterruption::CooperativeInterruption() { cooperative.store(true); }

CooperativeInterruption::~CooperativeInterruption() {
  cooperative.store(false);
  winding_up.store(false);
}

bool CooperativeInterruption::requested() const {
  return noted.load(std::memory_order_relaxed) != Cause::none;
}

bool CooperativeInterruption::late() const { return noted.load() == Cause::time; }

void CooperativeInterruption::check() const {
  if (late()) throw Undecided(time_limit_reason());
  if (requested()) throw Interrupted();
}

void CooperativeInterruption::wind_up() {
  winding_up.store(true);
  alarm(0);
}

}  // namespace voroproof::internal
