// Timetables and gaps: exact values against sampling, exhaustive search and many digits.
#include "library/planning/clearance.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/mpfr.hpp>

#include "tests/planning/flight.h"
#include "tests/support/dice.h"

namespace voroproof::internal {
namespace {

using testing::Dice;
using testing::Flight;
using Digits = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100>>;

Digits digits(const Rational& q) { return Digits(q.get_num_mpz_t()) / Digits(q.get_den_mpz_t()); }
Digits gap_of(const Approach& a) { return sqrt(digits(a.distance2)) - digits(a.reach); }

Timetable random_timetable(Dice& dice) {
  Timetable timetable{{0, 0}};
  for (int k = dice(0, 3); k > 0; --k) {
    const Knot last = timetable.back();
    timetable.push_back({dice(last.step + 1, last.step + 900), dice(last.progress, whole_way)});
  }
  timetable.push_back({time_steps, whole_way});
  drop_idle_knots(timetable);
  return timetable;
}

// Small integers, so that equal gaps occur.
Plan random_plan(Dice& dice, int n) {
  PlanTask task;
  task.container_radius = 1000;
  task.arrive = 10;
  const auto place = [&]() -> Point2 { return {dice(-9, 9), dice(-9, 9)}; };
  for (int i = 0; i < n; ++i) {
    const Point2 start = place();
    task.vehicles.push_back({Rational(dice(0, 3)), start, dice(0, 4) == 0 ? start : place()});
  }
  Plan plan = even_plan(task);
  for (Timetable& timetable : plan.timetables)
    if (dice(0, 2) > 0) timetable = random_timetable(dice);
  return plan;
}

TEST(Timetables, AreInterpolated) {
  const Timetable timetable{{0, 0}, {1024, 4096}, {2048, 4096}, {time_steps, whole_way}};
  EXPECT_EQ(progress_at<Rational>(timetable, 0), 0);
  EXPECT_EQ(progress_at<Rational>(timetable, 512), 2048);
  EXPECT_EQ(progress_at<Rational>(timetable, 1500), 4096);
  EXPECT_EQ(progress_at<Rational>(timetable, Rational(2049)), 4096 + 30);
  EXPECT_EQ(progress_at<double>(timetable, time_steps), whole_way);
}

TEST(Timetables, LoseKnotsWhereNoSpeedChanges) {
  Timetable timetable{{0, 0}, {1024, 16384}, {2048, 32768}, {2049, 32768}, {time_steps, whole_way}};
  drop_idle_knots(timetable);
  EXPECT_EQ(timetable, (Timetable{{0, 0}, {2048, 32768}, {2049, 32768}, {time_steps, whole_way}}));
}

TEST(Scenes, OfPlansArriveAndStop) {
  Dice dice(5);
  for (int round = 0; round < 50; ++round) {
    const Plan plan = random_plan(dice, 5);
    const Scene scene = scene_of(plan);
    const Flight flight(scene);
    for (int i = 0; i < 5; ++i) {
      const Point2 end = flight.place(i, plan.task.arrive), v = flight.last_velocity(i);
      EXPECT_EQ(end.x, plan.task.vehicles[i].goal.x);
      EXPECT_EQ(end.y, plan.task.vehicles[i].goal.y);
      EXPECT_TRUE(v.x == 0 && v.y == 0);
      for (const Knot& knot : plan.timetables[i]) {
        const Point2 on_way = place(plan.task.vehicles[i], knot.progress),
                     there = flight.place(i, time_of(plan.task, knot.step));
        EXPECT_TRUE(on_way.x == there.x && on_way.y == there.y);
      }
    }
  }
}

TEST(Approaches, AreThoseOfTheScene) {
  Dice dice(7);
  for (int round = 0; round < 200; ++round) {
    const Plan plan = random_plan(dice, 2);
    const Scene scene = scene_of(plan);
    const Flight flight(scene);
    const Approach approach = nearest_approach(plan, 1, 0);
    EXPECT_EQ(approach.i, 0);
    EXPECT_EQ(approach.j, 1);
    EXPECT_EQ(approach.distance2, flight.least_distance2(0, 1));
    EXPECT_EQ(approach.reach, plan.task.vehicles[0].radius + plan.task.vehicles[1].radius);
    // At its time they are that near, and nearer before they never were.
    const Point2 p = flight.place(0, approach.t), q = flight.place(1, approach.t);
    EXPECT_EQ((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y), approach.distance2);
    if (approach.t > 0) {
      EXPECT_GT(flight.least_distance2(0, 1, 0, approach.t * 1023 / 1024), approach.distance2);
    }
  }
}

TEST(Approaches, AreComparedAndEnclosedExactly) {
  Dice dice(9);
  const auto random = [&]() -> Approach {
    Rational square(dice(0, 40), dice(1, 4));
    square.canonicalize();
    // Often the square of a rational.
    if (dice(0, 1) == 0) square *= square;
    return {0, 1, 0, square, Rational(dice(0, 12))};
  };
  int equal = 0;
  for (int round = 0; round < 20000; ++round) {
    const Approach a = random(), b = random();
    const Digits difference = gap_of(a) - gap_of(b);
    const int expected = abs(difference) < Digits("1e-80") ? 0 : difference > 0 ? 1 : -1;
    const auto order = compare_gaps(a, b);
    EXPECT_EQ(order > 0   ? 1
              : order < 0 ? -1
                          : 0,
              expected)
        << a.distance2 << ' ' << a.reach << ' ' << b.distance2 << ' ' << b.reach;
    equal += expected == 0 && a.reach != b.reach;
    const Enclosure enclosed = gap(a);
    EXPECT_LE(Digits(enclosed.lo) - Digits("1e-80"), gap_of(a));
    EXPECT_GE(Digits(enclosed.hi) + Digits("1e-80"), gap_of(a));
    EXPECT_LE(enclosed.hi - enclosed.lo, 4e-15);
  }
  EXPECT_GT(equal, 40);  // the case that only exact comparison gets right
}

TEST(Approaches, KeepClear) {
  const auto at = [](int distance2) { return Approach{0, 1, 0, distance2, 2}; };
  EXPECT_FALSE(keeps_clear(at(4), 0));  // touching is not clear
  EXPECT_TRUE(keeps_clear(at(5), 0));
  EXPECT_TRUE(keeps_clear(at(9), 1));
  EXPECT_FALSE(keeps_clear(at(8), 1));
}

TEST(MinimumGap, IsTheLeastOfAll) {
  Dice dice(11);
  for (int round = 0; round < 100; ++round) {
    const Plan plan = random_plan(dice, dice(2, 12));
    const int n = static_cast<int>(plan.task.vehicles.size());
    std::optional<Approach> least;
    for (int i = 0; i < n; ++i) {
      for (int j = i + 1; j < n; ++j) {
        const Approach approach = nearest_approach(plan, i, j);
        const Digits difference = least ? gap_of(approach) - gap_of(*least) : Digits(-1);
        const bool tie = abs(difference) < Digits("1e-80");
        if ((!tie && difference < 0) || (tie && approach.t < least->t)) least = approach;
      }
    }
    const auto found = minimum_gap(plan);
    ASSERT_TRUE(found);
    EXPECT_EQ(std::pair(found->i, found->j), std::pair(least->i, least->j));
    EXPECT_EQ(found->t, least->t);
    EXPECT_EQ(found->distance2, least->distance2);
  }
  EXPECT_FALSE(minimum_gap(even_plan({})));
}

}  // namespace
}  // namespace voroproof::internal
