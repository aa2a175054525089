// clearance as its users meet it.
#include "tests/apps/verbs/certify_cli.h"

namespace voroproof::internal {
namespace {

constexpr const char* kInterpolation =
    "c judged are the piecewise linear paths between the waypoints of the file\n";

TEST_F(CertifyCli, ClearanceOfATable) {
  const std::string table =
      written("a.csv", "disk,t,x,y,radius\na,0,0,0,1\na,2,4,0,1\nb,0,2,3,1\nb,2,2,3,1\n");
  const std::string out = file("o.json");
  EXPECT_EQ(must({"clearance", table, "--required", "1", "-o", out}).out,
            std::string(kInterpolation) + "c judged from t = 0 to t = 2\n" +
                "c least gap 1, of a b at t = 1\ns FREE\n");
  EXPECT_EQ(json("o.json")["verdict"], "FREE");
  EXPECT_EQ(json("o.json")["least"]["distance_squared"], 9);
  EXPECT_EQ(json("o.json")["from"], 0);
  EXPECT_EQ(json("o.json")["to"], 2);
  EXPECT_EQ(json("o.json")["missing"], Json::array());
  const Result refuted = run({"clearance", table, "--required", "1.0000000000000000001"});
  EXPECT_EQ(refuted.code, 1);
  EXPECT_EQ(refuted.out, std::string(kInterpolation) + "c judged from t = 0 to t = 2\n" +
                             "c least gap 1, of a b at t = 1\ns REFUTED\n");
  const std::string near = must({"clearance", table, "--below", "2", "-o", out}).out;
  EXPECT_NE(near.find("a b"), std::string::npos);
  EXPECT_EQ(json("o.json")["approaches"].size(), 1u);
  EXPECT_EQ(json("o.json")["approaches"][0]["least"]["t"], 1);
}

// What a table says of itself is said wherever something is said of its paths.
TEST_F(CertifyCli, RemarksOfATableAreRepeated) {
  const std::string table =
      written("r.csv", "# remark: walls are left out\ndisk,t,x,y,radius\na,0,0,0,1\na,1,0,1,1\n");
  EXPECT_EQ(must({"clearance", table, "-o", file("o.json")}).out,
            std::string(kInterpolation) + "c walls are left out\nc judged from t = 0 to t = 1\n" +
                "c no two disks are there at one time\n");
  EXPECT_EQ(json("o.json")["remarks"][1], "walls are left out");
  const std::string told = must({"convert", table, "-o", file("r.scene.json")}).out;
  EXPECT_NE(told.find("\nwalls are left out\n"), std::string::npos) << told;
}

// The scene of given paths meets their waypoints exactly, at times that are no binary64.
TEST_F(CertifyCli, ScenesOfPaths) {
  const std::string table = written(
      "p.csv",
      "disk,t,x,y,radius\na,1,0,0,1/3\nb,1,9,9,0\na,4/3,0.1,0.7,1/3\na,2,3,1,1/3\nb,2,9,9,0\n");
  const std::string scene = file("p.scene.json"), path = file("p.history.jsonl");
  must({"convert", table, "-o", scene});
  EXPECT_EQ(json("p.scene.json")["horizon"], 1);
  must({"simulate", scene, "-o", path});
  EXPECT_EQ(verdict({scene, path, "--kernel"}), "s CERTIFIED");
  must({"snapshot", scene, "--at", "1/3", "-o", file("d.json")});
  EXPECT_EQ(json("d.json")["disks"][0]["center"], Json::array({0.1, 0.7}));
  must({"snapshot", scene, "--at", "1", "-o", file("d.json")});
  EXPECT_EQ(json("d.json")["disks"][0]["center"], Json::array({3, 1}));
  EXPECT_EQ(json("d.json")["disks"][1]["center"], Json::array({9, 9}));
  const auto convert = [&](const char* text) -> Arguments {
    return {"convert", written("q.csv", text), "--radius", "1", "-o", file("q.scene.json")};
  };
  refused(convert("disk,t,x,y\n#missing: a ship\na,0,0,0\na,1,4,0\nb,0,3,9\nb,1,3,9\n"),
          "q.csv:2: missing: a ship: a scene cannot say that somebody is missing");
  refused(convert("disk,t,x,y\na,0,0,0\na,1,4,0\nb,0,3,1\nb,1,3,1\n"),
          "disks a and b: overlap by 1 at t = 0.75: ");
  refused(convert("disk,t,x,y\na,0,0,0\na,1,4,0\nb,0,3,2\nb,1,3,2\n"),
          "disks a and b: touch at t = 0.75: ");
  refused(convert("disk,t,x,y\na,0,0,0\na,1,4,0\nb,0,3,9\nb,2,3,1\n"),
          "disk b: is there from 0 to 2");
  Arguments stay = convert("disk,t,x,y\na,0,0,0\na,1,4,0\nb,0,3,9\nb,2,3,4\n");
  stay.push_back("--stay");
  EXPECT_NE(must(stay).out.find("1 of 2 disks are taken to stay"), std::string::npos);
  EXPECT_EQ(json("q.scene.json")["horizon"], 2);
  EXPECT_EQ(json("q.scene.json")["maneuvers"].size(), 1u);
}

// Nobody is free of what was not looked at.
TEST_F(CertifyCli, FreeOfNothingIsUndecided) {
  const auto judged = [&](const std::string& rows) {
    return run({"clearance", written("a.csv", "disk,t,x,y\n" + rows), "--radius", "1", "--vanish",
                "--required", "0", "-o", file("o.json")});
  };
  const std::string apart = "a,0,0,0\na,1,0,0\nb,0,9,0\nb,1,9,0\n";
  EXPECT_EQ(judged(apart).code, 0);
  for (const std::string& nobody : {std::string(), std::string("a,0,0,0\na,1,4,0\n"),
                                    std::string("a,0,0,0\na,1,4,0\nb,2,0,0\nb,3,0,0\n")}) {
    const Result result = judged(nobody);
    EXPECT_EQ(result.code, 3);
    EXPECT_NE(result.out.find("c no two disks are there at one time\ns UNDECIDED\n"),
              std::string::npos);
    EXPECT_EQ(json("o.json")["verdict"], "UNDECIDED");
  }
  const Result lacking = judged("# missing: the images of b\n" + apart);
  EXPECT_EQ(lacking.code, 3);
  EXPECT_NE(lacking.out.find("c missing: the images of b\n"), std::string::npos);
  EXPECT_NE(lacking.out.find("\ns UNDECIDED\n"), std::string::npos);
  EXPECT_EQ(json("o.json")["missing"], Json::array({"the images of b"}));
  // What is missing takes nothing back.
  EXPECT_EQ(judged("# missing: the images of b\n" + apart + "c,0,9,0\nc,1,9,0\n").code, 1);
}

// One that has arrived, and one that passes there afterwards.
TEST_F(CertifyCli, WhereDisksAreBeyondTheirPathsIsSaid) {
  const std::string table =
      written("p.csv", "disk,t,x,y\nquick,0,2,0\nquick,1,3,0\nslow,0,0,0\nslow,5,5,0\n");
  const std::string plan = written("p.xml", R"(<root><log>
    <agent number="quick"><path><section start_i="2" start_j="0" goal_i="3" goal_j="0" duration="1"/>
    </path></agent><agent number="slow"><path>
    <section start_i="0" start_j="0" goal_i="5" goal_j="0" duration="5"/></path></agent>
    </log></root>)");
  for (const std::string& paths : {table, plan}) {
    const auto judged = [&](const Arguments& beyond) {
      Arguments all{"clearance", paths, "--radius", "0.3", "--required", "0"};
      all.insert(all.end(), beyond.begin(), beyond.end());
      return run(all);
    };
    refused({"clearance", paths, "--radius", "0.3"}, "disk quick: has waypoints from t = 0 to 1");
    const Result unsaid = judged({});
    EXPECT_EQ(unsaid.code, 2);
    EXPECT_EQ(unsaid.out, "s INVALID\n");
    const Result stays = judged({"--stay"});
    EXPECT_EQ(stays.code, 1);
    EXPECT_NE(stays.out.find("1 of 2 disks are taken to stay"), std::string::npos);
    EXPECT_NE(stays.out.find("c least gap -0.6 (they overlap), of quick slow at t = 3\n"),
              std::string::npos)
        << stays.out;
    const Result vanishes = judged({"--vanish"});
    EXPECT_EQ(vanishes.code, 0);
    EXPECT_NE(vanishes.out.find("1 of 2 disks are taken to be nowhere"), std::string::npos);
    EXPECT_EQ(judged({"--stay", "--vanish"}).code, 2);
  }
}

// Three disks of which two touch at t = 5; the third is to turn at 1.5.
TEST_F(CertifyCli, NoHistoryIsFreeOfWhatItDoesNotTell) {
  const std::string whole = written("t.scene.json", R"({"format":"voroproof-scene","version":1,
    "container":{"center":[0,0],"radius":20},"horizon":12,"disks":[
    {"center":[-6,"1/3"],"radius":2,"velocity":[1,0]},
    {"center":[4,"1/3"],"radius":3,"velocity":[0,0],"mass":4},
    {"center":[5,-11],"radius":1,"velocity":[0,0]}],
    "maneuvers":[{"t":1.5,"disk":2,"velocity":[1,0]},
    {"t":20,"disk":2,"velocity":[0,0]}]})");
  const std::string right = file("t.history.jsonl");
  must({"simulate", whole, "-o", right});
  EXPECT_EQ(run({"clearance", whole, right, "--required", "0"}).code, 1);
  const std::string header = lines_of(read_file(right))[0];
  const auto judged = [&](const std::string& horizon, const std::string& events,
                          const std::string& end) {
    std::string text = header;
    text.replace(text.find("\"horizon\":12"), 12, "\"horizon\":" + horizon);
    return run({"clearance", whole, written("s.history.jsonl", text + "\n" + events + end + "\n"),
                "--required", "0"});
  };
  const auto lacks = [&](const Result& result, const std::string& what) {
    EXPECT_EQ(result.code, 3) << result.out;
    EXPECT_NE(result.out.find("c missing: " + what + "\n"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("\ns UNDECIDED\n"), std::string::npos) << result.out;
  };
  const std::string turn = "{\"t\":1.5,\"maneuver\":2,\"v\":[1,0],\"p\":[5,-11]}\n";
  const auto end = [](const std::string& t, const std::string& maneuvers) {
    return R"({"end":{"t":)" + t + R"(,"flips":0,"collisions":0,"maneuvers":)" + maneuvers + "}}";
  };
  const std::string rest = ", to the scene's horizon, 12";
  lacks(judged("0", "", end("0", "0")), "the time from t = 0, where the history ends" + rest);
  lacks(judged("4", turn, end("4", "1")), "the time from t = 4, where the history ends" + rest);
  lacks(judged("12", "", R"({"stopped":{"t":1,"reason":"x","events":[]}})"),
        "the time from t = 1, where the history stops" + rest);
  const std::string maneuver =
      "a maneuver of the scene, not in the history as scheduled: disk 2 at t = 1.5";
  lacks(judged("4", "", end("4", "0")), maneuver);
  std::string other = turn;
  lacks(judged("4", other.replace(other.find("[1,0]"), 5, "[1,1]"), end("4", "1")), maneuver);
  other = turn;
  lacks(judged("4", other.replace(other.find("1.5"), 3, "2.5"), end("4", "1")), maneuver);
  other = turn;
  const Result surplus =
      judged("12", turn + other.replace(other.find("1.5"), 3, "3.5"), end("12", "2"));
  EXPECT_NE(surplus.out.find("c missing: the scene has no such maneuver: disk 2 at t = 3.5\n"),
            std::string::npos)
      << surplus.out;
}

// The scene's maneuvers are known: a history without one of them is not that of its true motion.
TEST_F(CertifyCli, ConstructedDiagramsLackNoManeuver) {
  std::string text = read_file(reference(12, "20"));
  text.insert(text.rfind('}'), R"(,"maneuvers":[{"t":1,"disk":3,"velocity":[0,0]}])");
  const std::string scene = written("m.scene.json", text), path = file("m.history.jsonl");
  must({"simulate", scene, "-o", path});
  must({"snapshot", scene, path, "--at", "2", "--construct", "1", "-o", file("d.json")});
  std::string lacking;
  for (std::string line : lines_of(read_file(path))) {
    if (const auto at = line.find("\"maneuvers\":1"); at != std::string::npos) line[at + 12] = '0';
    if (line.find("\"maneuver\"") == std::string::npos) lacking += line + "\n";
  }
  refused({"query", "closest", scene, written("l.history.jsonl", lacking), "--at", "2"},
          "lacks the maneuver of disk 3 that the scene schedules at t = 1");
}

constexpr const char* kScene = R"({"format":"voroproof-scene","version":1,
  "container":{"center":[0,0],"radius":10},"horizon":6,"disks":[
  {"center":[-4,0],"radius":1,"velocity":[1,0]},{"center":[4,0],"radius":1,"velocity":[-1,0]}]})";

