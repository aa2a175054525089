// The order of what one instant changes (docs/formats.md, section 6): collisions, the smallest pair
// first; maneuvers; collisions that these bring about; flips. Claims that commute may be exchanged.
#pragma once

#include <span>
#include <vector>

#include "certify/exact_pairs.h"
#include "certify/front.h"
#include "certify/refuter.h"
#include "certify/setting.h"
#include "filtered/search/carry.h"

namespace voroproof::internal {

// A collision (i < j) or maneuver (i = j), and the states of the motion that it ended.
struct Turn {
  GenId i, j;
  int state_i, state_j;
};

class TurnOrder {
 public:
  TurnOrder(Setting& s, const Front& front, const Refuter& refuter)
      : s_(s), front_(front), refuter_(refuter) {}

  // Another instant begins.
  void clear() {
    turns_.clear();
    flipped_.clear();
  }
  // The edge q has flipped at the present instant.
  void note_flip(const Quad& q) { flipped_.insert(flipped_.end(), {q.l, q.r, q.s, q.e}); }
  // No flip at this instant has been claimed of a generator that turns at it, now. Throws Refuted.
  void require_no_flip_yet(GenId i, GenId j) const;

  // At t = 0 no pair has a life yet that a turn would end. The first function requires that no
  // smaller pair touches and approaches that has a generator of the pair i, j which collides; the
  // second, that no pair does that has the disk g of a maneuver. Both throw Refuted.
  void require_first_at_start(GenId i, GenId j);
  void require_no_contact_at_start(GenId g);

  // Exact truth: puts what has just been proved to turn at the present instant where the format's
  // order has it, among those that turned before it. Throws Refuted and Undecided.
  void place(const Turn& turn);

 private:
  void require_commutes(const Turn& turn, std::span<const Turn> passed) const;
  bool would_collide(GenId g, const DiskState& other) const;

  Setting& s_;
  const Front& front_;
  const Refuter& refuter_;
  std::vector<Turn> turns_;     // of this instant, in the order of the format
  std::vector<GenId> flipped_;  // generators of the edges that have flipped at this instant
};

}  // namespace voroproof::internal
