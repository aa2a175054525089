// The diagram of any disks at rest against brute force, CGAL and exact transformations.
#include "engine/resting_diagram.h"

#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_filtered_traits_2.h>
#include <CGAL/Apollonius_graph_hierarchy_2.h>
#include <CGAL/Apollonius_graph_traits_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>

#include "exact/topology/diagram.h"
#include "filtered/search/hidden_disks.h"
#include "tests/support/resting_disks.h"

namespace voroproof::internal::testing {
namespace {

int number_from(const char* variable, int usual) {
  const char* given = std::getenv(variable);
  return given == nullptr ? usual : std::atoi(given);
}

RestingDiagram diagram(const Disks& disks, Frame frame, const Rational& radius = 10) {
  TierCounts counts;
  return resting_diagram(input_of(disks, radius), frame, {}, counts);
}

// ---- Brute force, in long double: for disks in general position. ----

using Real = long double;
struct Site3 {
  Real x, y, r;  // the container has a negative radius
};
struct Circle {
  Real x, y, radius;
};

class BruteForce {
 public:
  BruteForce(const Disks& disks, Frame frame, const Rational& radius) : frame_(frame) {
    sites_.push_back({0, 0, -static_cast<Real>(radius.get_d())});
    for (const Disk& d : disks) {
      sites_.push_back({static_cast<Real>(d.x.get_d()), static_cast<Real>(d.y.get_d()),
                        static_cast<Real>(d.r.get_d())});
    }
  }

  // Whether no three centres are so nearly on one line that circles have few digits.
  bool is_general() const {
    const std::size_t first = frame_ == Frame::circle ? 0 : 1;
    for (std::size_t i = first; i < sites_.size(); ++i) {
      for (std::size_t j = i + 1; j < sites_.size(); ++j) {
        for (std::size_t k = j + 1; k < sites_.size(); ++k) {
          const Site3 &a = sites_[i], &b = sites_[j], &c = sites_[k];
          const Real area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
          if (std::fabs(area) < 1e-4) return false;
        }
      }
    }
    return true;
  }

  // The names of all vertices.
  std::set<Triple> vertices() const {
    std::set<Triple> all;
    const int n = static_cast<int>(sites_.size()) - 1;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        if (i == j) continue;
        if (i < j && frame_ == Frame::circle) add_circles(-1, i, j, all);
        if (frame_ == Frame::plane && is_hull_edge(i, j)) all.insert({-1, i, j});
        for (int k = j + 1; i < j && k < n; ++k) add_circles(i, j, k, all);
      }
    }
    return all;
  }

 private:
  const Site3& at(int g) const { return sites_[g + 1]; }
  Real distance(int g, const Circle& c) const { return std::hypot(c.x - at(g).x, c.y - at(g).y); }
  // Positive outside of a disk, inside of the container.
  Real gap(int g, const Circle& c) const {
    return g < 0 ? -at(g).r - c.radius - distance(g, c) : distance(g, c) - at(g).r - c.radius;
  }

  void add_circles(int i, int j, int k, std::set<Triple>& all) const {
    // Differences of |c - c_g|^2 = (rho + r_g)^2 are linear: (x, y) = u + rho w.
    const Real ax = 2 * (at(j).x - at(i).x), ay = 2 * (at(j).y - at(i).y);
    const Real bx = 2 * (at(k).x - at(i).x), by = 2 * (at(k).y - at(i).y);
    const auto square = [&](int g) {
      return at(g).x * at(g).x + at(g).y * at(g).y - at(g).r * at(g).r;
    };
    const Real a = square(j) - square(i), b = square(k) - square(i);
    const Real ar = -2 * (at(j).r - at(i).r), br = -2 * (at(k).r - at(i).r);
    const Real det = ax * by - ay * bx;
    const Real ux = (a * by - ay * b) / det, uy = (ax * b - a * bx) / det;
    const Real wx = (ar * by - ay * br) / det, wy = (ax * br - ar * bx) / det;
    const Real dx = ux - at(i).x, dy = uy - at(i).y;
    const Real p = wx * wx + wy * wy - 1, q = dx * wx + dy * wy - at(i).r,
               c = dx * dx + dy * dy - at(i).r * at(i).r;
    const Real root = std::sqrt(q * q - p * c);
    for (const Real rho : {(-q + root) / p, (-q - root) / p}) {
      const Circle circle{ux + rho * wx, uy + rho * wy, rho};
      if (!std::isfinite(rho) || !is_empty(circle, {i, j, k})) continue;
      all.insert(canonical(turns_left(i, j, k, circle) ? Triple{i, j, k} : Triple{i, k, j}));
    }
  }

