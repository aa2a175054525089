// The proofs of filtered/search/symmetry.h for a motion that is computed, by what carries the pasts
// of disks onto each other.
#pragma once

#include <span>
#include <vector>

#include "filtered/computed/carry.h"
#include "filtered/computed/computed_motion.h"
#include "filtered/search/symmetry.h"

namespace voroproof::internal {

class ComputedSymmetry final : public Symmetry {
 public:
  explicit ComputedSymmetry(const ComputedMotion& motion) : motion_(motion) {}

  bool always_cotangent(const QuadStates& q, const DoubleBall& t) const override;
  Cotangency cotangency(const QuadStates& q, const Coincidence& known, double lo,
                        double hi) const override;
  bool mirrored_between(const QuadStates& q, double lo, double hi) const override;
  bool touch(const PairStates& pair, const Coincidence& known) const override;
  bool same_contact(const PairStates& a, const PairStates& b) const override;
  bool same_flip(const QuadStates& a, const Ball& time, const QuadStates& b,
                 const RootInterval& root) const override;
  bool at_rest(const DiskState& s) const override { return internal::at_rest(motion_, s); }
  std::optional<PairStates> collision_before(const DiskState& s) const override;

 private:
  std::vector<Isometry> carry(std::span<const DiskState> from,
                              std::span<const DiskState> to) const {
    return internal::carry(motion_, from, to);
  }
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

  const ComputedMotion& motion_;
};

}  // namespace voroproof::internal
