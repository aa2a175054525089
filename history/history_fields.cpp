#include "history/history_fields.h"

#include <algorithm>
#include <array>

namespace voroproof::internal {

int read_id(JsonReader& json, int lowest, int last_id) {
  return static_cast<int>(json.integer(lowest, last_id));
}

Quad read_edge(JsonReader& json, int last_id) {
  std::array<int, 4> ids{};
  json.array_of<4>([&](std::size_t i) { ids[i] = read_id(json, container_id, last_id); });
  const Quad edge{ids[0], ids[1], ids[2], ids[3]};
  if (!names_an_edge(edge)) json.fail("names no edge: its generators are not distinct");
  return edge;
}

Number read_time(JsonReader& json) {
  Number t = json.number();
  if (t.exact ? *t.exact < 0 : t.nearest < 0) json.fail("negative");
  return t;
}

void read_end_time(JsonReader& json, const Rational& horizon) {
  const Number t = read_time(json);
  // A producer may have rounded an exact horizon to write it here.
  if (t.value() != horizon && t.nearest != round_nearest(horizon)) json.fail("not the horizon");
}

std::string read_scene_sha256(JsonReader& json, const std::string& wanted) {
  std::string hash(json.text());
  for (char& c : hash)
    if (c >= 'A' && c <= 'F') c = static_cast<char>(c - 'A' + 'a');
  if (hash.size() != 64 || hash.find_first_not_of("0123456789abcdef") != std::string::npos)
    json.fail("not 64 hexadecimal digits");
  // The hash is checked before the ids, which would be those of another scene.
  if (!wanted.empty() && hash != wanted) json.fail("the history is one of another scene");
  return hash;
}

std::vector<Quad> read_initial(JsonReader& json, int last_id) {
  std::vector<Quad> edges;
  json.array([&](std::size_t) { edges.push_back(canonical(read_edge(json, last_id))); });
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end())
    json.fail("names an edge twice");
  return edges;
}

}  // namespace voroproof::internal
