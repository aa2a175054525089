// An index: what is found in it, and what is refused. Shards begun where it says are those begun at
// the beginning.
#include "tests/library/indexed_history.h"

namespace voroproof::internal::testing {
namespace {

TEST_F(Indexes, ShardsAreTheSameFromTheMiddle) {
  ASSERT_GT(index(), 3);
  constexpr int of = 6;
  std::vector<std::string> paths;
  for (int k = 1; k <= of; ++k) {
    const auto entry =
        find([&](const Cut& cut) { return shard_of(cut.t, scene_.horizon.get_d(), of) < k; });
    EXPECT_EQ(entry.has_value(), k > 1);
    paths.push_back(shard(k, of, "a.history.jsonl", std::nullopt));
    const std::string from_the_start = directory_.read(std::to_string(k) + ".shard.json");
    if (entry) shard(k, of, "a.history.jsonl", entry->at);
    EXPECT_EQ(directory_.read(std::to_string(k) + ".shard.json"), from_the_start) << k;
  }
  EXPECT_EQ(merged(paths), "s CERTIFIED");
}

TEST_F(Indexes, TheLastEarlyEntryIsFound) {
  index();
  const std::vector<Json> all = lines();
  for (std::size_t k = 1; k + 1 < all.size(); ++k) {
    const std::int64_t part = all[k]["cut"]["part"];
    const auto entry = find([&](const Cut& cut) { return cut.part <= part; });
    ASSERT_TRUE(entry);
    EXPECT_EQ(entry->at.cut.offset, all[k]["cut"]["offset"].get<std::int64_t>());
  }
  EXPECT_FALSE(find([](const Cut&) { return false; }));
}

// What is no index of this history, or is damaged, is said to be.
TEST_F(Indexes, OfSomethingElseAreRefused) {
  index();
  const std::vector<Json> right = lines();
  ASSERT_EQ(refusal(), "");
  EXPECT_PRED2(has, refusal(small_parts(), "program 2"), "is by program 1");
  CertifyOptions other = small_parts();
  other.tolerance = Rational(1, 1000);
  EXPECT_PRED2(has, refusal(other), "is for the tolerance");
  other = small_parts();
  other.unoriented = true;
  EXPECT_PRED2(has, refusal(other), "without --unoriented");
  const auto changed = [&](const std::string& why,
                           const std::function<void(std::vector<Json>&)>& what) {
    std::vector<Json> wrong = right;
    what(wrong);
    put(wrong);
    EXPECT_PRED2(has, refusal(), why);
  };
  const std::size_t last = right.size() - 2;
  changed("not \"voroproof-index\"", [](auto& l) { l[0]["format"] = "voroproof-history"; });
  changed("version 2", [](auto& l) { l[0]["version"] = 2; });
  changed("another history", [](auto& l) { l[0]["header_sha256"] = std::string(64, '0'); });
  changed("another history", [](auto& l) { l.back()["end"]["bytes"] = 17; });
  changed("incomplete", [](auto& l) { l.pop_back(); });
  changed("incomplete", [](auto& l) { l.erase(l.begin() + 2); });
  changed("behind the one before", [](auto& l) { std::swap(l[1], l[2]); });
  changed("beyond the horizon", [&](auto& l) { l[last]["cut"]["t"] = 1e300; });
  changed("beginning of the history", [&](auto& l) { l[1]["cut"]["part"] = 0; });
  changed("text after the last line", [](auto& l) { l.push_back(l.back()); });
  changed("other bytes", [&](auto& l) { l[last]["sha256"] = std::string(64, '0'); });
  changed("no state of SHA-256", [&](auto& l) { l[last]["cut"]["digest"] = "0"; });
  changed("neither an entry", [](auto& l) { l[1] = Json{{"x", 1}}; });
  put(right);
  std::string text = directory_.read("a.index");
  directory_.write("a.index", text.substr(0, text.size() / 2));
  EXPECT_NE(refusal(), "");
  put(right);
  // The history is changed in a place that the last entry stands for.
  std::string bytes = directory_.read("a.history.jsonl");
  const std::size_t digit = bytes.rfind("\"p\":[[") + 8;
  bytes[digit] = bytes[digit] == '1' ? '2' : '1';
  directory_.write("a.history.jsonl", bytes);
  EXPECT_PRED2(has, refusal(), "other bytes");
}

// A state that is none, or not the one whose hash the entry has, is not gone on with.
TEST_F(Indexes, DamagedStatesAreRefused) {
  index();
  const Json right = lines()[2];
  const auto refused = [&](const std::string& why, const std::function<void(Json&)>& what) {
    Json wrong = right;
    what(wrong);
    try {
      shard(6, 6, "a.history.jsonl", cut_of(wrong));
      ADD_FAILURE() << why;
    } catch (const InputError& error) {
      EXPECT_PRED2(has, error.what(), why);
    }
  };
  refused("not that of the state", [](Json& e) { e["state"]["disks"][0][3] = 0.125; });
  refused("parts that overlap", [](Json& e) { e["state"]["disks"][0][6] = {1, 1.5}; });
  refused("not in [", [](Json& e) { e["state"]["origins"][0] = 99; });
  refused("not a triangle", [](Json& e) { e["state"]["previous"][0] = e["state"]["previous"][1]; });
  refused("not in [", [](Json& e) { e["state"]["anchors"][0] = 1000; });
  refused("fewer disks", [](Json& e) { e["state"]["disks"].erase(0); });
  refused("not in [", [](Json& e) { e["state"]["next_maneuver"] = 5; });
  refused("missing", [](Json& e) { e["state"].erase("changes"); });
  const std::int64_t offset = right["cut"]["offset"];
  for (const std::int64_t other : {offset + 1, std::int64_t{1} << 30}) {
    refused("no line ends", [&](Json& e) {
      e["cut"]["offset"] = other;
      // What may be a state of SHA-256 after so many bytes.
      e["cut"]["digest"] = std::string(64 + 2 * static_cast<std::size_t>(other % 64), '0');
    });
  }
  refused("no state of SHA-256", [&](Json& e) { e["cut"]["offset"] = offset + 1; });
}

}  // namespace
}  // namespace voroproof::internal::testing
