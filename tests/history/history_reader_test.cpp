// Histories as they are read: every faulty line is refused with its number and field.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "history/error.h"
#include "history/history_reader.h"
#include "tests/history/example_history.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal::testing {
namespace {

TEST(HistoryReader, ReadsTheExample) {
  TemporaryDirectory directory;
  const Told told = read(directory.write("h", joined(good_lines)));
  ASSERT_EQ(told.fault, "");
  EXPECT_EQ(told.header.scene_sha256, hash);
  EXPECT_EQ(told.header.horizon, 1000);
  EXPECT_EQ(told.header.producer, "name version");
  EXPECT_EQ(*told.header.initial,
            (std::vector<Quad>{{-1, 0, 1, 1}, {-1, 1, 0, 0}, {0, 1, -1, -1}}));
  EXPECT_EQ(told.lines, (std::vector<std::int64_t>{2, 3, 4, 5}));
  ASSERT_EQ(told.events.size(), 4u);
  EXPECT_EQ(std::get<FlipEvent>(told.events[0]).quad, (Quad{2, 9, 3, 7}));
  const auto& wall = std::get<CollideEvent>(told.events[2]);
  EXPECT_EQ(wall.i, container_id);
  EXPECT_FALSE(wall.v[0]);
  EXPECT_EQ(*wall.p[1], (Vec2{5, 6}));
  EXPECT_EQ(*exact_center(wall, 1), (ExactVec2{5, 6}));
  EXPECT_EQ(*std::get<ManeuverEvent>(told.events[3]).p, (Vec2{7, 8}));
  EXPECT_EQ(std::get<HistoryEnd>(told.ending).counts, (HistoryCounts{1, 2, 1}));
  EXPECT_TRUE(told.counts_match);
}

TEST(HistoryReader, AnyOrderOfKeysAndEitherNameOfAnEdge) {
  TemporaryDirectory directory;
  const Told told = read(directory.write(
      "h",
      joined({R"( { "initial":[[1,0,-1,-1],[1,-1,0,0],[0,-1,1,1]], "producer":"","horizon":"10",)"
              R"("scene_sha256":")" +
                  std::string(64, 'A') + R"(","version":1,"format":"voroproof-history"})",
              R"({"flip":[9,2,7,3],"t":1})", "{\"p\":[[1,2],[3,4]],\"collide\":[3,7],\"t\":1}\r",
              R"({"v":[1,2],"t":1,"maneuver":0})", R"({"t":1,"collide":[-1,0]})",
              R"({"end":{"maneuvers":0,"flips":0,"collisions":0,"t":10}})"})));
  ASSERT_EQ(told.fault, "");
  EXPECT_EQ(told.header.scene_sha256, hash);
  EXPECT_EQ(*told.header.initial, *read(directory.write("g", joined(good_lines))).header.initial);
  EXPECT_EQ(std::get<FlipEvent>(told.events[0]).quad, (Quad{2, 9, 3, 7}));
  EXPECT_FALSE(std::get<CollideEvent>(told.events[1]).v[0]);
  EXPECT_FALSE(told.counts_match);
}

TEST(HistoryReader, ExactStrings) {
  TemporaryDirectory directory;
  const Told told =
      read(directory.write("h", joined({good_lines[0], R"({"t":"1/3","flip":[2,9,3,7]})",
                                        R"({"t":1,"collide":[3,7],"v":[["0.1",1],[0.1,0]]})",
                                        R"({"t":2,"maneuver":3,"p":[1,"1/7"]})", good_lines[5]})));
  ASSERT_EQ(told.fault, "");
  EXPECT_EQ(time(told.events[0]), 1.0 / 3);
  EXPECT_EQ(exact_time(told.events[0]), Rational(1, 3));
  const auto& collision = std::get<CollideEvent>(told.events[1]);
  EXPECT_EQ(*collision.v[0], (Vec2{0.1, 1}));
  EXPECT_EQ(*exact_velocity(collision, 0), (ExactVec2{Rational(1, 10), 1}));
  EXPECT_EQ(*exact_velocity(collision, 1), (ExactVec2{to_rational(0.1), 0}));
  EXPECT_FALSE(exact_center(collision, 0));
  EXPECT_EQ(exact_time(told.events[1]), 1);
  EXPECT_EQ(*exact_center(std::get<ManeuverEvent>(told.events[2])), (ExactVec2{1, Rational(1, 7)}));
}

