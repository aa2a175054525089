#include "certify/initial_proof.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "certify/on_threads.h"
#include "exact/names.h"
#include "filtered/search/collapse.h"
#include "filtered/search/instant_predicates.h"

namespace voroproof::internal {

namespace {

using HalfEdge = Diagram::HalfEdge;

// The side of the x axis a direction lies on: positive for angles in [0, pi), negative for [pi,
// 2 pi).
template <class T>
Sign half_plane(const std::array<T, 2>& d) {
  const Sign y = sign(d[1]);
  return y == Sign::zero ? sign(d[0]) : y;
}

// The sign of angle(b) - angle(a), angles in [0, 2 pi) counterclockwise from the x axis.
template <class T>
Sign angle_order(const std::array<T, 2>& a, const std::array<T, 2>& b) {
  const Sign ha = half_plane(a), hb = half_plane(b);
  if (ha == Sign::unknown || hb == Sign::unknown) return Sign::unknown;
  if (ha != hb) return ha;
  return sign(T(a[0] * b[1] - a[1] * b[0]));
}

class InitialProof {
 public:
  InitialProof(const Diagram& diagram, Frame frame, const Motion& motion, const Rational& t,
               TierCounts& counts, int threads)
      : diagram_(diagram),
        frame_(frame),
        framed_(frame, motion.size()),
        motion_(motion),
        counts_(counts),
        threads_(threads),
        predicates_(motion, t, counts) {}

  // All threads prove what doubles can prove. This thread proves the rest. `is_legal_after` tells
  // of an edge of which both circles touch all four generators whether it is there just after.
  template <class IsLegalAfter>
  std::optional<InitialFault> fault(const IsLegalAfter& is_legal_after) {
    const int edges = diagram_.edges();
    for (const int e : unproved(edges, [this](int k) { return prove_tangency(2 * k); })) {
      require_tangency(diagram_.org(2 * e), diagram_.dest(2 * e));
    }
    for (const HalfEdge h : unproved(2 * edges, [this](int k) { return prove_vertex(k); })) {
      if (auto f = vertex_fault(h)) return f;
    }
    for (const int e :
         unproved(edges, [this](int k) { return prove_edge(diagram_.quad(2 * k)); })) {
      if (auto f = edge_fault(diagram_.quad(2 * e), is_legal_after)) return f;
    }
    for (const int k :
         unproved(diagram_.disks() + 1, [this](int k) { return prove_cell(k - 1); })) {
      if (auto f = cell_fault(k - 1)) return f;
    }
    return std::nullopt;
  }

 private:
  // `predicate` as InstantPredicates takes it; gives a sign.
  template <class F>
  Sign decide(F&& predicate) {
    try {
      return predicates_.decide_sign(predicate);
    } catch (const std::domain_error&) {
      // Recorded truth: one of the generators lies inside another, and there is no such circle.
      throw Undecided("a generator lies inside another where a diagram is to be proved");
    }
  }

  // The direction from g to its vertex with i and j.
  template <class Sites, class Root>
  auto direction(Sites& at, Root& root, GenId g, GenId i, GenId j) const {
    const auto v = framed_.triple(at, g, i, j);
    using Vec = std::array<std::decay_t<decltype(v.pj)>, 2>;
    // From infinity all lines to a vertex have the direction of those from disks.
    if (g != container_id || framed_.is_infinity(g)) return Vec(circle_direction(v, root));
    const auto base = at(g);
    const auto z = tangent_circle(v, root);
    return Vec{z[0] - base.x, z[1] - base.y};
  }

  // ---- In doubles, for any thread: the number of signs that prove it, or nothing. ----

  // Those of 0 .. count-1, in this order, that `prove` does not.
  template <class Prove>
  std::vector<int> unproved(int count, const Prove& prove) {
    struct Block {
      std::vector<int> unproved;
      std::uint64_t signs = 0;
    };
    constexpr int kBlock = 4096;
    std::vector<Block> blocks(static_cast<std::size_t>((count + kBlock - 1) / kBlock));
    const auto work = [&](std::size_t b) {
      const int first = static_cast<int>(b) * kBlock;
      for (int k = first; k < std::min(first + kBlock, count); ++k) {
        const auto signs = motion_.options().filters ? prove(k) : std::nullopt;
        blocks[b].signs += signs.value_or(0);
        if (!signs) blocks[b].unproved.push_back(k);
      }
    };
    on_threads(blocks.size(), threads_, work);
    std::vector<int> all;
    for (const Block& block : blocks) {
      all.insert(all.end(), block.unproved.begin(), block.unproved.end());
      counts_.count(Predicate::incircle, Tier::filter, block.signs);
    }
    return all;
  }

