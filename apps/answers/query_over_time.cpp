#include "apps/answers/query_over_time.h"

#include "library/closest_over.h"

namespace voroproof::internal {
namespace {

using Rows = std::vector<std::vector<std::string>>;

OrderedJson head(const std::string& name, const TimeQuery& query) {
  OrderedJson json = answer_head(name, query.scene);
  json["from"] = json_of(query.window.from);
  json["to"] = json_of(query.window.to);
  return json;
}

Answer with_gap(OrderedJson json, const TimeQuery& query, const LeastGap& least) {
  const Enclosure gap = gap_of(query.paths, least), t = enclosure(least.t);
  json["pair"] = OrderedJson::array({least.i, least.j});
  json["gap"] = json_of(gap);
  json["t"] = json_of(t);
  json["contact"] = least.contact;
  return {std::move(json),
          table_of({{"pair", "least gap", "t"},
                    {text_of(least.i) + " " + text_of(least.j),
                     least.contact ? "0 (contact)" : short_text(gap), short_text(t)}})};
}

Answer with_openings(OrderedJson json, const Rational& probe,
                     const std::vector<Opening>& openings) {
  json["probe"] = json_of(probe);
  OrderedJson& all = json["open"] = OrderedJson::array();
  Rows rows{{"opens", "closes"}};
  for (const Opening& o : openings) {
    all.push_back({{"from", json_of(o.from)}, {"to", json_of(o.to)}});
    rows.push_back({short_text(o.from), short_text(o.to)});
  }
  return {std::move(json), openings.empty() ? "never open\n" : table_of(rows)};
}

}  // namespace

Answer answer_neighbours_over(const TimeQuery& query, GenId disk) {
  Answer answer{head("neighbours-over", query), {}};
  answer.json["disk"] = disk;
  OrderedJson& all = answer.json["neighbours"] = OrderedJson::array();
  Rows rows{{"neighbour", "from", "to"}};
  for (const Neighbourhood& n : neighbours_over(query.history, disk, query.window)) {
    all.push_back({{"generator", n.generator}, {"from", json_of(n.from)}, {"to", json_of(n.to)}});
    rows.push_back(
        {text_of(n.generator), short_text(enclosure(n.from)), short_text(enclosure(n.to))});
  }
  answer.table = table_of(rows);
  return answer;
}

Answer answer_gap_over(const TimeQuery& query, GenId i, GenId j) {
  return with_gap(head("gap-over", query), query, least_gap(query.paths, i, j, query.window));
}

Answer answer_closest_over(const TimeQuery& query) {
  OrderedJson json = head("closest-over", query);
  const auto least = least_gap_of_all(query.paths, query.history, query.window);
  if (!least) return {std::move(json), "no two disks\n"};
  return with_gap(std::move(json), query, *least);
}

Answer answer_tunnel(const TimeQuery& query, GenId i, GenId j, const Rational& probe) {
  OrderedJson json = head("tunnel", query);
  json["pair"] = OrderedJson::array({i, j});
  return with_openings(std::move(json), probe,
                       tunnel_openings(query.paths, query.history, i, j, probe, query.window));
}

Answer answer_void(const TimeQuery& query, const Triple& vertex, const Rational& probe) {
  OrderedJson json = head("void", query);
  json["vertex"] = json_of(canonical(vertex));
  return with_openings(std::move(json), probe,
                       void_openings(query.paths, query.history, vertex, probe, query.window));
}

Answer answer_voids_over(const TimeQuery& query, const Rational& probe) {
  Answer answer{head("voids-over", query), {}};
  answer.json["probe"] = json_of(probe);
  OrderedJson& all = answer.json["voids"] = OrderedJson::array();
  Rows rows{{"void", "from", "to", "out of", "into", "at first at"}};
  const auto list = [](const std::vector<std::size_t>& voids) {
    std::string text;
    for (const std::size_t v : voids) text += (text.empty() ? "" : " ") + std::to_string(v);
    return text.empty() ? "-" : text;
  };
  for (const VoidLife& v : void_lives(query.paths, query.history, probe, query.window)) {
    OrderedJson json = {
        {"from", json_of(v.from)}, {"to", json_of(v.to)}, {"before", v.before}, {"after", v.after}};
    if (v.at) json["at"] = json_of(*v.at);
    rows.push_back({std::to_string(all.size()), short_text(v.from), short_text(v.to),
                    list(v.before), list(v.after), v.at ? short_text(*v.at) : "centre"});
    all.push_back(std::move(json));
  }
  answer.table = table_of(rows);
  return answer;
}

}  // namespace voroproof::internal
