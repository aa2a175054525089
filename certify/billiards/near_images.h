// The images of a disk that are near to another.
#pragma once

#include <vector>

#include "filtered/billiards/billiard_gaps.h"

namespace voroproof::internal {

class NearImages {
 public:
  // Both must outlive it.
  NearImages(const Billiard& billiard, const BilliardGaps<Rational>& gaps)
      : billiard_(billiard), gaps_(gaps) {}

  // The images of the pair's second disk that may be nearest to the first one at t; its own is
  // ignored.
  std::vector<LatticeImage> all(const BilliardPair& pair, const Flight<Rational>& a,
                                const Flight<Rational>& b, const Rational& t) const;
  // The nearest one.
  LatticeImage nearest(const BilliardPair& pair, const Flight<Rational>& a,
                       const Flight<Rational>& b, const Rational& t) const;

 private:
  const Billiard& billiard_;
  const BilliardGaps<Rational>& gaps_;
};

}  // namespace voroproof::internal