// Two that collide at t = 3, at the gap 6 - 2t before and 2(t - 3) after; the wall is 5 away at
// first.
TEST_F(CertifyCli, ClearanceOfAHistory) {
  const std::string scene = written("c.scene.json", kScene), history = file("c.history.jsonl");
  must({"simulate", scene, "-o", history});
  const std::string out = file("o.json");
  const Result told =
      run({"clearance", scene, history, "--required", "0", "--below", "2", "-o", out});
  EXPECT_EQ(told.code, 1);
  EXPECT_NE(told.out.find("c the history is not judged: certify does that\n"), std::string::npos);
  EXPECT_NE(told.out.find("c least gap 0, of 0 1 at t = 3\n"
                          "c least gap to the container 5, of 0 wall at t = 0\n"),
            std::string::npos)
      << told.out;
  EXPECT_NE(told.out.find("s REFUTED"), std::string::npos);
  const Json answer = json("o.json");
  EXPECT_EQ(answer["least"]["distance_squared"], 4);
  EXPECT_EQ(answer["container"]["radius"], 10);
  EXPECT_EQ(answer["approaches"].size(), 1u);
  EXPECT_EQ(answer["approaches"][0]["from"], Json::array({2, 2}));
  EXPECT_EQ(answer["approaches"][0]["to"], Json::array({4, 4}));
  EXPECT_EQ(answer["approaches_to_container"].size(), 0u);
  must({"clearance", scene, history, "--below", "6", "-o", out});
  EXPECT_EQ(json("o.json")["approaches_to_container"].size(), 4u);
}

