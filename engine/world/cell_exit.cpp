#include "engine/world/cell_exit.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "engine/world/moving_edge.h"
#include "exact/directions.h"
#include "filtered/motion/options.h"

namespace voroproof::internal {
namespace {

// u + sqrt(gamma) v.
struct VertexDirection {
  std::array<TimePolynomial, 2> u, v;
  TimePolynomial gamma;
};

// Where a vertex lies to the ray: on it, to its left, opposite to it, to its right.
enum class Side { on = 0, left = 1, opposite = 2, right = 3 };

using Vector = std::array<TimePolynomial, 2>;
TimePolynomial cross(const Vector& a, const Vector& b) { return a[0] * b[1] - a[1] * b[0]; }

class Exit {
 public:
  Exit(const MovingRows& rows, const Diagram& diagram, GenId j, GenId g, const WorldTime& t)
      : rows_(rows), diagram_(diagram), j_(j), t_(t) {
    const Site<TimePolynomial>& from = origin();
    ray_ = {rows.site(g).x - from.x, rows.site(g).y - from.y};
  }

  Diagram::HalfEdge find() const {
    std::vector<Diagram::HalfEdge> ring;
    std::vector<VertexDirection> starts;
    for (const Diagram::HalfEdge h : diagram_.ring(j_)) {
      ring.push_back(h);
      starts.push_back(start_of(h));
    }
    std::vector<Side> sides;
    for (const VertexDirection& d : starts) {
      sides.push_back(side(d));
      if (sides.back() == Side::on) return ring[sides.size() - 1];
    }
    // The edges follow each other counterclockwise, those of the frame clockwise, once around: the
    // ray leaves where the way leads from its right to its left, or where all are on one side and
    // an edge is longer than half a turn. An edge that collapses at the instant leads backwards
    // just after it.
    const auto next = [&](std::size_t k) { return (k + 1) % ring.size(); };
    const bool one_side =
        std::all_of(sides.begin(), sides.end(), [&](Side side) { return side == sides.front(); });
    std::optional<Diagram::HalfEdge> at_vertex;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const bool leaves =
          one_side ? turns_back(starts[k], starts[next(k)]) : sides[k] > sides[next(k)];
      if (!leaves) continue;
      const Quad q = diagram_.quad(ring[k]);
      if (q.s == q.e || !MovingEdge(rows_, q).collapses_at(t_)) return ring[k];
      at_vertex = ring[k];
    }
    if (at_vertex) return *at_vertex;
    throw Undecided("a disk leaves another towards no edge of its cell");
  }

 private:
  bool is_frame() const { return j_ == container_id; }
  const Site<TimePolynomial>& origin() const {
    return is_frame() ? rows_.circle() : rows_.site(j_);
  }

  // From the origin to the vertex at which the edge of h starts.
  VertexDirection start_of(Diagram::HalfEdge h) const {
    const Quad q = diagram_.quad(h);
    const GenId base = is_frame() ? q.r : q.l;
    const GenId second = is_frame() ? q.l : q.s, third = is_frame() ? q.s : q.r;
    const TangentTriple<TimePolynomial> m(rows_.site(base), rows_.row_of(base, second),
                                          rows_.row_of(base, third), false);
    VertexDirection d{{-(m.sp * m.xp), -(m.sp * m.yp)}, {-m.yp, m.xp}, gamma(m)};
    if (is_frame()) {
      const TimePolynomial u = m.xp * m.xs + m.yp * m.ys, x = m.base.x - origin().x,
                           y = m.base.y - origin().y, twice_u = u + u, twice_v = m.xy + m.xy;
      d.u = {d.u[0] + x * twice_u, d.u[1] + y * twice_u};
      d.v = {d.v[0] + x * twice_v, d.v[1] + y * twice_v};
    }
    return d;
  }

  Side side(const VertexDirection& d) const {
    const auto dot = [&](const std::array<TimePolynomial, 2>& w) {
      return ray_[0] * w[0] + ray_[1] * w[1];
    };
    Sign turn = sign_after(cross(ray_, d.u), d.gamma, cross(ray_, d.v), t_);
    if (is_frame()) turn = -turn;
    if (turn == Sign::positive) return Side::left;
    if (turn == Sign::negative) return Side::right;
    return sign_after(dot(d.u), d.gamma, dot(d.v), t_) == Sign::positive ? Side::on
                                                                         : Side::opposite;
  }

  // Whether the shorter way from a to b is the one back.
  bool turns_back(const VertexDirection& a, const VertexDirection& b) const {
    const Ball at = ball_about(t_);
    const auto direction = [&](const VertexDirection& d) -> Direction<Ball> {
      const Ball root = sqrt(value(d.gamma, at));
      return {value(d.u[0], at) + root * value(d.v[0], at),
              value(d.u[1], at) + root * value(d.v[1], at)};
    };
    Sign turn = internal::cross(direction(a), direction(b));
    if (!is_certain(turn)) turn = turn_after(a, b);
    return turn == (is_frame() ? Sign::positive : Sign::negative);
  }

  // The sign of the cross product of two vertex directions just after the instant, exactly.
  Sign turn_after(const VertexDirection& a, const VertexDirection& b) const {
    // (m + sqrt(g) n) + sqrt(h) (p + sqrt(g) q)
    const TimePolynomial &g = a.gamma, &h = b.gamma;
    const TimePolynomial m = cross(a.u, b.u), n = cross(a.v, b.u), p = cross(a.u, b.v),
                         q = cross(a.v, b.v);
    if (g == h) return sign_after(m + g * q, g, n + p, t_);
    const Sign first = sign_after(m, g, n, t_), second = sign_after(p, g, q, t_);
    if (first == second) return first;
    const TimePolynomial twice_mn = m * n + m * n, twice_pq = p * q + p * q;
    return sign_with_root(
        first, second,
        sign_after(m * m + g * n * n - h * (p * p + g * q * q), g, twice_mn - h * twice_pq, t_));
  }

  const MovingRows& rows_;
  const Diagram& diagram_;
  GenId j_;
  const WorldTime& t_;
  std::array<TimePolynomial, 2> ray_;
};

}  // namespace

Diagram::HalfEdge cell_exit(const MovingRows& rows, const Diagram& diagram, GenId j, GenId g,
                            const WorldTime& t) {
  return Exit(rows, diagram, j, g, t).find();
}

}  // namespace voroproof::internal
