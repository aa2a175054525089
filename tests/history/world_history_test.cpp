// Histories of worlds as they are written and read: each line in its one form, and every faulty one
// refused with its number and field.
#include <gtest/gtest.h>

#include <ostream>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "history/error.h"
#include "history/event_limit.h"
#include "history/sha256.h"
#include "history/validate.h"
#include "history/world_history_reader.h"
#include "history/world_history_writer.h"
#include "tests/history/example_history.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal::testing {
namespace {

// Each kind of line as it is written.
const std::vector<std::string> world_lines = {
    R"({"format":"voroproof-history","version":2,"scene_sha256":")" + hash +
        R"(","horizon":600,"producer":"name version","initial":[[-1,0,1,1],[-1,1,0,0],[0,1,-1,-1]]})",
    R"({"t":0,"flip":[2,9,3,7]})",                                     // 2
    R"({"t":61.25,"hide":[1,0]})",                                     // 3
    R"({"t":"226/3","appear":[1,0],"at":[0,4,-1,2]})",                 // 4
    R"({"t":76,"appear":[1,-1]})",                                     // 5
    R"({"t":80,"swap":[2,5]})",                                        // 6
    R"({"t":81,"maneuver":5})",                                        // 7
    R"({"t":81,"maneuver":5,"v":[1,0],"p":[7,"1/3"],"growth":-0.5})",  // 8
    R"({"t":90,"jump":3,"out":[[2,9,3,7],[6,3],[6,3,3,9,-1,2],[3,9]],"at":[4,8,1,-1],"in":[[1,3,4,8],[6,3]],"p":[1,2],"v":[0,0],"r":50})",  // 9
    R"({"t":91,"jump":3,"out":[[6,3,null],[3,6]]})",         // 10: it goes
    R"({"t":92,"jump":7,"in":[]})",                          // 11: it comes, and is hidden
    R"({"t":93,"jump":7,"out":[],"at":null,"in":[[6,7]]})",  // 12: it becomes visible
    R"({"end":{"t":600,"flips":1,"hides":1,"appears":2,"swaps":1,"jumps":4,"collisions":0,"maneuvers":2}})",
};

struct WorldTold {
  WorldHistoryHeader header;
  std::vector<WorldEvent> events;
  std::vector<std::int64_t> lines;
  std::variant<WorldEnd, WorldStop> ending;
  bool counts_match = false;
  std::string sha256, fault;
};

WorldTold told(const std::string& path, int disk_count = max_disks) {
  WorldTold told;
  try {
    WorldHistoryReader reader(path, disk_count);
    told.header = reader.header();
    while (auto event = reader.next()) {
      told.events.push_back(*event);
      told.lines.push_back(reader.line());
    }
    EXPECT_FALSE(reader.next());
    told.ending = reader.ending();
    told.counts_match = reader.counts_match();
    told.sha256 = reader.content_sha256();
  } catch (const InputError& e) {
    told.fault = std::string(e.what()).substr(path.size() + 1);
  }
  return told;
}

WorldTold told_of(const std::vector<std::string>& lines) {
  TemporaryDirectory directory;
  return told(directory.write("h", joined(lines)), 10);
}

