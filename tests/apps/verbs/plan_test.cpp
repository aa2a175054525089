// The verb plan, as a user runs it, and its files.
#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

class PlanCli : public Cli {
 protected:
  // A plan file of vehicles with radius 1.
  std::string plan_file(const std::string& vehicles) const {
    return directory_.write("a.plan.json",
                            R"({"format": "voroproof-plan", "version": 1,
 "container": {"center": [0, 0], "radius": 50},
 "arrive": 10, "clearance": "1/3",
 "vehicles": [)" + vehicles + "]}\n");
  }
};

constexpr char crossing[] = R"(
  {"id": 0, "radius": 1, "start": [-10, 0], "goal": [10, 0]},
  {"id": 1, "radius": 1, "start": [0, -10], "goal": ["1/3", 10]})";

TEST_F(PlanCli, PlansAreScenesThatAreCertified) {
  for (const std::string preset : {"five", "square-to-circle", "h-to-y", "drones58"}) {
    const std::string scene = file("p.scene.json"), history = file("p.history.jsonl");
    must({"plan", "--preset", preset, "-o", scene, "--report", file("p.report.json")});
    EXPECT_NE(must({"simulate", scene, "-o", history}).out.find("collisions 0"), std::string::npos);
    EXPECT_NE(must({"certify", scene, history}).out.find("s CERTIFIED"), std::string::npos);
    const Json report = json("p.report.json");
    EXPECT_TRUE(report["found"]);
    EXPECT_GE(report["minimum_gap"]["gap"]["from"], report["clearance"]);
    EXPECT_LE(report["minimum_gap"]["gap"]["from"], report["minimum_gap"]["gap"]["to"]);
  }
}

TEST_F(PlanCli, ReadsPlanFiles) {
  const std::string plan = plan_file(crossing), scene = file("a.scene.json");
  EXPECT_EQ(must({"validate", plan}).out,
            plan + ": plan: 2 vehicles, clearance \"1/3\", arrive 10\n");
  must({"plan", plan, "-o", scene, "--report", file("a.report.json"), "--picture", file("a.svg")});
  const Json report = json("a.report.json");
  EXPECT_EQ(report["clearance"], "1/3");
  EXPECT_EQ(report["speed_changes"], 2);
  EXPECT_EQ(report["avoided"].size(), 1u);
  EXPECT_EQ(report["vehicles"][1]["way"].back(), Json::parse(R"([10, "1/3", 10])"));
  EXPECT_NE(directory_.read("a.svg").find("<svg"), std::string::npos);
  // The plan is made again, and then with other wishes.
  const std::string bytes = directory_.read("a.scene.json");
  must({"plan", plan, "-o", scene});
  EXPECT_EQ(directory_.read("a.scene.json"), bytes);
  must({"plan", plan, "-o", scene, "--clearance", "2.5", "--arrive", "20", "--assignment",
        "optimal", "--report", file("a.report.json")});
  EXPECT_EQ(json("a.report.json")["clearance"], 2.5);
  EXPECT_EQ(json("a.scene.json")["horizon"], 20);
}

TEST_F(PlanCli, NothingFarBeyondTheContainerIsDrawn) {
  const std::string report = file("a.report.json"), picture = file("p.svg");
  must({"plan", plan_file(crossing), "-o", file("a.scene.json"), "--report", report});
  const Json whole = json("a.report.json");
  Json changed = whole;
  changed["container"]["radius"] = 1e-100;
  directory_.write("a.report.json", changed.dump());
  refused({"render", report, "-o", picture}, "vehicles[0].radius: far beyond the container");
  changed = whole;
  changed["vehicles"][1]["way"][0][2] = -1e30;
  directory_.write("a.report.json", changed.dump());
  refused({"render", report, "-o", picture}, "vehicles[1].way[0]: far beyond the container");
  // A container that is as large as it may be stands for none.
  changed = whole;
  changed["container"]["radius"] = 1e100;
  directory_.write("a.report.json", changed.dump());
  must({"render", report, "-o", picture});
}

