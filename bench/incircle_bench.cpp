// The in-circle predicate at one instant within the first time unit: in doubles with error
// bounds, in CGAL's intervals and in rationals, each next to plain doubles.
#include <string>
#include <vector>

#include "bench/data_sets.h"
#include "bench/incircle_task.h"
#include "bench/paired.h"
#include "bench/predicates_bench.h"
#include "bench/tasks.h"

namespace voroproof::internal::bench {

namespace {

constexpr std::size_t kSlowSample = 200;

// All tasks in one number type; `site(g, t)` gives a generator. Returns the seconds.
template <class SiteOf>
double pass(const std::vector<IncircleTask>& tasks, long& undecided, SiteOf&& site) {
  return seconds_of([&] {
    undecided = 0;
    for (const IncircleTask& task : tasks) {
      const Sign s = incircle_at(task.quad, [&](GenId g) { return site(g, task.t); });
      if (s == Sign::unknown) ++undecided;
    }
    benchmark::DoNotOptimize(undecided);
  });
}

double plain_pass(const Motion& motion, const std::vector<IncircleTask>& tasks) {
  Sign last = Sign::unknown;
  return seconds_of([&] {
    for (const IncircleTask& task : tasks) {
      last = incircle_at(task.quad, [&](GenId g) {
        const DoubleMotion& m = motion.doubles(g);
        const double dt = task.t - m.t;
        return Site<double>{m.x + m.vx * dt, m.y + m.vy * dt, m.r};
      });
      benchmark::DoNotOptimize(last);
    }
  });
}

void with_bounds(benchmark::State& state, const std::string& name) {
  const DataSet& set = data_set(name);
  const std::vector<IncircleTask> tasks = incircle_tasks(set);
  long undecided = 0;
  run_paired(
      state, tasks.size(),
      [&] {
        return pass(tasks, undecided,
                    [&](GenId g, double t) { return set.motion->site(g, DoubleBall(t)); });
      },
      [&] { return plain_pass(*set.motion, tasks); });
  state.counters["undecided"] = static_cast<double>(undecided);
}

void in_intervals(benchmark::State& state, const std::string& name) {
  const DataSet& set = data_set(name);
  const std::vector<IncircleTask> tasks = incircle_tasks(set);
  long undecided = 0;
  run_paired(
      state, tasks.size(),
      [&] {
        double seconds = 0;
        undecided = incircles_in_intervals(*set.motion, tasks, seconds);
        return seconds;
      },
      [&] { return plain_pass(*set.motion, tasks); });
  state.counters["undecided"] = static_cast<double>(undecided);
}

Site<Rational> exact_site(const Scene& scene, GenId g, const Rational& t) {
  if (g == container_id) return {scene.cx, scene.cy, Rational(-scene.container_radius)};
  const DiskInput& d = scene.disks[static_cast<std::size_t>(g)];
  return {Rational(d.x.value() + d.vx.value() * t), Rational(d.y.value() + d.vy.value() * t),
          d.radius.value()};
}

void in_rationals(benchmark::State& state, const std::string& name) {
  const DataSet& set = data_set(name);
  std::vector<IncircleTask> tasks = incircle_tasks(set);
  tasks.resize(std::min(tasks.size(), kSlowSample));
  long undecided = 0;
  run_paired(
      state, tasks.size(),
      [&] {
        return pass(tasks, undecided,
                    [&](GenId g, double t) { return exact_site(set.scene, g, to_rational(t)); });
      },
      [&] { return plain_pass(*set.motion, tasks); });
}

}  // namespace

void register_incircle_benchmarks() {
  for (const std::string& name : data_set_names) {
    const auto add = [&](const std::string& kind,
                         void (*function)(benchmark::State&, const std::string&)) {
      benchmark::RegisterBenchmark(("incircle/" + kind + "/" + name).c_str(),
                                   [=](benchmark::State& state) { function(state, name); })
          ->UseManualTime()
          ->Unit(benchmark::kMicrosecond);
    };
    add("double_ball", with_bounds);
    add("cgal_interval", in_intervals);
    add("rational", in_rationals);
  }
}

}  // namespace voroproof::internal::bench
