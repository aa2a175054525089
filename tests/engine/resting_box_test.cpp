// The diagram of any disks at rest between four walls against brute force in 100 digits, which
// finds all circles that touch three generators and knows nothing of rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "engine/resting_diagram.h"
#include "exact/topology/diagram.h"
#include "filtered/search/hidden_disks.h"
#include "tests/support/resting_disks.h"

namespace voroproof::internal::testing {
namespace {

using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100>,
                                           boost::multiprecision::et_off>;
const Real nothing("1e-40");

Real real(const Rational& q) { return Real(q.get_num().get_str()) / Real(q.get_den().get_str()); }

std::string text(const Disks& disks, const Walls& w) {
  return "\nwalls " + w.x0.get_str() + " " + w.y0.get_str() + " " + w.x1.get_str() + " " +
         w.y1.get_str() + text(disks);
}

// A plane a x + b y + c rho = d.
struct Plane {
  Real a, b, c, d;
};
struct Circle {
  Real x, y, rho;
};

class BruteForce {
 public:
  BruteForce(const Disks& disks, const Walls& w, std::vector<bool> hidden)
      : n_(static_cast<int>(disks.size())), hidden_(std::move(hidden)) {
    for (const Disk& d : disks) disks_.push_back({real(d.x), real(d.y), real(d.r)});
    // n.x - rho = h.
    walls_ = {{1, 0, -1, real(w.x0)},
              {0, 1, -1, real(w.y0)},
              {-1, 0, -1, -real(w.x1)},
              {0, -1, -1, -real(w.y1)}};
  }

  // The names of all vertices: polygons of contacts in triangles at their largest generators.
  std::set<Triple> vertices() const {
    std::set<Triple> all;
    for (int k = 0; k < 4; ++k) all.insert(canonical(Triple{n_ + (k + 1) % 4, n_ + k, -1}));
    for (int i = 0; i < n_ + 4; ++i) {
      for (int j = i + 1; j < n_ + 4; ++j) {
        for (int k = j + 1; k < n_ + 4; ++k) {
          if (is_hidden(i) || is_hidden(j) || is_hidden(k)) continue;
          for (const Circle& c : circles(i, j, k)) add(c, {i, j, k}, all);
        }
      }
    }
    return all;
  }

 private:
  bool is_hidden(int g) const { return g < n_ && hidden_[static_cast<std::size_t>(g)]; }
  Real gap(int g, const Circle& c) const {
    if (g >= n_) {
      const Plane& w = walls_[static_cast<std::size_t>(g - n_)];
      return w.a * c.x + w.b * c.y - w.d - c.rho;
    }
    const Circle& d = disks_[static_cast<std::size_t>(g)];
    return sqrt((c.x - d.x) * (c.x - d.x) + (c.y - d.y) * (c.y - d.y)) - d.rho - c.rho;
  }

  // The difference of |z - c|^2 = (rho + r)^2 of two disks, or that of a wall.
  Plane plane(int g, int base) const {
    if (g >= n_) return walls_[static_cast<std::size_t>(g - n_)];
    const Circle &a = disks_[static_cast<std::size_t>(base)],
                 &b = disks_[static_cast<std::size_t>(g)];
    const auto square = [](const Circle& c) { return Real(c.x * c.x + c.y * c.y - c.rho * c.rho); };
    return {2 * (b.x - a.x), 2 * (b.y - a.y), 2 * (b.rho - a.rho), square(b) - square(a)};
  }

