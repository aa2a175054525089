#include "corpus/truth/placement.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace voroproof::truth {

namespace {

bool is_upper(const Direction& d) { return d.b > 0 || (d.b == 0 && d.a > 0); }

// By angle from 0 to 2 pi.
bool precedes(const Direction& p, const Direction& q) {
  if (is_upper(p) != is_upper(q)) return is_upper(p);
  return p.a * q.b - p.b * q.a > 0;
}

bool is_same(const Direction& p, const Direction& q) {
  return p.a * q.h == q.a * p.h && p.b * q.h == q.b * p.h;
}

// All with a hypotenuse of at most `most`, by angle.
std::vector<Direction> directions_up_to(int most) {
  std::vector<Direction> all;
  for (int h = 1; h <= most; ++h) {
    for (int a = -h; a <= h; ++a) {
      const int b = static_cast<int>(std::lround(std::sqrt(h * h - a * a)));
      if (a * a + b * b != h * h || std::gcd(std::gcd(a, b), h) != 1) continue;
      all.push_back({a, b, h});
      if (b != 0) all.push_back({a, -b, h});
    }
  }
  std::sort(all.begin(), all.end(), precedes);
  return all;
}

// Those that are multiples of 1/65, as such.
std::vector<Direction> of_one_length() {
  std::vector<Direction> all;
  for (const Direction& d : directions_up_to(65)) {
    if (65 % d.h == 0) all.push_back({d.a * (65 / d.h), d.b * (65 / d.h), 65});
  }
  return all;
}

const std::vector<Direction>& any_length() {
  static const std::vector<Direction> all = directions_up_to(101);
  return all;
}

const std::vector<Direction>& one_length() {
  static const std::vector<Direction> all = of_one_length();
  return all;
}

// `count` different ones, by angle.
std::vector<Direction> draw(Dice& dice, const std::vector<Direction>& from, int count) {
  std::vector<std::size_t> picks;
  while (picks.size() < static_cast<std::size_t>(count)) {
    const std::size_t k = dice.next() % from.size();
    if (std::find(picks.begin(), picks.end(), k) == picks.end()) picks.push_back(k);
  }
  std::sort(picks.begin(), picks.end());
  std::vector<Direction> drawn;
  for (const std::size_t k : picks) drawn.push_back(from[k]);
  return drawn;
}

// A disk that touches the circle of radius rho about the origin in direction d.
Generator touching_disk(const Direction& d, double multiple, double rho) {
  return {'d', d.a * multiple, d.b * multiple, d.h * multiple - rho};
}

bool is_axis(const Direction& d) { return d.a == 0 || d.b == 0; }

Generators around(Dice& dice, std::vector<Direction> directions, const Ingredients& with) {
  // The first three in a cyclic order, the others in any place between them.
  std::rotate(directions.begin(), directions.begin() + dice.whole(0, 2), directions.end());
  const auto count = static_cast<int>(directions.size());
  for (int k = count - 1; k > 2; --k) std::swap(directions[k], directions[dice.whole(0, k)]);
  std::sort(directions.begin(), directions.begin() + 3, precedes);
  std::rotate(directions.begin(), directions.begin() + dice.whole(0, 2), directions.begin() + 3);
  const int h = with.equal_radii ? 65 : 1;
  const double rho = h * dice.whole(1, 4000 / h);
  const double radius = with.equal_radii ? 65 * dice.whole(0, 40) : -1;
  const int container = with.container ? dice.whole(0, count - 1) : -1;
  int walls = with.walls;
  Generators all;
  for (int k = 0; k < count; ++k) {
    const Direction& d = directions[k];
    if (k == container) {
      // On the other side of the circle's centre, so that it touches from inside.
      const double multiple = dice.whole(0, 2000 / d.h);
      all.push_back({'c', -d.a * multiple, -d.b * multiple, d.h * multiple + rho});
    } else if (walls > 0 && is_axis(d)) {
      --walls;
      all.push_back({'w', -double(d.a), -double(d.b), -rho});
    } else {
      const double least = std::ceil(rho / d.h);
      double more = dice.one_in(3) ? dice.whole(0, 3) : dice.whole(0, 1 + 2000 / d.h);
      if (with.wide && dice.one_in(2)) more = std::ldexp(more, dice.whole(8, 24));
      if (with.points && dice.one_in(2)) more = 0;
      const double multiple = radius >= 0 ? (rho + radius) / d.h : least + more;
      all.push_back(touching_disk(d, multiple, rho));
    }
  }
  return walls > 0 ? Generators() : all;
}

bool has_disk(const Generators& g) {
  return g[0].kind == 'd' || g[1].kind == 'd' || g[2].kind == 'd';
}

bool are_apart(const Generators& all) {
  std::vector<Numbers<Rational>> exact;
  for (const Generator& g : all) exact.push_back(at(g, 0));
  return truth::are_apart(exact);
}

// All lengths of generators at rest.
void multiply(Generators& all, double by) {
  for (Generator& g : all) {
    if (g.kind != 'w') {
      g.x *= by;
      g.y *= by;
    }
    g.r *= by;
  }
}

}  // namespace

