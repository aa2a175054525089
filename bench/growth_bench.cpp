// How the time of an event, the memory of a disk and the bits of the states grow with the number of
// disks, at one density and horizon: by the event queue the time should grow like log n.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/report.h"
#include "bench/simulation.h"
#include "bench/statistics.h"

namespace voroproof::internal::bench {

namespace {

struct Point {
  int n;
  std::uint64_t events;
  // Medians of microseconds an event: of the whole run, and of CPU without the first diagram.
  double certified, certified_loop, plain, plain_loop;
  double ratio;          // median of the pairwise ratios of whole runs
  std::uint64_t memory;  // bytes, the peak of a certified run
  EngineStats stats;     // of a certified run
};

Point measure(const SceneChoice& choice, std::uint64_t memory, int repeats) {
  const Scene scene = scene_of(choice);
  EngineStats stats;
  std::vector<double> total[2], loop[2], ratios;
  std::uint64_t events = 0;
  for (int r = 0; r < repeats; ++r) {
    for (const bool certified : {r % 2 == 0, r % 2 != 0}) {
      const RunResult run = simulate(scene, certified);
      if (certified) {
        events = run.events();
        stats = run.stats;
      }
      const double scale = 1e6 / static_cast<double>(run.events());
      total[certified].push_back(run.seconds * scale);
      loop[certified].push_back(run.loop_cpu_seconds * scale);
    }
    ratios.push_back(total[1].back() / total[0].back());
  }
  return {.n = choice.n,
          .events = events,
          .certified = median(total[1]),
          .certified_loop = median(loop[1]),
          .plain = median(total[0]),
          .plain_loop = median(loop[0]),
          .ratio = median(ratios),
          .memory = memory,
          .stats = stats};
}

// The slope of the least-squares line through (log n, log y).
template <class Value>
double fitted_exponent(const std::vector<Point>& points, Value&& value) {
  double x1 = 0, y1 = 0, xx = 0, xy = 0;
  for (const Point& p : points) {
    const double x = std::log(p.n), y = std::log(value(p));
    x1 += x;
    y1 += y;
    xx += x * x;
    xy += x * y;
  }
  const double k = static_cast<double>(points.size());
  return (k * xy - x1 * y1) / (k * xx - x1 * x1);
}

// What a disk takes where it counts: beyond 20 MB, the program's own and what is on its way out.
double bytes_a_disk(const Point& p) {
  return std::max(0.0, static_cast<double>(p.memory) - 20e6) / p.n;
}

void bench(const std::vector<int>& sizes, SceneChoice choice, int repeats,
           const std::string& path) {
  std::printf(
      "horizon %g, density %g, %d repeats; microseconds an event; loop: CPU, without "
      "the first diagram\n",
      choice.horizon, choice.density, repeats);
  std::printf("%8s %10s %10s %10s %10s %10s %8s %12s %9s %8s %6s\n", "n", "events", "certified",
              "loop", "plain", "loop", "ratio", "loop/log2 n", "peak MB", "B/disk", "bits");
  // The memory is measured before anything large is made here.
  std::vector<std::uint64_t> memory;
  for (const int n : sizes) {
    choice.n = n;
    memory.push_back(peak_memory(choice, EngineKind::certified));
  }
  std::vector<Point> points;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    choice.n = sizes[k];
    const Point p = measure(choice, memory[k], repeats);
    points.push_back(p);
    std::printf("%8d %10llu %10.2f %10.2f %10.2f %10.2f %8.2f %12.3f %9.1f %8.0f %6d\n", p.n,
                static_cast<unsigned long long>(p.events), p.certified, p.certified_loop, p.plain,
                p.plain_loop, p.ratio, p.certified_loop / std::log2(p.n),
                static_cast<double>(p.memory) / 1e6, bytes_a_disk(p), p.stats.highest_bits);
    std::fflush(stdout);
  }
  const double certified = fitted_exponent(points, [](const Point& p) { return p.certified_loop; });
  const double plain = fitted_exponent(points, [](const Point& p) { return p.plain_loop; });
  const double logarithm = fitted_exponent(points, [](const Point& p) { return std::log(p.n); });
  std::printf("fitted exponent of n (loop): certified %.3f, plain %.3f; of log n itself: %.3f\n",
              certified, plain, logarithm);
  if (path.empty()) return;

  nlohmann::ordered_json report{{"horizon", choice.horizon},
                                {"density", choice.density},
                                {"repeats", repeats},
                                {"exponent_certified", certified},
                                {"exponent_plain", plain},
                                {"exponent_of_log_n", logarithm},
                                {"points", nlohmann::ordered_json::array()}};
  for (const Point& p : points) {
    report["points"].push_back({{"n", p.n},
                                {"events", p.events},
                                {"certified_us", p.certified},
                                {"certified_loop_cpu_us", p.certified_loop},
                                {"plain_us", p.plain},
                                {"plain_loop_cpu_us", p.plain_loop},
                                {"ratio", p.ratio},
                                {"peak_memory_bytes", p.memory},
                                {"bytes_a_disk_beyond_20_MB", bytes_a_disk(p)},
                                {"highest_bits", p.stats.highest_bits},
                                {"replays", p.stats.replays},
                                {"tiers", tiers_json(p.stats.tiers)}});
  }
  write_report(path, report);
}

}  // namespace

}  // namespace voroproof::internal::bench

int main(int argc, char** argv) {
  std::vector<int> sizes{1000, 2000, 5000, 10000, 20000, 50000, 100000};
  voroproof::internal::bench::SceneChoice choice;
  choice.horizon = 120;  // about seven events a disk
  int repeats = 3;
  std::string json;
  CLI::App app{"Time per event as the number of disks grows"};
  app.add_option("--sizes", sizes, "numbers of disks, at least two of them")
      ->expected(2, 100)
      ->check(CLI::PositiveNumber);
  app.add_option("--horizon", choice.horizon, "time simulated")->check(CLI::PositiveNumber);
  app.add_option("--density", choice.density, "area of the disks / area of the container")
      ->check(CLI::Range(0.0001, 0.6));
  app.add_option("--repeats", repeats, "runs of each engine and size")->check(CLI::PositiveNumber);
  app.add_option("--json", json, "write the results to this file");
  CLI11_PARSE(app, argc, argv);
  try {
    voroproof::internal::bench::bench(sizes, choice, repeats, json);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return 0;
}
