// The example history of docs/formats.md, and what a file says.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "history/error.h"
#include "history/history_reader.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal::testing {

inline const std::string hash(64, 'a');

// The example of docs/formats.md.
inline const std::vector<std::string> good_lines = {
    R"({"format":"voroproof-history","version":1,"scene_sha256":")" + hash +
        R"(","horizon":1000,"producer":"name version","initial":[[-1,0,1,1],[-1,1,0,0],[0,1,-1,-1]]})",
    R"({"t":1.25,"flip":[2,9,3,7]})",
    R"({"t":2.5,"collide":[3,7],"v":[[0.5,1],[2,0.25]],"p":[[1,2],[3,4]]})",
    R"({"t":3.5,"collide":[-1,4],"v":[null,[1,0]],"p":[null,[5,6]]})",
    R"({"t":4,"maneuver":5,"v":[1,0],"p":[7,8]})",
    R"({"end":{"t":1000,"flips":1,"collisions":2,"maneuvers":1}})",
};

inline std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

// What a file says, or the fault in it.
struct Told {
  HistoryHeader header;
  std::vector<Event> events;
  std::vector<std::int64_t> lines;
  std::variant<HistoryEnd, HistoryStop> ending;
  bool counts_match = false;
  std::string fault;
};

inline Told read(const std::string& path, int disk_count = max_disks) {
  Told told;
  try {
    HistoryReader reader(path, disk_count);
    told.header = reader.header();
    while (auto event = reader.next()) {
      told.events.push_back(*event);
      told.lines.push_back(reader.line());
    }
    EXPECT_FALSE(reader.next());
    told.ending = reader.ending();
    told.counts_match = reader.counts_match();
  } catch (const InputError& e) {
    told.fault = e.what();
  }
  return told;
}

// The fault without the directory.
inline std::string fault(const TemporaryDirectory& directory, const std::string& bytes,
                         int disk_count = max_disks) {
  std::string message = read(directory.write("h", bytes), disk_count).fault;
  if (message.empty()) return message;
  EXPECT_TRUE(message.starts_with(directory.file("h:")));
  return message.substr(directory.file("h:").size());
}

}  // namespace voroproof::internal::testing
