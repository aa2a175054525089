// The diagram just after an instant.
#include <set>
#include <utility>
#include <vector>

#include "engine/static_diagram.h"
#include "exact/predicates.h"
#include "filtered/search/collapse.h"

namespace voroproof::internal {

long settle(Diagram& diagram, Motion& motion, const Moment& now, TierCounts& counts) {
  CollapseSearch search(motion, counts);
  std::set<std::pair<Quad, Diagram::HalfEdge>> illegal;
  const DoubleBall t = DoubleBall::hull(now.lo, now.hi);
  std::vector<Site<DoubleBall>> sites;
  sites.reserve(motion.size() + 1);
  for (GenId g = container_id; g < motion.size(); ++g) sites.push_back(motion.site(g, t));
  const auto examine = [&](Diagram::HalfEdge h) {
    const Quad q = diagram.quad(h);
    if (q.s == q.e) return;
    const auto at = [&](GenId g) -> const Site<DoubleBall>& { return sites[g + 1]; };
    if (is_certain(sign(cotangency(at(q.l), at(q.r), at(q.s), at(q.e))))) return;
    if (search.from(q, now, now.hi).kind == Collapse::Kind::now) {
      illegal.insert({canonical(q), h & ~1});
    }
  };
  for (Diagram::HalfEdge h = 0; h < 2 * diagram.edges(); h += 2) examine(h);
  long flips = 0;
  while (!illegal.empty()) {
    const Diagram::HalfEdge h = illegal.begin()->second;
    illegal.erase(illegal.begin());
    const Diagram::HalfEdge around[4] = {diagram.next(h), diagram.previous(h), diagram.next(h ^ 1),
                                         diagram.previous(h ^ 1)};
    for (const Diagram::HalfEdge a : around) illegal.erase({canonical(diagram.quad(a)), a & ~1});
    diagram.flip(h);
    ++flips;
    examine(h);
    for (const Diagram::HalfEdge a : around) examine(a);
  }
  return flips;
}

}  // namespace voroproof::internal
