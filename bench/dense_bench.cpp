// Dense scenes: whole runs beside what GMP takes for the long products of their collisions alone.
//
// A collision takes 5 squares, 9 products, a quotient and a root of numbers as long as its states
// (filtered/computed/fixed_collision.cpp; all other operands are short), and a state needs the bits
// that the collisions to come will lose. The bound is the time of these operations, on random
// numbers, of that many bits for each collision: nothing is read, bounded or kept.
#include <gmp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <random>
#include <vector>

#include "bench/report.h"
#include "bench/simulation.h"
#include "bench/statistics.h"
#include "library/maneuver_input.h"

namespace voroproof::internal::bench {

namespace {

class Collisions : public EventSink {
 public:
  void begin(const std::vector<Quad>&) override {}
  void flip(double, const Quad&) override {}
  void collide(double t, GenId, GenId, const RoundedState&, const RoundedState&) override {
    times_.push_back(t);
  }
  void maneuver(double, GenId, const RoundedState&) override {}

  const std::vector<double>& times() const { return times_; }

 private:
  std::vector<double> times_;
};

// The seconds of the long operations of one collision, on numbers of so many limbs.
double seconds_of_products(mp_size_t limbs) {
  std::mt19937_64 random(1);
  std::vector<mp_limb_t> a(limbs), b(limbs), twice(2 * limbs), q(2 * limbs), rest(limbs);
  for (auto* v : {&a, &b, &twice}) std::generate(v->begin(), v->end(), std::ref(random));
  b.back() |= mp_limb_t{1} << 63;
  const auto collide = [&] {
    for (int k = 0; k < 5; ++k) mpn_sqr(q.data(), a.data(), limbs);
    for (int k = 0; k < 9; ++k) mpn_mul_n(q.data(), a.data(), b.data(), limbs);
    mpn_tdiv_qr(q.data(), rest.data(), 0, twice.data(), 2 * limbs, b.data(), limbs);
    mpn_sqrtrem(q.data(), nullptr, twice.data(), 2 * limbs);
  };
  const int repeats = static_cast<int>(std::max<mp_size_t>(4, 20000 / limbs));
  std::vector<double> seconds;
  for (int k = 0; k < 5; ++k) {
    seconds.push_back(seconds_of([&] {
      for (int r = 0; r < repeats; ++r) collide();
    }));
  }
  return *std::min_element(seconds.begin(), seconds.end()) / repeats;
}

nlohmann::ordered_json bench(const SceneChoice& choice, int repeats) {
  const Scene scene = scene_of(choice);
  std::vector<double> runs, bounds;
  std::size_t collisions = 0;
  int bits = 0;
  std::uint64_t replays = 0;
  for (int k = 0; k < repeats; ++k) {
    EngineOptions options;
    Engine engine(motion_input(scene), {}, options);
    Collisions sink;
    runs.push_back(seconds_of([&] {
      if (engine.run(sink).kind != Outcome::Kind::complete) throw std::runtime_error("it stopped");
    }));
    const EngineStats& stats = engine.stats();
    collisions = sink.times().size();
    bits = stats.highest_bits;
    replays = stats.replays;
    std::map<mp_size_t, std::size_t> by_limbs;
    for (const double t : sink.times()) {
      const double lost = (stats.highest_bits - stats.goal_bits) * (1 - t / choice.horizon);
      ++by_limbs[static_cast<mp_size_t>((stats.goal_bits + lost) / 64) + 1];
    }
    double bound = 0;
    for (const auto& [limbs, count] : by_limbs) {
      bound += static_cast<double>(count) * seconds_of_products(limbs);
    }
    bounds.push_back(bound);
  }
  const double run = median(runs), bound = median(bounds);
  std::printf("%6d %8g %8g %11zu %7d %8llu %9.3f %9.3f %7.2f\n", choice.n, choice.density,
              choice.horizon, collisions, bits, static_cast<unsigned long long>(replays), run,
              bound, run / bound);
  std::fflush(stdout);
  return {{"n", choice.n},
          {"density", choice.density},
          {"horizon", choice.horizon},
          {"collisions", collisions},
          {"bits", bits},
          {"replays", replays},
          {"seconds", run},
          {"bound", bound}};
}

}  // namespace

}  // namespace voroproof::internal::bench

int main(int argc, char** argv) {
  CLI::App app("Dense scenes beside the products of their collisions");
  voroproof::internal::bench::SceneChoice choice;
  choice.n = 20;
  choice.density = 0.3;
  std::vector<double> horizons{500, 1000, 2000, 4000, 6000};
  int repeats = 5;
  std::string path;
  app.add_option("--n", choice.n)->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--seed", choice.seed)->capture_default_str();
  app.add_option("--density", choice.density)->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--horizons", horizons, "times simulated");
  app.add_option("--repeats", repeats)->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--json", path, "write the results to this file");
  CLI11_PARSE(app, argc, argv);
  try {
    std::printf("seconds of one thread, medians of %d\n", repeats);
    std::printf("%6s %8s %8s %11s %7s %8s %9s %9s %7s\n", "n", "density", "horizon", "collisions",
                "bits", "replays", "run", "products", "ratio");
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const double horizon : horizons) {
      choice.horizon = horizon;
      rows.push_back(voroproof::internal::bench::bench(choice, repeats));
    }
    if (!path.empty()) voroproof::internal::bench::write_report(path, {{"rows", rows}});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
