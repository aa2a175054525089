// voroproof movie: a history as a page that plays it.
#include <memory>
#include <optional>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/cli/limits.h"
#include "apps/verbs/verbs.h"
#include "history/error.h"
#include "history/event_limit.h"
#include "history/output_file.h"
#include "history/sha256.h"
#include "library/movie/movie.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string scene, history, output, report, from, horizon, index;
  std::optional<GenId> follow;
  EngineOptions options;
};

ExitCode write_movie(const Verb& verb, const Request& request) {
  require_distinct({request.scene, request.history, request.report, request.index},
                   {request.output});
  require_order(request.scene, request.history);
  const EventLimit limit(request.options.max_events);
  MovieSpan span;
  if (!request.from.empty()) span.from = time_argument("--from", request.from);
  if (!request.horizon.empty()) span.until = time_argument("--horizon", request.horizon);
  if (span.from && span.until && *span.until < *span.from) {
    throw UsageError("--horizon: before --from");
  }
  if (!request.index.empty()) {
    if (!span.from) throw UsageError("--index: only with --from, which begins in the middle");
    span.index = {request.index, producer()};
  }
  Claim claim = open_claim(request.scene, request.history);
  const auto disks = static_cast<GenId>(claim.scene.disks.size());
  if (request.follow && *request.follow >= disks) {
    throw UsageError("--follow: the scene has " + std::to_string(disks) + " disks");
  }
  std::optional<Explanation> report;
  if (!request.report.empty()) {
    report = explain_report(request.report, producer());
    require_report_of(*report, request.report, producer(), claim.scene.sha256,
                      sha256_of_file(request.history));
    span.flips = report->judges_flips;
  }
  const std::int64_t line = report && report->fault ? report->fault->line : 0;
  const MovieData data = movie_data(claim, request.history, span, line, request.options);
  // Without a limit the page does without the diagram, and says why.
  if (!data.no_initial.empty() && verb.given("--max-bits")) throw Undecided(data.no_initial);
  const CooperativeInterruption interruption;
  OutputFile file(request.output);
  make_movie(claim, data, report ? &*report : nullptr,
             {.producer = producer(), .follow = request.follow},
             [&](std::string_view piece) { file.write(piece); });
  file.commit();
  return ExitCode::ok;
}

}  // namespace

void add_movie(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb("movie", "Make a page that plays a history");
  verb.input("scene", request->scene, "The scene.").required();
  verb.input("history", request->history, "A history of the scene, right or wrong.").required();
  verb.output(request->output, "The page to write: HTML that needs no other file.").required();
  verb.input("--report", request->report,
             "The report of this version's certify on these files; another one is refused. The "
             "time line shows what is proved, and the "
             "evidence of a refutation is drawn.");
  verb.whole("--follow", request->follow, 0, max_disks, "The disk to follow to begin with.");
  verb.text("--from", request->from, "TIME",
            "Leave out what happens up to then: the page begins with what the history makes of the "
            "disks and the diagram by that time. The time is exact, as --horizon is.");
  verb.input(
          "--index", request->index,
          "An index of the history (voroproof index), with --from: what is before the last place "
          "that it names before that time is not read. The state there is believed.")
      .excludes({"--max-events"});
  verb.text("--horizon", request->horizon, "TIME",
            "Leave out what is later. The time is exact: a decimal, a fraction or a hexadecimal "
            "float.");
  add_computing_limits(verb, request->options);
  verb.example("voroproof movie a.scene.json a.history.jsonl --report a.report.json -o a.html");
  verb.does([request, &verb] { return write_movie(verb, *request); });
}

}  // namespace voroproof::internal
