// Worlds as they are read and written: values, paths, and that every faulty one is refused with its
// line and field.
#include <gtest/gtest.h>

#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "history/error.h"
#include "history/scene.h"
#include "history/sha256.h"
#include "history/world.h"
#include "history/world_writer.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal::testing {
namespace {

// One field a line.
const std::vector<std::string> good_world = {
    R"({"format": "voroproof-scene",)",                                             // 1
    R"( "version": 2,)",                                                            // 2
    R"( "horizon": 600,)",                                                          // 3
    R"( "contacts": "pass",)",                                                      // 4
    R"( "frame": {"center": [0, "1/3"], "radius": 1000, "growth": -1},)",           // 5
    R"( "disks": [)",                                                               // 6
    R"(  {"center": [0, 0], "radius": 50, "growth": "1/4", "velocity": [7, 0]},)",  // 7
    R"(  {"center": [9, -4], "radius": 30, "velocity": [-5, 1], "enter": 12.5, "leave": 480},)",  // 8
    R"(  {"center": [0, 0], "radius": 0, "velocity": [0, 0], "enter": 700}],)",                // 9
    R"( "maneuvers": [)",                                                                      // 10
    R"(  {"t": 0, "disk": 0, "velocity": [6, 0]},)",                                           // 11
    R"(  {"t": 60, "disk": 0, "center": [423, -2], "radius": 50, "velocity": [7.5, 0.25]},)",  // 12
    R"(  {"t": 90, "disk": 1, "growth": "-1/13"},)",                                           // 13
    R"(  {"t": 650, "disk": 0, "velocity": [0, 0]}]})",                                        // 14
};

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

World parse(const std::string& text) { return parse_world(text, "w.json"); }

std::string fault(const std::string& text) {
  try {
    parse(text);
    return "";
  } catch (const InputError& e) {
    return e.what();
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string written(const World& world) {
  std::ostringstream out;
  write_world(out, world);
  return out.str();
}

void expect_state(const GrowingDisk& state, const std::vector<Rational>& values) {
  EXPECT_EQ(
      (std::vector<Rational>{state.x, state.y, state.radius, state.vx, state.vy, state.growth}),
      values);
}

TEST(World, ReadsAllFields) {
  const std::string text = joined(good_world);
  const World world = parse(text);
  EXPECT_EQ(world.horizon, 600);
  ASSERT_TRUE(world.circle);
  EXPECT_EQ(world.circle->center.y, Rational(1, 3));
  EXPECT_EQ(world.circle->radius, 1000);
  EXPECT_EQ(world.circle->growth, -1);
  ASSERT_EQ(world.disks.size(), 3u);
  expect_state(world.disks[0].state, {0, 0, 50, 7, 0, Rational(1, 4)});
  EXPECT_EQ(world.disks[0].enter, 0);
  EXPECT_FALSE(world.disks[0].leave);
  expect_state(world.disks[1].state, {9, -4, 30, -5, 1, 0});
  EXPECT_EQ(world.disks[1].enter, Rational(25, 2));
  EXPECT_EQ(world.disks[1].leave, 480);
  ASSERT_EQ(world.maneuvers.size(), 4u);
  EXPECT_FALSE(world.maneuvers[0].is_jump());
  EXPECT_TRUE(world.maneuvers[1].is_jump());
  EXPECT_EQ(world.maneuvers[1].t, 60);
  EXPECT_EQ(world.maneuvers[1].center->x, 423);
  EXPECT_EQ(world.maneuvers[1].radius, 50);
  EXPECT_EQ(world.maneuvers[1].velocity->y, Rational(1, 4));
  EXPECT_FALSE(world.maneuvers[1].growth);
  EXPECT_EQ(world.maneuvers[2].disk, 1);
  EXPECT_EQ(world.maneuvers[2].growth, Rational(-1, 13));
  EXPECT_EQ(world.sha256, sha256_hex(text));
}

TEST(World, FrameIsNoneOrAContainer) {
  const std::string frame = R"("frame": {"center": [0, "1/3"], "radius": 1000, "growth": -1})";
  EXPECT_FALSE(parse(replaced(joined(good_world), frame, R"("frame": "none")")).circle);
  const World held = parse(
      replaced(joined(good_world), frame, R"("container": {"center": [1, 2], "radius": "1/7"})"));
  EXPECT_EQ(held.circle->center.x, 1);
  EXPECT_EQ(held.circle->radius, Rational(1, 7));
  EXPECT_EQ(held.circle->growth, 0);
}

// Disks may overlap, hold each other and be equal, and lie outside the frame.
TEST(World, SaysWhoIsMissing) {
  const std::string horizon = R"("horizon": 600,)";
  const World world =
      parse(replaced(joined(good_world), horizon, horizon + R"( "missing": ["a \"b\"", "c"],)"));
  EXPECT_EQ(world.missing, (std::vector<std::string>{"a \"b\"", "c"}));
  EXPECT_EQ(parse(written(world)).missing, world.missing);
  EXPECT_EQ(fault(replaced(joined(good_world), horizon, horizon + R"( "missing": [1],)")),
            "w.json:3: missing[0]: expected a string, found '1'");
}

TEST(World, NeedsNoRoomBetweenDisks) {
  const World world = parse(
      R"({"x-a": [ 1 ], "disks": [{"center": [0, 0], "radius": 3, "velocity": [0, 0]},
          {"center": [0, 0], "radius": 3, "velocity": [0, 0], "x-b": "c"},
          {"center": [9, 0], "radius": 0, "velocity": [0, 0]}], "seed": "s", "comment": "c",
          "name": "n", "container": {"radius": 2, "center": [0, 0]}, "contacts": "pass",
          "horizon": 0, "version": 2, "format": "voroproof-scene"})");
  EXPECT_EQ(world.disks.size(), 3u);
  EXPECT_EQ(world.extensions.at("x-a"), "[1]");
  EXPECT_EQ(world.disk_extensions.at(1).at("x-b"), "\"c\"");
  EXPECT_EQ(world.name + world.comment + std::get<std::string>(*world.seed), "ncs");
}

TEST(World, IsWrittenInOneForm) {
  const std::string text = joined(good_world);
  World world = parse(text);
  world.name = "a \"world\"";
  world.seed = Integer(7);
  world.extensions["x-a"] = "1";
  world.disk_extensions[1]["x-b"] = "2";
  world.maneuver_extensions[3]["x-c"] = "3";
  EXPECT_EQ(written(world), R"({"format": "voroproof-scene", "version": 2,
 "name": "a \"world\"",
 "seed": 7,
 "horizon": 600,
 "contacts": "pass",
 "frame": {"center": [0, "1/3"], "radius": 1000, "growth": -1},
 "disks": [
  {"center": [0, 0], "radius": 50, "growth": 0.25, "velocity": [7, 0]},
  {"center": [9, -4], "radius": 30, "velocity": [-5, 1], "enter": 12.5, "leave": 480, "x-b": 2},
  {"center": [0, 0], "radius": 0, "velocity": [0, 0], "enter": 700}],
 "maneuvers": [
  {"t": 0, "disk": 0, "velocity": [6, 0]},
  {"t": 60, "disk": 0, "center": [423, -2], "radius": 50, "velocity": [7.5, 0.25]},
  {"t": 90, "disk": 1, "growth": "-1/13"},
  {"t": 650, "disk": 0, "velocity": [0, 0], "x-c": 3}],
 "x-a": 1}
)");
  EXPECT_EQ(written(parse(written(world))), written(world));
  world.circle.reset();
  world.disks.clear();
  world.maneuvers.clear();
  const std::string empty = written(parse(replaced(
      replaced(written(world), "\"disks\": [],\n \"x-a\": 1", "\"disks\": []"), "7", "\"7\"")));
  EXPECT_NE(empty.find("\"frame\": \"none\",\n \"disks\": []}\n"), std::string::npos) << empty;
}

