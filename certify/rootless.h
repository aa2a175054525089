// Flip polynomials without roots, several at once: what proves most lives of edges.
#pragma once

#include <vector>

#include "filtered/motion.h"

namespace voroproof {

// A set of V-edges, each over an interval of its own. The motion of their generators is that at the
// time of prove().
class RootlessBatch {
 public:
  explicit RootlessBatch(const Motion& motion) : motion_(motion) {}

  void clear() { spans_.clear(); }
  // Adds the edge q over [a, b]; the first is numbered 0.
  void add(const Quad& q, double a, double b) { spans_.push_back({q, a, b}); }
  void prove();
  // Whether the flip polynomial of the k-th provably has no root in its [a, b]: its four generators
  // are cotangent at no time of it, the ends included. False says nothing.
  bool rootless(std::size_t k) const { return proved_[k] != 0; }

 private:
  struct Span {
    Quad q;
    double a, b;
  };
  static constexpr std::size_t kLanes = 4;
  void prove_lanes(std::size_t first, std::size_t count);

  const Motion& motion_;
  std::vector<Span> spans_;
  std::vector<char> proved_;
};

}  // namespace voroproof
