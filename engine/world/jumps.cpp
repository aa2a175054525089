#include "engine/world/jumps.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "filtered/motion/options.h"

namespace voroproof::internal {
namespace {

// Who hides a disk once it is small, and a radius with which it certainly does.
struct Hiding {
  GenId host = LiveDiagram::visible;  // this: nobody is there
  Rational radius;
};

// The one whose boundary is nearest of all generators that are there, as they rest, but for
// rounding.
Hiding hiding_of(const MovingRows& rest, GenId g) {
  const auto place = [&](GenId j) { return rest.rough().site(j, DdBall(0)); };
  const Site<DdBall> own = place(g);
  Hiding best;
  double largest = 0, size = 0;
  const auto take = [&](GenId j) {
    const Site<DdBall> site = place(j);
    const double distance = std::hypot((site.x - own.x).hi, (site.y - own.y).hi);
    const double at_touch = j == container_id ? distance - site.r.hi : site.r.hi - distance;
    if (best.host == LiveDiagram::visible || at_touch > largest) {
      best.host = j;
      largest = at_touch;
      size = distance + std::fabs(at_touch);
    }
  };
  if (rest.has_circle()) take(container_id);
  for (GenId j = 0; j < rest.disks(); ++j) {
    if (j != g && rest.is_there(j)) take(j);
  }
  // By more than what rounding can do.
  const double below = size > 0 ? size * 0x1p-20 : 1;
  best.radius = to_rational(largest) - to_rational(below);
  return best;
}

struct StepList final : ChangeSink {
  std::vector<Step> steps;
  bool takes_swaps() const override { return false; }
  void change(const LazyTime&, const WorldChange& change) override {
    steps.push_back(step_of(change));
  }
};

// All rest but g, whose radius changes from `radius` by `rate` in a unit of time.
JumpSteps run(LiveDiagram& live, MovingRows rest, GenId g, const Rational& radius, int rate,
              const Rational& length) {
  GrowingDisk state = rest.state_at(g, 0);
  state.radius = radius;
  state.growth = rate;
  rest.set(g, 0, state);
  StepList list;
  WorldSweep sweep(live, rest, 0, length, list);
  sweep.turn(g);
  sweep.settle();
  sweep.look_ahead();
  sweep.run_before(length);
  return {std::move(list.steps),
          {sweep.edges_seen().begin(), sweep.edges_seen().end()},
          {sweep.disks_seen().begin(), sweep.disks_seen().end()}};
}

}  // namespace

Step step_of(const WorldChange& change) {
  if (const auto* q = std::get_if<Quad>(&change)) return *q;
  if (const auto* hide = std::get_if<Hide>(&change)) return *hide;
  if (const auto* appear = std::get_if<Appear>(&change)) return *appear;
  throw std::logic_error("a swap is no step");
}

JumpSteps shrink_out(LiveDiagram& live, const MovingRows& rows, GenId g, const Rational& t) {
  const MovingRows rest = rows.resting_at(t);
  const Hiding hiding = hiding_of(rest, g);
  const bool alone = live.visible_disks() == 1 && live.guests(g).empty();
  JumpSteps out;
  if (!alone) {
    const Rational radius = rest.state_at(g, 0).radius;
    out = run(live, rest, g, radius, -1, radius - hiding.radius);
  }
  if (live.is_visible(g) && live.diagram().edges() > 0) {
    throw Undecided("a disk that goes is not hidden by another");
  }
  // Without edges nothing tells that it is hidden.
  if (live.visible_disks() < 2 && !out.steps.empty()) out.steps.pop_back();
  live.set_host(g, LiveDiagram::absent);
  out.disks.push_back(g);
  return out;
}

JumpSteps grow_in(LiveDiagram& live, const MovingRows& rows, GenId g, const Rational& t) {
  const MovingRows rest = rows.resting_at(t);
  const Hiding hiding = hiding_of(rest, g);
  JumpSteps out;
  if (hiding.host == LiveDiagram::visible) {
    live.appear(g);
    out.steps.emplace_back(Appear{g, container_id, std::nullopt});
  } else {
    GenId host = hiding.host;
    while (host >= 0 && !live.is_visible(host)) host = live.host(host);
    live.set_host(g, host);
    const Rational radius = rest.state_at(g, 0).radius;
    if (radius > hiding.radius) out = run(live, rest, g, hiding.radius, 1, radius - hiding.radius);
  }
  out.disks.push_back(g);
  return out;
}

}  // namespace voroproof::internal