  bool is_empty(const Circle& c, const std::set<int>& own) const {
    const int n = static_cast<int>(sites_.size()) - 1;
    for (int g = frame_ == Frame::circle ? -1 : 0; g < n; ++g) {
      const Real off = gap(g, c);
      if (own.count(g) ? std::fabs(off) > 1e-9 : off < 0) return false;
    }
    return true;
  }

  // Whether the contacts are counterclockwise.
  bool turns_left(int i, int j, int k, const Circle& c) const {
    const auto direction = [&](int g) {
      const Real far = (g < 0 ? -1 : 1) / distance(g, c);
      return std::array{(at(g).x - c.x) * far, (at(g).y - c.y) * far};
    };
    const auto a = direction(i), b = direction(j), d = direction(k);
    return (b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0]) > 0;
  }

  // Whether a line touches i and then j, all disks on its right.
  bool is_hull_edge(int i, int j) const {
    const Real dx = at(j).x - at(i).x, dy = at(j).y - at(i).y, far = std::hypot(dx, dy);
    const Real sine = (at(i).r - at(j).r) / far, cosine = std::sqrt(1 - sine * sine);
    const Real nx = (dx * sine - dy * cosine) / far, ny = (dy * sine + dx * cosine) / far;
    const int n = static_cast<int>(sites_.size()) - 1;
    const Real height = nx * at(i).x + ny * at(i).y + at(i).r;
    for (int g = 0; g < n; ++g) {
      if (g != i && g != j && nx * at(g).x + ny * at(g).y + at(g).r > height) return false;
    }
    return true;
  }

  Frame frame_;
  std::vector<Site3> sites_;
};

// The disks that a definition hides.
std::vector<bool> hidden(const Disks& disks, Frame frame, const Rational& radius) {
  std::vector<bool> all;
  for (std::size_t g = 0; g < disks.size(); ++g) {
    const Disk& d = disks[g];
    const bool is_outside =
        frame == Frame::circle && d.x * d.x + d.y * d.y >= (radius + d.r) * (radius + d.r);
    all.push_back(is_outside || another_contains(disks, g));
  }
  return all;
}

void expect_sphere(const Disks& disks, const RestingDiagram& d) {
  int visible = 0;
  std::map<GenId, GenId> number{{-1, -1}};
  for (std::size_t g = 0; g < disks.size(); ++g) {
    if (d.host[g] == visible_disk) number[static_cast<GenId>(g)] = visible++;
    if (d.host[g] < 0) continue;
    EXPECT_EQ(d.host[d.host[g]], visible_disk);
  }
  if (visible < 2) {
    EXPECT_TRUE(d.edges.empty());
    return;
  }
  std::vector<Quad> edges;
  for (const Quad& q : d.edges) {
    edges.push_back({number.at(q.l), number.at(q.r), number.at(q.s), number.at(q.e)});
  }
  EXPECT_NO_THROW(diagram_of(visible, edges)) << text(disks);
}

// Counts the sets of which vertices are compared.
void expect_right(const Disks& disks, Frame frame, const Rational& radius, int& compared) {
  const RestingDiagram d = diagram(disks, frame, radius);
  expect_sphere(disks, d);
  const std::vector<bool> truth = hidden(disks, frame, radius);
  Disks seen;
  std::vector<GenId> names;
  for (std::size_t g = 0; g < disks.size(); ++g) {
    EXPECT_EQ(d.host[g] != visible_disk, truth[g]) << g << text(disks);
    if (truth[g]) continue;
    seen.push_back(disks[g]);
    names.push_back(static_cast<GenId>(g));
  }
  if (seen.size() < 2) return;
  const BruteForce truth_of(seen, frame, radius);
  if (!truth_of.is_general()) return;
  ++compared;
  std::set<Triple> expected, found;
  for (const Triple& v : truth_of.vertices()) {
    const auto name = [&](GenId g) { return g < 0 ? g : names[g]; };
    expected.insert(canonical(Triple{name(v[0]), name(v[1]), name(v[2])}));
  }
  for (const Quad& q : d.edges) found.insert({start_vertex(q), end_vertex(q)});
  EXPECT_EQ(found, expected) << text(disks);
}