TEST(World, IsKnownByItsBeginning) {
  TemporaryDirectory directory;
  write_world(directory.file("w"), parse(joined(good_world)));
  EXPECT_TRUE(is_world_file(directory.file("w")));
  EXPECT_EQ(read_world(directory.file("w")).disks.size(), 3u);
  const auto known = [&](const std::string& text) {
    return is_world_file(directory.write("f", text));
  };
  EXPECT_TRUE(known(R"({"version":2,"x":[],"format":"voroproof-scene", and so on)"));
  EXPECT_FALSE(known(R"({"version":1,"format":"voroproof-scene"})"));
  EXPECT_FALSE(known(R"({"version":2,"format":"voroproof-history"})"));
  EXPECT_FALSE(known(R"({"version":"2","format":"voroproof-scene"})"));
  EXPECT_FALSE(known(R"({"format":"voroproof-scene"})"));
  EXPECT_FALSE(known("2\n1 0 0 1"));
  EXPECT_FALSE(is_world_file(directory.file("absent")));
}

TEST(World, ReaderOfScenesRefusesIt) {
  EXPECT_THROW(parse_scene(joined(good_world), "w.json"), InputError);
}

void expect_piece(const WorldPiece& piece, PieceStart start, const Rational& from,
                  const std::optional<Rational>& to, const std::vector<Rational>& state) {
  EXPECT_EQ(piece.start, start);
  EXPECT_EQ(piece.from, from);
  EXPECT_EQ(piece.to, to);
  expect_state(piece.state, state);
}

