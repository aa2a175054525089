// Collisions and maneuvers under the exact truth: the claimed changes of the motion against those
// that are computed.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "certify/cells_around.h"
#include "certify/claims.h"
#include "certify/exact_pairs.h"
#include "certify/exact_truth.h"
#include "certify/front.h"
#include "certify/instants.h"
#include "certify/pair_lives.h"
#include "certify/refuter.h"
#include "certify/responses.h"
#include "certify/true_turns.h"
#include "certify/turn_order.h"

namespace voroproof::internal {

class ExactTurns : public ExactTruth {
 public:
  // `turns` is of the motion of the setting; `births` as ExactPairs takes them.
  ExactTurns(const Parts& of, TrueTurns& turns, Births births)
      : s_(of.s),
        claims_(of.claims),
        front_(of.front),
        refuter_(of.refuter),
        pairs_(of.pairs),
        around_(of.around),
        instants_(of.instants),
        turns_(turns),
        order_(s_, front_, refuter_),
        exact_(s_, front_, refuter_, order_, std::move(births)),
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

 protected:
  Instants& instants() { return instants_; }
  Births take_births() { return exact_.take_births(); }
  // The disks of the claim turn at m, which is their contact, or by maneuver k.
  const TrueTurn& turn(const CollideEvent& claim, Moment m);
  const TrueTurn& turn(std::size_t k);
  // They have turned.
  void note(const CollideEvent& claim, const TrueTurn& turned);

 private:
  Moment contact_of(const CollideEvent& claim);
  // A claimed state against the true one, correctly rounded.
  void check_state(const CollideEvent& claim, int side, const RoundedState& truth);

  Setting& s_;
  const Claims& claims_;
  Front& front_;
  const Refuter& refuter_;
  PairLives& pairs_;
  CellsAround& around_;
  Instants& instants_;
  TrueTurns& turns_;
  TurnOrder order_;
  ExactPairs exact_;
  Responses responses_;
};

}  // namespace voroproof::internal
