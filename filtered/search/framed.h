// The circles of a diagram's vertices, whatever bounds it: its rows, for predicates at one instant.
#pragma once

#include <array>
#include <limits>
#include <type_traits>

#include "exact/ball.h"
#include "exact/predicates.h"
#include "filtered/search/collapse.h"

namespace voroproof::internal {

// The bound of a diagram: the container, nothing, or four walls.
//
// Without a container the generator -1 is infinity: its cell is where no other is, and the circles
// that touch it are the lines that touch two disks on one side. The last four generators of a box
// are its walls. To a wall the distance is that to its line, positive inside, everywhere in the
// plane: it is a disk without end. So far out there is one vertex of each two walls that meet in a
// corner with infinity, and no disk has infinity as its neighbour.
enum class Frame { circle, plane, box };
inline constexpr GenId wall_count = 4;
// Among so many disks and walls.
inline GenId disk_count(Frame frame, GenId generators) {
  return frame == Frame::box ? generators - wall_count : generators;
}

// The whole number n, of the kind of x.
template <class T>
T whole_like(const T&, int n) {
  return T(n);
}
inline Ball whole_like(const Ball& x, int n) { return {static_cast<double>(n), x.precision()}; }

// `Sites` gives the site of a generator at the instant (InstantPredicates); none of infinity is
// asked for, and that of a wall is any place on its line, with the radius 0.
class Framed {
 public:
  // `generators` is the number of disks and walls; only in a box it matters.
  explicit Framed(Frame frame, GenId generators = std::numeric_limits<GenId>::max())
      : frame_(frame), first_wall_(disk_count(frame, generators)) {}

  bool has_walls() const { return frame_ == Frame::box; }
  bool is_infinity(GenId g) const { return frame_ != Frame::circle && g == container_id; }
  bool is_wall(GenId g) const { return g >= first_wall_; }
  bool is_disk(GenId g) const { return g >= 0 && !is_wall(g); }
  // The walls in the order of contacts with a circle between them, counterclockwise, from the left
  // one on. A wall has a quarter turn for each place in it.
  GenId wall(int quarter) const { return first_wall_ + quarter; }
  int quarter(GenId wall) const { return wall - first_wall_; }

  // The vector (x, y) in the frame of a wall: along it, with the inside on the right, and inwards.
  // That frame is a reflection of the plane: of a vector in it this gives the one in the plane.
  template <class T>
  std::array<T, 2> reflected(GenId wall, const T& x, const T& y) const {
    switch (quarter(wall)) {
      case 0:
        return {y, x};
      case 1:
        return {-x, y};
      case 2:
        return {-y, -x};
      default:
        return {x, -y};
    }
  }
  // How far the place is along a wall and from it.
  template <class T>
  std::array<T, 2> seen_from_wall(GenId wall, const Site<T>& line, const T& x, const T& y) const {
    return reflected<T>(wall, x - line.x, y - line.y);
  }

