// Equality proved by symmetry.
//
// The state of a disk follows from its causal past: the initial states, masses and
// maneuvers in it, and who collided with whom in which order. The collision law and the
// rules for a pair's next contact are the same in every place and direction. So if an
// isometry of the plane carries the initial states of one past onto those of another,
// and the two pasts agree collision by collision, then it carries the one state onto the
// other, at any depth and without any arithmetic on the states themselves. Where a past
// touches the container, the isometry has to fix the container's centre.
//
// From that follow the ties of symmetric input, which no arithmetic of bounded cost
// could prove: events that are images of each other are simultaneous, and mirror images
// in pairs stay cotangent. Every answer here is a proof when true and says nothing when
// false.
#pragma once

#include <span>
#include <vector>

#include "exact/roots.h"
#include "filtered/motion/motion.h"
#include "filtered/search/carry.h"

namespace voroproof::internal {

// The proved facts about one instant. States are those in force just before it, or since an earlier
// event of the same instant.
struct Coincidence {
  // Quadruplets that are cotangent at the instant with one of their V-edges shrunk to a
  // point, in the cyclic order of their contact points (l, s, r, e).
  std::vector<QuadStates> flips;
  // Pairs whose next contact it is.
  std::vector<PairStates> contacts;
  // The number of the log's records that lie before the instant; all others are at it.
  int records = 0;
};

class Symmetry {
 public:
  explicit Symmetry(const Motion& motion) : motion_(motion) {}

  // The states in force.
  DiskState state(GenId g) const { return {g, motion_.state_id(g)}; }
  QuadStates states(const Quad& q) const {
    return {state(q.l), state(q.s), state(q.r), state(q.e)};
  }
  PairStates states(GenId i, GenId j) const { return {state(i), state(j)}; }

  // Calls carry() of filtered/search/carry.h.
  std::vector<Isometry> carry(std::span<const DiskState> from,
                              std::span<const DiskState> to) const {
    return voroproof::internal::carry(motion_, from, to);
  }

  // Whether the four certainly touch one circle as long as they move like this, namely
  // every circle that three of them touch; `t` is some time at which they are where the states in
  // force say:
  //   - they are mirror images of each other two by two: three of them hold a pair, the
  //     centre of a circle that touches both of it is on the axis, so the circle is its
  //     own image and touches the fourth as it touches the third; or
  //   - isometries that fix one point carry one onto the others, of the same radius: their
  //     centres have the same distance from that point, and three points lie on one circle.
  bool always_cotangent(const QuadStates& q, const DoubleBall& t) const;

  // Whether the four generators, with their states in force, certainly touch one circle at
  // the instant, which lies between lo and hi: some circle that touches three of them, or
  // every such circle.
  enum class Cotangency { unknown, some_circle, every_circle };
  Cotangency cotangency(const QuadStates& q, const Coincidence& known, double lo, double hi) const;

  // Whether the four certainly are mirror images of each other two by two at some time between lo
  // and hi, so that then every circle that touches three of them touches the fourth. Two pairs that
  // isometries carry onto each other for good are such when the diagonals between them are equal.
  bool mirrored_between(const QuadStates& q, double lo, double hi) const;

  // Whether two generators, with their states in force, certainly touch at the instant.
  bool touch(const PairStates& pair, const Coincidence& known) const;

  // Whether the next contacts of two pairs are certainly simultaneous.
  bool same_contact(const PairStates& a, const PairStates& b) const;

  // Whether two flips are certainly simultaneous, both of states in force: `time` encloses the
  // first, and [root.lo, root.hi] isolates the root of the second's flip polynomial.
  bool same_flip(const QuadStates& a, const Ball& time, const QuadStates& b,
                 const RootInterval& root) const;

 private:
  Rational radius(const DiskState& s) const;  // signed
  bool mirrored_in_pairs(const QuadStates& q, const DoubleBall& t) const;
  bool turned_about_a_point(const QuadStates& q) const;
  DiskState before(DiskState s, const Coincidence& known) const {
    return state_before(motion_, s, known.records);
  }
  bool carried_into(const QuadStates& q, const std::vector<DiskState>& others,
                    const DoubleBall& now) const;
  std::vector<DiskState> near_circle(const QuadStates& flip, const Coincidence& known,
                                     const DoubleBall& now) const;
  bool is_image(const DiskState& x, const std::vector<DiskState>& circle,
                const DoubleBall& now) const;
  bool joins(const DiskState& x, const QuadStates& cluster, const DoubleBall& now) const;

  const Motion& motion_;
};

}  // namespace voroproof::internal