// At a collision that is none the recorded paths tell, also after a right one; and that no gap is
// too small proves nothing then.
TEST_F(CertifyCli, ClaimedCollisionsHideNoOverlap) {
  const std::string scene = written("c.scene.json", kScene), right = file("c.history.jsonl");
  must({"simulate", scene, "-o", right});
  const std::string header = lines_of(read_file(right))[0], out = file("o.json");
  struct Claims {
    std::string lines;
    int count;
    double gap, t, to_container;
    bool contact;
  };
  const std::string first = R"({"t":3,"collide":[0,1],"v":[[-1,0],[1,0]]})"
                            "\n";
  for (const Claims& claims :
       std::vector<Claims>{{first, 1, 0, 3, 5, true},
                           {R"({"t":3.5,"collide":[0,1],"v":[[-1,0],[1,0]]})"
                            "\n",
                            1, -1, 3.5, 5, false},
                           {R"({"t":1,"collide":[0,1],"v":[[0,0],[0,0]]})"
                            "\n",
                            1, 4, 1, 5, false},
                           {R"({"t":1,"collide":[-1,0],"v":[null,[-1,0]]})"
                            "\n",
                            1, 4, 1, 1, false},
                           {first + R"({"t":4,"collide":[0,1],"v":[[1,0],[-1,0]]})"
                                    "\n"
                                    R"({"t":5.5,"collide":[0,1],"v":[[-1,0],[1,0]]})"
                                    "\n",
                            3, -1, 5.5, 5, false}}) {
    const std::string history =
        written("w.history.jsonl", header + "\n" + claims.lines +
                                       R"({"end":{"t":6,"flips":0,"maneuvers":0,"collisions":)" +
                                       std::to_string(claims.count) + "}}\n");
    const bool apart = claims.gap > 0;
    EXPECT_EQ(run({"clearance", scene, history, "--required", "0", "-o", out}).code, apart ? 3 : 1);
    const Json answer = json("o.json"), least = answer["least"];
    EXPECT_EQ(answer["verdict"], apart ? "UNDECIDED" : "REFUTED") << claims.lines;
    EXPECT_EQ(answer["missing"].size(), claims.contact ? 0U : 1U) << claims.lines;
    EXPECT_EQ(least["gap"], Json::array({claims.gap, claims.gap})) << claims.lines;
    EXPECT_EQ(least["t"], claims.t) << claims.lines;
    EXPECT_EQ(least["distance_squared"], (claims.gap + 2) * (claims.gap + 2)) << claims.lines;
    EXPECT_EQ(answer["least_to_container"]["gap"],
              Json::array({claims.to_container, claims.to_container}))
        << claims.lines;
    for (Arguments query : {Arguments{"gap-over", scene, history, "--pair", "0", "1"},
                            Arguments{"closest-over", scene, history}}) {
      query.insert(query.begin(), "query");
      query.insert(query.end(), {"-o", out});
      must(query);
      EXPECT_EQ(json("o.json")["gap"], least["gap"]) << claims.lines;
      EXPECT_EQ(json("o.json")["t"], Json::array({claims.t, claims.t})) << claims.lines;
      EXPECT_EQ(json("o.json")["contact"], claims.contact) << claims.lines;
    }
  }
}

