// Pairs that touch and approach at an instant at which disks turn: in the states that these have
// before it, between two of its turns and after it.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "certify/certificate.h"
#include "certify/front.h"
#include "certify/setting.h"

namespace voroproof::internal {

// A collision (i < j) or maneuver (i = j), and the states of the motion that it ended
// (Motion::state_id), with the velocities of then.
struct Turn {
  GenId i, j;
  int state_i, state_j;
  std::array<std::array<DdBall, 2>, 2> v;
  std::int64_t line;
  Event claim;
};

class DuePairs {
 public:
  // Two generators i < j, and a state of each.
  using States = std::array<int, 4>;

  // `turns`: all claims of the present instant, at the end of which the motion is.
  DuePairs(Setting& s, const Front& front, const std::vector<Turn>& turns);

  // Whether the two, of which one turns at the instant, touch and approach then in these states:
  // those just before it or since a turn of it. They do not overlap. Throws Undecided.
  bool is_due(const States& states);

 private:
  Contact<DdBall> narrow(const States& states) const;
  std::optional<bool> by_balls(GenId i, GenId j) const;
  bool exactly(const States& states);

  Setting& s_;
  const Front& front_;
  Moment now_;
  ExactMotion exact_;
  std::map<std::pair<GenId, int>, std::array<DdBall, 2>> ended_;  // velocities in states
  std::set<std::pair<GenId, GenId>> touching_;                    // are proved to
};

}  // namespace voroproof::internal
