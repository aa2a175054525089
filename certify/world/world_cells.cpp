#include "certify/world/world_cells.h"

#include "certify/world/world_verdict.h"
#include "exact/patience.h"

namespace voroproof::internal {

namespace {

constexpr Ball::Precision kFirstBits = 128;
constexpr Ball::Precision kMostBits = 1 << 16;

std::string name(const Quad& q) {
  std::string text = "[";
  for (const GenId g : {q.l, q.s, q.r}) text += (text.size() > 1 ? "," : "") + std::to_string(g);
  return text + "]";
}

}  // namespace

const Site<Rational>& WorldCells::site(GenId g) {
  const auto found = sites_.find(g);
  if (found != sites_.end()) return found->second;
  const Course& c = motion_.course(g);
  return sites_.emplace(g, Site<Rational>{c.x.evaluate(t_), c.y.evaluate(t_), c.r.evaluate(t_)})
      .first->second;
}

GeneratorRow<Rational> WorldCells::row(GenId base, GenId g) {
  if (g >= 0) return internal::row(site(base), site(g));
  if (!motion_.has_circle()) return {0, 0, 0, 1};
  const Site<Rational>&b = site(base), &c = site(g);
  const Rational x = b.x - c.x, y = b.y - c.y, s = c.r + b.r;
  return {x, y, s, s * s - x * x - y * y};
}

TangentTriple<Rational> WorldCells::triple(Half h) {
  GenId a = map_.org(h), b = map_.dest(h), c = map_.apex(h);
  if (a < 0) {
    const GenId first = a;
    a = b;
    b = c;
    c = first;
  }
  return {site(a), row(a, b), row(a, c), false};
}

// Whether both circles of the edge are one.
bool WorldCells::is_point(Half h) {
  const Quad q = with_disk_on_left(map_.quad(h));
  if (q.s == q.e) return false;
  const auto s = row(q.l, q.s), r = row(q.l, q.r), e = row(q.l, q.e);
  const TangentTriple<Rational> m(site(q.l), s, r, false), n(site(q.l), r, e, false);
  const Rational a = e.x * m.sp - e.s * m.xp + e.p * m.xs, b = e.y * m.sp - e.s * m.yp + e.p * m.ys,
                 c = e.x * m.yp - e.y * m.xp + e.p * m.xy;
  const Sign d = sign(Rational(a * a + b * b - c * c));
  if (d != Sign::zero) return false;
  if (sign_with_root(sign(Rational(m.xp * a + m.yp * b)), sign(c), d) != Sign::zero) return false;
  const Rational x = m.sp * (n.yp * m.xp - n.xp * m.yp), y = n.xp * m.xp + n.yp * m.yp;
  return sign_with_root(sign(x), sign(y), sign(Rational(x * x - gamma(m) * y * y))) ==
         Sign::positive;
}

// From the centre of g to that of the circle; seen from a round frame from its centre, from
// infinity against the normal of the line. Mirrored for frames, whose cells are around the rest.
WorldCells::Direction WorldCells::direction(GenId g, const TangentTriple<Rational>& v,
                                            Ball::Precision bits) {
  const auto ball = [&](const Rational& q) { return Ball(q, bits); };
  const Ball xp = ball(v.xp), yp = ball(v.yp), sp = ball(v.sp), root = sqrt(ball(gamma(v)));
  const Ball x = -(yp * root) - sp * xp, y = xp * root - sp * yp;
  if (g >= 0) return {x, y};
  if (!motion_.has_circle()) return {x, -y};
  const Ball half = ball(v.xp * v.xs + v.yp * v.ys) + root * ball(v.xy), k2 = half + half;
  const Site<Rational>& o = site(container_id);
  return {ball(v.base.x - o.x) * k2 + x, -(ball(v.base.y - o.y) * k2 + y)};
}

std::optional<int> WorldCells::passes(GenId g, const std::vector<TangentTriple<Rational>>& vertices,
                                      const std::vector<bool>& is_point, Ball::Precision bits,
                                      int turn) {
  const Ball a(Rational(7 + 2 * turn), bits), b(Rational(3 + 5 * turn), bits);
  std::vector<Direction> to;
  std::vector<bool> up;
  for (const auto& v : vertices) {
    const Direction d = direction(g, v, bits);
    to.push_back({a * d[0] + b * d[1], a * d[1] - b * d[0]});
    const Sign s = sign(to.back()[1]);
    if (!is_certain(s)) return std::nullopt;
    up.push_back(s == Sign::positive);
  }
  int count = 0;
  for (std::size_t k = 0; k < to.size(); ++k) {
    // The edge k leads from the vertex before to the vertex k.
    const std::size_t before = (k + to.size() - 1) % to.size();
    if (is_point[k]) continue;
    if (up[before] != up[k]) {
      count += up[k] ? 1 : 0;
      continue;
    }
    const Sign s = sign(to[before][0] * to[k][1] - to[before][1] * to[k][0]);
    if (!is_certain(s)) return std::nullopt;
    count += s == Sign::negative ? 1 : 0;
  }
  return count;
}

std::optional<std::string> WorldCells::fault(GenId g) {
  std::vector<TangentTriple<Rational>> vertices;
  std::vector<bool> points;
  for (const Half h : map_.ring(g)) {
    Patience::ask();
    vertices.push_back(triple(h));
    const auto& v = vertices.back();
    if (sgn(v.pj) <= 0 || sgn(v.pk) <= 0 || sgn(gamma(v)) <= 0) {
      return "at the vertex " + name(map_.quad(WorldMap::twin(h))) + " one disk hides another";
    }
    const bool at_infinity =
        !motion_.has_circle() && (g < 0 || map_.dest(h) < 0 || map_.apex(h) < 0);
    const Sign exists = circle_exists(v);
    if (!at_infinity && exists != Sign::positive &&
        (motion_.has_circle() || exists == Sign::negative)) {
      return "the vertex " + name(map_.quad(WorldMap::twin(h))) + " has no circle";
    }
    points.push_back(is_point(h));
  }
  int turn = 0;
  for (Ball::Precision bits = kFirstBits; bits <= kMostBits; bits *= 2, ++turn) {
    const std::optional<int> count = passes(g, vertices, points, bits, turn);
    if (!count) continue;
    if (*count == 1) return std::nullopt;
    return "the cell of " + std::to_string(g) + " winds " + std::to_string(*count) + " times";
  }
  throw WorldUndecided{"how often the cell of " + std::to_string(g) + " winds takes too many bits"};
}

}  // namespace voroproof::internal
