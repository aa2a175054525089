// Histories as they are written: byte by byte, whole or not at all, and read back the same.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "history/error.h"
#include "history/history_reader.h"
#include "history/history_writer.h"
#include "tests/history/example_history.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal::testing {
namespace {

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
}

TEST(HistoryWriter, WritesToADeviceAndDoesNotReplaceIt) {
  HistoryWriter writer("/dev/null");
  EXPECT_TRUE(writer.is_stream());
  writer.header(example_header());
  writer.stopped(0, "no more", {});
  EXPECT_EQ(writer.close_beside_complete(), "/dev/null");
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

}  // namespace
}  // namespace voroproof::internal::testing
