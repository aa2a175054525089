// Voids, tunnels and critical radii against points sampled everywhere.
#include "library/queries/free_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

#include "apps/draw/render_probe.h"
#include "library/snapshot.h"
#include "tests/oracle/brute_force.h"
#include "tests/queries/brute_moment.h"
#include "tests/queries/free_space_cases.h"

namespace voroproof::internal::testing {
namespace {

// A grid of points and which of them are connected, by paths of at least a clearance.
class Grid {
 public:
  Grid(const BruteMoment& m, int cells) : cells_(cells) {
    const double r = m.container.radius.convert_to<double>();
    step = 2 * r / cells;
    x0_ = m.container.x.convert_to<double>() - r;
    y0_ = m.container.y.convert_to<double>() - r;
    for (int j = 0; j <= cells; ++j) {
      for (int i = 0; i <= cells; ++i) clearance_.push_back(m.clearance(x(i), y(j)));
    }
  }
  // A component for each point, -1 for those with less clearance.
  std::vector<int> components(double least) const {
    std::vector<int> component(clearance_.size(), -1);
    int count = 0;
    for (std::size_t start = 0; start < component.size(); ++start) {
      if (component[start] >= 0 || clearance_[start] < least) continue;
      std::vector<std::size_t> pending{start};
      component[start] = count;
      while (!pending.empty()) {
        const int at = static_cast<int>(pending.back()), i = at % (cells_ + 1),
                  j = at / (cells_ + 1);
        pending.pop_back();
        for (int dj = -1; dj <= 1; ++dj) {
          for (int di = -1; di <= 1; ++di) {
            if (i + di < 0 || i + di > cells_ || j + dj < 0 || j + dj > cells_) continue;
            const std::size_t to = static_cast<std::size_t>((j + dj) * (cells_ + 1) + i + di);
            if (component[to] >= 0 || clearance_[to] < least) continue;
            component[to] = count;
            pending.push_back(to);
          }
        }
      }
      ++count;
    }
    return component;
  }
  std::size_t nearest(double px, double py) const {
    const int i = static_cast<int>(std::lround((px - x0_) / step));
    const int j = static_cast<int>(std::lround((py - y0_) / step));
    return static_cast<std::size_t>(j * (cells_ + 1) + i);
  }
  double step = 0;

