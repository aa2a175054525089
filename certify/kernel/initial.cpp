// The initial diagram: circles exist, each cell winds once, no fourth generator in a circle.
#include "certify/kernel/motion.h"

namespace voroproof_kernel {
namespace {

// u + v sqrt(gamma).
struct Surd {
  Int u, v;
  Surd operator*(const Int& k) const { return {u * k, v * k}; }
  Surd operator+(const Surd& o) const { return {u + o.u, v + o.v}; }
  Surd operator-(const Surd& o) const { return {u - o.u, v - o.v}; }
};

// A direction with surds of one gamma.
struct Direction {
  Surd x, y;
  Int gamma;
  // Whether it is in the lower half plane, from the negative x axis to before the positive one.
  bool lower() const {
    const int sign = sign_with_root(y.u, y.v, gamma);
    return sign < 0 || (sign == 0 && sign_with_root(x.u, x.v, gamma) < 0);
  }
};

// The sign of a x b, x + y sqrt(c) with surds x and y of g.
int turn(const Direction& a, const Direction& b) {
  const Surd x = a.x * b.y.u - a.y * b.x.u, y = a.x * b.y.v - a.y * b.x.v;
  const Int &g = a.gamma, &c = b.gamma;
  const int s = sign_with_root(x.u, x.v, g), r = c == 0 ? 0 : sign_with_root(y.u, y.v, g);
  if (s == r || r == 0) return s;
  if (s == 0) return r;
  return s * sign_with_root(x.u * x.u + x.v * x.v * g - c * (y.u * y.u + y.v * y.v * g),
                            2 * (x.u * x.v - c * y.u * y.v), g);
}

// The direction from generator g to its vertex [g,j,k]: n N; for the container 2 h (c - O) + n N.
Direction direction(const Site<Int>& g, const Site<Int>& j, const Site<Int>& k, bool of_wall,
                    bool with_wall) {
  const Circle c = of_wall ? Circle(j, k, g) : Circle(g, j, k);
  const Int eps = of_wall || with_wall ? 1 : -1;
  Direction d{{-c.sp * c.xp, eps * c.yp}, {-c.sp * c.yp, -eps * c.xp}, c.gamma()};
  if (!of_wall) return d;
  const Surd h{2 * (c.xp * c.xs + c.yp * c.ys), -2 * c.xy};
  d.x = d.x + h * (j.x - g.x);
  d.y = d.y + h * (j.y - g.y);
  return d;
}

// Whether one disk lies inside the other, or outside the container. (Where they touch from inside,
// the vertices of a point coincide.)
bool hidden(int i, int j, const Site<Int>& a, const Site<Int>& b) {
  const int sign = sgn(tangency(a - b));
  return i == container || j == container ? sign > 0 : sign < 0;
}

}  // namespace

bool check_cell(const Walk& walk, int g, const Rat& t) {
  const Diagram& d = *walk.diagram;
  std::vector<Direction> vertices;
  int k = d.spokes(g)[0];
  do {
    // The end vertex [g, r, e]; the next spoke counterclockwise is that of e.
    const Quad q = d.edges()[k].l == g ? d.edges()[k] : d.edges()[k].reversed();
    const Four four{q, {&walk.leg(g), &walk.leg(q.r), &walk.leg(q.e), &walk.leg(q.s)}};
    const Sites at = sites(four.legs, {t})[0];
    if (hidden(g, q.r, at[0], at[1]) || hidden(q.r, q.e, at[1], at[2])) return false;
    const bool with_wall = q.r == container || q.e == container;
    vertices.push_back(direction(at[0], at[1], at[2], g == container, with_wall));
    k = d.next_spoke(k, g);
  } while (k != d.spokes(g)[0]);
  // Angles from 0 to 2 pi: the lower half plane follows the upper. One step falls back.
  int falls = 0;
  bool moves = false;
  for (std::size_t n = 0; n < vertices.size(); ++n) {
    const Direction *a = &vertices[n], *b = &vertices[(n + 1) % vertices.size()];
    if (g == container) std::swap(a, b);  // clockwise around the container
    const int step = a->lower() != b->lower() ? (a->lower() ? -1 : 1) : turn(*a, *b);
    falls += step < 0;
    moves |= step != 0;
  }
  const std::string cell = "the vertices around generator " + std::to_string(g);
  const Sight seen = sight(t, {g});
  if (!moves) undecided(cell + " coincide", seen);
  if (falls != 1) {
    refute("wrong diagram: " + cell + " turn " + std::to_string(falls) + " times", seen);
  }
  return true;
}

void check_initial(const Walk& walk) {
  const int count = static_cast<int>(walk.edges().size());
  for (int k = 0; k < count; ++k) {
    const Four four = walk.four(k);
    const std::string edge = "edge " + name(four.quad);
    const Sight seen = sight(0, four.quad);
    for (const bool start : {true, false}) {
      const int exists = four.exists(0, start);
      if (exists == 0) undecided("a point touches another generator at the start", seen);
      if (exists < 0) {
        refute("wrong initial diagram: a circle of " + edge + " does not exist", seen);
      }
      if (four.quad.s != four.quad.e && four.incircle(0, start) < 0) {
        refute("wrong initial diagram: " + edge + " is not legal", seen);
      }
    }
  }
  for (int g = container; g < walk.problem.disks(); ++g) check_cell(walk, g, 0);
}

}  // namespace voroproof_kernel
