// Motion of the disks alone, recomputed in high precision from the order of the events.
//
// Given which pairs collide in which order, the time of each collision is the first contact
// after the pair's previous events, in closed form, and the velocities after it follow from the
// response law. No search is involved, so this says nothing by itself on whether the events are
// the right ones: first_missed_contact does.
#pragma once

#include <gmpxx.h>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "tests/oracle/circle.h"

namespace voroproof::oracle {

// State at time 0. Masses must be positive for disks that collide with disks.
struct MovingDisk {
  mpq_class x, y, vx, vy, radius, mass;
};

enum class WallLaw { normal, whole };

struct MotionScene {
  ExactCircle container;
  mpq_class wall_restitution = 1;
  WallLaw wall_law = WallLaw::normal;
  mpq_class disk_restitution = 1;
  std::vector<MovingDisk> disks;
};

// Disks i and j collide; one of the two may be the container, -1.
struct CollisionRecord {
  int i, j;
};

// Disk i has this velocity from time t on.
struct ManeuverRecord {
  int i;
  mpq_class t, vx, vy;
};

// One event. Exactly one of the two is set.
struct MotionRecord {
  std::optional<CollisionRecord> collision;
  std::optional<ManeuverRecord> maneuver;
};

inline MotionRecord collision(int i, int j) { return {CollisionRecord{i, j}, std::nullopt}; }
inline MotionRecord maneuver(int i, mpq_class t, mpq_class vx, mpq_class vy) {
  return {std::nullopt, ManeuverRecord{i, std::move(t), std::move(vx), std::move(vy)}};
}

// Computes with the given number of decimal digits. A collision amplifies errors by 10 to 15
// bits for each earlier collision of its own causal chain (more when tiny disks are fast), so
// 300 digits carry some 70 collisions of one disk; compare two precisions to be sure.
template <unsigned Digits>
class BasicMotionOracle {
 public:
  using Number = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<Digits>,
                                               boost::multiprecision::et_off>;
  using Vector = std::array<Number, 2>;

  struct Contact {
    Number t;
    int i, j;  // i < j; i may be the container, -1
  };

  // Applies the records in order. Throws std::invalid_argument for a record that names no disk,
  // for a collision whose pair never meets on its present path or overlaps already, and for a
  // maneuver before an earlier event of its disk.
  BasicMotionOracle(const MotionScene& scene, const std::vector<MotionRecord>& records);

  // The time of each record, in the order of the records. That they increase is for the caller
  // to check: only the order of the events of one disk is enforced here.
  const std::vector<Number>& times() const { return times_; }
  double nearest_double(std::size_t record) const;

  // Centre of a disk at time t >= 0; beyond the last record it keeps its velocity.
  Vector position(int disk, const Number& t) const;

  // Velocity of a disk at time t >= 0; at an event, the one just after.
  Vector velocity(int disk, const Number& t) const;

  // All disks at time t >= 0, for brute_force_diagram.
  std::vector<Circle> disks_at(const Number& t) const;

  // The earliest instant in [t0, t1] from which on two disks overlap, or a disk leaves the
  // container, by more than tolerance() explains: a collision that the records miss.
  // nullopt when there is none. Examines every pair on every common straight piece.
  std::optional<Contact> first_missed_contact(const Number& t0, const Number& t1) const;

 private:
  // From time `start` on: centre `at` at that time, then velocity `v`.
  struct Piece {
    Number start;
    Vector at, v;
  };
  struct Body {
    Number radius, mass;
    std::vector<Piece> path;
  };

  // What rounding may do to a squared distance: 10^(-Digits/3) of the container's squared radius.
  Number tolerance() const;
  Body& body(int disk);
  const Body& body(int disk) const;
  const Piece& piece_at(int disk, const Number& t) const;
  void add_piece(int disk, const Number& t, const Vector& v);
  Number collide_disks(int i, int j);
  Number collide_wall(int i);
  Number apply(const ManeuverRecord& record);
  void examine_pair(int i, int j, const Number& t0, const Number& t1,
                    std::optional<Contact>& first) const;

  Vector container_centre_;
  Number container_radius_, wall_restitution_, disk_restitution_;
  WallLaw wall_law_;
  std::vector<Body> bodies_;
  std::vector<Number> times_;
};

extern template class BasicMotionOracle<300>;
extern template class BasicMotionOracle<1000>;

using MotionOracle = BasicMotionOracle<300>;

}  // namespace voroproof::oracle
