#include "apps/interruption.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <string_view>

#include "apps/command_line.h"

namespace voroproof {
namespace {

// A handler can reach nothing but globals.
std::atomic<bool> cooperative{false};
std::atomic<bool> noted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void on_signal(int) {
  if (cooperative.load() && !noted.exchange(true)) return;
  constexpr std::string_view message = "voroproof: interrupted\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message.data(), message.size());
  _exit(static_cast<int>(ExitCode::interrupted));
}

}  // namespace

void install_signal_handlers() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

CooperativeInterruption::CooperativeInterruption() { cooperative.store(true); }

CooperativeInterruption::~CooperativeInterruption() { cooperative.store(false); }

bool CooperativeInterruption::requested() const { return noted.load(std::memory_order_relaxed); }

void CooperativeInterruption::check() const {
  if (requested()) throw Interrupted();
}

}  // namespace voroproof
