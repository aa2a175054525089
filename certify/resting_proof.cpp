#include "certify/resting_proof.h"

#include <algorithm>
#include <stdexcept>

#include "exact/names.h"
#include "filtered/motion/given_motion.h"
#include "filtered/search/hidden_disks.h"
#include "filtered/search/resting_ties.h"

namespace voroproof::internal {

namespace {

InitialFault fault_of_disk(GenId g, const std::string& truth) {
  return {"disk " + std::to_string(g) + truth, {}, {}, {}, g};
}

// Walls are the generators from `walls` on.
std::string hidden_by(GenId host, GenId walls) {
  if (host == container_id) return " lies outside of the frame";
  if (host >= walls) return " lies behind wall " + std::to_string(host);
  return " is hidden by disk " + std::to_string(host);
}

GenId disks_of(const RestingClaim& claim) {
  return disk_count(claim.frame, static_cast<GenId>(claim.input.disks.size()));
}

// The fault of the host that is claimed for g, if there is one.
std::optional<InitialFault> host_fault(const RestingClaim& claim, GenId g,
                                       const std::vector<GenId>& hosts) {
  const GenId claimed = claim.hosts[g];
  if (hosts[g] == visible_disk) {
    if (claimed == visible_disk) return std::nullopt;
    return fault_of_disk(g, " is not hidden");
  }
  const GenId walls = disks_of(claim);
  if (claimed == visible_disk) return fault_of_disk(g, hidden_by(hosts[g], walls));
  const DiskInput& disk = claim.input.disks[g];
  if (claimed == container_id) {
    if (claim.frame == Frame::circle && is_outside(claim.input, disk)) return std::nullopt;
    return fault_of_disk(g, " does not lie outside of a frame");
  }
  if (claimed >= walls) {
    if (is_behind(claim.input, claimed, g)) return std::nullopt;
    return fault_of_disk(g, " does not lie behind wall " + std::to_string(claimed));
  }
  if (!contains(claim.input.disks[claimed], disk)) {
    return fault_of_disk(g, " does not lie in disk " + std::to_string(claimed));
  }
  if (hosts[claimed] == visible_disk) return std::nullopt;
  return fault_of_disk(claimed, hidden_by(hosts[claimed], walls) + ", and hides nobody");
}

}  // namespace

RestingProof resting_proof(const RestingClaim& claim, const MotionOptions& options,
                           TierCounts& counts, int threads) {
  RestingProof proof;
  const std::vector<GenId> hosts = hosts_of(claim.input, claim.frame);
  const auto n = static_cast<GenId>(hosts.size());
  const GenId walls = disks_of(claim);
  std::vector<bool>& hidden = proof.hidden;
  for (GenId g = 0; g < n; ++g) {
    hidden.push_back(hosts[g] != visible_disk);
    if (g >= walls) continue;
    proof.visible += hidden.back() ? 0 : 1;
    if (claim.hosts.empty()) continue;
    if ((proof.fault = host_fault(claim, g, hosts))) return proof;
  }
  Diagram diagram(n);
  for (const Quad& q : claim.edges) {
    for (const GenId g : {q.l, q.r, q.s, q.e}) {
      if (g < 0 || g >= n || !hidden[g]) continue;
      proof.fault =
          fault_of_disk(g, hidden_by(hosts[g], walls) + ", and edge " + text_of(q) + " names it");
      return proof;
    }
  }
  try {
    diagram = diagram_of(n, claim.edges, hidden);
  } catch (const std::invalid_argument& why) {
    proof.fault = InitialFault{why.what(), {}, {}, {}, {}};
    return proof;
  }
  if (claim.frame != Frame::box && proof.visible < 2) return proof;
  const GivenMotion motion(claim.input, options);
  proof.fault = resting_fault(diagram, claim.frame, motion, counts, threads);
  if (proof.fault) return proof;
  const RestingTies ties(motion, claim.frame);
  for (const Quad& q : claim.edges) {
    if (q.s == q.e || !ties.is_point(q)) continue;
    ++proof.points;
    if (!legal_while_cotangent(q)) ++proof.chosen_otherwise;
  }
  return proof;
}

}  // namespace voroproof::internal
