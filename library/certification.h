// The common parts of the verbs that certify histories.
#pragma once

#include <string>
#include <vector>

#include "certify/report.h"
#include "exact/billiard.h"
#include "history/claim.h"

namespace voroproof::internal {

// Requires tolerances that mean something for a history with that horizon (docs/formats.md, section
// 8). A greater tolerance would accept any time, or any velocity, and would only cost: each claim
// is looked at beside all others that may be in its place. Throws std::invalid_argument for such a
// tolerance, and for an order of instants that is asked for where none is judged, naming the option
// and the reason.
void require_meaningful(const CertifyOptions& options, const Rational& horizon);

// A diagram for histories that give none (CertifyOptions::propose_initial); the certifier proves it
// or refutes it.
std::vector<Quad> construct_initial(Motion& motion);

// The words of a third party about the witness of a refutation (certify/evidence/evidence.h); empty
// without one. Throws std::logic_error, with the files to report, where it says that the witness is
// false: then the certifier is not to be believed, and nothing may be printed.
std::string checked_evidence(const Certificate& certificate, const std::string& scene_path,
                             const std::string& history_path);

// Whether there is a regular file of that name whose content has another hash than this one.
bool has_other_bytes(const std::string& path, const std::string& sha256);

// The report's facts about the two files and the evidence; `producer` is this program.
CertificationRun certification_run(const std::string& producer, const std::string& scene_path,
                                   const std::string& history_path, const Claim& claim,
                                   const std::string& evidence);
CertificationRun certification_run(const std::string& producer, const std::string& scene_path,
                                   const std::string& history_path, const Billiard& billiard,
                                   const HistoryHeader& header);

}  // namespace voroproof::internal
