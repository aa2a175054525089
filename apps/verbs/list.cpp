#include "apps/verbs/list.h"

#include <algorithm>
#include <ostream>

#include "apps/cli/interruption.h"

namespace voroproof::internal {

std::shared_ptr<ListRequest> add_list_options(Verb& verb, const std::vector<std::string>& single) {
  auto request = std::make_shared<ListRequest>();
  verb.input("--list", request->list,
             "Do this for many scenes: each line of this file names a scene and a history, with a "
             "tab between them. The limits of time and memory are those of each run. The exit code "
             "is that of the worst run.")
      .excludes(single);
  verb.output("--json", request->json,
              "Write the table of the runs here. Rows that it has already, of the same files and "
              "options, are kept and not run again.")
      .needs("--list");
  verb.output("--csv", request->csv, "Write the table here as comma-separated values.")
      .needs("--list");
  verb.whole("--jobs", request->jobs, 1, 1024, "The number of runs side by side.").needs("--list");
  verb.starts_runs_with("--list");
  return request;
}

ExitCode run_listed(const Verb& verb, ListRequest request, const ListedVerb& listed) {
  require_distinct({request.list}, {request.json, request.csv});
  request.options = verb.given_words({"--list", "--json", "--csv", "--jobs", "--quiet"});
  CooperativeInterruption interruption;
  const RunTable table = run_list(request, listed, [&] {
    if (!interruption.requested()) return true;
    interruption.wind_up();  // the writing of the results so far is waited for
    return false;
  });
  interruption.wind_up();
  write_run_tables(request, table);
  words_beside({request.json, request.csv}) << table_words(table);
  return worst_of(table);
}

}  // namespace voroproof::internal
