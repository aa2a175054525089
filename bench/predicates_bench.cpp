#include "bench/predicates_bench.h"

#include <benchmark/benchmark.h>

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  voroproof::internal::bench::register_flip_benchmarks();
  voroproof::internal::bench::register_incircle_benchmarks();
  voroproof::internal::bench::register_contact_benchmarks();
  voroproof::internal::bench::register_collide_benchmarks();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
