// Fields of strangers (docs/formats.md, section 14) and versions of formats (section 13).
#include "history/extensions.h"

#include <gtest/gtest.h>

#include <sstream>

#include "history/diagram_file.h"
#include "history/error.h"
#include "history/history_reader.h"
#include "history/history_writer.h"
#include "history/plan_file.h"
#include "history/scene.h"
#include "history/scene_writer.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal {
namespace {

template <class Read>
std::string fault(Read&& read) {
  try {
    read();
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

// `more` stands in the scene, `of_disk` in its disk, `of_wall` in its container.
std::string scene(const std::string& more, const std::string& of_disk = "",
                  const std::string& of_wall = "") {
  return R"({"format": "voroproof-scene", "version": 1, "horizon": 5, )" + more +
         R"("container": {"center": [0, 0], )" + of_wall + R"("radius": 9}, "disks": [)" +
         R"({"center": [0, 0], )" + of_disk + R"("radius": 1, "velocity": [1, 0]}],)" +
         R"("maneuvers": [{"t": 1, "x-m": null, "disk": 0, "velocity": [0, 0]}]})";
}

std::string scene_fault(const std::string& text) {
  return fault([&] { parse_scene(text, "s"); });
}

std::string written(const Scene& scene) {
  std::ostringstream out;
  write_scene(out, scene);
  return out.str();
}

TEST(Extensions, OfAScene) {
  const Scene read = parse_scene(
      scene(R"("x-b": {"of": [1, "a b\"  c", 1e3]}, "x-a": true, )", R"("x-d": "red", )"), "s");
  EXPECT_EQ(read.extensions,
            (Extensions{{"x-a", "true"}, {"x-b", R"({"of":[1,"a b\"  c",1e3]})"}}));
  ASSERT_EQ(read.disk_extensions.size(), 1u);
  EXPECT_EQ(read.disk_extensions.at(0), (Extensions{{"x-d", "\"red\""}}));
  EXPECT_EQ(read.maneuver_extensions.at(0), (Extensions{{"x-m", "null"}}));
  // They survive being written, and reading that again.
  const std::string text = written(read);
  EXPECT_EQ(written(parse_scene(text, "s")), text);
  EXPECT_EQ(parse_scene(text, "s").extensions, read.extensions);
  EXPECT_EQ(parse_scene(text, "s").disk_extensions, read.disk_extensions);
  EXPECT_EQ(parse_scene(text, "s").maneuver_extensions, read.maneuver_extensions);
}

TEST(Extensions, FollowTheRulesForJson) {
  EXPECT_EQ(scene_fault(scene(R"("x-a": 1, "x-a": 2, )")), "s:1: x-a: appears twice in one object");
  EXPECT_EQ(scene_fault(scene(R"("x-a": {"b": 1, "b": 2}, )")),
            "s:1: x-a: a field appears twice in one object");
  EXPECT_EQ(scene_fault(scene(R"("x-a": 1e-400, )")), "s:1: x-a: beyond the range of binary64");
  EXPECT_EQ(scene_fault(scene(R"("x-a": NaN, )")), "s:1: x-a: expected a value, found 'NaN'");
  EXPECT_NE(scene_fault(scene("\"x-a\": " + std::string(16, '[') + std::string(16, ']') + ", ")),
            "");
  EXPECT_EQ(scene_fault(scene("\"x-a\": " + std::string(15, '[') + std::string(15, ']') + ", ")),
            "");
}

TEST(Extensions, NowhereElse) {
  EXPECT_EQ(scene_fault(scene("", "", R"("x-a": 1, )")), "s:1: container.x-a: unknown field");
  EXPECT_EQ(scene_fault(scene(R"("y-a": 1, )")), "s:1: y-a: unknown field");
  EXPECT_EQ(scene_fault(scene("", R"("X-a": 1, )")), "s:1: disks[0].X-a: unknown field");
}

TEST(Extensions, StayInsideTheirField) {
  Scene bad = parse_scene(scene(""), "s");
  for (const auto& [name, value] :
       Extensions{{"x-a", R"(1, "comment": 2)"}, {"x-b", ""}, {"x-c", "1}"}, {"name", "1"}}) {
    bad.extensions = {{name, value}};
    EXPECT_NE(fault([&] { written(bad); }), "") << name;
  }
  bad.extensions = {{"x-\"q", "[1,\n 2]"}};
  EXPECT_EQ(parse_scene(written(bad), "s").extensions, (Extensions{{"x-\"q", "[1,2]"}}));
}

const std::string header =
    R"({"x-h":{"a":1},"format":"voroproof-history","version":1,"scene_sha256":")" +
    std::string(64, '0') + R"(","horizon":5,"producer":"p"})" + "\n";

