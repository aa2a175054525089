// Queries over time against the same asked at many instants.
#include "queries/over_time.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "history/history_file.h"
#include "library/true_moment.h"
#include "queries/free_space.h"
#include "queries/openings.h"
#include "tests/queries/brute_moment.h"
#include "tests/queries/watched.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/formation_scene.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

double middle(const Enclosure& e) { return 0.5 * e.lo + 0.5 * e.hi; }

TEST(LeastGap, OfPairsIsThatOfManyInstants) {
  for (const unsigned seed : {1u, 2u}) {
    Watched w(crowd(7, seed));
    const Window window{1, 13};
    std::vector<std::vector<Vec2>> centres;
    for (int k = 0; k <= 240; ++k) centres.push_back(w.centres(1 + k * 0.05));
    for (GenId j = 0; j < w.size(); ++j) {
      for (GenId i = container_id; i < j; ++i) {
        const LeastGap least = least_gap(w.paths, w.cursor, i, j, window);
        const Enclosure gap = gap_of(w.paths, least);
        EXPECT_LE(gap.hi - gap.lo, 1e-12);
        EXPECT_GE(least.t, window.from);
        EXPECT_LE(least.t, window.to);
        EXPECT_NEAR(w.gap(w.centres(round_nearest(least.t)), i, j), middle(gap), 1e-9);
        double sampled = 1e9;
        for (const std::vector<Vec2>& at : centres) {
          const double here = w.gap(at, i, j);
          EXPECT_GE(here, gap.lo - 1e-9);
          sampled = std::min(sampled, here);
        }
        EXPECT_LE(sampled, gap.hi + 0.6);
        EXPECT_EQ(least.contact, gap.hi == 0);
      }
    }
  }
}

// The way of a disk from its lines in the history, or of the container, in 100 digits.
struct Way {
  struct Piece {
    Real t, x, y, vx, vy;
  };
  std::vector<Piece> pieces;
  void turn(const Piece& piece) { pieces.push_back(piece); }
  Piece at(const Real& t) const {
    auto piece = pieces.rbegin();
    while (piece->t > t) ++piece;
    const Real passed = t - piece->t;
    return {t, piece->x + piece->vx * passed, piece->y + piece->vy * passed, piece->vx, piece->vy};
  }
};

std::vector<Way> ways_of(const Watched& w) {
  const auto real = [](const Rational& q) { return oracle::rounded<Real>(q); };
  const Scene& scene = w.run.scene;
  std::vector<Way> ways(scene.disks.size() + 1);  // the last one is the container's
  ways.back().turn({0, real(scene.cx), real(scene.cy), 0, 0});
  for (std::size_t i = 0; i < scene.disks.size(); ++i) {
    const DiskInput& d = scene.disks[i];
    ways[i].turn({0, real(d.x), real(d.y), real(d.vx), real(d.vy)});
  }
  HistoryReader history(w.run.history, w.size());
  std::size_t maneuvers = 0;
  while (const auto event = history.next()) {
    if (const auto* c = std::get_if<CollideEvent>(&*event)) {
      for (const int side : {0, 1}) {
        const GenId g = side == 0 ? c->i : c->j;
        if (g == container_id) continue;
        ways[g].turn(
            {c->t, (*c->p[side])[0], (*c->p[side])[1], (*c->v[side])[0], (*c->v[side])[1]});
      }
    } else if (std::holds_alternative<ManeuverEvent>(*event)) {
      const Maneuver& m = scene.maneuvers[maneuvers++];
      Way::Piece there = ways[m.disk].at(real(m.t));
      there.vx = real(m.vx);
      there.vy = real(m.vy);
      ways[m.disk].turn(there);
    }
  }
  return ways;
}

