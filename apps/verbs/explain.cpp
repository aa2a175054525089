// voroproof explain: a report of certify in words and as a picture.
#include <iostream>
#include <memory>

#include "apps/cli/command_line.h"
#include "apps/cli/interruption.h"
#include "apps/draw/witness_picture.h"
#include "apps/verbs/verbs.h"
#include "history/error.h"
#include "library/explanation.h"

namespace voroproof::internal {
namespace {

struct Request {
  std::string report, picture;
};

constexpr std::size_t longest_name = 4096;

ExitCode explain(const Request& request) {
  require_distinct({request.report}, {request.picture});
  if (!request.picture.empty()) require_picture("--output", request.picture);
  const Explanation explanation = explain_report(request.report, producer());
  const bool drawn = !request.picture.empty() && !explanation.generators.empty();
  const CooperativeInterruption interruption;
  if (drawn) draw_witness(explanation.generators, request.picture);
  std::ostream& out = words_beside({request.picture});
  out << explanation.words;
  if (drawn) {
    out << "\nDrawn in " << printable(request.picture, longest_name) << ".\n";
  } else if (!request.picture.empty()) {
    out << "\nThe report has no evidence that can be drawn.\n";
  }
  return ExitCode::ok;
}

}  // namespace

void add_explain(Verb& program) {
  auto request = std::make_shared<Request>();
  Verb& verb = program.add_verb(
      "explain",
      "Say in words what a report of certify found, and draw it where that is asked for");
  verb.input("report", request->report, "The report.").required();
  verb.output(request->picture, "Draw the evidence here; the name ends in .svg, .png or .pdf.");
  verb.example("voroproof explain r.json -o r.png");
  verb.does([request] { return explain(*request); });
}

}  // namespace voroproof::internal
