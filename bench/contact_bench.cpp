// The next contact of the two generators of an edge within a horizon of 1000.
#include <string>
#include <utility>
#include <vector>

#include "bench/data_sets.h"
#include "bench/paired.h"
#include "bench/plain_motion.h"
#include "bench/predicates_bench.h"
#include "bench/tasks.h"
#include "engine/static_diagram.h"
#include "filtered/search/contact.h"

namespace voroproof::internal::bench {

namespace {

constexpr double kHorizon = 1000;

void certified(benchmark::State& state, const std::string& name) {
  const DataSet& set = data_set(name);
  const std::vector<std::pair<GenId, GenId>> pairs = neighbours(set);
  TierCounts counts;
  ContactSearch search(*set.motion, counts);
  const PlainMotion plain(*set.motion);
  const Moment now = Moment::at(0);
  run_paired(
      state, pairs.size(),
      [&] {
        return seconds_of([&] {
          for (const auto& [i, j] : pairs) {
            benchmark::DoNotOptimize(search.from(i, j, now, kHorizon));
          }
        });
      },
      [&] {
        return seconds_of([&] {
          for (const auto& [i, j] : pairs) {
            benchmark::DoNotOptimize(plain.contact(i, j, 0, kHorizon));
          }
        });
      });
  const auto& by_tier = counts.decided[static_cast<int>(Predicate::contact_search)];
  double all = 0;
  for (const auto n : by_tier) all += static_cast<double>(n);
  state.counters["beyond_double"] =
      100 * (1 - static_cast<double>(by_tier[static_cast<int>(Tier::filter)]) / all);
}

}  // namespace

void register_contact_benchmarks() {
  for (const std::string& name : data_set_names) {
    benchmark::RegisterBenchmark(("contact/certified/" + name).c_str(),
                                 [=](benchmark::State& state) { certified(state, name); })
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace voroproof::internal::bench
