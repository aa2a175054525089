#include "history/scene.h"
#include "history/scene_writer.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <sstream>

#include "history/error.h"
#include "history/sha256.h"
#include "tests/history/temporary_directory.h"
#include "tests/support/compact_arithmetic.h"

namespace voroproof::internal {
namespace {

// The example of docs/formats.md, one field a line.
const std::vector<std::string> good_lines = {
    R"({"format": "voroproof-scene",)",                                              // 1
    R"( "version": 1,)",                                                             // 2
    R"( "container": {"center": [0, 0], "radius": 250},)",                           // 3
    R"( "restitution": 1,)",                                                         // 4
    R"( "horizon": 1000,)",                                                          // 5
    R"( "disks": [)",                                                                // 6
    R"(  {"center": [10.5, "1/3"], "radius": 2, "velocity": [1, 0]},)",              // 7
    R"(  {"center": [-40, 0], "radius": 3, "velocity": ["-0.5", 0], "mass": 9}],)",  // 8
    R"( "maneuvers": [)",                                                            // 9
    R"(  {"t": 12.5, "disk": 0, "velocity": [0.5, 0]},)",                            // 10
    R"(  {"t": 12.5, "disk": 1, "velocity": [0.5, 0]}]})",                           // 11
};

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

Scene parse(const std::string& text) { return parse_scene(text, "s.json"); }

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

void expect_same(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.cx, b.cx);
  EXPECT_EQ(a.cy, b.cy);
  EXPECT_EQ(a.container_radius, b.container_radius);
  EXPECT_EQ(a.restitution, b.restitution);
  EXPECT_EQ(a.container_restitution, b.container_restitution);
  EXPECT_EQ(a.law, b.law);
  EXPECT_EQ(a.horizon, b.horizon);
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.comment, b.comment);
  EXPECT_EQ(a.seed, b.seed);
  ASSERT_EQ(a.disks.size(), b.disks.size());
  for (std::size_t i = 0; i < a.disks.size(); ++i) {
    const DiskInput &p = a.disks[i], &q = b.disks[i];
    EXPECT_TRUE(p.x == q.x && p.y == q.y && p.radius == q.radius && p.vx == q.vx && p.vy == q.vy &&
                p.mass == q.mass)
        << i;
  }
  ASSERT_EQ(a.maneuvers.size(), b.maneuvers.size());
  for (std::size_t i = 0; i < a.maneuvers.size(); ++i) {
    const Maneuver &p = a.maneuvers[i], &q = b.maneuvers[i];
    EXPECT_TRUE(p.t == q.t && p.disk == q.disk && p.vx == q.vx && p.vy == q.vy) << i;
  }
}

std::string written(const Scene& scene) {
  std::ostringstream out;
  write_scene(out, scene);
  return out.str();
}

TEST(Scene, ReadsTheExample) {
  const std::string text = joined(good_lines);
  const Scene scene = parse(text);
  EXPECT_EQ(scene.container_radius, 250);
  EXPECT_EQ(scene.horizon, 1000);
  EXPECT_EQ(scene.restitution, 1);
  EXPECT_EQ(scene.container_restitution, 1);
  EXPECT_EQ(scene.law, ContainerLaw::normal);
  ASSERT_EQ(scene.disks.size(), 2u);
  EXPECT_EQ(scene.disks[0].x, Rational(21, 2));
  EXPECT_EQ(scene.disks[0].y, Rational(1, 3));
  EXPECT_EQ(scene.disks[0].mass, 4);
  EXPECT_EQ(scene.disks[1].vx, Rational(-1, 2));
  EXPECT_EQ(scene.disks[1].mass, 9);
  ASSERT_EQ(scene.maneuvers.size(), 2u);
  EXPECT_EQ(scene.maneuvers[1].t, Rational(25, 2));
  EXPECT_EQ(scene.sha256, sha256_hex(text));
}

