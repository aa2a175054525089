// Whole simulations of one scene by the exact engine and by the same engine in plain
// doubles, in turn in one process; prints a table and, where asked, writes it as JSON.
#include <CLI/CLI.hpp>
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

constexpr double kMegabyte = 1024.0 * 1024.0;

// What one engine did in all repeats. The events are the same in each.
struct Series {
  std::vector<double> seconds, cpu_seconds;
  RunResult last;
  std::uint64_t memory = 0;
};

nlohmann::ordered_json series_json(const Series& s) {
  const EngineStats& stats = s.last.stats;
  const double middle = median(s.seconds);
  return {{"outcome", name_of(s.last.outcome.kind)},
          {"reason", s.last.outcome.reason},
          {"end", stats.end},
          {"seconds", s.seconds},
          {"median_seconds", middle},
          {"cpu_seconds", s.cpu_seconds},
          {"median_cpu_seconds", median(s.cpu_seconds)},
          {"flips", stats.flip_count()},
          {"disk_collisions", stats.disk_collisions},
          {"wall_collisions", stats.wall_collisions},
          {"events", s.last.events()},
          {"events_per_second", static_cast<double>(s.last.events()) / middle},
          {"peak_memory_bytes", s.memory},
          {"history_bytes", s.last.bytes},
          {"highest_bits", stats.highest_bits},
          {"goal_bits", stats.goal_bits},
          {"replays", stats.replays},
          {"ties", stats.ties},
          {"tiers", tiers_json(stats.tiers)}};
}

// The engine's timers nest: the searches include the updates of the queue that they cause, and
// those at t = 0 count as initial, too. So flips, collisions, moves and the rest make up the total.
nlohmann::ordered_json profile_json(const RunResult& run) {
  const EngineStats& s = run.stats;
  return {{"total", run.seconds},
          {"flips", s.flip_seconds},
          {"collisions", s.collision_seconds},
          {"move", s.move_seconds},
          {"rest", run.seconds - s.flip_seconds - s.collision_seconds - s.move_seconds},
          {"of these, queue", s.queue_seconds},
          {"of these, initial", s.initial_seconds}};
}

double per_event_microseconds(const Series& s) {
  return 1e6 * median(s.seconds) / static_cast<double>(s.last.events());
}

struct Ratios {
  double of_medians, of_cpu_medians;
  double median_of_pairs;
  double per_event;  // of microseconds an event: the two runs have different events
};

Ratios ratios_of(const Series& certified, const Series& plain) {
  std::vector<double> pairs;
  for (std::size_t r = 0; r < certified.seconds.size(); ++r) {
    pairs.push_back(certified.seconds[r] / plain.seconds[r]);
  }
  return {median(certified.seconds) / median(plain.seconds),
          median(certified.cpu_seconds) / median(plain.cpu_seconds), median(pairs),
          per_event_microseconds(certified) / per_event_microseconds(plain)};
}

void print_table(const Series& certified, const Series& plain, const Ratios& ratios,
                 std::uint64_t scene_memory) {
  const auto both = [&](const char* title, const char* format, auto&& value) {
    char cells[2][32];
    std::snprintf(cells[0], sizeof cells[0], format, value(certified));
    std::snprintf(cells[1], sizeof cells[1], format, value(plain));
    std::printf("%-28s %14s %14s\n", title, cells[0], cells[1]);
  };
  std::printf("%-28s %14s %14s\n", "", "certified", "plain");
  both("outcome", "%s", [](const Series& s) { return name_of(s.last.outcome.kind); });
  both("seconds, median", "%.3f", [](const Series& s) { return median(s.seconds); });
  both("CPU seconds, median", "%.3f", [](const Series& s) { return median(s.cpu_seconds); });
  both("flips", "%.0f", [](const Series& s) { return double(s.last.stats.flip_count()); });
  both("disk collisions", "%.0f",
       [](const Series& s) { return double(s.last.stats.disk_collisions); });
  both("wall collisions", "%.0f",
       [](const Series& s) { return double(s.last.stats.wall_collisions); });
  both("events a second", "%.0f",
       [](const Series& s) { return double(s.last.events()) / median(s.seconds); });
  both("microseconds an event", "%.2f", per_event_microseconds);
  both("peak memory, MB", "%.1f", [](const Series& s) { return double(s.memory) / kMegabyte; });
  both("history, MB", "%.1f", [](const Series& s) { return double(s.last.bytes) / kMegabyte; });
  std::printf("memory of the scene alone    %14.1f MB\n", double(scene_memory) / kMegabyte);
  std::printf("bits of the first states     %14d (goal at the horizon %d, replays %llu)\n",
              certified.last.stats.highest_bits, certified.last.stats.goal_bits,
              static_cast<unsigned long long>(certified.last.stats.replays));
  std::printf("ratio of the medians         %14.2f\n", ratios.of_medians);
  std::printf("median of the ratios         %14.2f\n", ratios.median_of_pairs);
  std::printf("ratio of CPU medians         %14.2f\n", ratios.of_cpu_medians);
  std::printf("ratio of times per event     %14.2f\n", ratios.per_event);
  if (certified.last.outcome.kind != Outcome::Kind::complete) {
    std::printf("stopped at %g: %s\n", certified.last.outcome.t,
                certified.last.outcome.reason.c_str());
  }
}

