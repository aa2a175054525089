// The result of a run over the corpus, as a page that needs nothing but itself.
#pragma once

#include <string>
#include <vector>

#include "apps/corpus/report.h"

namespace voroproof::internal {

// The page of apps/corpus/page/ with its data, an element "report": what the JSON file holds and,
// of each case, its `story`, its `sources` and, where it has one, its `picture`.
std::string report_html(const CorpusRunInfo& info, const std::vector<ProgramResult>& results);
std::string report_html(const CorpusRunInfo& info, const std::vector<OwnResult>& results);

}  // namespace voroproof::internal
