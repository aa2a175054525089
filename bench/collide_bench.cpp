// The change of motion at a collision, with and without certificates.
//
// A short run of the exact engine tells which pairs touch and when; the same collisions
// are then processed again, in order, from fresh motions. The horizon that the scene
// announces sets the bits that a state carries, and with them the cost.
#include <memory>
#include <string>
#include <vector>

#include "bench/data_sets.h"
#include "bench/paired.h"
#include "bench/plain_motion.h"
#include "bench/predicates_bench.h"
#include "bench/tasks.h"

namespace voroproof::internal::bench {

namespace {

void certified(benchmark::State& state, const std::string& name) {
  // About a thousand collisions of the sparse scenes, some ten thousand of the dense ones.
  const DataSet& set = data_set(name);
  const std::vector<Hit> hits = hits_of(set.scene, 100);
  int bits = 0;
  run_paired(
      state, hits.size(),
      [&] {
        const std::unique_ptr<ComputedMotion> motion = motion_of(set.scene);
        const double seconds = seconds_of([&] {
          for (const Hit& h : hits) benchmark::DoNotOptimize(motion->collide(h.i, h.j, h.t));
        });
        bits = motion->highest_bits();
        return seconds;
      },
      [&] {
        const std::unique_ptr<ComputedMotion> motion = motion_of(set.scene);
        PlainMotion plain(*motion);
        return seconds_of([&] {
          for (const Hit& h : hits) {
            benchmark::DoNotOptimize(plain.collide(h.i, h.j, h.t));
          }
        });
      });
  state.counters["collisions"] = static_cast<double>(hits.size());
  state.counters["bits"] = bits;
}

}  // namespace

void register_collide_benchmarks() {
  for (const std::string& name : data_set_names) {
    benchmark::RegisterBenchmark(("collide/certified/" + name).c_str(),
                                 [=](benchmark::State& state) { certified(state, name); })
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace voroproof::internal::bench