TEST(WorldHistory, ReadsTheExample) {
  const WorldTold t = told_of(world_lines);
  ASSERT_EQ(t.fault, "");
  EXPECT_EQ(t.sha256, sha256_hex(joined(world_lines)));
  EXPECT_EQ(t.header.scene_sha256, hash);
  EXPECT_EQ(t.header.horizon, 600);
  EXPECT_EQ(t.header.producer, "name version");
  EXPECT_EQ(t.header.initial, (std::vector<Quad>{{-1, 0, 1, 1}, {-1, 1, 0, 0}, {0, 1, -1, -1}}));
  ASSERT_EQ(t.events.size(), 11u);
  EXPECT_EQ(t.lines.front(), 2);
  EXPECT_EQ(t.lines.back(), 12);
  EXPECT_EQ(std::get<Quad>(t.events[0].what), (Quad{2, 9, 3, 7}));
  EXPECT_EQ(t.events[1].t, Rational(245, 4));
  EXPECT_EQ(std::get<Hide>(t.events[1].what), (Hide{1, 0}));
  EXPECT_EQ(t.events[2].t, Rational(226, 3));
  EXPECT_EQ(std::get<Appear>(t.events[2].what), (Appear{1, 0, Quad{0, 4, -1, 2}}));
  EXPECT_EQ(std::get<Appear>(t.events[3].what), (Appear{1, -1, std::nullopt}));
  EXPECT_EQ(std::get<Swap>(t.events[4].what), (Swap{2, 5}));
  const auto& turn = std::get<PathTurn>(t.events[6].what);
  EXPECT_EQ(turn.g, 5);
  EXPECT_EQ(turn.velocity->x, 1);
  EXPECT_EQ(turn.center->y, Rational(1, 3));
  EXPECT_EQ(turn.growth, Rational(-1, 2));
  EXPECT_FALSE(std::get<PathTurn>(t.events[5].what).growth);
  EXPECT_EQ(std::get<WorldEnd>(t.ending).counts, (WorldCounts{1, 1, 2, 1, 4, 0, 2}));
  EXPECT_TRUE(t.counts_match);
}

TEST(WorldHistory, ReadsJumps) {
  const WorldTold t = told_of(world_lines);
  ASSERT_EQ(t.events.size(), 11u);
  const auto& both = std::get<Jump>(t.events[7].what);
  EXPECT_EQ(both.g, 3);
  EXPECT_EQ(*both.out, (std::vector<Step>{Quad{2, 9, 3, 7}, Hide{6, 3},
                                          Appear{6, 3, Quad{3, 9, -1, 2}}, Hide{3, 9}}));
  EXPECT_EQ(*both.in,
            (std::vector<Step>{Appear{3, 4, Quad{4, 8, 1, -1}}, Quad{1, 3, 4, 8}, Hide{6, 3}}));
  EXPECT_EQ(both.center->y, 2);
  EXPECT_EQ(both.velocity->x, 0);
  EXPECT_EQ(both.radius, 50);
  const auto& goes = std::get<Jump>(t.events[8].what);
  EXPECT_EQ(*goes.out, (std::vector<Step>{Appear{6, 3, std::nullopt}, Hide{3, 6}}));
  EXPECT_FALSE(goes.in);
  const auto& comes = std::get<Jump>(t.events[9].what);
  EXPECT_FALSE(comes.out);
  EXPECT_TRUE(comes.in->empty());
  const auto& shown = std::get<Jump>(t.events[10].what);
  EXPECT_TRUE(shown.out->empty());
  EXPECT_EQ(*shown.in, (std::vector<Step>{Appear{7, container_id, std::nullopt}, Hide{6, 7}}));
}

// Writes what was read of the file.
std::string rewritten(const TemporaryDirectory& directory, const WorldTold& t) {
  WorldHistoryWriter writer(directory.file("out"));
  writer.header(t.header);
  for (const WorldEvent& event : t.events) writer.write(event);
  if (const auto* stop = std::get_if<WorldStop>(&t.ending))
    writer.stopped(stop->t, stop->reason);
  else
    writer.end();
  writer.close();
  return directory.read("out");
}

TEST(WorldHistory, IsWrittenInOneForm) {
  TemporaryDirectory directory;
  EXPECT_EQ(rewritten(directory, told_of(world_lines)), joined(world_lines));
  std::vector<std::string> loose = world_lines;
  loose[0].replace(loose[0].find("[[-1,0,1,1],[-1,1,0,0]"), 22, "[[1,-1,0,0],[-1,0,1,1]");
  loose[1] = R"( { "flip" : [9, 2, 7, 3], "x-a": {}, "t" : 0 } )";
  loose[8].replace(loose[8].find("[2,9,3,7]"), 9, "[9,2,7,3]");
  EXPECT_EQ(rewritten(directory, told_of(loose)), joined(world_lines));
  const std::vector<std::string> stopped = {world_lines[0], world_lines[1],
                                            R"({"stopped":{"t":"1/3","reason":"a \"tie\""}})"};
  EXPECT_EQ(rewritten(directory, told_of(stopped)), joined(stopped));
}

