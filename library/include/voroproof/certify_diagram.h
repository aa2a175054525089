// The certifier of diagrams at rest, whoever made them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "voroproof/certify.h"
#include "voroproof/export.h"
#include "voroproof/static_diagram.h"

namespace voroproof {

// A program's words about a diagram of disks: any part of it, each as in StaticDiagram.
struct DiagramClaim {
  std::vector<Circle> disks;
  std::optional<Circle> frame;
  std::optional<std::vector<int>> hosts;
  // All edges; or only the pairs of generators whose cells have an edge in common. Pairs with
  // `container` may all be left out, and so may those with walls.
  std::optional<std::vector<Edge>> edges;
  std::optional<std::vector<std::array<int, 2>>> neighbours;
  // Circles of vertices, with edges those of all.
  std::optional<std::vector<Vertex>> vertices;
  std::optional<Box> walls{};  // without a frame
};

struct DiagramReport {
  Verdict verdict = Verdict::undecided;
  // In the words of the program: what was judged; and each reservation, a line.
  std::string about;
  std::vector<std::string> reservations;
  std::string reason;  // in one line, why it is not certified: the evidence
};

// Proves the claim or refutes it. Edges are judged by exact predicates one by one, whatever made
// them; edges without length, in whose place others are as right, may be any of these. Neighbours
// are compared with proved edges. Centres and radii of vertices may be off by `tolerance` times the
// largest number of the true circle and its three generators. Throws std::invalid_argument as
// StaticDiagram does, for a claim that says nothing or that does not fit its disks (a disk that
// does not exist, hosts of another number), for a tolerance that is not within 0 to 1, and for
// threads that are not 1 to 1024.
VOROPROOF_API DiagramReport certify_diagram(const DiagramClaim& claim, double tolerance = 1e-9,
                                            int threads = 1);

}  // namespace voroproof