// Between two turns of either the squared distance is a quadratic in time.
TEST(LeastGap, EnclosuresContainThatOfTheQuadratics) {
  int touched = 0, compared = 0;
  for (const unsigned seed : {1u, 2u, 3u}) {
    Watched w(crowd(7, seed));
    const std::vector<Way> ways = ways_of(w);
    const Window window{1, 13};
    for (GenId j = 0; j < w.size(); ++j) {
      for (GenId i = container_id; i < j; ++i) {
        const LeastGap least = least_gap(w.paths, w.cursor, i, j, window);
        if (least.contact) {
          ++touched;
          continue;
        }
        const Way &one = i == container_id ? ways.back() : ways[i], &other = ways[j];
        std::set<Real> ends{1, 13};
        for (const Way* way : {&one, &other}) {
          for (const Way::Piece& piece : way->pieces) {
            if (1 < piece.t && piece.t < 13) ends.insert(piece.t);
          }
        }
        const auto radius = [&](GenId g) {
          return oracle::rounded<Real>(g == container_id ? w.run.scene.container_radius
                                                         : w.run.scene.disks[g].radius.value());
        };
        Real best = 1e9, when = 0;
        for (auto from = ends.begin(), to = std::next(from); to != ends.end(); from = to++) {
          const Way::Piece a = one.at(*from), b = other.at(*from);
          const Real x = b.x - a.x, y = b.y - a.y, vx = b.vx - a.vx, vy = b.vy - a.vy;
          const Real length = *to - *from, v2 = vx * vx + vy * vy;
          std::vector<Real> times{0, length};
          const Real turning = v2 > 0 ? Real(-(x * vx + y * vy) / v2) : Real(0);
          if (0 < turning && turning < length) times.push_back(turning);
          for (const Real& t : times) {
            const Real d = sqrt((x + t * vx) * (x + t * vx) + (y + t * vy) * (y + t * vy));
            const Real gap = i == container_id ? Real(radius(i) - radius(j) - d)
                                               : Real(d - radius(i) - radius(j));
            if (gap < best) {
              best = gap;
              when = *from + t;
            }
          }
        }
        const Enclosure gap = gap_of(w.paths, least);
        EXPECT_TRUE(contains(gap, best)) << i << ' ' << j;
        EXPECT_TRUE(is_narrow(gap, 200));
        EXPECT_LT(abs(oracle::rounded<Real>(least.t) - when), Real(1e-60)) << i << ' ' << j;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 40);
  EXPECT_GT(touched, 10);
}

void expect_least_of_all(Watched& w, const Window& window) {
  const auto least = least_gap_of_all(w.paths, w.cursor, window);
  ASSERT_TRUE(least);
  // All pairs, one by one, compared in doubles.
  std::optional<LeastGap> best;
  for (GenId j = 0; j < w.size(); ++j) {
    for (GenId i = 0; i < j; ++i) {
      const LeastGap g = least_gap(w.paths, w.cursor, i, j, window);
      const double difference =
          best ? middle(gap_of(w.paths, g)) - middle(gap_of(w.paths, *best)) : -1;
      const bool first = best && std::tie(g.t, g.i, g.j) < std::tie(best->t, best->i, best->j);
      if (difference < -1e-12 || (difference <= 1e-12 && first)) best = g;
    }
  }
  EXPECT_EQ(std::pair(least->i, least->j), std::pair(best->i, best->j)) << text(w.run.scene);
  EXPECT_EQ(least->t, best->t);
  EXPECT_NEAR(middle(gap_of(w.paths, *least)), middle(gap_of(w.paths, *best)), 1e-12);
}

TEST(LeastGap, OfAllIsTheLeastOfAllPairs) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    Watched w(crowd(9, seed));
    // Until the first collision of disks, from a third of the time, and all.
    Rational contact = 16;
    for (std::size_t k = w.cursor.size(); k-- > 0;) {
      const auto* c = std::get_if<CollideEvent>(&w.cursor.event(k));
      if (c != nullptr && c->i != container_id) contact = exact_time(w.cursor.event(k));
    }
    expect_least_of_all(w, {0, 16});
    expect_least_of_all(w, {0, Rational(contact * Rational(9, 10))});
    expect_least_of_all(w, {Rational(contact / 3), Rational(contact * Rational(2, 3))});
  }
}

// Many pairs are equally close, at one time and at several.
TEST(LeastGap, OfAllInFormations) {
  for (const auto& flight : {std::vector<std::string>{"square", "circle", "frame"},
                             {"circle", "turn", "square"},
                             {"square", "east", "staggered"}}) {
    for (const int n : {4, 9}) {
      Watched w(scene_of(FormationScene{n, flight}));
      ASSERT_TRUE(w.run.complete);
      expect_least_of_all(w, {0, w.run.scene.horizon});
      expect_least_of_all(w, {3, 11});
    }
  }
}

// The pair at the wall that is never a pair of neighbours (see nearest_test.cpp).
TEST(LeastGap, OfAllFindsThePairBehindTheWall) {
  const Rational r(1, 100), low = Rational(-1000) + Rational(2, 100);
  Watched w(scene_of(1000, 1,
                     {disk(Rational(51, 100), low, r, 0, 0), disk(Rational(-51, 100), low, r, 0, 0),
                      disk(0, low + Rational(9, 10), r, 0, 0)}));
  const auto least = least_gap_of_all(w.paths, w.cursor, {0, 1});
  EXPECT_EQ(std::pair(least->i, least->j), std::pair(0, 1));
  EXPECT_EQ(least->t, 0);
}