// The initial diagram has it done.
TEST(WorldHistory, JumpAtTheStartNeedsNoSteps) {
  TemporaryDirectory directory;
  const std::vector<std::string> lines = {
      world_lines[0], R"({"t":0,"jump":3,"p":[1,2]})",
      R"({"end":{"t":600,"flips":0,"hides":0,"appears":0,"swaps":0,"jumps":1,"collisions":0,"maneuvers":0}})"};
  const WorldTold t = told_of(lines);
  ASSERT_EQ(t.fault, "");
  EXPECT_FALSE(std::get<Jump>(t.events[0].what).out);
  EXPECT_FALSE(std::get<Jump>(t.events[0].what).in);
  EXPECT_EQ(rewritten(directory, t), joined(lines));
}

// The bytes at an appear tell the host first, though the other name may be the smaller.
TEST(WorldHistory, KeepsTheHostFirst) {
  TemporaryDirectory directory;
  std::vector<std::string> lines = world_lines;
  lines[3] = R"({"t":"226/3","appear":[1,4],"at":[4,0,2,-1]})";
  const WorldTold t = told_of(lines);
  EXPECT_EQ(std::get<Appear>(t.events[2].what), (Appear{1, 4, Quad{4, 0, 2, -1}}));
  EXPECT_EQ(rewritten(directory, t), joined(lines));
}

TEST(WorldHistory, WriterRefusesWhatIsNoHistory) {
  TemporaryDirectory directory;
  WorldHistoryWriter writer(directory.file("h"));
  EXPECT_THROW(writer.write({0, Hide{1, 0}}), std::logic_error);
  writer.header({hash, 10, "p", {}});
  writer.write({1, Hide{1, 0}});
  EXPECT_THROW(writer.write({Rational(1, 2), Hide{1, 0}}), std::logic_error);
  EXPECT_THROW(writer.write({1, Quad{0, 0, 1, 2}}), std::logic_error);
  EXPECT_THROW(writer.write({1, Hide{-1, 0}}), std::logic_error);
  EXPECT_THROW(writer.write({1, Appear{2, 0, Quad{1, 0, 3, 4}}}), std::logic_error);
  EXPECT_THROW(writer.write({1, Swap{2, 1}}), std::logic_error);
  EXPECT_THROW(writer.write({1, PathTurn{-1, {}, {}, {}}}), std::logic_error);
  EXPECT_THROW(writer.write({1, Jump{2, {}, {}, {}, {}, {}}}), std::logic_error);
  EXPECT_THROW(writer.write({1, Jump{2, {}, std::vector<Step>{Hide{3, 2}}, {}, {}, {}}}),
               std::logic_error);
  EXPECT_THROW(writer.close(), std::logic_error);
  EXPECT_EQ(writer.counts(), (WorldCounts{0, 1, 0, 0, 0, 0, 0}));
  writer.end();
  EXPECT_THROW(writer.end(), std::logic_error);
  EXPECT_EQ(directory.read("h"), "");  // it has no name yet
  writer.close();
  EXPECT_EQ(validate_file(directory.file("h")),
            "history of a world: 0 flips, 1 hide, 0 appears, 0 swaps, 0 jumps, 0 maneuvers, "
            "complete to t = 10");
}

TEST(WorldHistory, StoppedOneDoesNotReplaceACompleteOne) {
  TemporaryDirectory directory;
  const auto write = [&](bool complete) {
    WorldHistoryWriter writer(directory.file("h"));
    writer.header({hash, 10, "p", {}});
    complete ? writer.end() : writer.stopped(5, "a tie");
    return writer.close_beside_complete();
  };
  EXPECT_EQ(write(false), directory.file("h"));
  EXPECT_EQ(write(true), directory.file("h"));
  EXPECT_EQ(write(false), directory.file("h.partial"));
  EXPECT_EQ(validate_file(directory.file("h.partial")),
            "history of a world: 0 flips, 0 hides, 0 appears, 0 swaps, 0 jumps, 0 maneuvers, "
            "stopped at t = 5: a tie");
}

