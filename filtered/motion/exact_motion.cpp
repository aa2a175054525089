#include "filtered/motion/exact_motion.h"

#include <algorithm>

namespace voroproof::internal {

namespace {

// The limit of exact arithmetic, which is slow far sooner than balls are.
constexpr std::size_t kMaxCoefficientBits = 1 << 16;

}  // namespace

ExactMotion::ExactMotion(const Motion& motion)
    : motion_(motion),
      field_(RadicalField::Budget{
          motion.options().max_radicals,
          std::min(kMaxCoefficientBits, static_cast<std::size_t>(motion.options().max_bits) * 4)}) {
}

const ExactMotion::State& ExactMotion::state(GenId g) {
  return entry(motion_.state_id(g), g).state;
}
const ExactMotion::State& ExactMotion::state(int id, GenId g) { return entry(id, g).state; }
const Tower& ExactMotion::start(int id, GenId g) { return entry(id, g).start; }

Tower ExactMotion::radius(GenId g) const {
  const MotionInput& in = motion_.input();
  return g == container_id ? Tower(Rational(-in.container_radius))
                           : Tower(Rational(in.disks[g].radius));
}

long ExactMotion::key(int id, GenId g) const {
  return static_cast<long>(id) * (motion_.size() + 1) + (g + 1);
}

const ExactMotion::Entry& ExactMotion::entry(int id, GenId g) {
  if (const auto it = memo_.find(key(id, g)); it != memo_.end()) return it->second;
  if (id > 0) {
    motion_.compute_exactly(id, g, *this);
  } else if (g == container_id) {
    note(id, g, {0, 0, 0, 0, 0}, 0);
  } else {
    const DiskInput& d = motion_.initial_state(g);
    const Rational start = to_rational(motion_.initial_time(g));
    note(id, g,
         {start, Tower(d.x.value()), Tower(d.y.value()), Tower(d.vx.value()), Tower(d.vy.value())},
         Tower(start));
  }
  return memo_.at(key(id, g));
}

MovingSite<Tower> ExactMotion::moving_site(GenId g, const Rational& t) {
  const State& s = state(g);
  const Tower dt(Rational(t - s.t_ref));
  return {s.x + s.vx * dt, s.y + s.vy * dt, s.vx, s.vy, radius(g)};
}

Site<Tower> ExactMotion::site(GenId g, const Tower& t) {
  const State& s = state(g);
  const Tower dt = t - Tower(s.t_ref);
  return {s.x + s.vx * dt, s.y + s.vy * dt, radius(g)};
}

}  // namespace voroproof::internal
