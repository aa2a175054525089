#include "bench/simulation.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "apps/run/history_sink.h"
#include "bench/plain_engine.h"
#include "bench/statistics.h"
#include "corpus/generate.h"
#include "history/history_writer.h"
#include "library/maneuver_input.h"

namespace voroproof::internal::bench {

namespace {

double cpu_seconds_since(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// Removes its file at the end, also when a run throws.
class TemporaryFile {
 public:
  TemporaryFile()
      : path_(std::filesystem::temp_directory_path() /
              ("voroproof-bench-" + std::to_string(getpid()) + ".history.jsonl")) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  std::string path() const { return path_.string(); }
  std::uint64_t size() const { return std::filesystem::file_size(path_); }

 private:
  std::filesystem::path path_;
};

// Notes when the engine hands over the first diagram.
class TimedSink : public EventSink {
 public:
  explicit TimedSink(EventSink& next) : next_(next) {}
  void begin(const std::vector<Quad>& initial) override {
    begun_ = std::clock();
    next_.begin(initial);
  }
  void flip(double t, const Quad& edge) override { next_.flip(t, edge); }
  void collide(double t, GenId i, GenId j, const RoundedState& first,
               const RoundedState& second) override {
    next_.collide(t, i, j, first, second);
  }
  void maneuver(double t, GenId disk, const RoundedState& state) override {
    next_.maneuver(t, disk, state);
  }
  std::clock_t begun() const { return begun_; }

 private:
  EventSink& next_;
  std::clock_t begun_ = std::clock();
};

template <class AnEngine>
RunResult run(const Scene& scene, const EngineOptions& options) {
  const TemporaryFile file;
  RunResult result;
  const std::clock_t cpu_start = std::clock();
  const auto start = Clock::now();
  {
    AnEngine engine(motion_input(scene), maneuver_input(scene), options);
    HistoryWriter writer(file.path());
    // The scene exists in memory only: its fingerprint stands for none.
    BackgroundHistorySink history(
        writer, {std::string(64, '0'), scene.horizon, "voroproof-bench 1", std::nullopt},
        static_cast<int>(scene.disks.size()));
    TimedSink sink(history);
    result.outcome = engine.run(sink);
    history.finish();
    if (result.outcome.kind == Outcome::Kind::complete) {
      writer.end();
    } else {
      writer.stopped(result.outcome.t, result.outcome.reason, {});
    }
    writer.close();
    result.loop_cpu_seconds = cpu_seconds_since(sink.begun());
    result.stats = engine.stats();
  }
  result.seconds = seconds_since(start);
  result.cpu_seconds = cpu_seconds_since(cpu_start);
  result.bytes = file.size();
  return result;
}

}  // namespace

Scene scene_of(const SceneChoice& choice) {
  ReferenceOptions o;
  o.n = choice.n;
  o.seed = choice.seed;
  o.horizon = choice.horizon;
  o.density = choice.density;
  o.rmin = choice.rmin;
  o.rmax = choice.rmax;
  return generate_reference(o);
}

RunResult simulate(const Scene& scene, bool certified, const EngineOptions& options) {
  return certified ? run<Engine>(scene, options) : run<PlainEngine>(scene, options);
}

std::uint64_t peak_memory(const SceneChoice& choice, EngineKind engine) {
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    int status = 1;
    try {
      const Scene scene = scene_of(choice);
      if (engine != EngineKind::none) simulate(scene, engine == EngineKind::certified);
      status = 0;
    } catch (const std::exception&) {
      // The exit status tells; the parent reports.
    }
    _exit(status);
  }
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, 0, &usage) < 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "wait4");
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error("the run whose memory was to be measured failed");
  }
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace voroproof::internal::bench