TEST(WorldHistory, IsOfOneWorld) {
  TemporaryDirectory directory;
  const std::string path = directory.write("h", joined(world_lines));
  EXPECT_NO_THROW(WorldHistoryReader(path, 10, hash));
  EXPECT_THROW(WorldHistoryReader(path, 10, std::string(64, 'c')), InputError);
  EXPECT_THROW((HistoryReader(path, 10)), InputError);
}

TEST(WorldHistory, EventsAreLimited) {
  TemporaryDirectory directory;
  const std::string path = directory.write("h", joined(world_lines));
  const EventLimit limit(3);
  EXPECT_THROW(told(path), EventLimitReached);
}

TEST(WorldHistory, ValidateSaysHowMany) {
  TemporaryDirectory directory;
  EXPECT_EQ(validate_file(directory.write("h", joined(world_lines))),
            "history of a world: 1 flip, 1 hide, 2 appears, 1 swap, 4 jumps, 2 maneuvers, "
            "complete to t = 600");
  EXPECT_EQ(validate_file(directory.write(
                "w", R"({"format":"voroproof-scene","version":2,"contacts":"pass","horizon":"1/3",)"
                     R"("frame":"none","disks":[]})")),
            "world: 0 disks, 0 maneuvers, horizon \"1/3\"");
  std::vector<std::string> lines = world_lines;
  lines.erase(lines.begin() + 1);
  EXPECT_THROW(validate_file(directory.write("h", joined(lines))), InputError);
}

struct Bad {
  std::size_t line;  // of the example, from 1
  std::string text;  // that replaces it
  std::string message;
};

// What gtest calls the case.
void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.message; }

class BadWorldHistory : public ::testing::TestWithParam<Bad> {};

TEST_P(BadWorldHistory, IsRefusedWithLineAndField) {
  std::vector<std::string> lines = world_lines;
  lines[GetParam().line - 1] = GetParam().text;
  EXPECT_EQ(told_of(lines).fault, GetParam().message);
}

std::string header(const std::string& from, const std::string& to) {
  std::string text = world_lines[0];
  return text.replace(text.find(from), from.size(), to);
}

const std::string not_distinct = "names no edge: its generators are not distinct";

