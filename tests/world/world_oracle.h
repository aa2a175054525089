// Judges the history of a world by the diagrams of its disks at rest.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "exact/generators.h"
#include "exact/rational.h"
#include "history/world.h"
#include "history/world_history.h"

namespace voroproof::internal::testing {

// ---- The world at one time. ----

// Whether the disk is there at t, and its state then: that just after the maneuvers at t. Paths go
// on after the horizon.
bool is_present(const World& world, GenId g, const Rational& t);
GrowingDisk state_at(const World& world, GenId g, const Rational& t);

struct BruteDiagram {
  std::vector<Quad> edges;      // by canonical names, sorted
  std::set<GenId> visible;      // the disks that have a cell
  std::map<GenId, GenId> host;  // by hidden disk: a visible disk that hides it, or the container
};
// The diagram of the disks as they are at t. Where there are ties at t only, it need not be that
// just after t. Throws Undecided.
BruteDiagram brute_diagram(const World& world, const Rational& t);
inline std::vector<Quad> brute_edges(const World& world, const Rational& t) {
  return brute_diagram(world, t).edges;
}

// A time between the two at which nothing is a tie but what is one for ever: the share of the way
// is about numerator / 2^61, but its denominator is a large prime that is in no world.
Rational odd_time_between(const Rational& from, const Rational& to, std::uint64_t numerator);
inline constexpr std::uint64_t way = (std::uint64_t{1} << 61) - 1;  // the prime

// ---- Its history. ----

// The times, as exact numbers, that round to that of an event; the exact time if it is no double.
struct TimeRange {
  Rational low, high;
};
TimeRange rounding_range(const Rational& t);

struct JudgeOptions {
  std::optional<Rational> until;  // the history is said to be right before it only, not to the end
  int random_times = 8;
  unsigned seed = 1;
};

// Why the history is wrong: at some time, its edges or its visible disks are not the brute ones; or
// an event is impossible, changes nothing, or is not that of the world. None if it is right as far
// as the judge can see. Events whose ranges of times meet are looked at together: what is before
// and after them counts. Throws Undecided.
std::optional<std::string> first_disagreement(const World& world, const std::vector<Quad>& initial,
                                              const std::vector<WorldEvent>& events,
                                              const JudgeOptions& options = {});

}  // namespace voroproof::internal::testing
