#include "apps/verbs/simulate_billiard.h"

#include <iostream>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/cli/progress.h"
#include "apps/run/told_run.h"
#include "certify/billiards/billiard_certifier.h"
#include "engine/billiard/billiard_run.h"
#include "history/billiard.h"
#include "history/billiard_history_writer.h"
#include "history/error.h"
#include "history/history_writer.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

BilliardOutcome run(const WorldRequest& request, const Billiard& billiard, int max_bits,
                    BilliardHistoryWriter& writer, const CooperativeInterruption& interruption) {
  Progress progress(round_nearest(billiard.horizon), request.quiet);
  BilliardOptions options;
  options.max_bits = max_bits;
  options.max_events = request.max_events;
  options.monitor = [&](double t, std::uint64_t events) {
    progress.report(t, events);
    return !interruption.requested();
  };
  writer.header(billiard.sha256, billiard.horizon, producer());
  BilliardOutcome outcome =
      run_billiard(billiard, options, [&](const BilliardEvent& event) { writer.write(event); });
  if (outcome.kind == BilliardOutcome::Kind::interrupted && interruption.late()) {
    outcome.kind = BilliardOutcome::Kind::stopped;
    outcome.reason = time_limit_reason();
  }
  return outcome;
}

}  // namespace

ExitCode simulate_billiard(const WorldRequest& request, int max_bits) {
  CooperativeInterruption interruption;
  Billiard billiard = read_billiard(request.scene);
  if (request.horizon) {
    if (*request.horizon > billiard.horizon)
      throw UsageError("--horizon: later than that of the scene, up to which it is checked");
    billiard.horizon = *request.horizon;
  }
  require_placement(billiard, request.scene);
  BilliardHistoryWriter writer(request.history, billiard.dimension);
  const BilliardOutcome outcome = run(request, billiard, max_bits, writer, interruption);
  if (!writer.is_stream()) interruption.wind_up();
  const bool complete = outcome.kind == BilliardOutcome::Kind::complete;
  if (complete) {
    writer.end();
  } else {
    writer.stopped(outcome.t, outcome.reason);
  }
  close_history(writer, request.history, request.replace);
  if (!request.quiet) {
    words_beside({request.history})
        << "collisions " << writer.counts().collisions << "; maneuvers "
        << writer.counts().maneuvers << "; t " << number_text(outcome.t) << "; "
        << (outcome.bits == 0 ? "in fractions" : "bits " + std::to_string(outcome.bits)) << '\n';
  }
  return told_end(outcome);
}

}  // namespace voroproof::internal
