// voroproof simulate: from a scene to its history.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>
#include <string_view>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/cli/progress.h"
#include "apps/run/begun_history.h"
#include "apps/run/checkpoints.h"
#include "apps/run/history_sink.h"
#include "apps/run/keeper.h"
#include "apps/run/stats_file.h"
#include "apps/run/told_run.h"
#include "apps/verbs/simulate_billiard.h"
#include "apps/verbs/simulate_world.h"
#include "apps/verbs/verbs.h"
#include "history/billiard.h"
#include "history/descriptor.h"
#include "history/error.h"
#include "history/history_writer.h"
#include "history/json_text.h"
#include "history/output_file.h"
#include "history/world.h"
#include "library/maneuver_input.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string scene, history, stats, horizon;
  int threads = 1;
  MotionOptions motion;
  std::uint64_t max_events = 0;
  bool replace = false;
  bool resume = false;
  std::uint64_t checkpoint = 10;  // seconds
  bool quiet = false;
};

// Tests set in the environment where decisions are taken, never what they are (CONTRIBUTING.md).
MotionOptions motion_options(const Request& request) {
  MotionOptions motion = request.motion;
  motion.filters = filters_wanted();
  if (const char* bits = std::getenv("VOROPROOF_START_BITS")) {
    motion.start_bits = std::clamp(std::atoi(bits), least_bits, most_bits);
  }
  motion.start_bits = std::min(motion.start_bits, motion.max_bits);
  return motion;
}

EngineOptions engine_options(const Request& request) {
  EngineOptions options;
  options.motion = motion_options(request);
  options.threads = request.threads;
  options.profile = !request.stats.empty();
  options.max_events = request.max_events;
  return options;
}

std::unique_ptr<HistorySink> make_sink(int threads, HistoryWriter& writer, HistoryHeader header,
                                       int disks) {
  if (threads == 1) return std::make_unique<HistorySink>(writer, std::move(header), disks);
  return std::make_unique<BackgroundHistorySink>(writer, std::move(header), disks);
}

// The events that an outcome names, as a history writes them.
std::vector<Event> events_of(const Outcome& outcome) {
  std::vector<Event> events;
  for (const auto& event : outcome.events) {
    if (const auto* edge = std::get_if<Quad>(&event)) {
      events.emplace_back(FlipEvent{.t = outcome.t, .quad = *edge});
    } else {
      const auto [i, j] = std::get<std::pair<GenId, GenId>>(event);
      events.emplace_back(CollideEvent{.t = outcome.t, .i = std::min(i, j), .j = std::max(i, j)});
    }
  }
  return events;
}

// One line that depends on the scene and the options alone.
void print_summary(std::ostream& out, const Outcome& outcome, const EngineStats& stats) {
  out << "flips " << stats.flip_count();
  for (std::size_t kind = 0; kind < stats.flips.size(); ++kind) {
    if (stats.flips[kind] == 0) continue;
    out << ' ' << flip_kind_names[kind] << ' ' << stats.flips[kind];
  }
  out << "; collisions " << stats.disk_collisions + stats.wall_collisions << " disks "
      << stats.disk_collisions << " container " << stats.wall_collisions << "; maneuvers "
      << stats.maneuvers << "; t " << number_text(outcome.t) << "; bits " << stats.highest_bits
      << '\n';
}

Outcome run_or_resume(Engine& engine, HistorySink& sink, const std::optional<BegunHistory>& begun) {
  if (!begun) return engine.run(sink);
  try {
    return engine.resume(
        begun->kept().run, [&](EventSink& told) { begun->tell(told); }, sink);
  } catch (const OtherRun& other) {
    throw InputError(begun->path(), 0, "", other.what());
  }
}

// The engine's run; one that a limit of the user's ends is one that stopped.
Outcome run(Engine& engine, HistorySink& sink, const std::optional<BegunHistory>& begun,
            const CooperativeInterruption& interruption) {
  Outcome outcome;
  try {
    outcome = run_or_resume(engine, sink, begun);
  } catch (const std::bad_alloc&) {
    if (!has_memory_limit()) throw;
    lift_memory_limit();
    if (!sink.has_begun()) sink.begin({});
    outcome.kind = Outcome::Kind::stopped;
    outcome.t = sink.last_time();
    outcome.reason = memory_limit_reason();
    return outcome;
  }
  if (outcome.kind == Outcome::Kind::interrupted && interruption.late()) {
    outcome.kind = Outcome::Kind::stopped;
    outcome.reason = time_limit_reason();
  }
  return outcome;
}

