// What is said of the clearance of given paths: JSON for programs (docs/formats.md, section 18),
// lines for people.
#pragma once

#include <optional>
#include <string>

#include "apps/answers/query_answer.h"
#include "planning/given_clearance.h"

namespace voroproof::internal {

struct ClearanceQuestion {
  std::string file;
  std::optional<Rational> below;     // approaches nearer than this are listed
  std::optional<Rational> required;  // the gap that is to be kept
};

struct ClearanceAnswer {
  Answer answer;
  bool refuted = false;  // something is required and not kept
};

// Throws Interrupted where `go_on` says no.
ClearanceAnswer answer_clearance(const ClearanceQuestion& question, const GivenPaths& given,
                                 const std::function<bool()>& go_on);

}  // namespace voroproof::internal
