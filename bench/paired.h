// A predicate measured next to its plain-double peer: both do the same operations in
// turn, in one process, so that a busy machine slows both and leaves their ratio.
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

#include "bench/statistics.h"

namespace voroproof::internal::bench {

// Every iteration calls both `subject` and `plain`, each of which does the same
// `operations` operations and returns the seconds it took. Which goes first
// alternates. The iteration's time is the subject's. Counters:
//   ns, plain_ns   medians, nanoseconds per operation
//   ratio          median over the iterations of subject / plain
template <class Subject, class Plain>
void run_paired(benchmark::State& state, std::size_t operations, Subject&& subject, Plain&& plain) {
  std::vector<double> subject_seconds, plain_seconds, ratios;
  bool plain_first = false;
  for (auto _ : state) {
    double p = plain_first ? plain() : 0;
    const double s = subject();
    if (!plain_first) p = plain();
    plain_first = !plain_first;
    subject_seconds.push_back(s);
    plain_seconds.push_back(p);
    ratios.push_back(s / p);
    state.SetIterationTime(s);
  }
  const double per_operation = 1e9 / static_cast<double>(operations);
  state.counters["ns"] = median(subject_seconds) * per_operation;
  state.counters["plain_ns"] = median(plain_seconds) * per_operation;
  state.counters["ratio"] = median(ratios);
}

}  // namespace voroproof::internal::bench
