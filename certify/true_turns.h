// The true states after a turn: they are computed, or taken over from a leader that has computed
// them (docs/certificate.md, Rule 3.24).
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "filtered/computed/computed_motion.h"
#include "filtered/search/moment.h"
#include "history/scene.h"

namespace voroproof::internal {

struct TrueTurn {
  static constexpr std::size_t no_maneuver = std::numeric_limits<std::size_t>::max();

  LedTurn led;
  double near = 0;                     // a collision is at the contact next to this time
  DdBall time{};                       // and encloses its time
  std::size_t maneuver = no_maneuver;  // which one of the scene
  MotionStates::After states{};        // for who follows
};

// Each result is valid until the next turn.
class TrueTurns {
 public:
  virtual ~TrueTurns() = default;
  // The two collide at m, which is proved to be their next contact.
  virtual const TrueTurn& collide(GenId i, GenId j, const Moment& m) = 0;
  // The disk of maneuver k of the scene turns.
  virtual const TrueTurn& maneuver(std::size_t k) = 0;
};

// `motion` computes them.
class ComputedTurns final : public TrueTurns {
 public:
  ComputedTurns(const Scene& scene, ComputedMotion& motion) : scene_(scene), motion_(motion) {}
  const TrueTurn& collide(GenId i, GenId j, const Moment& m) override;
  const TrueTurn& maneuver(std::size_t k) override;

 private:
  const Scene& scene_;
  ComputedMotion& motion_;
  TrueTurn last_;
};

// `motion` follows the leader's, which has computed `turns`, one after the other. Throws Undecided
// where another turn is asked for than the next of these. They outlive the motion.
class FollowedTurns final : public TrueTurns {
 public:
  FollowedTurns(ComputedMotion& motion, const std::vector<TrueTurn>& turns)
      : motion_(motion), turns_(turns) {}
  const TrueTurn& collide(GenId i, GenId j, const Moment& m) override;
  const TrueTurn& maneuver(std::size_t k) override;
  bool all_taken() const { return next_ == turns_.size(); }

 private:
  template <class Is>
  const TrueTurn& take(const Is& is_asked_for);

  ComputedMotion& motion_;
  const std::vector<TrueTurn>& turns_;
  std::size_t next_ = 0;
};

}  // namespace voroproof::internal
