#include "tests/world/world_oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <variant>

#include "engine/resting_diagram.h"
#include "filtered/motion/options.h"
#include "filtered/numbers/stats.h"
#include "filtered/search/hidden_disks.h"
#include "tests/world/edge_set.h"
#include "tests/world/scheduled.h"

namespace voroproof::internal::testing {

namespace {

GrowingDisk moved(GrowingDisk d, const Rational& passed) {
  d.x += d.vx * passed;
  d.y += d.vy * passed;
  d.radius += d.growth * passed;
  return d;
}

}  // namespace

// ---- The world at one time. ----

bool is_present(const World& world, GenId g, const Rational& t) {
  const WorldDisk& disk = world.disks[g];
  return disk.enter <= t && (!disk.leave || t < *disk.leave);
}

GrowingDisk state_at(const World& world, GenId g, const Rational& t) {
  GrowingDisk state = world.disks[g].state;
  Rational from = world.disks[g].enter;
  for (const WorldManeuver& m : world.maneuvers) {
    if (m.disk != g || m.t > t) continue;
    state = moved(state, m.t - from);
    from = m.t;
    if (m.center) state.x = m.center->x, state.y = m.center->y;
    if (m.velocity) state.vx = m.velocity->x, state.vy = m.velocity->y;
    if (m.radius) state.radius = *m.radius;
    if (m.growth) state.growth = *m.growth;
  }
  return moved(state, t - from);
}

BruteDiagram brute_diagram(const World& world, const Rational& t) {
  MotionInput input;
  std::vector<GenId> names;
  std::vector<GrowingDisk> states;
  Rational least = 0;
  for (GenId g = 0; g < static_cast<GenId>(world.disks.size()); ++g) {
    if (!is_present(world, g, t)) continue;
    names.push_back(g);
    states.push_back(state_at(world, g, t));
    least = std::min(least, states.back().radius);
  }
  // No radius may be negative here: all are larger by one number, and the frame is smaller.
  for (const GrowingDisk& d : states) {
    input.disks.push_back({d.x, d.y, Rational(d.radius - least), 0, 0, 1});
  }
  input.container_radius = 1;
  if (world.circle) {
    input.container_x = world.circle->center.x;
    input.container_y = world.circle->center.y;
    input.container_radius = world.circle->radius + world.circle->growth * t + least;
  }
  TierCounts counts;
  const RestingDiagram resting =
      resting_diagram(std::move(input), world.circle ? Frame::circle : Frame::plane, {}, counts);
  const auto name = [&](GenId g) { return g < 0 ? g : names[g]; };
  BruteDiagram out;
  for (const Quad& q : resting.edges) {
    out.edges.push_back({name(q.l), name(q.r), name(q.s), name(q.e)});
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (resting.host[k] == visible_disk) {
      out.visible.insert(names[k]);
    } else {
      out.host[names[k]] = name(resting.host[k]);
    }
  }
  return out;
}

Rational odd_time_between(const Rational& from, const Rational& to, std::uint64_t numerator) {
  return from + (to - from) * Rational(Integer(numerator), Integer(way));
}

// ---- Its history. ----

TimeRange rounding_range(const Rational& t) {
  const double near = round_nearest(t);
  if (t == 0 || to_rational(near) != t) return {t, t};
  const double infinity = std::numeric_limits<double>::infinity();
  return {rounding_breakpoint(std::nextafter(near, -infinity), near),
          rounding_breakpoint(near, std::nextafter(near, infinity))};
}

namespace {

std::string text(const std::vector<Quad>& edges) {
  std::string all;
  for (const Quad& q : edges) all += testing::text(q);
  return all;
}
std::string text(const std::set<GenId>& ids) {
  std::string all;
  for (const GenId g : ids) all += " " + std::to_string(g);
  return all;
}
template <class Item>
std::vector<Item> without(const std::vector<Item>& all, const std::vector<Item>& others) {
  std::vector<Item> rest;
  std::set_difference(all.begin(), all.end(), others.begin(), others.end(),
                      std::back_inserter(rest));
  return rest;
}

// The disk that is visible just after 0 without an edge.
std::set<GenId> lone_at_start(const World& world) {
  const std::set<GenId> visible =
      brute_diagram(world, odd_time_between(0, Rational(1, way), 1)).visible;
  return visible.size() < 2 ? visible : std::set<GenId>{};
}

// Events of ranges that meet: [begin, end).
struct EventGroup {
  TimeRange when;
  std::size_t begin, end;
};

class Judge {
 public:
  Judge(const World& world, const std::vector<Quad>& initial, const std::vector<WorldEvent>& events,
        const JudgeOptions& options)
      : world_(world),
        events_(events),
        options_(options),
        random_(options.seed),
        state_(initial, lone_at_start(world)) {}

