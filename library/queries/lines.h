// A few generators on lines: when a probe just fits among them, and where it fits at a time.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "exact/polynomial.h"
#include "filtered/computed/computed_motion.h"
#include "library/queries/clearance.h"
#include "library/queries/paths.h"

namespace voroproof::internal {

// The generators on the lines that are in force on their paths from `start` on. Polynomials are in
// the time t itself, not since the start; they are zero where what they tell of never changes.
class Lines {
 public:
  Lines(const Paths& paths, const std::set<GenId>& generators, const Rational& start);

  // Vanishes where the gap of the two is twice the probe's radius; of a disk and the container also
  // where the point of their edge that is far from the disk has the probe's clearance.
  Polynomial<Rational> gate(GenId i, GenId j, const Rational& probe) const;
  // Vanishes where a circle of the probe's radius touches all three: where three circles around the
  // generators, widened by the probe, meet in a point.
  Polynomial<Rational> vertex(const Triple& v, const Rational& probe) const;

  // The nodes along an edge of the diagram at a time t >= start (see edge_profile()), each with
  // whether the probe fits there. For the closed edge around a lone disk, given as [0,-1,0,0],
  // these are its gate and its far point.
  struct Fit {
    ClearanceNode node;
    bool fits;
  };
  std::vector<Fit> along(const Quad& q, const Rational& t, const Rational& probe) const;
  // Whether it fits at the vertex.
  bool fits(const Triple& v, const Rational& t, const Rational& probe) const;

 private:
  struct Line {
    Polynomial<Rational> x, y;
    Rational radius;  // signed
  };
  Rational start_;
  std::map<GenId, GenId> local_;  // ids in input_, in the same order
  std::vector<GenId> global_;     // and back
  std::map<GenId, Line> lines_;
  MotionInput input_;  // from the start on
};

}  // namespace voroproof::internal
