// Proofs about one pair of generators over an interval of time, in doubles with error bounds.
#pragma once

#include <vector>

#include "filtered/motion/motion.h"

namespace voroproof::internal {

// Whether i and j, apart or parting at a, provably do not begin to overlap in (a, b], under their
// present motion. Says nothing when false.
bool proved_apart(const Motion& motion, GenId i, GenId j, double a, double b);

// Asks what proved_apart() asks, of several pairs at once. The motion of the generators is that at
// the time of prove().
class ApartBatch {
 public:
  explicit ApartBatch(const Motion& motion) : motion_(motion) {}

  void clear() { pairs_.clear(); }
  // Adds the pair i < j from a on; the first is numbered 0.
  void add(GenId i, GenId j, double a) { pairs_.push_back({i, j, a}); }
  // Looks at all pairs, each from its own a up to b.
  void prove(double b);
  bool apart(std::size_t k) const { return apart_[k] != 0; }

 private:
  struct Pair {
    GenId i, j;
    double a;
  };
  const Motion& motion_;
  std::vector<Pair> pairs_;
  std::vector<char> apart_;
};

}  // namespace voroproof::internal
