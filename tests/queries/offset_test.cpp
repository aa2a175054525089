// The offset against points sampled on every circle, and its end points against polished ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "library/queries/free_space.h"
#include "tests/oracle/circle.h"
#include "tests/queries/brute_moment.h"
#include "tests/queries/free_space_cases.h"

namespace voroproof::internal::testing {
namespace {

constexpr double pi = std::numbers::pi;

double angle(const BruteMoment& m, GenId g, const std::array<Enclosure, 2>& p) {
  return std::atan2(middle(p[1]) - m.circle(g).y.convert_to<double>(),
                    middle(p[0]) - m.circle(g).x.convert_to<double>());
}

double turn(double angle) { return angle < 0 ? angle + 2 * pi : angle; }

// Every point of every generator's circle at the probe's distance: on an arc iff it is free.
TEST(Offset, CoversTheFreePointsOfAllCircles) {
  int arcs_seen = 0, full = 0;
  for (Case& c : cases()) {
    BruteMoment& m = c.moment;
    for (const Rational& probe : c.probes) {
      Clearance clearance = m.clearance_for(probe);
      const FreeSpace space(clearance);
      std::map<GenId, std::vector<std::pair<double, double>>> arcs;  // from, extent
      for (const OffsetArc& arc : space.offset()) {
        ++arcs_seen;
        EXPECT_EQ(arc.from.has_value(), arc.to.has_value());
        if (!arc.from) {
          ++full;
          arcs[arc.generator].emplace_back(0, 7);
          continue;
        }
        const double from = angle(m, arc.generator, space.position(*arc.from));
        const double to = angle(m, arc.generator, space.position(*arc.to));
        arcs[arc.generator].emplace_back(from, turn(to - from));
      }
      const double rho = probe.get_d();
      for (GenId g = container_id; g < m.size(); ++g) {
        const double r = m.circle(g).radius.convert_to<double>() + (g < 0 ? -rho : rho);
        if (r <= 0) continue;
        for (int k = 0; k < 500; ++k) {
          const double a = 2 * pi * (k + 0.37) / 500 - pi;
          const double x = m.circle(g).x.convert_to<double>() + r * std::cos(a);
          const double y = m.circle(g).y.convert_to<double>() + r * std::sin(a);
          double others = 1e9;
          for (GenId h = container_id; h < m.size(); ++h) {
            if (h != g) others = std::min(others, m.distance_in_doubles(h, x, y));
          }
          if (std::fabs(others - rho) < 1e-6) continue;
          bool covered = false;
          for (const auto& [from, extent] : arcs[g]) covered |= turn(a - from) <= extent;
          EXPECT_EQ(covered, others > rho)
              << text(m.scene) << "probe " << probe << " generator " << g << " angle " << a;
        }
      }
    }
  }
  EXPECT_GT(arcs_seen, 200);
  EXPECT_GT(full, 10);
}

// The point at distance rho from both generators, next to (x, y), by Newton's iteration; nothing
// where it is double.
std::optional<std::array<Real, 2>> polished(const BruteMoment& m, GenId i, GenId j, const Real& rho,
                                            Real x, Real y) {
  for (int k = 0; k < 8; ++k) {
    Real residue[2], jacobian[2][2];
    for (const int row : {0, 1}) {
      const GenId g = row == 0 ? i : j;
      const Real dx = x - m.circle(g).x, dy = y - m.circle(g).y, d = sqrt(dx * dx + dy * dy);
      const int sign = g == container_id ? -1 : 1;
      residue[row] = m.distance(g, x, y) - rho;
      jacobian[row][0] = sign * dx / d;
      jacobian[row][1] = sign * dy / d;
    }
    const Real det = jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0];
    if (abs(det) < 1e-9) return std::nullopt;
    x -= (residue[0] * jacobian[1][1] - residue[1] * jacobian[0][1]) / det;
    y -= (residue[1] * jacobian[0][0] - residue[0] * jacobian[1][0]) / det;
  }
  return std::array<Real, 2>{x, y};
}

TEST(Offset, EnclosuresContainTheEndPoints) {
  int points = 0;
  for (Case& c : cases()) {
    BruteMoment& m = c.moment;
    for (const Rational& probe : c.probes) {
      Clearance clearance = m.clearance_for(probe);
      const FreeSpace space(clearance);
      for (const FreePiece& piece : space.pieces()) {
        for (const auto& point : {piece.from, piece.to}) {
          if (!point) continue;
          const auto at = space.position(*point);
          const auto truth = polished(m, point->i, point->j, oracle::rounded<Real>(probe),
                                      middle(at[0]), middle(at[1]));
          if (!truth) continue;
          ++points;
          for (const int axis : {0, 1}) {
            EXPECT_TRUE(contains(at[axis], (*truth)[axis]));
            EXPECT_TRUE(is_narrow(at[axis], 300));
          }
        }
      }
    }
  }
  EXPECT_GT(points, 200);
}

}  // namespace
}  // namespace voroproof::internal::testing
