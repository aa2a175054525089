// Decisions that may take long ask now and then whether they are still wanted: whoever started them
// may be interrupted, and show that it is alive.
#pragma once

#include <exception>
#include <functional>
#include <stdexcept>

namespace voroproof::internal {

// Thrown out of a decision that is not wanted any more. Objects that were computing it are of no
// further use.
class GivenUp : public std::exception {
 public:
  const char* what() const noexcept override { return "a decision was given up"; }
};

// Thrown out of a whole run that is given up because whoever started it says so.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

// While it lives, the long decisions of this thread ask `wanted`; the one that was asked before is
// asked again afterwards. Without any they go on for as long as they take.
class Patience {
 public:
  explicit Patience(std::function<bool()> wanted);
  Patience(const Patience&) = delete;
  Patience& operator=(const Patience&) = delete;
  ~Patience();

  // To be called in each step of a long decision: once in many steps asks whether to go on. Throws
  // GivenUp. `steps`: as how many it counts, where it may take longer than some milliseconds.
  static void ask(unsigned steps = 1);
  // The same, and asks in any case.
  static void ask_now() { ask(kSteps); }

 private:
  // Steps take from a tenth of a microsecond to some milliseconds.
  static constexpr unsigned kSteps = 64;

  std::function<bool()> wanted_;
  Patience* outer_;
};

}  // namespace voroproof::internal
