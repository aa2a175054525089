// A replay as text, as an index beside a history keeps it (docs/formats.md, section 19).
#pragma once

#include <string>

#include "certify/replay.h"

namespace voroproof::internal {

// Reads what the replay and its paths keep to themselves.
class ReplayWriter {
 public:
  explicit ReplayWriter(std::string& out) : out_(out) {}

  // A JSON object. Precondition: the replay is of the recorded truth.
  void put(const Replay& replay);

 private:
  void put(const DyadicSum& sum);
  // Two numbers of a history with a comma between.
  void put(const Velocity& velocity);
  // But for the velocity: the time of the last turn and both coordinates there, with commas
  // between. Where the path is one of binary64 values, a number and two sums; else three strings.
  void put(const Path& path);
  void put_disk(const Replay& replay, std::size_t g);

  std::string& out_;
};

}  // namespace voroproof::internal
