// Contacts under the exact truth: when two neighbours touch, as they have moved since the later of
// them last turned.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "certify/exact_truth.h"
#include "certify/front.h"
#include "certify/refuter.h"
#include "certify/setting.h"
#include "certify/turn_order.h"

namespace voroproof::internal {

class ExactPairs {
 public:
  ExactPairs(Setting& s, const Front& front, const Refuter& refuter, TurnOrder& order)
      : s_(s), front_(front), refuter_(refuter), order_(order) {}

  // The disk has turned at m, the present instant.
  void note_birth(GenId g, const Moment& m);
  // See ExactTruth.
  Moment since(GenId i, GenId j) const;
  std::string standing(GenId i, GenId j, const Rational& t) const;
  void require_no_meeting(GenId i, GenId j, const Moment& m);
  void require_no_contact(GenId i, GenId j, const Moment& m, PairEnd why);
  // When the two touch next, from the birth of their present motion on.
  NextContact next_contact(GenId i, GenId j);
  // When i and j touch: `c` is not `none`.
  Moment moment_of(GenId i, GenId j, const NextContact& c) const;

 private:
  // When the present motion of a disk began, and the number of that instant.
  struct Birth {
    Moment moment;
    int instant;
  };
  const Birth* birth(GenId i, GenId j) const;
  Moment born(GenId i, GenId j) const;
  bool born_at_present(GenId i, GenId j) const;

  Setting& s_;
  const Front& front_;
  const Refuter& refuter_;
  TurnOrder& order_;
  std::vector<std::shared_ptr<const Birth>> births_;  // by disk; empty before the first
};

}  // namespace voroproof::internal
