// Plans: that they keep clear by two independent ways, arrive, and fail where they must.
#include "library/planning/planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "corpus/plan_presets.h"
#include "exact/topology/diagram.h"
#include "library/planning/assignment.h"
#include "tests/planning/flight.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal {
namespace {

using testing::Flight;

PlanTask task_of(std::vector<Vehicle> vehicles, Rational clearance = Rational(1, 2)) {
  PlanTask task;
  task.container_radius = 100;
  task.arrive = 10;
  task.clearance = clearance;
  task.vehicles = std::move(vehicles);
  return task;
}

// The lives of adjacencies in the engine's history: for each pair of disks the times between which
// their cells share some edge, widened to binary64 neighbours of the rounded times.
template <class Life>
void for_each_adjacency(const testing::RecordedRun& run, int disks, Rational horizon, Life&& life) {
  std::map<std::pair<int, int>, std::pair<int, double>> open;  // edges, since
  const double infinity = std::numeric_limits<double>::infinity();
  const auto change = [&](GenId a, GenId b, int by, double t) {
    if (a < 0 || b < 0) return;
    const std::pair<int, int> pair = std::minmax(a, b);
    auto& [edges, since] = open[pair];
    if (edges == 0) since = t;
    edges += by;
    if (edges == 0) {
      const Rational from = since > 0 ? to_rational(std::nextafter(since, 0)) : Rational(0);
      life(pair.first, pair.second, from,
           std::min(horizon, to_rational(std::nextafter(t, infinity))));
    }
  };
  const Diagram initial = diagram_of(disks, run.initial);
  for (const Quad& q : initial.quads()) change(q.l, q.r, 1, 0);
  for (const testing::Event& event : run.events) {
    if (event.kind != testing::Event::Kind::flip) continue;
    change(event.edge.l, event.edge.r, -1, event.t);
    change(event.edge.s, event.edge.e, 1, event.t);
  }
  const double end = round_nearest(horizon);
  for (const auto& [pair, state] : std::map(open)) {
    for (int k = state.first; k > 0; --k) change(pair.first, pair.second, -1, end);
  }
}

void check_plan(const PlanResult& result) {
  const PlanTask& task = result.plan.task;
  const int n = static_cast<int>(task.vehicles.size());
  ASSERT_TRUE(result.found());
  const Scene scene = scene_of(result.plan);
  const Flight flight(scene);
  for (int i = 0; i < n; ++i) {
    const Point2 end = flight.place(i, task.arrive);
    EXPECT_EQ(end.x, task.vehicles[i].goal.x);
    EXPECT_EQ(end.y, task.vehicles[i].goal.y);
    EXPECT_TRUE(flight.last_velocity(i).x == 0 && flight.last_velocity(i).y == 0);
  }
  // The first way: all pairs, from the scene. (Equal radii: the least distance decides.)
  const testing::RecordedRun run = testing::run(scene);
  ASSERT_TRUE(run.complete());
  EXPECT_EQ(run.count(testing::Event::Kind::collision), 0u);
  if (n < 2) return;
  const Rational apart = result.nearest->reach + task.clearance;
  EXPECT_GE(result.nearest->distance2, apart * apart);
  if (n <= 60) {
    Rational least = -1;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < i; ++j) {
        const Rational d = flight.least_distance2(i, j);
        if (least < 0 || d < least) least = d;
      }
    }
    EXPECT_EQ(result.nearest->distance2, least);
  }
  // The second: the nearest pair has adjacent cells, so that the pairs of the history suffice.
  Rational least_adjacent = -1;
  for_each_adjacency(run, n, scene.horizon,
                     [&](int i, int j, const Rational& a, const Rational& b) {
                       const Rational d = flight.least_distance2(i, j, a, b);
                       if (least_adjacent < 0 || d < least_adjacent) least_adjacent = d;
                     });
  EXPECT_EQ(result.nearest->distance2, least_adjacent);
}

class Presets : public ::testing::TestWithParam<std::string> {};

TEST_P(Presets, KeepClearAndArrive) {
  const PlanResult result = make_plan(plan_preset(GetParam()));
  EXPECT_GT(result.avoided.size(), 0u);  // conjunctions are predicted with the goals as given
  EXPECT_GT(speed_changes(result.plan), 0u);
  check_plan(result);
}

TEST_P(Presets, NeedNoChangeOfSpeedWithTheNearestGoals) {
  PlanTask task = plan_preset(GetParam());
  assign_nearest_goals(task);
  const PlanResult result = make_plan(task);
  EXPECT_EQ(speed_changes(result.plan), 0u);
  check_plan(result);
}

