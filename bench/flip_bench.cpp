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
#include "bench/predicates_bench.h"
#include "filtered/collapse.h"
#include "filtered/contact.h"

namespace voroproof::bench {

namespace {

constexpr double kHorizons[] = {1, 10, 100, 1000};
// Peers of some 100 microseconds a polynomial get this many, evenly spread.
constexpr std::size_t kSlowSample = 100;

struct Search {
  Quad quad;
  double end;
};

double first_contact(const Motion& motion, const Quad& q, double horizon) {
  const GenId ids[4] = {q.l, q.r, q.s, q.e};
  double end = horizon;
  for (int a = 0; a < 4; ++a) {
    for (int b = a + 1; b < 4; ++b) {
      const auto [i, j] = std::minmax(ids[a], ids[b]);
      const NextContact c = contact_in_doubles(motion, i, j, 0, end);
      if (c.kind == NextContact::Kind::at) end = std::min(end, c.lo);
    }
  }
  return end;
}

std::vector<Search> searches_of(const DataSet& set, double horizon) {
  std::vector<Search> out;
  for (const Quad& q : set.quads) {
    const double end = first_contact(*set.motion, q, horizon);
    if (end > 0) out.push_back({q, end});
  }
  return out;
}

std::vector<Search> sample_of(const std::vector<Search>& searches, std::size_t size) {
  if (searches.size() <= size) return searches;
  std::vector<Search> out;
  for (std::size_t k = 0; k < size; ++k) out.push_back(searches[k * searches.size() / size]);
  return out;
}

// A search may answer for a part of the window only: asks on until the end.
template <class After>
Collapse through_window(const Search& s, After&& after) {
  Collapse c = after(s.quad, 0.0, s.end);
  while (c.kind == Collapse::Kind::none && c.lo < s.end) c = after(s.quad, c.lo, s.end);
  return c;
}

Collapse plain_collapse(const Motion& motion, const Search& s) {
  return through_window(s, [&](const Quad& q, double start, double end) {
    return collapse_in_doubles(motion, q, start, end);
  });
}

Collapse certified_collapse(CollapseSearch& search, const Search& s) {
  return through_window(
      s, [&](const Quad& q, double start, double end) { return search.after(q, start, end); });
}

double plain_pass(const Motion& motion, const std::vector<Search>& searches) {
  return seconds_of([&] {
    for (const Search& s : searches) benchmark::DoNotOptimize(plain_collapse(motion, s));
  });
}

// What the plain search gets wrong, in percent of the collapses there are: those that it
// misses or finds at another root, and those that it makes up.
void count_faults(benchmark::State& state, const DataSet& set,
                  const std::vector<Search>& searches) {
  TierCounts counts;
  CollapseSearch search(*set.motion, counts);
  long collapses = 0, missed = 0, invented = 0;
  for (const Search& s : searches) {
    const Collapse truth = certified_collapse(search, s);
    const Collapse claim = plain_collapse(*set.motion, s);
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
  const std::vector<Search> searches = searches_of(set, horizon);
  TierCounts counts;
  CollapseSearch search(*set.motion, counts);
  run_paired(
      state, searches.size(),
      [&] {
        return seconds_of([&] {
          for (const Search& s : searches) {
            benchmark::DoNotOptimize(certified_collapse(search, s));
          }
        });
      },
      [&] { return plain_pass(*set.motion, searches); });
  count_faults(state, set, searches);
  double window = 0;
  for (const Search& s : searches) window += s.end;
  state.counters["window"] = window / static_cast<double>(searches.size());
}

using MakeIsolator = std::unique_ptr<RootIsolator> (*)(const std::vector<RootTask>&);

[[maybe_unused]] void isolator(benchmark::State& state, const std::string& name, double horizon,
                               MakeIsolator make) {
  const DataSet& set = data_set(name);
  const std::vector<Search> searches = sample_of(searches_of(set, horizon), kSlowSample);
  std::vector<RootTask> tasks;
  for (const Search& s : searches) {
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
#ifdef VOROPROOF_BENCH_ARB
      add("flip/arb/" + where,
          [=](benchmark::State& state) { isolator(state, name, horizon, arb_isolator); });
#endif
#ifdef VOROPROOF_BENCH_CGAL_KERNEL
      add("flip/cgal/" + where,
          [=](benchmark::State& state) { isolator(state, name, horizon, cgal_isolator); });
#endif
    }
  }
}

}  // namespace voroproof::bench