// Times that round to the same binary64 are still compared.
TEST(HistoryReader, ComparesExactTimes) {
  TemporaryDirectory directory;
  const auto two = [&](const std::string& a, const std::string& b) {
    return fault(directory, joined({good_lines[0], R"({"t":)" + a + R"(,"flip":[2,9,3,7]})",
                                    R"({"t":)" + b + R"(,"flip":[2,9,3,7]})", good_lines[5]}));
  };
  const std::string late = R"("1.00000000000000000001")", early = R"("0.99999999999999999999")";
  EXPECT_EQ(two(early, late), "");
  EXPECT_EQ(two(early, "1"), "");
  EXPECT_EQ(two("1", late), "");
  EXPECT_EQ(two("1", "1"), "");
  for (const auto& [a, b] :
       {std::pair{late, early}, {late, std::string("1")}, {std::string("1"), early}})
    EXPECT_EQ(two(a, b), "3: t: earlier than the event before it");
}

TEST(HistoryReader, RoundedEventAtAnExactHorizon) {
  TemporaryDirectory directory;
  // 2/3 rounds up.
  std::string header = good_lines[0];
  header.replace(header.find("1000"), 4, "\"2/3\"");
  const std::string end =
      R"({"end":{"t":0.66666666666666663,"flips":1,"collisions":0,"maneuvers":0}})";
  EXPECT_EQ(
      fault(directory, joined({header, R"({"t":0.66666666666666663,"flip":[2,9,3,7]})", end})), "");
  EXPECT_EQ(
      fault(directory, joined({header, R"({"t":0.66666666666666674,"flip":[2,9,3,7]})", end})),
      "2: t: beyond the horizon");
}

struct Bad {
  std::size_t line;  // of the example, from 1
  std::string text;  // that replaces it
  std::string message;
};

// What gtest calls the case.
void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.message; }

// With the ids of the other scene a reader would complain of these.
TEST(HistoryReader, SaysThatAHistoryIsOfAnotherScene) {
  TemporaryDirectory directory;
  const std::string path = directory.write("h", joined(good_lines));
  EXPECT_NO_THROW(HistoryReader(path, 10, hash));
  try {
    HistoryReader(path, 1, std::string(64, 'c'));
    ADD_FAILURE() << "accepted";
  } catch (const InputError& e) {
    EXPECT_EQ(e.what(), path + ":1: scene_sha256: the history is one of another scene");
  }
}

class BadHistory : public ::testing::TestWithParam<Bad> {};

TEST_P(BadHistory, IsRefusedWithLineAndField) {
  TemporaryDirectory directory;
  std::vector<std::string> lines = good_lines;
  lines[GetParam().line - 1] = GetParam().text;
  EXPECT_EQ(fault(directory, joined(lines), 10), GetParam().message);
}

std::string header(const std::string& from, const std::string& to) {
  std::string text = good_lines[0];
  return text.replace(text.find(from), from.size(), to);
}

