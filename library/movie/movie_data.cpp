#include "library/movie/movie_data.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>

#include "certify/replay.h"
#include "history/error.h"
#include "library/snapshot.h"

namespace voroproof::internal {
namespace {

std::uint16_t movie_id(GenId g) {
  return g == container_id ? std::numeric_limits<std::uint16_t>::max()
                           : static_cast<std::uint16_t>(g);
}

void add_quad(std::vector<std::uint16_t>& ids, const Quad& q) {
  for (const GenId g : {q.l, q.r, q.s, q.e}) ids.push_back(movie_id(g));
}

class Collector {
 public:
  explicit Collector(const Scene& scene) : scene_(scene), replay_(scene, options_) {}

  void begin(const std::vector<Quad>& edges) {
    for (const Quad& q : edges) add_quad(data_.initial, q);
  }

  // The events that are replayed are those before the movie, which begins with open().
  void replay_from(const IndexedCut& at) {
    replay_.read(at);
    is_replaying_ = true;
    data_.left_out = at.cut.claims.all();
    last_line_ = at.cut.line;
  }
  void replay_from_begin(const std::vector<Quad>& edges) {
    try {
      replay_.diagram() = diagram_of(replay_.disks(), edges);
      is_replaying_ = true;
    } catch (const std::invalid_argument& fault) {
      data_.no_initial = std::string("at t = 0: ") + fault.what();
    }
  }
  void replay(const Event& event, std::int64_t line) {
    ++data_.left_out;
    last_line_ = line;
    const auto* flip = std::get_if<FlipEvent>(&event);
    if (flip != nullptr && !is_replaying_) return;
    if (!replay_.take(event).is_none() || flip == nullptr) return;
    // A name without orientation (docs/formats.md, section 8)?
    const Diagram::HalfEdge h =
        flip->quad.s == flip->quad.e ? -1 : replay_.find_mirrored(flip->quad);
    if (h >= 0) {
      replay_.diagram().flip(h);
      return;
    }
    is_replaying_ = false;
    data_.no_initial = "the flip on line " + std::to_string(line) + " is of no edge";
  }

  // The movie begins, at that time.
  void open(const Rational& t) {
    data_.begin = round_nearest(t);
    for (GenId g = 0; g < replay_.disks(); ++g) {
      const ExactVec2 p = replay_.path(g).at(t), v = replay_.velocity(g).value();
      const Rational radius = scene_.disks[static_cast<std::size_t>(g)].radius;
      for (const Rational* q : {&p[0], &p[1], &radius, &v[0], &v[1]}) {
        data_.disks.push_back(round_nearest(*q));
      }
    }
    if (is_replaying_) begin(replay_.diagram().quads());
  }

  void add(const Event& event) {
    data_.times.push_back(time(event));
    std::visit([&](const auto& kind) { describe(kind, event); }, event);
  }

  // The last line of what is before the movie; 0 where nothing is.
  std::int64_t last_line() const { return last_line_; }

  MovieData& data() { return data_; }

 private:
  static CertifyOptions recorded() {
    CertifyOptions options;
    options.truth = Truth::recorded;
    return options;
  }

  void describe(const FlipEvent& flip, const Event&) {
    data_.kinds.push_back(MovieEvent::flip);
    add_quad(data_.ids, flip.quad);
  }

  void describe(const CollideEvent& contact, const Event& event) {
    data_.kinds.push_back(MovieEvent::collision);
    replay_.take(event);
    for (const int side : {0, 1}) {
      const GenId g = side == 0 ? contact.i : contact.j;
      data_.ids.push_back(movie_id(g));
      if (g != container_id) add_velocity(g, contact.v[side]);
    }
  }

  void describe(const ManeuverEvent& maneuver, const Event& event) {
    data_.kinds.push_back(MovieEvent::maneuver);
    replay_.take(event);
    data_.ids.push_back(movie_id(maneuver.disk));
    add_velocity(maneuver.disk, maneuver.v);
  }