// `render` draws the picture of the plan from the report.
TEST_F(PlanCli, ReportsAreDrawn) {
  const std::string scene = file("a.scene.json"), report = file("a.report.json");
  must({"plan", plan_file(crossing), "-o", scene, "--report", report, "--picture", file("a.svg")});
  must({"render", report, "-o", file("again.svg")});
  EXPECT_EQ(directory_.read("again.svg"), directory_.read("a.svg"));
  // The ways cross in the middle, about, where both would be at half the time.
  const Json place = json("a.report.json")["avoided"][0]["place"];
  EXPECT_NEAR(place[0], 0, 0.5);
  EXPECT_NEAR(place[1], 0, 0.5);
  Json changed = json("a.report.json");
  changed["avoided"].clear();
  directory_.write("b.report.json", changed.dump());
  must({"render", file("b.report.json"), "-o", file("b.svg")});
  EXPECT_NE(directory_.read("b.svg"), directory_.read("a.svg"));
  for (const std::string vehicles :
       {"", R"({"id": 0, "radius": 0, "start": [1, 1], "goal": [1, 1]})"}) {
    must({"plan", plan_file(vehicles), "-o", scene, "--report", report});
    must({"render", report, "-o", file("few.png")});
  }
  const auto bad = [&](const std::string& member, const Json& value, const std::string& message) {
    Json json = changed;
    if (value.is_null()) {
      json.erase(member);
    } else {
      json[member] = value;
    }
    directory_.write("bad.json", json.dump());
    refused({"render", file("bad.json"), "-o", file("bad.svg")}, message);
  };
  bad("container", {}, "bad.json: container: missing");
  bad("vehicles", "none", "bad.json: vehicles: not an array");
  bad("version", 2, "bad.json: version: the file is of version 2");
  bad("minimum_gap", Json::parse(R"({"pair": [0, 2], "t": 1})"),
      "minimum_gap.pair[1]: no vehicle 2");
  bad("avoided", Json::parse(R"([{"place": ["x", 0]}])"), "avoided[0].place[0]: not a number: x");
  bad("format", "voroproof-scene", "bad.json:1: format: neither a diagram nor a report of a plan");
  refused({"render", report, "--probe", "1", "-o", file("bad.svg")}, "--probe: a plan has no");
  refused({"render", report, "-o", file("bad.gif")}, "--output: ");
}

// A velocity of 1e-150 is none of a scene.
TEST_F(PlanCli, WritesValidScenesOrNone) {
  refused({"plan", plan_file(R"({"id": 0, "radius": 1, "start": [0, 0], "goal": ["1e-60", 0]})"),
           "-o", file("a.scene.json"), "--arrive", "1e90"},
          "plan: gives no valid scene: disks[0].velocity[0]: ");
}

TEST_F(PlanCli, SaysWhereThereIsNoPlan) {
  const std::string scene = file("a.scene.json");
  const std::string same_goal = plan_file(R"(
  {"id": 0, "radius": 1, "start": [-10, 0], "goal": [10, 0]},
  {"id": 1, "radius": 1, "start": [0, -10], "goal": [11, 0]})");
  Result result = run({"plan", same_goal, "-o", scene, "--report", file("r.json")});
  EXPECT_EQ(result.code, 1);
  EXPECT_NE(
      result.err.find("no plan exists: too near at the ends: vehicles 0 and 1 at t = 10, gap -1"),
      std::string::npos)
      << result.err;
  EXPECT_EQ(json("r.json")["impossible"]["t"], 10);
  const std::string swap = plan_file(R"(
  {"id": 0, "radius": 1, "start": [-10, 0], "goal": [10, 0]},
  {"id": 1, "radius": 1, "start": [10, 0], "goal": [-10, 0]})");
  result = run({"plan", swap, "-o", scene});
  EXPECT_EQ(result.code, 3);
  EXPECT_NE(result.err.find("no plan found: too near: vehicles 0 and 1 at t = 5, gap -2"),
            std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("--assignment optimal"), std::string::npos);
  EXPECT_THROW(json("a.scene.json"), std::exception);  // no scene was written
  // With the goals exchanged nobody moves.
  must({"plan", swap, "-o", scene, "--assignment", "optimal"});
}

TEST_F(PlanCli, RefusesWhatIsNoPlan) {
  const std::string scene = file("a.scene.json");
  const auto bad = [&](const std::string& vehicles, const std::string& message) {
    refused({"plan", plan_file(vehicles), "-o", scene}, message);
  };
  bad(R"({"id": 1, "radius": 1, "start": [0, 0], "goal": [1, 0]})",
      "a.plan.json:4: vehicles[0].id: not 0");
  bad(R"({"id": 0, "radius": 1, "start": [0, 0], "goal": [49, 0]})",
      "a.plan.json:4: vehicles[0].goal: not strictly inside the container");
  bad(R"({"id": 0, "radius": -1, "start": [0, 0], "goal": [4, 0]})",
      "vehicles[0].radius: negative");
  bad(R"({"id": 0, "radius": 1, "start": [0, 0]})", "vehicles[0].goal: missing");
  bad(R"({"id": 0, "radius": 1, "start": [0, 0], "goal": [1, 1], "speed": 1})", "speed");
  refused({"plan", "-o", scene}, "either a plan file or --preset");
  refused({"plan", plan_file(crossing), "--preset", "five", "-o", scene}, "either a plan file");
  refused({"plan", "--preset", "six", "-o", scene}, "--preset");
  refused({"plan", "--preset", "five", "--arrive", "0", "-o", scene}, "--arrive");
  refused({"plan", "--preset", "five", "--clearance", "-1", "-o", scene}, "--clearance");
  refused({"plan", plan_file(crossing), "-o", file("a.plan.json")}, "input as well as an output");
  refused({"plan", "--preset", "five", "-o", scene, "--picture", file("p.gif")}, "--picture: ");
}

}  // namespace
}  // namespace voroproof::internal
