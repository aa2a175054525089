// The result of a run over the corpus, as a table for the terminal and as JSON.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/corpus/run.h"

namespace voroproof::internal {

// How the run was made.
struct CorpusRunInfo {
  std::string producer;  // the program that gave the verdicts: this one
  std::string command;   // empty where the corpus was held against itself
  std::vector<Truth> truths;
  EventKinds events = EventKinds::all;
  ProcessLimits limits;
};

// The cases of a family, counted.
struct FamilyTally {
  std::string family;
  int cases = 0, passed = 0;
  int exact = 0, recorded = 0;  // certified against this truth
  std::array<int, static_cast<std::size_t>(CaseOutcome::count)> outcomes{};
  std::map<std::string, int> kinds;  // counts of faults among the refuted cases
  double seconds = 0;                // time that the program took
};

// One for each family, in order, and a last one named "all".
std::vector<FamilyTally> tallies(const std::vector<ProgramResult>& results);

// "missing event 3", "wrong time 1", the most frequent first.
std::vector<std::string> kind_counts(const FamilyTally& tally);

// The words with commas between them.
std::string joined(const std::vector<std::string>& words);

// "0.004", "12.3": seconds to three places at most.
std::string seconds_text(double seconds);

// Columns of text, each as wide as its widest cell; numbers to the right. The first row is the
// head.
std::string table_text(const std::vector<std::vector<std::string>>& rows);

// The table by family and, before it, a line for each case that did not pass.
std::string report_for_terminal(const CorpusRunInfo& info,
                                const std::vector<ProgramResult>& results);
std::string report_for_terminal(const CorpusRunInfo& info, const std::vector<OwnResult>& results);

// The content of the JSON file, and its text; packaging/schemas/corpus-report.schema.json lists its
// fields.
nlohmann::ordered_json report_data(const CorpusRunInfo& info,
                                   const std::vector<ProgramResult>& results);
nlohmann::ordered_json report_data(const CorpusRunInfo& info,
                                   const std::vector<OwnResult>& results);
std::string report_json(const CorpusRunInfo& info, const std::vector<ProgramResult>& results);
std::string report_json(const CorpusRunInfo& info, const std::vector<OwnResult>& results);

}  // namespace voroproof::internal
