// When do two generators touch? The next contact of a pair under its present motion.
#pragma once

#include <optional>

#include "filtered/motion/motion.h"
#include "filtered/numbers/stats.h"
#include "filtered/search/collapse.h"

namespace voroproof::internal {

struct NextContact {
  enum class Kind {
    none,  // no contact from now on, or none up to `end`
    at,    // the next contact lies in [lo, hi], later than now
    now,   // the pair touches now and approaches
  };
  Kind kind = Kind::none;
  double lo = 0, hi = 0;
};

// A contact is the time at which a pair begins to overlap: the smaller root of the
// quadratic |d + w s|^2 = (r_i + r_j)^2, for the container the larger root of |d + w
// s|^2 = (R - r_i)^2. Contacts of even order (grazing) are none.
class ContactSearch {
 public:
  ContactSearch(Motion& motion, TierCounts& counts) : motion_(motion), counts_(counts) {}

  // The next contact of i < j at or after `now`, no later than `end`. They do not
  // overlap at `now`. Throws Undecided when a disk slides along the container, which
  // the model does not cover.
  NextContact from(GenId i, GenId j, const Moment& now, double end);

  // Whether the two certainly do not touch at `now`, nor overlap: as far as doubles tell, where
  // filters are on, and as far as balls do.
  bool certainly_apart(GenId i, GenId j, const Moment& now) const;
  bool apart_by_balls(GenId i, GenId j, const Moment& now) const;

  // The contact that lies next to t, tightly; radius infinite where not known.
  DdBall refine(GenId i, GenId j, double t) const;
  Ball refine(GenId i, GenId j, const Rational& t, int bits) const;
  // The time of the next contact that `from` announced, exactly. `near` is any
  // rational next to it.
  static ExactTime exact_time(GenId i, GenId j, const Rational& near, ExactMotion& exact);

 private:
  // The ladder beneath the first filter.
  NextContact slow(GenId i, GenId j, const Moment& now, double end);
  template <class T>
  std::optional<NextContact> in(GenId i, GenId j, const Moment& now, double end, const T& t,
                                const T& zero) const;
  std::optional<NextContact> by_symmetry(GenId i, GenId j, const Moment& now) const;
  NextContact exactly(GenId i, GenId j, const Moment& now, double end);

  Motion& motion_;
  TierCounts& counts_;
};

}  // namespace voroproof::internal
