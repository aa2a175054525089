// The kernel as a second checker.
#include <cstdio>

#include "apps/run/second_checker.h"
#include "certify/kernel/kernel.h"

namespace voroproof::internal {

namespace {

const char* verdict_of(voroproof_kernel::Verdict verdict) {
  switch (verdict) {
    case voroproof_kernel::Verdict::certified:
      return "CERTIFIED";
    case voroproof_kernel::Verdict::refuted:
      return "REFUTED";
    case voroproof_kernel::Verdict::undecided:
      return "UNDECIDED";
    case voroproof_kernel::Verdict::invalid:
      break;
  }
  return "INVALID";
}

std::string refusal(const CertifyOptions& options) {
  if (!options.judges_flips()) return "the kernel judges all events (--events all)";
  if (options.any_order)
    return "the kernel knows no other order than the format's (--order format)";
  return {};
}

int judge(const std::string& scene, const std::string& history, const CertifyOptions& options) {
  voroproof_kernel::Options asked;
  asked.truth = options.truth == Truth::exact ? voroproof_kernel::Truth::exact
                                              : voroproof_kernel::Truth::recorded;
  asked.tolerance = options.tolerance.get_str();
  asked.law_tolerance = options.law_tolerance.get_str();
  asked.strict = options.strict;
  asked.unoriented = options.unoriented;
  asked.jobs = options.threads;
  const voroproof_kernel::Result result = voroproof_kernel::check(scene, history, asked);
  if (!result.reason.empty()) {
    if (result.line > 0) {
      std::printf("c line %lld: ", static_cast<long long>(result.line));
    } else {
      std::printf("c ");
    }
    std::printf("%s\n", result.reason.c_str());
  }
  std::printf("s %s\n", verdict_of(result.verdict));
  return 0;
}

}  // namespace

SecondChecker kernel_checker() {
  return {
      .option = "--kernel", .name = "kernel", .field = "kernel", .refusal = refusal, .work = judge};
}

}  // namespace voroproof::internal