// Roundings of an absurd speed would explain any overlap.
TEST_F(CertifyCli, ClaimedSpeedsHideNoOverlap) {
  const std::string scene = written("f.scene.json", R"({"format":"voroproof-scene","version":1,
"horizon":3,"container":{"center":[0,0],"radius":100},"disks":[
{"center":[0,0],"radius":1,"velocity":[0,0]},{"center":[2,0],"radius":1,"velocity":[0,0]},
{"center":[0,40],"radius":1,"velocity":[0,0]}]})");
  const std::string right = file("f.history.jsonl");
  must({"simulate", scene, "-o", right});
  const std::string wrong = written("g.history.jsonl", lines_of(read_file(right))[0] + R"(
{"t":1,"collide":[0,1],"v":[[0,1e16],[0,0]]}
{"t":1.0000000000000002,"collide":[0,1],"v":[[0,18.4],[0,0]]}
{"t":3,"collide":[0,2],"v":[[0,0],[0,0]]}
{"end":{"t":3,"flips":0,"collisions":3,"maneuvers":0}}
)");
  EXPECT_EQ(run({"clearance", scene, wrong, "--required", "0", "--may-touch"}).code, 1);
}

// The gap to the container is one to keep, too.
TEST_F(CertifyCli, OneDiskOfAHistoryIsFree) {
  const std::string scene = written("l.scene.json", R"({"format":"voroproof-scene","version":1,
    "container":{"center":[0,0],"radius":10},"horizon":4,"disks":[
    {"center":[0,0],"radius":1,"velocity":[1,0]}]})");
  must({"simulate", scene, "-o", file("l.history.jsonl")});
  const Result told = run({"clearance", scene, file("l.history.jsonl"), "--required", "0"});
  EXPECT_EQ(told.code, 0);
  EXPECT_EQ(told.out.find("no two disks"), std::string::npos) << told.out;
  EXPECT_NE(told.out.find("c least gap to the container 5, of 0 wall at t = 4\ns FREE\n"),
            std::string::npos)
      << told.out;
}

