// The circles of a diagram's vertices, whatever bounds it: its rows, for predicates at one instant.
#pragma once

#include <array>
#include <type_traits>

#include "exact/ball.h"
#include "exact/predicates.h"
#include "filtered/search/collapse.h"

namespace voroproof::internal {

// The bound of a diagram: the container, or nothing. Then the generator -1 is infinity: its cell is
// where no other is, and the circles that touch it are the lines that touch two disks on one side.
enum class Frame { circle, plane };

// The whole number n, of the kind of x.
template <class T>
T whole_like(const T&, int n) {
  return T(n);
}
inline Ball whole_like(const Ball& x, int n) { return {static_cast<double>(n), x.precision()}; }

// `Sites` gives the site of a generator at the instant (InstantPredicates); none of infinity is
// asked for.
class Framed {
 public:
  explicit Framed(Frame frame) : frame_(frame) {}

  bool is_infinity(GenId g) const { return frame_ == Frame::plane && g == container_id; }

  template <class Sites>
  auto row_of(Sites& at, GenId base, GenId g) const {
    const auto& from = at(base);
    using T = std::decay_t<decltype(from.x)>;
    if (!is_infinity(g)) return row<T>(from, at(g));
    const T zero = whole_like(from.x, 0);
    return GeneratorRow<T>{zero, zero, zero, whole_like(from.x, 1)};
  }
  // The circle that touches the disk `base` and b, c counterclockwise.
  template <class Sites>
  auto circle(Sites& at, GenId base, GenId b, GenId c) const {
    const bool wall = frame_ == Frame::circle && (b == container_id || c == container_id);
    return TangentTriple(at(base), row_of(at, base, b), row_of(at, base, c), wall);
  }
  // The same of the vertex [a,b,c].
  template <class Sites>
  auto triple(Sites& at, GenId a, GenId b, GenId c) const {
    const auto v = disk_first(a, b, c);
    return circle(at, v[0], v[1], v[2]);
  }
  // Direction from the disk `base` to the vertex (base, b, c), up to a positive factor.
  template <class Sites, class Root>
  auto direction(Sites& at, Root& root, GenId base, GenId b, GenId c) const {
    return circle_direction(circle(at, base, b, c), root);
  }
  template <class Sites>
  auto tangency(Sites& at, GenId a, GenId b) const {
    return a == container_id ? row_of(at, b, a).p : row_of(at, a, b).p;
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
    const auto circle = triple(at, v[0], v[1], v[2]);
    if (is_infinity(e)) return circle_exists(circle);
    return internal::incircle(circle, at(e), e == container_id, f);
  }

 private:
  Frame frame_;
};

}  // namespace voroproof::internal
