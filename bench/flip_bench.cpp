// The first collapse of an edge within a window: the predicate that takes most of a run.
//
// The window is (0, w], where w is the horizon or, if that is sooner, the first contact
// of the edge's four generators, beyond which their circles mean nothing.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench/data_sets.h"
#include "bench/flip_peer.h"
#include "bench/paired.h"
#include "bench/plain_motion.h"
#include "bench/predicates_bench.h"
#include "bench/tasks.h"
#include "filtered/search/collapse.h"

namespace voroproof::internal::bench {

namespace {

constexpr double kHorizons[] = {1, 10, 100, 1000};
// Peers of some 100 microseconds a polynomial get this many, evenly spread.
constexpr std::size_t kSlowSample = 100;

std::vector<FlipTask> sample_of(const std::vector<FlipTask>& searches, std::size_t size) {
  if (searches.size() <= size) return searches;
  std::vector<FlipTask> out;
  for (std::size_t k = 0; k < size; ++k) out.push_back(searches[k * searches.size() / size]);
  return out;
}

Collapse plain_collapse(const PlainMotion& motion, const FlipTask& s) {
  return through_window(
      s, [&](const Quad& q, double start, double end) { return motion.collapse(q, start, end); });
}

double plain_pass(Motion& in, const std::vector<FlipTask>& searches) {
  const PlainMotion motion(in);
  return seconds_of([&] {
    for (const FlipTask& s : searches) benchmark::DoNotOptimize(plain_collapse(motion, s));
  });
}

// What the plain search gets wrong, in percent of the collapses there are: those that it
// misses or finds at another root, and those that it makes up.
void count_faults(benchmark::State& state, const DataSet& set,
                  const std::vector<FlipTask>& searches) {
  TierCounts counts;
  CollapseSearch search(*set.motion, counts);
  const PlainMotion plain(*set.motion);
  long collapses = 0, missed = 0, invented = 0;
  for (const FlipTask& s : searches) {
    const Collapse truth = certified_collapse(search, s);
    const Collapse claim = plain_collapse(plain, s);
    const bool claims = claim.kind == Collapse::Kind::root;
    if (truth.kind != Collapse::Kind::root) {
      invented += claims;
      continue;
    }
    ++collapses;
    const double slack = 1e-6 * (1 + truth.hi);
    missed += !claims || claim.hi < truth.lo - slack || claim.lo > truth.hi + slack;
  }
  const auto& by_tier = counts.decided[static_cast<int>(Predicate::flip_search)];
  state.counters["collapses"] = static_cast<double>(collapses);
  state.counters["plain_missed"] = static_cast<double>(missed);
  state.counters["plain_invented"] = static_cast<double>(invented);
  state.counters["beyond_double"] = static_cast<double>(
      by_tier[static_cast<int>(Tier::dd)] + by_tier[static_cast<int>(Tier::ball)] +
      by_tier[static_cast<int>(Tier::symmetry)] + by_tier[static_cast<int>(Tier::exact)]);
  state.counters["exact"] = static_cast<double>(by_tier[static_cast<int>(Tier::exact)]);
}

void certified(benchmark::State& state, const std::string& name, double horizon) {
  const DataSet& set = data_set(name);
  const std::vector<FlipTask> searches = flip_tasks(set, horizon);
  TierCounts counts;
  CollapseSearch search(*set.motion, counts);
  run_paired(
      state, searches.size(),
      [&] {
        return seconds_of([&] {
          for (const FlipTask& s : searches) {
            benchmark::DoNotOptimize(certified_collapse(search, s));
          }
        });
      },
      [&] { return plain_pass(*set.motion, searches); });
  count_faults(state, set, searches);
  double window = 0;
  for (const FlipTask& s : searches) window += s.end;
  state.counters["window"] = window / static_cast<double>(searches.size());
}

using MakeIsolator = std::unique_ptr<RootIsolator> (*)(const std::vector<RootTask>&);

[[maybe_unused]] void isolator(benchmark::State& state, const std::string& name, double horizon,
                               MakeIsolator make) {
  const DataSet& set = data_set(name);
  const std::vector<FlipTask> searches = sample_of(flip_tasks(set, horizon), kSlowSample);
  std::vector<RootTask> tasks;
  for (const FlipTask& s : searches) {
    tasks.push_back({flip_polynomial_of(set.scene, s.quad), s.end});
  }
  const std::unique_ptr<RootIsolator> peer = make(tasks);
  long roots = 0;
  run_paired(
      state, searches.size(), [&] { return seconds_of([&] { roots = peer->isolate(); }); },
      [&] { return plain_pass(*set.motion, searches); });
  state.counters["roots"] = static_cast<double>(roots);
  state.counters["undecided"] =
      static_cast<double>(peer->undecided()) / static_cast<double>(state.iterations());
}

}  // namespace

void register_flip_benchmarks() {
  for (const std::string& name : data_set_names) {
    for (const double horizon : kHorizons) {
      const std::string where = name + "/" + std::to_string(std::lround(horizon));
      const auto add = [](const std::string& title, auto&& function) {
        benchmark::RegisterBenchmark(title.c_str(), function)
            ->UseManualTime()
            ->Unit(benchmark::kMicrosecond);
      };
      add("flip/certified/" + where,
          [=](benchmark::State& state) { certified(state, name, horizon); });
      add("flip/arb/" + where,
          [=](benchmark::State& state) { isolator(state, name, horizon, arb_isolator); });
#ifdef VOROPROOF_BENCH_CGAL_KERNEL
      add("flip/cgal/" + where,
          [=](benchmark::State& state) { isolator(state, name, horizon, cgal_isolator); });
#endif
    }
  }
}

}  // namespace voroproof::internal::bench
