// certify --part and --merge, run as a user would, on a history made for it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {

// What --quiet leaves besides the verdict.
inline const std::string about =
    "c all events, recorded truth, up to t = 1000, times within 1e-6, velocities within 1e-9\n";

inline std::string about_shard(int k, int of) {
  return "c shard " + std::to_string(k) + " of " + std::to_string(of) + " of " + about.substr(2);
}

class ShardsCli : public Cli {
 protected:
  void SetUp() override {
    scene_ = reference(30, "1000");
    history_ = file("a.history.jsonl");
    report_ = file("a.report.json");
    must({"simulate", scene_, "-o", history_});
  }

  Arguments certify(const Arguments& more = {}) const {
    Arguments arguments{"certify",  scene_,     history_, "--truth",
                        "recorded", "--report", report_,  "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  // The report of one process.
  std::string whole(int code = 0) const {
    EXPECT_EQ(run(certify()).code, code);
    std::string text = read_bytes(report_);
    std::filesystem::remove(report_);
    return text;
  }

  std::string name(int k) const { return file("s" + std::to_string(k) + ".shard.json"); }

  Result part(int k, int of, const Arguments& more = {}) const {
    Arguments arguments{
        "certify",  scene_,    history_, "--truth",
        "recorded", "--quiet", "--part", std::to_string(k) + "/" + std::to_string(of),
        "--report", name(k)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  // Certifies all, and gives their names.
  Arguments parts(int of) const {
    Arguments names;
    for (int k = 1; k <= of; ++k) {
      const Result result = part(k, of);
      EXPECT_EQ(result.code, 0) << result.err;
      EXPECT_EQ(result.out, about_shard(k, of) + "s SHARD " + std::to_string(k) + "/" +
                                std::to_string(of) + " CERTIFIED\n");
      names.push_back(name(k));
    }
    return names;
  }

  Arguments merge(const Arguments& names) const {
    Arguments arguments{"certify", "--report", report_, "--quiet", "--merge"};
    arguments.insert(arguments.end(), names.begin(), names.end());
    return arguments;
  }

  void refused_merge(const Arguments& names, const std::string& message) const {
    const Result result = run(merge(names));
    EXPECT_EQ(result.code, 2) << message;
    EXPECT_EQ(result.out, "s INVALID\n") << message;
    EXPECT_NE(result.err.find(message), std::string::npos) << message << ": " << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(std::filesystem::exists(report_)) << message;
  }

  void change(int k, const std::function<void(Json&)>& what) const {
    Json shard = json("s" + std::to_string(k) + ".shard.json");
    what(shard);
    directory_.write("s" + std::to_string(k) + ".shard.json", shard.dump());
  }

  // The history without the first flip after so many bytes.
  void drop_a_flip(std::size_t after) const {
    std::string text = read_bytes(history_);
    const std::size_t flip = text.find("\"flip\"", after), from = text.rfind('\n', flip);
    text.erase(from, text.find('\n', flip) - from);
    directory_.write("a.history.jsonl", text);
  }

  std::string scene_, history_, report_;
};

}  // namespace voroproof::internal
