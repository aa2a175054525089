// How the motion is computed, and what it says where that does not suffice.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "exact/generators.h"
#include "exact/motion_input.h"

namespace voroproof::internal {

struct MotionOptions {
  bool filters = true;  // false: no decision is taken in doubles or double-doubles
  int start_bits = 192;
  int max_bits = 32768;
  std::size_t max_radicals = 4;
};

// A decision that needs more than the stated budget, and what it is about.
class Undecided : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  Undecided(const std::string& reason, const Quad& edge) : std::runtime_error(reason), flip(edge) {}
  Undecided(const std::string& reason, GenId i, GenId j)
      : std::runtime_error(reason), contact(std::pair(i, j)) {}

  std::optional<Quad> flip;
  std::optional<std::pair<GenId, GenId>> contact;
};

}  // namespace voroproof::internal
