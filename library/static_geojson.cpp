// The cells of a diagram of disks at rest, for maps.
#include <stdexcept>

#include "history/json_text.h"
#include "voroproof/static_diagram.h"

namespace voroproof {
namespace internal {
namespace {

using Ring = std::vector<Vector>;

std::string ring_text(const Ring& ring) {
  std::string text = "[[";
  const auto append = [&text](const Vector& p) {
    text += "[" + number_text(p[0]) + "," + number_text(p[1]) + "]";
  };
  for (const Vector& p : ring) {
    append(p);
    text += ",";
  }
  append(ring.front());
  return text + "]]";
}

std::string geometry_text(const std::vector<Ring>& cell) {
  if (cell.empty()) return "null";
  if (cell.size() == 1) {
    return "{\"type\":\"Polygon\",\"coordinates\":" + ring_text(cell[0]) + "}";
  }
  std::string text = "{\"type\":\"MultiPolygon\",\"coordinates\":[";
  for (const Ring& ring : cell) text += (&ring == cell.data() ? "" : ",") + ring_text(ring);
  return text + "]}";
}

}  // namespace
}  // namespace internal

std::string StaticDiagram::geojson(const Box& box, double tolerance,
                                   const std::vector<Column>& columns) const {
  using internal::number_text, internal::string_text;
  for (const auto& [name, values] : columns) {
    if (values.size() != disks_.size()) {
      throw std::invalid_argument("column " + name + ": not one value for each disk");
    }
  }
  const auto all = cells(box, tolerance);
  std::string text = "{\"type\":\"FeatureCollection\",\"features\":[";
  for (std::size_t k = 0; k < disks_.size(); ++k) {
    const auto& [center, radius] = disks_[k];
    text += k == 0 ? "\n" : ",\n";
    text += "{\"type\":\"Feature\",\"geometry\":" + internal::geometry_text(all[k]) +
            ",\"properties\":{\"disk\":" + std::to_string(k) + ",\"x\":" + number_text(center[0]) +
            ",\"y\":" + number_text(center[1]) + ",\"radius\":" + number_text(radius);
    if (hosts_[k] != visible) text += ",\"hidden_by\":" + std::to_string(hosts_[k]);
    for (const auto& [name, values] : columns) {
      text += "," + string_text(name) + ":" + string_text(values[k]);
    }
    text += "}}";
  }
  return text + "\n]}\n";
}

}  // namespace voroproof
