// How the time of an event grows with the number of disks, at one density and horizon: by
// the event queue it should grow like log n.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/simulation.h"
#include "bench/statistics.h"

namespace voroproof::bench {

namespace {

struct Point {
  int n;
  std::uint64_t events;
  // Medians of microseconds an event: of the whole run, and of CPU without the first diagram.
  double certified, certified_loop, plain, plain_loop;
  double ratio;  // median of the pairwise ratios of whole runs
};

Point measure(const SceneChoice& choice, int repeats) {
  const Scene scene = scene_of(choice);
  std::vector<double> total[2], loop[2], ratios;
  std::uint64_t events = 0;
  for (int r = 0; r < repeats; ++r) {
    for (const bool certified : {r % 2 == 0, r % 2 != 0}) {
      const RunResult run = simulate(scene, certified);
      if (certified) events = run.events();
      const double scale = 1e6 / static_cast<double>(run.events());
      total[certified].push_back(run.seconds * scale);
      loop[certified].push_back(run.loop_cpu_seconds * scale);
    }
    ratios.push_back(total[1].back() / total[0].back());
  }
  return {choice.n,         events,          median(total[1]), median(loop[1]),
          median(total[0]), median(loop[0]), median(ratios)};
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

int bench(const std::vector<int>& sizes, double horizon, int repeats, const std::string& path) {
  std::printf(
      "horizon %g, density 0.05, %d repeats; microseconds an event; loop: CPU, without "
      "the first diagram\n",
      horizon, repeats);
  std::printf("%8s %10s %10s %10s %10s %10s %8s %12s\n", "n", "events", "certified", "loop",
              "plain", "loop", "ratio", "loop/log2 n");
  std::vector<Point> points;
  for (const int n : sizes) {
    const Point p = measure({.n = n, .horizon = horizon}, repeats);
    points.push_back(p);
    std::printf("%8d %10llu %10.2f %10.2f %10.2f %10.2f %8.2f %12.3f\n", p.n,
                static_cast<unsigned long long>(p.events), p.certified, p.certified_loop, p.plain,
                p.plain_loop, p.ratio, p.certified_loop / std::log2(p.n));
    std::fflush(stdout);
  }
  const double certified = fitted_exponent(points, [](const Point& p) { return p.certified_loop; });
  const double plain = fitted_exponent(points, [](const Point& p) { return p.plain_loop; });
  const double logarithm = fitted_exponent(points, [](const Point& p) { return std::log(p.n); });
  std::printf("fitted exponent of n (loop): certified %.3f, plain %.3f; of log n itself: %.3f\n",
              certified, plain, logarithm);
  if (path.empty()) return 0;

  nlohmann::ordered_json report{{"horizon", horizon},
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
                                {"ratio", p.ratio}});
  }
  std::ofstream out(path);
  out << report.dump(2) << '\n';
  if (!out.flush()) {
    std::fprintf(stderr, "cannot write %s\n", path.c_str());
    return 1;
  }
  return 0;
}

}  // namespace

}  // namespace voroproof::bench

int main(int argc, char** argv) {
  std::vector<int> sizes{1000, 2000, 5000, 10000, 20000, 50000, 100000};
  double horizon = 120;  // about seven events a disk
  int repeats = 3;
  std::string json;
  CLI::App app{"Time per event as the number of disks grows"};
  app.add_option("--sizes", sizes, "numbers of disks, at least two of them")
      ->expected(2, 100)
      ->check(CLI::PositiveNumber);
  app.add_option("--horizon", horizon, "time simulated")->check(CLI::PositiveNumber);
  app.add_option("--repeats", repeats, "runs of each engine and size")->check(CLI::PositiveNumber);
  app.add_option("--json", json, "write the results to this file");
  CLI11_PARSE(app, argc, argv);
  try {
    return voroproof::bench::bench(sizes, horizon, repeats, json);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
}
