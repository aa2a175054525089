#include "voroproof/history.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "history/error.h"
#include "history/history_reader.h"
#include "history/history_writer.h"
#include "history/sha256.h"
#include "library/values.h"

namespace voroproof {
namespace internal {
namespace {

constexpr const char* name_in_memory = "history";

[[noreturn]] void fail(std::int64_t line, const char* field, const char* reason) {
  throw InputError(name_in_memory, line, field, reason);
}

bool is_finite(const std::optional<Vec2>& v) {
  return !v || (std::isfinite((*v)[0]) && std::isfinite((*v)[1]));
}

// Whether a collision's values are finite, and there for both disks or for neither, and not for the
// container.
bool well_formed(const CollideEvent& c, const std::array<std::optional<Vec2>, 2>& values) {
  if (!is_finite(values[0]) || !is_finite(values[1])) return false;
  return c.i == container_id ? !values[0] : values[0].has_value() == values[1].has_value();
}

class MemoryHistory final : public HistorySource {
 public:
  MemoryHistory(const voroproof::History& history, int disks) : history_(history), disks_(disks) {
    header_.scene_sha256 = history.scene_sha256;
    header_.horizon = rational(history.horizon);
    header_.producer = history.producer;
    header_.extensions = history.extensions;
    if (header_.horizon < 0) fail(1, "horizon", "negative");
    horizon_ = round_nearest(header_.horizon);
    if (history.initial) read_initial(*history.initial);
  }

  const HistoryHeader& header() const override { return header_; }
  std::int64_t line() const override { return static_cast<std::int64_t>(taken_) + 1; }
  const std::variant<HistoryEnd, HistoryStop>& ending() const override { return ending_; }
  const HistoryCounts& counts() const override { return counts_; }
  bool counts_match() const override { return true; }
  std::vector<std::string> remarks() const override { return {}; }
  // The hash of the file that write_history() would write.
  std::string content_sha256() override;
  std::optional<std::int64_t> shadow_line(const Quad&, double, double) const override {
    return std::nullopt;
  }

  std::optional<Event> next() override {
    if (taken_ == history_.events.size()) {
      if (!ended_) finish();
      return std::nullopt;
    }
    Event event = internal::event(history_.events[taken_]);
    ++taken_;
    check(time(event));
    std::visit([this](const auto& e) { check(e); }, event);
    return event;
  }

 private:
  void read_initial(const std::vector<voroproof::Edge>& edges) {
    std::vector<Quad>& initial = header_.initial.emplace();
    for (const voroproof::Edge& edge : edges) initial.push_back(checked(quad(edge), 1, "initial"));
    std::sort(initial.begin(), initial.end());
    if (std::adjacent_find(initial.begin(), initial.end()) != initial.end()) {
      fail(1, "initial", "names an edge twice");
    }
  }

  Quad checked(const Quad& q, std::int64_t line, const char* field) const {
    for (const GenId g : {q.l, q.r, q.s, q.e}) check_id(g, container_id, line, field);
    if (!names_an_edge(q)) fail(line, field, "names no edge: its generators are not distinct");
    return canonical(q);
  }

  void check_id(GenId g, GenId least, std::int64_t line, const char* field) const {
    if (g < least || g >= disks_) fail(line, field, "no such generator");
  }

  void check(double t) {
    if (!std::isfinite(t) || t < 0) fail(line(), "t", "not a time");
    if (t < last_t_) fail(line(), "t", "before the event before it");
    if (t > horizon_) fail(line(), "t", "beyond the horizon");
    last_t_ = t;
  }
  void check(const FlipEvent& e) {
    checked(e.quad, line(), "flip");
    ++counts_.flips;
  }
  void check(const CollideEvent& e) {
    check_id(e.i, container_id, line(), "collide");
    check_id(e.j, 0, line(), "collide");
    if (e.i >= e.j) fail(line(), "collide", "not two ids, the smaller first");
    if (!well_formed(e, e.v)) fail(line(), "v", "not a velocity for each disk");
    if (!well_formed(e, e.p)) fail(line(), "p", "not a centre for each disk");
    ++counts_.collisions;
  }
  void check(const ManeuverEvent& e) {
    check_id(e.disk, 0, line(), "maneuver");
    if (!is_finite(e.v) || !is_finite(e.p)) fail(line(), "v", "not finite");
    ++counts_.maneuvers;
  }

  void finish() {
    ended_ = true;
    if (history_.ending.complete) {
      ending_ = HistoryEnd{counts_};
      return;
    }
    check(history_.ending.t);
    HistoryStop stop;
    stop.t = history_.ending.t;
    stop.reason = history_.ending.reason;
    ending_ = stop;
  }

