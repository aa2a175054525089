#include "library/planning/planner.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "library/planning/conjunctions.h"
#include "library/planning/rescheduling.h"
#include "library/planning/slowing.h"

namespace voroproof::internal {
namespace {

using Pair = std::pair<int, int>;

Pair ordered(int i, int j) { return {std::min(i, j), std::max(i, j)}; }

// The first pair, by time and ids, that is too near at the start or at the goals.
std::optional<Approach> too_near_at_ends(const PlanTask& task) {
  const int n = static_cast<int>(task.vehicles.size());
  for (const bool at_goal : {false, true}) {
    for (int i = 0; i < n; ++i) {
      for (int j = i + 1; j < n; ++j) {
        const Vehicle &a = task.vehicles[i], &b = task.vehicles[j];
        const Point2 &p = at_goal ? a.goal : a.start, &q = at_goal ? b.goal : b.start;
        const Rational x = q.x - p.x, y = q.y - p.y;
        const Approach approach{i, j, at_goal ? task.arrive : Rational(0), Rational(x * x + y * y),
                                Rational(a.radius + b.radius)};
        if (!keeps_clear(approach, task.clearance)) return approach;
      }
    }
  }
  return std::nullopt;
}

class Planner {
 public:
  explicit Planner(PlanTask task) : plan_(even_plan(std::move(task))), conjunctions_(plan_.task) {
    for (int i = 0; i < static_cast<int>(plan_.timetables.size()); ++i) predict(i, i);
  }

  // Whether no conjunction is left.
  bool run(const std::function<bool(std::size_t)>& monitor) {
    // Conjunctions that resisted are tried again after others were avoided.
    for (std::set<Pair> resisting; !steps_.empty();) {
      if (monitor && !monitor(steps_.size())) return false;
      const auto next = std::find_if(by_step_.begin(), by_step_.end(), [&](const auto& entry) {
        return !resisting.contains(entry.second);
      });
      if (next == by_step_.end()) return false;
      const auto [step, pair] = *next;
      if (avoid(pair, step))
        resisting.clear();
      else
        resisting.insert(pair);
    }
    return true;
  }

  Pair first_conjunction() const { return by_step_.begin()->second; }
  Plan& plan() { return plan_; }
  std::vector<Avoidance>& avoided() { return avoided_; }

 private:
  // Predicts the conjunctions of vehicle i with its neighbours below `end`.
  void predict(int i, int end = std::numeric_limits<int>::max()) {
    for (const int j : conjunctions_.neighbors(i)) {
      if (j >= end) continue;
      const Pair pair = ordered(i, j);
      if (const auto old = steps_.find(pair); old != steps_.end()) {
        by_step_.erase({old->second, pair});
        steps_.erase(old);
      }
      if (const auto step = conjunctions_.first(i, plan_.timetables[i], j, plan_.timetables[j])) {
        steps_[pair] = *step;
        by_step_.insert({*step, pair});
      }
    }
  }

  int count(int i) const {
    return static_cast<int>(std::count_if(conjunctions_.neighbors(i).begin(),
                                          conjunctions_.neighbors(i).end(),
                                          [&](int j) { return steps_.contains(ordered(i, j)); }));
  }

  bool avoid(const Pair& pair, double step) {
    return slow_down(pair, step) || reschedule(pair) || reschedule_both(pair);
  }

  // The change that leaves the fewest conjunctions; of equals the gentlest.
  bool slow_down(const Pair& pair, double step) {
    const int before[] = {count(pair.first), count(pair.second)};
    int best_change = 0, best_vehicle = -1;
    double best_speed = 0;
    Timetable best;
    for (const int which : {0, 1}) {
      const int i = which == 0 ? pair.first : pair.second;
      for (Timetable& timetable : slowings(plan_.timetables[i], step)) {
        const double speed = top_speed(timetable);
        const int enough = before[which] + best_change + (speed < best_speed ? 1 : 0);
        const int change =
            conjunctions_.count(i, timetable, plan_.timetables, enough) - before[which];
        if (change >= 0 || change > best_change || (change == best_change && speed >= best_speed))
          continue;
        best_change = change;
        best_speed = speed;
        best_vehicle = i;
        best = std::move(timetable);
      }
    }
    if (best_vehicle < 0) return false;
    accept(pair, best_vehicle, std::move(best), true);
    return true;
  }

  bool reschedule(const Pair& pair) {
    for (const int i : {pair.first, pair.second}) {
      if (auto timetable = rescheduled(i, plan_.timetables, conjunctions_)) {
        accept(pair, i, std::move(*timetable), false);
        return true;
      }
    }
    return false;
  }

  // One gets a timetable as if the other were not there, then the other one around that.
  bool reschedule_both(const Pair& pair) {
    for (const auto& [i, j] : {pair, Pair(pair.second, pair.first)}) {
      for (const Haste haste : all_hastes) {
        auto of_i = rescheduled(i, plan_.timetables, conjunctions_, haste, j);
        if (!of_i) break;
        std::swap(plan_.timetables[i], *of_i);
        auto of_j = rescheduled(j, plan_.timetables, conjunctions_);
        std::swap(plan_.timetables[i], *of_i);
        if (!of_j) continue;
        accept(pair, i, std::move(*of_i), false);
        accept(pair, j, std::move(*of_j), false);
        return true;
      }
    }
    return false;
  }

  void accept(const Pair& pair, int vehicle, Timetable timetable, bool slowed) {
    const Approach predicted = nearest_approach(plan_, pair.first, pair.second);
    const Point2 a = place_at(plan_, pair.first, predicted.t);
    const Point2 b = place_at(plan_, pair.second, predicted.t);
    const Point2 middle{Rational((a.x + b.x) / 2), Rational((a.y + b.y) / 2)};
    avoided_.push_back({predicted, middle, vehicle, slowed});
    plan_.timetables[vehicle] = std::move(timetable);
    predict(vehicle);
  }

  Plan plan_;
  Conjunctions conjunctions_;
  std::map<Pair, double> steps_;  // by predicted conjunction
  std::set<std::pair<double, Pair>> by_step_;
  std::vector<Avoidance> avoided_;
};

}  // namespace

PlanResult make_plan(PlanTask task, const std::function<bool(std::size_t)>& monitor) {
  PlanResult result;
  if (auto pair = too_near_at_ends(task)) {
    result.plan = even_plan(std::move(task));
    result.impossible = std::move(pair);
    return result;
  }
  Planner planner(std::move(task));
  if (!planner.run(monitor)) {
    const Pair pair = planner.first_conjunction();
    result.unsolved = nearest_approach(planner.plan(), pair.first, pair.second);
  }
  result.plan = std::move(planner.plan());
  result.avoided = std::move(planner.avoided());
  result.nearest = minimum_gap(result.plan);
  // The exact clearance decides: the search in doubles may have been wrong.
  if (result.found() && result.nearest && !keeps_clear(*result.nearest, result.plan.task.clearance))
    result.unsolved = result.nearest;
  return result;
}

}  // namespace voroproof::internal
