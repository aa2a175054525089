// Openings of tunnels and voids over time against the queries at many instants.
#include "library/queries/openings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "library/queries/free_space.h"
#include "library/true_moment.h"
#include "tests/oracle/brute_force.h"
#include "tests/queries/watched.h"
#include "tests/support/compact_arithmetic.h"

namespace voroproof::internal::testing {
namespace {

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
