// Contacts under the exact truth: when two neighbours touch, as they have moved since the later of
// them last turned.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "certify/front.h"
#include "certify/refuter.h"
#include "certify/setting.h"
#include "certify/turn_order.h"

namespace voroproof::internal {

// Why the life of a pair ends: one of the two turns; its edge flips; a window of one of the two
// ends, and the next begins; the history ends, or a part.
enum class PairEnd { turn, flip, window, end };

class ExactPairs {
 public:
  ExactPairs(Setting& s, const Front& front, const Refuter& refuter, TurnOrder& order)
      : s_(s), front_(front), refuter_(refuter), order_(order) {}

  // The disk has turned at m, the present instant.
  void note_birth(GenId g, const Moment& m);
  // When the present motion of the pair began: with the later of the last turns of the two.
  Moment since(GenId i, GenId j) const;
  // When the two touch next, from the birth of their present motion on.
  NextContact next_contact(GenId i, GenId j);
  // When i and j touch: `c` is not `none`.
  Moment moment_of(GenId i, GenId j, const NextContact& c) const;
  // How two that are said to collide at the time t, and do not, stand to each other then, or at the
  // present instant if it is no further from t than the tolerance: see text_of().
  std::string standing(GenId i, GenId j, const Rational& t) const;
  // Two points do not meet from the birth of their motion to m. Throws Undecided.
  void require_no_meeting(GenId i, GenId j, const Moment& m);
  // The pair does not touch while it approaches from the birth of its motion to m; at m itself it
  // may only where its motion ends there, too: the order of the instant's turns is told. Throws
  // Refuted.
  void require_no_contact(GenId i, GenId j, const Moment& m, PairEnd why);

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
