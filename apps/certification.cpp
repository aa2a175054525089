#include "apps/certification.h"

#include "kinetic/static_diagram.h"

namespace voroproof {

std::vector<Quad> construct_initial(Motion& motion) {
  TierCounts counts;
  Diagram diagram = static_diagram(motion, 0, counts);
  settle(diagram, motion, instant_at(0), counts);
  return diagram.quads();
}

CertificationRun certification_run(const std::string& producer, const std::string& scene_path,
                                   const std::string& history_path, const Claim& claim) {
  const HistoryHeader& header = claim.history->header();
  return {.producer = producer,
          .scene_file = scene_path,
          .history_file = history_path,
          .scene_sha256 = claim.scene.sha256,
          .history_producer = header.producer,
          .disks = static_cast<int>(claim.scene.disks.size()),
          .horizon = header.horizon};
}

}  // namespace voroproof
