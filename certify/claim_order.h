// Which claim is checked next: claims near each other in time may be written in another order than
// the true one.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "certify/claims.h"
#include "certify/edge_lives.h"
#include "certify/front.h"
#include "certify/instants.h"
#include "certify/refuter.h"
#include "certify/setting.h"

namespace voroproof::internal {

class ClaimOrder {
 public:
  using HalfEdge = Diagram::HalfEdge;

  ClaimOrder(Setting& s, Claims& claims, const Front& front, const Refuter& refuter,
             EdgeLives& edges, Instants& instants)
      : s_(s),
        claims_(claims),
        front_(front),
        refuter_(refuter),
        edges_(edges),
        instants_(instants),
        concerned_(s.scene.disks.size()) {}

  // Makes the next claim the one being checked. Precondition: there are near claims. Throws Refuted
  // where the order in the file is wrong and may not be.
  void take_next();
  // Makes the next claim of a change of the motion at t = 0, in truth, the one being checked,
  // wherever within the tolerance the file has it. Throws Refuted like take_next(). False if there
  // is none.
  bool take_next_at_start();

 private:
  std::size_t earliest();
  HalfEdge meant_by(const FlipEvent& claim) const;
  bool has_to_flip_now(const Event& event) const;
  std::size_t turn_before(const Event& event);
  const std::optional<Moment>& moment_of(Claims::Claim& claim);
  std::optional<Moment> probe(const Event& event);
  std::optional<Moment> probe_flip(const FlipEvent& claim);
  void take_before_others(std::size_t k);
  void take(std::size_t k);
  bool turns_at_start(const Event& event);

  Setting& s_;
  Claims& claims_;
  const Front& front_;
  const Refuter& refuter_;
  EdgeLives& edges_;
  Instants& instants_;
  std::int64_t ties_ = 0;                // ties numbered so far
  std::int64_t taken_ = 0;               // claims taken so far
  std::vector<std::int64_t> concerned_;  // for each disk: taken_ when it was in a claim last
};

}  // namespace voroproof::internal
