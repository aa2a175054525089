// The diagram just after an instant.
#include <vector>

#include "engine/legalize.h"
#include "engine/static_diagram.h"
#include "exact/predicates.h"
#include "filtered/search/collapse.h"

namespace voroproof::internal {

long settle(Diagram& diagram, Motion& motion, const Moment& now, TierCounts& counts) {
  CollapseSearch search(motion, counts);
  const DoubleBall t = DoubleBall::hull(now.lo, now.hi);
  std::vector<Site<DoubleBall>> sites;
  sites.reserve(motion.size() + 1);
  for (GenId g = container_id; g < motion.size(); ++g) sites.push_back(motion.site(g, t));
  return legalize(diagram, [&](const Quad& q) {
    const auto at = [&](GenId g) -> const Site<DoubleBall>& { return sites[g + 1]; };
    if (is_certain(sign(cotangency(at(q.l), at(q.r), at(q.s), at(q.e))))) return false;
    return search.from(q, now, now.hi).kind == Collapse::Kind::now;
  });
}

}  // namespace voroproof::internal
