// The diagram from scratch beside CGAL's Delaunay triangulation of the centres and its Apollonius
// graph of the disks: what a disk costs, one thread.
#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_filtered_traits_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/report.h"
#include "bench/simulation.h"
#include "bench/statistics.h"
#include "engine/static_diagram.h"
#include "library/maneuver_input.h"

namespace voroproof::internal::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;
// Predicates are exact behind CGAL's interval filter.
using Traits = CGAL::Apollonius_graph_filtered_traits_2<CGAL::Simple_cartesian<double>>;
using Graph = CGAL::Apollonius_graph_2<Traits>;

// All have the disks in memory; neither of the peers knows the container.
nlohmann::ordered_json bench(const SceneChoice& choice, int repeats, int graph_up_to) {
  const Scene scene = scene_of(choice);
  const ComputedMotion motion(motion_input(scene), {});
  std::vector<Kernel::Point_2> points;
  std::vector<Graph::Site_2> sites;
  for (GenId g = 0; g < motion.size(); ++g) {
    const DoubleMotion& m = motion.doubles(g);
    points.emplace_back(m.x, m.y);
    sites.emplace_back(Graph::Point_2(m.x, m.y), m.r);
  }
  std::vector<double> own, delaunay, apollonius;
  TierCounts counts;
  for (int k = 0; k < repeats; ++k) {
    own.push_back(seconds_of([&] {
      counts = {};
      if (static_diagram(motion, 0, counts).disks() != motion.size()) throw std::logic_error("n");
    }));
    delaunay.push_back(seconds_of([&] {
      const Delaunay all(points.begin(), points.end());
      if (all.number_of_vertices() != points.size()) throw std::logic_error("a point is lost");
    }));
    if (choice.n > graph_up_to) continue;
    apollonius.push_back(seconds_of([&] {
      const Graph all(sites.begin(), sites.end());
      if (all.number_of_visible_sites() != sites.size()) throw std::logic_error("a disk is lost");
    }));
  }
  const auto each = [&](const std::vector<double>& seconds) {
    return seconds.empty() ? 0.0 : 1e6 * median(seconds) / choice.n;
  };
  double decisions = 0;
  for (const std::uint64_t k : counts.decided[static_cast<int>(Predicate::incircle)]) {
    decisions += static_cast<double>(k);
  }
  std::printf("%9d %9.2f %9.2f %9.2f %9.2f\n", choice.n, each(own), each(delaunay),
              each(apollonius), decisions / choice.n);
  std::fflush(stdout);
  return {{"n", choice.n},
          {"us_per_disk", each(own)},
          {"delaunay_us_per_disk", each(delaunay)},
          {"apollonius_us_per_disk", each(apollonius)},
          {"decisions", tiers_json(counts)}};
}

}  // namespace

}  // namespace voroproof::internal::bench

int main(int argc, char** argv) {
  CLI::App app("The first diagram beside CGAL's");
  std::vector<int> sizes{1000, 10000, 100000, 1000000};
  int repeats = 3, graph_up_to = 100000;
  voroproof::internal::bench::SceneChoice choice;
  std::string path;
  app.add_option("--sizes", sizes, "numbers of disks")->check(CLI::PositiveNumber);
  app.add_option("--density", choice.density)->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--repeats", repeats)->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--graph-up-to", graph_up_to, "more disks are not asked of the Apollonius graph")
      ->capture_default_str();
  app.add_option("--json", path, "write the results to this file");
  CLI11_PARSE(app, argc, argv);
  try {
    std::printf("microseconds a disk, medians of %d\n", repeats);
    std::printf("%9s %9s %9s %9s %9s\n", "n", "own", "Delaunay", "graph", "decisions");
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const int n : sizes) {
      choice.n = n;
      rows.push_back(voroproof::internal::bench::bench(choice, repeats, graph_up_to));
    }
    if (!path.empty()) voroproof::internal::bench::write_report(path, {{"rows", rows}});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
