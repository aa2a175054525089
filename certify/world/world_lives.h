// The next instants of edges, of pairs of neighbours, and of hidden disks.
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "certify/world/world_geometry.h"

namespace voroproof::internal {

// An edge from an instant on.
struct EdgeFate {
  std::optional<std::string> fault;  // why it is not there just after the instant
  // The first time afterwards, before the course of one of its generators ends or at that, at which
  // the tangency of its pair vanishes, or after which it cannot be there: an in-circle function is
  // negative, or a circle does not exist.
  std::optional<LazyTime> due;
  // Its in-circle functions, positive before, both vanish and fall then, its four generators are
  // apart, and its two circles are one: it has no length, and flips.
  bool collapses = false;
};
EdgeFate edge_fate(const WorldCourses& motion, const Quad& q, const LazyTime& now);

// A hidden disk g in h: the first time after which it is not, before a course ends or at that.
std::optional<WorldTime> first_exit(const WorldCourses& motion, GenId g, GenId h,
                                    const LazyTime& now);
// The first time at which the tangency, positive just after the instant, vanishes.
std::optional<LazyTime> first_contact(const WorldCourses& motion, GenId g, GenId h,
                                      const LazyTime& now);

// Times at which something has to be looked at, the next first.
class WorldAgenda {
 public:
  enum class Kind { edge, hidden, last_disk };
  struct Item {
    LazyTime t;
    Kind kind;
    int id;  // number of an edge, or a disk
    bool collapses = false;
  };

  // All that was noted of it is void.
  void forget(Kind kind, int id);
  void note(Item item);
  // Null where nothing is left.
  const Item* next() const;
  // The next one is done.
  void drop();

 private:
  struct Key {
    Kind kind;
    int id;
    auto operator<=>(const Key&) const = default;
  };

  std::map<Key, Item> items_;
  std::set<std::pair<double, Key>> queue_;  // by lower bounds
};

}  // namespace voroproof::internal
