#include "certify/orientation.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "filtered/search/collapse.h"

namespace voroproof::internal {

namespace {

// The four generators alone, in the order of their ids.
class Four {
 public:
  Four(const Replay& replay, const Scene& scene, const CertifyOptions& options, const Quad& q)
      : ids_{q.l, q.r, q.s, q.e}, motion_(alone(scene), options.motion) {
    for (const GenId g : ids_) {
      if (g == container_id || !replay.moved(g)) continue;
      const Path& path = replay.path(g);
      const Rational t = path.since();
      const ExactVec2 p = path.at(t), v = path.velocity().value();
      motion_.restart(id(g), t, p[0], p[1], v[0], v[1]);
      since_ = std::max(since_, t);
    }
  }

  // Whether the edge collapses no more than the tolerance from t.
  bool collapses(const Quad& q, const Rational& t, const Rational& tolerance) {
    const double from = round_up(std::max(since_, Rational(t - tolerance)));
    const double end = round_up(Rational(t + tolerance));
    const Quad renamed{id(q.l), id(q.r), id(q.s), id(q.e)};
    TierCounts counts;
    try {
      for (double at = from; at < end;) {
        const Collapse c = CollapseSearch(motion_, counts).after(renamed, at, end);
        if (c.kind == Collapse::Kind::root) return true;
        if (!(c.lo > at)) return false;
        at = c.lo;
      }
    } catch (const Undecided&) {
      // Then the proof does not come past this flip either, or finds the diagram another one.
    }
    return false;
  }

 private:
  // Sorts ids_, with the container first or not there.
  MotionInput alone(const Scene& scene) {
    std::sort(ids_.begin(), ids_.end());
    std::vector<DiskInput> disks;
    for (const GenId g : ids_) {
      if (g == container_id) continue;
      const DiskInput& d = scene.disks[g];
      disks.push_back({d.x, d.y, d.radius, d.vx, d.vy, 1});
    }
    MotionInput input;
    input.container_x = scene.cx;
    input.container_y = scene.cy;
    input.container_radius = scene.container_radius;
    input.horizon = scene.horizon;
    input.disks = std::move(disks);
    return input;
  }

  GenId id(GenId g) const {
    if (g == container_id) return g;
    const auto at = std::find(ids_.begin(), ids_.end(), g) - ids_.begin();
    return static_cast<GenId>(at) - (ids_[0] == container_id ? 1 : 0);
  }

  std::array<GenId, 4> ids_;
  GivenMotion motion_;
  Rational since_ = 0;
};

}  // namespace

bool means_mirrored(const Replay& replay, const Scene& scene, const CertifyOptions& options,
                    const FlipEvent& claim, const Quad& mirrored) {
  const Rational t = exact_time(Event(claim));
  Four four(replay, scene, options, claim.quad);
  return !four.collapses(claim.quad, t, options.tolerance) &&
         four.collapses(mirrored, t, options.tolerance);
}

}  // namespace voroproof::internal
