#include "apps/cli/progress.h"

#include <unistd.h>

#include <cstdio>
#include <string>

namespace voroproof::internal {
namespace {

constexpr std::chrono::milliseconds period{300};
constexpr double longest_estimate = 1e7;  // seconds; beyond, none is given

std::string clock_text(double seconds) {
  const long all = static_cast<long>(seconds + 0.5);
  char text[48];
  if (all >= 3600) {
    std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", all / 3600, all / 60 % 60, all % 60);
  } else {
    std::snprintf(text, sizeof text, "%ld:%02ld", all / 60, all % 60);
  }
  return text;
}

}  // namespace

Progress::Progress(double horizon, bool quiet)
    : shown_(!quiet && isatty(STDERR_FILENO) == 1),
      horizon_(horizon),
      start_(Clock::now()),
      next_(start_ + period) {}

Progress::~Progress() {
  if (dirty_) std::fputs("\r\033[K", stderr);
}

void Progress::report(double t, std::uint64_t events) {
  if (!shown_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + period;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = t > 0 ? elapsed * (horizon_ - t) / t : longest_estimate;
  std::fprintf(stderr, "\rt = %.6g of %.6g, %llu events, %.0f/s%s\033[K", t, horizon_,
               static_cast<unsigned long long>(events), static_cast<double>(events) / elapsed,
               left < longest_estimate ? (", about " + clock_text(left) + " left").c_str() : "");
  std::fflush(stderr);
  dirty_ = true;
}

}  // namespace voroproof::internal
