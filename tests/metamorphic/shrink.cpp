#include "tests/metamorphic/shrink.h"

#include <algorithm>

namespace voroproof::internal::metamorphic {
namespace {

class Shrinking {
 public:
  Shrinking(Relation relation, const World& world) : relation_(relation), world_(world) {}

  World run() {
    World simpler = world_;
    simpler.claim.reset();
    take(simpler);
    simpler = world_;
    simpler.mutation.reset();
    take(simpler);
    while (!world_.claim && (take_fewer_disks() || take_fewer_maneuvers())) {
    }
    while (take_earlier_horizon()) {
    }
    return world_;
  }

 private:
  bool take(const World& smaller) {
    if (tries_++ > most_tries || smaller.scene.disks.empty() || !compare(relation_, smaller).found)
      return false;
    world_ = smaller;
    return true;
  }

  bool take_fewer_disks() {
    for (std::size_t k = 0; k < world_.scene.disks.size(); ++k) {
      World fewer = world_;
      Scene& s = fewer.scene;
      const int id = static_cast<int>(k);
      s.disks.erase(s.disks.begin() + id);
      s.maneuvers.erase(std::remove_if(s.maneuvers.begin(), s.maneuvers.end(),
                                       [&](const Maneuver& m) { return m.disk == id; }),
                        s.maneuvers.end());
      for (Maneuver& m : s.maneuvers) m.disk -= m.disk > id;
      if (take(fewer)) return true;
    }
    return false;
  }

  bool take_fewer_maneuvers() {
    for (std::size_t k = 0; k < world_.scene.maneuvers.size(); ++k) {
      World fewer = world_;
      auto& maneuvers = fewer.scene.maneuvers;
      maneuvers.erase(maneuvers.begin() + static_cast<std::ptrdiff_t>(k));
      if (take(fewer)) return true;
    }
    return false;
  }

  bool take_earlier_horizon() {
    World earlier = world_;
    earlier.scene.horizon /= 2;
    if (earlier.scene.horizon < 2 * earlier.tolerance) return false;
    if (earlier.claim) {
      auto& claim = *earlier.claim;
      claim.header.horizon = earlier.scene.horizon;
      while (!claim.events.empty() && exact_time(claim.events.back()) > earlier.scene.horizon) {
        claim.events.pop_back();
      }
      claim.count();
    }
    return take(earlier);
  }

  static constexpr int most_tries = 40;
  int tries_ = 0;
  Relation relation_;
  World world_;
};

}  // namespace

World shrunk(Relation relation, const World& world) { return Shrinking(relation, world).run(); }

}  // namespace voroproof::internal::metamorphic
