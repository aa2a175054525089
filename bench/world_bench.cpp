// Disks that pass through each other and grow, in the plane: what the exact engine and the
// certifier take. The peer is to build CGAL's Apollonius_graph_2 anew at every event; some of these
// are built, and the others thought to take as long.
#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_filtered_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/report.h"
#include "bench/statistics.h"
#include "certify/world/world_certifier.h"
#include "engine/world/world_run.h"

namespace voroproof::internal::bench {

namespace {

using Traits = CGAL::Apollonius_graph_filtered_traits_2<CGAL::Simple_cartesian<double>>;
using Graph = CGAL::Apollonius_graph_2<Traits>;

struct Choice {
  int n = 1000, samples = 20, repeats = 3;
  unsigned seed = 1;
  double horizon = 10;
};

// Radii from 0.1 to 2 that grow by up to a twentieth, speeds up to 1 in each direction; a hundred
// units of area for each disk.
World random_world(const Choice& choice) {
  std::mt19937_64 random(choice.seed);
  const auto uniform = [&](double lo, double hi) {
    return to_rational(std::uniform_real_distribution<double>(lo, hi)(random));
  };
  const double side = 10 * std::sqrt(choice.n);
  World world;
  world.horizon = to_rational(choice.horizon);
  for (int i = 0; i < choice.n; ++i) {
    const Rational x = uniform(0, side), y = uniform(0, side), r = uniform(0.1, 2);
    const Rational vx = uniform(-1, 1), vy = uniform(-1, 1), growth = uniform(0, 0.05);
    world.disks.push_back({0, {}, {x, y, r, vx, vy, growth}});
  }
  return world;
}

class Recorder final : public WorldSink {
 public:
  void begin(const std::vector<Quad>& edges) override { initial = edges; }
  void event(const WorldEvent& event) override { events.push_back(event); }

  std::vector<Quad> initial;
  std::vector<WorldEvent> events;
};

Recorder run(const World& world) {
  Recorder history;
  if (run_world(world.motion(), {}, history).kind != WorldOutcome::Kind::complete) {
    throw std::runtime_error("the run does not reach its horizon");
  }
  return history;
}

void certify(const World& world, const Recorder& history) {
  WorldCertifier certifier(world, history.initial);
  WorldEnd end;
  for (const WorldEvent& event : history.events) {
    end.counts.add(event);
    certifier.event(event, 0);
  }
  if (certifier.finish(end).kind != Verdict::certified) throw std::runtime_error("not certified");
}

// The seconds of one graph, the mean of some at times of events.
double graph_seconds(const World& world, const std::vector<WorldEvent>& events, int samples) {
  return seconds_of([&] {
           for (int k = 0; k < samples; ++k) {
             const std::size_t at = events.size() * static_cast<std::size_t>(k) / samples;
             const double t = round_nearest(events.at(at).t);
             std::vector<Graph::Site_2> sites;
             for (const WorldDisk& d : world.disks) {
               const GrowingDisk& s = d.state;
               const auto line = [t](const Rational& x, const Rational& v) {
                 return round_nearest(x) + round_nearest(v) * t;
               };
               sites.emplace_back(Graph::Point_2(line(s.x, s.vx), line(s.y, s.vy)),
                                  line(s.radius, s.growth));
             }
             Graph graph;
             graph.insert(sites.begin(), sites.end());
             if (graph.number_of_vertices() == 0) throw std::logic_error("CGAL hides all disks");
           }
         }) /
         samples;
}

void bench(const Choice& choice, const std::string& path) {
  const World world = random_world(choice);
  const Recorder history = run(world);
  if (history.events.empty()) throw std::runtime_error("nothing happens: a longer horizon");
  std::vector<double> engine, certifier, cgal;
  for (int r = 0; r < choice.repeats; ++r) {
    engine.push_back(seconds_of([&] { run(world); }));
    certifier.push_back(seconds_of([&] { certify(world, history); }));
    cgal.push_back(graph_seconds(world, history.events, choice.samples) *
                   static_cast<double>(history.events.size()));
  }
  const double ratio = median(cgal) / median(engine);
  std::printf("n %d, horizon %g: %zu events; seconds, medians of %d\n", choice.n, choice.horizon,
              history.events.size(), choice.repeats);
  std::printf("engine %.3f, certifier %.3f, CGAL anew at every event %.3f: %.1f times the engine\n",
              median(engine), median(certifier), median(cgal), ratio);
  if (path.empty()) return;
  const nlohmann::ordered_json report{{"n", choice.n},
                                      {"horizon", choice.horizon},
                                      {"events", history.events.size()},
                                      {"engine_seconds", engine},
                                      {"certifier_seconds", certifier},
                                      {"cgal_seconds", cgal},
                                      {"cgal_by_engine", ratio}};
  write_report(path, report);
}

}  // namespace

}  // namespace voroproof::internal::bench

int main(int argc, char** argv) {
  voroproof::internal::bench::Choice choice;
  std::string json;
  CLI::App app{"Disks that pass and grow: the exact engine, the certifier, CGAL anew"};
  app.add_option("--n", choice.n, "number of disks")->check(CLI::Range(3, 1000000));
  app.add_option("--seed", choice.seed, "seed of the world");
  app.add_option("--horizon", choice.horizon, "time simulated")->check(CLI::PositiveNumber);
  app.add_option("--samples", choice.samples, "graphs that are built")->check(CLI::PositiveNumber);
  app.add_option("--repeats", choice.repeats, "of each")->check(CLI::PositiveNumber);
  app.add_option("--json", json, "write the results to this file");
  CLI11_PARSE(app, argc, argv);
  try {
    voroproof::internal::bench::bench(choice, json);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return 0;
}
