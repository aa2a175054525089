#include "apps/run/keeper.h"

#include <iostream>
#include <memory>
#include <new>
#include <utility>

#include "history/error.h"
#include "history/history_writer.h"

namespace voroproof::internal {

namespace {

// Keeping a run takes no more than one part in kPart of its time.
constexpr int kPart = 20;

}  // namespace

Keeper::Keeper(const std::string& history, HistoryHeader header, HistoryWriter& writer,
               std::uint64_t seconds)
    : history_(history),
      header_(std::move(header)),
      writer_(writer),
      file_(history, kept_format, kept_ending),
      checkpoints_(seconds) {
  file_.require_replaceable("-o");
  writer_.follow_content();
}

void Keeper::serve(EngineOptions& options, HistorySink& sink, std::function<void()> before) {
  options.is_to_keep = [this, &sink] {
    return sink.has_begun() && Clock::now() >= not_before_.load() && checkpoints_.due();
  };
  options.mark = [this, &sink] {
    sink.checkpoint([this] {
      marked_counts_ = writer_.counts();
      marked_ = writer_.written();
    });
  };
  options.keep = [this, &sink, before = std::move(before)](KeptRun&& kept) {
    before();
    // The thread that writes has the events first.
    const auto shared = std::make_shared<KeptFile>(KeptFile{std::move(kept), {}});
    sink.checkpoint([this, shared] { keep(*shared); });
  };
}

void Keeper::keep(KeptFile& kept) {
  if (kept.counts() != marked_counts_) return;
  const Clock::time_point begin = Clock::now();
  kept.history = marked_;
  try {
    if (file_.keep(kept_text(kept, header_))) writer_.outlive();
  } catch (const std::bad_alloc&) {
    // The run needs no such memory: another time there may be some.
  }
  const Clock::time_point end = Clock::now();
  not_before_ = end + kPart * (end - begin);
}

void Keeper::begin_with(const BegunHistory& begun, HistorySink& sink) {
  const KeptFile& kept = begun.kept();
  writer_.begin_with(begun.path(), kept.history, header_.horizon, kept.counts(), kept.run.last);
  sink.go_on_after(kept.run.last);
}

void Keeper::see_stop() { stopped_ = writer_.written(); }

void Keeper::close_stopped() {
  const std::string name = printable(history_, 4096);
  const std::int64_t events = writer_.counts().all();
  switch (place_of_stopped(history_, stopped_, events)) {
    case PlaceOfStopped::history:
      writer_.close();
      BegunHistory::remove_shorter(history_, header_, events);
      return;
    case PlaceOfStopped::partial:
      std::cerr << "voroproof: " << name
                << ": goes farther and stays; the history that stopped is in "
                << printable(writer_.close_as_partial(), 4096) << '\n';
      return;
    case PlaceOfStopped::none:
      writer_.discard();
      std::cerr << "voroproof: " << name << ": what was there goes farther and stays\n";
  }
}

void Keeper::forget(bool all) const {
  if (all) BegunHistory::remove_beside_complete(history_, header_);
  file_.forget();
}

bool Keeper::leave() {
  if (!BegunHistory::is_there(history_)) return false;
  writer_.outlive();
  return true;
}

}  // namespace voroproof::internal
