// The request to the verb certify.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "apps/cli/verb.h"
#include "apps/verbs/certify_diagram.h"
#include "certify/options.h"

namespace voroproof::internal {

struct CertifyRequest {
  std::string scene, history, report, truth = "exact", events = "all", order = "format",
                                      tolerance = "1e-6", law_tolerance = "1e-9", part, index;
  std::vector<std::string> shards;  // to be merged
  DiagramRequest diagram;
  CertifyOptions options;
  std::uint64_t max_events = 0, checkpoint = 10;
  bool quiet = false, least_tolerances = false, kernel = false, proved = false, resume = false;
};

// Reads the tolerances asked for, which must mean something for a history with that horizon. Throws
// UsageError.
void read_tolerances(const CertifyRequest& request, const Rational& horizon,
                     CertifyOptions& options);

// Adds the verb with all its options, which are read into the request.
Verb& add_certify_options(Verb& program, const std::shared_ptr<CertifyRequest>& request);

}  // namespace voroproof::internal