INSTANTIATE_TEST_SUITE_P(
    Table, BadHistory,
    ::testing::Values(
        Bad{1, "", "1: unexpected end of input, expected an object"},
        Bad{1, header("history", "scene"), "1: format: not \"voroproof-history\""},
        Bad{1, header("\"version\":1,", ""), "1: version: missing"},
        Bad{1, header("aaa", "xaa"), "1: scene_sha256: not 64 hexadecimal digits"},
        Bad{1, header("aaa", "aa"), "1: scene_sha256: not 64 hexadecimal digits"},
        Bad{1, header(":1000", ":-1"), "1: horizon: negative"},
        Bad{1, header("[-1,0,1,1]", "[-1,0,1]"), "1: initial[0]: not an array of 4 elements"},
        Bad{1, header("[-1,0,1,1]", "[-1,0,-1,1]"),
            "1: initial[0]: names no edge: its generators are not distinct"},
        Bad{1, header("[-1,0,1,1]", "[-2,0,1,1]"), "1: initial[0][0]: not in [-1, 9]"},
        Bad{1, header("[-1,0,1,1]", "[1,-1,0,0]"), "1: initial: names an edge twice"},
        Bad{1, header("}", ",\"seed\":1}"), "1: seed: unknown field"},
        Bad{2, R"({"t":1.25,"flip":[2,9,3,10]})", "2: flip[3]: not in [-1, 9]"},
        Bad{2, R"({"t":1.25,"flip":[2,9,3,7.0]})", "2: flip[3]: not an integer"},
        Bad{2, R"({"t":1.25,"flip":[2,9,3,"7"]})", "2: flip[3]: expected a number, found '\"'"},
        Bad{2, R"({"t":1.25,"flip":[2,2,3,7]})",
            "2: flip: names no edge: its generators are not distinct"},
        Bad{2, R"({"flip":[2,9,3,7]})", "2: t: missing"},
        Bad{2, R"({"t":-1,"flip":[2,9,3,7]})", "2: t: negative"},
        Bad{2, R"({"t":NaN,"flip":[2,9,3,7]})", "2: t: expected a number, found 'NaN'"},
        Bad{2, R"({"t":1e999,"flip":[2,9,3,7]})", "2: t: beyond the range of binary64"},
        Bad{2, R"({"t":1,"t":1,"flip":[2,9,3,7]})", "2: t: appears twice in one object"},
        Bad{2, R"({"t":1001,"flip":[2,9,3,7]})", "2: t: beyond the horizon"},
        Bad{2, R"({"t":1,"flip":[2,9,3,7],"v":[1,2]})", "2: a flip has neither v nor p"},
        Bad{2, R"({"t":1,"flip":[2,9,3,7],"maneuver":1})", "2: more than one event"},
        Bad{2, R"({"t":1,"flop":[2,9,3,7]})", "2: flop: unknown field"},
        Bad{2, R"({"t":1})", "2: neither an event nor an end line"},
        Bad{2, R"({})", "2: neither an event nor an end line"},
        Bad{2, R"([1])", "2: expected an object, found '['"},
        Bad{2, "", "2: unexpected end of input, expected an object"},
        Bad{2, R"({"t":1,"flip":[2,9,3,7]} x)", "2: expected nothing more, found 'x'"},
        Bad{2, R"({"t":1,"flip":[2,9,3,7)",
            "2: flip[3]: unexpected end of input, expected ',' or ']'"},
        Bad{2, R"({"t":3,"flip":[2,9,3,7]})", "3: t: earlier than the event before it"},
        Bad{3, R"({"t":2.5,"collide":[7,3]})", "3: collide: not two ids, the smaller first"},
        Bad{3, R"({"t":2.5,"collide":[3,3]})", "3: collide: not two ids, the smaller first"},
        Bad{3, R"({"t":2.5,"collide":[3]})", "3: collide: not an array of 2 elements"},
        Bad{3, R"({"t":2.5,"collide":[3,7],"v":[1,2]})", "3: v: not two vectors"},
        Bad{3, R"({"t":2.5,"collide":[3,7],"v":[null,[1,2]]})", "3: v: null for a disk"},
        Bad{3, R"({"t":2.5,"collide":[3,7],"p":[[1,2],[1,2,3]]})",
            "3: p[1]: not an array of 2 elements"},
        Bad{3, R"({"t":2.5,"collide":[3,7],"p":[[1,2],3]})", "3: p[1]: mixes numbers and vectors"},
        Bad{3, R"({"t":2.5,"collide":[3,7],"p":null})", "3: p: expected an array, found 'null'"},
        Bad{4, R"({"t":3.5,"collide":[-1,4],"v":[[0,0],[1,0]]})",
            "4: v: not null for the container"},
        Bad{5, R"({"t":4,"maneuver":-1})", "5: maneuver: not in [0, 9]"},
        Bad{5, R"({"t":4,"maneuver":5,"v":[[1,2],[3,4]]})", "5: v: not one vector"},
        Bad{5, R"({"t":4,"maneuver":5,"p":[null,[3,4]]})", "5: p: not one vector"},
        Bad{6, R"({"end":{"t":999,"flips":1,"collisions":2,"maneuvers":1}})",
            "6: end.t: not the horizon"},
        Bad{6, R"({"end":{"t":1000,"flips":1,"collisions":2}})", "6: end.maneuvers: missing"},
        Bad{6, R"({"end":{"t":1000,"flips":-1,"collisions":2,"maneuvers":1}})",
            "6: end.flips: not in [0, 9223372036854775807]"},
        Bad{6, R"({"t":5,"end":{"t":1000,"flips":1,"collisions":2,"maneuvers":1}})",
            "6: an end line with other fields"},
        Bad{6, R"({"stopped":{"t":3,"reason":"","events":[]}})",
            "6: stopped: earlier than the event before it"},
        Bad{6, R"({"stopped":{"t":1001,"reason":"","events":[]}})",
            "6: stopped: beyond the horizon"},
        Bad{6, R"({"stopped":{"t":5,"events":[]}})", "6: stopped.reason: missing"},
        Bad{6, good_lines[4], "6: incomplete: the file ends without an end line"},
        Bad{6, good_lines[5] + "\n", "7: text after the last line of the history"},
        Bad{5, good_lines[5], "6: text after the last line of the history"}));

