// The instants of a history: when the truth moves on to the next one, nothing may be left that had
// to happen at the one before.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "certify/claims.h"
#include "certify/edge_lives.h"
#include "certify/front.h"
#include "certify/pair_lives.h"
#include "certify/refuter.h"
#include "certify/setting.h"

namespace voroproof::internal {

class Instants {
 public:
  Instants(Setting& s, const Claims& claims, Front& front, const Refuter& refuter, EdgeLives& edges,
           PairLives& pairs)
      : s_(s), claims_(claims), front_(front), refuter_(refuter), edges_(edges), pairs_(pairs) {}

  // The event of the claim being checked happens at m: the front moves there. Throws Refuted where
  // it has moved on already, or where something is missing before m.
  void advance(const Moment& m);
  // The present instant is left. Throws Refuted where an edge should have flipped at it.
  void leave();
  // Begins the lives that wait for the end of the instant's turns.
  void begin_pending_lives();

  // The edge q has flipped at the present instant.
  void note_flip(const Quad& q) { flipped_.insert(flipped_.end(), {q.l, q.r, q.s, q.e}); }
  // No flip at this instant has been claimed of a generator that turns at it, now. Throws Refuted.
  void require_no_flip_yet(GenId i, GenId j) const;

  // Whether the event of the claim being checked, which happens at m, is claimed in time.
  bool in_time(const Moment& m);
  // Whether m is the moment for which the tie was proved: then no generator of it has turned since.
  bool is_moment_of(const Tie& tie, const Moment& m) const;

  // Every maneuver that is scheduled before t must have been claimed. Throws Refuted.
  void require_maneuvers_before(double t);

 private:
  void require_areas(const std::vector<int>& edges) const;
  void prove_hidden_anew(std::vector<int>& edges);

  Setting& s_;
  const Claims& claims_;
  Front& front_;
  const Refuter& refuter_;
  EdgeLives& edges_;
  PairLives& pairs_;
  std::vector<GenId> flipped_;  // generators of the edges that have flipped at this instant
  std::int64_t tie_ = 0;        // tie of the claims that are simultaneous with the front
  std::vector<int> beginning_;  // edges whose lives begin
  // Up to here a generator lay inside another at the last such moment, if there was one.
  std::optional<Moment> revealed_;
};

}  // namespace voroproof::internal
