// The filters of worlds against exact numbers, on any four generators: they need not be neighbours.
#include "filtered/worlds/rough_edge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "certify/world/world_courses.h"
#include "certify/world/world_geometry.h"
#include "tests/world/random_worlds.h"
#include "tests/world/world_tools.h"

namespace voroproof::internal::testing {
namespace {

using Kind = RoughCollapse::Kind;

// Some four different generators, three of which are disks at least; the first is one.
std::optional<Quad> any_quad(const WorldCourses& motion, std::mt19937_64& random) {
  std::vector<GenId> there{container_id};
  for (GenId g = 0; g < motion.disks(); ++g) {
    if (motion.is_there(g)) there.push_back(g);
  }
  if (there.size() < 5) return std::nullopt;
  std::shuffle(there.begin(), there.end(), random);
  Quad q{there[0], there[1], there[2], there[3]};
  if (q.l == container_id) q.l = there[4];
  return q;
}

// A world, some four of its generators, and a window of time in which neighbours among them are
// apart.
struct Trial {
  World world;
  WorldCourses motion;
  Quad q{};
  Rational begin, end;

  explicit Trial(World any) : world(std::move(any)), motion(world.motion(), true) {}
};

std::optional<Trial> trial(WorldFamily family, std::mt19937_64& random) {
  Trial t(random_world(family, random));
  const auto q = any_quad(t.motion, random);
  if (!q || sgn(t.world.horizon) == 0) return std::nullopt;
  t.q = *q;
  t.begin = t.world.horizon * Rational(static_cast<long>(random() % 97), 97);
  t.end = t.world.horizon;
  for (const auto& [g, h] :
       {std::pair{q->l, q->r}, {q->l, q->s}, {q->s, q->r}, {q->r, q->e}, {q->e, q->l}}) {
    const WorldPolynomial p = world_tangency(t.motion, g, h);
    if (sgn(p.evaluate(t.begin)) <= 0) return std::nullopt;
    for (const WorldTime& root : roots_after(p, WorldTime(t.begin), t.end)) {
      t.end = std::min(t.end, root.interval().lo);
    }
  }
  if (!(t.begin < t.end)) return std::nullopt;
  return t;
}

// The first root of the polynomial after a time for which `is_it`.
template <class IsIt>
std::optional<WorldTime> first(const WorldPolynomial* f, const Trial& t, const IsIt& is_it) {
  if (f == nullptr) return std::nullopt;
  for (const WorldTime& root : roots_after(*f, WorldTime(t.begin), 2 * t.world.horizon)) {
    if (is_it(root)) return root;
  }
  return std::nullopt;
}

// Whether the first is the one that was found, or none is up to the end.
void expect_same(const RoughCollapse& found, const std::optional<WorldTime>& first, double end,
                 const Trial& t) {
  if (found.kind == Kind::none) {
    EXPECT_TRUE(!first || compare(*first, to_rational(end)) > 0) << text(t.world);
    return;
  }
  ASSERT_TRUE(first) << text(t.world);
  EXPECT_TRUE(compare(*first, to_rational(found.root.lo)) >= 0) << text(t.world);
  EXPECT_TRUE(compare(*first, to_rational(found.root.hi)) <= 0) << text(t.world);
}

class RoughEdges : public ::testing::TestWithParam<WorldFamily> {};

TEST_P(RoughEdges, FallWhereExactOnesDo) {
  std::array<int, 4> kinds{};
  std::mt19937_64 random(7);
  for (int tries = 0; tries < 1500; ++tries) {
    const auto t = trial(GetParam(), random);
    if (!t) continue;
    const double lo = round_down(t->begin), hi = round_up(t->begin), end = round_down(t->end);
    const RoughRows& rows = t->motion.rough();
    const WorldEdge edge(t->motion, t->q);
    if (!(hi < end) || !is_legal_edge(rows, t->q, lo, hi)) continue;
    EXPECT_EQ(edge.from_start().at(t->begin), Sign::positive) << text(t->world);
    EXPECT_EQ(edge.from_end().at(t->begin), Sign::positive) << text(t->world);
    const RoughCollapse fall = rough_fall(rows, t->q, lo, hi, end);
    ++kinds[static_cast<int>(fall.kind)];
    if (fall.kind == Kind::unknown) continue;
    const auto falls = first(edge.changes(), *t, [&](const WorldTime& root) {
      return edge.from_start().after(root) == Sign::negative ||
             edge.from_end().after(root) == Sign::negative;
    });
    expect_same(fall, falls, end, *t);
    if (!falls || fall.kind == Kind::none) continue;
    const bool both = edge.from_start().after(*falls) == Sign::negative &&
                      edge.from_end().after(*falls) == Sign::negative;
    EXPECT_EQ(fall.kind == Kind::collapses, both && edge.is_point_at(*falls, false))
        << text(t->world);
  }
  for (const Kind kind : {Kind::none, Kind::collapses, Kind::fails}) {
    EXPECT_GT(kinds[static_cast<int>(kind)], 2);
  }
}

TEST_P(RoughEdges, CirclesEndWhereExactOnesDo) {
  const bool in_plane =
      GetParam() != WorldFamily::crossing_circle && GetParam() != WorldFamily::growing_circle;
  int ends = 0;
  std::mt19937_64 random(8);
  for (int tries = 0; tries < 1500; ++tries) {
    const auto t = trial(GetParam(), random);
    if (!t || t->q.r < 0 || t->q.s < 0) continue;
    const double lo = round_down(t->begin), hi = round_up(t->begin), end = round_down(t->end);
    const RoughRows& rows = t->motion.rough();
    if (t->motion.has_circle() || !(hi < end) ||
        !has_circle(rows, t->q.l, t->q.s, t->q.r, lo, hi)) {
      continue;
    }
    const RootedForm exact = existence(WorldEdge(t->motion, t->q).start());
    EXPECT_EQ(exact.at(t->begin), Sign::positive) << text(t->world);
    const RoughCollapse found = rough_end_of_circle(rows, t->q.l, t->q.s, t->q.r, lo, hi, end);
    if (found.kind == Kind::unknown) continue;
    ends += found.kind != Kind::none;
    const auto fails = first(exact.changes(), *t, [&](const WorldTime& root) {
      return exact.after(root) == Sign::negative;
    });
    expect_same(found, fails, end, *t);
  }
  EXPECT_EQ(ends > 0, in_plane);
}

TEST_P(RoughEdges, PairsMeetWhereExactOnesDo) {
  int pairs = 0, meetings = 0;
  std::mt19937_64 random(9);
  for (int tries = 0; tries < 3000; ++tries) {
    Trial t(random_world(GetParam(), random));
    const auto q = any_quad(t.motion, random);
    if (!q || sgn(t.world.horizon) == 0) continue;
    const auto [g, h] = std::pair(q->l, q->r);
    t.begin = t.world.horizon * Rational(static_cast<long>(random() % 97), 97);
    const double lo = round_down(t.begin), hi = round_up(t.begin);
    const double end = round_up(t.world.horizon);
    const RoughRows& rows = t.motion.rough();
    if (!are_apart(rows, g, h, lo, hi)) continue;
    const WorldPolynomial p = world_tangency(t.motion, g, h);
    EXPECT_GT(sgn(p.evaluate(t.begin)), 0);
    const RoughCollapse found = rough_meeting(rows, g, h, lo, hi, end);
    if (found.kind == Kind::unknown) continue;
    ++pairs;
    meetings += found.kind != Kind::none;
    expect_same(found, first(&p, t, [](const WorldTime&) { return true; }), end, t);
  }
  EXPECT_GT(pairs, 200);
  EXPECT_GT(meetings, 0);
}

INSTANTIATE_TEST_SUITE_P(Families, RoughEdges, ::testing::ValuesIn(world_families),
                         [](const auto& tested) { return name_of(tested.param); });

}  // namespace
}  // namespace voroproof::internal::testing
