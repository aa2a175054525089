#include "library/certification.h"

#include <algorithm>
#include <stdexcept>

#include "certify/evidence/evidence.h"
#include "engine/static_diagram.h"
#include "history/descriptor.h"
#include "history/error.h"
#include "history/json_text.h"
#include "history/sha256.h"

namespace voroproof::internal {
namespace {

template <class Scene>
CertificationRun run_of(const std::string& producer, const std::string& scene_path,
                        const std::string& history_path, const Scene& scene,
                        const HistoryHeader& header) {
  return {.producer = producer,
          .scene_file = scene_path,
          .history_file = history_path,
          .scene_sha256 = scene.sha256,
          .history_sha256 = {},
          .history_producer = header.producer,
          .disks = static_cast<int>(scene.disks.size()),
          .horizon = header.certain_horizon()};
}

}  // namespace

void require_meaningful(const CertifyOptions& options, const Rational& horizon) {
  static const Rational always_meaningful(1, 1'000'000);
  if (options.tolerance > std::max(horizon, always_meaningful)) {
    throw std::invalid_argument("tolerance: more than the horizon of the history, " +
                                number_text(round_nearest(horizon)) + ": any time would do");
  }
  if (options.any_order && options.truth == Truth::recorded) {
    throw std::invalid_argument(
        "order: the recorded truth takes the order of one instant as the history has it");
  }
  if (options.law_tolerance > 1) {
    throw std::invalid_argument("law-tolerance: more than 1: any velocity would do");
  }
}

std::vector<Quad> construct_initial(Motion& motion) {
  TierCounts counts;
  Diagram diagram = static_diagram(motion, 0, counts);
  settle(diagram, motion, Moment::at(0), counts);
  return diagram.quads();
}

std::string checked_evidence(const Certificate& certificate, const std::string& scene_path,
                             const std::string& history_path) {
  if (!certificate.divergence) return {};
  const EvidenceCheck check = check_evidence(*certificate.divergence);
  if (check.evidence == Evidence::contradicted) {
    throw std::logic_error("CGAL contradicts the witness of the refutation (" + check.sentence +
                           "); please report the files " + scene_path + " and " + history_path +
                           " (" + reason_line(certificate) + ")");
  }
  return check.sentence;
}

bool has_other_bytes(const std::string& path, const std::string& sha256) {
  if (is_stream(path)) return false;
  try {
    return !sha256.empty() && sha256_of_file(path) != sha256;
  } catch (const InputError&) {
    return false;  // it is not there
  }
}

CertificationRun certification_run(const std::string& producer, const std::string& scene_path,
                                   const std::string& history_path, const Claim& claim,
                                   const std::string& evidence) {
  CertificationRun run =
      run_of(producer, scene_path, history_path, claim.scene, claim.history->header());
  run.evidence = evidence;
  return run;
}

CertificationRun certification_run(const std::string& producer, const std::string& scene_path,
                                   const std::string& history_path, const Billiard& billiard,
                                   const HistoryHeader& header) {
  return run_of(producer, scene_path, history_path, billiard, header);
}

}  // namespace voroproof::internal
