// Scenes and histories of billiards: every faulty one refused with its line and field.
#include <gtest/gtest.h>

#include "history/billiard.h"
#include "history/billiard_history.h"
#include "history/error.h"
#include "history/validate.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal::testing {
namespace {

const std::string disk = R"({"center":[0,0],"radius":1,"velocity":[1,0]})";

std::string scene(const std::string& members) {
  return R"({"format":"voroproof-scene","version":2,"contacts":"bounce","horizon":4,)" + members +
         "}";
}

std::string fault(const std::string& members) {
  try {
    parse_billiard(scene(members), "a.scene.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(BilliardReader, ReadsAllMembers) {
  const Billiard b =
      parse_billiard(scene(R"("dimension":3,"frame":{"periodic":[5,"13/2",null],"shear":-0.5,
        "walls":[{"normal":[0,0,1],"offset":-3,"speed":0.25,"restitution":0.5}]},
        "restitution":0.75,"gravity":[0,0,-1],"name":"n","comment":"c","seed":12,
        "disks":[{"center":[1,2,0],"radius":1,"velocity":[0,1,2],"growth":0.125,"mass":3},
                 {"center":[3,5,0],"radius":"1/2","fixed":true}],
        "maneuvers":[{"t":1,"disk":0,"velocity":[0,0,0]}])"),
                     "a.scene.json");
  EXPECT_EQ(b.dimension, 3);
  EXPECT_EQ(b.lattice.sides, (Vec3{5, Rational(13, 2), 0}));
  EXPECT_EQ(b.lattice.shear, Rational(-1, 2));
  ASSERT_EQ(b.walls.size(), 1U);
  EXPECT_EQ(b.walls[0].normal, (Vec3{0, 0, 1}));
  EXPECT_EQ(b.walls[0].offset, -3);
  EXPECT_EQ(b.walls[0].speed, Rational(1, 4));
  EXPECT_EQ(b.walls[0].restitution, Rational(1, 2));
  EXPECT_EQ(b.restitution, Rational(3, 4));
  EXPECT_EQ(b.gravity, (Vec3{0, 0, -1}));
  ASSERT_EQ(b.disks.size(), 2U);
  EXPECT_EQ(b.disks[0].mass, 3);
  EXPECT_EQ(b.disks[0].growth, Rational(1, 8));
  EXPECT_TRUE(b.disks[1].fixed);
  EXPECT_EQ(b.maneuvers.size(), 1U);
  EXPECT_EQ(b.last_wall(), -1);
}

// Whatever comes before the two fields that say so.
TEST(BilliardReader, IsTold) {
  const TemporaryDirectory folder;
  const std::string members = R"("frame":"none","disks":[])";
  EXPECT_TRUE(is_billiard_file(folder.write("a.json", scene(members))));
  const std::string name = R"({"name":")" + std::string(5000, 'x') + R"(",)";
  EXPECT_TRUE(is_billiard_file(folder.write("b.json", name + scene(members).substr(1))));
  EXPECT_FALSE(is_billiard_file(folder.write("c.json", "{}")));
  EXPECT_FALSE(is_billiard_file(folder.file("none.json")));
}

TEST(BilliardReader, RefusesFaultyScenes) {
  const std::string disks = R"("disks":[)" + disk + "]";
  const struct {
    std::string members, words;
  } cases[] = {
      {disks, "a.scene.json:1: frame: missing"},
      {R"("frame":"none")", "a.scene.json:1: disks: missing"},
      {R"("frame":"box",)" + disks, R"(frame: neither "none" nor an object)"},
      {R"("frame":{},)" + disks, "frame: neither round"},
      {R"("frame":{"center":[0,0]},)" + disks, "frame.radius: missing"},
      {R"("frame":{"center":[0,0],"radius":9,"walls":[]},)" + disks,
       "frame.center: a frame is round"},
      {R"("frame":{"walls":[{"normal":[1,1],"offset":0}]},)" + disks,
       "frame.walls[0].normal: its length is not exactly 1"},
      {R"("frame":{"walls":[{"normal":[1,0],"offset":0,"restitution":0}]},)" + disks,
       "frame.walls[0].restitution: not in (0, 1]"},
      {R"("frame":{"center":[0,0],"radius":0.5},)" + disks,
       "disks[0].radius: the disk does not fit into the frame"},
      {R"("frame":{"periodic":[5,null],"walls":[{"normal":[1,0],"offset":-5}]},)" + disks,
       "frame.walls: a wall lies across an axis that is periodic"},
      {R"("frame":{"periodic":[0,5]},)" + disks, "frame.periodic[0]: not positive"},
      {R"("frame":{"periodic":[5,null],"shear":1},)" + disks, "frame.shear: the first two axes"},
      {R"("frame":{"periodic":[2,5]},)" + disks, "disks[0].radius: the disk reaches its own image"},
      {R"("frame":{"periodic":[5,5,5]},)" + disks, "other than 3 coordinates"},
      {R"("frame":"none","dimension":3,)" + disks, "has 2 coordinates, and \"dimension\" is 3"},
      {R"("frame":"none","gravity":[1],)" + disks, "gravity: fewer than two coordinates"},
      {R"("frame":"none","restitution":1.5,)" + disks, "restitution: not in [0, 1]"},
      {R"("frame":"none","disks":[{"center":[0,0],"radius":1}])", "disks[0].velocity: missing"},
      {R"("frame":"none","disks":[{"center":[0,0],"radius":1,"fixed":1}])",
       "disks[0].fixed: expected true or false"},
      {R"("frame":"none","disks":[{"center":[0,0],"radius":1,"fixed":true,"velocity":[1,0]}])",
       "disks[0].velocity: a fixed disk has none"},
      {R"("frame":"none","disks":[)" + disk + R"(,{"center":[9,0],"radius":0,"velocity":[0,0]}])",
       "disks[1].mass: missing for a point"},
      {R"("frame":"none","disks":[{"center":[0,0],"radius":1,"velocity":[0,0],"growth":-1}])",
       "disks[0].growth: the radius becomes negative"},
      {R"("frame":"none",)" + disks + R"(,"maneuvers":[{"t":1,"disk":1,"velocity":[0,0]}])",
       "maneuvers[0].disk: no such disk"},
      {R"("frame":"none","container":{},)" + disks, "container: unknown field"},
  };
  for (const auto& [members, words] : cases) {
    EXPECT_NE(fault(members).find(words), std::string::npos) << members << "\n" << fault(members);
  }
}

std::string history_fault(const std::string& line) {
  const TemporaryDirectory folder;
  const std::string scene_file = folder.write(
      "a.scene.json", scene(R"("frame":{"periodic":[9,null],"walls":[{"normal":[0,1],"offset":-5}]},
        "disks":[)" + disk + R"(,{"center":[4,0],"radius":1,"fixed":true}])"));
  const Billiard billiard = read_billiard(scene_file);
  const std::string file = folder.write(
      "a.history.jsonl", R"({"format":"voroproof-history","version":2,"scene_sha256":")" +
                             billiard.sha256 + R"(","horizon":4,"producer":"test"})" + "\n" + line +
                             "\n" + R"({"end":{"t":4,"collisions":1,"maneuvers":0,"flips":0}})");
  try {
    BilliardHistoryReader history(file, &billiard);
    while (history.next()) {
    }
  } catch (const InputError& error) {
    const std::string what = error.what();
    return what.substr(what.find("jsonl") + 5);
  }
  return validate_file(file);
}

