#include "corpus/truth/encounter.h"

#include <cmath>

namespace voroproof::truth {

namespace {

using Function = Polynomial<Rational>;

// The places are of some 2^18: in a time of 1 a part of that.
constexpr double speed_unit = 64;

// Velocities of one length, so that the degree of the flip polynomial falls.
void set_equal_speeds(Dice& dice, Generators& all) {
  static constexpr std::array<std::array<int, 2>, 7> directions{
      {{65, 0}, {63, 16}, {60, 25}, {56, 33}, {52, 39}, {16, 63}, {33, 56}}};
  for (Generator& g : all) {
    const auto& [a, b] = directions[dice.next() % directions.size()];
    g.vx = speed_unit * dice.sign() * a;
    g.vy = speed_unit * dice.sign() * b;
  }
}

// The first three drift together, and the last one along the circle.
void set_along_circle(Dice& dice, Generators& all) {
  const double vx = speed_unit * dice.whole(-20, 20), vy = speed_unit * dice.whole(-20, 20);
  const int side = dice.sign();
  const double turn = side * std::ldexp(dice.whole(1, 7), -9);
  for (Generator& g : all) {
    g.vx = vx;
    g.vy = vy;
  }
  all.back().vx -= all.back().y * turn;
  all.back().vy += all.back().x * turn;
}

void set_velocities(Dice& dice, std::string_view name, Generators& all, bool along) {
  if (along) {
    set_along_circle(dice, all);
  } else if (name == "degree") {
    set_equal_speeds(dice, all);
  } else {
    for (Generator& g : all) {
      g.vx = speed_unit * dice.whole(-60, 60);
      g.vy = speed_unit * dice.whole(-60, 60);
    }
  }
  for (Generator& g : all) {
    if (g.kind != 'd') g.vx = g.vy = 0;
    if (name == "growth" && g.kind == 'd') g.vr = speed_unit / 4 * dice.whole(0, 20);
  }
}

// Less than the gap between two generators, with its sign where that is near 0.
Function gap(const Numbers<Function>& a, const Numbers<Function>& b) {
  if (a.kind != 'd') return gap(b, a);
  if (b.kind == 'w') return b.x * a.x + b.y * a.y - b.r - a.r;
  const Function x = a.x - b.x, y = a.y - b.y, square = x * x + y * y;
  const Function reach = b.kind == 'd' ? a.r + b.r : b.r - a.r;
  return b.kind == 'd' ? square - reach * reach : reach * reach - square;
}

bool may_vanish(const Function& f, const Rational& from, const Rational& to) {
  return f.is_zero() || !is_plainly_rootless(f, from, to);
}

}  // namespace

Encounter encounter(Dice& dice, std::string_view name, int count, Distance distance) {
  Encounter e;
  e.time = name == "late" ? std::ldexp(dice.whole(1 << 10, 1 << 14), 10)
                          : std::ldexp(dice.whole(1, 1 << 10), -4);
  const bool along = name == "double" || (name == "near" && dice.one_in(2));
  Ingredients with = ingredients(dice, name);
  with.bits = count > 4 ? 5 : 7;  // the files would grow
  Generators& all = e.generators = touching(dice, count, with);
  if (name == "close") make_close(dice, all);
  set_velocities(dice, name, all, along);
  put_at(distance, dice, all);
  for (Generator& g : all) {
    if (g.kind == 'w') continue;
    g.x -= g.vx * e.time;
    g.y -= g.vy * e.time;
    // It is a disk at t = 0 already.
    if (g.r < g.vr * e.time) g.vr = 0;
    g.r -= g.vr * e.time;
  }
  if (name == "wide") {
    scale(all, dice.whole(-60, 40));
    const int faster = dice.whole(-40, 40);
    for (Generator& g : all) {
      for (double* v : {&g.vx, &g.vy}) *v = std::ldexp(*v, faster);
    }
    e.time = std::ldexp(e.time, -faster);
    e.span = std::ldexp(e.span, -faster);
  }
  return e;
}

Moving moving(const Generators& g, const std::array<int, 4>& ids) {
  return {in_time(g[ids[0]]), in_time(g[ids[1]]), in_time(g[ids[2]]), in_time(g[ids[3]])};
}

std::array<Numbers<Rational>, 4> at(const Moving& g, const Rational& t) {
  const auto value = [&](const Numbers<Function>& f) {
    return Numbers<Rational>{f.kind, f.x.evaluate(t), f.y.evaluate(t), f.r.evaluate(t), 1};
  };
  return {value(g[0]), value(g[1]), value(g[2]), value(g[3])};
}

// The product of the quantity whose sign tells that the circle exists and its conjugate is N (xs^2
// + ys^2 - xy^2): where that has no root, the circle exists throughout or nowhere.
bool is_plain(const Moving& g, const Rational& from, const Rational& to) {
  const auto first = at(g, from);
  if (!are_apart({first.begin(), first.end()})) return false;
  if (exists_sign(std::array{first[0], first[1], first[2]}) != Sign::positive) return false;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      if (g[i].kind == 'd' || g[j].kind == 'd') {
        if (may_vanish(gap(g[i], g[j]), from, to)) return false;
      }
    }
  }
  const auto v = disk_first(g[0], g[1], g[2]);
  const auto t = circle(v[0], v[1], v[2]);
  const Function e = t.xs * t.xs + t.ys * t.ys - t.xy * t.xy;
  return !may_vanish(e, from, to);
}

}  // namespace voroproof::truth