  // Adds the velocity as it is recorded, else as the replay has it. Where the replay makes nothing
  // of the claim, that is the velocity before it.
  void add_velocity(GenId g, const std::optional<Vec2>& recorded) {
    const Velocity& v = replay_.velocity(g);
    const Vec2 nearest = recorded ? *recorded
                         : v.exact
                             ? Vec2{round_nearest((*v.exact)[0]), round_nearest((*v.exact)[1])}
                             : v.near;
    data_.velocities.insert(data_.velocities.end(), nearest.begin(), nearest.end());
  }

  const CertifyOptions options_ = recorded();
  const Scene& scene_;
  Replay replay_;
  bool is_replaying_ = false;  // the flips before the movie
  std::int64_t last_line_ = 0;
  MovieData data_;
};

std::vector<Quad> initial_edges(const Claim& claim, const EngineOptions& options) {
  const auto& recorded = claim.history->header().initial;
  return recorded ? *recorded : snapshot(claim.scene, 0, options).edges;
}

// Brings the collector to where the reading of the history begins.
void start(Claim& claim, const std::string& history_path, const MovieSpan& span,
           const EngineOptions& options, Collector& collector) {
  if (!span.flips) {
    collector.data().no_diagram = "flips were not judged, and no diagram is claimed";
    return;
  }
  if (span.from && span.index) {
    const auto entry =
        go_on_before(*span.index, claim.scene, *claim.history, history_path, *span.from);
    if (entry) return collector.replay_from(entry->at);
  }
  try {
    const std::vector<Quad> edges = initial_edges(claim, options);
    if (span.from) {
      collector.replay_from_begin(edges);
    } else {
      collector.begin(edges);
    }
  } catch (const Undecided& stop) {  // as where a disk slides along the wall at once
    collector.data().no_initial = stop.what();
  }
}

}  // namespace

MovieData movie_data(Claim& claim, const std::string& history_path, const MovieSpan& span,
                     std::int64_t line, const EngineOptions& options) {
  HistorySource& history = *claim.history;
  if (claim.scene.disks.size() > max_movie_disks) {
    throw InputError(history_path, 0, "disks",
                     "a movie holds at most " + std::to_string(max_movie_disks));
  }
  if (span.from && *span.from > history.header().horizon) {
    throw InputError(history_path, 0, "horizon", "the movie would begin after it");
  }
  Collector collector(claim.scene);
  MovieData& data = collector.data();
  start(claim, history_path, span, options, collector);
  bool is_open = false;
  const auto open = [&] {
    if (!std::exchange(is_open, true)) collector.open(span.from.value_or(0));
  };
  if (!span.from) open();
  while (const std::optional<Event> event = history.next()) {
    if (!span.flips && std::holds_alternative<FlipEvent>(*event)) continue;
    if (!is_open && exact_time(*event) <= *span.from) {
      collector.replay(*event, history.line());
      continue;
    }
    open();
    if (span.until && exact_time(*event) > *span.until) continue;
    if (data.times.size() == max_movie_events) {
      throw InputError(history_path, history.line(), "",
                       "a movie holds at most " + std::to_string(max_movie_events) +
                           " events: cut it with --from and --horizon");
    }
    if (history.line() < line) data.event_at_line = data.times.size() + 1;
    collector.add(*event);
  }
  open();
  if (line <= collector.last_line()) data.event_at_line.reset();
  data.end = round_nearest(history.header().horizon);
  if (const auto* stop = std::get_if<HistoryStop>(&history.ending())) {
    data.stop = *stop;
    data.end = stop->t;
  }
  if (span.until && *span.until < to_rational(data.end)) {
    data.end = round_nearest(*span.until);
    data.cut = true;
    data.stop.reset();
  }
  data.end = std::max(data.begin, data.end);
  data.remarks = claim.remarks;
  for (const std::string& remark : history.remarks()) data.remarks.push_back(remark);
  if (!history.counts_match()) data.remarks.push_back("the counts of the last line are wrong");
  return std::move(data);
}

}  // namespace voroproof::internal
