// Collisions and maneuvers under the exact truth: the claimed changes of the motion against those
// that are computed.
#pragma once

#include <optional>
#include <string>

#include "certify/cells_around.h"
#include "certify/claims.h"
#include "certify/exact_pairs.h"
#include "certify/exact_truth.h"
#include "certify/front.h"
#include "certify/instants.h"
#include "certify/pair_lives.h"
#include "certify/refuter.h"
#include "certify/responses.h"
#include "certify/turn_order.h"
#include "filtered/computed/computed_motion.h"

namespace voroproof::internal {

class ExactTurns final : public ExactTruth {
 public:
  // `motion` is that of the setting.
  ExactTurns(ComputedMotion& motion, const Parts& of)
      : motion_(motion),
        s_(of.s),
        claims_(of.claims),
        front_(of.front),
        refuter_(of.refuter),
        pairs_(of.pairs),
        around_(of.around),
        instants_(of.instants),
        order_(s_, front_, refuter_),
        exact_(s_, front_, refuter_, order_),
        responses_(s_, claims_, refuter_) {}

  Moment since(GenId i, GenId j) const override { return exact_.since(i, j); }
  std::optional<Moment> next_contact(GenId i, GenId j) override;
  std::string standing(GenId i, GenId j, const Rational& t) const override {
    return exact_.standing(i, j, t);
  }
  void require_no_meeting(GenId i, GenId j, const Moment& m) override {
    exact_.require_no_meeting(i, j, m);
  }
  void require_no_contact(GenId i, GenId j, const Moment& m, PairEnd why) override {
    exact_.require_no_contact(i, j, m, why);
  }
  void note_near(GenId i, GenId j) override { order_.note_near(i, j); }

  void collide(const CollideEvent& claim) override;
  void maneuver(const ManeuverEvent& claim, std::size_t k) override;
  void begin_instant() override { order_.clear(); }
  void require_order(bool complete) override { order_.require_order(complete); }
  std::optional<Divergence> due_before() const override { return order_.due_before(); }

 private:
  Moment contact_of(const CollideEvent& claim);
  // A claimed state against the true one, correctly rounded.
  void check_state(const CollideEvent& claim, int side, const RoundedState& truth);

  ComputedMotion& motion_;
  Setting& s_;
  const Claims& claims_;
  Front& front_;
  const Refuter& refuter_;
  PairLives& pairs_;
  CellsAround& around_;
  Instants& instants_;
  TurnOrder order_;
  ExactPairs exact_;
  Responses responses_;
};

}  // namespace voroproof::internal