// By all legs here, by the diagram there.
TEST_F(CertifyCli, ClearanceAgreesWithTheClosestPair) {
  for (const char* kind : {"swarm", "reference"}) {
    const std::string scene = file("s.scene.json"), history = file("s.history.jsonl");
    must({"generate", kind, "--n", "9", "--seed", "2", "--horizon", "5", "-o", scene});
    must({"simulate", scene, "-o", history});
    must({"clearance", scene, history, "-o", file("o.json")});
    must({"query", "closest-over", scene, history, "-o", file("q.json")});
    const Json least = json("o.json")["least"], closest = json("q.json");
    EXPECT_EQ(least["disks"][0]["disk"], std::to_string(closest["pair"][0].get<int>()));
    EXPECT_EQ(least["disks"][1]["disk"], std::to_string(closest["pair"][1].get<int>()));
    EXPECT_NEAR(least["gap"][0].get<double>(), closest["gap"][0].get<double>(), 1e-14);
  }
}

TEST_F(CertifyCli, ClearanceOfAHistoryRefusesBadInput) {
  const std::string scene = written("c.scene.json", kScene), history = file("c.history.jsonl");
  must({"simulate", scene, "-o", history});
  refused({"clearance", scene, history, "--radius", "1"}, "--radius");
  refused({"clearance", scene, history, "--stay"}, "--stay");
  refused({"clearance", history, scene}, "the scene comes first");
  const std::string other = file("other.scene.json");
  must({"generate", "grid", "--n", "4", "-o", other});
  refused({"clearance", other, history}, "scene_sha256");
}

TEST_F(CertifyCli, ClearanceRefusesBadInput) {
  refused({"clearance", written("b.csv", "disk,t,x,y\na,0,0,0\n")}, "no radius is given");
  refused({"clearance", written("b.csv", "disk,t,x,y\na,0,0\n"), "--radius", "1"}, "b.csv:2");
  refused({"clearance", written("b.csv", "disk,t,x,y\na,0,0,0\n"), "--radius", "-1"}, "--radius");
  refused({"clearance", file("none.csv"), "--radius", "1"}, "none.csv");
}

}  // namespace
}  // namespace voroproof::internal
