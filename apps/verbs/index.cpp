// voroproof index: where the reading of a history may begin.
#include <iostream>
#include <memory>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/cli/progress.h"
#include "apps/verbs/verbs.h"
#include "history/error.h"
#include "history/event_limit.h"
#include "library/certification.h"
#include "library/history_index.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string scene, history, output, tolerance = "1e-6";
  CertifyOptions options;
  std::uint64_t max_events = 0;
  bool quiet = false;
};

ExitCode index_history(Request& request) {
  const std::string path = request.output.empty() ? request.history + ".index" : request.output;
  require_distinct({request.scene, request.history}, {path});
  require_order(request.scene, request.history);
  CooperativeInterruption interruption;
  const EventLimit limit(request.max_events);
  Claim claim = open_claim(request.scene, request.history);
  const HistoryHeader& header = claim.history->header();
  CertifyOptions& options = request.options;
  options.tolerance = time_argument("--tolerance", request.tolerance);
  try {
    require_meaningful(options, header.horizon);
  } catch (const std::invalid_argument& fault) {
    throw UsageError(std::string("--") + fault.what());
  }
  std::optional<Progress> progress;
  progress.emplace(round_nearest(header.horizon), request.quiet);
  options.monitor = [&](double t, std::int64_t events) {
    progress->report(t, static_cast<std::uint64_t>(events));
    return !interruption.requested();
  };
  std::int64_t entries = 0;
  try {
    entries = write_index(path, producer(), claim, request.history, options);
  } catch (const CertificationInterrupted&) {
    interruption.check();
  }
  progress.reset();
  if (!request.quiet) {
    words_beside({path}) << "entries " << entries << "; events " << claim.history->counts().all()
                         << '\n';
  }
  return ExitCode::ok;
}

}  // namespace

void add_index(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb("index", "Write where the reading of a history may begin");
  verb.input("scene", request->scene, "The scene.").required();
  verb.input("history", request->history,
             "The history: a plain JSON file, not compressed. It is not judged.")
      .required();
  verb.output(request->output,
              "The index to write; without it the history's name with .index at its end.");
  verb.text("--tolerance", request->tolerance, "TIME",
            "The tolerance of the certifications that will use the index.");
  verb.flag("--unoriented", request->options.unoriented,
            "The certifications that will use the index have this option, too.");
  add_max_events(verb, request->max_events);
  verb.flag("--quiet", request->quiet, "Show no progress on the terminal and no summary.");
  verb.note("certify --part, snapshot and movie read from the middle with --index.");
  verb.example("voroproof index a.scene.json a.history.jsonl");
  verb.does([request] { return index_history(*request); });
}

}  // namespace voroproof::internal
