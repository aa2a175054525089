#include "library/places.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "exact/tower.h"
#include "filtered/motion/exact_motion.h"
#include "filtered/search/collapse.h"

namespace voroproof::internal {

namespace {

template <class T>
std::vector<T> values(const MovingSite<T>& s) {
  return {s.x, s.y, s.r, s.vx, s.vy};
}

std::size_t index(GenId g) { return static_cast<std::size_t>(g + 1); }

Places::Rounded as_rounded(const std::vector<double>& x) {
  return {{x[0], x[1]}, x.size() > 3 ? Vec2{x[3], x[4]} : Vec2{}, x[2]};
}

// The doubles that all enclosures round to; nothing where one straddles the boundary between two
// binary64.
std::optional<std::vector<double>> rounded(const std::vector<Ball>& enclosures) {
  std::vector<double> all(enclosures.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!enclosures[k].round_to_double(all[k])) return std::nullopt;
  }
  return all;
}

}  // namespace

Places::Places(std::shared_ptr<Engine> engine, const Rational& t)
    : engine_(std::move(engine)), t_(t) {
  const Motion& motion = engine_->motion();
  for (GenId g = container_id; g < motion.size(); ++g) since_.push_back(motion.doubles(g).t);
  place();
}

Places::Places(std::vector<MovingSite<Rational>> sites)
    : lines_(std::move(sites)), since_(lines_.size()) {
  place();
}

Places::Places(const Scene& scene, const std::vector<RecordedState>& states, const Rational& t)
    : t_(t) {
  lines_.push_back({scene.cx, scene.cy, 0, 0, Rational(-scene.container_radius)});
  since_.push_back(0);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& [since, center, velocity] = states[i];
    const Rational dt = t - since;
    lines_.push_back({Rational(center[0] + velocity[0] * dt),
                      Rational(center[1] + velocity[1] * dt), velocity[0], velocity[1],
                      scene.disks[i].radius});
    since_.push_back(round_nearest(since));
  }
  place();
}

// Places the generators anew, with the present number of bits.
void Places::place() {
  near_.clear();
  near_.reserve(since_.size());
  const auto ball = [this](const Rational& q) { return Ball(q, bits_); };
  for (std::size_t k = 0; k < since_.size(); ++k) {
    if (engine_) {
      const Motion& motion = engine_->motion();
      MovingSite<Ball> site = motion.moving_site(static_cast<GenId>(k) - 1, Ball(t_, bits_));
      site.x = site.x + ball(motion.input().origin[0]);
      site.y = site.y + ball(motion.input().origin[1]);
      near_.push_back({site, since_[k]});
    } else {
      const MovingSite<Rational>& s = lines_[k];
      near_.push_back({{ball(s.x), ball(s.y), ball(s.vx), ball(s.vy), ball(s.r)}, since_[k]});
    }
  }
}

// The values `exact(site, field)`, from the exact sites and with square roots in the field,
// rounded.
template <class Exact>
std::vector<double> Places::exactly(const Exact& exact) const {
  const auto nearest = [&](const auto& site, RadicalField& field) {
    std::vector<double> all;
    for (const Tower& x : exact(site, field)) all.push_back(round_nearest(x));
    return all;
  };
  if (engine_) {
    ExactMotion motion(engine_->motion());
    const auto& origin = engine_->motion().input().origin;
    const auto site = [&](GenId g) {
      MovingSite<Tower> at = motion.moving_site(g, t_);
      at.x = at.x + Tower(origin[0]);
      at.y = at.y + Tower(origin[1]);
      return at;
    };
    return nearest(site, motion.field());
  }
  RadicalField field;
  const auto site = [&](GenId g) {
    const MovingSite<Rational>& s = lines_[index(g)];
    return MovingSite<Tower>{Tower(s.x), Tower(s.y), Tower(s.vx), Tower(s.vy), Tower(s.r)};
  };
  return nearest(site, field);
}

// The values `near()`, from the enclosures, and `exact(site, field)` are the same ones.
template <class Near, class Exact>
std::vector<double> Places::rounded(const Near& near, const Exact& exact) {
  if (const auto known = internal::rounded(near())) return *known;
  std::string budget;
  try {
    return exactly(exact);
  } catch (const BudgetExceeded& e) {
    budget = e.what();
  }
  while (engine_ && engine_->motion().raise_precision()) {
    bits_ = std::max(bits_, engine_->motion().goal_bits() + 32);
    place();
    if (const auto known = internal::rounded(near())) return *known;
  }
  throw Undecided(
      "a coordinate of the diagram is so near the middle between two binary64 that it is not "
      "proved which one is nearest; exactly: " +
      budget);
}

Places::Rounded Places::generator(GenId g) {
  const auto exact = [g](const auto& site, RadicalField&) { return values(site(g)); };
  return as_rounded(rounded([&] { return values(near_[index(g)].site); }, exact));
}

Places::Rounded Places::circle(const Triple& vertex) {
  const auto near = [&] {
    const auto at = circle_of(vertex, [this](GenId g) {
      const MovingSite<Ball>& s = near_[index(g)].site;
      return Site<Ball>{s.x, s.y, s.r};
    });
    return std::vector<Ball>(at.begin(), at.end());
  };
  const auto exact = [&](const auto& moving, RadicalField& field) {
    const auto site = [&](GenId g) {
      const MovingSite<Tower> s = moving(g);
      return Site<Tower>{s.x, s.y, s.r};
    };
    const auto [i, j, k] = disk_first(vertex[0], vertex[1], vertex[2]);
    const TangentTriple<Tower> triple(site(i), site(j), site(k),
                                      j == container_id || k == container_id);
    // Below zero by the rounding of recorded places (circle_of()).
    const auto root = [&](const Tower& x) {
      return sign(x) == Sign::negative ? Tower(0) : field.sqrt(x);
    };
    const auto at = tangent_circle(triple, root);
    return std::vector<Tower>(at.begin(), at.end());
  };
  return as_rounded(rounded(near, exact));
}

}  // namespace voroproof::internal
