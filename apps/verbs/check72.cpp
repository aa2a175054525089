// voroproof check72: the paper's own test of a history.
#include <iostream>
#include <memory>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/progress.h"
#include "apps/paper/paper_check.h"
#include "apps/verbs/verbs.h"
#include "exact/names.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string scene, history;
  PaperCheckOptions options;
  bool quiet = false;
};

ExitCode check72(const Request& request) {
  if (!(request.options.step > 0)) throw UsageError("--step: not positive");
  if (!(request.options.tolerance >= 0)) throw UsageError("--tolerance: negative");
  const CooperativeInterruption interruption;
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

void add_check72(CLI::App& app, Action& action) {
  auto request = std::make_shared<Request>();
  CLI::App* verb = app.add_subcommand(
      "check72", "Test a history as section 7.2 of the paper does; proves nothing, see certify");
  add_file(*verb, "scene", request->scene, "the scene")->required();
  add_file(*verb, "history", request->history, "the history, with centres and velocities")
      ->required();
  add_real(*verb, "--step", request->options.step, "of the regular instants");
  add_real(*verb, "--tolerance", request->options.tolerance,
           "how far a disk may reach into a circle");
  verb->add_flag("--quiet", request->quiet, "no progress on the terminal");
  verb->footer(
      "The last line is `passed` (exit code 0) or `failed` (1).\n"
      "Example:\n  voroproof check72 a.scene.json a.history.jsonl");
  verb->callback([request, &action] { action = [request] { return check72(*request); }; });
}

}  // namespace voroproof::internal