  std::optional<int> prove_tangency(HalfEdge h) const {
    const GenId a = diagram_.org(h), b = diagram_.dest(h);
    if (is_fixed(a, b)) return 0;
    const Sign s = sign(framed_.tangency(rough_, a, b));
    return s == tangency_sign(a, b) ? std::optional(1) : std::nullopt;
  }
  std::optional<int> prove_vertex(HalfEdge h) const {
    if (!is_named_by(h)) return 0;
    const GenId a = diagram_.org(h), b = diagram_.dest(h), c = diagram_.apex(h);
    if (is_line(a, b, c)) return 0;
    const Sign s = exists(rough_, {a, b, c});
    return s == Sign::positive ? std::optional(1) : std::nullopt;
  }
  // Legal: both in-circle functions at once.
  std::optional<int> prove_edge(const Quad& q) const {
    if (q.s == q.e) return 0;
    const Sign f = sign(framed_.cotangency(rough_, q.l, q.s, q.r, q.e));
    const bool legal = framed_.incircle(rough_, start_vertex(q), q.e, f) == Sign::positive &&
                       framed_.incircle(rough_, end_vertex(q), q.s, f) == Sign::positive;
    return legal ? std::optional(2) : std::nullopt;
  }
  // The vertices turn once; each direction is computed once.
  std::optional<int> prove_cell(GenId g) const {
    const OwnRoot root;
    const HalfEdge first = diagram_.anchor(g);
    if (first < 0) return 0;  // hidden
    if (framed_.has_walls() && !framed_.is_disk(g)) return std::nullopt;
    const auto vertex = [&](HalfEdge h) {
      return direction(rough_, root, g, diagram_.dest(h), diagram_.apex(h));
    };
    int falls = 0, steps = 0;
    auto d = vertex(first);
    HalfEdge h = first;
    do {
      h = diagram_.rotate(h);
      const auto e = vertex(h);
      // Around the container the vertices run clockwise.
      const Sign step = g == container_id ? angle_order(e, d) : angle_order(d, e);
      if (step == Sign::unknown) return std::nullopt;
      falls += step == Sign::negative;
      ++steps;
      d = e;
    } while (h != first);
    return falls == 1 ? std::optional(steps) : std::nullopt;
  }

  // ---- By all tiers. ----

  // Each vertex is named once: by its smallest half-edge.
  bool is_named_by(HalfEdge h) const { return h < diagram_.next(h) && h < diagram_.previous(h); }
  Sign tangency_sign(GenId a, GenId b) const {
    const bool wall = frame_ == Frame::circle && (a == container_id || b == container_id);
    return wall ? Sign::negative : Sign::positive;
  }
  // The circle of such a vertex is a line, which exists where the tangency is right.
  bool is_line(GenId a, GenId b, GenId c) const {
    return frame_ == Frame::plane && framed_.is_at_infinity({a, b, c});
  }
  template <class Sites>
  Sign exists(Sites& at, const std::array<GenId, 3>& v) const {
    if (!framed_.has_disk(v)) {
      return framed_.exists_of_walls(v) ? Sign::positive : Sign::negative;
    }
    if (framed_.has_walls() && framed_.is_at_infinity(v)) return Sign::negative;
    return circle_exists(framed_.triple(at, v[0], v[1], v[2]));
  }
  // Walls and infinity are always beside each other as they are.
  bool is_fixed(GenId a, GenId b) const {
    return framed_.has_walls() && !framed_.is_disk(a) && !framed_.is_disk(b);
  }

  // Two generators, neither of which lies in the other nor is a point of its boundary.
  void require_tangency(GenId a, GenId b) {
    if (is_fixed(a, b)) return;
    const Sign s = decide([&](auto at, auto) { return sign(framed_.tangency(at, a, b)); });
    if (s == tangency_sign(a, b)) return;
    throw Undecided(s == Sign::zero ? "a point touches another generator: its cell has no area"
                                    : "a generator lies inside another",
                    std::min(a, b), std::max(a, b));
  }

  std::optional<InitialFault> vertex_fault(HalfEdge h) {
    if (!is_named_by(h)) return std::nullopt;
    const GenId a = diagram_.org(h), b = diagram_.dest(h), c = diagram_.apex(h);
    if (is_line(a, b, c)) return std::nullopt;
    const Sign s = decide([&](auto at, auto) { return exists(at, {a, b, c}); });
    // In the plane a circle may be a line.
    if (s == Sign::positive || (frame_ == Frame::plane && s == Sign::zero)) return std::nullopt;
    const Triple v = canonical(Triple{a, b, c});
    return InitialFault{"no circle touches the generators of vertex " + text_of(v) +
                            " counterclockwise in this order",
                        {},
                        v,
                        {},
                        {}};
  }

