// The combinatorial Voronoi diagram, kept as its dual: a triangulation of the
// sphere with the generators as vertices. Cells with two edges and pairs of
// generators that share several edges are ordinary here: only incidences count.
//
// Notation. V-edge e owns the half-edges 2e and 2e+1. Half-edge h runs in the dual
// from generator org(h) to dest(h) and has a triangle (a V-vertex) on its left, whose
// third generator is apex(h); the triangle's generators org(h), dest(h), apex(h) are
// the V-vertex in counterclockwise order. As a quadruplet, half-edge h is
//   [l, r, s, e] = [org(h), dest(h), apex(twin h), apex(h)],
// the V-edge walked with l on the left from its start vertex [l, s, r] to its end
// vertex [l, r, e] (paper section 4: CDP {l, r}, TDP {s, e}).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "exact/generators.h"

namespace voroproof::internal {

class Diagram {
 public:
  using HalfEdge = std::int32_t;

  // A diagram of `disks` disks and the container, no edges yet.
  explicit Diagram(int disks) : disks_(disks), anchor_(disks + 1, -1) {}

  // The one diagram of two disks a, b and the container: both tangent circles.
  void start(GenId a, GenId b);
  // Splits edge h by a new generator g, whose cell gets two edges: with org(h) and
  // with dest(h). The half-edges returned run org(h) -> dest(h) with g as apex on
  // the side of the old apex(twin h) [first] and of the old apex(h) [second]: the
  // two remaining parts of the old edge.
  std::array<HalfEdge, 2> insert_in_edge(HalfEdge h, GenId g);
  // Puts a new generator g in the place of the V-vertex on the left of h: its cell gets three
  // edges. The half-edges of the triangle stay, with g as their apex.
  void insert_in_vertex(HalfEdge h, GenId g);
  // The inverse of insert_in_edge(): takes out g, whose cell has two edges; nothing is left where
  // these are two of three. Edges of the largest numbers take the places of those that are gone:
  // returned are the numbers of all edges that are another one now, first that of the edge which g
  // divided.
  std::vector<int> remove(GenId g);
  // Exchanges the names of two generators; one of them may have no edges.
  void exchange(GenId a, GenId b);
  // Replaces the edge of h, with quadruplet [l,r,s,e], by [s,e,r,l]; h then runs
  // from s to e. Precondition: s != e.
  void flip(HalfEdge h);

  int disks() const { return disks_; }
  int edges() const { return static_cast<int>(halves_.size() / 2); }
  static HalfEdge twin(HalfEdge h) { return h ^ 1; }
  HalfEdge next(HalfEdge h) const { return previous(previous(h)); }
  HalfEdge previous(HalfEdge h) const { return halves_[h].previous; }
  GenId org(HalfEdge h) const { return halves_[h].org; }
  GenId dest(HalfEdge h) const { return org(h ^ 1); }
  GenId apex(HalfEdge h) const { return org(previous(h)); }
  Quad quad(HalfEdge h) const { return {org(h), dest(h), apex(h ^ 1), apex(h)}; }
  // Some half-edge that starts at g, or -1.
  HalfEdge anchor(GenId g) const { return anchor_[g + 1]; }
  // The next half-edge counterclockwise around org(h).
  HalfEdge rotate(HalfEdge h) const { return previous(h) ^ 1; }

  // The half-edges around a cell: for (const HalfEdge h : diagram.ring(g)).
  class Ring;
  // Those that start at g, counterclockwise from its anchor on; none where g has no edge.
  Ring ring(GenId g) const;

  // The neighbours of g, each once, sorted; none where it has no edge.
  std::vector<GenId> neighbours(GenId g) const;

  // Asks the processor for the memory of a half-edge and its twin.
  void prefetch(HalfEdge h) const { __builtin_prefetch(&halves_[h]); }

  // Whether also the numbers of all half-edges are the same.
  bool operator==(const Diagram&) const = default;
  // Canonical quads of all edges, sorted.
  std::vector<Quad> quads() const;
  // Whether the incidences are those of a triangulation of the sphere by all
  // generators but hidden disks (by disk; none where it is empty): cycles of three, consistent
  // ends, one ring of edges around each generator, connected, Euler's count. On failure `why` (if
  // given) says what is wrong.
  bool is_valid(std::string* why = nullptr, const std::vector<bool>& hidden = {}) const;

 private:
  // Side by side, twins too: a quadruplet is read from three places of memory.
  struct Half {
    GenId org;
    HalfEdge previous;
    bool operator==(const Half&) const = default;
  };

  friend Diagram diagram_of(int disks, const std::vector<Quad>& edges,
                            const std::vector<bool>& hidden);
  friend Diagram numbered_diagram(int disks, const std::vector<GenId>& origins,
                                  const std::vector<HalfEdge>& previous,
                                  const std::vector<HalfEdge>& anchors);
  HalfEdge new_edge(GenId a, GenId b);
  void move_half(HalfEdge from, HalfEdge to);
  void link(HalfEdge a, HalfEdge b, HalfEdge c);

  int disks_;
  std::vector<Half> halves_;
  std::vector<HalfEdge> anchor_;
};

class Diagram::Ring {
 public:
  struct End {};
  class Iterator {
   public:
    Iterator(const Diagram& diagram, HalfEdge first)
        : diagram_(diagram), first_(first), half_(first) {}
    HalfEdge operator*() const { return half_; }
    bool operator!=(End) const { return half_ >= 0; }
    void operator++() {
      half_ = diagram_.rotate(half_);
      if (half_ == first_) half_ = -1;
    }

   private:
    const Diagram& diagram_;
    const HalfEdge first_;
    HalfEdge half_;
  };

  // From this half-edge on; no half-edge where it is -1.
  Ring(const Diagram& diagram, HalfEdge first) : diagram_(diagram), first_(first) {}
  Iterator begin() const { return {diagram_, first_}; }
  End end() const { return {}; }

 private:
  const Diagram& diagram_;
  HalfEdge first_;
};

inline Diagram::Ring Diagram::ring(GenId g) const { return {*this, anchor(g)}; }

// Visits the half-edges from l to r, until `visit` returns true; none in a diagram without edges.
// Precondition: l and r are generators of the diagram, if it has edges.
template <class Visit>
void each_between(const Diagram& diagram, GenId l, GenId r, Visit&& visit) {
  if (diagram.edges() == 0) return;
  // Around a disk: the container has many neighbours.
  const bool wall = l == container_id;
  const GenId other = wall ? l : r;
  for (const Diagram::HalfEdge h : diagram.ring(wall ? r : l)) {
    if (diagram.dest(h) == other && visit(wall ? Diagram::twin(h) : h)) return;
  }
}
// The half-edge of this quadruplet, or -1. Precondition: l and r are generators of the diagram.
Diagram::HalfEdge find_edge(const Diagram& diagram, const Quad& q);

// Rebuilds the incidences from the quads of all edges (as in a history's
// header or a diagram file). Throws std::invalid_argument, with the reason, where
// they are not those of a diagram of `disks` disks without the hidden ones, as is_valid() says.
Diagram diagram_of(int disks, const std::vector<Quad>& edges, const std::vector<bool>& hidden = {});

// The diagram with these half-edges, by their numbers: where each starts and which is before it;
// and these anchors, that of the container first. Throws std::invalid_argument as diagram_of()
// does.
Diagram numbered_diagram(int disks, const std::vector<GenId>& origins,
                         const std::vector<Diagram::HalfEdge>& previous,
                         const std::vector<Diagram::HalfEdge>& anchors);

}  // namespace voroproof::internal
