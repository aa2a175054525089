// Many runs of one verb: which they are, and the table of what came out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/command_line.h"

namespace voroproof::internal {

// A line of a list: the names of a scene, and of the history to read or to write.
struct ListedRun {
  std::string scene, history;

  bool operator==(const ListedRun&) const = default;
};

// Reads a list (docs/formats.md, section 17). Throws InputError naming the line.
std::vector<ListedRun> read_run_list(const std::string& path);

struct RunRow {
  ListedRun run;
  std::optional<ExitCode> code;              // nothing: the run has not ended
  std::string words;                         // the verdict, where a report says more than the code
  std::vector<std::string> says;             // the subject of the verdict, and each reservation
  std::string reason;                        // reason of a code other than ok
  std::string scene_sha256, history_sha256;  // hashes of the files; empty where unreadable
  std::vector<std::string> options;          // that the run had
  // How far the run came, where it says so.
  std::optional<std::int64_t> events;
  std::optional<double> t;
};

struct RunTable {
  std::string verb, producer;
  std::vector<RunRow> rows;  // in the order of the list
};

// The verdict of a run of the verb, in capitals; "NOT RUN" where it has not ended.
std::string verdict_of(const std::string& verb, const RunRow& row);

// The exit code of the whole: that of the worst row. From the worst on: interrupted, a fault of the
// program, out of memory, refuted, bad input, undecided, good.
ExitCode worst_of(const RunTable& table);

std::string table_csv(const RunTable& table);
std::string table_json(const RunTable& table);
// A line for each row, and one with the numbers of rows of each verdict.
std::string table_words(const RunTable& table);

// Reads what table_json() wrote. Throws InputError where the file is no table of this verb.
RunTable read_run_table(const std::string& path, const std::string& verb);

}  // namespace voroproof::internal
