// The paths of the disks, and the law of collision (docs/formats.md, section 6).
#include <algorithm>

#include "kernel/motion.h"

namespace voroproof_kernel {
namespace {

using Pair = std::array<Vec, 2>;

// v + k n.
Vec plus(const Vec& v, const Rat& k, const Vec& n) {
  return {Rat(v[0] + k * n[0]), Rat(v[1] + k * n[1])};
}

// Velocities after a collision of i and j with centres p and velocities v.
Pair response(const Problem& pr, int i, int j, const Pair& p, const Pair& v) {
  const Scene& scene = pr.scene;
  const Vec n = minus(p[1], i == container ? scene.center : p[0]);
  const Rat n2 = norm2(n);
  if (n2 == 0) undecided("the centres of two that touch coincide: there is no normal");
  if (i == container) {
    const Rat q = dot(v[1], n) / n2, e = scene.wall_restitution;
    if (!scene.whole_law) return {Vec{}, plus(v[1], Rat(-(1 + e) * q), n)};
    const Vec w = plus(v[1], Rat(-2 * q), n);
    return {Vec{}, Vec{Rat(e * w[0]), Rat(e * w[1])}};
  }
  const Rat mi = scene.disks[i].mass, mj = scene.disks[j].mass;
  const Rat q = (1 + scene.restitution) * dot(minus(v[1], v[0]), n) / (n2 * (mi + mj));
  return {plus(v[0], Rat(mj * q), n), plus(v[1], Rat(-mi * q), n)};
}

// A change d of velocity is -(k w.n) n for some unit vector n iff |d|^2 = -k d.w, where w is the
// velocity of approach. Both disks have one n where the momentum is kept.
bool some_normal(const Problem& pr, const Claim& c, const Pair& before, const Rat& speed) {
  const Scene& scene = pr.scene;
  const auto reflects = [&](const Vec& d, const Vec& w, const Rat& k) {
    return abs(Rat(norm2(d) + k * dot(d, w))) <= 8 * pr.law_tolerance * speed * speed;
  };
  if (c.i == container) {
    const Rat e = scene.wall_restitution;
    Vec after = *c.v[1];
    if (scene.whole_law) after = {Rat(after[0] / e), Rat(after[1] / e)};
    return reflects(minus(after, before[1]), before[1], scene.whole_law ? Rat(2) : Rat(1 + e));
  }
  const Rat m[2] = {scene.disks[c.i].mass, scene.disks[c.j].mass}, sum = m[0] + m[1];
  const Rat k = (1 + scene.restitution) / sum;
  const Vec w = minus(before[1], before[0]), back = minus(before[0], before[1]);
  const Vec d0 = minus(*c.v[0], before[0]), d1 = minus(*c.v[1], before[1]);
  const Vec lost{Rat(m[0] * d0[0] + m[1] * d1[0]), Rat(m[0] * d0[1] + m[1] * d1[1])};
  return reflects(d0, back, Rat(k * m[1])) && reflects(d1, w, Rat(k * m[0])) &&
         norm2(lost) <= square(Rat(2 * pr.law_tolerance * sum * speed));
}

// Whether the claimed velocities are those after a collision with centres p, velocities `before`.
// The rounding of centres and of the time turns the normal by up to `rounding`; where that is much,
// the velocities must be those of some normal, too.
bool obeyed(const Problem& pr, const Claim& c, const Pair& p, const Pair& before, const Rat& t) {
  Rat speed = length_above(before[1]);
  if (c.i != container) speed += length_above(before[0]);
  const Rat reach = abs(Rat(pr.radius(c.i) + pr.radius(c.j)));
  const Rat away = abs(p[1][0]) + abs(p[1][1]) + speed * t;
  const Rat rounding = 16 * away / (reach * power_of_two(53));
  if (rounding > pr.law_tolerance && !some_normal(pr, c, before, speed)) return false;
  if (rounding >= 1) return true;
  const Pair v = response(pr, c.i, c.j, p, before);
  const Rat most = square(Rat((pr.law_tolerance + rounding) * speed));
  return norm2(minus(*c.v[1], v[1])) <= most &&
         (c.i == container || norm2(minus(*c.v[0], v[0])) <= most);
}

class Tracer {
 public:
  Tracer(Problem& p, Counts& counts) : p_(p), counts_(counts), done_(p.scene.maneuvers.size()) {
    p_.legs.resize(p_.disks() + 1);
    p_.legs[0].emplace_back(0, p_.scene.center, Vec{0, 0}, p_.radius(container));
    for (int i = 0; i < p_.disks(); ++i) {
      const Disk& d = p_.scene.disks[i];
      p_.legs[i + 1].emplace_back(0, d.center, d.velocity, d.radius);
    }
  }

