#include "voroproof/queries.h"

#include <map>
#include <stdexcept>

#include "library/queries/free_space.h"
#include "library/queries/nearest.h"
#include "library/true_moment.h"
#include "library/values.h"

namespace voroproof {

namespace internal {

voroproof::ClearancePlace place_value(const ClearanceNode& node) {
  using Kind = voroproof::ClearancePlace::Kind;
  const auto& g = node.generators;
  switch (node.kind) {
    case ClearanceNode::Kind::gate:
      return {Kind::gate, {g[0], g[1]}};
    case ClearanceNode::Kind::far:
      return {Kind::far, {g[0], g[1]}};
    case ClearanceNode::Kind::vertex:
      break;
  }
  return {Kind::vertex, {g.begin(), g.end()}};
}

namespace {

voroproof::Tunnel tunnel_value(Clearance& clearance, const Quad& edge, Diagram::HalfEdge h) {
  const ClearanceNode node = narrowest(clearance, h);
  return {edge_value(edge), enclosure_value(clearance.value(node)), place_value(node)};
}

std::optional<voroproof::OffsetPoint> point_value(const FreeSpace& space,
                                                  const std::optional<OffsetPoint>& point) {
  if (!point) return std::nullopt;
  const auto at = space.position(*point);
  return voroproof::OffsetPoint{point->i, point->j, point->side, enclosure_value(at[0]),
                                enclosure_value(at[1])};
}

}  // namespace
}  // namespace internal

struct Instant::Implementation {
  internal::Rational t;
  internal::Rational container_radius;
  internal::TrueMoment moment;
  internal::TierCounts counts{};

  internal::Clearance clearance(const internal::Rational& probe = 0) {
    return internal::Clearance(moment.motion, t, moment.diagram, probe, counts);
  }

  VanishingVoid widest(const internal::Clearance& clearance,
                       const std::optional<internal::ClearanceNode>& node) const {
    if (!node) return {enclosure_value(internal::enclosure(container_radius)), std::nullopt};
    return {enclosure_value(clearance.value(*node)), internal::place_value(*node)};
  }

  Void value_of(internal::Clearance& clearance, const internal::Void& found,
                const std::map<internal::Quad, internal::Diagram::HalfEdge>& edges) const {
    Void out;
    out.vertices = found.vertices;
    for (const internal::Quad& quad : found.tunnels) {
      out.tunnels.push_back(internal::tunnel_value(clearance, quad, edges.at(quad)));
    }
    out.widest = widest(clearance, found.widest);
    return out;
  }
};

namespace {

using internal::enclosure_value;
using internal::with_public_errors;

ClosestPairs value_of(const internal::ClosestPairs& closest) {
  return {closest.pairs, enclosure_value(closest.gap)};
}

}  // namespace

Instant::Instant(const Scene& scene, const Number& t, int max_bits) {
  with_public_errors([&] {
    const internal::Rational at = internal::instant(t);
    const internal::Scene checked = internal::checked_scene(scene);
    implementation_ = std::make_unique<Implementation>(
        Implementation{at, checked.container_radius,
                       internal::true_moment(checked, {}, at, internal::engine_options(max_bits))});
  });
}
Instant::Instant(Instant&&) noexcept = default;
Instant& Instant::operator=(Instant&&) noexcept = default;
Instant::~Instant() = default;

std::vector<NearDisk> Instant::nearest(const Number& x, const Number& y, std::size_t count) {
  return with_public_errors([&] {
    std::vector<NearDisk> out;
    for (const auto& near : internal::nearest_disks(
             implementation_->moment.motion, implementation_->t,
             {internal::rational(x), internal::rational(y)}, count, implementation_->counts)) {
      out.push_back({near.disk, enclosure_value(near.distance), near.tied});
    }
    return out;
  });
}

std::vector<Neighbour> Instant::neighbours(int disk) {
  if (disk < 0 || disk >= implementation_->moment.motion.size()) {
    throw std::invalid_argument("disk: there is no disk " + std::to_string(disk));
  }
  return with_public_errors([&] {
    internal::Clearance clearance = implementation_->clearance();
    std::vector<Neighbour> out;
    for (const auto& n : internal::neighbours(clearance, disk)) {
      out.push_back({n.generator, n.edges, enclosure_value(n.gap)});
    }
    return out;
  });
}

ClosestPairs Instant::closest_generators() {
  return with_public_errors([&] {
    internal::Clearance clearance = implementation_->clearance();
    return value_of(internal::closest_generators(clearance));
  });
}

ClosestPairs Instant::closest_disks() {
  return with_public_errors([&] {
    internal::Clearance clearance = implementation_->clearance();
    return value_of(internal::closest_disks(clearance));
  });
}

std::vector<OffsetArc> Instant::offset(const Number& probe) {
  return with_public_errors([&] {
    internal::Clearance clearance = implementation_->clearance(internal::probe_radius(probe));
    const internal::FreeSpace space(clearance);
    std::vector<OffsetArc> out;
    for (const internal::OffsetArc& arc : space.offset()) {
      out.push_back({arc.generator, internal::point_value(space, arc.from),
                     internal::point_value(space, arc.to)});
    }
    return out;
  });
}

std::vector<Void> Instant::voids(const Number& probe) {
  return with_public_errors([&] {
    internal::Clearance clearance = implementation_->clearance(internal::probe_radius(probe));
    internal::FreeSpace space(clearance);
    const auto edges = internal::edges_by_name(clearance.diagram());
    std::vector<Void> out;
    for (const internal::Void& found : space.voids()) {
      out.push_back(implementation_->value_of(clearance, found, edges));
    }
    return out;
  });
}

CriticalRadii Instant::critical() {
  return with_public_errors([&] {
    internal::Clearance clearance = implementation_->clearance();
    CriticalRadii out;
    for (const auto& [quad, h] : internal::edges_by_name(clearance.diagram())) {
      out.tunnels.push_back(internal::tunnel_value(clearance, quad, h));
    }
    for (const internal::ClearanceNode& node : internal::widest_places(clearance)) {
      out.voids.push_back(implementation_->widest(clearance, node));
    }
    return out;
  });
}

}  // namespace voroproof
