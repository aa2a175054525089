#include "history/history_file.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "history/error.h"
#include "history/validate.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal {
namespace {

const std::string hash(64, 'a');

// The example of docs/formats.md.
const std::vector<std::string> good_lines = {
    R"({"format":"voroproof-history","version":1,"scene_sha256":")" + hash +
        R"(","horizon":1000,"producer":"name version","initial":[[-1,0,1,1],[-1,1,0,0],[0,1,-1,-1]]})",
    R"({"t":1.25,"flip":[2,9,3,7]})",
    R"({"t":2.5,"collide":[3,7],"v":[[0.5,1],[2,0.25]],"p":[[1,2],[3,4]]})",
    R"({"t":3.5,"collide":[-1,4],"v":[null,[1,0]],"p":[null,[5,6]]})",
    R"({"t":4,"maneuver":5,"v":[1,0],"p":[7,8]})",
    R"({"end":{"t":1000,"flips":1,"collisions":2,"maneuvers":1}})",
};

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

HistoryHeader example_header() {
  return {hash, 1000, "name version",
          std::vector<Quad>{{1, 0, -1, -1}, {0, -1, 1, 1}, {1, -1, 0, 0}}};
}

std::vector<Event> example_events() {
  return {FlipEvent{1.25, {9, 2, 7, 3}, {}},
          CollideEvent{2.5, 3, 7, {Vec2{0.5, 1}, Vec2{2, 0.25}}, {Vec2{1, 2}, Vec2{3, 4}}, {}},
          CollideEvent{3.5, -1, 4, {std::nullopt, Vec2{1, -0.0}}, {std::nullopt, Vec2{5, 6}}, {}},
          ManeuverEvent{4, 5, Vec2{1, 0}, Vec2{7, 8}, {}}};
}

// What a file says, or the fault in it.
struct Told {
  HistoryHeader header;
  std::vector<Event> events;
  std::vector<std::int64_t> lines;
  std::variant<HistoryEnd, HistoryStop> ending;
  bool counts_match = false;
  std::string fault;
};

Told read(const std::string& path, int disk_count = max_disks) {
  Told told;
  try {
    HistoryReader reader(path, disk_count);
    told.header = reader.header();
    while (auto event = reader.next()) {
      told.events.push_back(*event);
      told.lines.push_back(reader.line());
    }
    EXPECT_FALSE(reader.next());
    told.ending = reader.ending();
    told.counts_match = reader.counts_match();
  } catch (const InputError& e) {
    told.fault = e.what();
  }
  return told;
}

// The fault without the directory.
std::string fault(const TemporaryDirectory& directory, const std::string& bytes,
                  int disk_count = max_disks) {
  std::string message = read(directory.write("h", bytes), disk_count).fault;
  if (message.empty()) return message;
  EXPECT_TRUE(message.starts_with(directory.file("h:")));
  return message.substr(directory.file("h:").size());
}

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

TEST(HistoryWriter, WritesTheExampleByteByByte) {
  TemporaryDirectory directory;
  HistoryWriter writer(directory.file("h"));
  writer.header(example_header());
  for (const Event& event : example_events()) writer.write(event);
  writer.end();
  EXPECT_FALSE(std::filesystem::exists(directory.file("h")));
  writer.close();
  EXPECT_EQ(directory.read("h"), joined(good_lines));
  EXPECT_EQ(directory.number_of_files(), 1u);
}

TEST(HistoryWriter, StoppedRun) {
  TemporaryDirectory directory;
  HistoryWriter writer(directory.file("h"));
  writer.header({hash, Rational(1000, 3), "x \"y\"", std::nullopt});
  writer.flip(-0.0, {0, 1, 2, 3});
  writer.stopped(1e-7, "two\nlines", example_events());
  writer.close();
  EXPECT_EQ(directory.read("h"),
            R"({"format":"voroproof-history","version":1,"scene_sha256":")" + hash +
                R"(","horizon":"1000/3","producer":"x \"y\""})"
                "\n"
                R"({"t":0,"flip":[0,1,2,3]})"
                "\n"
                R"({"stopped":{"t":1e-7,"reason":"two\nlines","events":[{"flip":[2,9,3,7]},)"
                R"({"collide":[3,7]},{"collide":[-1,4]},{"maneuver":5}]}})"
                "\n");
  const Told told = read(directory.file("h"));
  EXPECT_EQ(told.fault, "");
  EXPECT_EQ(told.header.horizon, Rational(1000, 3));
  EXPECT_FALSE(told.header.initial);
  const auto& stop = std::get<HistoryStop>(told.ending);
  EXPECT_EQ(stop.t, 1e-7);
  EXPECT_EQ(stop.reason, "two\nlines");
  EXPECT_EQ(stop.events, (std::vector<std::string>{R"({"flip":[2,9,3,7]})", R"({"collide":[3,7]})",
                                                   R"({"collide":[-1,4]})", R"({"maneuver":5})"}));
}

