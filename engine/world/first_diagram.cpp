#include "engine/world/first_diagram.h"

#include <algorithm>

#include "engine/resting_diagram.h"
#include "engine/world/hosts.h"
#include "engine/world/moving_edge.h"
#include "engine/world/next_root.h"
#include "filtered/motion/options.h"
#include "filtered/worlds/rough_edge.h"

namespace voroproof::internal {
namespace {

constexpr int kMostTries = 64;
constexpr int kBitsATry = 8;

// The disks that are there as they are at one time.
class Snapshot {
 public:
  Snapshot(const MovingRows& rows, const Rational& t) : rows_(rows) {
    for (GenId g = 0; g < rows.disks(); ++g) {
      if (!rows.is_there(g)) continue;
      const GrowingDisk s = rows.state_at(g, t);
      least_ = names_.empty() ? s.radius : std::min(least_, s.radius);
      names_.push_back(g);
      input_.disks.push_back({s.x, s.y, s.radius, 0.0, 0.0, 1.0});
    }
    frame_ = rows.has_circle() ? Frame::circle : Frame::plane;
    if (rows.has_circle()) {
      const Site<TimePolynomial>& o = rows.circle();
      input_.container_x = o.x.evaluate(t);
      input_.container_y = o.y.evaluate(t);
      input_.container_radius = o.r.evaluate(t);
    } else if (!names_.empty()) {
      // Any place near the disks, and only differences of radii count.
      input_.container_x = input_.disks[0].x.value();
      input_.container_y = input_.disks[0].y.value();
      input_.container_radius = 1;
      for (DiskInput& d : input_.disks) d.radius = Rational(d.radius.value() - least_);
    }
  }

  bool has_radii() const { return names_.empty() || frame_ == Frame::plane || least_ >= 0; }

  LiveDiagram diagram() const {
    TierCounts counts;
    const RestingDiagram resting = resting_diagram(input_, frame_, {}, counts);
    const auto name = [&](GenId g) { return g < 0 ? g : names_[g]; };
    std::vector<GenId> host(static_cast<std::size_t>(rows_.disks()), LiveDiagram::absent);
    for (std::size_t k = 0; k < names_.size(); ++k) host[names_[k]] = name(resting.host[k]);
    std::vector<bool> unseen;
    for (const GenId h : host) unseen.push_back(h != LiveDiagram::visible);
    std::vector<Quad> edges;
    for (const Quad& q : resting.edges) {
      edges.push_back({name(q.l), name(q.r), name(q.s), name(q.e)});
    }
    LiveDiagram live(rows_.disks());
    live.begin(diagram_of(rows_.disks(), edges, unseen), host);
    return live;
  }

 private:
  const MovingRows& rows_;
  Frame frame_;
  std::vector<GenId> names_;  // by place in the input
  MotionInput input_;
  Rational least_;
};

// Whether the diagram, which is right at some time soon after 0, is so from 0 on.
bool is_right_after_zero(const MovingRows& rows, const LiveDiagram& live, const WorldTime& zero,
                         const Rational& soon) {
  for (GenId g = 0; g < rows.disks(); ++g) {
    const GenId host = live.host(g);
    if (host == LiveDiagram::absent) continue;
    const bool hidden = host != LiveDiagram::visible;
    if (hidden ? !hides_after(rows, host, g, zero) || exit_after(rows, host, g, zero, soon)
               : live.diagram().edges() == 0 && host_after(rows, g, zero) != LiveDiagram::visible) {
      return false;
    }
  }
  for (int edge = 0; edge < live.diagram().edges(); ++edge) {
    const Quad q = live.diagram().quad(2 * edge);
    const double until = round_up(soon);
    if (are_apart(rows.rough(), q.l, q.r, 0, until) &&
        (q.s == q.e || is_legal_edge(rows.rough(), q, 0, until))) {
      continue;
    }
    const TimePolynomial p = rows.tangency_of(q.l, q.r);
    const auto any = [](const WorldTime&, Sign) { return true; };
    if (sign_after(p, zero) != Sign::positive || first_root(p, zero, soon, any)) return false;
    const MovingEdge moving(rows, q);
    if (q.s != q.e &&
        (moving.collapses_at(zero) || first_root(moving.polynomial(), zero, soon, any)))
      return false;
  }
  return true;
}

}  // namespace

LiveDiagram first_diagram(const MovingRows& rows, const Rational& scale) {
  const WorldTime zero{Rational(0)};
  Rational soon = scale >> kBitsATry;
  for (int tries = 0; tries < kMostTries; ++tries, soon >>= kBitsATry) {
    const Snapshot snapshot(rows, soon);
    if (!snapshot.has_radii()) continue;
    LiveDiagram live = snapshot.diagram();
    if (is_right_after_zero(rows, live, zero, soon)) return live;
  }
  throw Undecided("no time after 0 is found before which nothing happens");
}

}  // namespace voroproof::internal
