#include "certify/initial_proof.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "certify/edge_signs.h"
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
  InitialProof(const Diagram& diagram, Motion& motion, const Rational& t, TierCounts& counts,
               int threads)
      : diagram_(diagram),
        motion_(motion),
        t_(t),
        counts_(counts),
        threads_(threads),
        predicates_(motion, t, counts) {}

  // All threads prove what doubles can prove. This thread proves the rest.
  std::optional<InitialFault> fault() {
    const int edges = diagram_.edges();
    for (const int e : unproved(edges, [this](int k) { return prove_tangency(2 * k); })) {
      require_tangency(diagram_.org(2 * e), diagram_.dest(2 * e));
    }
    for (const HalfEdge h : unproved(2 * edges, [this](int k) { return prove_vertex(k); })) {
      if (auto f = vertex_fault(h)) return f;
    }
    for (const int e :
         unproved(edges, [this](int k) { return prove_edge(diagram_.quad(2 * k)); })) {
      if (auto f = edge_fault(diagram_.quad(2 * e))) return f;
    }
    for (const int k :
         unproved(diagram_.disks() + 1, [this](int k) { return prove_cell(k - 1); })) {
      if (auto f = cell_fault(k - 1)) return f;
    }
    return std::nullopt;
  }

 private:
  template <class Sites>
  static auto triple_at(Sites& at, GenId a, GenId b, GenId c) {
    return tangent_triple(a, at(a), b, at(b), c, at(c));
  }

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
  static auto direction(Sites& at, Root& root, GenId g, GenId i, GenId j) {
    const auto base = at(g);
    using Vec = std::array<std::decay_t<decltype(base.x)>, 2>;
    const auto v = triple_at(at, g, i, j);
    if (g != container_id) return Vec(circle_direction(v, root));
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
    if (threads_ == 1 || blocks.size() < 2) {
      for (std::size_t b = 0; b < blocks.size(); ++b) work(b);
    } else {
      namespace tbb = oneapi::tbb;
      // As many threads are allowed as are asked for, also more than the machine has.
      const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                        static_cast<std::size_t>(threads_));
      tbb::task_arena(threads_).execute(
          [&] { tbb::parallel_for(std::size_t{0}, blocks.size(), work); });
    }
    std::vector<int> all;
    for (const Block& block : blocks) {
      all.insert(all.end(), block.unproved.begin(), block.unproved.end());
      counts_.count(Predicate::incircle, Tier::filter, block.signs);
    }
    return all;
  }

  std::optional<int> prove_tangency(HalfEdge h) const {
    const GenId a = diagram_.org(h), b = diagram_.dest(h);
    const Sign s = sign(tangency(predicates_.rough(a), predicates_.rough(b)));
    return s == tangency_sign(a, b) ? std::optional(1) : std::nullopt;
  }
  std::optional<int> prove_vertex(HalfEdge h) const {
    if (!is_named_by(h)) return 0;
    const auto at = [this](GenId g) { return predicates_.rough(g); };
    const Sign s =
        circle_exists(triple_at(at, diagram_.org(h), diagram_.dest(h), diagram_.apex(h)));
    return s == Sign::positive ? std::optional(1) : std::nullopt;
  }
  // Legal: both in-circle functions at once.
  std::optional<int> prove_edge(const Quad& q) const {
    if (q.s == q.e) return 0;
    const auto at = [this](GenId g) { return predicates_.rough(g); };
    const auto l = at(q.l), r = at(q.r), s = at(q.s), e = at(q.e);
    const Sign f = sign(cotangency(l, r, s, e));
    const auto [start, end] = EdgeTriples<DoubleBall>::of(q, {l, r, s, e});
    const bool legal = incircle(start, e, q.e == container_id, f) == Sign::positive &&
                       incircle(end, s, q.s == container_id, f) == Sign::positive;
    return legal ? std::optional(2) : std::nullopt;
  }
  // The vertices turn once; each direction is computed once.
  std::optional<int> prove_cell(GenId g) const {
    const auto at = [this](GenId i) { return predicates_.rough(i); };
    const OwnRoot root;
    const HalfEdge first = diagram_.anchor(g);
    const auto vertex = [&](HalfEdge h) {
      return direction(at, root, g, diagram_.dest(h), diagram_.apex(h));
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
  static Sign tangency_sign(GenId a, GenId b) {
    return a == container_id || b == container_id ? Sign::negative : Sign::positive;
  }

  // Two generators, neither of which lies in the other nor is a point of its boundary.
  void require_tangency(GenId a, GenId b) {
    const Sign s = decide([&](auto at, auto) { return sign(tangency(at(a), at(b))); });
    if (s == tangency_sign(a, b)) return;
    throw Undecided(s == Sign::zero ? "a point touches another generator: its cell has no area"
                                    : "a generator lies inside another",
                    std::min(a, b), std::max(a, b));
  }

  std::optional<InitialFault> vertex_fault(HalfEdge h) {
    if (!is_named_by(h)) return std::nullopt;
    const GenId a = diagram_.org(h), b = diagram_.dest(h), c = diagram_.apex(h);
    const Sign s = decide([&](auto at, auto) { return circle_exists(triple_at(at, a, b, c)); });
    if (s == Sign::positive) return std::nullopt;
    const Triple v = canonical(Triple{a, b, c});
    return InitialFault{"no circle touches the generators of vertex " + text_of(v) +
                            " counterclockwise in this order",
                        {},
                        v,
                        {},
                        {}};
  }

  std::optional<InitialFault> edge_fault(const Quad& q) {
    if (q.s == q.e) return std::nullopt;
    const auto side = [&](bool at_start) {
      return decide([&](auto at, auto) {
        const auto l = at(q.l), r = at(q.r), s = at(q.s), e = at(q.e);
        const EdgeSigns signs = edge_signs(q, l, r, s, e, sign(cotangency(l, r, s, e)));
        return at_start ? signs.end_in_start : signs.start_in_end;
      });
    };
    const Sign start = side(true), end = side(false);
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
    // Cotangent at t: legal just after?
    const Moment now = Moment::at(t_);
    CollapseSearch search(motion_, counts_);
    if (search.from(q, now, now.hi).kind != Collapse::Kind::now) return std::nullopt;
    return InitialFault{"the four generators of edge " + text_of(q) +
                            " are cotangent and the edge is not legal just after",
                        q,
                        {},
                        {},
                        {}};
  }

  // The vertices around g must turn exactly once: among the steps from each to the next exactly
  // one falls back in angle.
  std::optional<InitialFault> cell_fault(GenId g) {
    int falls = 0;
    bool turns = false;
    for (const HalfEdge h : diagram_.ring(g)) {
      const HalfEdge next = diagram_.rotate(h);
      const GenId a = diagram_.dest(h), b = diagram_.apex(h), c = diagram_.apex(next);
      const Sign step = decide([&](auto at, auto root) {
        const auto d = direction(at, root, g, a, b), e = direction(at, root, g, b, c);
        // Around the container the vertices run clockwise.
        return g == container_id ? angle_order(e, d) : angle_order(d, e);
      });
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
  Motion& motion_;
  Rational t_;
  TierCounts& counts_;
  int threads_;
  InstantPredicates predicates_;
};

}  // namespace

std::optional<InitialFault> initial_fault(const Diagram& diagram, Motion& motion, const Rational& t,
                                          TierCounts& counts, int threads) {
  return InitialProof(diagram, motion, t, counts, threads).fault();
}

}  // namespace voroproof::internal
