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
  std::optional<Rational> required;  // the gap that is to be kept
};

// Whether all gaps are as required. Free: they are, in the whole time, of all that may come near.
// Undecided: those of the paths are, but something is missing, or there is no gap at all.
enum class Freedom { not_asked, free, refuted, undecided };

struct ClearanceAnswer {
  Answer answer;
  Freedom freedom = Freedom::not_asked;
};

// Throws Interrupted where `go_on` says no.
ClearanceAnswer answer_clearance(const ClearanceQuestion& question, const GivenPaths& given,
                                 const std::function<bool()>& go_on);

}  // namespace voroproof::internal
