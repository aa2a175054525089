// voroproof certify --diagram: is this the diagram of the disks?
#pragma once

#include <string>
#include <vector>

#include "apps/cli/verb.h"

namespace voroproof::internal {

struct DiagramRequest {
  std::vector<std::string> files;  // one of a diagram, or a table of disks and a list of edges
  std::string frame, tolerance = "1e-9";
  int threads = 1;
  bool quiet = false;
};

// Adds the options that the request is read from, but for `threads` and `quiet`. It must outlive
// the verb.
void add_diagram_options(Verb& verb, DiagramRequest& request);

// Proves or refutes it, and says so. Throws UsageError and InputError.
ExitCode certify_diagram_files(const DiagramRequest& request);

}  // namespace voroproof::internal
