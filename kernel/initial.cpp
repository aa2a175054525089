// The initial diagram: circles exist, each cell winds once, no fourth generator in a circle.
#include "kernel/lives.h"

namespace voroproof_kernel {
namespace {

// u + v sqrt(gamma).
struct Surd {
  Int u, v;
};

// The sign of x + y sqrt(c), where x and y are surds of g.
int sign_with_two_roots(const Surd& x, const Surd& y, const Int& g, const Int& c) {
  const int a = sign_with_root(x.u, x.v, g), b = c == 0 ? 0 : sign_with_root(y.u, y.v, g);
  if (a == b || b == 0) return a;
  if (a == 0) return b;
  return a * sign_with_root(Int(x.u * x.u + x.v * x.v * g - c * (y.u * y.u + y.v * y.v * g)),
                            Int(2 * x.u * x.v - 2 * c * y.u * y.v), g);
}

// A direction with surds of one gamma.
struct Direction {
  Surd x, y;
  Int gamma;
};

// The sign of a x b.
int turn(const Direction& a, const Direction& b) {
  const auto times = [](const Surd& p, const Int& k) { return Surd{Int(p.u * k), Int(p.v * k)}; };
  const auto minus = [](const Surd& p, const Surd& q) {
    return Surd{Int(p.u - q.u), Int(p.v - q.v)};
  };
  return sign_with_two_roots(minus(times(a.x, b.y.u), times(a.y, b.x.u)),
                             minus(times(a.x, b.y.v), times(a.y, b.x.v)), a.gamma, b.gamma);
}

// From generator g to its vertex [g,j,k]: n N, or for the container 2 h (c - O) + n N.
Direction direction(const Site<Int>& g, const Site<Int>& j, const Site<Int>& k, bool of_wall,
                    bool with_wall) {
  const Circle<Int> c = of_wall ? Circle<Int>(j, k, g) : Circle<Int>(g, j, k);
  const int eps = of_wall || with_wall ? 1 : -1;
  Direction d{{Int(-c.sp * c.xp), Int(eps * c.yp)},
              {Int(-c.sp * c.yp), Int(-eps * c.xp)},
              Int(c.xp * c.xp + c.yp * c.yp - c.sp * c.sp)};
  if (!of_wall) return d;
  const Surd h{Int(2 * (c.xp * c.xs + c.yp * c.ys)), Int(-2 * c.xy)};
  const Int x = j.x - g.x, y = j.y - g.y;
  d.x = {Int(d.x.u + h.u * x), Int(d.x.v + h.v * x)};
  d.y = {Int(d.y.u + h.u * y), Int(d.y.v + h.v * y)};
  return d;
}

}  // namespace

void check_cell(const Walk& walk, int g, const Rat& t) {
  Edge4 four;
  const Diagram& d = *walk.diagram;
  std::vector<Direction> vertices;
  const int first = d.spokes(g)[0];
  int k = first;
  do {
    Quad q = d.edges()[k];
    if (q.l != g) q = {q.r, q.l, q.e, q.s};
    // The end vertex [g, r, e]; the next spoke counterclockwise is that of e.
    const auto at = four.sites({&walk.leg(g), &walk.leg(q.r), &walk.leg(q.e), &walk.leg(q.s)}, t);
    vertices.push_back(
        direction(at[0], at[1], at[2], g == container, q.r == container || q.e == container));
    k = d.next_spoke(k, g);
  } while (k != first);
  // Angles from 0 to 2 pi: the lower half plane follows the upper. One step falls back.
  const auto lower = [](const Direction& v) {
    const int y = sign_with_root(v.y.u, v.y.v, v.gamma);
    return y < 0 || (y == 0 && sign_with_root(v.x.u, v.x.v, v.gamma) < 0);
  };
  int falls = 0;
  bool moves = false;
  for (std::size_t n = 0; n < vertices.size(); ++n) {
    const Direction *a = &vertices[n], *b = &vertices[(n + 1) % vertices.size()];
    if (g == container) std::swap(a, b);  // clockwise around the container
    const int step = lower(*a) != lower(*b) ? (lower(*a) ? -1 : 1) : turn(*a, *b);
    falls += step < 0;
    moves |= step != 0;
  }
  const std::string cell = "the vertices around generator " + std::to_string(g);
  if (!moves) undecided(cell + " coincide");
  if (falls != 1) refute("wrong diagram: " + cell + " turn " + std::to_string(falls) + " times");
}

void check_initial(const Walk& walk) {
  const Diagram& d = *walk.diagram;
  for (const Quad& q : d.edges()) {
    Edge4 four;
    four.set(q, {&walk.leg(q.l), &walk.leg(q.r), &walk.leg(q.s), &walk.leg(q.e)});
    const std::string name = "[" + std::to_string(q.l) + "," + std::to_string(q.r) + "," +
                             std::to_string(q.s) + "," + std::to_string(q.e) + "]";
    for (const bool start : {true, false}) {
      const int exists = four.existence_at(0, start);
      if (exists == kTouching) undecided("a point touches another generator at the start");
      if (exists <= 0)
        refute("wrong initial diagram: a circle of edge " + name + " does not exist");
      if (q.s != q.e && four.incircle_at(0, start) < 0) {
        refute("wrong initial diagram: edge " + name + " is not legal");
      }
    }
  }
  for (int g = container; g < walk.problem.disks(); ++g) check_cell(walk, g, 0);
}

}  // namespace voroproof_kernel