  std::optional<std::string> verdict() {
    if (!has_order()) return *wrong_;
    group();
    draw_times();
    bool ok = true;
    Rational from = 0;
    if (groups_.empty() || groups_.front().when.low > 0) {
      ok = agrees_between(from, groups_.empty() ? end() : groups_.front().when.low);
    }
    for (std::size_t k = 0; ok && k < groups_.size(); ++k) {
      ok = replay(groups_[k]) &&
           agrees_between(groups_[k].when.high,
                          k + 1 < groups_.size() ? groups_[k + 1].when.low : end());
    }
    if (ok && !options_.until) agrees_at(just_after_horizon());
    return wrong_;
  }

 private:
  Rational end() const { return options_.until ? *options_.until : world_.horizon; }
  Rational just_after_horizon() const {
    const Rational& h = world_.horizon;
    return odd_time_between(h, h + (h > 0 ? h : Rational(1)), 1);
  }
  bool fail(const std::string& why) {
    wrong_ = why;
    return false;
  }

  bool has_order() {
    Rational last = 0;
    for (const WorldEvent& e : events_) {
      if (e.t < last) return fail("a time falls at " + testing::text(e));
      if (rounding_range(e.t).low > world_.horizon) return fail("late: " + testing::text(e));
      last = e.t;
    }
    for (std::size_t k = 1; k < events_.size(); ++k) {
      const WorldEvent &a = events_[k - 1], &b = events_[k];
      if (a.t == b.t && rank(a) > rank(b)) return fail("not in order: " + testing::text(b));
    }
    return true;
  }
  // At one instant some leave first, then others enter or jump, then turn, each by id; then comes
  // all else. (Two instants are hardly ever rounded to one time.)
  static std::pair<int, GenId> rank(const WorldEvent& event) {
    if (const auto* turn = std::get_if<PathTurn>(&event.what)) return {2, turn->g};
    const auto* jump = std::get_if<Jump>(&event.what);
    if (jump == nullptr) return {3, 0};
    return {jump->in || event.t == 0, jump->g};
  }

  void group() {
    for (std::size_t k = 0; k < events_.size(); ++k) {
      TimeRange when = rounding_range(events_[k].t);
      when.low = std::max(when.low, Rational(0));
      when.high = std::min(when.high, world_.horizon);
      const bool meets = !groups_.empty() && groups_.back().when.high >= when.low;
      if (!meets) groups_.push_back({when, k, k});
      groups_.back().when.high = when.high;
      groups_.back().end = k + 1;
    }
  }

  // In falling order.
  void draw_times() {
    for (int k = 0; k < options_.random_times; ++k) {
      const std::uint64_t share = random_() % way;
      times_.push_back(odd_time_between(0, end(), share));
    }
    std::sort(times_.begin(), times_.end(), std::greater<>());
  }

  // Whether this is the diagram at places of the open interval: near its ends, in the middle, and
  // at the random times in it.
  bool agrees_between(const Rational& from, const Rational& to) {
    while (!times_.empty() && times_.back() <= from) times_.pop_back();
    std::vector<Rational> times;
    if (from < to) {
      for (const std::uint64_t share : {std::uint64_t{1}, way / 2, way - 1}) {
        times.push_back(odd_time_between(from, to, share));
      }
    }
    for (; !times_.empty() && times_.back() < to; times_.pop_back()) times.push_back(times_.back());
    return std::all_of(times.begin(), times.end(), [this](const auto& t) { return agrees_at(t); });
  }

  bool agrees_at(const Rational& t) {
    const BruteDiagram brute = brute_diagram(world_, t);
    const std::vector<Quad> edges = state_.edges();
    if (edges == brute.edges && state_.visible() == brute.visible) return true;
    return fail("at " + std::to_string(round_nearest(t)) + ": visible" + text(state_.visible()) +
                ", brute force" + text(brute.visible) + "; edges too many " +
                text(without(edges, brute.edges)) + ", missing " +
                text(without(brute.edges, edges)) + last_);
  }