  const voroproof::History& history_;
  int disks_;
  HistoryHeader header_;
  HistoryCounts counts_;
  double horizon_ = 0, last_t_ = 0;
  std::size_t taken_ = 0;
  bool ended_ = false;
  std::variant<HistoryEnd, HistoryStop> ending_;
};

void write_as(const std::string& path, const voroproof::History& history) {
  MemoryHistory source(history, max_disks);
  HistoryWriter writer(path);
  writer.header(source.header());
  for (std::size_t k = 0; const auto event = source.next(); ++k) {
    const auto extended = history.event_extensions.find(k);
    writer.write(*event,
                 extended == history.event_extensions.end() ? Extensions{} : extended->second);
  }
  const Ending& ending = history.ending;
  if (ending.complete) {
    writer.end(ending.extensions);
  } else {
    writer.stopped(ending.t, ending.reason, {}, ending.extensions);
  }
  writer.close();
}

std::string MemoryHistory::content_sha256() {
  const int file = memfd_create("history", MFD_CLOEXEC);
  if (file < 0) throw OutputError(name_in_memory, std::strerror(errno));
  const std::unique_ptr<const int, void (*)(const int*)> closed(&file,
                                                                [](const int* f) { close(*f); });
  write_as("/proc/self/fd/" + std::to_string(file), history_);
  lseek(file, 0, SEEK_SET);
  Sha256 sha;
  std::vector<char> piece(std::size_t{1} << 18);
  for (;;) {
    const ssize_t got = read(file, piece.data(), piece.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw OutputError(name_in_memory, std::strerror(errno));
    if (got == 0) return sha.hex();
    sha.add({piece.data(), static_cast<std::size_t>(got)});
  }
}

bool is_rounded(const Event& event) {
  return std::visit([](const auto& e) { return e.exact != nullptr; }, event);
}

struct ToPublic {
  voroproof::Event operator()(const FlipEvent& e) const {
    return voroproof::FlipEvent{e.t, edge_value(e.quad)};
  }
  voroproof::Event operator()(const CollideEvent& e) const {
    voroproof::CollisionEvent out;
    out.t = e.t;
    out.i = e.i;
    out.j = e.j;
    out.velocity = e.v;
    out.center = e.p;
    return out;
  }
  voroproof::Event operator()(const ManeuverEvent& e) const {
    voroproof::ManeuverEvent out;
    out.t = e.t;
    out.disk = e.disk;
    out.velocity = e.v;
    out.center = e.p;
    return out;
  }
};

struct ToInternal {
  Event operator()(const voroproof::FlipEvent& e) const {
    return FlipEvent{.t = e.t, .quad = canonical(quad(e.edge))};
  }
  Event operator()(const voroproof::CollisionEvent& e) const {
    CollideEvent out;
    out.t = e.t;
    out.i = e.i;
    out.j = e.j;
    out.v = e.velocity;
    out.p = e.center;
    return out;
  }
  Event operator()(const voroproof::ManeuverEvent& e) const {
    ManeuverEvent out;
    out.t = e.t;
    out.disk = e.disk;
    out.v = e.velocity;
    out.p = e.center;
    return out;
  }
};

}  // namespace

voroproof::Edge edge_value(const Quad& q) { return {q.l, q.r, q.s, q.e}; }
Quad quad(const voroproof::Edge& edge) { return {edge.l, edge.r, edge.s, edge.e}; }
voroproof::Event event_value(const Event& event) { return std::visit(ToPublic{}, event); }
Event event(const voroproof::Event& event) { return std::visit(ToInternal{}, event); }

Claim memory_claim(const voroproof::Scene& scene, const voroproof::History& history) {
  Claim claim;
  claim.scene = checked_scene(scene);
  claim.history = memory_history(history, static_cast<int>(claim.scene.disks.size()));
  if (history.scene_sha256 != claim.scene.sha256) {
    fail(1, "scene_sha256", "the history is one of another scene");
  }
  return claim;
}

std::unique_ptr<HistorySource> memory_history(const voroproof::History& history, int disks) {
  return std::make_unique<MemoryHistory>(history, disks);
}

}  // namespace internal

using internal::with_public_errors;

Edge canonical(const Edge& edge) {
  return internal::edge_value(internal::canonical(internal::quad(edge)));
}
Edge flipped(const Edge& edge) {
  return internal::edge_value(internal::flipped(internal::quad(edge)));
}

double time(const Event& event) {
  return std::visit([](const auto& e) { return e.t; }, event);
}

EventSink::~EventSink() = default;

History read_history(const std::string& path) {
  History events;
  internal::Collecting sink(events);
  History out = read_history(path, sink);
  out.events = std::move(events.events);
  return out;
}

History read_history(const std::string& path, EventSink& sink) {
  return with_public_errors([&] {
    internal::HistoryReader reader(path);
    History out;
    out.scene_sha256 = reader.header().scene_sha256;
    out.horizon = internal::number(reader.header().horizon);
    out.producer = reader.header().producer;
    out.extensions = reader.header().extensions;
    if (reader.header().initial) {
      out.initial.emplace();
      for (const internal::Quad& q : *reader.header().initial) {
        out.initial->push_back(internal::edge_value(q));
      }
      sink.begin(*out.initial);
    }
    for (std::size_t k = 0; const auto event = reader.next(); ++k) {
      if (!reader.extensions().empty()) out.event_extensions.emplace(k, reader.extensions());
      sink.event(internal::event_value(*event));
      out.rounded += internal::is_rounded(*event);
    }
    if (const auto* stop = std::get_if<internal::HistoryStop>(&reader.ending())) {
      out.ending = {false, stop->t, stop->reason, {}};
    } else {
      if (!reader.counts_match()) {
        throw internal::InputError(path, reader.line(), "end", "wrong counts of events");
      }
      out.ending = {true, out.horizon.nearest(), {}, {}};
    }
    out.ending.extensions = reader.extensions();
    return out;
  });
}

void write_history(const std::string& path, const History& history) {
  with_public_errors([&] { internal::write_as(path, history); });
}

}  // namespace voroproof
