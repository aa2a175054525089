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

#include <array>
#include <optional>
#include <vector>

#include "exact/ball.h"
#include "exact/roots.h"
#include "filtered/motion/motion.h"

namespace voroproof::internal {

// A state of a generator: the motion since a record of the log, or the initial one
// (Motion::state_id). The container has only the initial one.
struct DiskState {
  GenId g;
  int id;
  bool operator==(const DiskState&) const = default;
};
using QuadStates = std::array<DiskState, 4>;
using PairStates = std::array<DiskState, 2>;

inline DiskState state_of(const Motion& motion, GenId g) { return {g, motion.state_id(g)}; }
inline QuadStates states_of(const Motion& motion, const Quad& q) {
  return {state_of(motion, q.l), state_of(motion, q.s), state_of(motion, q.r),
          state_of(motion, q.e)};
}
inline PairStates states_of(const Motion& motion, GenId i, GenId j) {
  return {state_of(motion, i), state_of(motion, j)};
}

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
  virtual ~Symmetry() = default;

  // Whether the four certainly touch one circle as long as they move like this, namely
  // every circle that three of them touch; `t` is some time at which they are where the states in
  // force say:
  //   - they are mirror images of each other two by two: three of them hold a pair, the
  //     centre of a circle that touches both of it is on the axis, so the circle is its
  //     own image and touches the fourth as it touches the third; or
  //   - isometries that fix one point carry one onto the others, of the same radius: their
  //     centres have the same distance from that point, and three points lie on one circle.
  virtual bool always_cotangent(const QuadStates& q, const DoubleBall& t) const = 0;

  // Whether the four generators, with their states in force, certainly touch one circle at
  // the instant, which lies between lo and hi: some circle that touches three of them, or
  // every such circle.
  enum class Cotangency { unknown, some_circle, every_circle };
  virtual Cotangency cotangency(const QuadStates& q, const Coincidence& known, double lo,
                                double hi) const = 0;

  // Whether the four certainly are mirror images of each other two by two at some time between lo
  // and hi, so that then every circle that touches three of them touches the fourth. Two pairs that
  // isometries carry onto each other for good are such when the diagonals between them are equal.
  virtual bool mirrored_between(const QuadStates& q, double lo, double hi) const = 0;

  // Whether two generators, with their states in force, certainly touch at the instant.
  virtual bool touch(const PairStates& pair, const Coincidence& known) const = 0;

  // Whether the next contacts of two pairs are certainly simultaneous.
  virtual bool same_contact(const PairStates& a, const PairStates& b) const = 0;

  // Whether two flips are certainly simultaneous, both of states in force: `time` encloses the
  // first, and [root.lo, root.hi] isolates the root of the second's flip polynomial.
  virtual bool same_flip(const QuadStates& a, const Ball& time, const QuadStates& b,
                         const RootInterval& root) const = 0;

  // Whether a generator in this state certainly is at rest.
  virtual bool at_rest(const DiskState& s) const = 0;

  // The pair, in its states before, whose collision began a state of g; nothing for others.
  virtual std::optional<PairStates> collision_before(const DiskState& s) const = 0;
};

}  // namespace voroproof::internal
