// voroproof index, and what begins in the middle with it.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

class IndexCli : public Cli {
 protected:
  void SetUp() override {
    scene_ = reference(12, "1500");
    history_ = file("a.history.jsonl");
    index_ = history_ + ".index";
    must({"simulate", scene_, "-o", history_});
    must({"index", scene_, history_});
  }

  Result certify(const std::string& report, const Arguments& more) const {
    Arguments arguments{"certify",  scene_,    history_,   "--truth",
                        "recorded", "--quiet", "--report", report};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  // The history and its index, in which what comes before the index's first entry makes no sense.
  void spoil_the_beginning() const {
    std::string text = read_bytes(history_);
    const std::size_t flip = text.find("\"flip\"");
    text.replace(flip, 6, "\"flop\"");
    directory_.write("a.history.jsonl", text);
  }

  std::string scene_, history_, index_;
};

TEST_F(IndexCli, SaysWhatItHasWritten) {
  const Result result = must({"index", scene_, history_, "-o", file("b.index")});
  EXPECT_TRUE(result.out.starts_with("entries ")) << result.out;
  EXPECT_TRUE(read_bytes(file("b.index")) == read_bytes(index_));
  EXPECT_EQ(must({"index", scene_, history_, "-o", file("b.index"), "--quiet"}).out, "");
  EXPECT_LT(read_bytes(index_).size(), read_bytes(history_).size() / 15);
}

TEST_F(IndexCli, ShardsBeginInTheMiddle) {
  const Arguments last{"--part", "3/3"}, indexed{"--part", "3/3", "--index", index_};
  ASSERT_EQ(certify(file("plain"), last).code, 0);
  ASSERT_EQ(certify(file("indexed"), indexed).code, 0);
  EXPECT_TRUE(read_bytes(file("plain")) == read_bytes(file("indexed")));
  spoil_the_beginning();
  EXPECT_EQ(certify(file("plain"), last).code, 2);
  std::filesystem::remove(file("indexed"));
  ASSERT_EQ(certify(file("indexed"), indexed).code, 0);
  // Such shards are joined with none that has read the beginning.
  EXPECT_EQ(certify(file("first"), {"--part", "1/3", "--index", index_}).code, 2);
}

TEST_F(IndexCli, ARunIsTakenUpFromTheMiddle) {
  ASSERT_EQ(certify(file("whole"), {}).code, 0);
  ASSERT_EQ(certify(file("half"), {"--part", "1/2"}).code, 0);
  Json left = json("half");
  left["part"] = {1, 1};
  directory_.write("a.report.partial", left.dump());
  spoil_the_beginning();
  EXPECT_EQ(certify(file("a.report"), {"--resume"}).code, 2);
  ASSERT_EQ(certify(file("a.report"), {"--resume", "--index", index_}).code, 0);
  EXPECT_TRUE(read_bytes(file("a.report")) == read_bytes(file("whole")));
}

TEST_F(IndexCli, SnapshotsBeginInTheMiddle) {
  std::string line = read_bytes(history_);
  line = line.substr(line.rfind("\"collide\"") - 40);
  const std::string event =
      line.substr(line.find("\"t\":") + 4, line.find(",\"c") - line.find("\"t\":") - 4);
  const Arguments plain{"snapshot", scene_, history_, "-o", file("plain"), "--at"};
  const Arguments indexed{"snapshot", scene_, history_,        "--index",
                          index_,     "-o",   file("indexed"), "--at"};
  const auto at = [&](Arguments arguments, const std::string& t) {
    arguments.push_back(t);
    return run(arguments);
  };
  for (const std::string& t :
       {std::string("0"), std::string("1/3"), std::string("777.7"), event, std::string("1500")}) {
    ASSERT_EQ(at(plain, t).code, 0) << t;
    ASSERT_EQ(at(indexed, t).code, 0) << t;
    EXPECT_TRUE(read_bytes(file("plain")) == read_bytes(file("indexed"))) << t;
  }
  EXPECT_EQ(at(indexed, "1501").code, 2);
  spoil_the_beginning();
  EXPECT_EQ(at(plain, "1400").code, 2);
  EXPECT_EQ(at(indexed, "1400").code, 0);
  EXPECT_EQ(at(indexed, "1/3").code, 2);
}

TEST_F(IndexCli, MoviesBeginInTheMiddle) {
  const auto movie = [&](const std::string& page, const std::string& from,
                         const Arguments& more = {}) {
    Arguments arguments{"movie", scene_, history_, "-o", file(page), "--from", from};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments).code;
  };
  for (const std::string& t :
       {std::string("0"), std::string("1/3"), std::string("777.7"), std::string("1500")}) {
    ASSERT_EQ(movie("plain", t), 0) << t;
    ASSERT_EQ(movie("indexed", t, {"--index", index_}), 0) << t;
    EXPECT_TRUE(read_bytes(file("plain")) == read_bytes(file("indexed"))) << t;
  }
  spoil_the_beginning();
  EXPECT_EQ(movie("plain", "1400"), 2);
  EXPECT_EQ(movie("indexed", "1400", {"--index", index_}), 0);
  EXPECT_EQ(movie("indexed", "1/3", {"--index", index_}), 2);
}

// A history that was written anew is another one.
TEST_F(IndexCli, OfAnotherHistoryAreRefused) {
  must({"simulate", scene_, "-o", history_, "--horizon", "1400"});
  for (const Arguments& arguments :
       std::vector<Arguments>{{"snapshot", scene_, history_, "--at", "1", "-o", file("d")},
                              {"certify", scene_, history_, "--truth", "recorded", "--part", "2/2",
                               "--report", file("d")}}) {
    Arguments all = arguments;
    all.insert(all.end(), {"--index", index_});
    const Result result = run(all);
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err.find("is the index of another history"), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(file("d")));
  }
}

TEST_F(IndexCli, NeedWhatTheyNeed) {
  const Arguments recorded{"certify", scene_, history_, "--truth", "recorded"};
  const auto refused_with = [&](Arguments arguments, const Arguments& more,
                                const std::string& message) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    refused(arguments, message);
  };
  refused_with(recorded, {"--index", index_}, "only with --part or --resume");
  refused_with(recorded,
               {"--index", index_, "--part", "1/2", "--report", file("r"), "--max-events", "9"},
               "--max-events");
  const Result other =
      certify(file("r"), {"--index", index_, "--part", "2/2", "--tolerance", "1e-7"});
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find("is for the tolerance"), std::string::npos) << other.err;
  refused({"snapshot", scene_, "--at", "1", "-o", file("d"), "--index", index_}, "none is given");
  refused({"snapshot", scene_, history_, "--at", "1", "-o", file("d"), "--index", index_, "--move",
           "1"},
          "--move");
  must({"simulate", scene_, "-o", file("a.history.jsonl.gz")});
  refused({"index", scene_, file("a.history.jsonl.gz")}, "of a plain file alone");
  EXPECT_FALSE(std::filesystem::exists(file("a.history.jsonl.gz.index")));
}

}  // namespace
}  // namespace voroproof::internal
