// A certifier's report in words, and what of it can be drawn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exact/generators.h"
#include "history/events.h"

namespace voroproof {

// A generator of the evidence at the time of the event. Good to a few digits: for the eye.
struct DrawnGenerator {
  GenId id;
  Vec2 center, velocity;
  double radius;  // signed: the container's is negative
};

struct Explanation {
  std::string words;  // lines
  std::vector<DrawnGenerator> generators;
};

// Reads a report file. Throws InputError where it is none.
Explanation explain_report(const std::string& path);

}  // namespace voroproof
