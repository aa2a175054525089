// What a run over the corpus found, as a page that needs nothing but itself.
#pragma once

#include <string>
#include <vector>

#include "apps/corpus/report.h"

namespace voroproof::internal {

// The page: a table by family, then every case with its picture and what was found. The pictures
// are those of the cases, where they have one.
std::string report_html(const CorpusRunInfo& info, const std::vector<ProgramResult>& results);
std::string report_html(const CorpusRunInfo& info, const std::vector<OwnResult>& results);

}  // namespace voroproof::internal
