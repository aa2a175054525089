#include "apps/verbs/simulate_world.h"

#include <iostream>
#include <ostream>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/cli/progress.h"
#include "engine/world/world_run.h"
#include "history/error.h"
#include "history/history_writer.h"
#include "history/json_text.h"
#include "history/world.h"
#include "history/world_history_writer.h"

namespace voroproof::internal {
namespace {

class HistoryOfWorld final : public WorldSink {
 public:
  // `header` without the initial diagram.
  HistoryOfWorld(WorldHistoryWriter& writer, WorldHistoryHeader header)
      : writer_(writer), header_(std::move(header)) {}
  void begin(const std::vector<Quad>& initial) override {
    header_.initial = initial;
    writer_.header(header_);
  }
  void event(const WorldEvent& event) override { writer_.write(event); }

 private:
  WorldHistoryWriter& writer_;
  WorldHistoryHeader header_;
};

WorldOutcome run(const WorldRequest& request, const World& world, WorldHistoryWriter& writer,
                 CooperativeInterruption& interruption) {
  HistoryOfWorld sink(writer, {world.sha256, world.horizon, producer(), {}});
  Progress progress(round_nearest(world.horizon), request.quiet);
  WorldOptions options;
  options.max_events = request.max_events;
  options.monitor = [&](double t, std::uint64_t events) {
    progress.report(t, events);
    return !interruption.requested();
  };
  WorldOutcome outcome = run_world(world.motion(), options, sink);
  if (outcome.kind == WorldOutcome::Kind::interrupted && interruption.late()) {
    outcome.kind = WorldOutcome::Kind::stopped;
    outcome.reason = time_limit_reason();
  }
  return outcome;
}

void print_summary(std::ostream& out, const WorldCounts& counts, double t) {
  out << "flips " << counts.flips << "; hides " << counts.hides << "; appears " << counts.appears
      << "; swaps " << counts.swaps << "; jumps " << counts.jumps << "; maneuvers "
      << counts.maneuvers << "; t " << number_text(t) << '\n';
}

}  // namespace

ExitCode simulate_world(const WorldRequest& request) {
  CooperativeInterruption interruption;
  World world = read_world(request.scene);
  if (request.horizon) {
    if (*request.horizon > world.horizon) {
      throw UsageError("--horizon: later than that of the scene, up to which a world is checked");
    }
    world.horizon = *request.horizon;
  }
  WorldHistoryWriter writer(request.history);
  const WorldOutcome outcome = run(request, world, writer, interruption);
  if (!writer.is_stream()) interruption.wind_up();
  const bool complete = outcome.kind == WorldOutcome::Kind::complete;
  if (complete) {
    writer.end();
  } else {
    writer.stopped(to_rational(outcome.t), outcome.reason);
  }
  if (request.replace) {
    writer.close();
  } else if (const std::string written = writer.close_beside_complete();
             written != request.history) {
    std::cerr << "voroproof: " << printable(request.history, 4096)
              << ": is complete and stays; the history that stopped is in "
              << printable(written, 4096) << '\n';
  }
  if (!request.quiet) print_summary(words_beside({request.history}), writer.counts(), outcome.t);
  if (complete) return ExitCode::ok;
  const bool stopped = outcome.kind == WorldOutcome::Kind::stopped;
  std::cerr << "voroproof: " << (stopped ? "stopped" : "interrupted")
            << " at t = " << number_text(outcome.t);
  if (stopped) std::cerr << ": " << printable(outcome.reason, 4096);
  std::cerr << '\n';
  return stopped ? ExitCode::undecided : ExitCode::interrupted;
}

}  // namespace voroproof::internal
