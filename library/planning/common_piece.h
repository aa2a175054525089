// Two disks on a piece of time on which their offset is a polynomial.
//
// The square of their distance is a polynomial, too. Its least value is at an end of the piece or
// at a root of its derivative, and the times at which the gap is some distance are roots. Roots of
// a polynomial of degree 1 are rational, and so is all that is said of two straight ways; others
// are isolated (exact/roots.h) and narrowed.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "exact/enclosure.h"
#include "exact/polynomial.h"
#include "exact/roots.h"
#include "history/paths_file.h"
#include "library/planning/clearance.h"

namespace voroproof::internal {

// A longest interval in which the gap of a pair is less than some distance. Each end is enclosed;
// it is where the distance is reached, or where one of the two comes or goes.
struct NearSpell {
  Enclosure from, to;
  Approach nearest;  // the least gap in it, and when first
};

// The part of a spell in a piece of time.
struct SpellPart {
  bool at_begin, at_end;  // whether it has the piece's beginning and end
  NearSpell spell;
};

// The disks i and j from one time to another, or for an instant.
struct CommonTime {
  int i, j;
  LatticeImage image;  // the one of j
  Rational from, to;
  Rational reach;  // the sum of both radii
};

class CommonPiece {
 public:
  // `offset`: of the image of j from i, by s from 0 to 1 in proportion to time, or at one instant.
  // `height` > 0: they count as near each other only while their third coordinates differ by less,
  // and their distance is that of the other two.
  CommonPiece(CommonTime time, const Curve& offset, const std::optional<Rational>& height);

  const CommonTime& time() const { return time_; }

  // The least gap; of equal ones the first in time. At a contact the gap is zero. Nothing where
  // they never count as near.
  std::optional<Approach> nearest(const std::set<GivenContact>& contacts) const;
  // All parts of spells in which the gap is less than `distance`, in order.
  std::vector<SpellPart> below(const Rational& distance,
                               const std::set<GivenContact>& contacts) const;
  // Whether one look at the coefficients proves that no distance is as small as the root of that.
  bool is_plainly_beyond(const Rational& distance2) const;

 private:
  // A part of the piece: ends between 0 and 1, each exact or enclosed.
  struct Span {
    RootInterval begin, end;
  };
  // `is_stationary`: at a root of the derivative of the distance's square.
  Approach approach_at(const RootInterval& s, bool is_stationary) const;
  Approach nearest_on(const Span& span, const std::set<GivenContact>& contacts) const;
  const std::vector<RootInterval>& stationary() const;
  Enclosure time_at(const RootInterval& s) const;

  CommonTime time_;
  Polynomial<Rational> distance2_;
  std::vector<Span> spans_;  // where they count as near; the ends may not
  bool is_near_at_begin_ = true, is_near_at_end_ = true;
  mutable std::optional<std::vector<RootInterval>> stationary_;
};

}  // namespace voroproof::internal