TEST(HistoryReader, EveryPrefixIsIncomplete) {
  TemporaryDirectory directory;
  const std::string text = joined(good_lines);
  EXPECT_EQ(fault(directory, text.substr(0, text.size() - 1)), "");
  for (std::size_t length = 0; length + 1 < text.size(); ++length)
    ASSERT_NE(fault(directory, text.substr(0, length)), "") << length;
  EXPECT_EQ(fault(directory, ""), "1: empty file");
  EXPECT_THROW(HistoryReader(directory.file("none")), InputError);
}

TEST(HistoryReader, LongLinesAreRefused) {
  TemporaryDirectory directory;
  const std::string long_line = R"({"t":1,)" + std::string(2 << 20, ' ') + R"("flip":[2,9,3,7]})";
  EXPECT_EQ(fault(directory, joined({good_lines[0], long_line})),
            "2: a line of more than 1048576 bytes");
  EXPECT_EQ(fault(directory, good_lines[0] + "\n" + std::string(3 << 20, '1')),
            "2: a line of more than 1048576 bytes");
}

// Lines of every length around the size of the reader's buffer.
TEST(HistoryReader, LinesAcrossBuffers) {
  TemporaryDirectory directory;
  std::string text = good_lines[0] + "\n";
  std::int64_t flips = 0;
  for (int pad = 0; pad < 3000; pad += 7) {
    text +=
        R"({"t":1,)" + std::string(static_cast<std::size_t>(pad), ' ') + "\"flip\":[2,9,3,7]}\n";
    ++flips;
  }
  text += R"({"t":1,)" + std::string(900'000, ' ') + "\"flip\":[2,9,3,7]}\n";
  text += R"({"end":{"t":1000,"flips":)" + std::to_string(flips + 1) +
          R"(,"collisions":0,"maneuvers":0}})";
  const Told told = read(directory.write("h", text));
  EXPECT_EQ(told.fault, "");
  EXPECT_TRUE(told.counts_match);
}

}  // namespace
}  // namespace voroproof::internal::testing
