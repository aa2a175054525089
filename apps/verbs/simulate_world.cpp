#include "apps/verbs/simulate_world.h"

#include <iostream>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/cli/progress.h"
#include "apps/run/told_run.h"
#include "certify/world/world_certifier.h"
#include "engine/world/world_run.h"
#include "history/error.h"
#include "history/history_writer.h"
#include "history/json_text.h"
#include "history/world.h"
#include "history/world_history_writer.h"

namespace voroproof::internal {
namespace {

// Thrown where the certifier does not prove what the engine tells.
struct Unproved {
  double t;  // everything before is proved
  std::string reason;
};

// Writes what the certifier has proved: an instant once the next one begins.
class ProvedHistory final : public WorldSink {
 public:
  // `header` without the initial diagram.
  ProvedHistory(const World& world, WorldHistoryWriter& writer, WorldHistoryHeader header,
                bool filters)
      : world_(world), writer_(writer), header_(std::move(header)), filters_(filters) {}

  void begin(const std::vector<Quad>& initial) override {
    header_.initial = initial;
    writer_.header(header_);
    certifier_.emplace(world_, initial, tolerance_, nullptr, filters_);
  }
  void event(const WorldEvent& event) override {
    certifier_->event(event, 0);
    if (certifier_->is_decided()) throw_unproved(certifier_->finish(WorldStop{event.t, ""}));
    if (!pending_.empty() && pending_.back().t < event.t) flush();
    counts_.add(event);
    pending_.push_back(event);
  }
  // The run has ended at t: gives the time up to which the history is written.
  double stop(double t) {
    if (!certifier_) return 0;
    const Rational end = to_rational(t);
    const WorldVerdict verdict = certifier_->finish(WorldStop{end, ""});
    if (verdict.kind == Verdict::refuted) throw_unproved(verdict);
    if (!pending_.empty() && pending_.back().t + tolerance_ < end) flush();
    return pending_.empty() ? t : last_;
  }
  // The run has come to its horizon.
  void finish() {
    const WorldVerdict verdict = certifier_->finish(WorldEnd{counts_});
    if (verdict.kind != Verdict::certified) throw_unproved(verdict);
    flush();
  }

 private:
  // Times are rounded to nearest: by less than this part of the horizon.
  static constexpr int kBitsOfRounding = 50;

  void flush() {
    for (const WorldEvent& event : pending_) writer_.write(event);
    last_ = pending_.empty() ? last_ : round_nearest(pending_.back().t);
    pending_.clear();
  }
  [[noreturn]] void throw_unproved(const WorldVerdict& verdict) {
    throw Unproved{last_, "the certifier does not prove what follows: " + verdict.reason};
  }

  const World& world_;
  WorldHistoryWriter& writer_;
  WorldHistoryHeader header_;
  bool filters_;
  Rational tolerance_ = world_.horizon >> kBitsOfRounding;
  std::optional<WorldCertifier> certifier_;
  WorldCounts counts_;
  std::vector<WorldEvent> pending_;
  double last_ = 0;
};

WorldOutcome run(const WorldRequest& request, const World& world, WorldHistoryWriter& writer,
                 CooperativeInterruption& interruption) {
  ProvedHistory sink(world, writer, {world.sha256, world.horizon, producer(), {}}, request.filters);
  Progress progress(round_nearest(world.horizon), request.quiet);
  WorldOptions options;
  options.filters = request.filters;
  options.max_events = request.max_events;
  options.monitor = [&](double t, std::uint64_t events) {
    progress.report(t, events);
    return !interruption.requested();
  };
  WorldOutcome outcome;
  try {
    outcome = run_world(world.motion(), options, sink);
    if (outcome.kind == WorldOutcome::Kind::complete) {
      sink.finish();
    } else {
      outcome.t = sink.stop(outcome.t);
    }
  } catch (const Unproved& unproved) {
    outcome = {WorldOutcome::Kind::stopped, unproved.t, unproved.reason};
  }
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
  close_history(writer, request.history, request.replace);
  if (!request.quiet) print_summary(words_beside({request.history}), writer.counts(), outcome.t);
  return told_end(outcome);
}

}  // namespace voroproof::internal
