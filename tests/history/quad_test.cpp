// The names of an edge.
#include "exact/generators.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace voroproof::internal::testing {
namespace {

TEST(Quad, NamesOfAnEdge) {
  EXPECT_EQ(canonical(Quad{3, 7, 2, 9}), (Quad{3, 7, 2, 9}));
  EXPECT_EQ(canonical(Quad{7, 3, 9, 2}), (Quad{3, 7, 2, 9}));
  EXPECT_EQ(start_vertex(Quad{3, 7, 2, 9}), (Triple{2, 7, 3}));
  EXPECT_EQ(end_vertex(Quad{3, 7, 2, 9}), (Triple{3, 7, 9}));
  EXPECT_TRUE(names_an_edge(Quad{-1, 0, 1, 1}));
  EXPECT_FALSE(names_an_edge(Quad{1, 1, 0, 2}));
  EXPECT_FALSE(names_an_edge(Quad{0, 1, 0, 2}));
  EXPECT_FALSE(names_an_edge(Quad{0, 1, 2, 1}));
}

// Walked backwards an edge starts where it ended.
RC_GTEST_PROP(Quad, BackwardsIsTheSameEdge, ()) {
  const GenId l = *rc::gen::inRange(-1, 4);
  const GenId r = *rc::gen::distinctFrom(rc::gen::inRange(-1, 4), l);
  const auto third =
      rc::gen::suchThat(rc::gen::inRange(-1, 4), [=](GenId id) { return id != l && id != r; });
  const Quad q{l, r, *third, *third};
  RC_ASSERT(names_an_edge(q));
  RC_ASSERT(canonical(reversed(q)) == canonical(q));
  RC_ASSERT(start_vertex(reversed(q)) == end_vertex(q));
  RC_ASSERT(end_vertex(reversed(q)) == start_vertex(q));
  RC_ASSERT(canonical(q) <= q);
}

}  // namespace
}  // namespace voroproof::internal::testing
