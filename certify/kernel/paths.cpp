// The paths of the disks, and the law of collision (docs/formats.md, section 6).
#include <algorithm>

#include "certify/kernel/motion.h"

namespace voroproof_kernel {
namespace {

using Pair = std::array<Vec, 2>;

// Follows the claims in the order of the file.
class Tracer {
 public:
  Tracer(Problem& p, Counts& counts) : p_(p), counts_(counts), schedule_(p) {
    p_.legs.resize(p_.disks() + 1);
    p_.legs[0].emplace_back(0, p_.scene.center, Vec{0, 0}, p_.radius(container));
    for (int i = 0; i < p_.disks(); ++i) {
      const Disk& d = p_.scene.disks[i];
      p_.legs[i + 1].emplace_back(0, d.center, d.velocity, d.radius);
      told_.push_back(d.velocity);
    }
  }

  void claim(Claim& c, std::size_t number) {
    if (c.first == 2) return;
    const bool collision = c.kind == Claim::Kind::collision;
    counts_.maneuvers += !collision;
    const Maneuver* due = collision ? nullptr : &schedule_.claimed(c);
    if (p_.exact()) {
      c.t = collision ? exact_contact(c) : due->t;
      if (abs(c.t - c.filed) > p_.tolerance) refute("its time is " + about(c.t));
      if (c.t > p_.history.horizon) refute("its time is after the horizon");
    }
    Pair at, before;
    for (int k = c.first; k < 2; ++k) {
      at[k] = leg(c, k).at(c.t);
      before[k] = leg(c, k).velocity;
    }
    const Pair after = collision ? collide(c, at, before) : Pair{Vec{}, turned(c, *due)};
    for (int k = c.first; k < 2; ++k) {
      if (c.p[k]) {
        const Rat way = length_above(before[k]) + length_above(after[k]);
        const Rat most = p_.tolerance * way + length_above(at[k]) * power(2, -51);
        if (norm2(minus(*c.p[k], at[k])) > square(most)) refute("the centre is elsewhere");
      }
      told_[c.id[k]] = c.v[k].value_or(after[k]);
      const Vec n = minus(at[k], p_.scene.center);
      const bool touches = norm2(n) == square(p_.scene.radius - p_.radius(c.id[k]));
      if (touches && dot(n, after[k]) == 0 && norm2(after[k]) != 0) {
        undecided("disk " + std::to_string(c.id[k]) + " slides along the container");
      }
      p_.legs[c.id[k] + 1].emplace_back(c.t, at[k], after[k], p_.radius(c.id[k]), number);
    }
  }

  void finish() const { schedule_.require_done(); }

 private:
  const Leg& leg(const Claim& c, int k) const { return p_.legs[c.id[k] + 1].back(); }
  Rat mass(int g) const { return p_.scene.disks[g].mass; }

  Vec turned(const Claim& c, const Maneuver& due) const {
    const Vec& v = due.velocity;
    if (c.v[1]) check_velocity(*c.v[1], v, p_.law_tolerance * length_above(v));
    if (p_.exact()) return v;
    return c.v[1].value_or(v);
  }

  Pair collide(const Claim& c, const Pair& at, const Pair& before) {
    ++counts_.collisions;
    if (p_.reach(c.id[0], c.id[1]) == 0) undecided("two points that meet");
    if (c.first == 0 && mass(c.id[0]) + mass(c.id[1]) == 0) {
      undecided("two points without mass touch");
    }
    const Pair filed{c.p[0].value_or(at[0]), c.p[1].value_or(at[1])};
    if (!p_.exact()) {
      if (c.v[1]) {
        if (!obeyed(c, at, before, c.t)) refute("the velocities are not those of the law");
        return {c.v[0].value_or(Vec{}), *c.v[1]};
      }
      Pair v = response(c, filed, before);
      for (Vec& one : v) one = {nearest_binary64(one[0]), nearest_binary64(one[1]), 0};
      return v;
    }
    const Pair told{c.first == 0 ? told_[c.id[0]] : Vec{}, told_[c.id[1]]};
    if (c.v[1] && c.p[1] && !obeyed(c, filed, told, 0)) {
      refute("the velocities are not those of the law");
    }
    const Pair v = response(c, at, before);
    const Rat s = speeds(c, before), reach = p_.reach(c.id[0], c.id[1]);
    const Rat moved = std::min(Rat(4 * p_.tolerance * s * s / reach), Rat(s / 1024));
    for (int k = c.first; c.v[1] && k < 2; ++k) {
      check_velocity(*c.v[k], v[k], p_.law_tolerance * s + moved);
    }
    return v;
  }