TEST(WorldPath, HasAPieceForEachManeuver) {
  const World world = parse(joined(good_world));
  const Rational quarter(1, 4);
  const std::vector<WorldPiece> first = world.motion().paths[0];
  ASSERT_EQ(first.size(), 3u);
  // The maneuver at 0 leaves nothing of the piece before it.
  expect_piece(first[0], PieceStart::enters, 0, 0, {0, 0, 50, 7, 0, quarter});
  expect_piece(first[1], PieceStart::turns, 0, 60, {0, 0, 50, 6, 0, quarter});
  expect_piece(first[2], PieceStart::jumps, 60, std::nullopt,
               {423, -2, 50, Rational(15, 2), quarter, quarter});
  const std::vector<WorldPiece> second = world.motion().paths[1];
  ASSERT_EQ(second.size(), 2u);
  expect_piece(second[0], PieceStart::enters, Rational(25, 2), 90, {9, -4, 30, -5, 1, 0});
  expect_piece(second[1], PieceStart::turns, 90, 480,
               {9 - 5 * Rational(155, 2), -4 + Rational(155, 2), 30, -5, 1, Rational(-1, 13)});
  EXPECT_TRUE(world.motion().paths[2].empty());  // it comes after the horizon
}

TEST(WorldPath, EndsWithTheHorizon) {
  World world = parse(joined(good_world));
  world.horizon = 480;
  EXPECT_EQ(world.motion().paths[1].back().to, 480);
  world.horizon = 479;
  EXPECT_EQ(world.motion().paths[1].back().to, std::nullopt);
  world.horizon = 60;
  EXPECT_EQ(world.motion().paths[0].size(), 3u);
  EXPECT_EQ(world.motion().paths[0][1].to, 60);
  EXPECT_EQ(world.motion().paths[1].size(), 1u);
  world.horizon = Rational(25, 2);
  EXPECT_EQ(world.motion().paths[1].size(), 1u);
  world.horizon = 12;
  EXPECT_TRUE(world.motion().paths[1].empty());
  EXPECT_EQ(world.motion().paths[0][1].to, std::nullopt);
}

// A radius of 0 at a change or at the end is one.
TEST(World, RadiiMayBecomeZero) {
  const auto last_radius = [](const std::string& growth) {
    return fault(replaced(joined(good_world), "\"-1/13\"", growth));
  };
  EXPECT_EQ(last_radius("\"-1/13\""), "");
  EXPECT_EQ(last_radius("\"-10/129\""),
            "w.json:8: disks[1]: its radius becomes negative before t = 480");
}

struct Bad {
  std::string from, to;  // the change to the example
  std::string message;   // after "w.json:"
};

// What gtest calls the case.
void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.message; }

class BadWorld : public ::testing::TestWithParam<Bad> {};

TEST_P(BadWorld, IsRefusedWithLineAndField) {
  EXPECT_EQ(fault(replaced(joined(good_world), GetParam().from, GetParam().to)),
            "w.json:" + GetParam().message);
}

const std::string only_pass =
    "\"pass\" is wanted here; only simulate, certify, clearance and validate read billiards, whose "
    "disks bounce";
const std::string frame = R"("frame": {"center": [0, "1/3"], "radius": 1000, "growth": -1})";