  template <class IsLegalAfter>
  std::optional<InitialFault> edge_fault(const Quad& q, const IsLegalAfter& is_legal_after) {
    if (q.s == q.e) return std::nullopt;
    const auto side = [&](const Triple& v, GenId other) {
      return decide([&](auto at, auto) {
        const Sign f = sign(framed_.cotangency(at, q.l, q.s, q.r, q.e));
        return framed_.incircle(at, v, other, f);
      });
    };
    const Sign start = side(start_vertex(q), q.e), end = side(end_vertex(q), q.s);
    if (start == Sign::negative || end == Sign::negative) {
      const bool first = start == Sign::negative;
      const Triple v = first ? start_vertex(q) : end_vertex(q);
      const GenId inside = first ? q.e : q.s;
      return InitialFault{"the circle of vertex " + text_of(v) + " contains a point of generator " +
                              std::to_string(inside),
                          q,
                          v,
                          inside,
                          {}};
    }
    if (start == Sign::positive || end == Sign::positive) return std::nullopt;
    if (is_legal_after(q)) return std::nullopt;
    return InitialFault{"the four generators of edge " + text_of(q) +
                            " are cotangent and the edge is not legal just after",
                        q,
                        {},
                        {},
                        {}};
  }

  // The step from the vertex (g, a, b) to (g, b, c) around a wall g: along it, or from far out on
  // one side to far out on the other.
  Sign step_along_wall(GenId g, GenId a, GenId b, GenId c) {
    if (framed_.is_infinity(b)) return Sign::negative;
    if (framed_.is_infinity(a) || framed_.is_infinity(c)) return Sign::positive;
    return decide([&](auto at, auto root) {
      const auto from = framed_.center(at, root, g, a, b), to = framed_.center(at, root, g, b, c);
      using T = std::decay_t<decltype(from[0])>;
      return sign(framed_.template reflected<T>(g, to[0] - from[0], to[1] - from[1])[0]);
    });
  }
  Sign step_around(GenId g, GenId a, GenId b, GenId c) {
    if (framed_.is_wall(g)) return step_along_wall(g, a, b, c);
    return decide([&](auto at, auto root) {
      const auto d = direction(at, root, g, a, b), e = direction(at, root, g, b, c);
      // Around the container the vertices run clockwise.
      return g == container_id ? angle_order(e, d) : angle_order(d, e);
    });
  }

  // The vertices around g must turn exactly once: among the steps from each to the next exactly
  // one falls back in angle. Around the walls each step is a quarter turn.
  std::optional<InitialFault> cell_fault(GenId g) {
    if (diagram_.anchor(g) < 0) return std::nullopt;  // hidden
    int falls = 0;
    bool turns = false;
    const bool around_walls = framed_.has_walls() && g == container_id;
    int steps = 0;
    for (const HalfEdge h : diagram_.ring(g)) {
      const HalfEdge next = diagram_.rotate(h);
      const GenId a = diagram_.dest(h), b = diagram_.apex(h), c = diagram_.apex(next);
      if (around_walls) {
        turns = true;
        if (steps++ % wall_count == 0) ++falls;
        continue;
      }
      const Sign step = step_around(g, a, b, c);
      // Two coincident vertices do not move the angle; a full turn between them would need
      // another fall elsewhere.
      if (step == Sign::negative) ++falls;
      turns = turns || step != Sign::zero;
    }
    if (falls == 1) return std::nullopt;
    if (!turns) {
      // A point that touches another generator: its cell has no area, and the vertices coincide.
      throw Undecided("the vertices around generator " + std::to_string(g) +
                      " of the initial diagram coincide");
    }
    return InitialFault{"the vertices around generator " + std::to_string(g) + " turn " +
                            std::to_string(falls) + " times, not once",
                        {},
                        {},
                        {},
                        g};
  }

  const Diagram& diagram_;
  Frame frame_;
  Framed framed_;
  const Motion& motion_;
  TierCounts& counts_;
  int threads_;
  InstantPredicates predicates_;
  // The sites in doubles.
  struct Rough {
    const InstantPredicates& predicates;
    const Site<DoubleBall>& operator()(GenId g) const { return predicates.rough(g); }
  };
  const Rough rough_{predicates_};
};

}  // namespace

std::optional<InitialFault> initial_fault(const Diagram& diagram, Motion& motion, const Rational& t,
                                          TierCounts& counts, int threads) {
  return InitialProof(diagram, Frame::circle, motion, t, counts, threads).fault([&](const Quad& q) {
    const Moment now = Moment::at(t);
    CollapseSearch search(motion, counts);
    return search.from(q, now, now.hi).kind != Collapse::Kind::now;
  });
}

std::optional<InitialFault> resting_fault(const Diagram& diagram, Frame frame, const Motion& motion,
                                          TierCounts& counts, int threads) {
  return InitialProof(diagram, frame, motion, 0, counts, threads).fault([](const Quad&) {
    return true;
  });
}

}  // namespace voroproof::internal
