// The paper's test of section 7.2: what it sees, and what it cannot see but certify does.
#include <set>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

class Check72Cli : public Cli {
 protected:
  void SetUp() override {
    scene_ = reference(40, "40");
    history_ = file("a.history.jsonl");
    must({"simulate", scene_, "-o", history_});
    lines_ = lines_of(directory_.read("a.history.jsonl"));
  }

  // The history with other lines; the counts of its last line follow.
  std::string written(const std::vector<std::string>& lines) const {
    std::string text;
    Json end = Json::parse(lines.back());
    int flips = 0;
    for (const std::string& line : lines) flips += line.find("\"flip\"") != std::string::npos;
    end["end"]["flips"] = flips;
    for (std::size_t k = 0; k + 1 < lines.size(); ++k) text += lines[k] + '\n';
    return directory_.write("b.history.jsonl", text + end.dump() + '\n');
  }

  // The line of a flip somewhere in the middle.
  std::size_t some_flip() const {
    std::size_t k = lines_.size() / 2;
    while (lines_[k].find("\"flip\"") == std::string::npos) ++k;
    return k;
  }

  void passes(const std::string& history) const {
    const Result result = run({"check72", scene_, history});
    EXPECT_EQ(result.code, 0) << result.out << result.err;
    EXPECT_EQ(lines_of(result.out).back(), "passed");
  }
  void is_refuted(const std::string& history) const {
    for (const std::string truth : {"exact", "recorded"}) {
      const Result result = run({"certify", scene_, history, "--truth", truth});
      EXPECT_EQ(result.code, 1) << truth << result.out << result.err;
    }
  }

  std::string scene_, history_;
  std::vector<std::string> lines_;
};

std::string flip_line(const Json& t, int l, int r, int s, int e) {
  Json quad = std::min(Json{l, r, s, e}, Json{r, l, e, s});
  return Json{{"t", t}, {"flip", std::move(quad)}}.dump();
}

TEST_F(Check72Cli, RightHistoriesPass) {
  passes(history_);
  for (const Arguments& family :
       {Arguments{"grid", "--n", "25"},
        Arguments{"reference", "--n", "30", "--radii", "log", "--rmin", "0.1", "--density", "0.3"},
        Arguments{"reference", "--n", "1"}, Arguments{"reference", "--n", "0"}}) {
    Arguments make{"generate", "-o", file("c.scene.json"), "--horizon", "20"};
    make.insert(make.begin() + 1, family.begin(), family.end());
    must(make);
    must({"simulate", file("c.scene.json"), "-o", file("c.history.jsonl")});
    const Result result = must({"check72", file("c.scene.json"), file("c.history.jsonl")});
    EXPECT_EQ(lines_of(result.out).back(), "passed");
    // k times 0.1 for k = 0 to 200.
    EXPECT_NE(result.out.find(" at 201 regular instants"), std::string::npos) << result.out;
  }
}

TEST_F(Check72Cli, SeesAFlipThatComesTooLate) {
  auto lines = lines_;
  const std::size_t k = some_flip();
  Json late = Json::parse(lines[k]);
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(k));
  // Up to the next event of its generators nothing else depends on it; half a time unit is enough.
  const double t = late["t"].get<double>() + 0.5;
  late["t"] = t;
  std::size_t at = k;
  while (at + 1 < lines.size() && Json::parse(lines[at])["t"].get<double>() <= t) ++at;
  lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(at), late.dump());
  const std::string history = written(lines);
  const Result result = run({"check72", scene_, history});
  EXPECT_EQ(result.code, 1) << result.out << result.err;
  EXPECT_EQ(lines_of(result.out).back(), "failed");
  is_refuted(history);
}

// Four disks at rest; a flip makes the wrong two of them neighbours. The circle of the centres of
// 0, 1 and 2 is then that around (0, -10.5) of radius 14.5, that of the disks has the radius 13.5,
// and disk 3, 6.5 from its centre, reaches in by 13.5 + 1 - 6.5.
TEST_F(Check72Cli, TellsHowFarADiskReachesIn) {
  scene_ = directory_.write("rest.scene.json",
                            R"({"format": "voroproof-scene", "version": 1,
 "container": {"center": [0, 0], "radius": 100}, "horizon": 10,
 "disks": [{"center": [-10, 0], "radius": 1, "velocity": [0, 0]},
  {"center": [10, 0], "radius": 1, "velocity": [0, 0]},
  {"center": [0, 4], "radius": 1, "velocity": [0, 0]},
  {"center": [0, -4], "radius": 1, "velocity": [0, 0]}]})");
  must({"simulate", scene_, "-o", file("rest.history.jsonl")});
  auto lines = lines_of(directory_.read("rest.history.jsonl"));
  ASSERT_EQ(lines.size(), 2u);
  const Json header = Json::parse(lines[0]);
  for (const Json& q : header["initial"]) {
    if (std::set<int>{q[0], q[1]} == std::set<int>{2, 3} &&
        std::set<int>{q[2], q[3]} == std::set<int>{0, 1}) {
      lines.insert(lines.begin() + 1, flip_line(5.05, q[0], q[1], q[2], q[3]));
      break;
    }
  }
  const Result result = run({"check72", scene_, written(lines)});
  EXPECT_EQ(result.code, 1);
  EXPECT_NE(result.out.find("at t = 5.1000000000000005 the circle of "), std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find(", by 8\n"), std::string::npos) << result.out;
}

// Between two instants that it looks at, anything may happen.
TEST_F(Check72Cli, CannotSeeAFlipAndItsReversal) {
  auto lines = lines_;
  const std::size_t k = some_flip();
  const Json flip = Json::parse(lines[k]);
  const int l = flip["flip"][0], r = flip["flip"][1], s = flip["flip"][2], e = flip["flip"][3];
  lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(k) + 1,
               {flip_line(flip["t"], s, e, r, l), flip_line(flip["t"], r, l, e, s)});
  const std::string history = written(lines);
  passes(history);
  is_refuted(history);
}

// It follows the recorded motion and does not ask whether that is the scene's.
TEST_F(Check72Cli, CannotSeeWrongCollisions) {
  std::string other = directory_.read("reference.scene.json");
  const std::string elastic = "\"restitution\": 1,";
  const std::size_t at = other.find(elastic);
  ASSERT_NE(at, std::string::npos);
  other.replace(at, elastic.size(), "\"restitution\": 0.5,");
  const std::string other_scene = directory_.write("other.scene.json", other);
  must({"simulate", other_scene, "-o", file("other.history.jsonl")});
  auto lines = lines_of(directory_.read("other.history.jsonl"));
  Json header = Json::parse(lines[0]);
  header["scene_sha256"] = Json::parse(lines_[0])["scene_sha256"];
  lines[0] = header.dump();
  const std::string history = written(lines);
  passes(history);
  is_refuted(history);
}

TEST_F(Check72Cli, NeedsTheMotion) {
  auto lines = lines_;
  std::size_t k = 0;
  while (lines[k].find("\"collide\"") == std::string::npos) ++k;
  Json collision = Json::parse(lines[k]);
  collision.erase("p");
  lines[k] = collision.dump();
  refused({"check72", scene_, written(lines)},
          "b.history.jsonl:" + std::to_string(k + 1) + ": p: missing, and needed for this test");
  refused({"check72", scene_, history_, "--step", "0"}, "--step");
}

}  // namespace
}  // namespace voroproof::internal
