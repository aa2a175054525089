// The order of the turns of one instant, at which more than two touch (docs/formats.md, sections 6
// and 21).
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "certify/billiards/billiard_motion.h"
#include "certify/billiards/billiard_truth.h"

namespace voroproof::internal {

// Takes the turns of an instant again, in the order that the format gives them. The same has to
// happen to each disk, one after the other, as the claims say.
class TrueInstant {
 public:
  // `touching`: all pairs that touch then and may approach, but for those whose collisions are
  // claimed then. The others must outlive it.
  TrueInstant(const Billiard& billiard, const BilliardMotion& motion, const Rational& t,
              const std::set<BilliardPair>& touching);

  // The first turn that is in a wrong place; none where all are right.
  std::optional<BilliardFault> fault();

 private:
  // The turns of a disk, and its place and present velocity.
  struct Chain {
    std::vector<const TrueLine*> turns;
    std::size_t taken = 0;
    Vec3 place, velocity;
    const TrueLine* head() const { return taken < turns.size() ? turns[taken] : nullptr; }
  };

  void add(GenId disk);
  bool approach(const BilliardPair& pair) const;
  const TrueLine* head(GenId disk) const { return disk < 0 ? nullptr : chains_.at(disk).head(); }
  void take(GenId disk);
  std::optional<BilliardFault> collide();
  std::optional<BilliardFault> maneuver();
  BilliardFault misplaced(std::int64_t line, const std::string& truth,
                          const BilliardPair& pair) const;

  const Billiard& billiard_;
  const BilliardMotion& motion_;
  const Rational& t_;
  std::set<BilliardPair> touching_;
  std::map<GenId, Chain> chains_;
  std::deque<GenId> waiting_;
  std::int64_t last_line_ = 1;  // the last turn's
};

}  // namespace voroproof::internal