TEST(Scene, ReadsOptionalFieldsInAnyOrder) {
  const Scene scene = parse(
      R"({"disks": [], "seed": 18446744073709551617, "comment": "\u00e9", "name": "x", "horizon": 0,
          "container_law": "whole", "container": {"restitution": "1/2", "radius": "1/3",
          "center": ["0.1", 0.1]}, "restitution": 0, "version": 1, "format": "voroproof-scene"})");
  EXPECT_EQ(scene.law, ContainerLaw::whole);
  EXPECT_EQ(scene.container_restitution, Rational(1, 2));
  EXPECT_EQ(scene.cx, Rational(1, 10));
  EXPECT_EQ(scene.cy, to_rational(0.1));
  EXPECT_NE(scene.cx, scene.cy);
  EXPECT_EQ(scene.name, "x");
  EXPECT_EQ(scene.comment, "\xc3\xa9");
  EXPECT_EQ(std::get<Integer>(*scene.seed), Integer("18446744073709551617"));
  EXPECT_EQ(std::get<std::string>(*parse(replaced(joined(good_lines), "\"version\": 1",
                                                  "\"version\": 1, \"seed\": \"s\""))
                                       .seed),
            "s");
}

struct Bad {
  std::string from, to;  // the change to the example
  std::string message;   // after "s.json:"
};

// What gtest calls the case.
void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.message; }

class BadScene : public testing::TestWithParam<Bad> {};

TEST_P(BadScene, IsRefusedWithLineAndField) {
  EXPECT_EQ(fault(replaced(joined(good_lines), GetParam().from, GetParam().to)),
            "s.json:" + GetParam().message);
}

const std::string limits = "beyond the limits of a scene: 0 or 1e-100 to 1e100 in magnitude";

