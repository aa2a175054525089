// Measures the paper's six ways (section 6) from a history to the diagram at an instant: one table
// for a history file that exists, and the diagrams compared.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/statistics.h"
#include "history/history_reader.h"
#include "library/snapshot.h"

namespace voroproof::internal::bench {

namespace {

std::uint64_t events_up_to(const Scene& scene, const std::string& path, const Rational& t) {
  HistoryReader history(path, static_cast<int>(scene.disks.size()));
  std::uint64_t events = 0;
  while (const auto event = history.next()) events += exact_time(*event) <= t;
  return events;
}

bool same(const DiagramFile& a, const DiagramFile& b) {
  if (a.edges != b.edges || a.disks.size() != b.disks.size()) return false;
  for (std::size_t i = 0; i < a.disks.size(); ++i) {
    if (a.disks[i].center != b.disks[i].center) return false;
  }
  return true;
}

// Whether all ways gave the same.
bool bench(const std::string& scene_path, const std::string& history, int instants, int repeats,
           const std::string& path) {
  const Scene scene = read_scene(scene_path);
  const Rational horizon =
      HistoryReader(history, static_cast<int>(scene.disks.size())).header().horizon;
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  bool all_same = true;
  std::printf("n = %zu, median milliseconds of %d\n", scene.disks.size(), repeats);
  std::printf("%12s %9s %9s %9s %9s %9s %9s %9s\n", "t", "events", "M1 C1", "M1 C2", "M2 C1",
              "M2 C2", "M3 C1", "M3 C2");
  for (int k = 0; k <= instants; ++k) {
    const Rational t = horizon * k / instants;
    const std::uint64_t events = events_up_to(scene, history, t);
    nlohmann::ordered_json row{{"t", t.get_d()}, {"events", events}};
    std::printf("%12g %9llu", t.get_d(), static_cast<unsigned long long>(events));
    const DiagramFile expected = snapshot(scene, history, t);
    for (const int move : {1, 2, 3}) {
      for (const int construct : {1, 2}) {
        std::vector<double> seconds;
        for (int r = 0; r < repeats; ++r) {
          seconds.push_back(seconds_of([&] {
            all_same &= same(
                expected, snapshot(scene, history, t, {},
                                   {static_cast<Move>(move), static_cast<Construct>(construct)}));
          }));
        }
        const double middle = median(seconds);
        row["move_" + std::to_string(move) + "_construct_" + std::to_string(construct)] = middle;
        std::printf(" %9.2f", 1e3 * middle);
        std::fflush(stdout);
      }
    }
    std::printf("\n");
    rows.push_back(row);
  }
  std::printf("%s\n", all_same ? "all ways give the same" : "THE WAYS DIFFER");
  if (!path.empty()) std::ofstream(path) << rows.dump(1) << '\n';
  return all_same;
}

}  // namespace

}  // namespace voroproof::internal::bench

int main(int argc, char** argv) {
  CLI::App app("The six ways from a history to a diagram");
  std::string scene, history, path;
  int instants = 4, repeats = 3;
  app.add_option("scene", scene)->required();
  app.add_option("history", history)->required();
  app.add_option("--instants", instants)->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--repeats", repeats)->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--json", path, "write the results to this file");
  CLI11_PARSE(app, argc, argv);
  try {
    return voroproof::internal::bench::bench(scene, history, instants, repeats, path) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
