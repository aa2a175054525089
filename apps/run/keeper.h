// The means by which a run of `simulate` can be taken up by a later one.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "apps/run/begun_history.h"
#include "apps/run/checkpoints.h"
#include "apps/run/history_sink.h"
#include "apps/run/partial_file.h"
#include "engine/engine.h"
#include "history/history_reader.h"
#include "history/history_writer.h"
#include "history/output_file.h"

namespace voroproof::internal {

class Keeper {
 public:
  // `header`: of the history, without the diagram. `seconds`: from one time to keep to the next.
  // `writer`, to which nothing has been written, outlives this. Throws UsageError where something
  // else has the name of the file to keep in.
  Keeper(const std::string& history, HistoryHeader header, HistoryWriter& writer,
         std::uint64_t seconds);

  // The engine's run, whose events go to the sink, is kept now and then; `before` is called before
  // that is written. All of them outlive it.
  void serve(EngineOptions& options, HistorySink& sink, std::function<void()> before);

  // The writer's history begins with what was begun.
  void begin_with(const BegunHistory& begun, HistorySink& sink);

  // Notes how far the history has come, which stopped and has no last line yet.
  void see_stop();
  // Gives the history that stopped its name, so that no file loses events; says where it is.
  void close_stopped();
  // The history is complete, and has its name: what was kept is of no use, nor, with `all`, what is
  // beside it of the same run.
  void forget(bool all) const;
  // There is no room for the history: what was written stays for a later run, if there is something
  // beside it that it must not replace. Whether that is so.
  bool leave();

 private:
  using Clock = std::chrono::steady_clock;

  void keep(KeptFile& kept);

  std::string history_;
  HistoryHeader header_;
  HistoryWriter& writer_;
  PartialFile file_;
  Checkpoints checkpoints_;
  std::atomic<Clock::time_point> not_before_{Clock::time_point()};  // may it be kept again
  // Written up to the last mark, after so many events; used by the thread that writes.
  HistoryCounts marked_counts_;
  OutputFile::Written marked_;
  OutputFile::Written stopped_;  // see see_stop()
};

}  // namespace voroproof::internal
