#include "apps/answers/query_answer.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

#include "history/json_text.h"
#include "history/output_file.h"

namespace voroproof::internal {
namespace {

std::string file_text(const OrderedJson& json) {
  // One line for each member, and for each element of a list of objects.
  std::string text = "{";
  const char* separator = "";
  for (const auto& [name, value] : json.items()) {
    text += separator + OrderedJson(name).dump() + ":";
    separator = ",\n";
    if (value.is_array() && !value.empty() && value.front().is_structured()) {
      const char* comma = "[\n";
      for (const OrderedJson& element : value) {
        text += comma + element.dump();
        comma = ",\n";
      }
      text += "]";
    } else {
      text += value.dump();
    }
  }
  return text + "}\n";
}

}  // namespace

OrderedJson answer_head(const std::string& query, const Scene& scene) {
  return {{"format", "voroproof-answer"},
          {"version", 1},
          {"query", query},
          {"scene_sha256", scene.sha256}};
}

OrderedJson json_of(double x) { return OrderedJson::parse(number_text(x)); }
OrderedJson json_of(const Rational& q) { return OrderedJson::parse(number_text(q)); }
OrderedJson json_of(const Enclosure& e) {
  return OrderedJson::array({json_of(e.lo), json_of(e.hi)});
}
OrderedJson json_of(const Quad& q) { return OrderedJson::array({q.l, q.r, q.s, q.e}); }
OrderedJson json_of(const Triple& v) { return OrderedJson::array({v[0], v[1], v[2]}); }

OrderedJson json_of(const ClearanceNode& node) {
  switch (node.kind) {
    case ClearanceNode::Kind::gate:
      return {{"gate", OrderedJson::array({node.generators[0], node.generators[1]})}};
    case ClearanceNode::Kind::far:
      return {{"far", node.generators[0]}};
    case ClearanceNode::Kind::vertex:
      break;
  }
  return {{"vertex", json_of(node.generators)}};
}

std::string short_text(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", x);
  return text;
}

std::string short_text(const Enclosure& e) {
  // An enclosure of a vanishing number is not about 1e-60.
  if (e.lo <= 0 && e.hi >= 0) return "0";
  return short_text(0.5 * e.lo + 0.5 * e.hi);
}

std::string short_text(const ClearanceNode& node) {
  switch (node.kind) {
    case ClearanceNode::Kind::gate:
      return "gate " + text_of(node.generators[0]) + " " + text_of(node.generators[1]);
    case ClearanceNode::Kind::far:
      return "far from " + text_of(node.generators[0]);
    case ClearanceNode::Kind::vertex:
      break;
  }
  return "vertex " + text_of(node.generators);
}

std::string text_of(GenId g) { return g == container_id ? "wall" : std::to_string(g); }

std::string table_of(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      line += row[k];
      if (k + 1 < row.size()) line += std::string(widths[k] - row[k].size() + 2, ' ');
    }
    text += line + '\n';
  }
  return text;
}

void give(const Answer& answer, const std::string& path, std::ostream& out) {
  if (!path.empty()) write_output(path, file_text(answer.json));
  out << answer.table;
}

}  // namespace voroproof::internal
