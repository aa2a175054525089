// The answer about the clearance of given paths: JSON for programs (docs/formats.md, section 18),
// lines for people.
#pragma once

#include <optional>
#include <string>

#include "apps/answers/query_answer.h"
#include "library/planning/given_clearance.h"

namespace voroproof::internal {

struct ClearanceQuestion {
  std::string file;
  std::optional<Rational> below;     // approaches nearer than this are listed
  std::optional<Rational> required;  // the gap that is to be kept; negative: an overlap allowed
  Touching touching = Touching::is_too_near;
  ClearanceRules rules;
};

// Whether all gaps are as required. Free: they are, in the whole time, of all that may come near.
// Undecided: those of the paths are, but something is missing, or there is no gap at all; or a gap
// of curves is the required one, but for less than can be told.
enum class Freedom { not_asked, free, refuted, undecided };

struct ClearanceAnswer {
  Answer answer;
  std::string table;  // the approaches that were asked for, as a table of comma-separated values
  Freedom freedom = Freedom::not_asked;
};

// Throws Interrupted where `go_on` says no.
ClearanceAnswer answer_clearance(const ClearanceQuestion& question, const GivenPaths& given,
                                 const std::function<bool()>& go_on);

}  // namespace voroproof::internal
