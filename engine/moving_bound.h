// The bound below which the keys of a queue are in its heap. Most keys change, or come to nothing,
// before their time comes: the others wait in no order. When the heap is empty the bound moves on,
// by steps that follow the number of keys that they bring into the heap.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace voroproof::internal {

class MovingBound {
 public:
  double value() const { return value_; }

  // Moves on to where some of the keys, which are not before the bound or have no time (infinity),
  // are before it, if there are any. `gather` takes those before value() into the heap and returns
  // how many these are.
  template <class Gather>
  void move(const std::vector<double>& keys, const Gather& gather) {
    const std::size_t all = keys.size();
    std::size_t found = 0;
    if (value_ + step_ > value_) found = to(value_ + step_, gather);
    if (found == 0) {
      // This is reached at the start, and where the next keys are far off.
      if (keys.empty()) return;
      const double least = *std::min_element(keys.begin(), keys.end());
      if (!std::isfinite(least)) return;
      if (step_ == 0) step_ = mean_delay(keys, least) / kPart;
      found = to(std::max(least + step_, std::nextafter(least, kInfinity)), gather);
    }
    // The next step takes as many as are worth the passage through all keys, more or less.
    if (found < all / (2 * kPart)) {
      step_ = 2 * step_;
    } else if (found > 2 * all / kPart) {
      step_ = 0.5 * step_;
    }
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr std::size_t kPart = 32;  // one in so many is in the heap, more or less

  template <class Gather>
  std::size_t to(double bound, const Gather& gather) {
    value_ = bound;
    return gather();
  }

  // The mean of the finite keys, counted from `least`.
  static double mean_delay(const std::vector<double>& keys, double least) {
    double sum = 0;
    int count = 0;
    for (const double key : keys) {
      if (std::isfinite(key)) {
        sum += key - least;
        ++count;
      }
    }
    return sum / count;
  }

  double value_ = -kInfinity;
  double step_ = 0;
};

// Visits the places of all keys before the bound.
template <class Visit>
void each_before(const std::vector<double>& keys, double bound, const Visit& visit) {
  constexpr std::size_t kBlock = 8;
  for (std::size_t first = 0; first < keys.size(); first += kBlock) {
    const std::size_t last = std::min(first + kBlock, keys.size());
    if (last - first == kBlock) {
      // Most blocks have none: all keys are compared at once, without a branch for each.
      int any = 0;
      for (std::size_t k = 0; k < kBlock; ++k) any |= int(keys[first + k] < bound);
      if (any == 0) continue;
    }
    for (std::size_t k = first; k < last; ++k) {
      if (keys[k] < bound) visit(k);
    }
  }
}

}  // namespace voroproof::internal
