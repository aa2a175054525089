// The order of the turns of one instant under the exact truth (docs/formats.md, section 6): the
// smallest pair that touches and approaches collides, again and again; then the maneuvers; then
// once more collisions.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "certify/kernel/motion.h"

namespace voroproof_kernel {

using Two = std::pair<int, int>;  // the smaller generator first

// The sign of the gap of two generators where they overlap. Two that touch approach each other
// where the slope of their gap has the same sign.
inline int inwards(Two two) { return two.first == container ? 1 : -1; }

// The turns that are claimed of one instant. They are right where the format's order, followed from
// the legs before the instant, makes the same happen to each disk, one after the other. (Claims
// that share no disk may be told in another order.)
class Turns {
 public:
  // The claim, a collision or a maneuver, is about to turn its disks. `of`: all pairs of these.
  void begin(const Claim& c, const std::set<Two>& of, const Walk& before);
  // It has turned them.
  void end(const Claim& c, const Walk& after);

  struct Fault {
    std::int64_t line;
    std::string why;
  };
  // The first turn that is wrong in the order of the instant t, and why; nothing where all are
  // right.
  std::optional<Fault> fault(const Rat& t) const;

 private:
  struct Turn {
    Two two;  // twice the disk of a maneuver
    std::int64_t line;
    bool is_maneuver() const { return two.first == two.second; }
  };
  struct Chain {
    std::vector<std::size_t> turns;  // numbers of a disk's turns
    std::vector<const Leg*> legs;    // before the first of them, and after each
  };
  class Replay;

  std::vector<Turn> turns_;
  std::map<int, Chain> chains_;            // by disk that turns
  std::map<int, const Leg*> standing_;     // by generator beside them: its leg at the instant
  std::map<int, std::set<Two>> touching_;  // by disk: its pairs
};

}  // namespace voroproof_kernel
