// Several numbers as one argument.
#pragma once

#include <array>
#include <cstddef>
#include <sstream>
#include <string>

#include "apps/cli/command_line.h"

namespace voroproof::internal {

// The numbers, separated by commas, each rounded to nearest. Throws UsageError, naming the option.
template <std::size_t N>
std::array<double, N> numbers_argument(const std::string& option, const std::string& text) {
  std::array<double, N> all{};
  std::istringstream words(text);
  std::string word;
  for (double& x : all) {
    if (!std::getline(words, word, ',')) throw UsageError(option + ": too few numbers");
    x = round_nearest(number_argument(option, word));
  }
  if (std::getline(words, word)) throw UsageError(option + ": too many numbers");
  return all;
}

}  // namespace voroproof::internal
