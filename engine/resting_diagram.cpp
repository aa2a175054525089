#include "engine/resting_diagram.h"

#include <utility>

#include "engine/legalize.h"
#include "filtered/motion/given_motion.h"
#include "filtered/search/hidden_disks.h"
#include "filtered/search/resting_ties.h"

namespace voroproof::internal {

RestingDiagram resting_diagram(MotionInput input, Frame frame, const MotionOptions& options,
                               TierCounts& counts) {
  RestingDiagram out{hosts_of(input, frame), {}};
  std::vector<GenId> names;  // the visible disks
  for (GenId g = 0; g < static_cast<GenId>(out.host.size()); ++g) {
    if (out.host[g] != visible_disk) continue;
    input.disks[names.size()] = input.disks[g];
    names.push_back(g);
  }
  input.disks.resize(names.size());
  if (frame != Frame::box && names.size() < 2) return out;
  const GivenMotion motion(std::move(input), options);
  Diagram diagram = overlapping_diagram(motion, frame, counts);
  const RestingTies ties(motion, frame);
  legalize(diagram, [&](const Quad& q) { return ties.is_illegal(q); });
  const auto name = [&](GenId g) { return g == container_id ? g : names[g]; };
  for (const Quad& q : diagram.quads()) {
    out.edges.push_back({name(q.l), name(q.r), name(q.s), name(q.e)});
  }
  return out;
}

}  // namespace voroproof::internal