INSTANTIATE_TEST_SUITE_P(
    Table, BadWorld,
    ::testing::Values(
        Bad{"voroproof-scene", "voroproof-plan", "1: format: not \"voroproof-scene\""},
        Bad{"\"version\": 2", "\"version\": 1", "2: version: not 2"},
        Bad{"\"version\": 2", "\"new\": 1, \"version\": 3",
            "2: version: the file is of version 3; this program reads version 2"},
        Bad{" \"version\": 2,\n", "", "1: version: missing"},
        Bad{" \"horizon\": 600,\n", "", "1: horizon: missing"},
        Bad{"\"horizon\": 600", "\"horizon\": -1", "3: horizon: negative"},
        Bad{"\"horizon\": 600", "\"horizon\": 1e101",
            "3: horizon: beyond the limits of a scene: 0 or 1e-100 to 1e100 in magnitude"},
        Bad{"\"horizon\": 600", "\"horizon\": 600, \"colour\": 1", "3: colour: unknown field"},
        Bad{"\"horizon\": 600", "\"horizon\": 600, \"restitution\": 1",
            "3: restitution: disks that pass do not bounce"},
        Bad{"\"horizon\": 600", "\"horizon\": 600, \"container_law\": \"normal\"",
            "3: container_law: disks that pass do not bounce"},
        Bad{"\"pass\"", "\"bounce\"", "4: contacts: " + only_pass},
        Bad{"\"pass\"", "1", "4: contacts: expected a string, found '1'"},
        Bad{" \"contacts\": \"pass\",\n", "", "1: contacts: missing: " + only_pass},
        Bad{" " + frame + ",\n", "",
            "1: frame: missing: \"none\", or a circle, or \"container\" in its place"},
        Bad{frame, frame + ", \"container\": {\"center\": [0, 0], \"radius\": 1}",
            "5: container: a world has it or a frame, not both"},
        Bad{frame, "\"frame\": \"box\"", "5: frame: neither \"none\" nor a circle"},
        Bad{frame, "\"frame\": {\"walls\": []}", "5: frame.walls: walls are not built yet"},
        Bad{frame, "\"frame\": {\"center\": [0, 0]}", "5: frame.radius: missing"},
        Bad{frame, "\"frame\": 1", "5: frame: expected an object, found '1'"},
        Bad{"1000", "0", "5: frame.radius: not positive"},
        Bad{"1000", "-1", "5: frame.radius: negative"},
        Bad{"1000", "600", "5: frame.growth: the radius is not positive up to the horizon"},
        Bad{"1000", "1000, \"restitution\": 1",
            "5: frame.restitution: disks that pass do not bounce"},
        Bad{"\"frame\"", "\"container\"",
            "5: container.growth: a container does not grow; a frame does"},
        Bad{"[9, -4]", "[9]", "8: disks[1].center: not an array of 2 elements"},
        Bad{"\"radius\": 30", "\"radius\": -30", "8: disks[1].radius: negative"},
        Bad{"\"radius\": 30", "\"radius\": 30, \"mass\": 1",
            "8: disks[1].mass: disks that pass have no mass"},
        Bad{"\"radius\": 30", "\"radius\": 30, \"fixed\": true",
            "8: disks[1].fixed: unknown field"},
        Bad{", \"velocity\": [-5, 1]", "", "8: disks[1].velocity: missing"},
        Bad{"\"enter\": 12.5", "\"enter\": -1", "8: disks[1].enter: negative"},
        Bad{"\"enter\": 12.5", "\"enter\": 480", "8: disks[1].leave: not later than \"enter\""},
        Bad{"\"t\": 60", "\"t\": -1", "12: maneuvers[1].t: negative"},
        Bad{"\"t\": 60", "\"t\": 91", "13: maneuvers[2].t: earlier than the maneuver before it"},
        Bad{"\"t\": 60", "\"t\": 0",
            "12: maneuvers[1].disk: second maneuver of one disk at one time"},
        Bad{"\"disk\": 1", "\"disk\": 3", "13: maneuvers[2].disk: no such disk"},
        Bad{"\"disk\": 1", "\"disk\": 2", "13: maneuvers[2].t: not after the disk enters"},
        Bad{"\"enter\": 12.5", "\"enter\": 90", "13: maneuvers[2].t: not after the disk enters"},
        Bad{"\"leave\": 480", "\"leave\": 90", "13: maneuvers[2].t: the disk has left"},
        Bad{", \"growth\": \"-1/13\"", "",
            "13: maneuvers[2]: changes nothing: it has neither center, radius, velocity nor "
            "growth"},
        Bad{"\"growth\": \"-1/13\"", "\"radius\": -1", "13: maneuvers[2].radius: negative"},
        Bad{"\"growth\": \"-1/13\"", "\"mass\": 1", "13: maneuvers[2].mass: unknown field"},
        // Before the jump that would give it another radius; up to the horizon.
        Bad{"\"growth\": \"1/4\"", "\"growth\": -1",
            "7: disks[0]: its radius becomes negative before t = 60"},
        Bad{"\"growth\": \"1/4\"", "\"growth\": \"-1/10\"",
            "7: disks[0]: its radius becomes negative before t = 600"},
        Bad{"[0, 0]}]}\n", "[0, 0]}]}\n{", "15: expected nothing more, found '{'"}));

}  // namespace
}  // namespace voroproof::internal::testing
