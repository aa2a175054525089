#include "apps/answers/query_instant.h"

#include <algorithm>
#include <utility>

#include "library/queries/free_space.h"
#include "library/queries/nearest.h"

namespace voroproof::internal {
namespace {

using Rows = std::vector<std::vector<std::string>>;

OrderedJson head(const std::string& name, const InstantQuery& query) {
  OrderedJson json = answer_head(name, query.scene);
  json["t"] = json_of(query.t);
  return json;
}

Clearance clearance_of(const InstantQuery& query, const Rational& probe, TierCounts& counts) {
  return Clearance(query.moment.motion, query.t, query.moment.diagram, probe, counts);
}

OrderedJson json_of(const ClosestPairs& closest) {
  OrderedJson json = OrderedJson::object();
  json["pairs"] = OrderedJson::array();
  for (const auto& [i, j] : closest.pairs) json["pairs"].push_back(OrderedJson::array({i, j}));
  if (!closest.pairs.empty()) json["gap"] = json_of(closest.gap);
  return json;
}

OrderedJson json_of(const FreeSpace& space, const std::optional<OffsetPoint>& point) {
  const auto at = space.position(*point);
  return {{"edge", OrderedJson::array({point->i, point->j})},
          {"side", point->side},
          {"x", voroproof::internal::json_of(at[0])},
          {"y", voroproof::internal::json_of(at[1])}};
}

}  // namespace

Answer answer_nearest(const InstantQuery& query, const Point2& point, std::size_t count) {
  TierCounts counts;
  Answer answer{head("nearest", query), {}};
  answer.json["point"] = OrderedJson::array({json_of(point.x), json_of(point.y)});
  OrderedJson& disks = answer.json["disks"] = OrderedJson::array();
  Rows rows{{"disk", "distance"}};
  for (const NearDisk& near : nearest_disks(query.moment.motion, query.t, point, count, counts)) {
    disks.push_back(
        {{"disk", near.disk}, {"distance", json_of(near.distance)}, {"tied", near.tied}});
    rows.push_back({text_of(near.disk), short_text(near.distance) + (near.tied ? " (tied)" : "")});
  }
  answer.table = table_of(rows);
  return answer;
}

Answer answer_neighbours(const InstantQuery& query, GenId disk) {
  TierCounts counts;
  Clearance clearance = clearance_of(query, 0, counts);
  Answer answer{head("neighbours", query), {}};
  answer.json["disk"] = disk;
  OrderedJson& all = answer.json["neighbours"] = OrderedJson::array();
  Rows rows{{"neighbour", "edges", "gap"}};
  for (const Neighbour& n : neighbours(clearance, disk)) {
    all.push_back({{"generator", n.generator}, {"edges", n.edges}, {"gap", json_of(n.gap)}});
    rows.push_back({text_of(n.generator), std::to_string(n.edges), short_text(n.gap)});
  }
  answer.table = table_of(rows);
  return answer;
}

Answer answer_closest(const InstantQuery& query) {
  TierCounts counts;
  Clearance clearance = clearance_of(query, 0, counts);
  Answer answer{head("closest", query), {}};
  Rows rows{{"among", "pair", "gap"}};
  const auto add = [&](const char* name, const ClosestPairs& closest) {
    answer.json[name] = json_of(closest);
    for (const auto& [i, j] : closest.pairs) {
      rows.push_back({name, text_of(i) + " " + text_of(j), short_text(closest.gap)});
    }
  };
  add("generators", closest_generators(clearance));
  add("disks", closest_disks(clearance));
  answer.table = table_of(rows);
  return answer;
}

Answer answer_offset(const InstantQuery& query, const Rational& probe) {
  TierCounts counts;
  Clearance clearance = clearance_of(query, probe, counts);
  const FreeSpace space(clearance);
  Answer answer{head("offset", query), {}};
  answer.json["probe"] = json_of(probe);
  OrderedJson& arcs = answer.json["arcs"] = OrderedJson::array();
  Rows rows{{"around", "from", "to"}};
  const auto name = [](const std::optional<OffsetPoint>& p) {
    return p ? "edge " + text_of(p->i) + " " + text_of(p->j) : std::string("all around");
  };
  for (const OffsetArc& arc : space.offset()) {
    OrderedJson json = {{"generator", arc.generator}};
    if (arc.from) {
      json["from"] = json_of(space, arc.from);
      json["to"] = json_of(space, arc.to);
    }
    arcs.push_back(std::move(json));
    rows.push_back({text_of(arc.generator), name(arc.from), name(arc.to)});
  }
  answer.table = table_of(rows);
  return answer;
}

Answer answer_voids(const InstantQuery& query, const Rational& probe) {
  TierCounts counts;
  Clearance clearance = clearance_of(query, probe, counts);
  FreeSpace space(clearance);
  const auto edges = edges_by_name(query.moment.diagram);
  Answer answer{head("voids", query), {}};
  answer.json["probe"] = json_of(probe);
  OrderedJson& voids = answer.json["voids"] = OrderedJson::array();
  Rows rows{{"void", "vertices", "tunnels", "vanishes beyond", "at"}};
  for (const Void& v : space.voids()) {
    OrderedJson json = {{"vertices", OrderedJson::array()}, {"tunnels", OrderedJson::array()}};
    for (const Triple& vertex : v.vertices) json["vertices"].push_back(json_of(vertex));
    for (const Quad& quad : v.tunnels) {
      const ClearanceNode node = narrowest(clearance, edges.at(quad));
      json["tunnels"].push_back({{"edge", json_of(quad)},
                                 {"closes", json_of(clearance.value(node))},
                                 {"at", json_of(node)}});
    }
    const Enclosure widest =
        v.widest ? clearance.value(*v.widest) : enclosure(query.scene.container_radius);
    json["vanishes"] = json_of(widest);
    if (v.widest) json["at"] = json_of(*v.widest);
    rows.push_back({std::to_string(voids.size()), std::to_string(v.vertices.size()),
                    std::to_string(v.tunnels.size()), short_text(widest),
                    v.widest ? short_text(*v.widest) : "centre"});
    voids.push_back(std::move(json));
  }
  answer.table = table_of(rows);
  return answer;
}

Answer answer_critical(const InstantQuery& query) {
  TierCounts counts;
  Clearance clearance = clearance_of(query, 0, counts);
  Answer answer{head("critical", query), {}};
  OrderedJson& tunnels = answer.json["tunnels"] = OrderedJson::array();
  // The rows of the table, each with its radius, by which they are ordered.
  std::vector<std::pair<double, std::vector<std::string>>> rows;
  for (const auto& [quad, h] : edges_by_name(query.moment.diagram)) {
    const ClearanceNode node = narrowest(clearance, h);
    const Enclosure radius = clearance.value(node);
    tunnels.push_back(
        {{"edge", json_of(quad)}, {"closes", json_of(radius)}, {"at", json_of(node)}});
    rows.push_back(
        {radius.lo, {short_text(radius), "tunnel " + text_of(quad) + " closes", short_text(node)}});
  }
  OrderedJson& voids = answer.json["voids"] = OrderedJson::array();
  for (const ClearanceNode& node : widest_places(clearance)) {
    const Enclosure radius = clearance.value(node);
    voids.push_back({{"vanishes", json_of(radius)}, {"at", json_of(node)}});
    rows.push_back({radius.lo, {short_text(radius), "a void vanishes", short_text(node)}});
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  Rows table{{"radius", "what happens there", "at"}};
  for (auto& row : rows) table.push_back(std::move(row.second));
  answer.table = table_of(table);
  return answer;
}

}  // namespace voroproof::internal