TEST(RestingDiagram, IsThatOfBruteForce) {
  Dice dice(1);
  const int sets = number_from("VOROPROOF_SETS", 1500);
  int compared = 0;
  for (int round = 0; round < sets; ++round) {
    const Disks disks = random_disks(dice, dice(0, 19) == 0 ? dice(0, 40) : dice(0, 12),
                                     dice(0, 1) == 0 ? Rational(3, 2) : Rational(5));
    expect_right(disks, Frame::plane, 10, compared);
    expect_right(disks, Frame::circle, dice(0, 2) == 0 ? Rational(5) : Rational(10), compared);
    if (HasFailure()) return;
  }
  EXPECT_GT(compared, sets);
}

// ---- CGAL ----

// The edges of a graph of CGAL's, of which `id` gives the disks by their places.
template <class Graph, class Id>
std::set<Quad> edges_of(const Graph& graph, const Id& id_of) {
  using Vertex = typename Graph::Vertex_handle;
  const auto id = [&](Vertex v) { return graph.is_infinite(v) ? -1 : id_of(v->site().point()); };
  std::set<Quad> edges;
  const auto& faces = graph.data_structure();
  for (auto face = graph.all_faces_begin(); face != graph.all_faces_end(); ++face) {
    for (int i = 0; i < 3; ++i) {
      const auto other = face->neighbor(i);
      edges.insert(
          canonical(Quad{id(face->vertex((i + 2) % 3)), id(face->vertex((i + 1) % 3)),
                         id(face->vertex(i)), id(other->vertex(faces.mirror_index(face, i)))}));
    }
  }
  return edges;
}

// `Number` is that of the graph's coordinates; no two centres are one.
template <class Graph, class Number, class ToNumber>
void expect_as_cgal(const Disks& disks, const ToNumber& number) {
  const RestingDiagram d = diagram(disks, Frame::plane);
  std::map<std::pair<Number, Number>, GenId> ids;
  std::vector<typename Graph::Site_2> sites;
  for (std::size_t g = 0; g < disks.size(); ++g) {
    const Number x = number(disks[g].x), y = number(disks[g].y);
    ids[{x, y}] = static_cast<GenId>(g);
    sites.emplace_back(typename Graph::Point_2(x, y), number(disks[g].r));
  }
  const Graph graph(sites.begin(), sites.end());
  const auto id = [&](const auto& point) { return ids.at({point.x(), point.y()}); };
  std::set<GenId> hidden_ones;
  for (auto s = graph.hidden_sites_begin(); s != graph.hidden_sites_end(); ++s) {
    hidden_ones.insert(id(s->point()));
  }
  for (std::size_t g = 0; g < disks.size(); ++g) {
    ASSERT_EQ(d.host[g] != visible_disk, hidden_ones.count(static_cast<GenId>(g)) == 1);
  }
  if (disks.size() - hidden_ones.size() < 3) return;
  EXPECT_TRUE(std::set<Quad>(d.edges.begin(), d.edges.end()) == edges_of(graph, id))
      << text(disks).substr(0, 4096);
}

TEST(RestingDiagram, IsThatOfCgal) {
  using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
  using Graph = CGAL::Apollonius_graph_2<
      CGAL::Apollonius_graph_traits_2<Kernel, CGAL::Integral_domain_without_division_tag>>;
  Dice dice(2);
  for (int round = 0; round < 60; ++round) {
    const Rational largest = dice(0, 1) == 0 ? Rational(4, 5) : Rational(4);
    expect_as_cgal<Graph, CGAL::Gmpq>(random_disks(dice, dice(3, 60), largest),
                                      [](const Rational& q) { return CGAL::Gmpq(q.get_mpq_t()); });
    if (HasFailure()) return;
  }
}

// Many disks, some or most of them hidden, behind CGAL's interval filter. VOROPROOF_SETS and
// VOROPROOF_DISKS ask for more.
TEST(RestingDiagram, IsThatOfCgalWhereDisksAreMany) {
  using Graph = CGAL::Apollonius_graph_hierarchy_2<
      CGAL::Apollonius_graph_filtered_traits_2<CGAL::Simple_cartesian<double>>>;
  const int sets = number_from("VOROPROOF_SETS", 3), n = number_from("VOROPROOF_DISKS", 3000);
  std::mt19937_64 random(3);
  const auto part = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (int round = 0; round < sets; ++round) {
    // The larger the disks, the more of them are hidden: up to 60%.
    const double largest = (round % 4 + 0.5) * 12 / std::sqrt(static_cast<double>(n));
    Disks disks;
    for (int k = 0; k < n; ++k) {
      const double x = 12 * part() - 6, y = 12 * part() - 6, r = part();
      disks.push_back({to_rational(x), to_rational(y), to_rational(largest * r * r * r)});
    }
    expect_as_cgal<Graph, double>(disks, [](const Rational& q) { return q.get_d(); });
    if (HasFailure()) return;
  }
}

