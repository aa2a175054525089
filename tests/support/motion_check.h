// The motion of a run and the order of what is simultaneous, held against the oracle of motion.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/oracle/motion.h"
#include "tests/support/checked_run.h"

namespace voroproof::internal::testing {

// At every event the state of its disks, at every instant the order of its events; and no contact
// that was missed.
template <unsigned Digits>
class MotionCheck {
 public:
  using Run = CheckedRun<Digits>;
  using Motion = typename Run::Motion;
  using Number = typename Run::Number;

  explicit MotionCheck(const Run& given)
      : scene_(given.scene),
        run_(given.run),
        counts_(given.counts),
        motion_scene_(given.motion_scene),
        records_(given.records),
        motion_(given.motion),
        horizon_(oracle::rounded<Number>(given.scene.horizon)) {}

  void run_all() const {
    check_frame();
    check_states();
    check_motion_order();
  }

 private:
  static bool is_motion(const Event& e) { return e.kind != Event::Kind::flip; }
  int disks() const { return static_cast<int>(scene_.disks.size()); }

  // Whether the nearest double of some number within `slack` of `value` is `claimed`.
  bool rounds_to(const Number& value, double claimed, const Number& slack) const {
    if (claimed == 0 && std::signbit(claimed)) return false;
    const Number low = (Number(claimed) + Number(std::nextafter(claimed, -kInfinity))) / 2;
    const Number high = (Number(claimed) + Number(std::nextafter(claimed, kInfinity))) / 2;
    return low - slack <= value && value <= high + slack;
  }

  std::vector<oracle::MotionRecord> first_records(std::size_t k) const {
    return {records_.begin(), records_.begin() + static_cast<long>(k)};
  }
  std::vector<Event>::const_iterator next_event(const Event& e) const {
    return run_.events.begin() + (&e - run_.events.data()) + 1;
  }
  std::vector<Event>::const_iterator end_of_instant(const Event& e) const {
    return std::find_if(next_event(e), run_.events.end(),
                        [&e](const Event& f) { return f.t != e.t; });
  }

  void check_frame() const {
    if (!run_.complete()) throw Fault("stopped: " + run_.outcome.reason);
    if (run_.begins != 1) throw Fault("begin was called " + std::to_string(run_.begins) + " times");
    double t = 0;
    const double end = scene_.horizon.get_d() * (1 + 1e-15);
    for (const Event& e : run_.events) {
      if (!(e.t >= t && e.t <= end)) throw Fault("out of order or beyond the horizon: " + text(e));
      t = e.t;
    }
    // Every maneuver up to the horizon took place.
    const auto due = std::count_if(scene_.maneuvers.begin(), scene_.maneuvers.end(),
                                   [&](const Maneuver& m) { return m.t <= scene_.horizon; });
    if (static_cast<std::size_t>(due) != run_.count(Event::Kind::maneuver)) {
      throw Fault("wrong number of maneuvers");
    }
  }

  void check_states() const {
    const Number tiny = pow(Number(10), -60);
    Number scale = abs(oracle::rounded<Number>(scene_.container_radius)) +
                   abs(oracle::rounded<Number>(scene_.cx)) +
                   abs(oracle::rounded<Number>(scene_.cy)) + 1;
    std::size_t k = 0;
    for (const Event& e : run_.events) {
      if (!is_motion(e)) continue;
      const Number& t = motion_.times()[k++];
      if (!rounds_to(t, e.t, tiny * (1 + abs(t)))) {
        throw Fault(text(e) + ", but the time is " + t.str(25));
      }
      const auto check_state = [&](int id, const RoundedState& s, const auto& velocity) {
        const auto p = motion_.position(id, t);
        if (!rounds_to(p[0], s.px, tiny * scale) || !rounds_to(p[1], s.py, tiny * scale)) {
          throw Fault(text(e) + ", but the place of " + std::to_string(id) + " is (" +
                      p[0].str(25) + ", " + p[1].str(25) + ")");
        }
        const Number speed = abs(velocity[0]) + abs(velocity[1]) + 1;
        if (!rounds_to(velocity[0], s.vx, tiny * speed) ||
            !rounds_to(velocity[1], s.vy, tiny * speed)) {
          throw Fault(text(e) + ", but the velocity of " + std::to_string(id) + " is (" +
                      velocity[0].str(25) + ", " + velocity[1].str(25) + ")");
        }
      };
      // Where the disk has further events at this instant, only the records so far count.
      std::optional<Motion> prefix;
      const auto velocity = [&](int id) {
        const bool again = std::any_of(next_event(e), end_of_instant(e), [&](const Event& f) {
          return is_motion(f) && (f.i == id || f.j == id);
        });
        if (!again) return motion_.velocity(id, t + pow(Number(10), -150));
        if (!prefix) prefix.emplace(motion_scene_, first_records(k));
        return prefix->velocity(id, t + 1);
      };
      if (e.i != container_id) check_state(e.i, e.first, velocity(e.i));
      if (e.kind == Event::Kind::collision) check_state(e.j, e.second, velocity(e.j));
    }
    if (const auto missed = motion_.first_missed_contact(Number(0), horizon_)) {
      throw Fault("missed contact of " + std::to_string(missed->i) + " and " +
                  std::to_string(missed->j) + " at " + missed->t.str(25));
    }
  }

