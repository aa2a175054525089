// All edges of a diagram some at a time: of many more than that the caches would hold nothing of
// what is made of each.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>

namespace voroproof::internal {

// Visits the numbers from 0 to count - 1 in their order, as spans of several.
template <class Visit>
void each_block(int count, Visit&& visit) {
  std::array<int, 512> numbers;
  for (int first = 0; first < count; first += static_cast<int>(numbers.size())) {
    const int size = std::min(count - first, static_cast<int>(numbers.size()));
    std::iota(numbers.begin(), numbers.begin() + size, first);
    visit(std::span<const int>(numbers.data(), static_cast<std::size_t>(size)));
  }
}

}  // namespace voroproof::internal
