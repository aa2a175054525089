#include "apps/run/begun_history.h"

#include <cstdio>
#include <filesystem>
#include <utility>
#include <variant>

#include "history/error.h"
#include "history/json_text.h"
#include "kinetic/engine.h"

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

std::string partial_of(const std::string& history) { return history + ".partial"; }

}  // namespace

std::optional<BegunHistory> BegunHistory::find(const std::string& history,
                                               const HistoryHeader& wanted, int disks) {
  std::optional<BegunHistory> best;
  if (exists(history)) {
    const std::string other = difference(HistoryReader(history).header(), wanted);
    if (!other.empty()) throw InputError(history, 1, "", other);
    best = read(history, wanted, disks);
    if (best && best->complete_) return best;
  }
  const std::string partial = partial_of(history);
  const auto take = [&](std::optional<BegunHistory> found) {
    if (found && (!best || found->t0() > best->t0())) best = std::move(found);
  };
  if (exists(partial)) take(read(partial, wanted, disks));
  each_abandoned(history, [&](const std::string& path) {
    std::optional<BegunHistory> found = read(path, wanted, disks);
    if (!found || (best && found->t0() <= best->t0())) return;
    if (std::rename(path.c_str(), partial.c_str()) != 0) return;
    found->path_ = partial;
    best = std::move(found);
  });
  if (best && best->t0() == 0) return std::nullopt;
  return best;
}

void BegunHistory::remove_beside_complete(const std::string& history, const HistoryHeader& wanted) {
  const std::string partial = partial_of(history);
  if (exists(partial) && is_of(partial, wanted)) std::remove(partial.c_str());
  each_abandoned(history, [](const std::string& path) { std::remove(path.c_str()); });
}

std::optional<BegunHistory> BegunHistory::read(const std::string& path, const HistoryHeader& wanted,
                                               int disks) {
  BegunHistory found(path);
  found.disks_ = disks;
  std::optional<HistoryReader> reader;
  try {
    reader.emplace(path, disks);
    if (!difference(reader->header(), wanted).empty() || !reader->header().initial) return {};
    while (const std::optional<Event> event = reader->next()) found.point_.see(time(*event));
    found.complete_ = std::holds_alternative<HistoryEnd>(reader->ending());
  } catch (const InputError&) {
    // It goes so far and no farther.
    if (!reader) return std::nullopt;
  }
  return found;
}

void BegunHistory::tell(EventSink& sink) const {
  HistoryReader reader(path_, disks_);
  try {
    sink.begin(reader.header().initial.value());
    for (std::uint64_t k = 0; k < events(); ++k) tell_event(reader.next().value(), sink);
  } catch (const OtherRun& other) {
    throw InputError(path_, reader.line(), "", other.what());
  }
}

}  // namespace voroproof::internal
