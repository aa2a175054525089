// Recorded paths: those of the certifier, whatever centres a history claims.
#include "library/queries/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "certify/replay.h"
#include "exact/topology/diagram.h"
#include "history/error.h"
#include "history/history_reader.h"
#include "tests/queries/watched.h"

namespace voroproof::internal::testing {
namespace {

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), by);
}

TEST(Paths, AreThoseOfTheCertifier) {
  int turns = 0;
  for (const unsigned seed : {1u, 2u}) {
    const Watched w(crowd(7, seed));
    CertifyOptions options;
    options.truth = Truth::recorded;
    Replay replay(w.run.scene, options);
    HistoryReader history(w.run.history, w.size());
    replay.diagram() = diagram_of(w.size(), *history.header().initial);
    while (const auto event = history.next()) {
      if (std::holds_alternative<FlipEvent>(*event)) continue;
      replay.take(*event);
      ++turns;
      const Rational t = exact_time(*event);
      for (GenId g = 0; g < w.size(); ++g) {
        EXPECT_EQ(position_at(w.paths.piece(g, t), t), replay.path(g).at(t)) << seed << ' ' << g;
      }
    }
  }
  EXPECT_GT(turns, 20);
}

std::set<GivenContact> claims(const Watched& w) {
  std::set<GivenContact> all;
  for (std::size_t k = 0; k < w.cursor.size(); ++k) {
    if (const auto* c = std::get_if<CollideEvent>(&w.cursor.event(k))) {
      all.insert({c->i, c->j, std::min(exact_time(*c), w.run.scene.horizon)});
    }
  }
  return all;
}

// Rounded times and velocities move the paths, the more the later: two rest up to a time that is
// long for the container. The last collision is at a horizon that is no binary64.
TEST(Paths, TouchAtCollisionsOfRightHistories) {
  std::vector<Scene> scenes;
  for (const unsigned seed : {1u, 2u, 3u, 4u}) scenes.push_back(crowd(9, seed));
  const Rational late(1'000'000'000), third(1, 3);
  scenes.push_back(scene_of(10, late + 60, {disk(-4, 0, 1, 0, 0), disk(4, third, 1, 0, 0)}));
  scenes.back().maneuvers = {{late + Rational(1, 7), 0, Rational(9, 7), third}};
  scenes.push_back(scene_of(10, 9 * third, {disk(0, 0, 1, 3, 0)}));
  scenes.push_back(scene_of(10, 10 * third, {disk(-1, 0, 1, 3, 0)}));
  for (const Scene& scene : scenes) {
    const Watched w(scene);
    ASSERT_TRUE(w.run.complete);
    const std::set<GivenContact> right = claims(w);
    EXPECT_FALSE(right.empty());
    EXPECT_EQ(w.paths.contacts().size(), right.size());
    for (const GivenContact& c : right) {
      EXPECT_TRUE(w.paths.contacts().contains(c)) << c.i << ' ' << c.j << " at " << c.t.get_d();
    }
  }
}

// A disk of radius 1 that reaches the wall of a container of radius 10 at t = 9, and turns at 10.
constexpr const char* kScene = R"({"format":"voroproof-scene","version":1,
  "container":{"center":[0,0],"radius":10},"horizon":12,"disks":[
  {"center":[0,0],"radius":1,"velocity":[1,0]}],
  "maneuvers":[{"t":10,"disk":0,"velocity":[0,"1/3"]}]})";

class PathsOfOne : public ::testing::Test {
 protected:
  Paths paths(const std::string& collision, const std::string& maneuver) {
    scene_ = read_scene(directory_.write("scene", kScene));
    const std::string name = directory_.write(
        "history", R"({"format":"voroproof-history","version":1,"scene_sha256":")" + scene_.sha256 +
                       R"(","horizon":12,"producer":"a test","initial":[]})"
                       "\n" +
                       collision + "\n" + maneuver +
                       "\n{\"end\":{\"t\":12,\"flips\":0,\"collisions\":1,\"maneuvers\":1}}\n");
    return Paths(scene_, HistoryCursor(scene_, name, no_initial), name);
  }
  ExactVec2 at(const Paths& paths, const Rational& t) { return position_at(paths.piece(0, t), t); }

  TemporaryDirectory directory_;
  Scene scene_;
};

TEST_F(PathsOfOne, GoOnWhereTheyAre) {
  const std::string collision = R"({"t":9,"collide":[-1,0],"v":[null,[-1,0]],"p":[null,[9,0]]})";
  const std::string maneuver = R"({"t":10,"maneuver":0,"v":[0,0.25],"p":[8,0]})";
  const Paths right = paths(collision, maneuver);
  EXPECT_EQ(at(right, 10), (ExactVec2{8, 0}));
  // The velocity that is claimed, and not the one that is scheduled.
  EXPECT_EQ(at(right, 12), (ExactVec2{8, Rational(1, 2)}));
  for (const Paths& other : {paths(replaced(collision, "[9,0]", "[9.0000004,0]"), maneuver),
                             paths(replaced(collision, R"(,"p":[null,[9,0]])", ""), maneuver)}) {
    EXPECT_EQ(other.pieces(0), right.pieces(0));
  }
  // At the time that is claimed.
  const Paths late = paths(collision, replaced(maneuver, "10", "10.5"));
  EXPECT_EQ(at(late, Rational(21, 2)), (ExactVec2{Rational(15, 2), 0}));
  EXPECT_EQ(at(paths(collision, R"({"t":10,"maneuver":0})"), 11), (ExactVec2{8, Rational(1, 3)}));
}

TEST_F(PathsOfOne, TouchButForRoundings) {
  const auto touch_at = [&](const std::string& t) {
    const std::string claim = R"({"t":)" + t + R"(,"collide":[-1,0],"v":[null,[-1,0]]})";
    return !paths(claim, R"({"t":10,"maneuver":0})").contacts().empty();
  };
  for (const char* t : {"9", "9.000000000000002", "8.999999999999998"}) EXPECT_TRUE(touch_at(t));
  for (const char* t : {"8", "9.0000000000001", "8.9999999999999"}) EXPECT_FALSE(touch_at(t));
}

TEST_F(PathsOfOne, NeedVelocities) {
  EXPECT_THROW(paths(R"({"t":9,"collide":[-1,0]})", R"({"t":10,"maneuver":0,"v":[0,0.25]})"),
               InputError);
}

}  // namespace
}  // namespace voroproof::internal::testing
