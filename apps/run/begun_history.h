// The history of a run of `simulate` that did not come to its end.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "apps/run/kept_file.h"
#include "engine/event_sink.h"
#include "history/history_reader.h"
#include "history/output_file.h"

namespace voroproof::internal {

// A run that was stopped or interrupted leaves HISTORY, or HISTORY.partial beside a complete one; a
// process that was killed leaves a file for the time being (AtomicFile), possibly cut off within a
// line. HISTORY.kept says up to where one of them can be gone on from: of the others nothing is
// believed.
class BegunHistory {
 public:
  // Finds what can be taken up of the run of the scene, the horizon and the producer that `wanted`
  // names: a complete HISTORY, or a file with the beginning that was kept; nothing if there is
  // none. The temporary file that goes farthest, or can be taken up, gets the name HISTORY.partial,
  // so that the next writer of HISTORY does not remove it. Throws InputError where HISTORY itself
  // is there and belongs to something else: it is not to be replaced.
  static std::optional<BegunHistory> find(const std::string& history, const HistoryHeader& wanted,
                                          int disks);

  // Removes what other processes of that run have left beside HISTORY, which is complete. What a
  // living process writes stays, and so does HISTORY.partial where it is of something else.
  static void remove_beside_complete(const std::string& history, const HistoryHeader& wanted);
  // Removes HISTORY.partial where it is of that run and has no more than so many events.
  static void remove_shorter(const std::string& history, const HistoryHeader& wanted,
                             std::int64_t events);
  // Whether there is HISTORY or HISTORY.partial, of whatever run.
  static bool is_there(const std::string& history);

  const std::string& path() const { return path_; }
  // Whether it is HISTORY, and nothing is left to do.
  bool complete() const { return !kept_; }
  // The kept part of a history that is not complete.
  const KeptFile& kept() const { return kept_.value(); }

  // Tells the history as Engine::resume() asks for it. Throws InputError, with the line, where the
  // sink throws OtherRun.
  void tell(EventSink& sink) const;

 private:
  BegunHistory(std::string path, int disks, std::optional<KeptFile> kept)
      : path_(std::move(path)), disks_(disks), kept_(std::move(kept)) {}

  std::string path_;
  int disks_;
  std::optional<KeptFile> kept_;
};

// Where a history that stopped goes, for no file beside it to lose events: HISTORY,
// HISTORY.partial, or nowhere, because one of them has its events and more.
enum class PlaceOfStopped { history, partial, none };
PlaceOfStopped place_of_stopped(const std::string& history, const OutputFile::Written& events,
                                std::int64_t number);

}  // namespace voroproof::internal
