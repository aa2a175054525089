#include "exact/patience.h"

#include <utility>

namespace voroproof::internal {

namespace {

// Steps take from a tenth of a microsecond to some milliseconds.
constexpr unsigned kSteps = 64;

thread_local Patience* innermost = nullptr;
thread_local unsigned steps = 0;

}  // namespace

Patience::Patience(std::function<bool()> wanted)
    : wanted_(std::move(wanted)), outer_(std::exchange(innermost, this)) {}

Patience::~Patience() { innermost = outer_; }

void Patience::ask() {
  if (innermost != nullptr && ++steps % kSteps == 0 && !innermost->wanted_()) throw GivenUp();
}

}  // namespace voroproof::internal