  void claim(Claim& c) {
    if (c.kind == Claim::Kind::flip) return;
    const bool two = c.kind == Claim::Kind::collision && c.i != container;
    std::size_t due = 0;
    if (c.kind == Claim::Kind::maneuver) due = maneuver_of(c);
    if (p_.exact()) {
      c.t = c.kind == Claim::Kind::maneuver ? p_.scene.maneuvers[due].t : exact_contact(c);
      if (abs(Rat(c.t - c.filed)) > p_.tolerance) refute("its time is " + about(c.t));
      if (c.t > p_.horizon) refute("its time is after the horizon");
    }
    Pair at{}, before{}, after{};
    for (const int side : {0, 1}) {
      if (side == 0 && !two) continue;
      const Leg& leg = p_.legs[(side == 0 ? c.i : c.j) + 1].back();
      at[side] = leg.at(c.t);
      before[side] = leg.velocity;
    }
    if (c.kind == Claim::Kind::maneuver) {
      after[1] = p_.exact() ? p_.scene.maneuvers[due].velocity : recorded_velocity(c, due);
      if (p_.exact() && c.v[1]) {
        check_velocity(*c.v[1], after[1], p_.law_tolerance * length_above(after[1]));
      }
    } else {
      after = collide(c, at, before);
    }
    for (const int side : {0, 1}) {
      if (side == 0 && !two) continue;
      if (c.p[side]) check_center(*c.p[side], at[side], before[side], after[side]);
      turn(side == 0 ? c.i : c.j, c.t, at[side], after[side]);
    }
  }

  void all_maneuvers_done() const {
    for (std::size_t k = 0; k < done_.size(); ++k) {
      const Maneuver& m = p_.scene.maneuvers[k];
      if (done_[k] || m.t > p_.horizon || (p_.history.stopped && m.t == p_.horizon)) continue;
      refute("disk " + std::to_string(m.disk) + " has a maneuver at " + about(m.t));
    }
  }

 private:
  std::size_t maneuver_of(const Claim& c) {
    ++counts_.maneuvers;
    const auto& list = p_.scene.maneuvers;
    std::size_t k = 0;
    while (k < list.size() && (done_[k] || list[k].disk != c.j)) ++k;
    if (k == list.size()) refute("the scene has no such maneuver");
    if (abs(Rat(list[k].t - c.t)) > p_.tolerance) {
      refute("the maneuver is scheduled at " + about(list[k].t));
    }
    done_[k] = true;
    return k;
  }

  Vec recorded_velocity(const Claim& c, std::size_t k) const {
    const Vec due = p_.scene.maneuvers[k].velocity;
    if (!c.v[1]) return {nearest_binary64(due[0]), nearest_binary64(due[1])};
    if (norm2(minus(*c.v[1], due)) > square(Rat(p_.law_tolerance * length_above(due)))) {
      refute("the maneuver gives another velocity");
    }
    return *c.v[1];
  }

  Pair collide(const Claim& c, const Pair& at, const Pair& before) {
    ++counts_.collisions;
    const Scene& scene = p_.scene;
    if (p_.radius(c.i) + p_.radius(c.j) == 0) undecided("two points that meet");
    if (c.i != container && scene.disks[c.i].mass + scene.disks[c.j].mass == 0) {
      undecided("two points without mass touch");
    }
    const Pair filed{c.p[0].value_or(at[0]), c.p[1].value_or(at[1])};
    if (p_.exact()) {
      if (c.v[1] && c.p[1] && !obeyed(p_, c, filed, before, 0)) {
        refute("the velocities are not those of the law of collision");
      }
      const Pair v = response(p_, c.i, c.j, at, before);
      Rat s = length_above(before[1]);
      if (c.i != container) s += length_above(before[0]);
      const Rat reach = abs(Rat(p_.radius(c.i) + p_.radius(c.j)));
      const Rat moved = 4 * p_.tolerance * s * s / reach, most = s / 1024;
      const Rat allowed = p_.law_tolerance * s + std::min(moved, most);
      for (const int side : {0, 1}) {
        if (c.v[side]) check_velocity(*c.v[side], v[side], allowed);
      }
      return v;
    }
    if (c.v[1]) {
      if (!obeyed(p_, c, at, before, c.t)) {
        refute("the velocities are not those of the law of collision");
      }
      return {c.v[0].value_or(Vec{}), *c.v[1]};
    }
    Pair v = response(p_, c.i, c.j, filed, before);
    for (Vec& one : v) one = {nearest_binary64(one[0]), nearest_binary64(one[1])};
    return v;
  }

