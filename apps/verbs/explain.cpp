// voroproof explain: a report of certify in words and as a picture.
#include <iostream>
#include <memory>

#include "apps/answers/explanation.h"
#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/draw/witness_picture.h"
#include "apps/verbs/verbs.h"
#include "history/error.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string report, picture;
};

// The picture's path: beside the report, under its name.
std::string default_picture(const std::string& report) {
  const std::string ending = ".json";
  return (report.ends_with(ending) ? report.substr(0, report.size() - ending.size()) : report) +
         ".svg";
}

constexpr std::size_t longest_name = 4096;

ExitCode explain(const Request& request) {
  const std::string picture =
      request.picture.empty() ? default_picture(request.report) : request.picture;
  require_distinct({request.report}, {picture});
  require_picture("--output", picture);
  const Explanation explanation = explain_report(request.report);
  const bool drawn = !explanation.generators.empty();
  const CooperativeInterruption interruption;
  if (drawn) draw_witness(explanation.generators, picture);
  std::cout << explanation.words;
  if (drawn) {
    std::cout << "\nDrawn in " << printable(picture, longest_name) << ".\n";
  } else if (!request.picture.empty()) {
    std::cout << "\nThe report has no evidence that can be drawn.\n";
  }
  return ExitCode::ok;
}

}  // namespace

void add_explain(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb =
      program.add_verb("explain", "Say in words what a report of certify found, and draw it");
  verb.file("report", request->report, "The report.").required();
  verb.output(request->picture,
              "Draw the evidence here. The name ends in .svg or .png; without this option the "
              "picture stands beside the report, as .svg.");
  verb.example("voroproof explain r.json -o r.png");
  verb.does([request] { return explain(*request); });
}

}  // namespace voroproof::internal
