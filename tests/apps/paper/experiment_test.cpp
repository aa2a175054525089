// The paper's experiments: the data sets, and what is counted, against counting in other ways.
#include "apps/paper/experiment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "apps/paper/predictions.h"
#include "corpus/paper_sets.h"
#include "filtered/search/root_presence.h"
#include "library/maneuver_input.h"
#include "tests/support/rough_contact.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal {
namespace {

using testing::disk;
using testing::scene_of;

// Section 7.1, member by member.
TEST(PaperSets, AreThoseOfThePaper) {
  for (int k = 1; k <= 10; ++k) {
    EXPECT_EQ(paper_set_member("reference", k).n, 1000 * k);
    EXPECT_EQ(paper_set_member("speed", k).speed, k);
    EXPECT_EQ(paper_set_member("size", k).rmax, k);
    EXPECT_DOUBLE_EQ(paper_set_member("density", k).density, 0.05 * k);
    for (const std::string name : {"reference", "speed", "size", "density"}) {
      const ReferenceOptions o = paper_set_member(name, k);
      EXPECT_EQ(o.rmin, 1);
      EXPECT_EQ(o.horizon, 1000);
      EXPECT_EQ(o.restitution, 1);
      if (name != "reference") {
        EXPECT_EQ(o.n, 1000);
      }
      if (name != "speed") {
        EXPECT_EQ(o.speed, 1);
      }
      if (name != "size") {
        EXPECT_EQ(o.rmax, 10);
      }
      if (name != "density") {
        EXPECT_EQ(o.density, 0.05);
      }
    }
  }
  for (int k = 1; k <= 5; ++k) {
    EXPECT_EQ(paper_set_member("restitution", k).restitution, (5 + k) / 10.0);
    EXPECT_EQ(paper_set_member("restitution", k).n, 300);
  }
  EXPECT_EQ(paper_set_member("speed", 1, 0.0123).n, 12);
  EXPECT_THROW(paper_set_member("restitution", 6), std::invalid_argument);
  EXPECT_THROW(paper_set_member("speed", 0), std::invalid_argument);
  EXPECT_THROW(paper_set_member("colour", 1), std::invalid_argument);
}

TEST(Distributions, AreDescribed) {
  const Distribution d = distribution_of({5, 1, 4, 2});
  EXPECT_EQ(d.count, 4u);
  EXPECT_EQ(d.mean, 3);
  EXPECT_EQ(d.deviation, std::sqrt(2.5));
  EXPECT_EQ(d.least, 1);
  EXPECT_EQ(d.lower_quartile, 1.75);
  EXPECT_EQ(d.median, 3);
  EXPECT_EQ(d.upper_quartile, 4.25);
  EXPECT_EQ(d.greatest, 5);
  EXPECT_EQ(distribution_of({}).count, 0u);
}

// Two disks that go for each other along the x axis, one of them with the other at its back.
TEST(Experiment, MeasuresTheEnd) {
  const Scene scene = scene_of(
      100, 4, {disk(-10, 0, 1, 1, 0), disk(10, 0, 2, 0, 0), disk(0, 50, 3, 0, Rational(1, 2))});
  const ExperimentRun run = run_experiment(scene, false);
  ASSERT_EQ(run.outcome.kind, Outcome::Kind::complete);
  EXPECT_EQ(run.disks, 3);
  EXPECT_EQ(run.speed.greatest, 1);
  EXPECT_EQ(run.speed.median, 0.5);
  const double a = 16 - 3, b = std::hypot(6, 52) - 4, c = std::hypot(10, 52) - 5;
  EXPECT_NEAR(run.neighbor_distance.mean, ((a + b) / 2 + (a + c) / 2 + (b + c) / 2) / 3, 1e-12);
}

// The frequencies sum to the counts, and events are in their intervals.
TEST(Experiment, CountsByTime) {
  ReferenceOptions options = paper_set_member("speed", 4, 0.03);
  options.horizon = 35;
  const Scene scene = generate_reference(options);
  const ExperimentRun run = run_experiment(scene, false);
  const testing::RecordedRun record = testing::run(scene);
  std::map<int, std::uint64_t> flips, collisions;
  for (const testing::Event& e : record.events)
    ++(e.kind == testing::Event::Kind::flip ? flips : collisions)[static_cast<int>(e.t / 10)];
  ASSERT_EQ(run.flip_frequency.size(), 4u);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(run.flip_frequency[k], flips[k]);
    EXPECT_EQ(run.collision_frequency[k], collisions[k]);
  }
  EXPECT_GT(run.stats.flip_count(), 50u);
}

// Every event that occurs has been predicted.
TEST(Predictions, CoverWhatOccurs) {
  for (const double speed : {1.0, 6.0}) {
    ReferenceOptions options = paper_set_member("speed", 1, 0.03);
    options.speed = speed;
    options.horizon = 60;
    const ExperimentRun run = run_experiment(generate_reference(options), true);
    EXPECT_GE(run.predicted_flips_before_contact, run.stats.flip_count());
    EXPECT_GT(run.predicted_flips, run.predicted_flips_before_contact);
    EXPECT_GE(run.predicted_collisions, run.stats.disk_collisions + run.stats.wall_collisions);
    EXPECT_GT(run.predicted_roots, run.predicted_flips);
    EXPECT_LT(run.predicted_roots, 20 * run.stats.flip_count());
  }
}

