// Steps through a history, there and back.
#include "library/queries/history_cursor.h"

#include <gtest/gtest.h>

#include <set>
#include <variant>

#include "history/error.h"
#include "tests/queries/watched.h"

namespace voroproof::internal::testing {
namespace {

std::vector<Quad> sight(const HistoryCursor& cursor) { return cursor.diagram().diagram().quads(); }

class CursorTest : public ::testing::Test {
 protected:
  static SceneHistory make() {
    Random random(5);
    return SceneHistory(
        random_scene({.n = 9, .horizon = 30, .density = 0.25, .maneuvers = 5}, random));
  }
};

TEST_F(CursorTest, EveryStepBackRestoresWhatWasBeforeIt) {
  const SceneHistory run = make();
  ASSERT_TRUE(run.complete);
  HistoryCursor cursor(run.scene, run.history, no_initial);
  std::vector<std::vector<Quad>> sights{sight(cursor)};
  std::set<std::size_t> kinds;
  while (cursor.next()) {
    kinds.insert(cursor.event(cursor.position() - 1).index());
    sights.push_back(sight(cursor));
    EXPECT_TRUE(cursor.diagram().diagram().is_valid());
    // The cursor goes there and back at once.
    EXPECT_TRUE(cursor.previous());
    EXPECT_EQ(sight(cursor), sights[sights.size() - 2]);
    EXPECT_TRUE(cursor.next());
    EXPECT_EQ(sight(cursor), sights.back());
  }
  EXPECT_EQ(kinds.size(), std::variant_size_v<voroproof::internal::Event>);
  EXPECT_EQ(cursor.position(), cursor.size());
  EXPECT_FALSE(cursor.next());
  for (std::size_t k = cursor.size(); k-- > 0;) {
    EXPECT_TRUE(cursor.previous());
    EXPECT_EQ(sight(cursor), sights[k]) << k;
  }
  EXPECT_FALSE(cursor.previous());
}

TEST_F(CursorTest, SeeksByNumberAndTimeAgreeWithTheWayThroughTheFile) {
  const SceneHistory run = make();
  HistoryCursor cursor(run.scene, run.history, no_initial);
  const Paths paths(run.scene, cursor, run.history);
  ASSERT_GT(cursor.size(), 40u);
  for (const std::size_t k : {31u, 7u, 40u, 0u, 12u}) {
    const Rational t = exact_time(cursor.event(k));
    cursor.seek(t);
    EXPECT_GT(cursor.position(), k);
    const RecordedMoment moment =
        recorded_moment(run.scene, run.history, t, Move::colliding, true, no_initial);
    const std::vector<Quad> here = sight(cursor);
    EXPECT_EQ(here, moment.diagram->quads());
    for (GenId g = 0; g < static_cast<GenId>(run.scene.disks.size()); ++g) {
      EXPECT_EQ(paths.piece(g, t), (*moment.states)[static_cast<std::size_t>(g)]);
    }
    const std::size_t position = cursor.position();
    cursor.seek(cursor.size());
    cursor.seek(position);
    EXPECT_EQ(sight(cursor), here);
    const Rational before = t - Rational(1, 1000000000);
    cursor.seek(before);
    EXPECT_LE(cursor.position(), k);
  }
  EXPECT_THROW(cursor.seek(cursor.size() + 1), std::out_of_range);
}

TEST_F(CursorTest, AFlipOfNoEdgeNamesItsLine) {
  const SceneHistory run = make();
  std::string bytes = run.directory.read("history");
  const std::size_t flip = bytes.find("\"flip\":[");
  const std::size_t line = 1 + std::count(bytes.begin(), bytes.begin() + flip, '\n');
  bytes.replace(flip, bytes.find(']', flip) - flip, "\"flip\":[0,1,2,3");
  HistoryCursor cursor(run.scene, run.directory.write("wrong", bytes), no_initial);
  try {
    cursor.seek(cursor.size());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.line(), static_cast<std::int64_t>(line));
  }
}

TEST(HistoryCursor, NoDisksAndOne) {
  for (const auto& disks : {std::vector<DiskInput>{}, {disk(0, 0, 1, 3, 0)}}) {
    const SceneHistory run(scene_of(5, 10, disks));
    ASSERT_TRUE(run.complete);
    HistoryCursor cursor(run.scene, run.history, no_initial);
    EXPECT_EQ(cursor.size(), disks.size() * 4);
    cursor.seek(Rational(10));
    EXPECT_EQ(cursor.position(), cursor.size());
    cursor.seek(Rational(0));
    EXPECT_EQ(cursor.position(), 0u);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