RunDescription description(const EngineOptions& options, const Scene& scene, int disks) {
  return {.producer = producer(),
          .scene_sha256 = scene.sha256,
          .disks = disks,
          .horizon = scene.horizon,
          .start_bits = options.motion.start_bits,
          .max_bits = options.motion.max_bits,
          .threads = options.threads,
          .filters = options.motion.filters,
          .total_seconds = 0};
}

// The history's last line.
void finish(HistoryWriter& writer, const Outcome& outcome) {
  if (outcome.kind == Outcome::Kind::complete) {
    writer.end();
  } else {
    writer.stopped(outcome.t, outcome.reason, events_of(outcome));
  }
}

// Finds what an earlier run has left, if that is asked for.
std::optional<BegunHistory> find_begun(const Request& request, const HistoryHeader& header,
                                       int disks) {
  if (!request.resume) return std::nullopt;
  if (is_stream(request.history) || is_standard_output(request.history)) {
    throw UsageError("--resume: what was written into a stream cannot be taken up");
  }
  auto begun = BegunHistory::find(request.history, header, disks);
  if (begun && !request.quiet && !begun->complete()) {
    std::cerr << "voroproof: takes up " << printable(begun->path(), 4096)
              << " at t = " << number_text(begun->kept().run.t0) << ", after "
              << begun->kept().run.events << " events\n";
  }
  return begun;
}

// Gives the history its name.
void close(HistoryWriter& writer, const Request& request, const Outcome& outcome,
           std::optional<Keeper>& keeper) {
  const bool complete = outcome.kind == Outcome::Kind::complete;
  if (keeper && request.resume && !complete) {
    keeper->close_stopped();
    return;
  }
  if (request.replace) {
    writer.close();
    return;
  }
  const std::string written = writer.close_beside_complete();
  if (keeper && complete) keeper->forget(request.resume);
  if (written == request.history) return;
  std::cerr << "voroproof: " << printable(request.history, 4096)
            << ": is complete and stays; the history that stopped is in "
            << printable(written, 4096) << '\n';
}

// Where a disk is full the history so far is kept, as one that stopped.
void close_short(HistoryWriter& writer, const Request& request, const OutputError& error,
                 std::optional<Keeper>& keeper) {
  if (keeper && request.resume && keeper->leave()) return;
  if (const auto written = writer.close_short(error.reason(), request.replace)) {
    std::cerr << "voroproof: what there was room for, a history that stopped, is in "
              << printable(*written, 4096) << '\n';
  }
}

