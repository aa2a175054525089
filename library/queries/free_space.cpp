#include "library/queries/free_space.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace voroproof::internal {
namespace {

using HalfEdge = Diagram::HalfEdge;

bool fits(Sign s) { return s == Sign::positive || s == Sign::zero; }

template <class Sites, class Root>
auto position_of(Sites& at, Root& root, const OffsetPoint& point) {
  const auto a = at(point.i), b = at(point.j);
  using T = std::decay_t<decltype(a.x)>;
  const bool wall = point.j == container_id;
  const T ux = wall ? T(a.x - b.x) : T(b.x - a.x), uy = wall ? T(a.y - b.y) : T(b.y - a.y);
  const T d2 = ux * ux + uy * uy, d = root(d2);
  const T from_a = a.r + at.constant(Clearance::probe_constant);
  const T from_b = b.r + at.constant(Clearance::probe_constant);  // negative for the container
  // The point lies `along` the axis, and `across`.
  const T difference = d2 + from_a * from_a - from_b * from_b;
  const T sum = from_b * from_b - d2 - from_a * from_a;
  const T along = (wall ? sum : difference) / (d + d);
  const T across2 = from_a * from_a - along * along;
  const T across = root(across2);
  const T side = point.side > 0 ? T(across / d) : T(-across / d);
  return std::array<T, 2>{a.x + ux * (along / d) - uy * side, a.y + uy * (along / d) + ux * side};
}

class Groups {
 public:
  explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::size_t find(std::size_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parent_;
};

// The vertices of a diagram, numbered in the order of their names.
std::map<Triple, std::size_t> numbered_vertices(const Diagram& diagram) {
  std::map<Triple, std::size_t> vertices;
  for (HalfEdge h = 0; h < 2 * diagram.edges(); ++h) {
    vertices.emplace(end_vertex(diagram.quad(h)), 0);
  }
  std::size_t k = 0;
  for (auto& [name, number] : vertices) number = k++;
  return vertices;
}

FreePiece reversed(FreePiece piece) {
  piece.edge = Diagram::twin(piece.edge);
  std::swap(piece.from, piece.to);
  std::reverse(piece.nodes.begin(), piece.nodes.end());
  return piece;
}

}  // namespace

FreeSpace::FreeSpace(Clearance& clearance) : clearance_(clearance) {
  const Diagram& diagram = clearance.diagram();
  if (diagram.disks() == 0) {
    too_wide_ = clearance.probe() > clearance.motion().input().container_radius;
  } else if (diagram.disks() == 1) {
    pieces_ = pieces_of(-1, clearance.ring_profile());
  }
  for (HalfEdge h = 0; h < 2 * diagram.edges(); h += 2) {
    of_edge_.emplace_back();
    for (FreePiece& piece : pieces_of(h, clearance.profile(h))) {
      of_edge_.back().push_back(pieces_.size());
      pieces_.push_back(std::move(piece));
    }
  }
}

std::vector<FreePiece> FreeSpace::pieces_of(HalfEdge h, const std::vector<ClearanceNode>& nodes) {
  const bool ring = h < 0;
  const Quad q = ring ? Quad{0, container_id, 0, 0} : clearance_.diagram().quad(h);
  const bool left = q.l != container_id;
  // Behind the gate of a base on its left the edge is on the left of the axis, and rises.
  const auto crossing = [&](bool rising) {
    return OffsetPoint{left ? q.l : q.r, left ? q.r : q.l, rising == left ? 1 : -1};
  };
  std::vector<FreePiece> pieces;
  bool open = false;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const bool here = fits(clearance_.to_probe(nodes[k]));
    if (here && !open) {
      pieces.push_back({h, {}, {}, {}});
      if (k > 0) pieces.back().from = crossing(true);
    } else if (!here && open) {
      pieces.back().to = crossing(false);
    }
    if (here) pieces.back().nodes.push_back(nodes[k]);
    open = here;
  }
  return pieces;
}

std::vector<OffsetArc> FreeSpace::offset() const {
  std::vector<OffsetArc> arcs;
  for (GenId g = container_id; g < clearance_.diagram().disks(); ++g) {
    for (OffsetArc& arc : arcs_of(g)) {
      if (g == container_id) std::swap(arc.from, arc.to);  // its edges run clockwise
      arcs.push_back(std::move(arc));
    }
  }
  return arcs;
}

std::vector<OffsetArc> FreeSpace::arcs_of(GenId g) const {
  const Diagram& diagram = clearance_.diagram();
  std::vector<FreePiece> around;
  bool all = true;
  if (diagram.disks() == 0) {
    all = !too_wide_;
  } else if (diagram.disks() == 1) {
    around = pieces_;  // counterclockwise around both
    if (g == container_id) {
      for (FreePiece& piece : around) piece = reversed(std::move(piece));
    }
    // The ring begins and ends at its gate.
    all = !around.empty() && !around.front().from && !around.front().to;
  } else {
    for (const HalfEdge h : diagram.ring(g)) {
      const std::vector<std::size_t>& own = of_edge_[h / 2];
      all = all && own.size() == 1 && !pieces_[own[0]].from && !pieces_[own[0]].to;
      std::vector<FreePiece> pieces;
      for (const std::size_t k : own) {
        pieces.push_back((h & 1) == 0 ? pieces_[k] : reversed(pieces_[k]));
      }
      if ((h & 1) != 0) std::reverse(pieces.begin(), pieces.end());
      around.insert(around.end(), pieces.begin(), pieces.end());
    }
  }
  if (all) return {{g, {}, {}}};
  // Begin where an arc does; a piece without a point at its start continues the one before it.
  const auto begin = std::find_if(around.begin(), around.end(),
                                  [](const FreePiece& piece) { return piece.from.has_value(); });
  std::rotate(around.begin(), begin, around.end());
  std::vector<OffsetArc> arcs;
  for (const FreePiece& piece : around) {
    if (piece.from) arcs.push_back({g, piece.from, {}});
    if (piece.to) arcs.back().to = piece.to;
  }
  return arcs;
}