  // ---- What is simultaneous. ----

  // The smallest pair that touches at t and approaches by the velocities just after `prefix`.
  std::optional<std::pair<int, int>> approaching(const Motion& prefix, const Number& t) const {
    const Number later = t + pow(Number(10), -150);
    const Number tiny = pow(Number(10), -60);
    for (int i = container_id; i < disks(); ++i) {
      for (int j = i + 1; j < disks(); ++j) {
        const auto pj = prefix.position(j, t), vj = prefix.velocity(j, later);
        typename Motion::Vector pi{oracle::rounded<Number>(scene_.cx),
                                   oracle::rounded<Number>(scene_.cy)};
        typename Motion::Vector vi{Number(0), Number(0)};
        Number reach = oracle::rounded<Number>(scene_.container_radius) - radius(j);
        if (i != container_id) {
          pi = prefix.position(i, t);
          vi = prefix.velocity(i, later);
          reach = radius(i) + radius(j);
        }
        const Number dx = pj[0] - pi[0], dy = pj[1] - pi[1];
        if (abs(dx * dx + dy * dy - reach * reach) > tiny * (1 + reach * reach)) continue;
        const Number closing = dx * (vj[0] - vi[0]) + dy * (vj[1] - vi[1]);
        if (i == container_id ? closing > tiny : closing < -tiny) return std::pair(i, j);
      }
    }
    return std::nullopt;
  }
  Number radius(int i) const {
    return oracle::rounded<Number>(scene_.disks[static_cast<std::size_t>(i)].radius);
  }

  // At every instant with several events: collisions of the smallest approaching pair, then
  // maneuvers by disk, then collisions, then flips.
  void check_motion_order() const {
    std::size_t record = 0;
    for (std::size_t first = 0; first < run_.events.size();) {
      std::size_t last = first;
      while (last < run_.events.size() && run_.events[last].t == run_.events[first].t) ++last;
      if (last - first > 1) {
        check_motion_order(first, last, record);
        ++counts_.ties;
      }
      for (; first < last; ++first) record += is_motion(run_.events[first]);
    }
  }

  void check_motion_order(std::size_t first, std::size_t last, std::size_t record) const {
    const auto prefix = [&](std::size_t k) { return Motion(motion_scene_, first_records(k)); };
    // One recorded time may stand for two instants, if rarely: then this is not for us.
    for (std::size_t k = first, r = record; k < last; ++k) {
      if (!is_motion(run_.events[k])) continue;
      if (abs(motion_.times()[r] - motion_.times()[record]) > pow(Number(10), -60)) return;
      ++r;
    }
    int stage = 0;  // 0 collisions, 1 maneuvers, 2 collisions again, 3 flips
    int maneuvered = -1;
    for (std::size_t k = first; k < last; ++k) {
      const Event& e = run_.events[k];
      if (e.kind == Event::Kind::flip) {
        if (stage < 3 && record > 0 && k > first) {
          const auto pair = approaching(prefix(record), motion_.times()[record - 1]);
          if (pair) throw Fault("before flips nothing may approach: " + text(e));
        }
        stage = 3;
        continue;
      }
      if (stage == 3) throw Fault("after a flip at the same instant: " + text(e));
      const Number& t = motion_.times()[record];
      const auto pair = approaching(prefix(record), t);
      if (e.kind == Event::Kind::collision) {
        if (!pair) throw Fault("does not approach: " + text(e));
        if (*pair != std::pair(e.i, e.j)) {
          throw Fault(text(e) + ", but the pair " + std::to_string(pair->first) + " " +
                      std::to_string(pair->second) + " comes first");
        }
        if (stage == 1) stage = 2;
      } else {
        if (stage == 0 && pair) throw Fault("before collisions of the same instant: " + text(e));
        if (stage == 2) throw Fault("after the collisions that follow maneuvers: " + text(e));
        if (stage == 1 && maneuvered >= e.i) throw Fault("maneuvers not in order: " + text(e));
        stage = 1;
        maneuvered = e.i;
      }
      ++record;
    }
  }

  const Scene& scene_;
  const RecordedRun& run_;
  CheckCounts& counts_;
  const oracle::MotionScene& motion_scene_;
  const std::vector<oracle::MotionRecord>& records_;
  const Motion& motion_;
  Number horizon_;
};

}  // namespace voroproof::internal::testing
