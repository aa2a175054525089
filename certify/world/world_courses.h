// The motion of a world, piece by piece.
#pragma once

#include <vector>

#include "exact/generators.h"
#include "exact/polynomial.h"
#include "exact/world_motion.h"
#include "filtered/worlds/rough_rows.h"

namespace voroproof::internal {

using WorldPolynomial = Polynomial<Rational>;

// Centre and radius of a generator as polynomials in the time since 0, of degree 1 at most.
struct Course {
  WorldPolynomial x, y, r;
};

// All that the scene itself says of a disk at a time up to the horizon.
struct Scheduled {
  enum class Kind { enters, turns, jumps, leaves };
  Rational t;
  GenId g;
  Kind kind;
  GrowingDisk after;  // at t; without meaning where the disk leaves
};

// Every generator as it moves now. A disk that is not there keeps the course it had.
class WorldCourses {
 public:
  // `filters`: doubles decide where they can.
  WorldCourses(const WorldMotion& world, bool filters);

  int disks() const { return static_cast<int>(there_.size()); }
  bool has_circle() const { return has_circle_; }
  // The same courses in doubles.
  const RoughRows& rough() const { return rough_; }
  const Rational& horizon() const { return horizon_; }
  // Some time after the horizon up to which lives are followed: to tell what happens just after it.
  // No verdict depends on it.
  const Rational& limit() const { return limit_; }
  // Sorted by time, then by disk. Those that enter at 0 are there from the beginning.
  const std::vector<Scheduled>& schedule() const { return schedule_; }

  bool is_there(GenId g) const { return g < 0 || there_[g]; }
  const Course& course(GenId g) const { return courses_[g + 1]; }
  // The end of the course, or limit().
  const Rational& until(GenId g) const;
  // Lets it take effect. Each is taken once, in their order.
  void take(const Scheduled& change);

 private:
  void schedule_disk(GenId g, const WorldPath& path);
  void set(GenId g, Course course);

  Rational horizon_, limit_;
  bool has_circle_;
  RoughRows rough_;
  std::vector<Scheduled> schedule_;
  std::vector<Course> courses_;  // that of the frame first
  std::vector<bool> there_;
  std::vector<std::vector<Rational>> ends_;  // by disk, the last first
};

}  // namespace voroproof::internal
