#include "engine/world/touch.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "engine/world/cell_exit.h"
#include "engine/world/moving_edge.h"
#include "filtered/motion/options.h"

namespace voroproof::internal {
namespace {

using HalfEdge = Diagram::HalfEdge;

// The changes of a diagram, made on a copy.
class Trial {
 public:
  Trial(const MovingRows& rows, const Diagram& diagram, GenId g, GenId j, const WorldTime& t)
      : rows_(rows), before_(diagram), now_(diagram), g_(g), j_(j), t_(t) {}

  std::vector<HalfEdge> flips() {
    for (;;) {
      const std::optional<HalfEdge> h = edge_without_length(now_, g_, j_);
      if (!h) throw Undecided("a disk touches another from inside and has a cell then", g_, j_);
      if (*h < 0) break;
      flip(*h);
    }
    move();
    legalize();
    return is_same() ? std::vector<HalfEdge>() : std::move(flips_);
  }

 private:
  void flip(HalfEdge h) {
    now_.flip(h);
    flips_.push_back(h);
    const HalfEdge t = Diagram::twin(h);
    for (const HalfEdge k : {h, now_.next(h), now_.previous(h), now_.next(t), now_.previous(t)}) {
      touched_.insert(k / 2);
    }
  }

  // Around a cell, the first half-edge that is wanted, and how many turns lead to it.
  template <class IsWanted>
  std::pair<HalfEdge, int> turn_to(const Diagram& diagram, HalfEdge from,
                                   const IsWanted& is_wanted) const {
    int turns = 0;
    HalfEdge h = from;
    for (; !is_wanted(h); h = diagram.rotate(h)) {
      if (++turns > diagram.edges())
        throw Undecided("a disk that touches another from inside is not beside it", g_, j_);
    }
    return {h, turns};
  }

  // The cell, of two edges, passes vertices of that of j up to where it belongs. Both ways around
  // lead there, but the ray meets only the vertices of one at the instant: on the other an edge
  // with a length would flip.
  void move() {
    Diagram without = now_;
    HalfEdge here = 2 * without.remove(g_).front();
    if (without.org(here) != j_) here = Diagram::twin(here);
    const HalfEdge there = cell_exit(rows_, without, j_, g_, t_);
    const auto is = [](HalfEdge wanted) { return [wanted](HalfEdge h) { return h == wanted; }; };
    const int left = turn_to(without, here, is(there)).second,
              right = turn_to(without, there, is(here)).second;
    const bool left_first = left <= right;
    if (pass(left_first, std::min(left, right)) || pass(!left_first, std::max(left, right))) return;
    throw Undecided("a disk that touches another from inside does not pass to where it belongs", g_,
                    j_);
  }

  // Passes vertices on the left or the right. Nothing is done, and the answer is no, where an edge
  // that would flip certainly has a length.
  bool pass(bool on_left, int vertices) {
    const Trial before = *this;
    for (int k = 0; k < vertices; ++k) {
      const HalfEdge to_g =
          turn_to(now_, now_.anchor(j_), [&](HalfEdge h) { return now_.dest(h) == g_; }).first;
      const HalfEdge to_other = now_.rotate(Diagram::twin(to_g));
      const HalfEdge first = on_left ? now_.rotate(to_g) : now_.next(Diagram::twin(to_g));
      if (!MovingEdge(rows_, now_.quad(first)).may_be_point_at(t_)) {
        now_ = before.now_;
        flips_ = before.flips_;
        touched_ = before.touched_;
        return false;
      }
      flip(first);
      flip(to_other);
    }
    return true;
  }

  void legalize() {
    for (;;) {
      std::optional<std::pair<Quad, HalfEdge>> smallest;
      for (const int edge : touched_) {
        const HalfEdge h = 2 * edge;
        const Quad q = now_.quad(h);
        const std::pair named{canonical(q), h};
        if (q.s == q.e || (smallest && *smallest < named)) continue;
        if (MovingEdge(rows_, q).collapses_at(t_)) smallest = named;
      }
      if (!smallest) return;
      if (flips_.size() > 64 + touched_.size() * touched_.size())
        throw Undecided("the flips after a touch do not end", g_, j_);
      flip(smallest->second);
    }
  }

  // Whether the edges are those of before, perhaps by other numbers.
  bool is_same() const {
    std::set<Quad> before, now;
    for (const int edge : touched_) {
      before.insert(canonical(before_.quad(2 * edge)));
      now.insert(canonical(now_.quad(2 * edge)));
    }
    return before == now;
  }

  const MovingRows& rows_;
  const Diagram& before_;
  Diagram now_;
  GenId g_, j_;
  const WorldTime& t_;
  std::vector<HalfEdge> flips_;
  std::set<int> touched_;
};

}  // namespace

std::optional<HalfEdge> edge_without_length(const Diagram& diagram, GenId g, GenId j) {
  std::optional<std::pair<Quad, HalfEdge>> smallest;
  int edges = 0;
  for (const HalfEdge h : diagram.ring(g)) {
    ++edges;
    const Quad q = diagram.quad(h);
    if (q.r == j || q.s == q.e) continue;
    const std::pair named{canonical(q), h};
    if (!smallest || named < *smallest) smallest = named;
  }
  if (edges <= 2) return -1;
  return smallest ? std::optional(smallest->second) : std::nullopt;
}

std::vector<HalfEdge> flips_after_touch(const MovingRows& rows, const Diagram& diagram, GenId g,
                                        GenId j, const WorldTime& t) {
  return Trial(rows, diagram, g, j, t).flips();
}

}  // namespace voroproof::internal
