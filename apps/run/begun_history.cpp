#include "apps/run/begun_history.h"

#include <cstdio>
#include <filesystem>
#include <utility>
#include <variant>

#include "engine/engine.h"
#include "history/atomic_file.h"
#include "history/error.h"
#include "history/history_writer.h"
#include "history/json_text.h"
#include "history/output_file.h"
#include "history/sha256.h"

namespace voroproof::internal {
namespace {

// Why a history is not of that run; empty if it is.
std::string difference(const HistoryHeader& header, const HistoryHeader& wanted) {
  if (header.scene_sha256 != wanted.scene_sha256) return "is the history of another scene";
  if (header.horizon != wanted.horizon) {
    return "has the horizon " + number_text(header.horizon) + ", not " +
           number_text(wanted.horizon);
  }
  if (header.producer != wanted.producer) {
    return "was written by " + printable(header.producer) + ", not by " + wanted.producer;
  }
  return {};
}

RoundedState state(const std::optional<Vec2>& p, const std::optional<Vec2>& v) {
  if (!p || !v) throw OtherRun("the event has no p or no v");
  return {(*p)[0], (*p)[1], (*v)[0], (*v)[1]};
}

void tell_event(const Event& event, EventSink& sink) {
  if (const auto* flip = std::get_if<FlipEvent>(&event)) {
    sink.flip(flip->t, canonical(flip->quad));
  } else if (const auto* c = std::get_if<CollideEvent>(&event)) {
    const RoundedState second = state(c->p[1], c->v[1]);
    const RoundedState first = c->i == container_id ? second : state(c->p[0], c->v[0]);
    sink.collide(c->t, c->i, c->j, first, second);
  } else {
    const auto& m = std::get<ManeuverEvent>(event);
    sink.maneuver(m.t, m.disk, state(m.p, m.v));
  }
}

bool exists(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

// Whether the header of the file can be read and is that of the run.
bool is_of(const std::string& path, const HistoryHeader& wanted) {
  try {
    return difference(HistoryReader(path).header(), wanted).empty();
  } catch (const InputError&) {
    return false;
  }
}

// Whether every line of the file can be read, and the last one says that it is complete.
bool is_complete(const std::string& path, int disks) {
  if (!is_complete_history(path)) return false;
  try {
    HistoryReader reader(path, disks);
    while (reader.next()) continue;
    return std::holds_alternative<HistoryEnd>(reader.ending()) && reader.counts_match();
  } catch (const InputError&) {
    return false;
  }
}

// The lines of events in what can be read of a file; 0 where there is none.
std::int64_t events_in(const std::string& path) {
  if (!exists(path)) return 0;
  std::int64_t events = 0;
  try {
    LineSource lines(path);
    while (const auto line = lines.next(max_header_line)) events += line->starts_with("{\"t\":");
  } catch (const InputError&) {
    // It goes so far and no farther.
  }
  return events;
}

bool begins_with(const std::string& path, const OutputFile::Written& part) {
  try {
    return exists(path) && sha256_of_beginning(path, part.bytes) == part.sha256;
  } catch (const InputError&) {
    return false;
  }
}

std::string partial_of(const std::string& history) { return history + partial_ending; }

// Gives a lasting name to the file of a killed process that goes farther than the others. A file
// that can be taken up gets one, too, if no other can.
void name_abandoned(const std::string& history, const std::optional<KeptFile>& kept) {
  const std::string partial = partial_of(history);
  const bool may_go_on =
      kept && (begins_with(history, kept->history) || begins_with(partial, kept->history));
  std::int64_t most = events_in(history), in_partial = events_in(partial);
  most = std::max(most, in_partial);
  bool goes_on = may_go_on;
  each_abandoned(history, [&](const std::string& path) {
    const bool useful = kept && !goes_on && begins_with(path, kept->history);
    const std::int64_t events = events_in(path);
    if (events <= (useful ? in_partial : most)) return;
    if (std::rename(path.c_str(), partial.c_str()) != 0) return;
    goes_on = goes_on || useful;
    in_partial = events;
    most = std::max(most, events);
  });
}

}  // namespace

std::optional<BegunHistory> BegunHistory::find(const std::string& history,
                                               const HistoryHeader& wanted, int disks) {
  if (exists(history)) {
    const std::string other = difference(HistoryReader(history).header(), wanted);
    if (!other.empty()) throw InputError(history, 1, "", other);
    if (is_complete(history, disks)) return BegunHistory(history, disks, std::nullopt);
  }
  std::optional<KeptFile> kept = read_kept(history + kept_ending, wanted, disks);
  name_abandoned(history, kept);
  if (!kept) return std::nullopt;
  for (const std::string& path : {history, partial_of(history)}) {
    if (begins_with(path, kept->history)) return BegunHistory(path, disks, std::move(kept));
  }
  return std::nullopt;
}

void BegunHistory::remove_beside_complete(const std::string& history, const HistoryHeader& wanted) {
  const std::string partial = partial_of(history);
  if (exists(partial) && is_of(partial, wanted)) std::remove(partial.c_str());
  each_abandoned(history, [](const std::string& path) { std::remove(path.c_str()); });
}

void BegunHistory::remove_shorter(const std::string& history, const HistoryHeader& wanted,
                                  std::int64_t events) {
  const std::string partial = partial_of(history);
  if (events_in(partial) <= events && is_of(partial, wanted)) std::remove(partial.c_str());
}

bool BegunHistory::is_there(const std::string& history) {
  return exists(history) || exists(partial_of(history));
}

void BegunHistory::tell(EventSink& sink) const {
  HistoryReader reader(path_, disks_);
  try {
    for (std::uint64_t k = 0; k < kept().run.events; ++k) {
      const std::optional<Event> event = reader.next();
      if (!event) throw OtherRun("the history has fewer events than was kept");
      tell_event(*event, sink);
    }
  } catch (const OtherRun& other) {
    throw InputError(path_, reader.line(), "", other.what());
  }
}

PlaceOfStopped place_of_stopped(const std::string& history, const OutputFile::Written& events,
                                std::int64_t number) {
  if (events_in(history) <= number) return PlaceOfStopped::history;
  if (begins_with(history, events)) return PlaceOfStopped::none;
  const std::string partial = partial_of(history);
  if (events_in(partial) <= number) return PlaceOfStopped::partial;
  return begins_with(partial, events) ? PlaceOfStopped::none : PlaceOfStopped::partial;
}

}  // namespace voroproof::internal
