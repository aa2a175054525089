#include "apps/run/second_words.h"

#include <utility>

#include "apps/cli/limits.h"

namespace voroproof::internal {

void undecide(Certificate& certificate, const std::string& reason, std::int64_t prefix_events,
              double prefix_t) {
  Certificate at_limit;  // undecided
  at_limit.reason = reason;
  at_limit.prefix_events = prefix_events;
  at_limit.prefix_t = prefix_t;
  at_limit.other_horizon = certificate.other_horizon;
  at_limit.remarks = std::move(certificate.remarks);
  certificate = std::move(at_limit);
}

SecondWords second_words(const std::vector<SecondChecker>& seconds, const CertifyOptions& options,
                         const CooperativeInterruption& interruption, ShardFile& file) {
  Certificate& certificate = file.shard.certificate;
  SecondWords words;
  for (const SecondChecker& checker : seconds) {
    const std::string said = judged_by(checker, certificate, file.run, options,
                                       [&] { return !interruption.requested(); });
    if (said.empty()) {
      if (!interruption.late()) throw Interrupted();
      undecide(certificate,
               time_limit_reason() + " while the " + std::string(checker.name) + " judges",
               certificate.prefix_events, certificate.prefix_t);
      break;
    }
    words.emplace_back(checker, said);
    file.run.second.emplace_back(checker.field, said);
  }
  return words;
}

}  // namespace voroproof::internal