  // When two come into contact next, if that is rational.
  Rat exact_contact(const Claim& c) const {
    const Gap g(p_.legs[c.id[0] + 1].back(), leg(c, 1));
    const std::string two = std::to_string(c.id[0]) + " and " + std::to_string(c.id[1]);
    const bool points = c.first == 0 && p_.reach(c.id[0], c.id[1]) == 0;
    if (points && g.meet(c.t + p_.tolerance)) undecided("two points that meet");
    if (!g.has_roots()) refute("generators " + two + " do not come into contact");
    const Rat square = g.b * g.b - g.a * g.c;
    const Rat root(sqrt(numerator(square)), sqrt(denominator(square)));
    if (root * root != square) undecided("the collision time of " + two + " is irrational");
    if (msb(denominator(g.start)) > 20000) undecided("exact times have become too long");
    return g.start + ((c.first == 1 ? root : Rat(-root)) - g.b) / g.a;
  }

  static void check_velocity(const Vec& claimed, const Vec& due, const Rat& allowed) {
    const Rat most = allowed + length_above(due) * power(2, -51);
    if (norm2(minus(claimed, due)) > square(most)) refute("the velocity is another");
  }

  static Rat speeds(const Claim& c, const Pair& v) {
    return length_above(v[1]) + (c.first == 0 ? length_above(v[0]) : Rat(0));
  }

  // Velocities after a collision with centres p and velocities v.
  Pair response(const Claim& c, const Pair& p, const Pair& v) const {
    const Scene& scene = p_.scene;
    const Vec n = minus(p[1], c.first == 1 ? scene.center : p[0]);
    const Rat n2 = norm2(n);
    if (n2 == 0) undecided("the centres of two that touch coincide: there is no normal");
    if (c.first == 1) {
      const Rat e = scene.wall_restitution, q = dot(v[1], n) / n2;
      if (!scene.whole_law) return {Vec{}, plus(v[1], -(1 + e) * q, n)};
      const Vec w = plus(v[1], -2 * q, n);
      return {Vec{}, Vec{e * w[0], e * w[1]}};
    }
    const Rat mi = mass(c.id[0]), mj = mass(c.id[1]);
    const Rat q = (1 + scene.restitution) * dot(minus(v[1], v[0]), n) / (n2 * (mi + mj));
    return {plus(v[0], mj * q, n), plus(v[1], -mi * q, n)};
  }

  // A change d of velocity is -(k w.n) n for some unit vector n iff |d|^2 = -k d.w, where w is the
  // velocity of approach: then |d| <= k |w|, and d is off by no more than `off` only where the two
  // sides differ by no more than off (3 k |w| + off). Both disks have one n where the momentum is
  // kept.
  bool some_normal(const Claim& c, const Pair& before, const Rat& speed) const {
    const Rat most = p_.law_tolerance * speed, e = p_.scene.wall_restitution;
    const auto reflects = [&](const Vec& d, const Vec& w, const Rat& k, const Rat& off) {
      return abs(norm2(d) + k * dot(d, w)) <= off * (3 * k * length_above(w) + off);
    };
    const Vec& after = *c.v[1];
    if (c.first == 1 && p_.scene.whole_law) {
      return reflects(minus({after[0] / e, after[1] / e}, before[1]), before[1], 2, most / e);
    }
    const Vec d = minus(after, before[1]);
    if (c.first == 1) return reflects(d, before[1], 1 + e, most);
    const Rat mi = mass(c.id[0]), mj = mass(c.id[1]), k = (1 + p_.scene.restitution) / (mi + mj);
    const Vec di = minus(*c.v[0], before[0]), w = minus(before[1], before[0]);
    const Vec lost = plus({mi * di[0], mi * di[1]}, mj, d);
    return reflects(d, w, k * mi, most) && reflects(di, minus({0, 0}, w), k * mj, most) &&
           norm2(lost) <= square(2 * (mi + mj) * most);
  }