  // When two come into contact next, if that is rational.
  Rat exact_contact(const Claim& c) const {
    const Gap g(p_.legs[c.i + 1].back(), p_.legs[c.j + 1].back());
    const std::string two = std::to_string(c.i) + " and " + std::to_string(c.j);
    if (!g.has_roots()) refute("generators " + two + " do not touch");
    const Rat disc = g.b * g.b - g.a * g.c;
    const Int p = sqrt(Int(numerator(disc))), q = sqrt(Int(denominator(disc)));
    if (p * p != numerator(disc) || q * q != denominator(disc)) {
      undecided("the collision time of " + two + " is irrational");
    }
    if (msb(denominator(g.start)) > 20000) undecided("exact times have become too long");
    const Rat root(p, q);
    return g.start + (c.i == container ? Rat(root - g.b) : Rat(-root - g.b)) / g.a;
  }

  static void check_velocity(const Vec& claimed, const Vec& due, const Rat& allowed) {
    const Rat most = allowed + length_above(due) * power_of_two(-51);
    if (norm2(minus(claimed, due)) > square(most)) refute("the velocity is another");
  }

  void check_center(const Vec& claimed, const Vec& at, const Vec& before, const Vec& after) const {
    const Rat rounding = 4 * length_above(at) * power_of_two(-53);
    const Rat most = p_.tolerance * (length_above(before) + length_above(after)) + rounding;
    if (norm2(minus(claimed, at)) > square(most)) refute("the centre is elsewhere");
  }

  void turn(int disk, const Rat& t, const Vec& at, const Vec& v) {
    const Vec n = minus(at, p_.scene.center);
    if (dot(n, v) == 0 && norm2(v) != 0 &&
        norm2(n) == square(Rat(p_.scene.radius - p_.radius(disk)))) {
      undecided("disk " + std::to_string(disk) + " slides along the container");
    }
    p_.legs[disk + 1].emplace_back(t, at, v, p_.radius(disk));
  }

  Problem& p_;
  Counts& counts_;
  std::vector<bool> done_;  // maneuvers that have been claimed
};

}  // namespace

Gap::Gap(const Leg& i, const Leg& j) : start(std::max(i.start, j.start)) {
  const Vec d = minus(j.at(start), i.at(start)), w = minus(j.velocity, i.velocity);
  a = norm2(w);
  b = dot(d, w);
  c = norm2(d) - square(Rat(i.radius + j.radius));
}

void trace_paths(Problem& p, Counts& counts) {
  Tracer tracer(p, counts);
  for (Claim& c : p.history.claims) {
    try {
      tracer.claim(c);
    } catch (Stop& stop) {
      if (stop.line == 0) stop.line = c.line;
      throw;
    }
  }
  tracer.all_maneuvers_done();
}

Walk::Walk(const Problem& p) : problem(p), leg_of(p.disks() + 1, 0) {
  if (p.disks() >= 2) diagram = std::make_unique<Diagram>(*p.history.initial, p.disks());
}

int Walk::edge_of(const Claim& flip, std::int64_t* unoriented) const {
  if (!diagram) refute("there is no edge to flip");
  const Quad& q = flip.quad;
  int k = diagram->find(q);
  if (k < 0 && problem.options.unoriented) {
    k = diagram->find({q.l, q.r, q.e, q.s});
    if (unoriented != nullptr) ++*unoriented;
  }
  if (k < 0) refute("wrong quadruple: the diagram has no such edge");
  return k;
}

void Walk::apply(const Claim& claim) {
  if (claim.kind == Claim::Kind::flip) diagram->flip(edge_of(claim, nullptr));
  for (const int disk : turned(claim)) ++leg_of[disk + 1];
}

}  // namespace voroproof_kernel
