// Proofs that cells of a diagram are right at a rational time.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "certify/world/world_geometry.h"
#include "certify/world/world_map.h"
#include "exact/ball.h"

namespace voroproof::internal {

class WorldCells {
 public:
  WorldCells(const WorldCourses& motion, const WorldMap& map, Rational t)
      : motion_(motion), map_(map), t_(std::move(t)) {}

  // Whether the tangencies of g with its neighbours and of these with each other are right, the
  // circles of all vertices of its cell exist, and it winds once: nothing, or what is wrong.
  // Precondition: no in-circle function of an edge of the cell is negative. Throws WorldUndecided.
  std::optional<std::string> fault(GenId g);

 private:
  using Half = WorldMap::Half;
  using Direction = std::array<Ball, 2>;

  const Site<Rational>& site(GenId g);
  GeneratorRow<Rational> row(GenId base, GenId g);
  // The triple of the vertex on the left of h, seen from a disk of it.
  TangentTriple<Rational> triple(Half h);
  bool is_point(Half h);
  Direction direction(GenId g, const TangentTriple<Rational>& vertex, Ball::Precision bits);
  // How often the way around passes a fixed direction, the `turn`-th of some; nothing where it
  // takes more bits.
  std::optional<int> passes(GenId g, const std::vector<TangentTriple<Rational>>& vertices,
                            const std::vector<bool>& is_point, Ball::Precision bits, int turn);

  const WorldCourses& motion_;
  const WorldMap& map_;
  const Rational t_;
  std::map<GenId, Site<Rational>> sites_;
};

}  // namespace voroproof::internal
