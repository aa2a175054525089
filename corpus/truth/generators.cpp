#include "corpus/truth/generators.h"

#include <charconv>

namespace voroproof::truth {

namespace {

template <class T>
std::array<Numbers<T>, 4> ordered(const std::array<Numbers<T>, 4>& g) {
  const auto v = disk_first(g[0], g[1], g[2]);
  return {v[0], v[1], v[2], g[3]};
}

}  // namespace

Numbers<Ball> in_balls(const Generator& g, int bits) {
  return {g.kind, Ball(g.x, bits), Ball(g.y, bits), Ball(g.r, bits), Ball(1.0, bits)};
}

Numbers<Rational> at(const Generator& g, const Rational& t) {
  const auto moved = [&](double x, double v) {
    return v == 0 ? internal::to_rational(x)
                  : Rational(internal::to_rational(x) + internal::to_rational(v) * t);
  };
  return {g.kind, moved(g.x, g.vx), moved(g.y, g.vy), moved(g.r, g.vr), 1};
}

Numbers<Ball> at(const Generator& g, const Rational& t, int bits) {
  const Ball time(t, bits);
  const auto moved = [&](double x, double v) { return Ball(x, bits) + Ball(v, bits) * time; };
  return {g.kind, moved(g.x, g.vx), moved(g.y, g.vy), moved(g.r, g.vr), Ball(1.0, bits)};
}

Numbers<Polynomial<Rational>> in_time(const Generator& g) {
  const auto line = [](double x, double v) {
    return Polynomial<Rational>({internal::to_rational(x), internal::to_rational(v)});
  };
  return {g.kind, line(g.x, g.vx), line(g.y, g.vy), line(g.r, g.vr), line(1, 0)};
}

std::string text(double x) {
  if (x == 0) return "0x0p+0";
  std::array<char, 40> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x < 0 ? -x : x,
                                 std::chars_format::hex);
  return (x < 0 ? "-0x" : "0x") + std::string(buffer.data(), end.ptr);
}

std::string text_at_rest(const Generator& g) {
  return std::string(1, g.kind) + ' ' + text(g.x) + ' ' + text(g.y) + ' ' + text(g.r);
}

std::string text_in_motion(const Generator& g) {
  return text_at_rest(g) + ' ' + text(g.vx) + ' ' + text(g.vy) + ' ' + text(g.vr);
}

// q = G + sqrt(Gamma) C has the sign, and q times its conjugate is N f.
Sign gap_sign(const std::array<Numbers<Rational>, 4>& given) {
  const auto g = ordered(given);
  const auto triple = circle(g[0], g[1], g[2]);
  const internal::InCircleParts<Rational> parts(triple, row_of(g[0], g[3]));
  return internal::sign_with_root(internal::sign(parts.g()), internal::sign(parts.c()),
                                  internal::sign(cotangency(g)));
}

// Bounded with the root itself, in another way than exactly.
Sign gap_sign(const std::array<Numbers<Ball>, 4>& given) {
  const auto g = ordered(given);
  const auto triple = circle(g[0], g[1], g[2]);
  const internal::InCircleParts<Ball> parts(triple, row_of(g[0], g[3]));
  return sign(parts.g() + sqrt(gamma(triple)) * parts.c());
}

Sign exists_sign(const std::array<Numbers<Rational>, 3>& given) {
  const auto g = disk_first(given[0], given[1], given[2]);
  return circle_exists(circle(g[0], g[1], g[2]));
}

Sign exists_sign(const std::array<Numbers<Ball>, 3>& given) {
  const auto g = disk_first(given[0], given[1], given[2]);
  const auto t = circle(g[0], g[1], g[2]);
  return sign(t.xp * t.xs + t.yp * t.ys + sqrt(gamma(t)) * t.xy);
}

bool are_apart(const std::vector<Numbers<Rational>>& all) {
  const auto fits = [](const Numbers<Rational>& a, const Numbers<Rational>& b) {
    if (b.kind == 'd') {
      const Rational x = a.x - b.x, y = a.y - b.y, r = a.r + b.r;
      return x * x + y * y >= r * r;
    }
    if (b.kind == 'w') return b.x * a.x + b.y * a.y - b.r >= a.r;
    const Rational x = a.x - b.x, y = a.y - b.y, room = b.r - a.r;
    return room >= 0 && x * x + y * y <= room * room;
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].kind != 'd') continue;
    if (all[i].r < 0) return false;
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (i != j && (all[j].kind != 'd' || j < i) && !fits(all[i], all[j])) return false;
    }
  }
  return true;
}

}  // namespace voroproof::truth
