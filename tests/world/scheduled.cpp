#include "tests/world/scheduled.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <variant>

#include "tests/world/edge_set.h"
#include "tests/world/world_oracle.h"

namespace voroproof::internal::testing {

namespace {

enum class Doing { goes, comes, turns };
// By a time as it is rounded. A jump of a disk that is there before and after goes and comes.
using Appointment = std::tuple<double, GenId, Doing>;

std::vector<Appointment> wanted(const World& world) {
  std::vector<Appointment> all;
  const auto add = [&](const Rational& t, GenId g, Doing doing) {
    if (t <= world.horizon) all.emplace_back(round_nearest(t), g, doing);
  };
  for (GenId g = 0; g < static_cast<GenId>(world.disks.size()); ++g) {
    const WorldDisk& disk = world.disks[g];
    if (disk.enter > 0) add(disk.enter, g, Doing::comes);
    if (disk.leave) add(*disk.leave, g, Doing::goes);
  }
  for (const WorldManeuver& m : world.maneuvers) {
    if (!m.is_jump()) {
      add(m.t, m.disk, Doing::turns);
      continue;
    }
    add(m.t, m.disk, Doing::goes);
    add(m.t, m.disk, Doing::comes);
  }
  return all;
}

std::vector<Appointment> told(const std::vector<WorldEvent>& events) {
  std::vector<Appointment> all;
  for (const WorldEvent& event : events) {
    const double t = round_nearest(event.t);
    if (const auto* turn = std::get_if<PathTurn>(&event.what)) {
      all.emplace_back(t, turn->g, Doing::turns);
    }
    const auto* jump = std::get_if<Jump>(&event.what);
    // At 0 the first diagram is that after it.
    const bool both = event.t == 0;
    if (jump != nullptr && (both || jump->out)) all.emplace_back(t, jump->g, Doing::goes);
    if (jump != nullptr && (both || jump->in)) all.emplace_back(t, jump->g, Doing::comes);
  }
  return all;
}

bool is_value(const std::optional<Rational>& told, const Rational& wanted) {
  return !told || round_nearest(*told) == round_nearest(wanted);
}
bool is_value(const std::optional<Point2>& told, const Rational& x, const Rational& y) {
  return !told || (is_value(told->x, x) && is_value(told->y, y));
}

// Whether what the event tells about its disk is so; `t` is exactly when it happens.
bool tells_right(const World& world, const WorldEvent& event) {
  const auto* turn = std::get_if<PathTurn>(&event.what);
  const auto* jump = std::get_if<Jump>(&event.what);
  if (turn == nullptr && (jump == nullptr || (!jump->in && event.t > 0))) return true;
  const GenId g = turn != nullptr ? turn->g : jump->g;
  const auto now = [&](const Rational& t) { return round_nearest(t) == round_nearest(event.t); };
  Rational t = event.t;
  if (now(world.disks[g].enter)) t = world.disks[g].enter;
  for (const WorldManeuver& m : world.maneuvers) {
    if (m.disk == g && now(m.t)) t = m.t;
  }
  const GrowingDisk s = state_at(world, g, t);
  if (turn != nullptr) {
    return is_value(turn->velocity, s.vx, s.vy) && is_value(turn->center, s.x, s.y) &&
           is_value(turn->growth, s.growth);
  }
  return is_value(jump->velocity, s.vx, s.vy) && is_value(jump->center, s.x, s.y) &&
         is_value(jump->radius, s.radius);
}

}  // namespace

std::optional<std::string> unscheduled(const World& world, const std::vector<WorldEvent>& events,
                                       const std::optional<Rational>& until) {
  std::vector<Appointment> a = wanted(world), b = told(events);
  for (auto* all : {&a, &b}) {
    if (until) {
      const double end = round_nearest(*until);
      std::erase_if(*all, [&](const Appointment& x) { return std::get<0>(x) >= end; });
    }
    std::sort(all->begin(), all->end());
  }
  if (a != b) {
    const auto [x, y] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    const auto name = [](const Appointment& p) {
      static const char* const doings[] = {" goes", " comes", " turns"};
      return std::to_string(std::get<1>(p)) + doings[static_cast<int>(std::get<2>(p))] + " at " +
             std::to_string(std::get<0>(p));
    };
    return "scheduled: " + (x == a.end() ? "nothing" : name(*x)) +
           ", told: " + (y == b.end() ? "nothing" : name(*y));
  }
  for (const WorldEvent& event : events) {
    if (!tells_right(world, event)) return "wrong values: " + text(event);
  }
  return std::nullopt;
}

}  // namespace voroproof::internal::testing
