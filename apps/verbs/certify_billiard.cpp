#include "apps/verbs/certify_billiard.h"

#include <optional>
#include <stdexcept>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/cli/progress.h"
#include "apps/run/least_tolerances.h"
#include "apps/run/second_words.h"
#include "apps/run/told_certificate.h"
#include "certify/billiards/billiard_certifier.h"
#include "certify/recorded_certifier.h"
#include "history/error.h"
#include "history/event_limit.h"
#include "history/output_file.h"
#include "library/certification.h"

namespace voroproof::internal {
namespace {

Certificate undecided(std::string reason, std::int64_t line, std::int64_t events, double t) {
  Certificate certificate;
  certificate.reason = std::move(reason);
  certificate.reason_line = line;
  certificate.prefix_events = events;
  certificate.prefix_t = t;
  return certificate;
}

Certificate judge(const CertifyRequest& request, const Billiard& billiard,
                  BilliardHistoryReader& history, CertifyOptions& options,
                  const CooperativeInterruption& interruption) {
  Progress progress(round_nearest(history.header().horizon), request.quiet);
  options.monitor = [&](double t, std::int64_t events) {
    progress.report(t, static_cast<std::uint64_t>(events));
    return !interruption.requested();
  };
  std::optional<EventLimit> limit;
  if (request.max_events > 0) limit.emplace(request.max_events);
  try {
    return internal::certify_billiard(billiard, request.scene, history, options);
  } catch (const EventLimitReached&) {
    return undecided(event_limit_reason(request.max_events), history.line(), 0, 0);
  } catch (const CertificationInterrupted& at) {
    if (!interruption.late()) throw Interrupted();
    return undecided(time_limit_reason(), history.line(), at.prefix_events, at.prefix_t);
  }
}

std::vector<SecondChecker> second_checkers(const CertifyRequest& request) {
  if (!request.kernel) return {};
  if (request.truth != "recorded")
    throw UsageError("--kernel: the kernel judges billiards with --truth recorded only");
  return {kernel_checker()};
}

}  // namespace

ExitCode certify_billiard(const CertifyRequest& request) {
  const std::vector<SecondChecker> seconds = second_checkers(request);
  require_distinct({request.scene, request.history}, {request.report});
  CooperativeInterruption interruption;
  std::optional<OutputFile> report;
  if (!request.report.empty()) report.emplace(request.report);
  const Billiard billiard = read_billiard(request.scene);
  BilliardHistoryReader history(request.history, &billiard);
  ShardFile file;
  file.options = request.options;
  file.options.truth = request.truth == "exact" ? Truth::exact : Truth::recorded;
  file.options.motion.filters = filters_wanted();
  file.options.events = EventKinds::collisions;
  read_tolerances(request, history.header().horizon, file.options);
  file.run =
      certification_run(producer(), request.scene, request.history, billiard, history.header());
  Certificate& certificate = file.shard.certificate;
  certificate = judge(request, billiard, history, file.options, interruption);
  certificate.other_horizon = other_horizon(billiard.horizon, history.header());
  if (report || request.kernel) file.run.history_sha256 = history.content_sha256();
  file.run.evidence = checked_evidence(certificate, request.scene, request.history);
  if (request.least_tolerances) {
    add_least_tolerances(file, interruption, [&](const CertifyOptions& other) {
      BilliardHistoryReader again(request.history, &billiard);
      Certificate anew = internal::certify_billiard(billiard, request.scene, again, other);
      if (again.content_sha256() != history.content_sha256())
        throw InputError(request.history, 0, "", "changes while it is read");
      return anew;
    });
  }
  const SecondWords second = second_words(seconds, file.options, interruption, file);
  interruption.wind_up();
  if (report) {
    report->write(report_text(file.run, file.options, certificate));
    report->commit();
  }
  tell(words_beside({request.report}), file, second, {}, request.quiet);
  return exit_code(certificate.verdict);
}

}  // namespace voroproof::internal
