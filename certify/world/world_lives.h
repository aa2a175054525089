// The next instants of edges, of pairs of neighbours, and of hidden disks.
#pragma once

#include <cstdint>
#include <optional>
#include <queue>
#include <string>
#include <vector>

#include "certify/world/world_geometry.h"

namespace voroproof::internal {

// An edge from an instant on.
struct EdgeFate {
  std::optional<std::string> fault;  // why it is not there just after the instant
  // The first time afterwards, before the course of one of its generators ends or at that, at which
  // the tangency of its pair vanishes, or after which it cannot be there: an in-circle function is
  // negative, or a circle does not exist.
  std::optional<WorldTime> due;
};
EdgeFate edge_fate(const WorldCourses& motion, const Quad& q, const WorldTime& now);

// A hidden disk g in h: the first time after which it is not, before a course ends or at that.
std::optional<WorldTime> first_exit(const WorldCourses& motion, GenId g, GenId h,
                                    const WorldTime& now);
// The first time at which their tangency vanishes.
std::optional<WorldTime> first_contact(const WorldCourses& motion, GenId g, GenId h,
                                       const WorldTime& now);

// Times at which something has to be looked at, the next first.
class WorldAgenda {
 public:
  enum class Kind { edge, hidden, last_disk };
  struct Item {
    WorldTime t;
    Kind kind;
    int id;  // number of an edge, or a disk
    std::int64_t stamp;
  };

  // All that was noted of it is void.
  void forget(Kind kind, int id) { ++stamp(kind, id); }
  void note(Kind kind, int id, WorldTime t) {
    items_.push({std::move(t), kind, id, stamp(kind, id)});
  }
  // Null where nothing is left.
  const Item* next();
  void drop() { items_.pop(); }

 private:
  struct Later {
    bool operator()(const Item& a, const Item& b) const { return order_of(a.t, b.t) > 0; }
  };
  std::int64_t& stamp(Kind kind, int id);

  std::priority_queue<Item, std::vector<Item>, Later> items_;
  std::vector<std::int64_t> stamps_[3];
};

}  // namespace voroproof::internal