// ---- Degenerate sets ----

// Ties are broken as if the disks were larger by numbers that grow from id to id beyond measure.
TEST(RestingDiagram, TiesAreThoseOfInfinitelyLittleLargerDisks) {
  Dice dice(3);
  for (int round = 0; round < 400; ++round) {
    const Disks disks = lattice_disks(dice, dice(2, 9), dice(1, 4));
    for (const Frame frame : {Frame::plane, Frame::circle}) {
      const RestingDiagram d = diagram(disks, frame, 5);
      expect_sphere(disks, d);
      Disks larger;
      std::vector<GenId> names;
      for (std::size_t g = 0; g < disks.size(); ++g) {
        if (d.host[g] != visible_disk) continue;
        names.push_back(static_cast<GenId>(g));
        larger.push_back(disks[g]);
        larger.back().r += Rational(1) >> (60 * (12 - static_cast<int>(names.size())));
      }
      const RestingDiagram untied = diagram(larger, frame, 5);
      std::vector<Quad> edges;
      for (const Quad& q : untied.edges) {
        const auto name = [&](GenId g) { return g < 0 ? g : names[g]; };
        edges.push_back({name(q.l), name(q.r), name(q.s), name(q.e)});
      }
      EXPECT_EQ(d.edges, edges) << (frame == Frame::plane ? "plane" : "circle") << text(disks);
    }
    if (HasFailure()) return;
  }
}

TEST(RestingDiagram, FewDisks) {
  EXPECT_TRUE(diagram({}, Frame::plane).edges.empty());
  EXPECT_TRUE(diagram({{1, 2, 3}}, Frame::plane).edges.empty());
  // Two that coincide: the second is hidden.
  EXPECT_EQ(diagram({{1, 2, 3}, {1, 2, 3}}, Frame::plane).host,
            (std::vector<GenId>{visible_disk, 0}));
  // Two, and infinity: the two lines that touch both.
  EXPECT_EQ(diagram({{0, 0, 1}, {5, 0, 2}}, Frame::plane).edges,
            (std::vector<Quad>{{-1, 0, 1, 1}, {-1, 1, 0, 0}, {0, 1, -1, -1}}));
  // All centres on one line.
  EXPECT_EQ(diagram({{0, 0, 1}, {2, 0, 1}, {4, 0, 1}}, Frame::plane).edges.size(), 6u);
  // A chain of hosts ends at a visible one; a disk outside is hidden by the circle.
  EXPECT_EQ(diagram({{0, 0, 1}, {0, 0, 3}, {0, 0, 2}, {20, 0, 1}}, Frame::circle).host,
            (std::vector<GenId>{1, visible_disk, 1, -1}));
}

// ---- Transformations after which the edges are the same ----

TEST(RestingDiagram, DoesNotDependOnUnitsOriginOrWeights) {
  Dice dice(4);
  for (int round = 0; round < 200; ++round) {
    const Disks disks = dice(0, 1) == 0 ? lattice_disks(dice, 8, 3) : random_disks(dice, 8, 3);
    const std::vector<Quad> edges = diagram(disks, Frame::plane).edges;
    const Rational scale = to_rational(dice(0, 1) == 0 ? 0x1p-90 : 0x1p90);
    Disks scaled = disks, moved = disks, heavier = disks;
    for (Disk& d : scaled) d = {d.x * scale, d.y * scale, d.r * scale};
    for (Disk& d : moved) d = {d.x + 12345678, d.y - Rational(1, 3), d.r};
    for (Disk& d : heavier) d.r += Rational(7, 3);
    EXPECT_EQ(diagram(scaled, Frame::plane).edges, edges) << text(disks);
    EXPECT_EQ(diagram(moved, Frame::plane).edges, edges) << text(disks);
    EXPECT_EQ(diagram(heavier, Frame::plane).edges, edges) << text(disks);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
