// Least gaps and neighbours over time against the same asked at many instants.
#include "library/closest_over.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "history/history_reader.h"
#include "tests/oracle/circle.h"
#include "tests/queries/brute_moment.h"
#include "tests/queries/watched.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/formation_scene.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

TEST(LeastGap, OfPairsIsThatOfManyInstants) {
  for (const unsigned seed : {1u, 2u}) {
    Watched w(crowd(7, seed));
    const Window window{1, 13};
    std::vector<std::vector<Vec2>> centres;
    for (int k = 0; k <= 240; ++k) centres.push_back(w.centres(1 + k * 0.05));
    for (GenId j = 0; j < w.size(); ++j) {
      for (GenId i = container_id; i < j; ++i) {
        const LeastGap least = least_gap(w.paths, i, j, window);
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

// The recorded path of a disk, or of the container, in 100 digits: it turns where it is.
struct Way {
  struct Piece {
    Real t, x, y, vx, vy;
  };
  std::vector<Piece> pieces;
  void turn(const Piece& piece) { pieces.push_back(piece); }
  void turn(const Real& t, const Vec2& v) {
    Piece here = at(t);
    here.vx = v[0];
    here.vy = v[1];
    turn(here);
  }
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
  while (const auto event = history.next()) {
    if (const auto* c = std::get_if<CollideEvent>(&*event)) {
      for (const int side : {0, 1}) {
        const GenId g = side == 0 ? c->i : c->j;
        if (g == container_id) continue;
        ways[g].turn(c->t, *c->v[side]);
      }
    } else if (const auto* m = std::get_if<ManeuverEvent>(&*event)) {
      ways[m->disk].turn(m->t, *m->v);
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
        const LeastGap least = least_gap(w.paths, i, j, window);
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
      const LeastGap g = least_gap(w.paths, i, j, window);
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
  const LeastGap pair = least_gap(w.paths, 0, 1, {0, 8});
  EXPECT_EQ(pair.t, 0);
  EXPECT_FALSE(pair.contact);
  EXPECT_TRUE(gap_of(w.paths, pair).lo <= 0 && gap_of(w.paths, pair).hi >= 0);
  const LeastGap later = least_gap(w.paths, 0, 1, {1, 8});
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

}  // namespace
}  // namespace voroproof::internal::testing
