// A certifier's report in words, and what of it can be drawn.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certify/report.h"
#include "exact/generators.h"
#include "history/events.h"

namespace voroproof::internal {

// A generator of the evidence at the time of the event. Good to a few digits: for the eye.
struct DrawnGenerator {
  GenId id;
  Vec2 center, velocity;
  double radius;  // signed: the container's is negative
};

// The first thing that is false in a history.
struct FirstFault {
  std::string kind;       // "missing event" and so on
  std::int64_t line = 0;  // in the history: the claim, or the line before which one is missing
  double t = 0;           // time of the claim, or of the truth where no claim is at fault
  std::string truth;      // one sentence
};

struct Explanation {
  std::string words;  // lines
  std::vector<DrawnGenerator> generators;
  double generators_t = 0;  // the time at which they are drawn
  // The subject of the report, and its findings.
  std::string producer, scene_sha256, history_sha256;
  VerdictWords verdict;
  bool judges_flips = true;
  std::string reason;
  std::int64_t prefix_events = 0;  // number of proved events; nothing is missing
  double prefix_t = 0;             // before this time
  std::optional<FirstFault> fault;
};

// Reads a report file. Throws InputError where it is none. The words say so where the files that
// the report names are there and have other bytes than those that were judged, where it does not
// tell of which bytes it is, and where it is by another program than this `producer`.
Explanation explain_report(const std::string& path, const std::string& producer);
// Explains the text of a report; `name` is for messages.
Explanation explain_report_text(const std::string& text, const std::string& name);

// Throws InputError, naming what differs, where the report `name` is not by this program, or not
// about contents with these hashes.
void require_report_of(const Explanation& report, const std::string& name,
                       const std::string& producer, const std::string& scene_sha256,
                       const std::string& history_sha256);

}  // namespace voroproof::internal
