// Clearance: how far a point is from its nearest generators, the container included. Along the
// Voronoi diagram it is the radius of the largest disk that fits there, the probe.
//
// Along an edge between two disks it falls towards the gate, the middle of the gap between the two,
// and rises behind it. An edge between a disk and the container is an arc of an ellipse with foci
// in the disk's centre and the container's: the clearance is least at the gate and greatest at the
// far end of the same axis. Between its ends and those of these points that lie on it an edge is
// monotone (the paper's section 1: "offset-invariance").
#pragma once

#include <vector>

#include "exact/enclosure.h"
#include "exact/topology/diagram.h"
#include "filtered/search/instant_predicates.h"

namespace voroproof::internal {

// A point of the diagram where the clearance is of interest.
struct ClearanceNode {
  enum class Kind {
    vertex,  // for the generators [i,j,k], canonical
    gate,    // in the middle between disk i and generator j
    far,     // on the edge between disk i and the container, far from the disk
  };
  Kind kind = Kind::vertex;
  Triple generators{};  // for a gate {i, j, j}, for a far point {i, -1, -1}
  auto operator<=>(const ClearanceNode&) const = default;
};

inline ClearanceNode vertex_node(const Triple& v) {
  return {ClearanceNode::Kind::vertex, canonical(v)};
}
ClearanceNode gate_node(GenId a, GenId b);  // one of them a disk
inline ClearanceNode far_node(GenId disk) {
  return {ClearanceNode::Kind::far, {disk, container_id, container_id}};
}

// The ends of an edge of the diagram, start first, and in their order the extremes strictly between
// them.
std::vector<ClearanceNode> edge_profile(InstantPredicates& predicates, const Quad& q);
// The sign of the clearance minus the probe's radius, the constant `probe` of the predicates.
Sign clearance_to_probe(InstantPredicates& predicates, const ClearanceNode& node,
                        std::size_t probe);

// Exact answers about the clearance at one instant.
class Clearance {
 public:
  // The diagram is that of the motion at t; all must outlive this object.
  Clearance(const Motion& motion, const Rational& t, const Diagram& diagram, const Rational& probe,
            TierCounts& counts);

  // The place of the probe's radius among the constants of predicates().
  static constexpr std::size_t probe_constant = 0;

  const Diagram& diagram() const { return diagram_; }
  const Rational& probe() const { return probe_; }
  const Motion& motion() const { return predicates_.motion(); }
  InstantPredicates& predicates() { return predicates_; }

  std::vector<ClearanceNode> profile(Diagram::HalfEdge h) {
    return edge_profile(predicates_, diagram_.quad(h));
  }
  // The profile of the closed edge around a lone disk: gate, far point, gate; or the gate alone
  // where the disk lies in the centre and the clearance is the same everywhere.
  std::vector<ClearanceNode> ring_profile();

  // The sign of the clearance at a minus that at b.
  Sign compare(const ClearanceNode& a, const ClearanceNode& b);
  // The sign of the clearance at the node minus the probe's radius.
  Sign to_probe(const ClearanceNode& node) {
    return clearance_to_probe(predicates_, node, probe_constant);
  }
  Enclosure value(const ClearanceNode& node) const;

 private:
  const Diagram& diagram_;
  Rational probe_;
  InstantPredicates predicates_;
};

}  // namespace voroproof::internal
