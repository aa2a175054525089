// The flights of a billiard's disks, and its law of collision (docs/formats.md, section 21).
#include <algorithm>

#include "certify/kernel/motion.h"

namespace voroproof_kernel {
namespace {

using Pair = std::array<Vec, 2>;

// Follows the claims in the order of the file.
class Tracer {
 public:
  Tracer(Problem& p, Counts& counts) : p_(p), counts_(counts), schedule_(p) {
    for (int i = 0; i < p.disks(); ++i) {
      const Disk& d = p.scene.disks[i];
      p.flights.push_back({Flight{0, d.center, d.velocity, d.velocity}});
    }
  }

  void claim(const Claim& c, std::int64_t number) {
    if (c.kind == Claim::Kind::collision) return collide(c, number);
    ++counts_.maneuvers;
    const int disk = c.id[1];
    const Vec& due = schedule_.claimed(c).velocity;
    const Vec v = c.v[1].value_or(due);
    if (norm2(minus(v, due)) > square(p_.law_tolerance) * norm2(due))
      refute("the velocity is another");
    require_place(disk, c.t, c.p[1], v);
    turn(disk, c.t, v, number);
  }

  std::vector<Life> finish() {
    schedule_.require_done();
    return std::move(collisions_);
  }

 private:
  const Flight& last(int disk) const { return p_.flights[disk].back(); }
  Vec place(int disk, const Rat& t) const { return p_.place(disk, last(disk), t); }
  Vec velocity(int disk, const Rat& t) const { return plus(last(disk).b, 2 * t, p_.fall(disk)); }

  void turn(int disk, const Rat& t, const Vec& v, std::int64_t number) {
    const Vec b = plus(v, -2 * t, p_.fall(disk));
    const Vec a = plus(plus(place(disk, t), -t, b), -t * t, p_.fall(disk));
    const std::int64_t turns = last(disk).turns + 1;
    p_.flights[disk].push_back({t, a, b, v, turns, number});
  }

  void require_place(int disk, const Rat& t, const std::optional<Vec>& claimed,
                     const Vec& after) const {
    if (!claimed) return;
    Rat size = 0;
    for (const Rat& x : *claimed) size = std::max(size, Rat(abs(x)));
    const Rat speeds = length_above(velocity(disk, t)) + length_above(after);
    const Rat most = p_.tolerance * speeds + size * power(2, -50);
    if (norm2(minus(*claimed, place(disk, t))) > square(most)) refute("the centre is elsewhere");
  }

  void collide(const Claim& c, std::int64_t number) {
    ++counts_.collisions;
    const Encounter two{c.id[0], c.id[1], c.image ? *c.image : nearest(c)};
    Life& met = collisions_.emplace_back(Life{two, {0, 0}, c.t, c.t, number});
    const bool moves = !p_.is_fixed(two.i) || !p_.is_fixed(two.j);
    const Pair law = moves ? response(two, c.t) : Pair{};
    if (moves) require_law(c, two, law);
    Vec after[2];
    for (int k = c.first; k < 2; ++k) {
      for (int m = 0; m < 3; ++m) after[k][m] = c.v[k] ? (*c.v[k])[m] : nearest_binary64(law[k][m]);
      require_place(c.id[k], c.t, c.p[k], after[k]);
    }
    for (int k = c.first; k < 2; ++k) {
      met.flight[k] = p_.flights[c.id[k]].size() - 1;
      if (!p_.is_fixed(c.id[k])) turn(c.id[k], c.t, after[k], number);
    }
  }

  // The image of the second disk that is nearest to the first one.
  Image nearest(const Claim& c) const {
    const Scene& scene = p_.scene;
    if (c.first == 1 || !scene.is_periodic()) return {};
    std::vector<std::pair<Rat, Image>> all;  // with the square of the distance
    const auto along = [&](auto&& self, int axis, Image image, const Vec& d) -> void {
      if (axis < 0) return all.emplace_back(norm2(d), image), void();
      const Rat& side = scene.sides[axis];
      const int around = side > 0 ? 1 : 0;
      const auto middle = around == 0 ? 0 : static_cast<int>(truncated(-d[axis] / side, 30));
      for (int by = -around; by <= around; ++by) {
        image[axis] = middle + by;
        Vec there = d;
        there[axis] += image[axis] * side;
        if (axis == 1) there[0] += drift(scene, image)[0] * c.t;
        self(self, axis - 1, image, there);
      }
    };
    along(along, 2, {}, minus(place(c.id[1], c.t), place(c.id[0], c.t)));
    std::sort(all.begin(), all.end());
    if (all[0].first == all[1].first) undecided("two images are as near, and none is named");
    return all[0].second;
  }

