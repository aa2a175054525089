// A small scene's diagram at every event, by CGAL: the peer of a kinetic engine is to build
// Apollonius_graph_2 anew, and this tells what that costs beside the exact engine and the plain
// one.
#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_filtered_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/report.h"
#include "bench/simulation.h"
#include "bench/statistics.h"
#include "library/maneuver_input.h"

namespace voroproof::internal::bench {

namespace {

// Predicates are exact behind CGAL's interval filter.
using Traits = CGAL::Apollonius_graph_filtered_traits_2<CGAL::Simple_cartesian<double>>;
using Graph = CGAL::Apollonius_graph_2<Traits>;

// The disks at any time, by what a history tells of them.
class Positions : public EventSink {
 public:
  struct State {
    double t, x, y, vx, vy, r;
  };
  struct Change {
    double t;  // of the event
    int disk;  // or -1, for a flip
    State state;
  };

  explicit Positions(const Scene& scene) {
    for (const DiskInput& d : scene.disks) {
      initial_.push_back({0, round_nearest(d.x), round_nearest(d.y), round_nearest(d.vx),
                          round_nearest(d.vy), round_nearest(d.radius)});
    }
  }
  void begin(const std::vector<Quad>&) override {}
  void flip(double t, const Quad&) override { changes_.push_back({t, -1, {}}); }
  void collide(double t, GenId i, GenId j, const RoundedState& first,
               const RoundedState& second) override {
    if (i != container_id) change(t, i, first);
    change(t, j, second);
  }
  void maneuver(double t, GenId disk, const RoundedState& s) override { change(t, disk, s); }

  const std::vector<State>& initial() const { return initial_; }
  const std::vector<Change>& changes() const { return changes_; }

 private:
  void change(double t, GenId g, const RoundedState& s) {
    changes_.push_back({t, g, {t, s.px, s.py, s.vx, s.vy, initial_[g].r}});
  }

  std::vector<State> initial_;
  std::vector<Change> changes_;
};

// Builds the graph of the disks at each event, without the container, which CGAL does not know;
// returns how many graphs that were.
std::size_t rebuild(const Positions& positions) {
  std::vector<Positions::State> now = positions.initial();
  std::vector<Graph::Site_2> sites;
  std::size_t graphs = 0, vertices = 0;
  for (const Positions::Change& change : positions.changes()) {
    if (change.disk >= 0) now[change.disk] = change.state;
    sites.clear();
    for (const Positions::State& s : now) {
      const double dt = change.t - s.t;
      sites.emplace_back(Graph::Point_2(s.x + s.vx * dt, s.y + s.vy * dt), s.r);
    }
    Graph graph;
    graph.insert(sites.begin(), sites.end());
    vertices += graph.number_of_vertices();
    ++graphs;
  }
  if (vertices != graphs * now.size()) throw std::logic_error("CGAL hides disks");
  return graphs;
}

void bench(const SceneChoice& choice, int repeats, const std::string& path) {
  const Scene scene = scene_of(choice);
  Positions positions(scene);
  Engine engine(motion_input(scene), maneuver_input(scene), {});
  if (engine.run(positions).kind != Outcome::Kind::complete) {
    throw std::runtime_error("the scene's run does not reach its horizon");
  }
  std::vector<double> certified, plain, cgal;
  std::size_t graphs = 0;
  for (int r = 0; r < repeats; ++r) {
    certified.push_back(simulate(scene, true).seconds);
    plain.push_back(simulate(scene, false).seconds);
    cgal.push_back(seconds_of([&] { graphs = rebuild(positions); }));
  }
  const double ratio = median(cgal) / median(certified);
  std::printf("n %d, horizon %g: %zu graphs, %d repeats; seconds, medians\n", choice.n,
              choice.horizon, graphs, repeats);
  std::printf("certified %.4f, plain %.4f, CGAL anew at every event %.4f: %.0f times certified\n",
              median(certified), median(plain), median(cgal), ratio);
  if (path.empty()) return;
  const nlohmann::ordered_json report{
      {"n", choice.n},        {"horizon", choice.horizon},      {"density", choice.density},
      {"graphs", graphs},     {"certified_seconds", certified}, {"plain_seconds", plain},
      {"cgal_seconds", cgal}, {"cgal_by_certified", ratio}};
  write_report(path, report);
}

}  // namespace

}  // namespace voroproof::internal::bench

int main(int argc, char** argv) {
  voroproof::internal::bench::SceneChoice choice;
  choice.n = 100;
  choice.horizon = 100;
  int repeats = 5;
  std::string json;
  CLI::App app{"A diagram at every event: kinetic, or built anew by CGAL"};
  app.add_option("--n", choice.n, "number of disks")->check(CLI::Range(3, 100000));
  app.add_option("--seed", choice.seed, "seed of the scene");
  app.add_option("--horizon", choice.horizon, "time simulated")->check(CLI::PositiveNumber);
  app.add_option("--density", choice.density, "area of the disks / area of the container")
      ->check(CLI::Range(0.0001, 0.6));
  app.add_option("--repeats", repeats, "of each")->check(CLI::PositiveNumber);
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
