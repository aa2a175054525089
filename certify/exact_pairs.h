// Contacts under the exact truth: when two neighbours touch, as they have moved since the later of
// them last turned.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact_truth.h"
#include "certify/front.h"
#include "certify/refuter.h"
#include "certify/setting.h"
#include "certify/turn_order.h"

namespace voroproof::internal {

// When the present motion of each disk began; nothing for those that have not turned.
using Births = std::vector<std::shared_ptr<const Moment>>;

class ExactPairs {
 public:
  // `births`: of before the history, or before the part of it.
  ExactPairs(Setting& s, const Front& front, const Refuter& refuter, TurnOrder& order,
             Births births)
      : s_(s),
        front_(front),
        refuter_(refuter),
        order_(order),
        births_(std::move(births)),
        instants_(births_.size(), 0) {}

  // Afterwards there are none here.
  Births take_births() { return std::move(births_); }
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
  GenId born_last(GenId i, GenId j) const;
  Moment born(GenId i, GenId j) const;
  bool born_at_present(GenId i, GenId j) const;

  Setting& s_;
  const Front& front_;
  const Refuter& refuter_;
  TurnOrder& order_;
  Births births_;
  // By disk: the number of the instant of its birth; 0 at the start, or before the part.
  std::vector<int> instants_;
};

}  // namespace voroproof::internal