  // The velocities after a collision.
  Pair response(const Encounter& two, const Rat& t) const {
    const Scene& scene = p_.scene;
    const Disk& b = scene.disks[two.j];
    const Vec p = place(two.j, t), v = velocity(two.j, t);
    const auto along = [](const Rat& rate, const Vec& n) -> Rat {
      const Rat n2 = norm2(n);
      if (n2 == 0) undecided("the centres of two that touch coincide: there is no normal");
      return rate / n2;
    };
    if (two.i < 0 && scene.radius > 0) {
      const Vec n = minus(p, scene.center);
      const Rat rate = dot(v, n) + b.growth * (scene.radius - b.radius - b.growth * t);
      return {Vec{}, plus(v, -(1 + scene.wall_restitution) * along(rate, n), n)};
    }
    if (two.i < 0) {
      const Wall& wall = scene.walls[-1 - two.i];
      const Rat rate = dot(v, wall.normal) - wall.speed - b.growth;
      return {Vec{}, plus(v, -(1 + wall.restitution) * rate, wall.normal)};
    }
    const Disk& a = scene.disks[two.i];
    const Vec u = velocity(two.i, t), w = minus(plus(v, 1, drift(scene, two.image)), u);
    const Vec at = plus(plus(p, 1, offset(scene, two.image)), t, drift(scene, two.image));
    const Vec n = minus(at, place(two.i, t));
    const Rat growth = a.growth + b.growth, reach = a.radius + b.radius + growth * t;
    const Rat q = (1 + scene.restitution) * along(dot(w, n) - growth * reach, n);
    const Rat of_a = a.fixed ? Rat(0) : b.fixed ? Rat(1) : Rat(b.mass / (a.mass + b.mass));
    const Rat of_b = b.fixed ? Rat(0) : Rat(1 - of_a);
    return {plus(u, q * of_a, n), plus(v, -q * of_b, n)};
  }

  // The rounding of centres and of the time turns the normal by up to `rounding`.
  void require_law(const Claim& c, const Encounter& two, const Pair& law) const {
    const Scene& scene = p_.scene;
    const bool flat = two.i < 0 && scene.radius == 0;
    const Disk& b = scene.disks[two.j];
    Rat speed =
        length_above(plus(velocity(two.j, c.t), 1, drift(scene, two.image))) + abs(b.growth);
    Rat reach = (flat ? Rat(0) : scene.radius) - b.radius - b.growth * c.t;
    if (flat) speed += abs(scene.walls[-1 - two.i].speed);
    if (two.i >= 0) {
      const Disk& a = scene.disks[two.i];
      speed += length_above(velocity(two.i, c.t)) + abs(a.growth);
      reach = a.radius + a.growth * c.t + b.radius + b.growth * c.t;
    }
    for (int k = c.first; k < 2; ++k) {
      if (!c.v[k]) continue;
      const Rat off2 = norm2(minus(*c.v[k], law[k])), plain = p_.law_tolerance * speed;
      if (off2 <= square(plain)) continue;
      const Rat error = flat ? Rat(0) : Rat(16 * (p_.extent + speed * c.t) * power(2, -53));
      if (!flat && error >= reach) undecided("roundings of centres hide the normal of a collision");
      const Rat rounding = flat ? Rat(0) : Rat(error / reach);
      const Rat fall = length_above(scene.gravity) * c.t * power(2, -51);
      if (off2 > square(plain + rounding * speed + fall))
        refute("the velocities are not those of the law");
    }
  }

  Problem& p_;
  Counts& counts_;
  Schedule schedule_;
  std::vector<Life> collisions_;
};

}  // namespace

std::vector<Life> trace_flights(Problem& p, Counts& counts) {
  Tracer tracer(p, counts);
  check_start(p);
  for (std::size_t k = 0; k < p.history.claims.size(); ++k) {
    p.tell("paths", k);
    const Claim& c = p.history.claims[k];
    at_line(c.line, [&] { tracer.claim(c, static_cast<std::int64_t>(k)); });
  }
  return tracer.finish();
}

}  // namespace voroproof_kernel
