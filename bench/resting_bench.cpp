// The diagram of disks at rest beside CGAL's Apollonius graphs: what a disk costs, one thread.
#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_filtered_traits_2.h>
#include <CGAL/Apollonius_graph_hierarchy_2.h>
#include <CGAL/Simple_cartesian.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/report.h"
#include "bench/simulation.h"
#include "bench/statistics.h"
#include "voroproof/static_diagram.h"

namespace voroproof::internal::bench {

namespace {

// Predicates are exact behind CGAL's interval filter.
using Traits = CGAL::Apollonius_graph_filtered_traits_2<CGAL::Simple_cartesian<double>>;
using Graph = CGAL::Apollonius_graph_2<Traits>;
using Hierarchy = CGAL::Apollonius_graph_hierarchy_2<Traits>;

// Disks in a square, a few of which overlap; `hidden` of them lie in others.
std::vector<Circle> disks_of(int n, double hidden) {
  std::mt19937_64 random(1);
  const auto part = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const double side = std::sqrt(static_cast<double>(n));
  const int outer = std::max(1, static_cast<int>(n * (1 - hidden)));
  std::vector<Circle> disks;
  for (int k = 0; k < outer; ++k) {
    const double x = side * part(), y = side * part();
    disks.push_back({{x, y}, 0.4 * part()});
  }
  while (static_cast<int>(disks.size()) < n) {
    const Circle host = disks[static_cast<std::size_t>(outer * part())];
    const double off = 0.5 * host.radius, x = off * (part() - 0.5), y = off * (part() - 0.5);
    disks.push_back({{host.center[0] + x, host.center[1] + y}, 0.4 * host.radius * part()});
  }
  std::shuffle(disks.begin(), disks.end(), random);
  return disks;
}

nlohmann::ordered_json bench(int n, double hidden, int repeats, int graph_up_to) {
  const std::vector<Circle> disks = disks_of(n, hidden);
  std::vector<Graph::Site_2> sites;
  for (const Circle& d : disks)
    sites.emplace_back(Graph::Point_2(d.center[0], d.center[1]), d.radius);
  std::vector<double> own, graph, hierarchy;
  for (int k = 0; k < repeats; ++k) {
    std::size_t visible = 0;
    own.push_back(seconds_of([&] {
      const StaticDiagram all(disks);
      for (const int host : all.hosts()) visible += host == StaticDiagram::visible ? 1 : 0;
    }));
    hierarchy.push_back(seconds_of([&] {
      const Hierarchy all(sites.begin(), sites.end());
      if (all.number_of_visible_sites() != visible) throw std::logic_error("other hidden disks");
    }));
    if (n > graph_up_to) continue;
    graph.push_back(seconds_of([&] {
      const Graph all(sites.begin(), sites.end());
      if (all.number_of_visible_sites() != visible) throw std::logic_error("other hidden disks");
    }));
  }
  const auto each = [&](const std::vector<double>& seconds) {
    return seconds.empty() ? 0.0 : 1e6 * median(seconds) / n;
  };
  std::printf("%9d %7.0f%% %9.2f %9.2f %9.2f\n", n, 100 * hidden, each(own), each(graph),
              each(hierarchy));
  std::fflush(stdout);
  return {{"n", n},
          {"hidden", hidden},
          {"us_per_disk", each(own)},
          {"graph_us_per_disk", each(graph)},
          {"hierarchy_us_per_disk", each(hierarchy)}};
}

}  // namespace

}  // namespace voroproof::internal::bench

int main(int argc, char** argv) {
  CLI::App app("The diagram of disks at rest beside CGAL's");
  std::vector<int> sizes{1000, 10000, 100000, 1000000};
  std::vector<double> hidden{0, 0.1, 0.6};
  int repeats = 3, graph_up_to = 100000;
  std::string path;
  app.add_option("--sizes", sizes, "numbers of disks")->check(CLI::PositiveNumber);
  app.add_option("--hidden", hidden, "parts of them that are hidden")->check(CLI::Range(0.0, 0.9));
  app.add_option("--repeats", repeats)->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--graph-up-to", graph_up_to, "more disks are not asked of the plain graph")
      ->capture_default_str();
  app.add_option("--json", path, "write the results to this file");
  CLI11_PARSE(app, argc, argv);
  try {
    std::printf("microseconds a disk, medians of %d\n", repeats);
    std::printf("%9s %8s %9s %9s %9s\n", "n", "hidden", "own", "graph", "hierarchy");
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const int n : sizes) {
      for (const double part : hidden) {
        rows.push_back(voroproof::internal::bench::bench(n, part, repeats, graph_up_to));
      }
    }
    if (!path.empty()) voroproof::internal::bench::write_report(path, {{"rows", rows}});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
