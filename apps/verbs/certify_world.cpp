#include "apps/verbs/certify_world.h"

#include <iostream>
#include <ostream>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/cli/progress.h"
#include "apps/run/told_certificate.h"
#include "certify/report.h"
#include "certify/world/world_certifier.h"
#include "history/error.h"
#include "history/history_reader.h"
#include "history/json_text.h"
#include "history/world.h"
#include "history/world_history_reader.h"

namespace voroproof::internal {
namespace {

WorldVerdict undecided(const std::string& reason, std::int64_t line, double t) {
  WorldVerdict verdict;
  verdict.reason = reason;
  verdict.line = line;
  verdict.t = t;
  return verdict;
}

WorldVerdict judge(const CertifyRequest& request, const Rational& tolerance, const World& world,
                   WorldHistoryReader& history, const CooperativeInterruption& interruption) {
  if (told_horizon(history.header().horizon, world.horizon) > world.horizon) {
    return undecided("the history goes beyond the horizon of the scene", 1, 0);
  }
  Progress progress(round_nearest(history.header().horizon), request.quiet);
  WorldCertifier certifier(
      world, history.header().initial, tolerance, [&] { return !interruption.requested(); },
      filters_wanted());
  double t = 0;
  std::uint64_t events = 0;
  while (const auto event = history.next()) {
    if (request.max_events > 0 && ++events > request.max_events) {
      return undecided(event_limit_reason(request.max_events), history.line(), t);
    }
    t = round_nearest(event->t);
    progress.report(t, events);
    // The rest is read for its form.
    if (!certifier.is_decided()) certifier.event(*event, history.line());
  }
  if (interruption.requested() && interruption.late()) {
    return undecided(time_limit_reason(), history.line(), t);
  }
  if (interruption.requested()) throw Interrupted();
  return std::visit([&](const auto& ending) { return certifier.finish(ending, history.line()); },
                    history.ending());
}

// The verdict last, and the reason of one other than CERTIFIED to stderr.
void tell(std::ostream& out, const CertifyRequest& request, const Rational& tolerance,
          const World& world, const WorldHistoryReader& history, const WorldVerdict& verdict) {
  if (verdict.kind != Verdict::certified) {
    std::cerr << "voroproof: " << printable(request.history, 4096) << ": line " << verdict.line
              << ": " << printable(verdict.reason, 4096) << '\n';
  }
  const WorldCounts& counts = history.counts();
  if (!request.quiet) {
    out << "c " << counts.flips << " flips, " << counts.hides << " hides, " << counts.appears
        << " appears, " << counts.swaps << " swaps, " << counts.jumps << " jumps, "
        << counts.maneuvers << " maneuvers "
        << (verdict.kind == Verdict::certified ? "proved" : "judged") << "; edge lives "
        << verdict.checked.edge_lives << ", pair lives " << verdict.checked.pair_lives
        << ", hidden lives " << verdict.checked.hidden_lives << ", cells " << verdict.checked.cells
        << '\n';
  }
  const VerdictWords words =
      words_of_world(verdict.kind, history.header().horizon, world.horizon, tolerance);
  out << "c " << words.about << '\n';
  for (const std::string& line : words.reservations) out << "c " << line << '\n';
  out << "s " << words.verdict << '\n';
}

}  // namespace

ExitCode certify_world(const CertifyRequest& request) {
  CooperativeInterruption interruption;
  World world = read_world(request.scene);
  WorldHistoryReader history(request.history, static_cast<int>(world.disks.size()), world.sha256);
  CertifyOptions options;
  read_tolerances(request, history.header().horizon, options);
  const Rational whole = world.horizon;
  if (history.header().horizon < whole) world.horizon = history.header().horizon;
  const WorldVerdict verdict = judge(request, options.tolerance, world, history, interruption);
  world.horizon = whole;
  tell(words_beside({}), request, options.tolerance, world, history, verdict);
  return exit_code(verdict.kind);
}

}  // namespace voroproof::internal
