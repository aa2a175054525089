// convert as its users meet it: there and back, and what cannot be converted.
#include <gtest/gtest.h>

#include <string>

#include "history/world.h"
#include "tests/apps/verbs/certify_cli.h"

namespace voroproof::internal {
namespace {

TEST_F(CertifyCli, ThereAndBackThroughAnEventSequence) {
  const std::string scene = reference(30, "40"), path = history(scene);
  const std::string disks = file("a.disks.txt"), events = file("a.evtsq");
  must({"convert", scene, "-o", disks});
  must({"convert", path, "--scene", scene, "-o", events});
  EXPECT_EQ(verdict({disks, events, "--truth", "recorded"}), "s CERTIFIED");
  EXPECT_EQ(verdict({scene, events, "--truth", "recorded"}), "s CERTIFIED");
  EXPECT_EQ(verdict({scene, events}), "s CERTIFIED");
  must({"convert", path, "--scene", scene, "-o", events, "--numbers", "decimal"});
  EXPECT_EQ(verdict({scene, events, "--truth", "recorded"}), "s CERTIFIED");
  must({"convert", disks, "--horizon", "40", "-o", file("b.scene.json")});
  const std::string back = file("b.history.jsonl");
  must({"convert", events, "--scene", file("b.scene.json"), "-o", back});
  EXPECT_EQ(verdict({file("b.scene.json"), back, "--truth", "recorded"}), "s CERTIFIED");
}

TEST_F(CertifyCli, ConversionsThatCannotBe) {
  const std::string scene = reference(5, "5"), path = history(scene);
  refused({"convert", path, "-o", file("a.evtsq")}, "--scene");
  refused({"convert", scene, "-o", file("a.svg")}, "--output");
  must({"convert", scene, "-o", file("a.disks.txt")});
  refused({"convert", file("a.disks.txt"), "-o", file("b.scene.json")}, "--horizon");
  refused({"convert", path, "-o", file("b.scene.json"), "--horizon", "1"},
          "neither a disk file nor paths");
}

TEST_F(CertifyCli, WhatADiskFileCannotSayIsToldAsLeftOut) {
  const std::string scene = directory_.write(
      "x.scene.json",
      R"({"format": "voroproof-scene", "version": 1, "container": {"center": [0, 0], "radius": 9},)"
      R"("horizon": 5, "disks": [{"center": [0, 0], "radius": 1, "velocity": [1, 0], "x-a": 1}]})");
  EXPECT_EQ(must({"convert", scene, "-o", file("x.disks.txt")}).out,
            "the extensions are left out: a disk file has none\n");
}

// Disks of tracks meet, come and go; what is not known of them grows.
TEST_F(CertifyCli, TracksThatPassBecomeAWorld) {
  const std::string table = directory_.write("tracks.csv",
                                             "disk,t,x,y,radius\n"
                                             "ferry,5,0,0,1\nferry,9,4,0,1\nferry,15,10,0,1\n"
                                             "pilot,5,10,4,0.5\npilot,10,6,1,0.5\n"
                                             "pilot,15,0,1,0.5\nbuoy,8,5,8,0.5\n"
                                             "tug,7,0,8,1\ntug,13,7,2,1\n");
  const std::string scene = file("tracks.scene.json"), path = file("tracks.history.jsonl");
  const Arguments convert{"convert", table, "-o", scene};
  refused(convert, "buoy");  // is not there all the time
  refused({"convert", table, "-o", scene, "--growth", "1/8"}, "--growth: only with");
  EXPECT_NE(must({"convert", table, "-o", scene, "--contacts", "pass", "--growth", "1/8"})
                .out.find("time is counted from t = 5 of the file\n"
                          "missing: buoy, which has one waypoint\n"),
            std::string::npos);
  // What is not in the scene is not forgotten.
  const Result told = run({"clearance", scene, "--required", "-5"});
  EXPECT_EQ(told.code, 3);
  EXPECT_NE(told.out.find("c missing: buoy, which has one waypoint\n"), std::string::npos);
  const World world = read_world(scene);
  EXPECT_EQ(world.horizon, 10);
  ASSERT_EQ(world.disks.size(), 3u);
  EXPECT_EQ(world.disks[0].leave, std::nullopt);
  EXPECT_EQ(world.disks[2].enter, 2);
  EXPECT_EQ(world.disks[2].leave, 8);
  EXPECT_EQ(world.disks[2].state.vx, Rational(7, 6));
  EXPECT_EQ(world.disks[2].state.growth, Rational(1, 8));
  ASSERT_EQ(world.maneuvers.size(), 2u);
  EXPECT_EQ(world.maneuvers[0].t, 4);
  EXPECT_FALSE(world.maneuvers[0].velocity);  // the ferry goes on as before
  EXPECT_EQ(world.maneuvers[0].radius, 1);
  EXPECT_EQ(world.maneuvers[1].disk, 1);
  EXPECT_EQ(world.maneuvers[1].radius, Rational(1, 2));
  must({"simulate", scene, "-o", path, "--quiet"});
  EXPECT_EQ(verdict({scene, path}), "s CERTIFIED");
  // Without growth nobody jumps but where one comes or goes.
  must({"convert", table, "-o", scene, "--contacts", "pass"});
  const World still = read_world(scene);
  ASSERT_EQ(still.maneuvers.size(), 1u);
  EXPECT_FALSE(still.maneuvers[0].is_jump());
}

TEST_F(CertifyCli, OptionsOfConvertThatTheOutputHasNoUseForAreRefused) {
  const std::string scene = reference(5, "5"), path = history(scene);
  must({"convert", scene, "-o", file("a.disks.txt")});
  must({"convert", path, "--scene", scene, "-o", file("a.evtsq")});
  const Arguments to_scene{"convert", file("a.disks.txt"), "-o", file("b.scene.json"), "--horizon",
                           "5"};
  const Arguments to_disks{"convert", scene, "-o", file("b.disks.txt")};
  const Arguments to_history{"convert", file("a.evtsq"),        "--scene", scene,
                             "-o",      file("b.history.jsonl")};
  const Arguments to_sequence{"convert", path, "--scene", scene, "-o", file("b.evtsq")};
  const Arguments of_a_scene[] = {{"--horizon", "1"}, {"--restitution", "1/2"}};
  const Arguments of_a_sequence[] = {{"--numbers", "hexadecimal"}, {"--evtsq-version", "1.1"}};
  const auto refuse = [&](Arguments words, const Arguments& option) {
    words.insert(words.end(), option.begin(), option.end());
    refused(words, option[0] + ": only where ");
  };
  for (const Arguments& option : of_a_scene) {
    for (const Arguments& words : {to_disks, to_history, to_sequence}) refuse(words, option);
  }
  for (const Arguments& option : of_a_sequence) {
    for (const Arguments& words : {to_scene, to_disks, to_history}) refuse(words, option);
  }
  for (const Arguments& words : {to_scene, to_disks}) refuse(words, {"--scene", scene});
}

}  // namespace
}  // namespace voroproof::internal