  static std::array<Real, 3> cross(const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  std::vector<Circle> circles(int i, int j, int k) const {
    const Plane p = plane(j, i), q = plane(k, i);
    const std::array<Real, 3> u{p.a, p.b, p.c}, v{q.a, q.b, q.c}, d = cross(u, v);
    const Real d2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    if (d2 < nothing) return {};
    const std::array<Real, 3> e = cross(v, d), f = cross(d, u);
    std::array<Real, 3> at;
    for (int m = 0; m < 3; ++m) at[m] = (p.d * e[m] + q.d * f[m]) / d2;
    if (i >= n_) {  // three walls
      const Plane r = walls_[static_cast<std::size_t>(i - n_)];
      const Real slope = r.a * d[0] + r.b * d[1] + r.c * d[2];
      if (abs(slope) < nothing) return {};
      const Real s = (r.d - (r.a * at[0] + r.b * at[1] + r.c * at[2])) / slope;
      return {{at[0] + s * d[0], at[1] + s * d[1], at[2] + s * d[2]}};
    }
    const Circle& b = disks_[static_cast<std::size_t>(i)];
    const Real x = at[0] - b.x, y = at[1] - b.y, r = at[2] + b.rho;
    const Real A = d[0] * d[0] + d[1] * d[1] - d[2] * d[2], B = x * d[0] + y * d[1] - r * d[2],
               C = x * x + y * y - r * r;
    std::vector<Real> roots;
    if (abs(A) < nothing) {
      if (abs(B) > nothing) roots.push_back(-C / (2 * B));
    } else {
      const Real square = B * B - A * C;
      const Real root = square > 0 ? Real(sqrt(square)) : Real(0);
      if (square > -nothing) roots = {(-B + root) / A, (-B - root) / A};
    }
    std::vector<Circle> all;
    for (const Real& s : roots)
      all.push_back({at[0] + s * d[0], at[1] + s * d[1], at[2] + s * d[2]});
    return all;
  }

  void add(const Circle& c, const std::array<int, 3>& own, std::set<Triple>& all) const {
    std::vector<std::pair<Real, int>> contacts;
    for (const int g : own) {
      if (abs(gap(g, c)) > nothing) return;  // the other kind of circle
    }
    for (int g = 0; g < n_ + 4; ++g) {
      if (is_hidden(g)) continue;
      const Real off = gap(g, c);
      if (off < -nothing) return;
      if (off > nothing) continue;
      if (g >= n_) {
        const Plane& w = walls_[static_cast<std::size_t>(g - n_)];
        contacts.emplace_back(atan2(-w.b, -w.a), g);
      } else {
        const Circle& d = disks_[static_cast<std::size_t>(g)];
        contacts.emplace_back(atan2(d.y - c.y, d.x - c.x), g);
      }
      // atan2(0, -1) may have either sign.
      if (contacts.back().first < -Real("3.14159265358979")) {
        contacts.back().first = -contacts.back().first;
      }
    }
    std::sort(contacts.begin(), contacts.end());
    const auto by_id = [](const auto& a, const auto& b) { return a.second < b.second; };
    std::rotate(contacts.begin(), std::max_element(contacts.begin(), contacts.end(), by_id),
                contacts.end());
    for (std::size_t k = 2; k < contacts.size(); ++k) {
      all.insert(canonical(Triple{contacts[0].second, contacts[k - 1].second, contacts[k].second}));
    }
  }

  int n_;
  std::vector<bool> hidden_;
  std::vector<Circle> disks_;
  std::vector<Plane> walls_;
};

// The disks that a definition hides.
std::vector<bool> hidden(const Disks& disks, const Walls& w) {
  std::vector<bool> all;
  for (std::size_t g = 0; g < disks.size(); ++g) {
    const Disk& d = disks[g];
    const bool is_behind =
        d.x + d.r <= w.x0 || d.y + d.r <= w.y0 || d.x - d.r >= w.x1 || d.y - d.r >= w.y1;
    all.push_back(is_behind || another_contains(disks, g));
  }
  return all;
}

std::set<Triple> vertices_of(const std::vector<Quad>& edges) {
  std::set<Triple> all;
  for (const Quad& q : edges) all.insert({start_vertex(q), end_vertex(q)});
  return all;
}

void expect_right(const Disks& disks, const Walls& walls) {
  TierCounts counts;
  const RestingDiagram d = resting_diagram(input_between(disks, walls), Frame::box, {}, counts);
  const std::vector<bool> truth = hidden(disks, walls);
  std::vector<bool> all = truth;
  for (std::size_t g = 0; g < disks.size(); ++g) {
    ASSERT_EQ(d.host[g] != visible_disk, truth[g]) << g << text(disks, walls);
    if (truth[g]) {
      ASSERT_EQ(d.host[static_cast<std::size_t>(d.host[g])], visible_disk);
    }
  }
  all.resize(disks.size() + 4, false);
  ASSERT_NO_THROW(diagram_of(static_cast<int>(all.size()), d.edges, all)) << text(disks, walls);
  ASSERT_EQ(vertices_of(d.edges), BruteForce(disks, walls, truth).vertices()) << text(disks, walls);
}

int sets() {
  const char* given = std::getenv("VOROPROOF_SETS");
  return given == nullptr ? 150 : std::atoi(given);
}

TEST(RestingBox, IsThatOfBruteForce) {
  Dice dice(1);
  for (int round = 0; round < sets(); ++round) {
    const Disks disks =
        random_disks(dice, dice(0, 9), dice(0, 1) == 0 ? Rational(3, 2) : Rational(5));
    const Walls walls{-6 - Rational(dice(0, 9), 7), -Rational(dice(10, 60), 10), 7,
                      Rational(dice(1, 60), 9)};
    expect_right(disks, walls);
    if (HasFatalFailure()) return;
  }
}

// Disks that touch walls and each other, corners' diagonals, squares, disks in a line.
TEST(RestingBox, IsThatOfBruteForceWhereManyTouchOneCircle) {
  Dice dice(2);
  for (int round = 0; round < sets(); ++round) {
    const int most = dice(1, 4);
    Disks disks = lattice_disks(dice, dice(0, 9), most);
    if (dice(0, 2) == 0) {
      for (Disk& d : disks) d.y = 1;
    }
    if (dice(0, 2) == 0) {
      for (Disk& d : disks) d.r = Rational(dice(0, 1), 2);
    }
    const Walls walls{-dice(1, 5), -dice(1, 5), dice(1, 5), dice(1, 5)};
    expect_right(disks, walls);
    if (HasFatalFailure()) return;
  }
}

TEST(RestingBox, FewDisks) {
  expect_right({}, {0, 0, 4, 2});
  expect_right({}, {0, 0, 2, 4});
  expect_right({}, {0, 0, 2, 2});
  expect_right({{1, 1, 0}}, {0, 0, 2, 2});
  expect_right({{1, 1, 1}}, {0, 0, 2, 2});
  expect_right({{1, 1, 5}}, {0, 0, 2, 2});
  expect_right({{1, 1, 1}, {3, 1, 1}}, {0, 0, 4, 2});
  // In a corner, and beyond it.
  expect_right({{1, 1, 1}, {3, 3, 1}}, {0, 0, 4, 4});
  expect_right({{-1, -1, Rational(6, 5)}}, {0, 0, 4, 4});
  Disks grid;
  for (int k = 0; k < 9; ++k) grid.push_back({2 * (k % 3) + 1, 2 * (k / 3) + 1, 1});
  expect_right(grid, {0, 0, 6, 6});
}

}  // namespace
}  // namespace voroproof::internal::testing