std::vector<Void> FreeSpace::voids() {
  const Diagram& diagram = clearance_.diagram();
  if (diagram.disks() == 0) {
    if (too_wide_) return {};
    return {Void{}};
  }
  const auto vertices = numbered_vertices(diagram);
  Groups groups(vertices.size() + pieces_.size());
  const auto of_piece = [&](std::size_t k) { return vertices.size() + k; };
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    for (const ClearanceNode& node : pieces_[k].nodes) {
      if (node.kind != ClearanceNode::Kind::vertex) continue;
      groups.join(vertices.at(node.generators), of_piece(k));
    }
  }
  std::map<std::size_t, std::size_t> index;  // by a group's void
  std::vector<Void> voids;
  const auto void_of = [&](std::size_t member) -> Void& {
    const auto [at, fresh] = index.emplace(groups.find(member), voids.size());
    if (fresh) voids.emplace_back();
    return voids[at->second];
  };
  std::vector<bool> is_free(vertices.size(), false);
  for (const FreePiece& piece : pieces_) {
    for (const ClearanceNode& node : piece.nodes) {
      if (node.kind == ClearanceNode::Kind::vertex) is_free[vertices.at(node.generators)] = true;
    }
  }
  for (const auto& [name, number] : vertices) {
    if (is_free[number]) void_of(number).vertices.push_back(name);
  }
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const FreePiece& piece = pieces_[k];
    Void& space = void_of(of_piece(k));
    if (piece.edge >= 0 && !piece.from && !piece.to) {
      space.tunnels.push_back(canonical(diagram.quad(piece.edge)));
    }
    for (const ClearanceNode& node : piece.nodes) {
      if (!space.widest) space.widest = node;
      const Sign wider = clearance_.compare(node, *space.widest);
      if (wider == Sign::positive || (wider == Sign::zero && node < *space.widest)) {
        space.widest = node;
      }
    }
  }
  for (Void& space : voids) std::sort(space.tunnels.begin(), space.tunnels.end());
  return voids;
}

std::array<Enclosure, 2> FreeSpace::position(const OffsetPoint& point) const {
  const std::array<Ball, 2> at = clearance_.predicates().ball(
      [&](auto sites, auto root) { return position_of(sites, root, point); });
  const auto placed = [&](int axis) {
    return enclosure(at[axis] +
                     Ball(clearance_.motion().input().origin[axis], at[axis].precision()));
  };
  return {placed(0), placed(1)};
}

std::map<Quad, Diagram::HalfEdge> edges_by_name(const Diagram& diagram) {
  std::map<Quad, Diagram::HalfEdge> edges;
  for (Diagram::HalfEdge h = 0; h < 2 * diagram.edges(); h += 2) {
    edges[canonical(diagram.quad(h))] = h;
  }
  return edges;
}

ClearanceNode narrowest(Clearance& clearance, HalfEdge h) {
  const std::vector<ClearanceNode> nodes = clearance.profile(h);
  return *std::min_element(nodes.begin(), nodes.end(),
                           [&](const ClearanceNode& a, const ClearanceNode& b) {
                             const Sign s = clearance.compare(a, b);
                             return s == Sign::negative || (s == Sign::zero && a < b);
                           });
}

std::vector<ClearanceNode> widest_places(Clearance& clearance) {
  const Diagram& diagram = clearance.diagram();
  if (diagram.disks() == 0) return {};
  if (diagram.disks() == 1)
    return {clearance.ring_profile().size() == 1 ? gate_node(0, container_id) : far_node(0)};
  const auto vertices = numbered_vertices(diagram);
  Groups plateaus(vertices.size());
  std::vector<bool> left_upwards(vertices.size(), false);
  std::vector<ClearanceNode> places;
  for (HalfEdge h = 0; h < 2 * diagram.edges(); h += 2) {
    const std::vector<ClearanceNode> nodes = clearance.profile(h);
    const auto number = [&](const ClearanceNode& v) { return vertices.at(v.generators); };
    const std::size_t last = nodes.size() - 1;
    if (clearance.compare(nodes[1], nodes[0]) == Sign::positive) {
      left_upwards[number(nodes[0])] = true;
    }
    if (clearance.compare(nodes[last - 1], nodes[last]) == Sign::positive) {
      left_upwards[number(nodes[last])] = true;
    }
    if (last == 1 && clearance.compare(nodes[0], nodes[1]) == Sign::zero) {
      plateaus.join(number(nodes[0]), number(nodes[1]));
    }
    for (const ClearanceNode& node : nodes) {
      if (node.kind == ClearanceNode::Kind::far) places.push_back(node);
    }
  }
  std::vector<bool> taken(vertices.size(), false);  // by plateau: is no place, or is one already
  for (const auto& [name, k] : vertices) {
    if (left_upwards[k]) taken[plateaus.find(k)] = true;
  }
  for (const auto& [name, k] : vertices) {
    if (taken[plateaus.find(k)]) continue;
    taken[plateaus.find(k)] = true;
    places.push_back(vertex_node(name));
  }
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace voroproof::internal
