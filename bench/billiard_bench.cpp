// How long the certifier takes for the history of an event-driven engine in a periodic box, against
// how long the engine takes to make it. The certifier reads a file; the engine writes into memory.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <string>

#include "bench/plain_billiard.h"
#include "certify/billiards/billiard_certifier.h"
#include "certify/report.h"
#include "history/json_text.h"

namespace voroproof::bench {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Gas {
  int dimension;
  double side, radius;
  std::vector<std::array<double, 3>> x, v;
};

// Balls on a lattice, moved off it by a little, with random velocities; `density`: the share of the
// volume that they fill.
Gas gas(int dimension, int n, double density, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1, 1);
  const int row = static_cast<int>(std::ceil(std::pow(n, 1.0 / dimension)));
  Gas gas{dimension, static_cast<double>(row), 0, {}, {}};
  const double ball = dimension == 2 ? M_PI : 4 * M_PI / 3;
  gas.radius = std::pow(density * std::pow(row, dimension) / n / ball, 1.0 / dimension);
  const double room = std::max(0.0, (1 - 2 * gas.radius) / 2 * 0.9);
  for (int i = 0; i < n; ++i) {
    std::array<double, 3> x{}, v{};
    int rest = i;
    for (int k = 0; k < dimension; ++k, rest /= row) {
      x[k] = rest % row + 0.5 + room * uniform(random);
      v[k] = normal(random);
    }
    gas.x.push_back(x);
    gas.v.push_back(v);
  }
  return gas;
}

std::string text(const std::array<double, 3>& v, int dimension) {
  std::string text = "[";
  for (int k = 0; k < dimension; ++k) text += (k ? "," : "") + internal::number_text(v[k]);
  return text + "]";
}

void write_scene(const Gas& gas, double horizon, const std::string& path) {
  std::ofstream out(path);
  out << R"({"format":"voroproof-scene","version":2,"contacts":"bounce","dimension":)"
      << gas.dimension << R"(,"horizon":)" << internal::number_text(horizon)
      << R"(,"frame":{"periodic":)" << text({gas.side, gas.side, gas.side}, gas.dimension)
      << "},\"disks\":[\n";
  for (std::size_t i = 0; i < gas.x.size(); ++i) {
    out << (i ? ",\n" : "") << R"({"center":)" << text(gas.x[i], gas.dimension) << R"(,"radius":)"
        << internal::number_text(gas.radius) << R"(,"velocity":)" << text(gas.v[i], gas.dimension)
        << R"(,"mass":1})";
  }
  out << "]}\n";
}

void write_history(const Gas& gas, const std::vector<PlainCollision>& told,
                   const std::string& sha256, double horizon, const std::string& path) {
  std::ofstream out(path);
  out << R"({"format":"voroproof-history","version":2,"scene_sha256":")" << sha256
      << R"(","horizon":)" << internal::number_text(horizon) << R"(,"producer":"plain"})" << '\n';
  for (const PlainCollision& c : told) {
    out << R"({"t":)" << internal::number_text(c.t) << R"(,"collide":[)" << c.i << ',' << c.j
        << R"(],"image":[)" << c.image[0] << ',' << c.image[1];
    if (gas.dimension == 3) out << ',' << c.image[2];
    out << R"(],"v":[)" << text(c.vi, gas.dimension) << ',' << text(c.vj, gas.dimension) << "]}\n";
  }
  out << R"({"end":{"t":)" << internal::number_text(horizon) << R"(,"collisions":)" << told.size()
      << R"(,"maneuvers":0}})" << '\n';
}

void measure(int dimension, int n, std::int64_t collisions, double density) {
  const Gas made = gas(dimension, n, density, 1);
  std::vector<PlainCollision> told;
  auto start = Clock::now();
  PlainBilliard engine(dimension, made.side, made.radius, made.x, made.v);
  engine.run(collisions, [&](const PlainCollision& c) { told.push_back(c); });
  const double making = since(start);
  const double horizon = told.back().t;
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const std::string scene = folder / "voroproof_bench.scene.json";
  const std::string history = folder / "voroproof_bench.history.jsonl";
  write_scene(made, horizon, scene);
  const internal::Billiard billiard = internal::read_billiard(scene);
  write_history(made, told, billiard.sha256, horizon, history);
  start = Clock::now();
  internal::BilliardHistoryReader alone(history, &billiard);
  while (alone.next()) {
  }
  const double reading = since(start);
  start = Clock::now();
  internal::BilliardHistoryReader reader(history, &billiard);
  internal::CertifyOptions options;
  options.truth = internal::Truth::recorded;
  const internal::Certificate c = internal::certify_billiard(billiard, scene, reader, options);
  const double certifying = since(start);
  std::printf("| %d | %d | %zu | %.2f | %.3f s | %.3f s | %.3f s | %.2f | %s |\n", dimension, n,
              told.size(), density, making, reading, certifying, certifying / making,
              std::string(internal::verdict_line(c.verdict)).c_str());
  std::fflush(stdout);
  if (c.verdict != internal::Verdict::certified) std::cerr << internal::reason_line(c) << '\n';
  std::filesystem::remove(scene);
  std::filesystem::remove(history);
}

}  // namespace
}  // namespace voroproof::bench

int main(int argc, char** argv) {
  const std::int64_t collisions = argc > 1 ? std::stoll(argv[1]) : 100'000;
  std::puts("| dimension | n | collisions | density | engine | reading | certifying | ratio | |");
  std::puts("|---|---|---|---|---|---|---|---|---|");
  voroproof::bench::measure(2, 1000, collisions, 0.3);
  voroproof::bench::measure(2, 10000, collisions, 0.5);
  voroproof::bench::measure(3, 1000, collisions, 0.2);
  voroproof::bench::measure(3, 100'000, collisions, 0.3);
}