// Disk 1 touches disk 0 at the start, goes to the wall and comes back; 2 and 3 meet at t = 1.
TEST(LeastGap, OfDisksThatTouchBeforeTheyCollide) {
  Watched w(scene_of(
      10, 8,
      {disk(0, 0, 1, 0, 0), disk(2, 0, 1, 2, 0), disk(-4, 4, 1, 1, 0), disk(0, 4, 1, -1, 0)}));
  ASSERT_TRUE(w.run.complete);
  const LeastGap pair = least_gap(w.paths, w.cursor, 0, 1, {0, 8});
  EXPECT_EQ(pair.t, 0);
  EXPECT_FALSE(pair.contact);
  EXPECT_TRUE(gap_of(w.paths, pair).lo <= 0 && gap_of(w.paths, pair).hi >= 0);
  const LeastGap later = least_gap(w.paths, w.cursor, 0, 1, {1, 8});
  EXPECT_EQ(later.t, 7);
  EXPECT_TRUE(later.contact);
  for (const Rational& end : {Rational(1, 2), Rational(8)}) {
    const auto all = least_gap_of_all(w.paths, w.cursor, {0, end});
    EXPECT_EQ(std::pair(all->i, all->j), std::pair(0, 1));
    EXPECT_EQ(all->t, 0);
  }
  const auto all = least_gap_of_all(w.paths, w.cursor, {Rational(1, 2), 8});
  EXPECT_EQ(std::pair(all->i, all->j), std::pair(2, 3));
  EXPECT_TRUE(all->contact);
}

TEST(NeighboursOver, AreThoseOfEveryInstant) {
  Watched w(crowd(8, 3));
  const Window window{Rational(1, 2), 12};
  HistoryCursor other(w.run.scene, w.run.history, no_initial);
  std::size_t spells = 0;
  for (GenId g = 0; g < w.size(); ++g) {
    const auto all = neighbours_over(w.cursor, g, window);
    spells += all.size();
    for (int k = 0; k <= 115; ++k) {
      const Rational t = window.from + Rational(k, 10);
      other.seek(t);
      std::set<GenId> expected, found;
      const Diagram& diagram = other.diagram().diagram();
      for (Diagram::HalfEdge h = 0; h < 2 * diagram.edges(); ++h) {
        if (diagram.org(h) == g) expected.insert(diagram.dest(h));
      }
      for (const Neighbourhood& n : all) {
        if (n.from <= t && t <= n.to) found.insert(n.generator);
      }
      EXPECT_EQ(found, expected) << g << " at " << t;
    }
  }
  EXPECT_GT(spells, 40u);
}

// Edges that go and come back at one recorded time part no spell.
TEST(NeighboursOver, SpellsDoNotAbut) {
  for (const char* name : {"close-roots/one-edge-1e-40", "configurations/fig15-there-and-back"}) {
    Watched w(read_scene(std::string(VOROPROOF_CASES "/") + name + "/scene.scene.json"));
    ASSERT_TRUE(w.run.complete);
    for (GenId g = 0; g < w.size(); ++g) {
      const auto all = neighbours_over(w.cursor, g, {0, w.run.scene.horizon});
      for (std::size_t k = 1; k < all.size(); ++k) {
        if (all[k].generator != all[k - 1].generator) continue;
        EXPECT_LT(all[k - 1].to, all[k].from) << name << ": " << g << ", " << all[k].generator;
      }
    }
  }
}

TEST(NeighboursOver, OfALoneDisk) {
  Watched w(scene_of(5, 10, {disk(0, 0, 1, 3, 0)}));
  const auto all = neighbours_over(w.cursor, 0, {1, 9});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].generator, container_id);
  EXPECT_EQ(all[0].from, 1);
  EXPECT_EQ(all[0].to, 9);
}

bool within(const std::vector<Opening>& openings, double t) {
  return std::any_of(openings.begin(), openings.end(),
                     [&](const Opening& o) { return o.from.lo <= t && t <= o.to.hi; });
}

bool near_an_end(const std::vector<Opening>& openings, double t) {
  return std::any_of(openings.begin(), openings.end(), [&](const Opening& o) {
    return std::fabs(o.from.lo - t) < 1e-6 || std::fabs(o.to.lo - t) < 1e-6;
  });
}

// What holds at the instant by the queries at an instant.
struct Asked {
  Asked(const Watched& w, const Rational& at)
      : t(at), moment(true_moment(w.run.scene, w.run.history, t, {})) {}
  bool tunnel(GenId i, GenId j, const Rational& probe) {
    Clearance clearance(moment.motion, t, moment.diagram, probe, counts);
    if (moment.diagram.disks() == 1) {
      return clearance.to_probe(clearance.ring_profile().front()) != Sign::negative;
    }
    for (Diagram::HalfEdge h = 0; h < 2 * moment.diagram.edges(); h += 2) {
      const std::pair<GenId, GenId> pair =
          std::minmax(moment.diagram.org(h), moment.diagram.dest(h));
      if (pair.first == i && pair.second == j &&
          clearance.to_probe(narrowest(clearance, h)) != Sign::negative) {
        return true;
      }
    }
    return false;
  }
  bool room(const Triple& v, const Rational& probe) {
    Clearance clearance(moment.motion, t, moment.diagram, probe, counts);
    for (const Quad& q : moment.diagram.quads()) {
      if (start_vertex(q) == v || end_vertex(q) == v) {
        return clearance.to_probe(vertex_node(v)) != Sign::negative;
      }
    }
    return false;
  }
  Rational t;
  TrueMoment moment;
  TierCounts counts;
};