  bool replay(const EventGroup& group) {
    const EdgeSet before = state_;
    bool only_steps = true;
    last_ = "; the events before it:";
    for (std::size_t k = group.begin; k < group.end; ++k) {
      const WorldEvent& event = events_[k];
      last_ += " " + testing::text(event);
      if (!has_its_name(event) || !is_when_it_says(event)) return false;
      const bool idle = std::holds_alternative<PathTurn>(event.what) ||
                        std::holds_alternative<Jump>(event.what) ||
                        std::holds_alternative<Swap>(event.what);
      only_steps = only_steps && !idle;
      state_.apply(event);
    }
    if (only_steps && state_ == before) return fail("nothing has changed" + last_);
    return true;
  }

  bool has_its_name(const WorldEvent& event) {
    const auto* q = std::get_if<Quad>(&event.what);
    return q == nullptr || canonical(*q) == *q || fail("no canonical name" + last_);
  }

  // The tangency of a hide or an appear falls or rises through 0 in the range of its time. Where a
  // path changes in the range, nothing is said.
  bool is_when_it_says(const WorldEvent& event) {
    const auto* h = std::get_if<Hide>(&event.what);
    const auto* a = std::get_if<Appear>(&event.what);
    if (h == nullptr && a == nullptr) return true;
    const GenId g = h != nullptr ? h->g : a->g, j = h != nullptr ? h->j : a->j;
    if (j == container_id && !world_.circle) return fail("nothing hides there" + last_);
    const TimeRange when = rounding_range(event.t);
    for (const GenId k : {g, j}) {
      if (k >= 0 && changes_in(k, when)) return true;
    }
    const int low = sgn(tangency(g, j, when.low)), high = sgn(tangency(g, j, when.high));
    const bool right = h != nullptr ? low >= 0 && high <= 0 : low <= 0 && high >= 0;
    if (right || (a != nullptr && touches_in(g, j, when))) return true;
    return fail("not tangent then" + last_);
  }

  // A disk may come out beside one that touches it from inside, or is one with it, just then.
  bool touches_in(GenId g, GenId j, const TimeRange& when) const {
    const Rational f = tangency(g, j, when.low), h = tangency(g, j, when.high),
                   middle = tangency(g, j, (when.low + when.high) / 2);
    const Rational a = 2 * (f - 2 * middle + h), b = 4 * middle - 3 * f - h;
    return sgn(a) > 0 && b * b == 4 * a * f && b <= 0 && -b <= 2 * a;
  }

  bool changes_in(GenId g, const TimeRange& when) const {
    const auto in = [&](const Rational& t) { return when.low <= t && t <= when.high; };
    const WorldDisk& disk = world_.disks[g];
    if (in(disk.enter) || (disk.leave && in(*disk.leave))) return true;
    return std::any_of(world_.maneuvers.begin(), world_.maneuvers.end(),
                       [&](const WorldManeuver& m) { return m.disk == g && in(m.t); });
  }

  // Positive where neither hides the other.
  Rational tangency(GenId g, GenId j, const Rational& t) const {
    const GrowingDisk a = state_at(world_, g, t);
    if (j == container_id) {
      const WorldCircle& c = *world_.circle;
      const Rational x = a.x - c.center.x, y = a.y - c.center.y,
                     s = c.radius + c.growth * t + a.radius;
      return s * s - x * x - y * y;
    }
    const GrowingDisk b = state_at(world_, j, t);
    const Rational x = a.x - b.x, y = a.y - b.y, s = a.radius - b.radius;
    return x * x + y * y - s * s;
  }

  const World& world_;
  const std::vector<WorldEvent>& events_;
  const JudgeOptions& options_;
  std::mt19937_64 random_;
  EdgeSet state_;
  std::vector<EventGroup> groups_;
  std::vector<Rational> times_;
  std::string last_;
  std::optional<std::string> wrong_;
};

}  // namespace

std::optional<std::string> first_disagreement(const World& world, const std::vector<Quad>& initial,
                                              const std::vector<WorldEvent>& events,
                                              const JudgeOptions& options) {
  try {
    Judge judge(world, initial, events, options);
    if (auto wrong = judge.verdict()) return wrong;
  } catch (const ImpossibleEvent& why) {
    return why.what();
  }
  return unscheduled(world, events, options.until);
}

}  // namespace voroproof::internal::testing