TEST(HistoryWriter, LeavesNothingBehindUnlessClosed) {
  TemporaryDirectory directory;
  directory.write("h", "before");
  {
    HistoryWriter writer(directory.file("h"));
    writer.header(example_header());
    for (int i = 0; i < 100'000; ++i) writer.flip(i, {0, 1, 2, 3});
    EXPECT_EQ(directory.number_of_files(), 2u);
    EXPECT_THROW(writer.close(), std::logic_error);
  }
  EXPECT_EQ(directory.read("h"), "before");
  EXPECT_EQ(directory.number_of_files(), 1u);
}

TEST(HistoryWriter, RefusesWhatHasNoPlace) {
  TemporaryDirectory directory;
  HistoryWriter writer(directory.file("h"));
  EXPECT_THROW(writer.flip(0, {0, 1, 2, 3}), std::logic_error);
  writer.header(example_header());
  EXPECT_THROW(writer.header(example_header()), std::logic_error);
  writer.flip(2, {0, 1, 2, 3});
  EXPECT_THROW(writer.flip(1, {0, 1, 2, 3}), std::logic_error);
  EXPECT_THROW(writer.flip(std::nan(""), {0, 1, 2, 3}), std::logic_error);
  EXPECT_THROW(writer.collide({3, 7, 3, {}, {}, {}}), std::logic_error);
  EXPECT_THROW(writer.collide({3, -1, 3, {Vec2{0, 0}, Vec2{0, 0}}, {}, {}}), std::logic_error);
  EXPECT_THROW(writer.collide({3, 1, 3, {std::nullopt, Vec2{0, 0}}, {}, {}}), std::logic_error);
  writer.end();
  EXPECT_THROW(writer.flip(3, {0, 1, 2, 3}), std::logic_error);
  writer.close();
  EXPECT_THROW(writer.close(), std::logic_error);
  EXPECT_EQ(read(directory.file("h")).fault, "");
}

TEST(HistoryWriter, PathsThatCannotBeWritten) {
  TemporaryDirectory directory;
  EXPECT_THROW(HistoryWriter(directory.file("none/h")), OutputError);
  EXPECT_THROW(HistoryWriter{directory.file("")}, OutputError);
  EXPECT_THROW(HistoryWriter("/dev/null"), OutputError);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(HistoryWriter, FollowsALink) {
  TemporaryDirectory directory;
  directory.write("target", "before");
  std::filesystem::create_symlink(directory.file("target"), directory.file("link"));
  HistoryWriter writer(directory.file("link"));
  writer.header(example_header());
  writer.end();
  writer.close();
  EXPECT_TRUE(std::filesystem::is_symlink(directory.file("link")));
  EXPECT_TRUE(directory.read("target").starts_with("{\"format\""));
}

// What stopped never takes the place of what is complete, whoever wrote that.
TEST(HistoryWriter, LeavesACompleteHistoryAlone) {
  TemporaryDirectory directory;
  const std::string stop = R"({"stopped":{"t":1,"reason":"interrupted","events":[]}})";
  struct Case {
    std::string before;
    bool stays;
  };
  for (const Case& c :
       {Case{joined(good_lines), true}, Case{"x\n{ \"end\" : {\"t\":1}}\n \n", true},
        Case{"x\n" + stop + "\n", false}, Case{"{\"end\":{}}\nx\n", false}, Case{"", false}}) {
    const std::string path = directory.write("h", c.before);
    HistoryWriter writer(path);
    writer.header(example_header());
    writer.stopped(1, "interrupted", {});
    const std::string written = writer.close_beside_complete();
    EXPECT_EQ(written, c.stays ? path + ".partial" : path);
    EXPECT_EQ(directory.read("h") == c.before, c.stays);
    EXPECT_TRUE(directory.read(c.stays ? "h.partial" : "h").ends_with(stop + "\n"));
  }
}

TEST(HistoryWriter, ACompleteHistoryReplacesAnother) {
  TemporaryDirectory directory;
  const std::string path = directory.write("h", joined(good_lines));
  HistoryWriter writer(path);
  writer.header(example_header());
  writer.end();
  EXPECT_EQ(writer.close_beside_complete(), path);
  EXPECT_NE(directory.read("h"), joined(good_lines));
  EXPECT_EQ(directory.number_of_files(), 1u);
}

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

class BadHistory : public testing::TestWithParam<Bad> {};

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
    testing::Values(
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

double any_double() {
  const double x =
      std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>() * 0x9E3779B97F4A7C15u);
  return std::isfinite(x) ? x : 0.0;
}

Vec2 any_vector() { return {any_double(), any_double()}; }

bool same(const Event& a, const Event& b) {
  if (a.index() != b.index()) return false;
  if (const auto* f = std::get_if<FlipEvent>(&a)) {
    const auto& g = std::get<FlipEvent>(b);
    return f->t == g.t && canonical(f->quad) == g.quad;
  }
  if (const auto* f = std::get_if<CollideEvent>(&a)) {
    const auto& g = std::get<CollideEvent>(b);
    return f->t == g.t && f->i == g.i && f->j == g.j && f->v == g.v && f->p == g.p;
  }
  const auto& f = std::get<ManeuverEvent>(a);
  const auto& g = std::get<ManeuverEvent>(b);
  return f.t == g.t && f.disk == g.disk && f.v == g.v && f.p == g.p;
}

RC_GTEST_PROP(History, WritingAndReadingIsTheIdentity, ()) {
  const int count = *rc::gen::inRange(0, 30);
  std::vector<double> times;
  for (int i = 0; i < count; ++i) times.push_back(std::fabs(any_double()));
  std::sort(times.begin(), times.end());
  std::vector<Event> events;
  for (double t : times) {
    const int a = *rc::gen::inRange(0, max_disks - 4);
    const bool v = *rc::gen::arbitrary<bool>(), p = *rc::gen::arbitrary<bool>();
    const auto vector = [](bool given) {
      return given ? std::optional(any_vector()) : std::nullopt;
    };
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        events.push_back(FlipEvent{t, {a + 3, a, container_id, a + 1}, {}});
        break;
      case 1:
        events.push_back(
            CollideEvent{t, a, a + 1, {vector(v), vector(v)}, {vector(p), vector(p)}, {}});
        break;
      case 2:
        events.push_back(CollideEvent{
            t, container_id, a, {std::nullopt, vector(v)}, {std::nullopt, vector(p)}, {}});
        break;
      default:
        events.push_back(ManeuverEvent{t, a, vector(v), vector(p), {}});
    }
  }
  const Rational horizon = to_rational(times.empty() ? 1 : times.back());
  TemporaryDirectory directory;
  HistoryWriter writer(directory.file("h"));
  writer.header({hash, horizon, "p", std::nullopt});
  for (const Event& event : events) writer.write(event);
  writer.end();
  writer.close();
  const Told told = read(directory.file("h"));
  RC_ASSERT(told.fault.empty());
  RC_ASSERT(told.counts_match);
  RC_ASSERT(told.header.horizon == horizon);
  RC_ASSERT(told.events.size() == events.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    RC_ASSERT(same(events[i], told.events[i]));
    RC_ASSERT(exact_time(told.events[i]) == to_rational(times[i]));
  }
}

TEST(Validate, FindsTheFormat) {
  TemporaryDirectory directory;
  EXPECT_EQ(validate_file(directory.write("h", joined(good_lines))),
            "history: 1 flip, 2 collisions, 1 maneuver, complete to t = 1000");
  const std::string scene =
      R"("version":1,"container":{"center":[0,0],"radius":1},"horizon":"1/3","disks":[]})";
  EXPECT_EQ(validate_file(directory.write("s", "{\"format\":\"voroproof-scene\"," + scene)),
            "scene: 0 disks, 0 maneuvers, horizon \"1/3\"");
  // The field may be far from the beginning.
  EXPECT_EQ(validate_file(directory.write("s", "{\"comment\":\"" + std::string(100'000, 'x') +
                                                   "\",\n\"format\":\"voroproof-scene\"," + scene)),
            "scene: 0 disks, 0 maneuvers, horizon \"1/3\"");
  EXPECT_EQ(
      validate_file(directory.write(
          "h", good_lines[0] + "\n{\"stopped\":{\"t\":5,\"reason\":\"r\",\"events\":[[1]]}}")),
      "history: 0 flips, 0 collisions, 0 maneuvers, stopped at t = 5: r");
}

TEST(Validate, RefusesOtherFiles) {
  TemporaryDirectory directory;
  const auto message = [&](const std::string& text) -> std::string {
    const std::string path = directory.write("f", text);
    try {
      validate_file(path);
      return "";
    } catch (const InputError& e) {
      return std::string(e.what()).substr(path.size() + 1);
    }
  };
  EXPECT_EQ(message(""), "1: unexpected end of input, expected an object");
  EXPECT_EQ(message("{\"a\":1}"), "1: format: missing");
  EXPECT_EQ(message("{\"a\":1,\n\"format\":\"x\"}"), "2: format: none that can be validated: x");
  EXPECT_EQ(message("{\"a\":[" + std::string(100'000, '1') + "]}"),
            "1: [0]: a number of more than 4096 characters");
  std::vector<std::string> lines = good_lines;
  lines[4] = R"({"t":4,"flip":[1,2,3,4]})";
  EXPECT_EQ(message(joined(lines)),
            "6: end: wrong counts: the file has 2 flips, 2 collisions, "
            "0 maneuvers");
  EXPECT_NE(message("\x1f\x8b garbage"), "");
}

}  // namespace
}  // namespace voroproof::internal