// At many instants, and on both sides of every end.
template <class Holds>
int expect_openings(const Watched& w, const std::vector<Opening>& openings, const Window& window,
                    Holds&& holds) {
  for (int k = 0; k < 24; ++k) {
    const Rational t = window.from + (window.to - window.from) * Rational(2 * k + 1, 48);
    if (near_an_end(openings, t.get_d())) continue;
    Asked instant(w, t);
    EXPECT_EQ(within(openings, t.get_d()), holds(instant)) << t;
  }
  int ends = 0;
  for (const Opening& o : openings) {
    for (const bool start : {true, false}) {
      const Enclosure& e = start ? o.from : o.to;
      EXPECT_LE(e.hi - e.lo, 1e-14 * (1 + e.hi));
      const Rational at = to_rational(e.lo), hair(1, 10000000);
      if (at <= window.from || at >= window.to - hair) continue;
      ++ends;
      Asked before(w, at - hair), after(w, at + hair);
      EXPECT_EQ(holds(before), !start) << at.get_d();
      EXPECT_EQ(holds(after), start) << at.get_d();
    }
  }
  return ends;
}

TEST(Openings, OfTunnelsAreThoseOfEveryInstant) {
  const Window window{1, 9};
  int ends = 0;
  for (const unsigned seed : {4u, 5u, 6u}) {
    Watched w(crowd(6, seed));
    for (GenId j = 0; j < w.size(); ++j) {
      for (GenId i = container_id; i < j; ++i) {
        for (const Rational& probe : {Rational(3), Rational(12), Rational(30)}) {
          SCOPED_TRACE(std::to_string(i) + " " + std::to_string(j) + " " + probe.get_str());
          const auto openings = tunnel_openings(w.paths, w.cursor, i, j, probe, window);
          ends += expect_openings(w, openings, window,
                                  [&](Asked& at) { return at.tunnel(i, j, probe); });
        }
      }
    }
  }
  EXPECT_GT(ends, 30);
}

TEST(Openings, OfVoidsAreThoseOfEveryInstant) {
  const Window window{1, 9};
  int ends = 0;
  for (const unsigned seed : {4u, 5u, 6u}) {
    Watched w(crowd(6, seed));
    w.cursor.seek(Rational(4));
    std::set<Triple> vertices;
    for (const Quad& q : w.cursor.diagram().diagram().quads()) vertices.insert(start_vertex(q));
    for (const Triple& v : vertices) {
      for (const Rational& probe : {Rational(15), Rational(25)}) {
        SCOPED_TRACE(oracle::text(v));
        const auto openings = void_openings(w.paths, w.cursor, v, probe, window);
        ends += expect_openings(w, openings, window, [&](Asked& at) { return at.room(v, probe); });
      }
    }
  }
  EXPECT_GT(ends, 15);
}

// The gap to the wall is 4 - |x|, and x = 3 t up to the bounce at x = 4.
TEST(Openings, OfALoneDisksTunnel) {
  Watched w(scene_of(5, 2, {disk(0, 0, 1, 3, 0)}));
  const auto openings = tunnel_openings(w.paths, w.cursor, -1, 0, 1, {0, 2});
  // Until x = 2, and when it is there again.
  ASSERT_EQ(openings.size(), 2u);
  EXPECT_EQ(openings[0].from.lo, 0);
  EXPECT_NEAR(openings[0].to.lo, 2.0 / 3, 1e-15);
  EXPECT_NEAR(openings[1].from.lo, 2, 1e-15);
}

// Disk 1 passes disk 0 at a distance at which the probe does not fit for some 5e-20 about t = 5.
TEST(Openings, OfATunnelThatClosesForALittleWhile) {
  Watched w(scene_of(100, 10, {disk(0, 0, 1, 0, 0), disk(-5, 4, 1, 1, 0)}));
  const Rational probe = 1 + Rational(1, Integer("1" + std::string(40, '0')));
  const auto openings = tunnel_openings(w.paths, w.cursor, 0, 1, probe, {0, 10});
  ASSERT_EQ(openings.size(), 2u);
  EXPECT_NEAR(openings[0].to.lo, 5, 1e-14);
  EXPECT_NEAR(openings[1].from.lo, 5, 1e-14);
}

}  // namespace
}  // namespace voroproof::internal::testing