Direction any_direction(Dice& dice) { return any_length()[dice.next() % any_length().size()]; }

Generators touching(Dice& dice, int count, const Ingredients& with) {
  static const std::vector<Direction> axes{{1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
  const double unit = dice.whole(1 << (with.bits - 1), 1 << with.bits) | 1;
  for (;;) {
    auto directions =
        draw(dice, with.equal_radii ? one_length() : any_length(), count - with.walls);
    for (const Direction& d : draw(dice, axes, with.walls)) directions.push_back(d);
    std::sort(directions.begin(), directions.end(), precedes);
    if (std::adjacent_find(directions.begin(), directions.end(), is_same) != directions.end()) {
      continue;
    }
    Generators all = around(dice, directions, with);
    if (all.empty() || !has_disk(all) || !are_apart(all)) continue;
    multiply(all, unit);
    return all;
  }
}

Generators touching_line(Dice& dice, const Ingredients& with) {
  const double unit = dice.whole(1 << (with.bits - 1), 1 << with.bits) | 1;
  for (;;) {
    const Direction d = any_direction(dice);
    const double equal = dice.whole(0, 200);
    std::array<int, 3> places{};
    for (int& x : places) x = dice.whole(-2000, 2000);
    std::sort(places.begin(), places.end());
    // Above the line, and the circle below it: its contacts run counterclockwise from right to
    // left.
    std::reverse(places.begin(), places.end());
    std::rotate(places.begin(), places.begin() + dice.whole(0, 2), places.end());
    Generators all;
    for (const double x : places) {
      double r = with.equal_radii ? equal : dice.whole(0, 400);
      if (with.points && dice.one_in(2)) r = 0;
      if (with.wide && dice.one_in(3)) r = std::ldexp(r, dice.whole(4, 12));
      all.push_back({'d', d.a * x - d.b * r, d.b * x + d.a * r, d.h * r});
    }
    if (!are_apart(all)) continue;
    multiply(all, unit);
    return all;
  }
}

void perturb(Dice& dice, Generators& all, double size) {
  const int bits = dice.whole(8, 26);
  for (Generator& g : all) {
    if (g.kind == 'w') continue;
    g.x += size * dice.fraction(bits);
    g.y += size * dice.fraction(bits);
    g.r = std::fabs(g.r + size / 2 * dice.fraction(bits));
  }
}

void nudge(Dice& dice, Generator& g, int bits) {
  double& x = g.kind == 'w' || g.r != 0 ? g.r : g.x;
  int exponent = 0;
  std::frexp(x == 0 ? 1.0 : x, &exponent);
  x += dice.sign() * std::ldexp(1.0, exponent - bits);
}

void scale(Generators& all, int exponent) {
  for (Generator& g : all) {
    if (g.kind != 'w') {
      g.x = std::ldexp(g.x, exponent);
      g.y = std::ldexp(g.y, exponent);
    }
    for (double* x : {&g.r, &g.vx, &g.vy, &g.vr}) *x = std::ldexp(*x, exponent);
  }
}

void translate(Generators& all, double x, double y) {
  for (Generator& g : all) {
    if (g.kind == 'w') {
      g.r += g.x * x + g.y * y;
    } else {
      g.x += x;
      g.y += y;
    }
  }
}

}  // namespace voroproof::truth