void print_profile(const RunResult& certified, const RunResult& plain) {
  const nlohmann::ordered_json a = profile_json(certified), b = profile_json(plain);
  std::printf("%-28s %14s %14s   (timers on: slower)\n", "profile, seconds", "certified", "plain");
  for (const auto& [key, value] : a.items()) {
    const double x = value.get<double>(), y = b[key].get<double>();
    std::printf("  %-26s %8.3f %4.0f%% %8.3f %4.0f%%\n", key.c_str(), x,
                100 * x / certified.seconds, y, 100 * y / plain.seconds);
  }
}

void print_tiers(const TierCounts& tiers) {
  std::printf("%-20s", "decided in tier");
  for (const auto name : tier_names) std::printf(" %14s", std::string(name).c_str());
  std::printf("\n");
  for (std::size_t p = 0; p < tiers.decided.size(); ++p) {
    std::printf("  %-18s", std::string(predicate_names[p]).c_str());
    for (const auto n : tiers.decided[p]) {
      std::printf(" %14llu", static_cast<unsigned long long>(n));
    }
    std::printf("\n");
  }
}

void bench(const SceneChoice& choice, int repeats, const std::string& json_path) {
  EngineOptions options;
  const std::uint64_t scene_memory = peak_memory(choice, EngineKind::none);
  Series certified, plain;
  certified.memory = peak_memory(choice, EngineKind::certified);
  plain.memory = peak_memory(choice, EngineKind::plain);

  const Scene scene = scene_of(choice);
  for (int r = 0; r < repeats; ++r) {
    // Whoever goes first alternates.
    const auto next = [&](bool exact) {
      Series& series = exact ? certified : plain;
      series.last = simulate(scene, exact, options);
      series.seconds.push_back(series.last.seconds);
      series.cpu_seconds.push_back(series.last.cpu_seconds);
    };
    next(r % 2 == 0);
    next(r % 2 != 0);
  }
  options.profile = true;
  const RunResult certified_profile = simulate(scene, true, options);
  const RunResult plain_profile = simulate(scene, false, options);

  const Ratios ratios = ratios_of(certified, plain);
  std::printf("n %d, seed %llu, horizon %g, density %g, radii %.10g to %.10g, %d repeats\n",
              choice.n, static_cast<unsigned long long>(choice.seed), choice.horizon,
              choice.density, choice.rmin, choice.rmax, repeats);
  print_table(certified, plain, ratios, scene_memory);
  print_profile(certified_profile, plain_profile);
  print_tiers(certified.last.stats.tiers);

  if (!json_path.empty()) {
    const nlohmann::ordered_json report{
        {"scene",
         {{"n", choice.n},
          {"seed", choice.seed},
          {"horizon", choice.horizon},
          {"density", choice.density},
          {"rmin", choice.rmin},
          {"rmax", choice.rmax}}},
        {"repeats", repeats},
        {"certified", series_json(certified)},
        {"plain", series_json(plain)},
        {"ratio_of_medians", ratios.of_medians},
        {"median_of_ratios", ratios.median_of_pairs},
        {"ratio_of_cpu_medians", ratios.of_cpu_medians},
        {"ratio_per_event", ratios.per_event},
        {"scene_memory_bytes", scene_memory},
        {"profile",
         {{"certified", profile_json(certified_profile)}, {"plain", profile_json(plain_profile)}}}};
    write_report(json_path, report);
  }
}

}  // namespace

}  // namespace voroproof::internal::bench

int main(int argc, char** argv) {
  voroproof::internal::bench::SceneChoice choice;
  int repeats = 5;
  std::string json;
  CLI::App app{"Whole runs, certified and in plain doubles, interleaved"};
  app.add_option("--n", choice.n, "number of disks")->check(CLI::PositiveNumber);
  app.add_option("--seed", choice.seed, "seed of the scene");
  app.add_option("--horizon", choice.horizon, "time simulated")->check(CLI::PositiveNumber);
  app.add_option("--density", choice.density, "area of the disks / area of the container")
      ->check(CLI::Range(0.0001, 0.6));
  app.add_option("--rmin", choice.rmin, "smallest radius")->check(CLI::PositiveNumber);
  app.add_option("--rmax", choice.rmax, "largest radius")->check(CLI::PositiveNumber);
  app.add_option("--repeats", repeats, "runs of each engine")->check(CLI::PositiveNumber);
  app.add_option("--json", json, "write the results to this file");
  CLI11_PARSE(app, argc, argv);
  try {
    voroproof::internal::bench::bench(choice, repeats, json);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return 0;
}