  // Whether the claimed velocities are those after a collision with centres p and velocities
  // `before`. The rounding of centres and of the time turns the normal by up to `rounding`; where
  // that is much, the velocities must be those of some normal, too.
  bool obeyed(const Claim& c, const Pair& p, const Pair& before, const Rat& t) const {
    const Rat speed = speeds(c, before), away = length_above(p[1]) + speed * t;
    const Rat rounding = 16 * away / (p_.reach(c.id[0], c.id[1]) * power(2, 53));
    if (rounding > p_.law_tolerance && !some_normal(c, before, speed)) return false;
    if (rounding >= 1) return true;
    const Pair due = response(c, p, before);
    const Rat most = square((p_.law_tolerance + rounding) * speed);
    return norm2(minus(*c.v[1], due[1])) <= most &&
           (c.first == 1 || norm2(minus(*c.v[0], due[0])) <= most);
  }

  Problem& p_;
  Counts& counts_;
  Schedule schedule_;
  std::vector<Vec> told_;  // by disk: its velocity as the file has it
};

}  // namespace

const Maneuver& Schedule::claimed(const Claim& c) {
  const auto& list = p_.scene.maneuvers;
  std::size_t k = 0;
  while (k < list.size() && (done_[k] || list[k].disk != c.id[1])) ++k;
  if (k == list.size()) refute("the scene has no such maneuver");
  if (abs(list[k].t - c.t) > p_.tolerance) refute("the maneuver is at " + about(list[k].t));
  if (list[k].t > p_.history.horizon) refute("the maneuver is after the horizon");
  done_[k] = true;
  return list[k];
}

void Schedule::require_done() const {
  for (std::size_t k = 0; k < done_.size(); ++k) {
    const Maneuver& m = p_.scene.maneuvers[k];
    if (done_[k] || m.t > p_.history.horizon) continue;
    refute("disk " + std::to_string(m.disk) + " has a maneuver at " + about(m.t),
           sight(m.t, {m.disk}));
  }
}

Gap::Gap(const Leg& i, const Leg& j) : start(std::max(i.start, j.start)) {
  const Vec d = minus(j.at(start), i.at(start)), w = minus(j.velocity, i.velocity);
  a = norm2(w);
  b = dot(d, w);
  c = norm2(d) - square(i.radius + j.radius);
}

void trace_paths(Problem& p, Counts& counts) {
  Tracer tracer(p, counts);
  for (std::size_t k = 0; k < p.history.claims.size(); ++k) {
    p.tell("paths", k);
    at_line(p.history.claims[k].line, [&] { tracer.claim(p.history.claims[k], k); });
  }
  tracer.finish();
}

Walk::Walk(const Problem& p) : problem(p), leg_of(p.disks() + 1, 0) {
  if (p.disks() >= 2) diagram = std::make_unique<Diagram>(*p.history.initial, p.disks());
}

Four Walk::four(int k) const {
  const Quad& q = edges()[k];
  return {q, {&leg(q.l), &leg(q.r), &leg(q.s), &leg(q.e)}};
}

int Walk::edge_of(const Claim& flip, bool* mirrored) const {
  if (!diagram) return -1;
  const auto [l, r, s, e] = flip.quad;
  const int k = diagram->find(flip.quad);
  if (mirrored != nullptr) *mirrored = k < 0;
  if (!problem.options.unoriented || s == e) return k;
  const int other = diagram->find({l, r, e, s});
  if (k >= 0 && other >= 0) undecided("two edges have the generators of the flip");
  return std::max(k, other);
}

void Walk::apply(const Claim& claim) {
  if (claim.kind == Claim::Kind::flip) {
    const int k = edge_of(claim);
    if (k < 0) refute("wrong quadruple: the diagram has no such edge");
    diagram->flip(k);
  }
  for (int k = claim.first; k < 2; ++k) ++leg_of[claim.id[k] + 1];
}

}  // namespace voroproof_kernel
