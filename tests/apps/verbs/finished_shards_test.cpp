// Certificates of shards that are there already, and files that were replaced since.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/apps/verbs/shards_cli.h"

namespace voroproof::internal {
namespace {

// A certificate that is there is the one that is asked for only if it is of these bytes, these
// options, this version and this shard. What it says is taken at its word: here it is marked.
TEST_F(ShardsCli, AFinishedShardIsNotMadeAgain) {
  const auto again = [&](int k, const Arguments& more = {}) {
    change(k, [](Json& s) { s["report"]["remarks"] = {"marked"}; });
    Arguments options{"--resume"};
    options.insert(options.end(), more.begin(), more.end());
    part(k, 3, options);
    const Json now = json("s" + std::to_string(k) + ".shard.json");
    return now["report"]["remarks"].empty() ? "made" : "kept";
  };
  parts(3);
  for (const int k : {1, 2, 3}) EXPECT_STREQ(again(k), "kept") << k;
  EXPECT_STREQ(again(2, {"--tolerance", "1e-7"}), "made");
  EXPECT_STREQ(again(2, {"--tolerance", "1e-7"}), "kept");
  EXPECT_STREQ(again(2), "made");
  const std::vector<std::pair<std::string, std::string>> others{
      {"producer", "voroproof 9"}, {"scene_sha256", std::string(64, 'a')}};
  for (const auto& [field, value] : others) {
    change(2, [&, &field = field, &value = value](Json& s) { s["report"][field] = value; });
    EXPECT_STREQ(again(2), "made") << field;
  }
  change(2, [](Json& s) { s["part"] = {3, 3}; });
  EXPECT_STREQ(again(2), "made");
  directory_.write("s2.shard.json", "{}");
  EXPECT_EQ(part(2, 3, {"--resume"}).code, 0);
  // Another history, whose first difference is behind the first shard.
  drop_a_flip(read_bytes(history_).size() / 2);
  EXPECT_STREQ(again(1), "kept");
  EXPECT_STREQ(again(2), "made");
  EXPECT_STREQ(again(3), "made");
  EXPECT_STREQ(again(2), "kept");
  EXPECT_EQ(part(2, 3, {"--resume"}).code, 1);
}

// The certificates fit together, and the files that they name are others by now.
TEST_F(ShardsCli, OfFilesThatWereReplaced) {
  const Arguments names = parts(3);
  const std::string history = read_bytes(history_), scene = read_bytes(scene_);
  drop_a_flip(history.size() / 2);
  refused_merge(names, "has other bytes than those of which the certificates are");
  directory_.write("a.history.jsonl", history);
  std::ofstream(scene_, std::ios::app) << ' ';
  refused_merge(names, "has other bytes than those of which the certificates are");
  // Where they are not there nothing is said of them.
  std::filesystem::remove(history_);
  std::filesystem::remove(scene_);
  EXPECT_EQ(run(merge(names)).code, 0);
}

}  // namespace
}  // namespace voroproof::internal
