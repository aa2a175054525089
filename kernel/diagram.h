// The diagram as incidences: edges by quadruplets, each vertex with its three edges.
#pragma once

#include <array>
#include <unordered_map>
#include <vector>

#include "kernel/files.h"

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
  // All edges that have the disk among their four generators.
  std::vector<int> about(int disk) const;
  bool adjacent(int i, int j) const;
  // Throws Stop (refuted) where no diagram has the vertices that the flip makes.
  void flip(int k);

 private:
  using Key = std::uint64_t;
  static Key key(int& i, int& j, int& k);  // turns the smallest to the front
  int edge_at(int i, int j, int k, int a, int b) const;
  void join(int i, int j, int k, std::array<int, 3> edges);

  std::vector<Quad> edges_;
  std::unordered_map<Key, std::array<int, 3>> vertices_;  // of [i,j,k]: edges ij, jk, ki
  std::vector<std::vector<int>> spokes_;
};

}  // namespace voroproof_kernel
