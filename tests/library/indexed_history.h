// A history in a file, and its index.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "certify/fingerprint.h"
#include "certify/report.h"
#include "history/error.h"
#include "history/history_writer.h"
#include "history/scene_writer.h"
#include "library/certification.h"
#include "library/history_index.h"
#include "library/index_format.h"
#include "library/shard_file.h"
#include "tests/certify/claimed_history.h"
#include "tests/history/temporary_directory.h"
#include "tests/library/index_entry.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
using Json = nlohmann::ordered_json;

inline constexpr const char* program = "program 1";

inline CertifyOptions small_parts() {
  CertifyOptions options;
  options.truth = Truth::recorded;
  options.least_part = 24;
  return options;
}

class Indexes : public ::testing::Test {
 protected:
  void SetUp() override {
    Random random(11);
    write_scene_file(
        "a",
        random_scene({.n = 8, .rmin = 2, .rmax = 20, .horizon = 1500, .density = 0.2}, random));
    history_ = claimed_history(scene_, run(scene_));
    history_.header.scene_sha256 = scene_.sha256;
    write("a.history.jsonl", history_);
  }

  std::string file(const std::string& name) const { return directory_.file(name); }

  void write_scene_file(const std::string& name, const Scene& scene) {
    std::ostringstream text;
    write_scene(text, scene);
    scene_ = read_scene(directory_.write(name + ".scene.json", text.str()));
  }

  void write(const std::string& name, const ClaimedHistory& history) const {
    HistoryWriter writer(file(name));
    writer.header(history.header);
    for (const auto& event : history.events) writer.write(event);
    writer.end();
    writer.close();
  }

  Claim claim(const std::string& name = "a.history.jsonl") const {
    return open_claim(file("a.scene.json"), file(name));
  }

  std::int64_t index(const std::string& history = "a.history.jsonl",
                     const std::string& name = "a.index") const {
    Claim of = claim(history);
    return write_index(file(name), program, of, file(history), small_parts());
  }

  // The lines of the index, and back.
  std::vector<Json> lines() const {
    std::vector<Json> all;
    std::istringstream in(directory_.read("a.index"));
    for (std::string line; std::getline(in, line);) all.push_back(Json::parse(line));
    return all;
  }
  void put(const std::vector<Json>& lines) const {
    std::string text;
    for (const Json& line : lines) text += line.dump() + "\n";
    directory_.write("a.index", text);
  }

  // The certificate of a shard, in a file. Reading begins at `start`, whatever an index would say.
  std::string shard(int number, int of, const std::string& history,
                    const std::optional<IndexedCut>& start) const {
    Claim read = claim(history);
    ShardFile out;
    out.number = number;
    out.of = of;
    out.options = options_;
    out.run = certification_run(program, "a.scene.json", history, read, {});
    ShardTask task{.number = number, .of = of};
    task.start = start;
    out.shard = certify_shard(read.scene, *read.history, options_, task);
    return directory_.write(std::to_string(number) + ".shard.json", shard_text(out));
  }

  std::optional<IndexEntry> find(const std::function<bool(const Cut&)>& is_early,
                                 const CertifyOptions& options = small_parts(),
                                 const std::string& by = program) const {
    Claim read = claim();
    return find_entry({file("a.index"), by}, read.scene, read.history->header(),
                      file("a.history.jsonl"), &options, is_early);
  }
  // Why the index is refused; empty where it is not.
  std::string refusal(const CertifyOptions& options = small_parts(),
                      const std::string& by = program) const {
    try {
      find([](const Cut&) { return true; }, options, by);
      return {};
    } catch (const InputError& error) {
      return error.what();
    }
  }

  // Why the shards of these files cannot be joined; the verdict where they can.
  static std::string merged(const std::vector<std::string>& paths) {
    try {
      return std::string(verdict_line(merge_shards(paths).shard.certificate.verdict));
    } catch (const InputError& error) {
      return error.what();
    }
  }

  const CertifyOptions options_ = small_parts();
  TemporaryDirectory directory_;
  Scene scene_;
  ClaimedHistory history_;
};

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace voroproof::internal::testing
