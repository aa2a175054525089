// A plan: when each vehicle is where on its straight way.
#pragma once

#include <vector>

#include "history/plan_file.h"
#include "history/scene.h"

namespace voroproof::internal {

// Times and progress lie on a grid, so that plans stay exact and their numbers short: the whole
// flight has time_steps steps, the whole way whole_way parts.
inline constexpr int time_steps = 1 << 12;
inline constexpr int whole_way = 1 << 16;

struct Knot {
  int step;      // in [0, time_steps]
  int progress;  // in [0, whole_way]
  bool operator==(const Knot&) const = default;
};

// Progress as a piecewise linear function of time: from {0, 0} to {time_steps, whole_way}, steps
// increase, progress never decreases, and the speed changes at every knot between the ends.
using Timetable = std::vector<Knot>;

// One speed all the way.
Timetable even_timetable();

// The knot that ends the piece in which the step lies.
template <class Step>
Timetable::const_iterator piece_end(const Timetable& timetable, const Step& step) {
  auto end = timetable.begin() + 1;
  while (end + 1 != timetable.end() && end->step < step) ++end;
  return end;
}

// The progress after so many steps, in parts of the way; Number and Step as the caller chooses.
template <class Number, class Step>
Number progress_at(const Timetable& timetable, const Step& step) {
  const auto end = piece_end(timetable, step);
  const Knot &a = *(end - 1), &b = *end;
  return Number(a.progress) +
         Number(b.progress - a.progress) * Number(step - a.step) / Number(b.step - a.step);
}

// Drops the knots where the speed does not change.
void drop_idle_knots(Timetable& timetable);

struct Plan {
  PlanTask task;
  std::vector<Timetable> timetables;  // one for each vehicle
};

Rational time_of(const PlanTask& task, const Rational& step);

// Where the vehicle is after so many parts of its way.
Point2 place(const Vehicle& vehicle, const Rational& progress);

// Where vehicle i is at the time t, from 0 to the time of arrival.
Point2 place_at(const Plan& plan, int i, const Rational& t);

// Everybody flies at one speed.
Plan even_plan(PlanTask task);

// The plan as a scene: the vehicles are its disks, every change of speed a maneuver, and at the
// horizon, the time of arrival, all stop exactly at their goals. Points have mass 1.
Scene scene_of(const Plan& plan);

// The changes of speed on the way, without departure and arrival.
std::size_t speed_changes(const Plan& plan);

}  // namespace voroproof::internal
