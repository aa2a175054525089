// Collisions and maneuvers: the claimed changes of the motion.
#pragma once

#include <optional>

#include "certify/cells_around.h"
#include "certify/claims.h"
#include "certify/front.h"
#include "certify/instants.h"
#include "certify/pair_lives.h"
#include "certify/refuter.h"
#include "certify/responses.h"
#include "certify/setting.h"

namespace voroproof::internal {

class Turns {
 public:
  Turns(Setting& s, const Claims& claims, Front& front, const Refuter& refuter, PairLives& pairs,
        CellsAround& around, Instants& instants)
      : s_(s),
        claims_(claims),
        front_(front),
        refuter_(refuter),
        pairs_(pairs),
        around_(around),
        instants_(instants),
        responses_(s, claims, refuter) {}

  // Prove the claim being checked, or throw Refuted or Undecided.
  void collide(const CollideEvent& claim);
  void maneuver(const ManeuverEvent& claim);

 private:
  void collide_as_recorded(const CollideEvent& claim, int edge);
  std::optional<ExactPair> recorded_response(const CollideEvent& claim, const BallPair& at);
  void maneuver_as_recorded(const ManeuverEvent& claim, std::size_t k, const Rational& t);
  void require_as_scheduled(const ManeuverEvent& claim, const Maneuver& due, const Rational& t);
  void turn(GenId g);

  Setting& s_;
  const Claims& claims_;
  Front& front_;
  const Refuter& refuter_;
  PairLives& pairs_;
  CellsAround& around_;
  Instants& instants_;
  Responses responses_;
};

}  // namespace voroproof::internal
