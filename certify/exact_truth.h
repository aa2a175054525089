// The exact truth, where that is asked for: how disks turn, and when two touch, as it is computed.
// The recorded truth has it from the claims, and nothing of this.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "certify/certificate.h"
#include "certify/setting.h"

namespace voroproof::internal {

class CellsAround;
class Claims;
struct Front;
class Instants;
class PairLives;
class Refuter;

// Why the life of a pair ends: one of the two turns; its edge flips; a window of one of the two
// ends, and the next begins; the history ends, or a part.
enum class PairEnd { turn, flip, window, end };

class ExactTruth {
 public:
  // The parts of the checker that it uses.
  struct Parts {
    Setting& s;
    const Claims& claims;
    Front& front;
    const Refuter& refuter;
    PairLives& pairs;
    CellsAround& around;
    Instants& instants;
  };
  using Make = std::function<std::unique_ptr<ExactTruth>(const Parts&)>;
  virtual ~ExactTruth() = default;

  // ---- Pairs. ----
  // When the present motion of the pair began: with the later of the last turns of the two.
  virtual Moment since(GenId i, GenId j) const = 0;
  // When the two touch next, from then on.
  virtual std::optional<Moment> next_contact(GenId i, GenId j) = 0;
  // How two that are said to collide at the time t, and do not, stand to each other then, or at the
  // present instant if it is no further from t than the tolerance: see text_of().
  virtual std::string standing(GenId i, GenId j, const Rational& t) const = 0;
  // Two points do not meet from the birth of their motion to m. Throws Undecided.
  virtual void require_no_meeting(GenId i, GenId j, const Moment& m) = 0;
  // The pair does not touch while it approaches from the birth of its motion to m; at m itself it
  // may only where its motion ends there, too: the order of the instant's turns is told. Throws
  // Refuted.
  virtual void require_no_contact(GenId i, GenId j, const Moment& m, PairEnd why) = 0;
  // One of the two turns now, and they are not proved to be apart.
  virtual void note_near(GenId i, GenId j) = 0;

  // ---- Turns. ----
  // Prove the claim being checked, that of maneuver k of the scene, or throw Refuted or Undecided.
  virtual void collide(const CollideEvent& claim) = 0;
  virtual void maneuver(const ManeuverEvent& claim, std::size_t k) = 0;
  // Another instant begins.
  virtual void begin_instant() = 0;
  // No more turns at the present instant: see TurnOrder::require_order().
  virtual void require_order(bool complete) = 0;
  // The claim that turns something, and is false: what should have come before it at the same
  // instant, if that is known.
  virtual std::optional<Divergence> due_before() const = 0;
};

}  // namespace voroproof::internal
