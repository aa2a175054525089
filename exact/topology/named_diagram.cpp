#include "exact/topology/named_diagram.h"

#include <cstdint>
#include <stdexcept>
#include <utility>

#include "exact/names.h"

namespace voroproof::internal {

std::size_t NamedDiagram::TripleHash::operator()(const Triple& v) const {
  std::uint64_t hash = 0;
  for (const GenId id : v) {
    hash = (hash ^ static_cast<std::uint32_t>(id)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return static_cast<std::size_t>(hash);
}

NamedDiagram::NamedDiagram(Diagram diagram) : diagram_(std::move(diagram)) {
  corners_.reserve(2 * static_cast<std::size_t>(diagram_.edges()));
  for (Diagram::HalfEdge h = 0; h < 2 * diagram_.edges(); ++h) corners_.emplace(corner(h), h);
}

Diagram::HalfEdge NamedDiagram::find(const Quad& q) const {
  const auto found = corners_.find({q.l, q.r, q.e});
  return found == corners_.end() || diagram_.quad(found->second) != q ? -1 : found->second;
}

Diagram::HalfEdge NamedDiagram::flip(const Quad& q) {
  const Diagram::HalfEdge h = find(q);
  if (h < 0) {
    throw std::invalid_argument("the diagram has no edge " + text_of(q) + " at this time");
  }
  if (q.s == q.e) {
    throw std::invalid_argument("the edge " + text_of(q) + " cannot flip: its ends are the " +
                                "two vertices of three generators");
  }
  for (const Diagram::HalfEdge side : sides(h)) corners_.erase(corner(side));
  diagram_.flip(h);
  for (const Diagram::HalfEdge side : sides(h)) {
    if (!corners_.emplace(corner(side), side).second) {
      throw std::invalid_argument("the flip of " + text_of(q) +
                                  " makes a second vertex of one name");
    }
  }
  return h;
}

std::array<Diagram::HalfEdge, 6> NamedDiagram::sides(Diagram::HalfEdge h) const {
  const Diagram::HalfEdge t = Diagram::twin(h);
  return {h, diagram_.next(h), diagram_.previous(h), t, diagram_.next(t), diagram_.previous(t)};
}

}  // namespace voroproof::internal
