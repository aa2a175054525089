// The first divergence of a history that is known to be false. The refuted claim may be the
// consequence of something missed before.
#pragma once

#include <initializer_list>
#include <optional>

#include "certify/claims.h"
#include "certify/edge_lives.h"
#include "certify/front.h"
#include "certify/pair_lives.h"
#include "certify/refuter.h"
#include "certify/setting.h"

namespace voroproof::internal {

class FirstDivergence {
 public:
  FirstDivergence(Setting& s, Claims& claims, const Front& front, const Refuter& refuter,
                  EdgeLives& edges, PairLives& pairs)
      : s_(s), claims_(claims), front_(front), refuter_(refuter), edges_(edges), pairs_(pairs) {}

  // The first event or maneuver that the history lacks before what was refuted, or that.
  Divergence before(const Divergence& refuted);
  // The first maneuver scheduled by t that the history lacks. Reads on.
  std::optional<Divergence> maneuver_missing_by(double t);
  // Where the present claim is undecided: the first event or maneuver that should have been claimed
  // before it. Disks that move through each other, since a collision is missing, lead the edges
  // into degeneracies that may be beyond the budget.
  std::optional<Divergence> before_undecided();
  // A time, at most t, before which nothing is missing in the lives that are open: no later than
  // the beginning of one in which this is undecided. `briefly`: what doubles do not prove is.
  double complete_until(double t, bool briefly);

 private:
  // The earliest so far, if any, and the time before which another would be earlier.
  struct Earliest {
    std::optional<Divergence> divergence;
    double limit;
  };
  bool turns_one_of(std::initializer_list<GenId> generators) const;
  std::optional<Divergence> refuted_in(const PairLives::Open& life);
  Divergence first_event_missing(const Divergence& found);
  double margin(const Earliest& first) const;
  NextContact contact_in(const PairLives::Open& life, double until);
  void look_for_contacts(Earliest& first);
  bool is_never_claimed(GenId i, GenId j, const NextContact& c);
  bool may_be_left_out(const PairLives::Open& life, const NextContact& c);
  std::optional<Divergence> due_before();
  void look_for_flips(Earliest& first);

  Setting& s_;
  Claims& claims_;
  const Front& front_;
  const Refuter& refuter_;
  EdgeLives& edges_;
  PairLives& pairs_;
};

}  // namespace voroproof::internal
