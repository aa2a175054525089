// What the verbs that certify histories share.
#pragma once

#include <string>
#include <vector>

#include "certify/report.h"
#include "history/claim.h"

namespace voroproof {

// A diagram for histories that give none (CertifyOptions::propose_initial); the certifier proves it
// or refutes it.
std::vector<Quad> construct_initial(Motion& motion);

// What the report says of the two files; `producer` is this program.
CertificationRun certification_run(const std::string& producer, const std::string& scene_path,
                                   const std::string& history_path, const Claim& claim);

}  // namespace voroproof
