// Other ways to isolate the roots of flip polynomials.
//
// What they are given is more than the search has: the exact polynomial is formed
// before the clock starts. What they do is less: they isolate all roots in the window
// but do not say at which one the edge collapses.
#pragma once

#include <memory>
#include <vector>

#include "exact/generators.h"
#include "exact/rational.h"
#include "history/scene.h"

namespace voroproof::internal::bench {

// A polynomial over the integers, constant term first, and the window (0, end) in
// which its roots are asked for.
struct RootTask {
  std::vector<Integer> coefficients;
  double end;
};

// The flip polynomial of q under the initial motion, primitive: f of the paper's
// Eq. (1), or C of Eq. (3) for four equal radii.
std::vector<Integer> flip_polynomial_of(const Scene& scene, const Quad& q);

// A peer prepares its own form of each task first; isolate() is what is timed.
class RootIsolator {
 public:
  virtual ~RootIsolator() = default;
  // Isolates the roots of all tasks; returns how many there are.
  virtual long isolate() = 0;
  // How many tasks isolate() could not finish, in all calls.
  virtual long undecided() const { return 0; }
};

// CGAL::Algebraic_kernel_d_1 (bitstream Descartes over the integers).
std::unique_ptr<RootIsolator> cgal_isolator(const std::vector<RootTask>& tasks);
// Arb balls of 128 bits: Descartes' rule in the Bernstein basis, by subdivision.
std::unique_ptr<RootIsolator> arb_isolator(const std::vector<RootTask>& tasks);

}  // namespace voroproof::internal::bench