  template <class Sites>
  auto row_of(Sites& at, GenId base, GenId g) const {
    return row_from(at, at(base), g);
  }
  // The circle that touches the disk `base` and b, c counterclockwise.
  template <class Sites>
  auto circle(Sites& at, GenId base, GenId b, GenId c) const {
    const bool wall = frame_ == Frame::circle && (b == container_id || c == container_id);
    return TangentTriple(at(base), row_of(at, base, b), row_of(at, base, c), wall);
  }
  // The same of the vertex [a,b,c]. Precondition: one of them is a disk.
  template <class Sites>
  auto triple(Sites& at, GenId a, GenId b, GenId c) const {
    return is_disk(a)   ? circle(at, a, b, c)
           : is_disk(b) ? circle(at, b, c, a)
                        : circle(at, c, a, b);
  }
  bool has_disk(const std::array<GenId, 3>& v) const {
    return is_disk(v[0]) || is_disk(v[1]) || is_disk(v[2]);
  }
  bool is_at_infinity(const std::array<GenId, 3>& v) const {
    return is_infinity(v[0]) || is_infinity(v[1]) || is_infinity(v[2]);
  }
  // Whether there is a circle of a vertex of walls, or one of two walls with infinity.
  bool exists_of_walls(std::array<GenId, 3> v) const {
    while (!is_wall(v[0]) || (is_infinity(v[1]))) v = {v[1], v[2], v[0]};
    if (!is_wall(v[1])) return false;
    const int turn = (quarter(v[1]) - quarter(v[0])) & 3;
    if (is_infinity(v[2])) return turn == 3;
    return is_wall(v[2]) && turn < ((quarter(v[2]) - quarter(v[0])) & 3);
  }
  // The circle between three walls, as a disk of the opposite radius.
  template <class Sites>
  auto between_walls(Sites& at, const std::array<GenId, 3>& v) const {
    // Two are opposite to each other, and a quarter turn from the third, the middle one.
    const int sum = quarter(v[0]) + quarter(v[1]) + quarter(v[2]);
    const int middle = (wall_count * (wall_count - 1) / 2 - sum + 2) & 3;
    const auto line = at(wall(middle)), low = at(wall((middle + 3) & 3)),
               high = at(wall((middle + 1) & 3));
    using T = std::decay_t<decltype(line.x)>;
    const T half = whole_like(line.x, 1) / whole_like(line.x, 2);
    const GenId m = wall(middle);
    const auto a = seen_from_wall<T>(m, line, low.x, low.y),
               b = seen_from_wall<T>(m, line, high.x, high.y);
    const T across = a[0] - b[0];
    const T rho = across * half, along = (a[0] + b[0]) * half;
    const auto z = reflected<T>(m, along, rho);
    return Site<T>{line.x + z[0], line.y + z[1], -rho};
  }
  // The tangency of that circle and g: its sign is that of their distance.
  template <class Sites>
  auto tangency_between_walls(Sites& at, const std::array<GenId, 3>& v, GenId g) const {
    return row_from(at, between_walls(at, v), g).p;
  }
  // The centre of the circle of a vertex that is not at infinity.
  template <class Sites, class Root>
  auto center(Sites& at, Root& root, GenId a, GenId b, GenId c) const {
    using T = std::decay_t<decltype(at(a < 0 ? b : a).x)>;
    if (!has_disk({a, b, c})) {
      const auto z = between_walls(at, {a, b, c});
      return std::array<T, 2>{z.x, z.y};
    }
    const auto z = tangent_circle(triple(at, a, b, c), root);
    return std::array<T, 2>{z[0], z[1]};
  }
  // Direction from the disk `base` to the vertex (base, b, c), up to a positive factor.
  template <class Sites, class Root>
  auto direction(Sites& at, Root& root, GenId base, GenId b, GenId c) const {
    return circle_direction(circle(at, base, b, c), root);
  }
  template <class Sites>
  auto tangency(Sites& at, GenId a, GenId b) const {
    if (is_disk(a)) return row_of(at, a, b).p;
    if (is_disk(b)) return row_of(at, b, a).p;
    const GenId wall = is_wall(a) ? a : b;
    using T = std::decay_t<decltype(at(wall).x)>;
    return T(whole_like(at(wall).x, is_wall(a + b - wall) ? tangency_of_walls(a, b) : 0));
  }
  // |n - n'|^2: of neighbouring walls 2, of opposite ones 4.
  int tangency_of_walls(GenId a, GenId b) const {
    const int turn = (quarter(a) - quarter(b)) & 3;
    return turn == 0 ? 0 : turn == 2 ? 4 : 2;
  }
  // a, b and c are those of a vertex.
  template <class Sites>
  auto cotangency(Sites& at, GenId a, GenId b, GenId c, GenId d) const {
    const auto p = [&](GenId g, GenId h) { return tangency(at, g, h); };
    return cotangency_of(p(a, b) * p(c, d), p(a, c) * p(b, d), p(a, d) * p(b, c));
  }
  // Where the generator e lies to the circle of the vertex [a,b,c], as incircle() says. `f` is the
  // sign of their cotangency.
  template <class Sites>
  Sign incircle(Sites& at, const std::array<GenId, 3>& v, GenId e, Sign f) const {
    if (frame_ == Frame::box) {
      if (is_at_infinity(v)) return Sign::positive;
      if (!has_disk(v)) return sign(tangency_between_walls(at, v, e));
    }
    const auto circle = triple(at, v[0], v[1], v[2]);
    if (is_infinity(e)) return circle_exists(circle);
    return internal::incircle(circle, row_from(at, circle.base, e), e == container_id, f);
  }

 private:
  // As seen from a disk, which need be no generator.
  template <class Sites, class T>
  GeneratorRow<T> row_from(Sites& at, const Site<T>& from, GenId g) const {
    const auto whole = [&](int n) { return T(whole_like(from.x, n)); };
    if (is_infinity(g)) return {whole(0), whole(0), whole(0), whole(1)};
    if (!is_wall(g)) return row<T>(from, at(g));
    const auto inwards = reflected<int>(g, 0, 1);
    const T half = seen_from_wall<T>(g, at(g), from.x, from.y)[1] + from.r;
    return {whole(-inwards[0]), whole(-inwards[1]), whole(1), half + half};
  }

  Frame frame_;
  GenId first_wall_;
};

}  // namespace voroproof::internal
