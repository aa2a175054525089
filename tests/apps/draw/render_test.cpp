// Pictures, and the curves of edges against the definition of a Voronoi edge, on
// diagrams found by brute force.
#include "apps/draw/render.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>

#include "apps/draw/edge_curves.h"
#include "history/error.h"

namespace voroproof::internal {
namespace {

constexpr double pi = std::numbers::pi;

Vec2 minus(const Vec2& a, const Vec2& b) { return {a[0] - b[0], a[1] - b[1]}; }
double norm(const Vec2& a) { return std::hypot(a[0], a[1]); }

const Vec2& center(const DiagramFile& d, GenId id) {
  return id == container_id ? d.container_center : d.disks[id].center;
}
double signed_radius(const DiagramFile& d, GenId id) {
  return id == container_id ? -d.container_radius : d.disks[id].radius;
}

// Distance of a point to a generator.
double gap(const DiagramFile& d, GenId id, const Vec2& x) {
  const double distance = norm(minus(x, center(d, id)));
  return id == container_id ? d.container_radius - distance : distance - d.disks[id].radius;
}

double nearest_gap(const DiagramFile& d, const Vec2& x) {
  double least = gap(d, container_id, x);
  for (std::size_t i = 0; i < d.disks.size(); ++i)
    least = std::min(least, gap(d, static_cast<GenId>(i), x));
  return least;
}

// The circles that touch i, j, k from outside (the container from inside).
std::vector<DiagramVertex> tangent_circles(const DiagramFile& d, GenId i, GenId j, GenId k) {
  // Differences to i, a disk, give two linear equations 2 dx.x + 2 ds rho = p in
  // the centre x about that of i and its distance rho from it: x = a + b rho.
  const Vec2 dj = minus(center(d, j), center(d, i)), dk = minus(center(d, k), center(d, i));
  const double sj = signed_radius(d, j) - signed_radius(d, i);
  const double sk = signed_radius(d, k) - signed_radius(d, i);
  const double pj = (dj[0] * dj[0] + dj[1] * dj[1] - sj * sj) / 2;
  const double pk = (dk[0] * dk[0] + dk[1] * dk[1] - sk * sk) / 2;
  const double det = dj[0] * dk[1] - dj[1] * dk[0];
  const Vec2 a{(pj * dk[1] - pk * dj[1]) / det, (pk * dj[0] - pj * dk[0]) / det};
  const Vec2 b{(-sj * dk[1] + sk * dj[1]) / det, (-sk * dj[0] + sj * dk[0]) / det};
  const double A = b[0] * b[0] + b[1] * b[1] - 1, B = a[0] * b[0] + a[1] * b[1];
  const double C = a[0] * a[0] + a[1] * a[1];
  std::vector<DiagramVertex> found;
  if (B * B < A * C) return found;
  for (double root : {std::sqrt(B * B - A * C), -std::sqrt(B * B - A * C)}) {
    const double rho = (-B + root) / A;
    const Vec2 x{center(d, i)[0] + a[0] + b[0] * rho, center(d, i)[1] + a[1] + b[1] * rho};
    const double radius = rho - d.disks[i].radius;
    const double tolerance = 1e-9 * d.container_radius;
    if (radius < 0 || std::abs(gap(d, j, x) - radius) > tolerance ||
        std::abs(gap(d, k, x) - radius) > tolerance)
      continue;
    const auto contact = [&](GenId id) {
      const Vec2 v = minus(center(d, id), x);
      return id == container_id ? std::atan2(-v[1], -v[0]) : std::atan2(v[1], v[0]);
    };
    const auto turn = [&](GenId id) {
      return std::fmod(contact(id) - contact(i) + 4 * pi, 2 * pi);
    };
    found.push_back({canonical(turn(j) < turn(k) ? Triple{i, j, k} : Triple{i, k, j}), x, radius});
  }
  return found;
}

// Vertices: all empty tangent circles. Edges: from each start the next vertex of
// the same two generators, counterclockwise around the left (clockwise around the
// right) one.
void complete(DiagramFile& d) {
  const int n = static_cast<int>(d.disks.size());
  for (GenId i = 0; i < n; ++i) {
    for (GenId j = container_id; j < i; ++j) {
      for (GenId k = container_id; k < j; ++k) {
        for (const DiagramVertex& v : tangent_circles(d, i, j, k)) {
          if (nearest_gap(d, v.center) > v.radius - 1e-9 * d.container_radius)
            d.vertices.push_back(v);
        }
      }
    }
  }
  std::set<Quad> edges;
  for (const DiagramVertex& start : d.vertices) {
    for (int turn = 0; turn < 3; ++turn) {
      const GenId l = start.generators[turn], s = start.generators[(turn + 1) % 3];
      const GenId r = start.generators[(turn + 2) % 3];
      const GenId base = l == container_id ? r : l;
      const auto direction = [&](const DiagramVertex& v) {
        const Vec2 from = minus(v.center, center(d, base));
        return (base == l ? 1 : -1) * std::atan2(from[1], from[0]);
      };
      GenId e = s;
      double least = 7;
      for (const DiagramVertex& end : d.vertices) {
        for (int other = 0; other < 3; ++other) {
          if (end.generators[other] != l || end.generators[(other + 1) % 3] != r) continue;
          const double sweep = std::fmod(direction(end) - direction(start) + 4 * pi, 2 * pi);
          if (sweep < least) {
            least = sweep;
            e = end.generators[(other + 2) % 3];
          }
        }
      }
      edges.insert(canonical(Quad{l, r, s, e}));
    }
  }
  d.edges.assign(edges.begin(), edges.end());
}

// Disjoint disks of very different radii: a few large ones, the others small.
DiagramFile random_diagram(int n, unsigned seed) {
  std::mt19937_64 engine(seed);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  DiagramFile d;
  d.container_center = {3, -2};
  d.container_radius = 100;
  while (static_cast<int>(d.disks.size()) < n) {
    const double radius = d.disks.size() < 3 ? 24 - 6.0 * static_cast<double>(d.disks.size())
                                             : 0.2 * std::pow(50.0, uniform());
    const Vec2 at{3 + 200 * (uniform() - 0.5), -2 + 200 * (uniform() - 0.5)};
    if (nearest_gap(d, at) < radius + 0.2) continue;
    const double heading = 2 * pi * uniform(), speed = 0.2 + uniform();
    d.disks.push_back({at, radius, {speed * std::cos(heading), speed * std::sin(heading)}});
  }
  complete(d);
  return d;
}

DiagramFile square_lattice(int side) {
  DiagramFile d;
  d.container_radius = 3.0 * side;
  for (int i = 0; i < side * side; ++i) {
    // Off the lattice by a little, so that brute force meets no cocircular disks.
    const double shift = 1e-3 * std::sin(7.0 * i);
    d.disks.push_back({{4.0 * (i % side) - 2.0 * (side - 1) + shift,
                        4.0 * (i / side) - 2.0 * (side - 1) + shift * shift + 1e-3 * std::cos(i)},
                       1,
                       {0, 0}});
  }
  complete(d);
  return d;
}

DiagramFile lone_disk() {
  DiagramFile d;
  d.container_radius = 10;
  d.disks.push_back({{4, 3}, 2, {1, 0}});
  return d;
}

// A disk in the crack between two large ones and the container: two-edge cells and
// pairs with several edges.
DiagramFile crack() {
  DiagramFile d;
  d.container_radius = 10;
  d.disks = {{{-4.5, 0}, 4.4, {0.3, 0.1}},
             {{4.5, 0.1}, 4.4, {-0.3, 0}},
             {{0.01, 0}, 0.05, {0, 1}},
             {{0.02, 1.5}, 0.1, {0, -1}},
             {{-8, -5.2}, 0.2, {0, 0}}};
  complete(d);
  return d;
}

Vec2 at(const Cubic& c, double t) {
  Vec2 x{};
  const double u = 1 - t;
  for (int i = 0; i < 2; ++i) {
    x[i] = u * u * u * c[0][i] + 3 * u * u * t * c[1][i] + 3 * u * t * t * c[2][i] +
           t * t * t * c[3][i];
  }
  return x;
}

// Every point of every curve is as near to both generators of the edge as to any
// other; the curve joins the two vertices and runs the way of its name.
void expect_true_curves(const DiagramFile& d, double tolerance) {
  const EdgeCurves curves(d, tolerance);
  for (const Quad& q : d.edges) {
    SCOPED_TRACE("edge " + std::to_string(q.l) + " " + std::to_string(q.r) + " " +
                 std::to_string(q.s) + " " + std::to_string(q.e));
    const auto chain = curves.of(q);
    ASSERT_FALSE(chain.empty());
    double turned = 0;
    const GenId base = q.l == container_id ? q.r : q.l;
    Vec2 previous = chain.front()[0];
    EXPECT_NEAR(gap(d, q.s, previous), gap(d, q.l, previous), 1e-6);
    EXPECT_NEAR(gap(d, q.e, chain.back()[3]), gap(d, q.l, chain.back()[3]), 1e-6);
    for (const Cubic& cubic : chain) {
      EXPECT_NEAR(norm(minus(cubic[0], previous)), 0, 1e-9);
      for (int step = 1; step <= 8; ++step) {
        const Vec2 x = at(cubic, step / 8.0);
        // The difference of two distances changes at most twice as fast as x.
        EXPECT_NEAR(gap(d, q.l, x), gap(d, q.r, x), 4 * tolerance);
        EXPECT_GE(nearest_gap(d, x), gap(d, q.l, x) - 4 * tolerance);
        const Vec2 a = minus(previous, center(d, base)), b = minus(x, center(d, base));
        turned += std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
        previous = x;
      }
    }
    EXPECT_GT(base == q.l ? turned : -turned, 0);
  }
}

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

class Render : public testing::Test {
 protected:
  Render() {
    folder_ = std::filesystem::temp_directory_path() /
              ("render_test_" + std::to_string(getpid()) + "_" +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  ~Render() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string svg_of(const DiagramFile& d) const {
    render_diagram(d, path("picture.svg"));
    return contents(path("picture.svg"));
  }

  std::filesystem::path folder_;
};

TEST(EdgeCurves, AreVoronoiEdgesOfRandomDisks) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const DiagramFile d = random_diagram(4 + static_cast<int>(seed), seed);
    const std::size_t n = d.disks.size();
    ASSERT_EQ(d.vertices.size(), 2 * (n + 1) - 4);
    ASSERT_EQ(d.edges.size(), 3 * (n + 1) - 6);
    expect_true_curves(d, 1e-3);
  }
}

TEST(EdgeCurves, AreVoronoiEdgesOfPairsWithSeveralEdges) {
  const DiagramFile d = crack();
  ASSERT_EQ(d.vertices.size(), 8u);
  ASSERT_EQ(d.edges.size(), 12u);
  std::map<std::pair<GenId, GenId>, int> pairs;
  for (const Quad& q : d.edges) ++pairs[{q.l, q.r}];
  EXPECT_TRUE(std::any_of(pairs.begin(), pairs.end(), [](const auto& p) { return p.second > 1; }));
  expect_true_curves(d, 1e-4);
}

TEST(EdgeCurves, AreSegmentsBetweenEqualDisks) {
  const DiagramFile d = square_lattice(3);
  ASSERT_EQ(d.edges.size(), 24u);
  expect_true_curves(d, 1e-4);
  const EdgeCurves curves(d, 1e-4);
  for (const Quad& q : d.edges) {
    if (q.l == container_id) continue;
    const auto chain = curves.of(q);
    const Vec2 start = chain.front()[0], along = minus(chain.back()[3], start);
    for (const Cubic& cubic : chain) {
      for (const Vec2& x : cubic) {
        const Vec2 to = minus(x, start);
        EXPECT_NEAR((along[0] * to[1] - along[1] * to[0]) / norm(along), 0, 1e-9);
      }
    }
  }
}

TEST(EdgeCurves, KeepTheToleranceTheyAreGiven) {
  const DiagramFile d = random_diagram(9, 5);
  for (double tolerance : {1.0, 1e-2, 1e-5}) expect_true_curves(d, tolerance);
}

TEST(EdgeCurves, SurviveVerticesThatCoincide) {
  // Edges of length zero whose ends rounding has put in the wrong order.
  const DiagramFile good = crack();
  for (const Quad& edge : good.edges) {
    for (const Vec2& shift : {Vec2{1e-14, 0}, Vec2{-1e-14, 0}, Vec2{0, 1e-14}, Vec2{0, -1e-14}}) {
      DiagramFile d = good;
      const auto vertex = [&](const Triple& generators) {
        return std::find_if(d.vertices.begin(), d.vertices.end(),
                            [&](const auto& v) { return v.generators == generators; });
      };
      const Vec2 place = vertex(start_vertex(edge))->center;
      vertex(end_vertex(edge))->center = {place[0] + shift[0], place[1] + shift[1]};
      for (const Quad& way : {edge, reversed(edge)}) {
        for (const Cubic& cubic : EdgeCurves(d, 1e-3).of(way)) {
          for (const Vec2& x : cubic) EXPECT_LT(norm(minus(x, place)), 1e-9);
        }
      }
    }
  }
}

TEST(EdgeCurves, TheOnlyCellIsAnEllipse) {
  const DiagramFile d = lone_disk();
  const auto chain = EdgeCurves(d, 1e-5).only_cell();
  EXPECT_LE(chain.size(), 16u);  // a cubic approximates to the sixth order
  double area = 0;
  for (const Cubic& cubic : chain) {
    for (int step = 0; step < 64; ++step) {
      const Vec2 a = at(cubic, step / 64.0), b = at(cubic, (step + 1) / 64.0);
      EXPECT_NEAR(gap(d, 0, a), gap(d, container_id, a), 1e-4);
      area += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
  }
  // Foci 5 apart, sum of distances R + r = 12.
  EXPECT_NEAR(area, pi * 6 * std::sqrt(36 - 6.25), 0.1);
}

TEST(EdgeCurves, RefuseAnEdgeWithoutVertices) {
  const DiagramFile d = crack();
  EXPECT_THROW(EdgeCurves(d, 1e-3).of({0, 1, 4, 4}), std::invalid_argument);
}

TEST_F(Render, SvgHasOnePathForEachPart) {
  const DiagramFile d = random_diagram(12, 3);
  const std::string svg = svg_of(d);
  EXPECT_EQ(svg.substr(0, 5), "<?xml");
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  // 33 edges, 22 vertices; for each disk its cell, arrow (2) and id. The areas and
  // the lines of the disks and the container may share a path or not.
  EXPECT_GE(count(svg, "<path"), 33 + 22 + 12 * 5 + 1);
  EXPECT_LE(count(svg, "<path"), 33 + 22 + 12 * 6 + 2);
}

TEST_F(Render, EqualDiagramsGiveEqualFiles) {
  const DiagramFile d = random_diagram(10, 4);
  render_diagram(d, path("a.svg"));
  render_diagram(random_diagram(10, 5), path("other.svg"));
  render_diagram(d, path("b.svg"));
  EXPECT_EQ(contents(path("a.svg")), contents(path("b.svg")));
  EXPECT_NE(contents(path("a.svg")), contents(path("other.svg")));
}

TEST_F(Render, PngOfTheGivenSize) {
  render_diagram(random_diagram(8, 6), path("picture.png"), {.size = 300});
  const std::string png = contents(path("picture.png"));
  ASSERT_GT(png.size(), 1000u);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  // Width and height in the header chunk, big-endian.
  EXPECT_EQ(png.substr(16, 8), std::string("\0\0\1\x2c\0\0\1\x2c", 8));
}

TEST_F(Render, NoDiskAndOneDisk) {
  DiagramFile empty;
  empty.container_radius = 5;
  const int container = count(svg_of(empty), "<path");
  EXPECT_GE(container, 1);
  // Cell and edge, the disk, its arrow (2) and its id.
  EXPECT_GE(count(svg_of(lone_disk()), "<path"), container + 5);
}

TEST_F(Render, NeighboursDifferInColour) {
  const DiagramFile d = random_diagram(16, 8);
  const std::string svg = svg_of(d);
  // The container is filled first, then the cells in the order of ids.
  std::vector<std::string> fills;
  auto at = svg.find("<path");
  for (std::size_t path = 0; path <= d.disks.size(); ++path) {
    const auto colour = svg.find("fill:rgb", at);
    fills.push_back(svg.substr(colour, svg.find(';', colour) - colour));
    at = svg.find("<path", at + 1);
  }
  EXPECT_GT(std::set<std::string>(fills.begin(), fills.end()).size(), 4u);
  for (const Quad& q : d.edges) {
    if (q.l == container_id) continue;
    EXPECT_NE(fills.at(1 + q.l), fills.at(1 + q.r)) << q.l << " and " << q.r;
  }
}

TEST_F(Render, RefusesOtherExtensions) {
  for (const char* name : {"picture", "picture.pdf", "picture.svg.gz", "png"})
    EXPECT_THROW(render_diagram(lone_disk(), path(name)), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(Render, RefusesSizesOutOfRange) {
  for (int size : {-1, 0, 15, 20001})
    EXPECT_THROW(render_diagram(lone_disk(), path("p.svg"), {.size = size}), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(Render, RefusesDiagramsThatAreNone) {
  const DiagramFile good = crack();
  DiagramFile d = good;
  d.edges.pop_back();  // two cells do not close
  EXPECT_THROW(render_diagram(d, path("p.svg")), std::invalid_argument);
  d = good;
  d.vertices.pop_back();
  EXPECT_THROW(render_diagram(d, path("p.svg")), std::invalid_argument);
  d = good;
  d.edges[0].e = 99;
  EXPECT_THROW(render_diagram(d, path("p.svg")), std::invalid_argument);
  d = good;
  d.container_radius = 0;
  EXPECT_THROW(render_diagram(d, path("p.svg")), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(Render, AnUnwritablePathLeavesNothing) {
  EXPECT_THROW(render_diagram(lone_disk(), path("missing/picture.svg")), OutputError);
  std::filesystem::create_directory(path("taken.png"));
  EXPECT_THROW(render_diagram(lone_disk(), path("taken.png")), OutputError);
  EXPECT_TRUE(std::filesystem::is_directory(path("taken.png")));
  std::filesystem::remove(path("taken.png"));
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

}  // namespace
}  // namespace voroproof::internal
