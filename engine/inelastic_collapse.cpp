#include "engine/inelastic_collapse.h"

#include <cmath>
#include <string>

#include "engine/collapse_rule.h"

namespace voroproof::internal {

namespace {

// A disk alone at the wall is looked at when all its bounces to come take less than this part of
// the horizon (later they are too short for binary64 times), or each time it has bounced that often
// (weak losses: the bounces would be many, and each costs bits).
constexpr double kShortRest = 1e-9;
constexpr int kManyBounces = 48;

// A rational as a double with a bound; get_d() rounds towards zero.
DoubleBall ball_of(const Rational& q) {
  const double x = q.get_d();
  return {x, std::fabs(x) * 0x1p-52};
}

double upper(const DoubleBall& b) { return (b.mid + b.rad) * (1 + 0x1p-50); }

}  // namespace

InelasticCollapse::InelasticCollapse(const Motion& motion)
    : motion_(motion),
      horizon_(round_up(motion.input().horizon)),
      possible_(motion.input().restitution < 1 || motion.input().container_restitution < 1) {
  if (possible_) past_.resize(motion.size());
}

void InelasticCollapse::after_collision(GenId i, GenId j, const Moment& now, double quiet_until) {
  if (!possible_) return;
  for (const GenId g : {i, j}) {
    if (g == container_id) continue;
    Past& past = past_[g];
    past.at_wall = i == container_id ? past.at_wall + 1 : 0;
    if (i == container_id) alone_at_wall(g, now, quiet_until);
    const std::string why = seeming_collapse(g, now.lo, horizon_, past.times);
    if (!why.empty()) throw Undecided("inelastic " + why, i, j);
  }
}

void InelasticCollapse::alone_at_wall(GenId g, const Moment& now, double quiet_until) {
  const MotionInput& in = motion_.input();
  if (in.whole_container_law || in.container_restitution == 1) return;
  const DoubleBall t = DoubleBall::hull(now.lo, now.hi);
  const MovingSite<DoubleBall> disk = motion_.moving_site(g, t);
  const MovingSite<DoubleBall> wall = motion_.moving_site(container_id, t);
  const DoubleBall nx = disk.x - wall.x, ny = disk.y - wall.y;
  const DoubleBall rho = -(wall.r + disk.r);
  const DoubleBall u = -(nx * disk.vx + ny * disk.vy) / rho;
  const DoubleBall w = (nx * disk.vy - ny * disk.vx) / rho;
  const DoubleBall loss = DoubleBall(1) - ball_of(in.container_restitution);
  const DoubleBall delay = DoubleBall(2) * rho * u / (w * w * loss);
  if (sign(u) != Sign::positive || sign(w * w) != Sign::positive) return;
  const bool many = past_[g].at_wall % kManyBounces == 0;
  if (!(upper(delay) < kShortRest * horizon_) && !many) return;
  const double last = upper(t + delay);
  if (!(last < quiet_until) || !(last < round_down(in.horizon))) return;
  if (!undisturbed(g, t, sqrt(u * u + w * w), delay)) return;
  throw Undecided("inelastic collapse: disk " + std::to_string(g) +
                      " collides with the container infinitely often before t = " + time_text(last),
                  container_id, g);
}

bool InelasticCollapse::undisturbed(GenId g, const DoubleBall& t, const DoubleBall& speed,
                                    const DoubleBall& delay) const {
  const MotionInput& in = motion_.input();
  DoubleBall twice_energy(0);
  for (GenId j = 0; j < motion_.size(); ++j) {
    const MovingSite<DoubleBall> m = motion_.moving_site(j, t);
    twice_energy = twice_energy + ball_of(in.disks[j].mass) * (m.vx * m.vx + m.vy * m.vy);
  }
  const Site<DoubleBall> disk = motion_.site(g, t);
  for (GenId j = 0; j < motion_.size(); ++j) {
    if (j == g) continue;
    const Site<DoubleBall> other = motion_.site(j, t);
    const DoubleBall x = other.x - disk.x, y = other.y - disk.y;
    const DoubleBall fastest = sqrt(twice_energy / ball_of(in.disks[j].mass));
    // A mass of zero gives an infinite radius and no sign.
    const DoubleBall reach = disk.r + other.r + (fastest + speed) * delay;
    if (sign(x * x + y * y - reach * reach) != Sign::positive) return false;
  }
  return true;
}

}  // namespace voroproof::internal
