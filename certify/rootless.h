// Flip polynomials without roots, or with one, several at once: what proves most lives of edges.
#pragma once

#include <array>
#include <vector>

#include "filtered/motion/motion.h"
#include "filtered/numbers/form.h"
#include "filtered/numbers/lanes.h"

namespace voroproof::internal {

struct MotionLanes;

// A set of V-edges, each over an interval of its own. The motion of their generators is that at the
// time of prove().
class RootlessBatch {
 public:
  explicit RootlessBatch(const Motion& motion) : motion_(motion) {}

  void clear() { spans_.clear(); }
  // Adds the edge q over [a, b]; the first is numbered 0.
  void add(const Quad& q, double a, double b) { spans_.push_back({q, a, b}); }
  // Proves what is asked for below, of all edges.
  void prove();
  // Proves less, of edges that were all added over one interval that is short: more rarely
  // successful and sooner done. It finds out only whether they are rootless.
  void prove_instant();
  // prove() of the four edges around the V-edge q, no two of which are the same, numbered in the
  // order (r,e), (e,l), (l,s), (s,r): outer[k] is the third generator of the k-th on the side where
  // q is not, and its interval is [from[k], b]. And prove_instant() of the same edges as they are
  // when q has flipped, over [a, b]: rootless_flipped() tells of these.
  void prove_around(const Quad& q, const std::array<GenId, 4>& outer,
                    const std::array<double, 4>& from, double a, double b);
  // Whether the flip polynomial of the k-th provably has no root in its [a, b]: its four generators
  // are cotangent at no time of it, the ends included. False says nothing.
  bool rootless(std::size_t k) const { return found_[k] == Found::rootless; }
  bool rootless_flipped(std::size_t k) const { return flipped_[k]; }
  // Whether provably it has at most one, and the four are separated throughout [a, b]: no disk
  // touches the inside of another, or leaves the container. False says nothing.
  bool one_root(std::size_t k) const { return found_[k] == Found::one_root; }
  // The sign of such an edge's flip polynomial at b.
  Sign end_sign(std::size_t k) const { return end_signs_[k]; }

 private:
  struct Span {
    Quad q;
    double a, b;
  };
  enum class Found : char { nothing, one_root, rootless };
  static constexpr std::size_t kLanes = 4;
  std::array<const Span*, kLanes> lanes(std::size_t first, std::size_t count) const;
  std::array<MotionLanes, 4> gather(const std::array<const Span*, kLanes>& of) const;
  struct Window;
  void judge(const Window& window, std::size_t first, std::size_t count);
  void judge_flipped(const Window& window, double since);
  void count_roots(const Form<Lanes, 8>& f, const Lanes& total, std::size_t lane, std::size_t k);
  void judge_at(const std::array<MotionLanes, 4>& generators, double a, double b, std::size_t first,
                std::size_t count);

  const Motion& motion_;
  std::vector<Span> spans_;
  std::vector<Found> found_;
  std::vector<Sign> end_signs_;
  std::array<bool, kLanes> flipped_{};  // rootless when q has flipped
};

// How many roots at most a polynomial has by Descartes' rule, where of its Bernstein coefficients,
// in order from the lowest bit, those in `above` may be positive and those in `below` negative: 0,
// 1, or 2 for more. (At an end of the interval too: a coefficient that may be both may be zero.)
int most_roots(unsigned above, unsigned below);

}  // namespace voroproof::internal
