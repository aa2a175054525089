#include "apps/verbs/certify_diagram.h"

#include <iostream>
#include <stdexcept>

#include "apps/answers/diagram_claim.h"
#include "apps/verbs/frame_argument.h"
#include "certify/report.h"
#include "history/error.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

constexpr std::size_t longest_shown = 4096;

DiagramFiles read(const DiagramRequest& request) {
  const auto& files = request.files;
  if (files.size() > 2) throw UsageError("--diagram: more than two files");
  const bool two = files.size() == 2;
  if (!two && !request.frame.empty()) {
    throw UsageError("--frame: the file of the diagram names it");
  }
  require_distinct(files, {});
  if (!two) return read_diagram_claim(files[0]);
  const FrameArgument frame = frame_argument(request.frame);
  return read_diagram_claim(files[0], files[1], frame.circle, frame.walls);
}

}  // namespace

void add_diagram_options(Verb& verb, DiagramRequest& request) {
  verb.inputs("--diagram", request.files,
              "Judge a diagram of disks at rest, whoever made it: a file like those of voroproof "
              "diagram (.json); or a table of disks, and a list of edges or of neighbours.")
      .with_all_that_follow()
      .excludes({"--truth", "--events", "--order", "--tolerance", "--law-tolerance", "--strict",
                 "--unoriented", "--kernel", "--proved", "--report", "--part", "--index", "--merge",
                 "--resume", "--checkpoint", "--max-bits", "--max-events"});
  verb.text("--frame", request.frame, "X,Y,R|X0,Y0,X1,Y1",
            "The circle or the rectangle in which the disks of the table are.")
      .needs("--diagram");
  verb.text("--vertex-tolerance", request.tolerance, "RATIO",
            "How far the circles of a diagram's vertices may be off, relative to the largest "
            "number of "
            "circle and generators.")
      .needs("--diagram");
}

ExitCode certify_diagram_files(const DiagramRequest& request) {
  const double tolerance = round_nearest(number_argument("--vertex-tolerance", request.tolerance));
  const DiagramFiles files = read(request);
  DiagramReport report;
  try {
    report = certify_diagram(files.claim, tolerance, request.threads);
  } catch (const std::invalid_argument& fault) {
    throw InputError(request.files.back(), 0, "", fault.what());
  }
  using Word = voroproof::Verdict;
  const bool certified = report.verdict == Word::certified;
  if (!certified) {
    std::cerr << "voroproof: " << printable(request.files.back(), longest_shown) << ": "
              << printable(report.reason, longest_shown) << '\n';
  }
  if (!request.quiet) std::cout << "c sha256 " << files.sha256 << '\n';
  std::cout << "c " << report.about << '\n';
  for (const std::string& line : report.reservations) std::cout << "c " << line << '\n';
  const bool refuted = report.verdict == Word::refuted;
  const auto verdict = certified ? Verdict::certified
                       : refuted ? Verdict::refuted
                                 : Verdict::undecided;
  std::cout << verdict_line(verdict) << '\n';
  return certified ? ExitCode::ok : refuted ? ExitCode::refuted : ExitCode::undecided;
}

}  // namespace voroproof::internal
