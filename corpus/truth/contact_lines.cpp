// The lines of `contact`.
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "corpus/truth/hardness.h"
#include "corpus/truth/lines.h"
#include "corpus/truth/proof.h"
#include "corpus/truth/times.h"

namespace voroproof::truth {

namespace {

using internal::Sign;
using internal::sign;

enum class Kind { none, graze, hit };

// a t^2 + 2 b t + c has the sign of the gap until the first contact.
template <class T>
struct Gap {
  T a, b, c;
};

// The gap between a disk and another generator, from their numbers at t = 0 and the differences of
// their rates.
template <class T>
Gap<T> gap_of(const Numbers<T>& m, const Numbers<T>& g, const T& wx, const T& wy, const T& rate) {
  if (g.kind == 'w') {
    const T room = g.x * m.x + g.y * m.y - g.r - m.r, speed = g.x * wx + g.y * wy - rate;
    return {g.one - g.one, speed, room + room};
  }
  const T x = m.x - g.x, y = m.y - g.y, reach = T(g.kind == 'd' ? T(m.r + g.r) : T(g.r - m.r));
  const T grows = g.kind == 'd' ? T(rate) : T(-rate);
  const T a = wx * wx + wy * wy - grows * grows, b = x * wx + y * wy - reach * grows,
          c = x * x + y * y - reach * reach;
  if (g.kind == 'd') return {a, b, c};
  return {T(-a), T(-b), T(-c)};
}

Gap<Rational> exact_gap(const Generator& m, const Generator& g) {
  const auto rate = [](double of_m, double of_g) {
    return Rational(internal::to_rational(of_m) - internal::to_rational(of_g));
  };
  // The radii of two disks add up.
  return gap_of<Rational>(at(m, 0), at(g, 0), rate(m.vx, g.vx), rate(m.vy, g.vy),
                          rate(m.vr, g.kind == 'd' ? -g.vr : g.vr));
}

Gap<Ball> gap_in_balls(const Generator& m, const Generator& g, int bits) {
  const auto rate = [&](double of_m, double of_g) { return Ball(of_m, bits) - Ball(of_g, bits); };
  return gap_of<Ball>(in_balls(m, bits), in_balls(g, bits), rate(m.vx, g.vx), rate(m.vy, g.vy),
                      rate(m.vr, g.kind == 'd' ? -g.vr : g.vr));
}

// The contact from t = 0 on, where the gap is not negative.
template <class T>
std::optional<Kind> kind_of(const Gap<T>& k) {
  const Sign a = sign(k.a), b = sign(k.b), c = sign(k.c);
  if (a == Sign::unknown || b == Sign::unknown || c == Sign::unknown) return std::nullopt;
  if (c == Sign::zero) {
    return b == Sign::negative || a == Sign::negative ? Kind::hit : Kind::none;
  }
  if (a == Sign::negative) return Kind::hit;
  if (b != Sign::negative) return Kind::none;
  if (a == Sign::zero) return Kind::hit;
  switch (sign(T(k.b * k.b - k.a * k.c))) {
    case Sign::negative:
      return Kind::none;
    case Sign::zero:
      return Kind::graze;
    case Sign::positive:
      return Kind::hit;
    case Sign::unknown:
      break;
  }
  return std::nullopt;
}

// The first zero at which a graze is, or after which the gap is negative.
Time time_of(const Gap<Rational>& k, Kind kind) {
  if (kind == Kind::graze) return Time(Rational(-k.b / k.a));
  if (sign(k.c) == Sign::zero && sign(k.b) != Sign::positive) return Time(Rational(0));
  const Polynomial<Rational> gap({k.c, Rational(2 * k.b), k.a});
  Rational bound = 1;
  for (int i = 0; i < gap.degree(); ++i) bound += abs(Rational(gap[i] / gap.leading()));
  for (const Time& t : real_roots(gap, Rational(0), bound)) {
    if (signs_around(gap, t).after == Sign::negative) return t;
  }
  throw std::logic_error("truth: a contact without a time");
}

// Two disks that graze each other at time t, the reach growing by h * grows.
Generators grazing(Dice& dice, int t, int grows) {
  const Direction d = any_direction(dice);
  const int far = grows * t + dice.whole(1, 400), side = dice.sign();
  const int along = side * dice.whole(1, 40);
  const double wx = grows * d.a - along * d.b, wy = grows * d.b + along * d.a;
  const double reach = double(d.h) * (far - grows * t);
  const double first = std::floor(reach * dice.whole(0, 8) / 8);
  const double vx = dice.whole(-50, 50), vy = dice.whole(-50, 50);
  Generators g(2);
  g[0] = {'d', 0, 0, first, vx, vy, 0};
  g[1] = {'d',     far * double(d.a) - wx * t, far * double(d.b) - wy * t, reach - first, wx + vx,
          wy + vy, double(d.h) * grows};
  const double y = dice.whole(-4000, 4000);
  translate(g, dice.whole(-4000, 4000), y);
  return g;
}

// A disk in a container or before a wall.
Generators bounded(Dice& dice, bool by_wall, int grows) {
  const Direction d = any_direction(dice);
  Generator m{'d', d.a * double(dice.whole(-9, 9)), d.b * double(dice.whole(-9, 9)),
              double(dice.whole(0, 60))};
  m.vx = dice.whole(-9, 9);
  m.vy = dice.whole(-9, 9);
  m.vr = grows;
  if (!by_wall) return {m, {'c', 0, 0, m.r + d.h * double(dice.whole(9, 60))}};
  const int side = dice.sign();
  if (dice.one_in(2)) return {m, {'w', double(side), 0, side * m.x - m.r - dice.whole(0, 99)}};
  return {m, {'w', 0, double(side), side * m.y - m.r - dice.whole(0, 99)}};
}

// Multiplies all lengths by one number, so that doubles are not exact.
void make_long(Dice& dice, Generators& all) {
  const double by = dice.whole(1 << 12, 1 << 13) | 1;
  for (Generator& g : all) {
    for (double* x : {&g.r, &g.vx, &g.vy, &g.vr}) *x *= by;
    if (g.kind == 'w') continue;
    g.x *= by;
    g.y *= by;
  }
}

Generators draw(Dice& dice, std::string_view name) {
  const int grows = name == "growth" ? dice.whole(1, 3) : 0;
  if (name == "container" || name == "wall" || (name == "growth" && dice.one_in(4))) {
    return bounded(dice, name == "wall" || dice.one_in(4), grows);
  }
  Generators g =
      grazing(dice, name == "late" ? dice.whole(1 << 16, 1 << 24) : dice.whole(1, 200), grows);
  if (name == "start") {
    // They touch, and part, meet or keep their distance.
    const Direction d = any_direction(dice);
    const double far = dice.whole(1, 60);
    g[1].x = g[0].x + d.a * far;
    g[1].y = g[0].y + d.b * far;
    g[0].r = dice.whole(0, int(d.h * far));
    g[1].r = d.h * far - g[0].r;
    const int turn = dice.whole(-1, 1);
    g[1].vx = g[0].vx - d.b * dice.whole(-3, 3) + turn * d.a;
    g[1].vy = g[0].vy + d.a * dice.whole(-3, 3) + turn * d.b;
  }
  return g;
}

bool keeps_promise(std::string_view name, Distance distance, Kind kind) {
  if (name == "double") return kind == Kind::graze;
  return distance == Distance::tie || kind != Kind::graze;
}

}  // namespace

std::string contact_line(std::uint64_t k) {
  static constexpr std::array<std::string_view, 9> classes{
      "generic", "near", "double", "start", "late", "wide", "container", "wall", "growth"};
  static constexpr std::array<std::string_view, 3> kinds{"none", "graze", "hit"};
  const std::string_view name = classes[k % classes.size()];
  for (Dice dice(3, k);;) {
    const Distance distance =
        name == "double" || name == "start" ? Distance::tie : distance_of(dice, name);
    Generators g = draw(dice, name);
    make_long(dice, g);
    if (distance == Distance::any) perturb(dice, g, std::ldexp(1.0, dice.whole(12, 22)));
    if (distance == Distance::near) nudge(dice, g.back(), dice.whole(24, 51));
    if (name == "wide") {
      scale(g, dice.whole(-200, 200));
      const int slower = dice.whole(-100, 100);
      for (Generator& m : g) {
        for (double* v : {&m.vx, &m.vy, &m.vr}) *v = std::ldexp(*v, slower);
      }
    }
    const Generator &m = g[0], &other = g[1];
    if (!are_apart({at(m, 0), at(other, 0)})) continue;
    const Gap<Rational> gap = exact_gap(m, other);
    // A disk that grows faster than it moves may fill its container.
    if (other.kind == 'c' && sgn(gap.a) >= 0 && m.vr != 0) continue;
    const Kind kind = *kind_of(gap);
    if (!keeps_promise(name, distance, kind)) continue;
    const Proof proof = kind == Kind::graze ? Proof{} : proof_of(kind, [&](int bits) {
      return kind_of(gap_in_balls(m, other, bits));
    });
    return std::string(name) + ' ' + proof.text() + ' ' + std::string(kinds[int(kind)]) + ' ' +
           (kind == Kind::none ? "- -" : text(rounded(time_of(gap, kind)))) + ' ' +
           text_in_motion(m) + ' ' + text_in_motion(other);
  }
}

}  // namespace voroproof::truth
