// Files that are swapped while certify reads them: the verdict is about the bytes whose hash the
// report has, or there is none.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "history/sha256.h"
#include "tests/apps/verbs/shards_cli.h"
#include "tests/history/swapped_file.h"

namespace voroproof::internal {
namespace {

// A disk in a container, which turns at `turn`.
std::string disks(const std::string& speed) {
  return "2\n-1 0 0 50 0 0 0 0 0\n0 0 0 1 0 0 0 " + speed + " 0\n";
}
std::string events(const std::string& turn) {
  return "#EVENT_SEQUENCE_FILE_FORMAT_VERSION: 1.10\n#SIMULATION_TIME: 10.00\n"
         "#RESTITUTION_COEFFICIENT: 1.00\n1\nV " +
         turn + " 0 0.5 0\n";
}

class SwappedFiles : public Cli {
 protected:
  // The last line and the report of a run in which the file is swapped at each opening but the
  // first `openings`.
  std::pair<std::string, Json> judged(std::size_t openings, const std::string& name,
                                      const std::string& first, const std::string& then,
                                      Arguments words) {
    const std::string report = file("r.json");
    words.insert(words.end(), {"--report", report});
    Result result;
    {
      const SwappedFile swapped(file(name), std::vector<std::string>(openings, first), then);
      result = run(words);
    }
    std::filesystem::remove(file(name));
    const std::string verdict = lines_of(result.out).back();
    if (verdict != "s INVALID") return {verdict, json("r.json")};
    EXPECT_NE(result.err.find("has other bytes than when"), std::string::npos) << result.err;
    return {verdict, {}};
  }
};

// Two sequences that are both right, with other maneuvers: the scene is from both otherwise.
TEST_F(SwappedFiles, AnEventSequenceIsJudgedUnderItsOwnManeuvers) {
  const std::string scene = directory_.write("a.disks.txt", disks("1"));
  const std::string first = events("2"), then = events("3");
  for (const std::string truth : {"exact", "recorded"}) {
    int refused = 0;
    for (std::size_t k = 0; k <= 5; ++k) {
      const auto [verdict, report] =
          judged(k, "a.evtsq", first, then, {"certify", scene, file("a.evtsq"), "--truth", truth});
      if (verdict == "s INVALID") {
        ++refused;
        continue;
      }
      EXPECT_EQ(verdict, "s CERTIFIED") << truth << k;
      const std::string hash = report["history_sha256"];
      EXPECT_TRUE(hash == sha256_hex(k < 3 ? then : first)) << truth << k;
    }
    EXPECT_EQ(refused, 1) << truth;
  }
}

TEST_F(SwappedFiles, ADiskFileIsJudgedAsItIsHashed) {
  const std::string history = directory_.write("a.evtsq", events("2"));
  // The fast one reaches the container before it turns.
  const std::string slow = disks("1"), fast = disks("100");
  for (std::size_t k = 0; k <= 6; ++k) {
    const auto [verdict, report] =
        judged(k, "a.disks.txt", slow, fast, {"certify", file("a.disks.txt"), history});
    const std::string hash = report["scene_sha256"];
    EXPECT_EQ(hash, sha256_hex(verdict == "s CERTIFIED" ? slow : fast)) << k << verdict;
  }
}

TEST_F(SwappedFiles, AHistoryIsHashedWithTheHeaderThatIsJudged) {
  const std::string scene = reference(5, "5"), path = file("a.history.jsonl");
  must({"simulate", scene, "-o", path, "--quiet"});
  const std::string first = read_bytes(path);
  std::filesystem::remove(path);
  std::string then = first;
  const std::string field = "\"producer\":\"";
  const std::size_t producer = then.find(field);
  ASSERT_NE(producer, std::string::npos);
  then[producer + field.size()] = 'X';
  for (const std::string truth : {"exact", "recorded"}) {
    for (std::size_t k = 0; k <= 3; ++k) {
      const auto [verdict, report] =
          judged(k, "a.history.jsonl", first, then, {"certify", scene, path, "--truth", truth});
      EXPECT_EQ(verdict, "s CERTIFIED") << truth << k;
      const bool is_first = report["history_producer"].get<std::string>()[0] != 'X';
      EXPECT_EQ(report["history_sha256"], sha256_hex(is_first ? first : then)) << truth << k;
    }
  }
}

// The certificate of a shard has to say itself that it is one.
TEST_F(ShardsCli, ACertificateThatIsSwappedAfterItsFormatWasReadIsNotMerged) {
  Arguments names = parts(2);
  std::string other = read_bytes(names[0]);
  const std::string format = "\"voroproof-shard\"";
  other.replace(other.find(format), format.size(), "\"voroproof-other\"");
  names[0] = file("s.shard.json");
  const SwappedFile swapped(names[0], {"{\"format\": \"voroproof-shard\", \"version\": 1}"}, other);
  refused_merge(names, "s.shard.json: part: missing");
}

}  // namespace
}  // namespace voroproof::internal
