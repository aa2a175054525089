// voroproof movie: a history as a page that plays it.
#include <memory>
#include <optional>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/movie/movie.h"
#include "apps/verbs/verbs.h"
#include "history/error.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string scene, history, output, report, until;
  std::optional<GenId> follow;
};

// The report must be one about the scene; that it is about the history is the user's word.
Explanation read_report(const std::string& path, const Scene& scene) {
  Explanation report = explain_report(path);
  if (report.scene_sha256 != scene.sha256) {
    throw InputError(path, 0, "scene_sha256", "the report is about another scene");
  }
  return report;
}

ExitCode make_movie(const Request& request) {
  require_distinct({request.scene, request.history, request.report}, {request.output});
  std::optional<Rational> until;
  if (!request.until.empty()) until = time_argument("--until", request.until);
  Claim claim = open_claim(request.scene, request.history);
  const auto disks = static_cast<GenId>(claim.scene.disks.size());
  if (request.follow && *request.follow >= disks) {
    throw UsageError("--follow: the scene has " + std::to_string(disks) + " disks");
  }
  std::optional<Explanation> report;
  if (!request.report.empty()) report = read_report(request.report, claim.scene);
  const std::int64_t line = report && report->fault ? report->fault->line : 0;
  const MovieData data = movie_data(claim, request.history, until, line);
  const CooperativeInterruption interruption;
  write_movie(request.output, claim, data, report ? &*report : nullptr,
              {.producer = producer(), .follow = request.follow});
  return ExitCode::ok;
}

}  // namespace

void add_movie(CLI::App& app, Action& action) {
  auto request = std::make_shared<Request>();
  CLI::App* verb = app.add_subcommand("movie", "Make a page that plays a history");
  add_file(*verb, "scene", request->scene, "the scene")->required();
  add_file(*verb, "history", request->history, "a history of it, right or wrong")->required();
  add_output(*verb, request->output, "the page to write: HTML that needs no other file");
  add_file(*verb, "--report", request->report,
           "the report of certify on this history: the time line shows what is proved, and\n"
           "the evidence of a refutation is drawn");
  verb->add_option("--follow", request->follow, "the disk to follow to begin with")
      ->type_name("ID")
      ->check(whole_number())
      ->check(CLI::Range(0, max_disks));
  add_text(*verb, "--until", request->until, "TIME",
           "leave out what is later, exactly: a decimal, a fraction or a hexadecimal float");
  verb->footer(
      "Example:\n  voroproof movie a.scene.json a.history.jsonl --report a.report.json -o a.html");
  verb->callback([request, &action] { action = [request] { return make_movie(*request); }; });
}

}  // namespace voroproof::internal
