// Predicted conjunctions: where vehicles of a plan come too near.
//
// This is the planner's view of a plan, in doubles where they can tell. What a finished plan keeps
// is decided anew by clearance.h.
#pragma once

#include <optional>
#include <vector>

#include "library/planning/plan.h"

namespace voroproof::internal {

class Conjunctions {
 public:
  explicit Conjunctions(const PlanTask& task);

  // The vehicles whose ways come so near to that of vehicle i that speeds decide.
  const std::vector<int>& neighbors(int i) const { return neighbors_[i]; }

  // When the two first come too near, as the step at which they are nearest in that piece; nothing
  // where they keep clear.
  std::optional<double> first(int i, const Timetable& of_i, int j, const Timetable& of_j) const;

  // The number of neighbours to which vehicle i comes too near with this timetable; no more than
  // `enough` are counted.
  int count(int i, const Timetable& timetable, const std::vector<Timetable>& all, int enough) const;

  // The square of the least distance while the two progress linearly, i from a to b and j from c to
  // d parts of its way, less the square of what they have to keep, in a unit of length of the task;
  // and at which part of the time.
  struct Nearest {
    double excess, part;
  };
  Nearest nearest(int i, double a, double b, int j, double c, double d) const;

  // Whether vehicle j, on the part of its way from c to d, can come too near to i, wherever that is
  // on its way.
  bool reaches(int j, double c, double d, int i) const;

  // Excesses nearer to zero than this are decided exactly.
  double doubt() const { return doubt_; }

 private:
  struct Vec {
    double x, y;
  };
  struct Way {
    Vec start, way;
  };

  Vec place(int i, double progress) const;
  double reach(int i, int j) const { return radii_[i] + radii_[j] + clearance_; }

  const PlanTask& task_;
  std::vector<Way> ways_;
  std::vector<double> radii_;
  double clearance_;
  double doubt_, margin_;
  std::vector<std::vector<int>> neighbors_;
};

}  // namespace voroproof::internal