ExitCode simulate_scene(const Request& request) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  CooperativeInterruption interruption;
  Scene scene = read_scene(request.scene);
  if (!request.horizon.empty()) scene.horizon = time_argument("--horizon", request.horizon);
  const int disks = static_cast<int>(scene.disks.size());

  HistoryHeader header{.scene_sha256 = scene.sha256,
                       .horizon = scene.horizon,
                       .producer = producer(),
                       .initial = {}};
  const std::optional<BegunHistory> begun = find_begun(request, header, disks);
  if (begun && begun->complete()) {
    // A process that was killed once its history had its name removed nothing any more.
    BegunHistory::remove_beside_complete(request.history, header);
    PartialFile(request.history, kept_format, kept_ending).forget();
    if (!request.quiet) std::cout << request.history << " is complete\n";
    return ExitCode::ok;
  }

  // Both outputs are begun first, so that a path that cannot be written is known before the run.
  std::optional<OutputFile> stats_file;
  if (!request.stats.empty()) stats_file.emplace(request.stats);
  HistoryWriter writer(request.history);
  std::optional<Keeper> keeper;
  if (!writer.is_stream()) keeper.emplace(request.history, header, writer, request.checkpoint);
  std::unique_ptr<HistorySink> sink = make_sink(request.threads, writer, std::move(header), disks);

  EngineOptions options = engine_options(request);
  std::optional<Progress> progress;
  progress.emplace(round_nearest(scene.horizon), request.quiet);
  Checkpoints checkpoints(request.checkpoint);
  options.monitor = [&](double t, std::uint64_t events) {
    progress->report(t, events);
    if (sink->has_begun() && checkpoints.due()) sink->checkpoint();
    return !interruption.requested();
  };
  if (keeper) {
    // After an interruption the state is being kept. The writing of it is waited for.
    keeper->serve(options, *sink, [&] {
      if (interruption.requested()) interruption.wind_up();
    });
  }
  if (begun) keeper->begin_with(*begun, *sink);
  Engine engine(motion_input(scene), maneuver_input(scene), options);
  scene.disks = std::vector<DiskInput>();  // the engine has its own
  Outcome outcome;
  try {
    outcome = run(engine, *sink, begun, interruption);
    progress.reset();
    // A stream may wait for ever for its reader.
    if (!writer.is_stream()) interruption.wind_up();
    sink->finish();
    if (keeper) keeper->see_stop();
    finish(writer, outcome);
    close(writer, request, outcome, keeper);
  } catch (const OutputError& error) {
    progress.reset();
    sink.reset();
    close_short(writer, request, error, keeper);
    throw;
  }
  if (stats_file) {
    RunDescription run = description(options, scene, disks);
    run.total_seconds = std::chrono::duration<double>(Clock::now() - start).count();
    stats_file->write(stats_text(run, outcome, engine.stats()));
    stats_file->commit();
  }
  if (!request.quiet) {
    print_summary(words_beside({request.history, request.stats}), outcome, engine.stats());
  }
  return told_end(outcome);
}

ExitCode simulate(const Request& request) {
  require_distinct({request.scene},
                   {request.history, request.history + partial_ending, request.stats});
  const bool is_billiard = is_billiard_file(request.scene);
  if (!is_billiard && !is_world_file(request.scene)) return simulate_scene(request);
  if (request.resume || !request.stats.empty()) {
    throw UsageError("--resume, --stats: not for scenes of version 2");
  }
  std::optional<Rational> horizon;
  if (!request.horizon.empty()) horizon = time_argument("--horizon", request.horizon);
  const MotionOptions motion = motion_options(request);
  const WorldRequest whole{.scene = request.scene,
                           .history = request.history,
                           .horizon = horizon,
                           .max_events = request.max_events,
                           .filters = motion.filters,
                           .replace = request.replace,
                           .quiet = request.quiet};
  return is_billiard ? simulate_billiard(whole, motion.max_bits) : simulate_world(whole);
}

}  // namespace

void add_simulate(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb("simulate", "Write the exact history of a scene");
  verb.input("scene", request->scene, "The scene.").required();
  verb.output(request->history, "The history to write.").required();
  verb.text(
      "--horizon", request->horizon, "TIME",
      "The horizon in place of the scene's, exactly: a decimal (0.1 is one tenth), a fraction "
      "(1/3) or a hexadecimal float (0x1.8p-3).");
  verb.output("--stats", request->stats, "Write counts and times of the run here, as JSON.");
  verb.whole(
      "--threads", request->threads, 1, 1024,
      "So many threads compute a scene of 500 disks or more in slices of time, and a further "
      "one writes the history. With fewer disks one computes and another one writes. A history "
      "that reaches its horizon does not depend on it.");
  add_max_bits(verb, request->motion.max_bits);
  add_max_events(verb, request->max_events);
  verb.flag("--replace", request->replace,
            "Let a history that stops replace a complete one of its name, too, instead of going to "
            "that name with .partial at its end.");
  verb.flag(
      "--resume", request->resume,
      "Take up what a run that stopped, was interrupted or killed has left of this history; "
      "the result is the same as without the break. It goes on from what was kept in "
      "HISTORY.kept. Where that is not there, or not of these bytes, the run begins at 0, and "
      "where the history is complete nothing is done.");
  verb.whole("--checkpoint", request->checkpoint, 1, 1'000'000,
             "After so many seconds at the latest events are safe from the end of the process: "
             "--resume finds them.");
  verb.flag("--quiet", request->quiet, "Show no progress on the terminal and no summary.");
  verb.example("voroproof simulate a.scene.json -o a.history.jsonl --stats a.stats.json");
  verb.does([request] { return simulate(*request); });
}

}  // namespace voroproof::internal
