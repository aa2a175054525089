// A run in slices (docs/design/engine.md, "Slices") on more cores than a machine has: the slices
// are made one after the other on one thread, and the CPU time that each of their parts takes is
// dealt out as the run deals out its work. What it leaves out: that cores share their memory and
// caches, and the threads that tell and write the history, which are further ones.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bench/report.h"
#include "bench/simulation.h"
#include "bench/statistics.h"
#include "engine/engine.h"
#include "engine/event_sink.h"
#include "engine/follower.h"
#include "engine/leader.h"
#include "engine/slice.h"
#include "library/maneuver_input.h"

namespace voroproof::internal::bench {

namespace {

double thread_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// What one slice takes, in seconds of CPU.
struct Cost {
  double lead = 0, construct = 0, follow = 0;
};

double one_thread(const Scene& scene, const EngineOptions& options) {
  const double start = thread_cpu_seconds();
  Engine engine(motion_input(scene), maneuver_input(scene), options);
  NoSink sink;
  if (engine.run(sink).kind != Outcome::Kind::complete) {
    throw std::runtime_error("the run is not complete");
  }
  return thread_cpu_seconds() - start;
}

// The slices of a run with so many threads.
std::vector<Cost> costs_of(const Scene& scene, const EngineOptions& options, int threads) {
  Leader leader(motion_input(scene), maneuver_input(scene), options.motion);
  if (!leader.possible()) throw std::runtime_error("the scene is none for slices");
  const ComputedMotion& leaders = leader.motion();
  ComputedMotion motion(leaders.input(), leaders.options(), leaders.log());
  std::vector<Cost> costs;
  double begin = 0;
  for (bool is_last = false; !is_last;) {
    Cost cost;
    const MotionSnapshot start = leader.motion().snapshot();
    LedTurns turns;
    const double t0 = thread_cpu_seconds();
    const std::uint64_t work =
        work_of_slice(static_cast<int>(costs.size()), leader.work_ahead(), leaders.size(), threads);
    const std::optional<double> border = leader.lead(turns, work, nullptr);
    const double t1 = thread_cpu_seconds();
    cost.lead = t1 - t0;
    motion.follow(start);
    Follower follower(motion, begin, false);
    follower.construct();
    const double t2 = thread_cpu_seconds();
    cost.construct = t2 - t1;
    Chunk chunk;
    follower.settle(turns, border ? to_rational(*border) : leaders.input().horizon);
    follower.run(chunk, [&] { chunk.end_instant(); });
    cost.follow = thread_cpu_seconds() - t2;
    costs.push_back(cost);
    is_last = !border;
    if (border) begin = *border;
  }
  return costs;
}

// A run on a core for each thread, with these costs.
class Schedule {
 public:
  Schedule(std::vector<Cost> costs, int threads) : costs_(std::move(costs)), threads_(threads) {
    slices_.push_back({});
    idle_ = threads;
  }

  // When all is done.
  double end() {
    deal();
    while (!running_.empty()) {
      const Running r = *running_.begin();
      running_.erase(running_.begin());
      now_ = r.end;
      finish(r);
      deal();
    }
    if (first_ != costs_.size()) throw std::logic_error("a schedule that does not end");
    return now_;
  }

 private:
  struct State {
    bool led = false, taken = false, done = false;
    double constructed = std::numeric_limits<double>::infinity();
  };
  struct Running {
    double end;
    std::size_t slice;
    bool leads;
    bool operator<(const Running& o) const {
      return std::tie(end, slice, leads) < std::tie(o.end, o.slice, o.leads);
    }
  };

