// voroproof check72: the paper's own test of a history.
#include <iostream>
#include <memory>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/cli/progress.h"
#include "apps/paper/paper_check.h"
#include "apps/verbs/verbs.h"
#include "exact/names.h"
#include "history/event_limit.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string scene, history;
  PaperCheckOptions options;
  std::uint64_t max_events = 0;
  bool quiet = false;
};

ExitCode check72(const Request& request) {
  if (!(request.options.step > 0)) throw UsageError("--step: not positive");
  if (!(request.options.tolerance >= 0)) throw UsageError("--tolerance: negative");
  require_distinct({request.scene, request.history}, {});
  require_order(request.scene, request.history);
  const CooperativeInterruption interruption;
  const EventLimit limit(request.max_events);
  const Scene scene = read_scene(request.scene);
  PaperCheckOptions options = request.options;
  PaperCheckResult result;
  {
    Progress progress(round_nearest(scene.horizon), request.quiet);
    std::uint64_t events = 0;
    options.monitor = [&](double t) {
      progress.report(t, events++);
      return !interruption.requested();
    };
    result = paper_check(scene, request.history, options);
  }
  interruption.check();
  std::cout << "c " << result.circles << " circles at " << result.regular
            << " regular instants and " << result.midway
            << " midway between events; deepest intrusion " << number_text(result.deepest) << '\n';
  if (result.passed()) {
    std::cout << "passed\n";
    return ExitCode::ok;
  }
  const Intrusion& intrusion = *result.first;
  std::cout << "c at t = " << number_text(intrusion.t) << " the circle of "
            << text_of(intrusion.vertex);
  if (intrusion.generator) {
    std::cout << " is entered by " << *intrusion.generator << ", by "
              << number_text(intrusion.depth) << '\n';
  } else {
    std::cout << " does not exist\n";
  }
  std::cout << "failed\n";
  return ExitCode::refuted;
}

}  // namespace

void add_check72(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb(
      "check72", "Test a history as section 7.2 of the paper does; proves nothing, see certify");
  verb.input("scene", request->scene, "The scene.").required();
  verb.input("history", request->history, "The history, with centres and velocities.").required();
  verb.real("--step", request->options.step, "The time from one regular instant to the next.");
  verb.real("--tolerance", request->options.tolerance, "How far a disk may reach into a circle.");
  add_max_bits(verb, request->options.motion.max_bits);
  add_max_events(verb, request->max_events);
  verb.flag("--quiet", request->quiet, "Show no progress on the terminal.");
  verb.note("The last line of the output is `passed` (exit code 0) or `failed` (1).");
  verb.example("voroproof check72 a.scene.json a.history.jsonl");
  verb.does([request] { return check72(*request); });
}

}  // namespace voroproof::internal
