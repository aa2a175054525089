// The order of what one instant changes (docs/formats.md, section 6): collisions, the smallest pair
// first; maneuvers; collisions that these bring about; flips. Claims that commute may be exchanged.
// Another order is accepted where that is asked for (CertifyOptions::any_order).
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "certify/certificate.h"
#include "certify/due_pairs.h"
#include "certify/front.h"
#include "certify/refuter.h"
#include "certify/setting.h"

namespace voroproof::internal {

// Two generators that touch and approach in these states (Motion::state_id).
struct DuePair {
  GenId i, j;
  int state_i, state_j;
  Divergence missing;  // the refutation where their collision is not claimed; few have a witness
};

class TurnOrder {
 public:
  TurnOrder(Setting& s, const Front& front, const Refuter& refuter)
      : s_(s), front_(front), refuter_(refuter) {}

  // Another instant begins.
  void clear() {
    turns_.clear();
    near_.clear();
    due_.clear();
    begun_.reset();
  }
  // The claim of a line, a collision (i < j) or maneuver (i = j), is about to turn its
  // disks at the present instant.
  void begin(GenId i, GenId j, std::int64_t line, Event claim);
  // They turn as it was claimed.
  void end() {
    turns_.push_back(*std::move(begun_));
    begun_.reset();
  }
  // The claim that has begun, and not ended, is false: what should have come before it at the same
  // instant, if that is known.
  std::optional<Divergence> due_before() const;
  // The two touch and approach at the present instant, and one of them turns now
  // without colliding with the other.
  void note_due(GenId i, GenId j, Divergence missing);
  // One of the two turns now, and they are not proved to be apart.
  void note_near(GenId i, GenId j) { near_.emplace_back(i, j); }
  // i and j turn at t = 0, where no pair has a life. Notes of all their other pairs what
  // note_near() and note_due() do.
  void note_at_start(GenId i, GenId j);
  // No more turns at the present instant. What has turned does so in the format's order, where
  // claims that share no disk may be exchanged; or in any, where that was asked for: then this is
  // counted. `complete`: these are all claims of the instant, which is not known where a history
  // stops. Throws Refuted and Undecided.
  void require_order(bool complete);

 private:
  std::optional<Divergence> fault(bool complete) const;
  Divergence named(Divergence wrong_order) const;
  std::optional<Divergence> left_due() const;
  std::vector<GenId> untold_maneuvers() const;

  Setting& s_;
  const Front& front_;
  const Refuter& refuter_;
  // The turns of this instant, in the order of the claims.
  std::vector<Turn> turns_;
  std::optional<Turn> begun_;
  std::vector<std::pair<GenId, GenId>> near_;
  std::vector<DuePair> due_;
};

}  // namespace voroproof::internal
