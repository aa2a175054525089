#include "library/movie/movie_data.h"

#include <algorithm>
#include <limits>
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
  explicit Collector(const Scene& scene) : replay_(scene, options_) {}

  void add(const Event& event) {
    data_.times.push_back(time(event));
    std::visit([&](const auto& kind) { describe(kind, event); }, event);
  }

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
  Replay replay_;
  MovieData data_;
};

std::vector<Quad> initial_edges(const Claim& claim, const EngineOptions& options) {
  const auto& recorded = claim.history->header().initial;
  return recorded ? *recorded : snapshot(claim.scene, 0, options).edges;
}

}  // namespace

MovieData movie_data(Claim& claim, const std::string& history_path,
                     const std::optional<Rational>& until, std::int64_t line,
                     const EngineOptions& options) {
  HistorySource& history = *claim.history;
  if (claim.scene.disks.size() > max_movie_disks) {
    throw InputError(history_path, 0, "disks",
                     "a movie holds at most " + std::to_string(max_movie_disks));
  }
  Collector collector(claim.scene);
  MovieData& data = collector.data();
  try {
    for (const Quad& q : initial_edges(claim, options)) add_quad(data.initial, q);
  } catch (const Undecided& stop) {  // as where a disk slides along the wall at once
    data.no_initial = stop.what();
  }
  while (const std::optional<Event> event = history.next()) {
    if (until && exact_time(*event) > *until) continue;
    if (data.times.size() == max_movie_events) {
      throw InputError(history_path, history.line(), "",
                       "a movie holds at most " + std::to_string(max_movie_events) +
                           " events: cut it with --until");
    }
    if (history.line() < line) data.event_at_line = data.times.size() + 1;
    collector.add(*event);
  }
  data.end = round_nearest(history.header().horizon);
  if (const auto* stop = std::get_if<HistoryStop>(&history.ending())) {
    data.stop = *stop;
    data.end = stop->t;
  }
  if (until && *until < to_rational(data.end)) {
    data.end = round_nearest(*until);
    data.cut = true;
    data.stop.reset();
  }
  data.remarks = claim.remarks;
  for (const std::string& remark : history.remarks()) data.remarks.push_back(remark);
  if (!history.counts_match()) data.remarks.push_back("the counts of the last line are wrong");
  return std::move(data);
}

}  // namespace voroproof::internal
