// A verb for each line of a list, in processes of their own.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/run/run_table.h"

namespace voroproof::internal {

struct ListRequest {
  std::string list;       // the file with the list
  std::string json, csv;  // tables to write; empty: none
  std::size_t jobs = 1;   // runs side by side
  // The options of every run besides its two files, as on the command line.
  std::vector<std::string> options;
};

// The differences between the verbs that run lists.
struct ListedVerb {
  std::string name;
  // The words of a run, the verb first, which writes its results, as JSON, to `result`.
  std::function<std::vector<std::string>(const ListedRun& run, const std::string& result)>
      arguments;
  // Takes of the row from these results what they say: `events`, `t`, the words, and the hashes of
  // what was read.
  std::function<void(const std::string& result, RunRow& row)> read;
  bool writes_history = false;
};

// Runs this program for each line of the list and returns the table. Rows of the table that is
// there already (request.json) are kept where they say what a run would say again: those of this
// version, of files with the same contents, with the same options; of runs that came to a verdict
// the limits of time and of memory may differ. The tables are written anew every few seconds, so
// that a run that is killed can be continued. Asked several times a second whether to `go_on`;
// where not, those that run are asked to end and waited for, and the rows of the others say that
// they did not run. Throws InputError for a bad list.
RunTable run_list(const ListRequest& request, const ListedVerb& verb,
                  const std::function<bool()>& go_on);

// Writes the tables that were asked for. Throws OutputError.
void write_run_tables(const ListRequest& request, const RunTable& table);

}  // namespace voroproof::internal