INSTANTIATE_TEST_SUITE_P(
    Table, BadScene,
    testing::Values(
        Bad{"voroproof-scene", "voroproof-history", "1: format: not \"voroproof-scene\""},
        Bad{"\"version\": 1", "\"version\": 2",
            "2: version: the file is of version 2; this program reads version 1"},
        Bad{"\"version\": 1", "\"version\": 1.0", "2: version: not an integer"},
        Bad{"\"version\": 1", "\"version\": \"1\"", "2: version: expected a number, found '\"'"},
        Bad{" \"version\": 1,\n", "", "1: version: missing"},
        Bad{" \"horizon\": 1000,\n", "", "1: horizon: missing"},
        Bad{"\"horizon\": 1000", "\"horizon\": -1", "5: horizon: negative"},
        Bad{"\"horizon\": 1000", "\"horizon\": \"-1/1000\"", "5: horizon: negative"},
        Bad{"\"horizon\": 1000", "\"horizon\": 1e101", "5: horizon: " + limits},
        Bad{"\"horizon\": 1000", "\"horizon\": 1e-101", "5: horizon: " + limits},
        Bad{"\"horizon\": 1000", "\"horizon\": \"1e-101\"", "5: horizon: " + limits},
        Bad{"\"horizon\": 1000", "\"horizon\": 1e999", "5: horizon: beyond the range of binary64"},
        Bad{"\"horizon\": 1000", "\"horizon\": 1e-999", "5: horizon: beyond the range of binary64"},
        Bad{"\"horizon\": 1000", "\"horizon\": NaN", "5: horizon: expected a number, found 'NaN'"},
        Bad{"\"horizon\": 1000", "\"horizon\": null",
            "5: horizon: expected a number, found 'null'"},
        Bad{"\"horizon\": 1000", "\"horizon\": 5, \"colour\": 1", "5: colour: unknown field"},
        Bad{"\"horizon\": 1000", "\"horizon\": 5,\n\"horizon\": 5",
            "6: horizon: appears twice in one object"},
        Bad{"\"restitution\": 1", "\"restitution\": 1.5", "4: restitution: not in [0, 1]"},
        Bad{"\"restitution\": 1", "\"restitution\": \"-1/9\"", "4: restitution: not in [0, 1]"},
        Bad{"\"restitution\": 1", "\"container_law\": \"hard\"",
            "4: container_law: neither \"normal\" nor \"whole\""},
        Bad{"\"radius\": 250", "\"radius\": 0", "3: container.radius: not positive"},
        Bad{"\"radius\": 250", "\"radius\": -3", "3: container.radius: negative"},
        Bad{"\"radius\": 250", "\"radius\": 250, \"restitution\": 0",
            "3: container.restitution: not in (0, 1]"},
        Bad{"\"radius\": 250", "\"radius\": 250, \"restitution\": \"1001/1000\"",
            "3: container.restitution: not in (0, 1]"},
        Bad{", \"radius\": 250", "", "3: container.radius: missing"},
        Bad{"{\"center\": [0, 0], \"radius\": 250}", "[0, 0, 250]",
            "3: container: expected an object, found '['"},
        Bad{"[10.5, \"1/3\"]", "[10.5]", "7: disks[0].center: not an array of 2 elements"},
        Bad{"[10.5, \"1/3\"]", "[10.5, 1, 1]", "7: disks[0].center: not an array of 2 elements"},
        Bad{"[10.5, \"1/3\"]", "10.5", "7: disks[0].center: expected an array, found '1'"},
        Bad{"[\"-0.5\", 0]", "[1e999, 0]", "8: disks[1].velocity[0]: beyond the range of binary64"},
        Bad{"\"radius\": 3", "\"radius\": -3", "8: disks[1].radius: negative"},
        Bad{"\"mass\": 9", "\"mass\": 0", "8: disks[1].mass: not positive"},
        Bad{"\"mass\": 9", "\"mass\": -1", "8: disks[1].mass: not positive"},
        Bad{"\"mass\": 9", "\"Mass\": 9", "8: disks[1].Mass: unknown field"},
        Bad{"\"radius\": 2,", "\"radius\": 0,",
            "7: disks[0].mass: missing (a disk of radius 0 has no default)"},
        Bad{", \"velocity\": [1, 0]", "", "7: disks[0].velocity: missing"},
        Bad{"[-40, 0]", "[-248, 0]", "8: disks[1]: not inside the container, by 1"},
        Bad{"[-40, 0]", "[12, 0]", "8: disks[1]: overlaps disks[0] by 3.46341"},
        Bad{"[-40, 0], \"radius\": 3, \"velocity\": [\"-0.5\", 0]",
            "[-247, 0], \"radius\": 3, \"velocity\": [0, 1]",
            "8: disks[1]: touches the container with a tangential velocity"},
        Bad{"\"t\": 12.5, \"disk\": 0", "\"t\": 13, \"disk\": 0",
            "11: maneuvers[1].t: earlier than the maneuver before it"},
        Bad{"\"t\": 12.5, \"disk\": 0", "\"t\": -1, \"disk\": 0", "10: maneuvers[0].t: negative"},
        Bad{"\"disk\": 0", "\"disk\": 2", "10: maneuvers[0].disk: no such disk"},
        Bad{"\"disk\": 0", "\"disk\": -1", "10: maneuvers[0].disk: not in [0, 1999999]"},
        Bad{"\"disk\": 0", "\"disk\": 0.0", "10: maneuvers[0].disk: not an integer"},
        Bad{"\"disk\": 0", "\"disk\": 1",
            "11: maneuvers[1].disk: second maneuver of one disk at one time"},
        Bad{"]}\n", "]}\n{", "12: expected nothing more, found '{'"},
        Bad{"]}\n", "]\n", "12: maneuvers: unexpected end of input, expected ',' or '}'"},
        Bad{"\"velocity\": [0.5, 0]}]}\n", "\"velo\xff", "11: maneuvers[1]: invalid UTF-8"}));