// The edges to ask about, from the differences between whole diagrams: those with a new name, and
// those with a generator that has collided.
TEST(Predictions, AskOfEveryEdgeThatIsNew) {
  ReferenceOptions options = paper_set_member("speed", 3, 0.014);
  options.horizon = 60;
  const Scene scene = generate_reference(options);
  const ExperimentRun run = run_experiment(scene, true);
  const testing::RecordedRun record = testing::run(scene);
  ComputedMotion motion(motion_input(scene), {});
  TierCounts counts;
  CollapseSearch search(motion, counts);
  NamedDiagram diagram(diagram_of(motion.size(), record.initial));
  std::set<Quad> known;
  std::uint64_t expected = 0, asked = 0, roots = 0;
  const auto ask = [&](double now, const std::set<GenId>& moved) {
    const double start = std::nextafter(now, std::numeric_limits<double>::infinity());
    const std::vector<Quad> quads = diagram.diagram().quads();
    for (const Quad& q : quads) {
      const bool is_moved =
          moved.contains(q.l) || moved.contains(q.r) || moved.contains(q.s) || moved.contains(q.e);
      if ((known.contains(q) && !is_moved) || q.s == q.e) continue;
      ++asked;
      roots += flip_polynomial_has_root(motion, q, start, options.horizon);
      // Beyond a contact of the four an answer means nothing.
      double end = options.horizon, at = start;
      for (const auto& [i, j] :
           {std::pair(q.l, q.r), {q.l, q.s}, {q.l, q.e}, {q.r, q.s}, {q.r, q.e}, {q.s, q.e}}) {
        end = std::min(
            end,
            testing::rough_contact(motion, std::min(i, j), std::max(i, j), start).value_or(end));
      }
      bool found = false;
      while (!found && at < end) {
        const Collapse next = search.after(q, at, end);
        found = next.kind != Collapse::Kind::none;
        if (!found && next.lo <= at) break;
        at = next.lo;
      }
      expected += found;
    }
    known = {quads.begin(), quads.end()};
  };
  ask(0, {});
  for (std::size_t k = 0; k < record.events.size();) {
    const double t = record.events[k].t;
    std::set<GenId> moved;
    for (; k < record.events.size() && record.events[k].t == t; ++k) {
      const testing::Event& e = record.events[k];
      if (e.kind == testing::Event::Kind::flip) {
        diagram.flip(e.edge);
      } else {
        motion.collide(e.i, e.j, t);
        moved.insert(e.j);
        if (e.i != container_id) moved.insert(e.i);
      }
    }
    ask(t, moved);
  }
  EXPECT_EQ(run.predicted_flips_before_contact, expected);
  EXPECT_GE(run.predicted_flips, expected);
  EXPECT_EQ(run.predicted_roots, roots);
  EXPECT_GT(run.stats.flip_count(), 100u);
  EXPECT_GT(run.stats.disk_collisions, 5u);
  EXPECT_GT(asked, 2 * expected);  // not every edge says yes
}

TEST(Predictions, AreCountedByTheRule) {
  // Head-on at t = 8.5, then to and fro along the x axis.
  const Scene scene = scene_of(100, 100, {disk(-10, 0, 1, 1, 0), disk(10, 0, 2, -1, 0)});
  const ExperimentRun run = run_experiment(scene, true);
  const testing::RecordedRun record = testing::run(scene);
  ASSERT_GE(record.count(testing::Event::Kind::collision), 1u);
  EXPECT_EQ(record.events[0].t, 8.5);
  // The predictions are counted by the rule, from the history: for each instant, the pairs of the
  // disks that collided that ever meet under their new velocities. With two disks all pairs are
  // adjacent.
  struct State {
    double x, v;
  };
  State state[2] = {{-10, 1}, {10, -1}};
  const double radius[2] = {1, 2};
  std::uint64_t expected = 0;
  const auto count = [&](double t, bool first, bool second) {
    const double left = 100 - t, gap = state[1].x - state[0].x - 3,
                 closing = state[0].v - state[1].v;
    if (gap > 1e-9 && closing > 0 && gap / closing <= left) ++expected;
    for (const int i : {0, 1}) {
      if (!(i == 0 ? first : second) || state[i].v == 0) continue;
      const double wall = 100 - radius[i] - (state[i].v > 0 ? state[i].x : -state[i].x);
      if (wall / std::fabs(state[i].v) <= left) ++expected;
    }
  };
  count(0, true, true);
  double now = 0;
  for (const testing::Event& e : record.events) {
    ASSERT_EQ(e.kind, testing::Event::Kind::collision);
    for (State& s : state) s.x += s.v * (e.t - now);
    now = e.t;
    if (e.i != container_id) state[e.i].v = e.first.vx;
    state[e.j].v = e.second.vx;
    count(now, e.i == 0 || e.j == 0, e.i == 1 || e.j == 1);
  }
  EXPECT_EQ(run.predicted_collisions, expected);
}

}  // namespace
}  // namespace voroproof::internal
