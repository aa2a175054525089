#include "library/planning/wall_clearance.h"

#include <utility>

#include "exact/patience.h"
#include "library/planning/given_clearance.h"

namespace voroproof::internal {

WallClearance::WallClearance(const GivenPaths& given, std::function<bool()> go_on)
    : given_(given), go_on_(std::move(go_on)) {}

// Calls visit(piece) for all legs of all disks and all walls.
template <class Visit>
void WallClearance::each_piece(Visit&& visit) const {
  for (std::size_t g = 0; g < given_.paths.size(); ++g) {
    if (!go_on_()) throw Interrupted();
    const GivenPath& path = given_.paths[g];
    const std::vector<Waypoint>& w = path.waypoints;
    for (std::size_t k = 0; k + 1 < w.size() || k == 0; ++k) {
      const bool is_instant = w.size() == 1;
      const Rational &from = w[k].t, &to = w[is_instant ? k : k + 1].t;
      Curve course = is_instant ? Curve{w[k].at} : course_of(path, k, from, to);
      const Polynomial<Rational> radius = radius_of(path, from, to);
      CommonTime time{container_id, static_cast<int>(g), {}, from, to, {}};
      for (const BilliardWall& wall : given_.walls) {
        std::vector<Rational> gap;
        for (const Vec3& c : course) gap.push_back(dot(wall.normal, c));
        const Polynomial<Rational> offset{wall.offset + wall.speed * from,
                                          wall.speed * (to - from)};
        time.reach = Polynomial<Rational>(std::move(gap)) - offset - radius;
        visit(CommonPiece(time, {}, std::nullopt));
        --time.i;
      }
      if (!given_.container) continue;
      time.reach = Polynomial<Rational>{given_.container->radius} - radius;
      course[0] = course[0] - given_.container->center;
      visit(CommonPiece(std::move(time), course, std::nullopt));
    }
  }
}

std::optional<Approach> WallClearance::least() const {
  std::optional<Approach> least;
  each_piece([&](const CommonPiece& piece) {
    Approach here = *piece.nearest(given_.contacts);
    least = least ? nearer_of(*least, here) : std::move(here);
  });
  return least;
}

std::vector<NearSpell> WallClearance::spells_below(const Rational& distance) const {
  SpellsBelow spells(distance, given_.contacts);
  const std::vector<int> disks = disks_of(given_.paths);
  each_piece([&](const CommonPiece& piece) {
    spells.add(piece, piece.time().i, disks[static_cast<std::size_t>(piece.time().j)]);
  });
  return spells.spells();
}

}  // namespace voroproof::internal