TEST(Extensions, OfAHistory) {
  const TemporaryDirectory folder;
  const std::string text = header +
                           R"({"t":1,"flip":[-1,0,1,2],"x-f":[1]})"
                           "\n"
                           R"({"x-c":2,"t":2,"collide":[-1,0]})"
                           "\n"
                           R"({"t":3,"maneuver":0})"
                           "\n"
                           R"({"x-e":3,"end":{"t":5,"flips":1,"collisions":1,"maneuvers":1}})"
                           "\n";
  HistoryReader reader(folder.write("a.jsonl", text));
  HistoryWriter writer(folder.file("b.jsonl"));
  EXPECT_EQ(reader.header().extensions, (Extensions{{"x-h", R"({"a":1})"}}));
  writer.header(reader.header());
  std::vector<Extensions> found;
  while (const auto event = reader.next()) {
    found.push_back(reader.extensions());
    writer.write(*event, reader.extensions());
  }
  EXPECT_EQ(found, (std::vector<Extensions>{{{"x-f", "[1]"}}, {{"x-c", "2"}}, {}}));
  EXPECT_EQ(reader.extensions(), (Extensions{{"x-e", "3"}}));
  writer.end(reader.extensions());
  writer.close();
  const std::string copy = folder.read("b.jsonl");
  EXPECT_NE(copy.find(R"({"t":2,"collide":[-1,0],"x-c":2})"), std::string::npos) << copy;
  EXPECT_NE(copy.find(R"("maneuvers":1},"x-e":3})"), std::string::npos) << copy;
  EXPECT_EQ(HistoryReader(folder.file("b.jsonl")).header().extensions, reader.header().extensions);
}

TEST(Extensions, NotWithinTheLastLinesObject) {
  const TemporaryDirectory folder;
  const std::string bad = R"({"end":{"t":5,"flips":0,"collisions":0,"maneuvers":0,"x-e":3}})";
  HistoryReader reader(folder.write("a.jsonl", header + bad));
  EXPECT_NE(fault([&] { reader.next(); }).find("end.x-e: unknown field"), std::string::npos);
}

// A history that stopped must not replace a complete one, however its last line looks.
TEST(Extensions, AnExtendedLastLineIsOne) {
  const TemporaryDirectory folder;
  const std::string end = R"("end":{"t":5,"flips":0,"collisions":0,"maneuvers":0})";
  const std::string stop = R"("stopped":{"t":5,"reason":"\"end\":{"})";
  const std::string more = "\"x-m\":\"" + std::string(5000, 'm') + "\"";
  for (const std::string& line : {"{" + end + "}", "{" + more + "," + end + "}",
                                  "{" + end + "," + more + "}", "{ " + end + " }\n"}) {
    EXPECT_TRUE(is_complete_history(folder.write("a.jsonl", header + line))) << line.substr(0, 80);
  }
  for (const std::string& line : {"{" + stop + "}", "{\"x-m\":{" + end + "}," + stop + "}"}) {
    EXPECT_FALSE(is_complete_history(folder.write("a.jsonl", header + line))) << line;
  }
}

std::string diagram(const std::string& version, const std::string& more) {
  return R"({"format":"voroproof-diagram",)" + more + "\"version\":" + version +
         R"(,"t":1,"scene_sha256":")" + std::string(64, 'a') +
         R"(","container":{"center":[0,0],"radius":9},"disks":[],"vertices":[],"edges":[]})";
}

TEST(Extensions, OfADiagram) {
  const TemporaryDirectory folder;
  const DiagramFile read = parse_diagram(diagram("1", R"("x-a": [ 1 ],)"), "d");
  EXPECT_EQ(read.extensions, (Extensions{{"x-a", "[1]"}}));
  write_diagram(folder.file("d.json"), read);
  EXPECT_EQ(read_diagram(folder.file("d.json")).extensions, read.extensions);
}

// A newer file may have fields that are not known here, before its version, too.
TEST(FormatVersion, ANewerFileIsToldAsSuch) {
  const TemporaryDirectory folder;
  const std::string newer = "version: the file is of version 2; this program reads version 1";
  EXPECT_EQ(fault([&] { parse_diagram(diagram("2", ""), "d"); }), "d:1: " + newer);
  EXPECT_EQ(fault([&] { parse_diagram(diagram("2", "\n\"colour\":3,\n"), "d"); }), "d:3: " + newer);
  EXPECT_EQ(scene_fault(R"({"walls": [], "version": 2, "format": "voroproof-scene", "more": NaN)"),
            "s:1: " + newer);
  EXPECT_EQ(
      fault([&] { parse_plan(R"({"z": 1, "format": "voroproof-plan", "version": 2})", "p"); }),
      "p:1: " + newer);
  const std::string history = R"({"format":"voroproof-history","frames":[],"version":2})";
  EXPECT_EQ(fault([&] { HistoryReader(folder.write("h.jsonl", history)); }),
            folder.file("h.jsonl") + ":1: " + newer);
}

TEST(FormatVersion, NothingElseIsTakenForNewer) {
  EXPECT_EQ(fault([&] { parse_diagram(diagram("0", ""), "d"); }), "d:1: version: not 1");
  EXPECT_EQ(fault([&] { parse_diagram(diagram("-2", ""), "d"); }), "d:1: version: not 1");
  EXPECT_EQ(fault([&] { parse_diagram(diagram("2.0", ""), "d"); }), "d:1: version: not an integer");
  EXPECT_EQ(fault([&] { parse_diagram(diagram("1", "\"colour\":3,"), "d"); }),
            "d:1: colour: unknown field");
  // Of another format, whose versions are not known.
  EXPECT_EQ(scene_fault(R"({"format": "voroproof-movie", "version": 2})"),
            "s:1: format: not \"voroproof-scene\"");
}

}  // namespace
}  // namespace voroproof::internal