INSTANTIATE_TEST_SUITE_P(
    Table, BadWorldHistory,
    ::testing::Values(
        Bad{1, header("history", "scene"), "1: format: not \"voroproof-history\""},
        Bad{1, header("\"version\":2", "\"version\":1"), "1: version: not 2"},
        Bad{1, header("\"version\":2", "\"version\":3"),
            "1: version: the file is of version 3; this program reads version 2"},
        Bad{1, header("aaa", "xaa"), "1: scene_sha256: not 64 hexadecimal digits"},
        Bad{1, header("[-1,0,1,1]", "[1,-1,0,0]"), "1: initial: names an edge twice"},
        Bad{1, header(R"(,"initial":[[-1,0,1,1],[-1,1,0,0],[0,1,-1,-1]])", ""),
            "1: initial: missing"},
        Bad{2, R"({"t":0,"flip":[2,9,3,10]})", "2: flip[3]: not in [-1, 9]"},
        Bad{2, R"({"t":0,"flip":[2,2,3,7]})", "2: flip: " + not_distinct},
        Bad{2, R"({"flip":[2,9,3,7]})", "2: t: missing"},
        Bad{2, R"({"t":-1,"flip":[2,9,3,7]})", "2: t: negative"},
        Bad{2, R"({"t":601,"flip":[2,9,3,7]})", "2: t: beyond the horizon"},
        Bad{2, R"({"t":62,"flip":[2,9,3,7]})", "3: t: earlier than the event before it"},
        Bad{2, R"({"t":0,"collide":[2,9]})", "2: collide: unknown field"},
        Bad{2, R"({"t":0})", "2: neither an event nor an end line"},
        Bad{2, R"({"t":0,"flip":[2,9,3,7],"swap":[2,5]})", "2: more than one event"},
        Bad{2, R"({"t":0,"flip":[2,9,3,7],"v":[2,5]})", "2: v: no field of a line with \"flip\""},
        Bad{3, R"({"t":61,"hide":[-1,0]})", "3: hide: only disks are hidden"},
        Bad{3, R"({"t":61,"hide":[1,1]})", "3: hide: a disk is not its own host"},
        Bad{3, R"({"t":61,"hide":[1,0,2]})", "3: hide: not an array of 2 elements"},
        Bad{3, R"({"t":61,"hide":[1,0],"at":[0,4,-1,2]})",
            "3: at: no field of a line with \"hide\""},
        Bad{4, R"({"t":75,"appear":[-1,0]})", "4: appear: only disks appear"},
        Bad{4, R"({"t":75,"appear":[1,1]})", "4: appear: a disk is not its own host"},
        Bad{4, R"({"t":75,"appear":[1,4],"at":[0,4,-1,2]})",
            "4: at: the host is not the first generator of the edge"},
        Bad{4, R"({"t":75,"appear":[1,0],"at":[0,4,1,2]})",
            "4: at: the edge is one of the disk itself"},
        Bad{4, R"({"t":75,"appear":[1,0],"at":[0,4,4,2]})", "4: at: " + not_distinct},
        Bad{4, R"({"t":75,"appear":[1,0],"at":null})",
            "4: at: null: where there is none, it is left out"},
        Bad{6, R"({"t":80,"swap":[5,2]})", "6: swap: not two ids of disks, the smaller first"},
        Bad{6, R"({"t":80,"swap":[-1,2]})", "6: swap: not two ids of disks, the smaller first"},
        Bad{7, R"({"t":81,"maneuver":-1})", "7: maneuver: not in [0, 9]"},
        Bad{7, R"({"t":81,"maneuver":1,"r":1})", "7: r: no field of a line with \"maneuver\""},
        Bad{7, R"({"t":81,"maneuver":1,"v":[[1,2],[3,4]]})",
            "7: v[0]: expected a number, found '['"},
        Bad{9, R"({"t":90,"jump":3})", "9: jump: neither out nor in"},
        Bad{9, R"({"t":90,"jump":3,"at":[4,8,1,-1]})", "9: in: missing beside \"at\""},
        Bad{9, R"({"t":90,"jump":3,"in":[[1,3,4,8]]})",
            "9: at: missing: the disk does not appear first"},
        Bad{9, R"({"t":90,"jump":3,"at":[4,3,1,-1],"in":[]})",
            "9: at: the edge is one of the disk itself"},
        Bad{9, R"({"t":90,"jump":3,"out":[[1]]})",
            "9: out[0]: neither a flip, a hide nor an appear"},
        Bad{9, R"({"t":90,"jump":3,"out":[[3,4],[1,2,null,4]]})",
            "9: out[1]: neither a flip, a hide nor an appear"},
        Bad{9, R"({"t":90,"jump":3,"out":[[1,2,3,4,5,6,7]]})",
            "9: out[0]: neither a flip, a hide nor an appear"},
        Bad{9, R"({"t":90,"jump":3,"out":[[1,2,3,null]]})",
            "9: out[0][3]: expected a number, found 'null'"},
        Bad{9, R"({"t":90,"jump":3,"out":[[1,1]]})", "9: out[0]: a disk is not its own host"},
        Bad{9, R"({"t":90,"jump":3,"out":[[1,1,2,3]]})", "9: out[0]: " + not_distinct},
        Bad{9, R"({"t":90,"jump":3,"out":[[1,2,4,5,6,7]]})",
            "9: out[0]: the host is not the first generator of the edge"},
        Bad{9, R"({"t":90,"jump":3,"out":[],"r":-1})", "9: r: negative"},
        Bad{9, R"({"t":90,"jump":3,"out":[],"growth":1})",
            "9: growth: no field of a line with \"jump\""},
        Bad{13, R"({"end":{"t":600,"flips":1,"collisions":0,"maneuvers":2}})",
            "13: end.hides: missing"},
        Bad{13, R"({"stopped":{"t":92,"reason":"r"}})",
            "13: stopped: earlier than the event before it"},
        Bad{13, R"({"stopped":{"t":93,"reason":"r","events":[]}})",
            "13: stopped.events: unknown field"},
        Bad{13, R"({"t":94,"swap":[2,5]})", "13: incomplete: the file ends without an end line"},
        Bad{12, world_lines[12], "13: text after the last line of the history"}));

}  // namespace
}  // namespace voroproof::internal::testing
