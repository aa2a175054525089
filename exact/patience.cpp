#include "exact/patience.h"

#include <utility>

namespace voroproof::internal {

namespace {

thread_local Patience* innermost = nullptr;
thread_local unsigned since_asked = 0;  // steps

}  // namespace

Patience::Patience(std::function<bool()> wanted)
    : wanted_(std::move(wanted)), outer_(std::exchange(innermost, this)) {}

Patience::~Patience() { innermost = outer_; }

void Patience::ask(unsigned steps) {
  since_asked += steps;
  if (innermost == nullptr || since_asked < kSteps) return;
  since_asked = 0;
  if (!innermost->wanted_()) throw GivenUp();
}

}  // namespace voroproof::internal
