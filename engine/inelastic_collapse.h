// Inelastic collapse: with a restitution below 1 infinitely many collisions may happen before some
// instant. No history goes beyond it, and no run reaches it: it must be seen coming.
//
// For a disk alone at the wall it is proved. Notation: the law "normal" with restitution e < 1, rho
// the container's radius less the disk's, u > 0 the inward and w the tangential velocity of the
// disk just after a collision with the wall at t0.
//
// Lemma. If w is not 0 and nothing else changes the disk's motion before t0 + D,
//   D = 2 rho u / (w^2 (1 - e)),
// the disk collides with the wall infinitely often before t0 + D.
// Proof. Its centre runs along chords of the circle of radius rho. A chord meets the circle under
// the same angle at both ends, so the disk comes back with the normal speed u and the tangential
// one w, and leaves with e u and w. The k-th chord takes the time 2 rho u_k / (u_k^2 + w^2), u_k =
// e^k u: less than 2 rho u e^k / w^2, and the sum over all k is less than D.
//
// Lemma. Nothing else changes the disk's motion before t0 + D if there is no maneuver before, and
// if from every other disk j it is further away than (S_j + V) D, where V^2 = u^2 + w^2, S_j^2 = 2
// E / m_j, and E is the kinetic energy of all disks just after t0. Proof. No collision increases
// the kinetic energy, as no restitution exceeds 1: until the first contact of the disk with
// another, j is never faster than S_j, and the disk never than V.
//
// All else (more disks, chains of them, the wall and a neighbour in turns) is taken to be a
// collapse by a rule (engine/collapse_rule.h).
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "filtered/motion/motion.h"
#include "filtered/search/collapse.h"

namespace voroproof::internal {

class InelasticCollapse {
 public:
  explicit InelasticCollapse(const Motion& motion);

  // Takes note of the collision of i < j at the instant `now`, the states after it being in force.
  // `quiet_until`: no maneuver is due before this time. Throws Undecided, with the disks and the
  // time, where a collapse is seen.
  void after_collision(GenId i, GenId j, const Moment& now, double quiet_until);

  struct Past {
    std::vector<double> times;  // times of the last collisions
    int at_wall = 0;            // collisions with the wall alone since the last other one
  };
  // Per disk; empty where no collapse is possible. What it knows of the run, for one that goes on.
  const std::vector<Past>& pasts() const { return past_; }
  // Precondition: they are of a run of the same scene.
  void go_on_with(std::vector<Past> pasts) { past_ = std::move(pasts); }

 private:
  void alone_at_wall(GenId g, const Moment& now, double quiet_until);
  bool undisturbed(GenId g, const DoubleBall& t, const DoubleBall& speed,
                   const DoubleBall& delay) const;

  const Motion& motion_;
  double horizon_;
  bool possible_;
  std::vector<Past> past_;
};

}  // namespace voroproof::internal
