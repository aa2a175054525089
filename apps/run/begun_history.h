// The history of a run of `simulate` that did not come to its end.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "history/history_file.h"
#include "history/resumption_point.h"
#include "kinetic/event_sink.h"

namespace voroproof::internal {

// A run that was stopped or interrupted leaves HISTORY, or HISTORY.partial beside a complete one; a
// process that was killed leaves a file for the time being (AtomicFile), possibly cut off within a
// line.
class BegunHistory {
 public:
  // Of these files the one that goes farthest, of those of the scene, the horizon and the producer
  // that `wanted` names; nothing if there is none that can be taken up. A file for the time being
  // gets the name HISTORY.partial, so that the next writer of HISTORY does not remove it. Throws
  // InputError where HISTORY itself is there and is of something else: it is not to be replaced.
  static std::optional<BegunHistory> find(const std::string& history, const HistoryHeader& wanted,
                                          int disks);

  // Removes what other processes of that run have left beside HISTORY, which is complete. What a
  // living process writes stays, and so does HISTORY.partial where it is of something else.
  static void remove_beside_complete(const std::string& history, const HistoryHeader& wanted);

  const std::string& path() const { return path_; }
  // Whether it is HISTORY, and nothing is left to do.
  bool complete(const std::string& history) const { return complete_ && path_ == history; }
  // The run is taken up at this time, after so many events.
  double t0() const { return point_.t0(); }
  std::uint64_t events() const { return point_.events(); }

  // What Engine::resume() asks for. Throws InputError, with the line, where the sink throws
  // OtherRun.
  void tell(EventSink& sink) const;

 private:
  explicit BegunHistory(std::string path) : path_(std::move(path)) {}

  // What there is of it; nothing if the file cannot be read so far, or its run is another.
  static std::optional<BegunHistory> read(const std::string& path, const HistoryHeader& wanted,
                                          int disks);

  std::string path_;
  int disks_ = 0;
  bool complete_ = false;
  ResumptionPoint point_;
};

}  // namespace voroproof::internal