TEST(Scene, EveryPrefixIsRefused) {
  const std::string text = joined(good_lines);
  for (std::size_t length = 0; length + 2 < text.size(); ++length) {
    const std::string message = fault(text.substr(0, length));
    ASSERT_TRUE(message.starts_with("s.json:")) << length;
    ASSERT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(Scene, LonePointNeedsNoMass) {
  std::string text = joined(good_lines);
  text = replaced(text, good_lines[7], "");
  text = replaced(text, good_lines[10], "");
  text = replaced(text, "\"velocity\": [1, 0]},", "\"velocity\": [1, 0]}],");
  text = replaced(text, "\"velocity\": [0.5, 0]},", "\"velocity\": [0.5, 0]}]}");
  text = replaced(text, "\"radius\": 2,", "\"radius\": 0,");
  EXPECT_EQ(parse(text).disks[0].mass, 0);
  expect_same(parse(written(parse(text))), parse(text));
}

TEST(Scene, LimitsAreTheWrittenDoubles) {
  const std::string text = joined(good_lines);
  for (const char* good : {"1e100", "1e-100", "\"1e100\"", "0", "\"0/7\""})
    EXPECT_EQ(fault(replaced(text, "\"horizon\": 1000", std::string("\"horizon\": ") + good)), "")
        << good;
}

TEST(Scene, FractionsTooLongToWriteAreRefused) {
  const std::string text = joined(good_lines);
  const auto with = [&](int digits) {
    return replaced(text, "\"horizon\": 1000",
                    "\"horizon\": \"0." + std::string(digits, '3') + "\"");
  };
  EXPECT_EQ(fault(with(3000)), "s.json:5: horizon: a fraction of more than 4096 characters");
  expect_same(parse(written(parse(with(2000)))), parse(with(2000)));
}

TEST(Scene, FilesThatCannotBeRead) {
  TemporaryDirectory directory;
  EXPECT_THROW(read_scene(directory.file("none")), InputError);
  EXPECT_THROW(read_scene(directory.file("")), InputError);
  const std::string path = directory.write("s.json", joined(good_lines));
  expect_same(read_scene(path), parse(joined(good_lines)));
  const std::string bad = directory.write("bad\n.json", "{");
  try {
    read_scene(bad);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    EXPECT_EQ(e.file(), bad);
    EXPECT_EQ(e.line(), 1);
  }
}

Rational any_value(bool positive) {
  const auto bits = *rc::gen::arbitrary<std::int64_t>();
  const int kind = *rc::gen::inRange(0, 3);
  const int scale = *rc::gen::inRange(-60, 60);
  Rational q = kind == 0   ? to_rational(std::ldexp(static_cast<double>(bits), scale))
               : kind == 1 ? Rational(Integer(std::to_string(bits)), Integer(std::abs(scale) + 1))
                           : Rational(bits % 1000, 1000);
  q.canonicalize();
  if (positive) q = abs(q) + Rational(1, 3);
  return q;
}

RC_GTEST_PROP(Scene, WritingAndReadingIsTheIdentity, ()) {
  Scene scene;
  scene.cx = any_value(false);
  scene.cy = any_value(false);
  scene.restitution = *rc::gen::element(Rational(1), Rational(0), Rational(1, 3));
  scene.container_restitution = *rc::gen::element(Rational(1), Rational(1, 2), Rational(1, 3));
  scene.law = *rc::gen::element(ContainerLaw::normal, ContainerLaw::whole);
  scene.horizon = any_value(true);
  const int n = *rc::gen::inRange(0, 6);
  // Disks in a row, each beyond the ones before it.
  Rational reach = 0;
  for (int i = 0; i < n; ++i) {
    DiskInput d;
    d.radius = *rc::gen::arbitrary<bool>() ? any_value(true) : Rational(0);
    reach += d.radius.value();
    d.x = Rational(scene.cx + reach);
    d.y = scene.cy;
    reach += d.radius.value() + any_value(true);
    d.vx = any_value(false);
    d.vy = any_value(false);
    d.mass = d.radius == 0 || *rc::gen::arbitrary<bool>() ? any_value(true) : d.radius * d.radius;
    scene.disks.push_back(d);
  }
  scene.container_radius = reach + 1;
  Rational t = 0;
  for (int i = 0; i < n; ++i) {
    scene.maneuvers.push_back({t, i, any_value(false), any_value(false)});
    if (*rc::gen::arbitrary<bool>()) t += any_value(true);
  }
  if (*rc::gen::arbitrary<bool>()) scene.name = "na\"me\n\xc3\xa9";
  if (*rc::gen::arbitrary<bool>()) scene.comment = "\\";
  scene.seed = *rc::gen::element<std::optional<std::variant<std::string, Integer>>>(
      std::nullopt, std::string("s"), Integer("-123456789012345678901234567890"));
  const std::string text = written(scene);
  const Scene again = parse(text);
  expect_same(scene, again);
  RC_ASSERT(!testing::Test::HasFailure());
  RC_ASSERT(written(again) == text);
}

}  // namespace
}  // namespace voroproof::internal