 private:
  double x(int i) const { return x0_ + i * step; }
  double y(int j) const { return y0_ + j * step; }
  int cells_;
  double x0_ = 0, y0_ = 0;
  std::vector<double> clearance_;
};

std::map<Triple, oracle::Circle> vertex_circles(const BruteMoment& m) {
  std::map<Triple, oracle::Circle> circles;
  for (const auto& c : oracle::brute_force_diagram(m.disks, m.container).classes) {
    EXPECT_EQ(c.contacts.size(), 3u);
    circles[{c.contacts[0], c.contacts[1], c.contacts[2]}] = c.circle;
  }
  return circles;
}

// Clearance has slope 1 at most: what is connected in free space is connected in a grid of a little
// less clearance, and what is connected in a grid of a little more is in free space.
TEST(Voids, AreTheComponentsOfAFineGrid) {
  int same = 0, apart = 0;
  for (Case& c : cases()) {
    BruteMoment& m = c.moment;
    if (m.size() < 2) continue;
    const auto circles = vertex_circles(m);
    const Grid grid(m, 300);
    const double half_diagonal = 0.7072 * grid.step;
    for (const Rational& probe : c.probes) {
      Clearance clearance = m.clearance_for(probe);
      FreeSpace space(clearance);
      std::map<Triple, int> void_of;
      int number = 0;
      for (const Void& v : space.voids()) {
        Real widest = 0;
        for (const Triple& vertex : v.vertices) {
          void_of[vertex] = number;
          widest = std::max(widest, circles.at(vertex).radius);
        }
        ASSERT_TRUE(v.widest);
        if (v.widest->kind == ClearanceNode::Kind::vertex) {
          EXPECT_TRUE(contains(clearance.value(*v.widest), widest));
        }
        ++number;
      }
      const double rho = probe.get_d();
      const auto outer = grid.components(rho - half_diagonal);
      const auto inner = grid.components(rho + half_diagonal);
      for (const auto& [a, ca] : circles) {
        EXPECT_EQ(void_of.contains(a), ca.radius >= oracle::rounded<Real>(probe));
        if (!void_of.contains(a)) continue;
        const std::size_t at_a = grid.nearest(ca.x.convert_to<double>(), ca.y.convert_to<double>());
        for (const auto& [b, cb] : circles) {
          if (!void_of.contains(b) || b <= a) continue;
          const std::size_t at_b =
              grid.nearest(cb.x.convert_to<double>(), cb.y.convert_to<double>());
          if (void_of[a] == void_of[b]) {
            EXPECT_EQ(outer[at_a], outer[at_b]);
            ++same;
          } else if (ca.radius > rho + 2 * half_diagonal && cb.radius > rho + 2 * half_diagonal) {
            EXPECT_NE(inner[at_a], inner[at_b]);
            ++apart;
          }
        }
      }
    }
  }
  EXPECT_GT(same, 500);
  EXPECT_GT(apart, 20);
}

// A gate is the narrowest place of its edge iff it is on it: iff nobody else is nearer.
TEST(Tunnels, CloseAtTheGatesThatNobodyIsNearer) {
  for (Case& c : cases()) {
    BruteMoment& m = c.moment;
    if (m.size() < 2) continue;
    Clearance clearance = m.clearance_for(0);
    const auto circles = vertex_circles(m);
    std::set<Triple> found, expected;
    for (Diagram::HalfEdge h = 0; h < 2 * m.moment.diagram.edges(); h += 2) {
      const ClearanceNode node = narrowest(clearance, h);
      const Quad q = m.moment.diagram.quad(h);
      if (node.kind == ClearanceNode::Kind::gate) {
        found.insert(node.generators);
        EXPECT_TRUE(contains(clearance.value(node), m.gap(q.l, q.r) / 2));
      } else {
        const Real least =
            std::min(circles.at(start_vertex(q)).radius, circles.at(end_vertex(q)).radius);
        EXPECT_TRUE(contains(clearance.value(node), least));
      }
      EXPECT_TRUE(is_narrow(clearance.value(node), 300));
    }
    for (GenId i = 0; i < m.size(); ++i) {
      for (GenId j = container_id; j < i; ++j) {
        const oracle::Circle &a = m.circle(i), &b = m.circle(j);
        Real ux = b.x - a.x, uy = b.y - a.y;
        if (j == container_id) ux = -ux, uy = -uy;
        const Real d = sqrt(ux * ux + uy * uy), half = m.gap(i, j) / 2;
        const Real x = a.x + ux / d * (a.radius + half), y = a.y + uy / d * (a.radius + half);
        bool nearest = true;
        for (GenId g = container_id; g < m.size(); ++g) {
          if (g != i && g != j) nearest &= m.distance(g, x, y) > half;
        }
        if (nearest) expected.insert(gate_node(i, j).generators);
      }
    }
    EXPECT_EQ(found, expected) << text(m.scene);
  }
}

// The clearance at a vertex is greatest around it iff its contacts do not lie on one half of it.
TEST(Voids, VanishWhereContactsAreAllAround) {
  int places = 0;
  for (Case& c : cases()) {
    BruteMoment& m = c.moment;
    if (m.size() < 2) continue;
    Clearance clearance = m.clearance_for(0);
    std::set<Triple> found, expected;
    for (const ClearanceNode& node : widest_places(clearance)) {
      if (node.kind == ClearanceNode::Kind::vertex) found.insert(node.generators);
    }
    for (const auto& [vertex, circle] : vertex_circles(m)) {
      Real dx[3], dy[3];
      for (int k = 0; k < 3; ++k) {
        const oracle::Circle& g = m.circle(vertex[k]);
        const int sign = vertex[k] == container_id ? -1 : 1;
        const Real x = sign * (g.x - circle.x), y = sign * (g.y - circle.y);
        const Real d = sqrt(x * x + y * y);
        dx[k] = x / d;
        dy[k] = y / d;
      }
      bool around = true;
      for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        around &= dx[k] * dy[next] - dy[k] * dx[next] > 0;
      }
      if (around) expected.insert(vertex);
    }
    EXPECT_EQ(found, expected) << text(m.scene);
    places += static_cast<int>(found.size());
  }
  EXPECT_GT(places, 20);
}

// The picture's own way, in doubles.
TEST(FreeSpace, IsWhatThePictureShows) {
  std::size_t several = 0;
  for (Case& c : cases()) {
    BruteMoment& m = c.moment;
    if (m.size() == 0) continue;
    const DiagramFile diagram = snapshot(m.scene, 0);
    for (const Rational& probe : c.probes) {
      Clearance clearance = m.clearance_for(probe);
      const FreeSpacePicture picture(diagram, probe.get_d());
      const auto voids = FreeSpace(clearance).voids();
      EXPECT_EQ(picture.voids(), voids.size()) << text(m.scene) << "probe " << probe;
      several += voids.size() > 1;
      std::set<Quad> tunnels, drawn;
      for (const Void& v : voids) tunnels.insert(v.tunnels.begin(), v.tunnels.end());
      for (std::size_t k = 0; k < diagram.edges.size(); ++k) {
        if (picture.is_tunnel(k)) drawn.insert(diagram.edges[k]);
      }
      EXPECT_EQ(drawn, tunnels);
    }
  }
  EXPECT_GT(several, 5u);
}

TEST(FreeSpace, OfALoneDisk) {
  // Ellipse: gate at clearance 5/2, far point at 11/2.
  BruteMoment m(scene_of(10, 1, {disk(3, 0, 2, 0, 0)}));
  const auto voids_and_arcs = [&](const Rational& probe) {
    Clearance clearance = m.clearance_for(probe);
    FreeSpace space(clearance);
    std::size_t full = 0;
    for (const OffsetArc& arc : space.offset()) full += !arc.from;
    return std::array<std::size_t, 3>{space.voids().size(), space.offset().size(), full};
  };
  EXPECT_EQ(voids_and_arcs(1), (std::array<std::size_t, 3>{1, 2, 2}));
  EXPECT_EQ(voids_and_arcs(Rational(5, 2)), (std::array<std::size_t, 3>{1, 2, 2}));  // just fits
  EXPECT_EQ(voids_and_arcs(3), (std::array<std::size_t, 3>{1, 2, 0}));
  EXPECT_EQ(voids_and_arcs(Rational(11, 2)), (std::array<std::size_t, 3>{1, 2, 0}));  // a point
  EXPECT_EQ(voids_and_arcs(6), (std::array<std::size_t, 3>{0, 0, 0}));
  Clearance clearance = m.clearance_for(0);
  EXPECT_EQ(widest_places(clearance), (std::vector<ClearanceNode>{far_node(0)}));
  EXPECT_TRUE(contains(clearance.value(far_node(0)), Real(11) / 2));
}

TEST(FreeSpace, OfNothingAndAroundTheCentre) {
  BruteMoment none(scene_of(10, 1, {}));
  for (const int probe : {0, 10, 11}) {
    Clearance clearance = none.clearance_for(probe);
    FreeSpace space(clearance);
    EXPECT_EQ(space.voids().size(), probe <= 10 ? 1u : 0u);
    EXPECT_EQ(space.offset().size(), probe <= 10 ? 1u : 0u);
  }
  BruteMoment centre(scene_of(10, 1, {disk(0, 0, 2, 0, 0)}));
  for (const int probe : {1, 4, 5}) {
    Clearance clearance = centre.clearance_for(probe);
    FreeSpace space(clearance);
    EXPECT_EQ(space.voids().size(), probe <= 4 ? 1u : 0u);
    EXPECT_EQ(space.offset().size(), probe <= 4 ? 2u : 0u);
  }
}

// Touching disks, a lattice, cotangent generators: equality is seen.
TEST(FreeSpace, OfALatticeWhoseGatesAreAllAlike) {
  std::vector<DiskInput> disks;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) disks.push_back(disk(4 * x - 4, 4 * y - 4, 1, 0, 0));
  }
  BruteMoment m(scene_of(20, 1, disks));
  const auto count = [&](const Rational& probe) {
    Clearance clearance = m.clearance_for(probe);
    return FreeSpace(clearance).voids().size();
  };
  // Gates at 1; the middles of the four squares at sqrt(8) - 1 = 1.83.
  EXPECT_EQ(count(1), 1u);
  EXPECT_EQ(count(Rational(1000001, 1000000)), 5u);
  EXPECT_EQ(count(Rational(182, 100)), 5u);
  EXPECT_EQ(count(Rational(183, 100)), 1u);
  Clearance clearance = m.clearance_for(0);
  std::size_t inner = 0;
  for (const ClearanceNode& node : widest_places(clearance))
    inner += node.generators[0] >= 0 && node.kind == ClearanceNode::Kind::vertex;
  EXPECT_EQ(inner, 4u);  // one for the two vertices of each square
}

}  // namespace
}  // namespace voroproof::internal::testing