TEST(BilliardReader, RefusesFaultyLines) {
  const struct {
    std::string line, words;
  } cases[] = {
      {R"({"t":1,"collide":[0,1],"image":[-1,0],"v":[[0,0],null]})",
       "history of a billiard: 0 flips, 1 collision, 0 maneuvers, complete to t = 4"},
      {R"({"t":1,"collide":[-1,0],"v":[null,[0,0]]})", "1 collision"},
      {R"({"collide":[-1,0]})", ":2: t: missing"},
      {R"({"t":1})", ":2: neither an event nor an end line"},
      {R"({"t":1,"flip":[0,1,-1,2]})", ":2: flip: unknown field"},
      {R"({"t":1,"collide":[1,0]})", ":2: collide: not two ids, the smaller first"},
      {R"({"t":1,"collide":[-2,0]})", ":2: collide[0]: not in [-1, 1]"},
      {R"({"t":1,"collide":[0,2]})", ":2: collide[1]: not in [-1, 1]"},
      {R"({"t":1,"collide":[0,1],"image":[0,1]})", ":2: image[1]: the axis is not periodic"},
      {R"({"t":1,"collide":[-1,0],"image":[1,0]})", ":2: image: a wall has no images"},
      {R"({"t":1,"collide":[0,1],"image":[1]})", ":2: image: not 2 coordinates"},
      {R"({"t":1,"collide":[0,1],"v":[0,0]})", ":2: v: not one of each of two"},
      {R"({"t":1,"collide":[0,1],"v":[null,[0,0]]})", ":2: v: null for a disk"},
      {R"({"t":1,"collide":[-1,0],"v":[[0,0],[0,0]]})", ":2: v: not null for a wall"},
      {R"({"t":1,"collide":[0,1],"v":[[0,0,0],null]})", ":2: v[0]: not 2 coordinates"},
      {R"({"t":1,"maneuver":0,"image":[0,0]})", ":2: image: no field"},
      {R"({"t":1,"maneuver":0,"v":[[0,0],[0,0]]})", ":2: v: not one velocity"},
      {R"({"t":5,"collide":[0,1]})", ":2: t: beyond the horizon"},
      {R"({"t":1,"collide":[0,1],"maneuver":0})", ":2: more than one event"},
  };
  for (const auto& [line, words] : cases) {
    EXPECT_NE(history_fault(line).find(words), std::string::npos) << line << "\n"
                                                                  << history_fault(line);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
