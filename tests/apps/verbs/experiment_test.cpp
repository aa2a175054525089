// The verb experiment and the members of the paper's data sets, as a user runs them.
#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

using ExperimentCli = Cli;

TEST_F(ExperimentCli, WritesJsonAndCsv) {
  const Arguments arguments{"experiment", "restitution", "--scale",      "0.05",  "--horizon",
                            "25",         "-o",          file("r.json"), "--csv", file("r.csv")};
  const Result result = must(arguments);
  EXPECT_EQ(lines_of(result.out).size(), 5u);
  const Json all = json("r.json");
  EXPECT_EQ(all["set"], "restitution");
  ASSERT_EQ(all["members"].size(), 5u);
  for (int k = 0; k < 5; ++k) {
    const Json& member = all["members"][k];
    EXPECT_EQ(member["n"], 15);
    EXPECT_EQ(member["flip_frequency"].size(), 3u);
    std::uint64_t sum = 0;
    for (const Json& count : member["flip_frequency"]) sum += count.get<std::uint64_t>();
    EXPECT_EQ(member["flips"], sum);
    EXPECT_GE(member["predicted"]["flips"], member["flips"]);
  }
  const std::string table = directory_.read("r.csv");
  EXPECT_EQ(lines_of(table).size(), 6u);
  // The table depends on the options alone.
  must(arguments);
  EXPECT_EQ(directory_.read("r.csv"), table);
}

TEST_F(ExperimentCli, RefusesOptionsWithoutMeaning) {
  refused({"experiment", "colour", "-o", file("r.json")}, "colour");
  refused({"experiment", "speed", "--scale", "0", "-o", file("r.json")}, "--scale");
  refused({"experiment", "speed", "--horizon", "0", "-o", file("r.json")}, "--horizon");
  refused({"experiment", "speed", "--horizon", "1e300", "-o", file("r.json")}, "--horizon");
}

TEST_F(ExperimentCli, GeneratesMembersOfDataSets) {
  must({"generate", "reference", "--set", "restitution:2", "--seed", "5", "--horizon", "10", "-o",
        file("a.scene.json")});
  must({"generate", "reference", "--n", "300", "--restitution", "0.7", "--seed", "5", "--horizon",
        "10", "-o", file("b.scene.json")});
  EXPECT_EQ(directory_.read("a.scene.json"), directory_.read("b.scene.json"));
  const auto bad = [&](const std::string& set) {
    refused({"generate", "reference", "--set", set, "-o", file("c.scene.json")}, "--set");
  };
  bad("speed");
  bad("speed:11");
  bad("speed:1x");
  refused({"generate", "reference", "--set", "speed:1", "--n", "3", "-o", file("c.scene.json")},
          "excludes");
}

}  // namespace
}  // namespace voroproof::internal
