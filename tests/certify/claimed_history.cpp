#include "tests/certify/claimed_history.h"

#include "history/error.h"
#include "library/maneuver_input.h"

namespace voroproof::internal::testing {

namespace {

HistoryCounts counts_of(const std::vector<voroproof::internal::Event>& events) {
  HistoryCounts c;
  for (const auto& e : events) {
    c.flips += std::holds_alternative<FlipEvent>(e);
    c.collisions += std::holds_alternative<CollideEvent>(e);
    c.maneuvers += std::holds_alternative<ManeuverEvent>(e);
  }
  return c;
}

}  // namespace

void ClaimedHistory::count() { claimed_counts = counts_of(events); }

ClaimedHistory claimed_history(const Scene& scene, const RecordedRun& run) {
  ClaimedHistory h;
  h.header.horizon = scene.horizon;
  h.header.producer = "voroproof";
  h.header.initial = run.initial;
  for (const Event& e : run.events) {
    const auto v = [](const RoundedState& s) { return Vec2{s.vx, s.vy}; };
    const auto p = [](const RoundedState& s) { return Vec2{s.px, s.py}; };
    switch (e.kind) {
      case Event::Kind::flip:
        h.events.emplace_back(FlipEvent{e.t, e.edge, {}});
        break;
      case Event::Kind::collision: {
        CollideEvent c{.t = e.t, .i = e.i, .j = e.j};
        if (e.i != container_id) {
          c.v[0] = v(e.first);
          c.p[0] = p(e.first);
        }
        c.v[1] = v(e.second);
        c.p[1] = p(e.second);
        h.events.emplace_back(c);
        break;
      }
      case Event::Kind::maneuver:
        h.events.emplace_back(ManeuverEvent{e.t, e.i, v(e.first), p(e.first), {}});
        break;
    }
  }
  h.count();
  return h;
}

std::optional<ClaimedHistory> read_claimed_history(const std::string& path, const Scene& scene) {
  try {
    const auto file = open_history(path, static_cast<int>(scene.disks.size()));
    ClaimedHistory h;
    h.header = file->header();
    while (auto event = file->next()) h.events.push_back(std::move(*event));
    if (!std::holds_alternative<HistoryEnd>(file->ending())) return std::nullopt;
    h.claimed_counts = file->counts();
    return h;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::string text(const ClaimedHistory& history) {
  std::string out;
  char number[40];
  int line = 2;
  for (const auto& e : history.events) {
    std::snprintf(number, sizeof number, "%d: t %.17g ", line++, time(e));
    out += number;
    if (const auto* f = std::get_if<FlipEvent>(&e)) {
      out += "flip " + text(f->quad);
    } else if (const auto* c = std::get_if<CollideEvent>(&e)) {
      out += "collide " + std::to_string(c->i) + " " + std::to_string(c->j);
    } else {
      out += "maneuver " + std::to_string(std::get<ManeuverEvent>(e).disk);
    }
    out += '\n';
  }
  return out;
}

MemoryHistory::MemoryHistory(const ClaimedHistory& history)
    : history_(history), ending_(HistoryEnd{history.claimed_counts}) {
  if (history.stop) ending_ = *history.stop;
}

std::optional<voroproof::internal::Event> MemoryHistory::next() {
  if (next_ >= history_.events.size()) {
    next_ = history_.events.size() + 1;
    counts_ = counts_of(history_.events);
    return std::nullopt;
  }
  return history_.events[next_++];
}

Certificate certify(const Scene& scene, const ClaimedHistory& history, CertifyOptions options) {
  MemoryHistory source(history);
  return voroproof::internal::certify(scene, source, options);
}

}  // namespace voroproof::internal::testing