INSTANTIATE_TEST_SUITE_P(Planner, Presets, ::testing::ValuesIn(plan_preset_names()),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(Planner, WorksForFewVehicles) {
  check_plan(make_plan(task_of({})));
  check_plan(make_plan(task_of({{1, {0, 0}, {5, 5}}})));
  check_plan(make_plan(task_of({{1, {0, 0}, {5, 5}}, {1, {10, 0}, {10, 0}}})));
  check_plan(make_plan(task_of({{0, {0, 0}, {5, 5}}, {0, {5, 0}, {0, 5}}}, 0)));
}

// The paths cross in the middle: one waits.
TEST(Planner, OneOfTwoGivesWay) {
  const PlanResult result = make_plan(task_of({{1, {-10, 0}, {10, 0}}, {1, {0, -10}, {0, 10}}}));
  ASSERT_EQ(result.avoided.size(), 1u);
  EXPECT_EQ(result.avoided[0].predicted.t, 5);
  EXPECT_EQ(result.avoided[0].predicted.distance2, 0);
  EXPECT_TRUE(result.avoided[0].slowed);
  EXPECT_EQ(speed_changes(result.plan), 2u);
  check_plan(result);
}

// The unit of length does not matter, up to the limits of scenes.
TEST(Planner, AnyUnit) {
  const auto timetables = [](int exponent) {
    const Rational unit =
        exponent < 0 ? Rational(1) / (Integer(1) << -exponent) : Rational(Integer(1) << exponent);
    PlanTask task = plan_preset("square-to-circle");
    for (Rational* x : {&task.container_center.x, &task.container_center.y, &task.container_radius,
                        &task.clearance})
      *x *= unit;
    for (Vehicle& v : task.vehicles) {
      for (Rational* x : {&v.radius, &v.start.x, &v.start.y, &v.goal.x, &v.goal.y}) *x *= unit;
    }
    return make_plan(task).plan.timetables;
  };
  const std::vector<Timetable> one = timetables(0);
  for (const int exponent : {-320, -180, 180, 320})
    EXPECT_EQ(timetables(exponent), one) << exponent;
}

// Exactly the clearance is enough; a little more is not to be had.
TEST(Planner, TheClearanceIsExact) {
  const auto side_by_side = [](const Rational& clearance) {
    return make_plan(task_of({{1, {0, 0}, {9, 0}}, {1, {0, 3}, {9, 3}}}, clearance));
  };
  EXPECT_TRUE(side_by_side(1).found());
  const PlanResult more = side_by_side(Rational("1000000000000000000001/1000000000000000000000"));
  ASSERT_TRUE(more.impossible);
  EXPECT_EQ(more.impossible->t, 0);
  // Without clearance touching is still too near.
  EXPECT_TRUE(make_plan(task_of({{1, {0, 0}, {9, 0}}, {1, {0, 2}, {9, 2}}}, 0)).impossible);
}

TEST(Planner, SaysWhoCannotArrive) {
  const PlanResult result =
      make_plan(task_of({{1, {0, 0}, {9, 9}}, {1, {5, -5}, {-5, -5}}, {1, {0, 9}, {9, 10}}}));
  ASSERT_TRUE(result.impossible);
  EXPECT_FALSE(result.found());
  EXPECT_EQ(result.impossible->i, 0);
  EXPECT_EQ(result.impossible->j, 2);
  EXPECT_EQ(result.impossible->t, 10);
}

TEST(Planner, SaysWhoCannotPass) {
  // 1 and 2 change places on one line.
  const PlanResult result =
      make_plan(task_of({{1, {0, 30}, {5, 30}}, {1, {-8, 0}, {8, 0}}, {1, {8, 0}, {-8, 0}}}));
  EXPECT_FALSE(result.impossible);
  ASSERT_TRUE(result.unsolved);
  EXPECT_EQ(result.unsolved->i, 1);
  EXPECT_EQ(result.unsolved->j, 2);
  EXPECT_EQ(result.unsolved->t, 5);
  EXPECT_EQ(result.unsolved->distance2, 0);
}

TEST(Assignment, IsTheBestOfAll) {
  std::uint32_t state = 1;
  const auto dice = [&](int high) {
    state = state * 1664525 + 1013904223;
    return static_cast<int>((state >> 8) % static_cast<unsigned>(high));
  };
  for (int round = 0; round < 60; ++round) {
    std::vector<Vehicle> vehicles(1 + dice(6));
    for (Vehicle& v : vehicles) v = {1 + dice(2), {dice(20), dice(20)}, {dice(20), dice(20)}};
    const auto cost = [&](const std::vector<int>& goal) {
      Rational sum = 0;
      for (std::size_t i = 0; i < goal.size(); ++i) {
        const Rational x = vehicles[goal[i]].goal.x - vehicles[i].start.x,
                       y = vehicles[goal[i]].goal.y - vehicles[i].start.y;
        sum += x * x + y * y;
      }
      return sum;
    };
    std::vector<int> all(vehicles.size());
    std::iota(all.begin(), all.end(), 0);
    Rational least = -1;
    do {
      bool fits = true;
      for (std::size_t i = 0; i < all.size(); ++i)
        fits = fits && vehicles[all[i]].radius == vehicles[i].radius;
      if (fits && (least < 0 || cost(all) < least)) least = cost(all);
    } while (std::next_permutation(all.begin(), all.end()));
    const std::vector<int> found = nearest_goals(vehicles);
    std::vector<int> sorted = found;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(sorted[i], static_cast<int>(i));
      EXPECT_EQ(vehicles[found[i]].radius, vehicles[i].radius);
    }
    EXPECT_EQ(cost(found), least);
  }
  EXPECT_TRUE(nearest_goals({}).empty());
}

}  // namespace
}  // namespace voroproof::internal
