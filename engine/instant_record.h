// The events of the present instant, kept back until all of the instant is decided.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "engine/event_sink.h"
#include "filtered/motion/options.h"
#include "filtered/numbers/next_double.h"

namespace voroproof::internal {

class InstantRecord {
 public:
  // `max_events`: of the whole history; 0 for no limit.
  explicit InstantRecord(std::uint64_t max_events) : max_events_(max_events) {}

  // The time of the instant, rounded. The collision or maneuver that tells a lone instant's time
  // comes before it is known here.
  void set_time(double t) { t_ = t; }
  double time() const { return t_; }
  // Events so far that have been told.
  std::uint64_t told() const { return told_; }
  // Before this time the history told is right, if `frontier` is such a time, too. The time of an
  // instant that was begun is known, and is the same in whatever way it was found: the history is
  // right up to just before it.
  double right_before(double frontier) const {
    return std::max(told_t_, t_ > told_t_ ? next_below(t_) : frontier);
  }
  // The time of the last instant that was told.
  double told_time() const { return told_t_; }

  // Goes on after events that were told before this object was there, the last of them at time t.
  void go_on_after(std::uint64_t events, double t) {
    told_ = events;
    t_ = told_t_ = t;
  }

  void add_flip(const Quad& canonical_edge) { events_.emplace_back(canonical_edge); }
  void add_collision(GenId i, GenId j, const Impact& impact) {
    add_collision(i, j, impact.first, impact.second);
  }
  void add_collision(GenId i, GenId j, const RoundedState& first, const RoundedState& second) {
    events_.emplace_back(Change{i, j, first, second});
  }
  void add_maneuver(GenId disk, const RoundedState& state) {
    events_.emplace_back(Change{disk, disk, state, {}});
  }

  // Tells the sink. Throws Undecided where the history becomes too long.
  void tell(EventSink& sink) {
    if (max_events_ > 0 && told_ + events_.size() > max_events_) {
      throw Undecided("the history has more than " + std::to_string(max_events_) + " events");
    }
    for (const auto& event : events_) {
      ++told_;
      if (const Quad* q = std::get_if<Quad>(&event)) {
        sink.flip(t_, *q);
      } else {
        const Change& c = std::get<Change>(event);
        if (c.i == c.j) {
          sink.maneuver(t_, c.i, c.first);
        } else {
          sink.collide(t_, c.i, c.j, c.first, c.second);
        }
      }
    }
    if (!events_.empty()) told_t_ = t_;
    events_.clear();
  }

 private:
  struct Change {
    GenId i, j;  // equal for a maneuver
    RoundedState first, second;
  };

  std::uint64_t max_events_;
  double t_ = 0, told_t_ = 0;
  std::uint64_t told_ = 0;
  std::vector<std::variant<Quad, Change>> events_;
};

}  // namespace voroproof::internal
