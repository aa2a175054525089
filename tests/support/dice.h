// Small random integers, the same on every system.
#pragma once

#include <random>

namespace voroproof::internal::testing {

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  // From low to high, both included.
  int operator()(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
  }

 private:
  std::mt19937 engine_;
};

}  // namespace voroproof::internal::testing
