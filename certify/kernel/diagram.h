// The diagram as incidences: what is next to what.
#pragma once

#include <unordered_map>

#include "certify/kernel/files.h"

namespace voroproof_kernel {

class Diagram {
 public:
  // Throws Stop (refuted) where the edges are not those of a triangulation of the sphere by n disks
  // and the container.
  Diagram(const std::vector<Quad>& edges, int n);

  const std::vector<Quad>& edges() const { return edges_; }
  const std::vector<int>& spokes(int g) const { return spokes_[g + 1]; }
  // The edge of this name, which may be read either way, or -1.
  int find(const Quad& quad) const;
  // The edges that meet edge k: between l and s, s and r, r and e, e and l.
  std::array<int, 4> around(int k) const;
  // The edge after k counterclockwise around g, one of its two.
  int next_spoke(int k, int g) const;
  bool adjacent(int i, int j) const;
  // Throws Stop (refuted) where no diagram has the vertices that the flip makes.
  void flip(int k);

 private:
  static std::uint64_t key(int a, int b, int c);
  int side(int a, int b, int c) const;      // the edge between a and b at vertex [a,b,c], or -1
  void put(int a, int b, int c, int edge);  // makes it that

  std::vector<Quad> edges_;
  std::unordered_map<std::uint64_t, int> sides_;
  std::vector<std::vector<int>> spokes_;
};

}  // namespace voroproof_kernel