  // The slices that exist are those from first_ on; those before it are told.
  void deal() {
    while (idle_ > 0 && take()) --idle_;
  }
  bool take() {
    const auto state = [this](std::size_t k) -> State& { return slices_[first_ + k]; };
    const SliceWork work = next_work(
        slices_.size() - first_, [&](std::size_t k) { return state(k).led; },
        [&](std::size_t k) { return state(k).taken; }, threads_, !leads_ && !slices_.back().led,
        true);
    const std::size_t k = first_ + work.slice;
    if (work.kind == SliceWork::Kind::lead) {
      leads_ = true;
      running_.insert({now_ + costs_[k].lead, k, true});
    } else if (work.kind == SliceWork::Kind::follow) {
      slices_[k].taken = true;
      slices_[k].constructed = now_ + costs_[k].construct;
      if (slices_[k].led) follow(k);
    }
    return work.kind != SliceWork::Kind::none;
  }
  void follow(std::size_t k) {
    running_.insert({std::max(now_, slices_[k].constructed) + costs_[k].follow, k, false});
  }
  void finish(const Running& r) {
    ++idle_;
    State& s = slices_[r.slice];
    if (r.leads) {
      leads_ = false;
      s.led = true;
      if (s.taken) follow(r.slice);
      if (slices_.size() < costs_.size()) slices_.push_back({});
    } else {
      s.done = true;
      while (first_ < slices_.size() && slices_[first_].done) ++first_;
    }
  }

  std::vector<Cost> costs_;
  int threads_, idle_ = 0;
  std::vector<State> slices_;
  std::size_t first_ = 0;
  std::set<Running> running_;
  bool leads_ = false;
  double now_ = 0;
};

void bench(const SceneChoice& choice, const std::vector<int>& all_threads, int repeats,
           const std::string& json_path) {
  const Scene scene = scene_of(choice);
  EngineOptions options;
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  std::printf("n %d, horizon %g, density %g: medians of %d\n", choice.n, choice.horizon,
              choice.density, repeats);
  std::printf("%8s %8s %12s %12s %12s %12s %10s\n", "threads", "slices", "CPU / one's", "leading",
              "diagrams", "bound", "speed-up");
  for (const int threads : all_threads) {
    std::size_t slices = 0;
    std::vector<double> cpu, leading, constructing, speed;
    for (int r = 0; r < repeats; ++r) {
      const double whole = one_thread(scene, options);
      const std::vector<Cost> costs = costs_of(scene, options, threads);
      slices = costs.size();
      Cost sum;
      for (const Cost& c : costs) {
        sum.lead += c.lead;
        sum.construct += c.construct;
        sum.follow += c.follow;
      }
      cpu.push_back((sum.lead + sum.construct + sum.follow) / whole);
      leading.push_back(sum.lead / whole);
      constructing.push_back(sum.construct / whole);
      speed.push_back(whole / Schedule(costs, threads).end());
    }
    // Leading is one thread's, and no more than all is done by all.
    const double bound = std::min(1 / median(leading), threads / median(cpu));
    std::printf("%8d %8zu %12.3f %12.3f %12.3f %12.2f %10.2f\n", threads, slices, median(cpu),
                median(leading), median(constructing), bound, median(speed));
    std::fflush(stdout);
    rows.push_back({{"threads", threads},
                    {"slices", slices},
                    {"cpu", median(cpu)},
                    {"leading", median(leading)},
                    {"diagrams", median(constructing)},
                    {"bound", bound},
                    {"speed_up", median(speed)}});
  }
  if (json_path.empty()) return;
  write_report(json_path, {{"n", choice.n},
                           {"horizon", choice.horizon},
                           {"density", choice.density},
                           {"repeats", repeats},
                           {"rows", rows}});
}

}  // namespace

}  // namespace voroproof::internal::bench

int main(int argc, char** argv) {
  voroproof::internal::bench::SceneChoice choice;
  std::vector<int> threads{1, 2, 4, 8, 16, 32, 64};
  int repeats = 3;
  std::string json;
  CLI::App app{"What a run in slices would take on many cores"};
  app.add_option("--n", choice.n, "number of disks")->check(CLI::PositiveNumber);
  app.add_option("--seed", choice.seed, "seed of the scene");
  app.add_option("--horizon", choice.horizon, "time simulated")->check(CLI::PositiveNumber);
  app.add_option("--density", choice.density, "area of the disks / area of the container")
      ->check(CLI::Range(0.0001, 0.6));
  app.add_option("--threads", threads, "numbers of threads")->check(CLI::PositiveNumber);
  app.add_option("--repeats", repeats, "runs of each")->check(CLI::PositiveNumber);
  app.add_option("--json", json, "write the results to this file");
  CLI11_PARSE(app, argc, argv);
  try {
    voroproof::internal::bench::bench(choice, threads, repeats, json);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return 0;
}
