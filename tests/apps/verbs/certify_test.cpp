// certify as its users meet it: verdicts, exit codes, reports.
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/apps/verbs/certify_cli.h"

namespace voroproof::internal {
namespace {

TEST_F(CertifyCli, OwnHistoriesUnderBothTruths) {
  const std::string scene = reference(30, "40"), path = history(scene);
  EXPECT_EQ(verdict({scene, path}), "s CERTIFIED");
  EXPECT_EQ(verdict({scene, path, "--truth", "recorded"}), "s CERTIFIED");
  EXPECT_EQ(verdict({scene, path, "--strict", "--report", file("r.json")}), "s CERTIFIED");
  const Json report = json("r.json");
  EXPECT_EQ(report["verdict"], "CERTIFIED");
  EXPECT_LE(report["time_error_ulps"]["max"].get<double>(), 0.5000001);
  EXPECT_EQ(report["certified_prefix"]["events"].get<std::size_t>(),
            lines_of(read_file(path)).size() - 2);
}

// The libraries below say nothing of their own about it.
TEST_F(CertifyCli, MoreThreadsThanTheMachineHas) {
  const std::string scene = reference(2000, "0.1"), path = history(scene);
  for (const char* truth : {"exact", "recorded"}) {
    const Result out = must({"certify", scene, path, "--truth", truth, "--threads", "1000",
                             "--quiet", "--report", file("r.json")});
    EXPECT_EQ(lines_of(out.out).back(), "s CERTIFIED");
    EXPECT_EQ(out.err, "");
  }
}

// The verdict on collisions alone cannot be taken for the whole claim: stdout and report say so
// whatever the options.
TEST_F(CertifyCli, CollisionsAlone) {
  const std::string scene = reference(30, "40"), path = history(scene);
  const std::string bare = edited(path, [](std::vector<std::string>& lines) {
    std::erase_if(lines, [](const std::string& l) { return l.find("\"flip\"") < l.size(); });
    lines.front().replace(lines.front().find(",\"initial\""), std::string::npos, "}");
    std::string& end = lines.back();
    const std::size_t count = end.find("\"flips\":") + 8;
    end.replace(count, end.find(',', count) - count, "0");
  });
  EXPECT_EQ(verdict({scene, bare}), "s REFUTED");
  for (const char* truth : {"exact", "recorded"}) {
    const Result out = must({"certify", scene, bare, "--truth", truth, "--events", "collisions",
                             "--quiet", "--report", file("r.json")});
    EXPECT_EQ(out.out, "c collisions and maneuvers, " + std::string(truth) +
                           " truth, up to t = 40, times within 1e-6, velocities within 1e-9\n"
                           "c flips were not judged (0 in the history), and no diagram is claimed\n"
                           "s CERTIFIED\n");
    const Json report = json("r.json");
    EXPECT_EQ(report["events"], "collisions");
    EXPECT_EQ(report["flips_not_judged"], 0);
    EXPECT_EQ(report["proved"]["flips"], 0);
    EXPECT_GT(report["proved"]["collisions"], 0);
    const std::string explained = must({"explain", file("r.json")}).out;
    EXPECT_NE(explained.find(": CERTIFIED (collisions alone).\n"), std::string::npos) << explained;
    EXPECT_NE(explained.find("flips were not judged"), std::string::npos) << explained;
  }
  const std::string missing = edited(bare, [](auto& lines) { lines.erase(lines.begin() + 1); });
  EXPECT_EQ(verdict({scene, missing, "--events", "collisions"}), "s REFUTED");
  EXPECT_EQ(run({"certify", scene, path, "--events", "collisions", "--kernel"}).code, 2);
}

TEST_F(CertifyCli, SmallestScenes) {
  for (const char* n : {"0", "1", "2", "3"}) {
    const std::string scene = reference(std::stoi(n), "20"), path = history(scene);
    EXPECT_EQ(verdict({scene, path}), "s CERTIFIED") << n;
    EXPECT_EQ(verdict({scene, path, "--truth", "recorded"}), "s CERTIFIED") << n;
  }
}

TEST_F(CertifyCli, FaultsAreRefutedWithTheirLine) {
  const std::string scene = reference(30, "40"), path = history(scene);
  std::size_t dropped = 0;
  const std::string bad = edited(path, [&](std::vector<std::string>& lines) {
    while (lines[++dropped].find("flip") == std::string::npos) {
    }
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(dropped));
  });
  for (const char* truth : {"exact", "recorded"}) {
    EXPECT_EQ(verdict({scene, bad, "--truth", truth, "--report", file("r.json")}), "s REFUTED");
    const Json report = json("r.json");
    EXPECT_EQ(report["verdict"], "REFUTED");
    EXPECT_EQ(report["divergence"]["kind"], "missing event");
    EXPECT_EQ(report["divergence"]["line"].get<std::size_t>(), dropped + 1);
  }
}

TEST_F(CertifyCli, ReportsAreExplainedAndDrawn) {
  const std::string scene = reference(30, "40"), path = history(scene);
  const std::string bad = edited(path, [](auto& lines) {
    lines.erase(lines.begin() + 1);
    lines.erase(lines.begin() + 1);
  });
  EXPECT_EQ(verdict({scene, bad, "--report", file("r.json")}), "s REFUTED");
  const std::string words = must({"explain", file("r.json")}).out;
  EXPECT_NE(words.find("REFUTED"), std::string::npos);
  EXPECT_NE(words.find("Exactly one root lies between"), std::string::npos);
  must({"explain", file("r.json"), "-o", file("r.svg")});
  EXPECT_EQ(directory_.read("r.svg").substr(0, 5), "<?xml");
  must({"explain", file("r.json"), "-o", file("r.png")});
  EXPECT_EQ(directory_.read("r.png").substr(1, 3), "PNG");
  EXPECT_EQ(verdict({scene, path, "--report", file("good.json")}), "s CERTIFIED");
  EXPECT_NE(must({"explain", file("good.json")}).out.find(" before t = 40.\n"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(file("good.svg")));
  Json cut = json("r.json");
  cut["divergence"]["witness"]["generators"][0]["center"] = Json::array();
  const std::string cut_report = written("cut.json", cut.dump());
  refused({"explain", cut_report},
          cut_report + ": divergence.witness.generators[0].center: fewer than 1 elements");
  cut = json("r.json");
  cut["certified_prefix"]["events"] = "12";
  refused({"explain", written("cut.json", cut.dump())},
          ": certified_prefix.events: not an integer\n");
  cut.erase("certified_prefix");
  refused({"explain", written("cut.json", cut.dump())}, ": certified_prefix: missing\n");
  Json good = json("good.json");
  good["divergence"] = json("r.json")["divergence"];
  refused({"explain", written("cut.json", good.dump())},
          ": divergence: in a report that refutes nothing\n");
  const std::string half = written("half.json", directory_.read("r.json").substr(0, 200));
  refused({"explain", half}, half + ":");
  refused({"explain", half}, ": incomplete\n");
  refused({"explain", scene}, scene + ":1: format: not \"voroproof-report\"\n");
  refused({"explain", path}, path + ":1: format: not \"voroproof-report\"\n");
  refused({"explain", file("r.json"), "-o", file("r.gif")}, ".svg, .png or .pdf");
}

TEST_F(CertifyCli, WhatIsNotAHistoryOfTheSceneIsInvalid) {
  const std::string scene = reference(30, "40"), path = history(scene);
  EXPECT_EQ(verdict({scene, edited(path, [](auto& lines) { lines.pop_back(); })}), "s INVALID");
  EXPECT_EQ(verdict({scene, edited(path,
                                   [](auto& lines) {
                                     const auto at = lines[0].find("sha256\":\"") + 9;
                                     lines[0][at] = lines[0][at] == 'a' ? 'b' : 'a';
                                   })}),
            "s INVALID");
  EXPECT_EQ(verdict({scene, file("absent")}), "s INVALID");
  EXPECT_EQ(verdict({path, path}), "s INVALID");
}

TEST_F(CertifyCli, AToleranceThatAcceptsEverythingIsRefused) {
  const std::string scene = reference(10, "40"), path = history(scene);
  for (const char* truth : {"exact", "recorded"}) {
    EXPECT_EQ(verdict({scene, path, "--truth", truth, "--tolerance", "40"}), "s CERTIFIED");
    for (const char* more : {"40.000001", "1e100"}) {
      refused({"certify", scene, path, "--truth", truth, "--tolerance", more},
              "--tolerance: more than the horizon of the history, 40");
    }
    refused({"certify", scene, path, "--truth", truth, "--law-tolerance", "1.1"},
            "--law-tolerance: more than 1");
  }
  // The default is never refused.
  const std::string none = reference(10, "0");
  EXPECT_EQ(verdict({none, history(none)}), "s CERTIFIED");
}

// The run may be shorter than its scene asks for; what it is right about is said.
TEST_F(CertifyCli, AHistoryIsJudgedUpToItsOwnHorizon) {
  const std::string scene = reference(10, "40"), path = file("a.history.jsonl");
  must({"simulate", scene, "-o", path, "--horizon", "20"});
  for (const char* truth : {"exact", "recorded"}) {
    EXPECT_EQ(verdict({scene, path, "--truth", truth, "--report", file("r.json")}), "s CERTIFIED");
    const Json report = json("r.json");
    EXPECT_EQ(report["certified_prefix"]["t"], 20);
    EXPECT_EQ(report["remarks"].at(0), "the horizon of the history is 20, that of the scene 40");
  }
  // Nothing is right beyond its end.
  const std::string longer = edited(path, [](auto& lines) {
    const auto at = lines[0].find("\"horizon\":20");
    lines[0].replace(at, 12, "\"horizon\":40");
    lines.back().replace(lines.back().find("\"t\":20"), 6, "\"t\":40");
  });
  EXPECT_EQ(verdict({scene, longer}), "s REFUTED");
}

// Three in a row that touch at once: the right pair collides first where the format has the left.
TEST_F(CertifyCli, AnotherOrderOfTouchingCollisions) {
  const std::string scene =
      this->scene("2", disk("-3,0", "1", "1,0") + ',' + disk("0,0", "1", "0,0") + ',' +
                           disk("3,0", "1", "-1,0"));
  const std::string other = edited(history(scene), [](std::vector<std::string>& lines) {
    ASSERT_EQ(lines.size(), 5U);
    lines[1] = R"({"t":1,"collide":[1,2],"v":[[-1,0],[0,0]]})";
    lines[2] = R"({"t":1,"collide":[0,1],"v":[[-1,0],[1,0]]})";
    lines[3] = R"({"t":1,"collide":[1,2],"v":[[0,0],[1,0]]})";
  });
  EXPECT_EQ(verdict({scene, other, "--report", file("r.json")}), "s REFUTED");
  EXPECT_EQ(json("r.json")["divergence"]["kind"], "another order of touching collisions");
  EXPECT_EQ(json("r.json")["order"], "format");
  EXPECT_NE(must({"explain", file("r.json")}).out.find("--order any"), std::string::npos);
  EXPECT_EQ(verdict({scene, other, "--order", "any", "--report", file("r.json")}), "s CERTIFIED");
  EXPECT_EQ(json("r.json")["order"], "any");
  EXPECT_EQ(json("r.json")["leniency"]["other_orders"], 1);
  EXPECT_EQ(verdict({scene, other, "--order", "any", "--strict"}), "s REFUTED");
  EXPECT_EQ(verdict({scene, other, "--truth", "recorded"}), "s CERTIFIED");
  refused({"certify", scene, other, "--truth", "recorded", "--order", "any"},
          "--order: the recorded truth takes the order of one instant as the history has it");
  refused({"certify", scene, other, "--order", "any", "--kernel"}, "--kernel: the kernel knows");
}

TEST_F(CertifyCli, NothingAfterTheHorizonIsAnEvent) {
  const std::string turn = R"({"t":2.0000005,"disk":0,"velocity":[0,1]})";
  const std::string scene = this->scene("2", disk("0,0", "1", "1,0"), turn);
  const std::string bad = edited(history(scene), [](auto& lines) {
    lines.back() = R"({"t":2,"maneuver":0})";
    lines.push_back(R"({"end":{"t":2,"flips":0,"collisions":0,"maneuvers":1}})");
  });
  for (const char* truth : {"exact", "recorded"}) {
    EXPECT_EQ(verdict({scene, bad, "--truth", truth}), "s REFUTED");
  }
}

// Disk 3 enters the circle of the others at t = 2.5e-7 and leaves it again. Told at t = 0, its turn
// would make the diagram between another one from the start.
TEST_F(CertifyCli, AManeuverToldTooEarlyDoesNotChangeTheStart) {
  const std::string others =
      disk("5,0", "0", "0,0") + ',' + disk("0,5", "0", "0,0") + ',' + disk("-5,0", "0", "0,0");
  const std::string scene = this->scene("1", others + ',' + disk("0,-5.00000025", "0", "0,1"),
                                        R"({"t":5e-7,"disk":3,"velocity":[0,-1]})");
  const std::string path = history(scene);
  EXPECT_EQ(verdict({scene, path}), "s CERTIFIED");
  ASSERT_EQ(lines_of(read_file(path)).size(), 5U);
  const std::string bad = edited(path, [](auto& lines) {
    lines[0].resize(lines[0].find(",\"initial"));
    lines[0] +=
        ",\"initial\":[[-1,0,1,3],[-1,1,2,0],[-1,2,3,1],[-1,3,0,2],[0,1,-1,3],[0,3,1,-1],"
        "[1,2,-1,3],[1,3,2,0],[2,3,-1,1]]}";
    lines[1] = R"({"t":0,"maneuver":3})";
    lines.erase(lines.begin() + 2);
    lines.back() = R"({"end":{"t":1,"flips":1,"collisions":0,"maneuvers":1}})";
  });
  EXPECT_EQ(verdict({scene, bad}), "s REFUTED");
}

TEST_F(CertifyCli, CentresThatCoincideGiveNoNormal) {
  const std::string scene =
      this->scene("3", disk("-2,0", "1", "1,0") + ',' + disk("2,0", "1", "-1,0"));
  const std::string path = history(scene);
  for (const char* truth : {"exact", "recorded"}) {
    for (const char* velocities : {"", R"(,"v":[[-1,0],[1,0]])"}) {
      const std::string bad = edited(path, [&](auto& lines) {
        lines[1] = R"({"t":1,"collide":[0,1],"p":[[0,0],[0,0]])" + std::string(velocities) + '}';
      });
      EXPECT_EQ(verdict({scene, bad, "--truth", truth}), "s REFUTED");
    }
  }
  // Two points that meet.
  const std::string points =
      this->scene("3", disk("-2,0", "0", "1,0") + ',' + disk("2,0", "0", "-1,0"));
  run({"simulate", points, "-o", path, "--replace"});  // stops, as the truth does
  const std::string meeting = edited(path, [&](auto& lines) {
    lines.resize(1);
    lines.push_back(R"({"t":2,"collide":[0,1]})");
    lines.push_back(R"({"end":{"t":3,"flips":0,"collisions":1,"maneuvers":0}})");
  });
  for (const char* truth : {"exact", "recorded"}) {
    EXPECT_EQ(verdict({points, meeting, "--truth", truth}), "s UNDECIDED");
  }
}

// Its cell has no area at the start: simulate stops there and names the pair, and certify does not
// decide what others claim.
TEST_F(CertifyCli, APointThatTouchesAtTheStartIsUndecided) {
  const std::string point = disk("0,1", "0", "0,1"), unit = disk("0,0", "1", "0,0");
  const std::string far = disk("-3,0", "1", "1,0"), at_wall = disk("100,0", "0", "-1,0");
  const auto expect_stop = [&](const std::string& disks, const Json& pair) {
    const std::string path = file("a.history.jsonl");
    const std::string scene = this->scene("3", disks);
    EXPECT_EQ(run({"simulate", scene, "-o", path}).code, 3) << disks;
    const Json last = Json::parse(lines_of(read_file(path)).back());
    EXPECT_EQ(last["stopped"]["t"], 0) << disks;
    EXPECT_EQ(last["stopped"]["events"], Json::array({{{"collide", pair}}})) << disks;
    EXPECT_EQ(verdict({scene, path}), "s UNDECIDED") << disks;
  };
  expect_stop(point + ',' + unit, {0, 1});
  expect_stop(unit + ',' + far + ',' + point, {0, 2});
  expect_stop(far + ',' + at_wall, {-1, 1});
  // A history of two disks as another program may write it.
  const std::string two = scene("3", point + ',' + unit), path = file("a.history.jsonl");
  run({"simulate", two, "-o", path});
  const std::string claimed = edited(path, [&](auto& lines) {
    Json header = Json::parse(lines.front());
    header["initial"] = {{-1, 0, 1, 1}, {-1, 1, 0, 0}, {0, 1, -1, -1}};
    lines = {header.dump(), R"({"end":{"t":3,"flips":0,"collisions":0,"maneuvers":0}})"};
  });
  EXPECT_EQ(verdict({two, claimed}), "s UNDECIDED");
  // Alone there is no diagram to be missed: it collides with the wall at once.
  const std::string alone = scene("3", disk("100,0", "0", "1,0"));
  EXPECT_EQ(verdict({alone, history(alone)}), "s CERTIFIED");
}

// Under the recorded truth no overlap is excused but by a claimed collision of the two, however
// short it is and whatever they do in it.
TEST_F(CertifyCli, OverlapsAreMeasuredWhole) {
  const std::string disks = disk("-3,0", "1", "1,0") + ',' + disk("1,0", "1", "0,0");
  std::string turns, claims;
  for (int k = 1; k <= 9; ++k) {
    const std::string t = "2.00000" + std::to_string(100 + 5 * k).substr(1);
    turns += (k > 1 ? "," : "") + (R"({"t":)" + t) + R"(,"disk":0,"velocity":[1,0]})";
    claims += R"({"t":)" + t + R"(,"maneuver":0})" + '\n';
  }
  const auto without_contact = [&](const std::string& scene, const std::string& events, int count) {
    return edited(history(scene), [&](auto& lines) {
      lines.resize(1);
      lines.push_back(events + R"({"end":{"t":3,"flips":0,"collisions":0,"maneuvers":)" +
                      std::to_string(count) + "}}");
    });
  };
  std::string scene = this->scene("3", disks, turns);
  EXPECT_EQ(verdict({scene, history(scene), "--truth", "recorded"}), "s CERTIFIED");
  EXPECT_EQ(verdict({scene, without_contact(scene, claims, 9), "--truth", "recorded"}),
            "s REFUTED");
  // At rest in the other; parting at once, without a collision.
  for (const bool parting : {false, true}) {
    const std::string v = parting ? "[-1,0]" : "[0,0]";
    scene = this->scene("3", disks, R"({"t":2.0000002,"disk":0,"velocity":)" + v + '}');
    const std::string claim = "{\"t\":2.0000002,\"maneuver\":0}\n";
    EXPECT_EQ(verdict({scene, without_contact(scene, claim, 1), "--truth", "recorded"}),
              "s REFUTED");
  }
}

TEST_F(CertifyCli, AHistoryThatStopsIsUndecided) {
  const std::string scene = reference(30, "40"), path = history(scene);
  const std::string stopped = edited(path, [](auto& lines) {
    lines.resize(20);
    lines.push_back(R"({"stopped":{"t":)" + lines.back().substr(5, lines.back().find(',') - 5) +
                    R"(,"reason":"interrupted","events":[]}})");
  });
  EXPECT_EQ(verdict({scene, stopped, "--report", file("r.json")}), "s UNDECIDED");
  EXPECT_EQ(json("r.json")["certified_prefix"]["events"], 19);
}

// A collision at 5, claimed at 5.4 within the tolerance; then the file stops, without that at 5.2.
TEST_F(CertifyCli, WhatMayBeClaimedAfterAStopIsNoneOfThePrefix) {
  const std::string scene = written("s.scene.json", R"({"format":"voroproof-scene","version":1,
    "container":{"center":[0,0],"radius":50},"horizon":10,"disks":[
    {"center":[39,0],"radius":1,"velocity":[2,0]},
    {"center":[-38.6,0],"radius":1,"velocity":[-2,0]}]})");
  const std::string stopped = edited(history(scene), [](auto& lines) {
    lines.resize(1);
    lines.push_back(R"({"t":5.4,"collide":[-1,0],"v":[null,[-2,0]]})");
    lines.push_back(R"({"stopped":{"t":5.4,"reason":"x","events":[]}})");
  });
  for (const char* truth : {"exact", "recorded"}) {
    EXPECT_EQ(verdict({scene, stopped, "--truth", truth, "--tolerance", "0.5", "--report",
                       file("r.json")}),
              "s UNDECIDED");
    EXPECT_LE(json("r.json")["certified_prefix"]["t"], 5.2);
  }
}

}  // namespace
}  // namespace voroproof::internal
