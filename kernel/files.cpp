#include "kernel/files.h"

#include <openssl/sha.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace voroproof_kernel {
namespace {

using Json = nlohmann::json;

// JSON as nlohmann reads it, but refusing what it would let pass: keys that occur twice, nesting
// without end, numbers that are not zero and whose nearest binary64 is.
class StrictReader : public nlohmann::detail::json_sax_dom_parser<Json> {
  using Base = nlohmann::detail::json_sax_dom_parser<Json>;

 public:
  explicit StrictReader(Json& result) : Base(result, false) {}
  bool start_object(std::size_t size) {
    keys_.emplace_back();
    return deeper() && Base::start_object(size);
  }
  bool key(std::string& name) {
    if (!keys_.back().insert(name).second) invalid("the field '" + name + "' occurs twice");
    return Base::key(name);
  }
  bool end_object() {
    keys_.pop_back();
    --depth_;
    return Base::end_object();
  }
  bool start_array(std::size_t size) { return deeper() && Base::start_array(size); }
  bool end_array() {
    --depth_;
    return Base::end_array();
  }
  bool number_float(double x, const std::string& text) {
    if (text.size() > 4096) invalid("a number of more than 4096 characters");
    if (x == 0 && text.find_first_of("123456789") < text.find_first_of("eE")) {
      invalid("beyond the range of binary64");
    }
    return Base::number_float(x, text);
  }

 private:
  bool deeper() {
    if (++depth_ > 16) invalid("nested too deeply");
    return true;
  }
  std::vector<std::set<std::string>> keys_;
  int depth_ = 0;
};

Json parse(const char* begin, const char* end) {
  Json result;
  StrictReader reader(result);
  if (!Json::sax_parse(begin, end, &reader)) invalid("not JSON");
  return result;
}

using Names = std::initializer_list<const char*>;

// That an object has all fields of the first list, and of others only those of the second.
void expect_fields(const Json& object, Names required, Names optional = {}) {
  if (!object.is_object()) invalid("not a JSON object");
  std::size_t known = required.size();
  for (const char* name : required) {
    if (!object.contains(name)) invalid(std::string("the field '") + name + "' is missing");
  }
  for (const char* name : optional) known += object.contains(name);
  if (known != object.size()) invalid("an unknown field");
}

void expect_format(const Json& object, const char* format) {
  if (object["format"] != format || !object["version"].is_number_integer() ||
      object["version"] != 1) {
    invalid("another format or version");
  }
}

Rat number(const Json& json) {
  // nlohmann converts with strtod, which rounds correctly; conversions of integers round to
  // nearest.
  if (json.is_number()) return exactly(json.get<double>());
  if (json.is_string()) return exact_string(json.get_ref<const std::string&>());
  invalid("not a number");
}

Rat scene_number(const Json& json) {
  static const Rat most = exactly(1e100), least = exactly(1e-100);
  const Rat x = number(json);
  if (x != 0 && (abs(x) > most || abs(x) < least)) invalid("a value beyond the limits of a scene");
  return x;
}

Rat history_number(const Json& json) {
  const Rat x = number(json);
  if (json.is_string() && x != 0 && nearest_binary64(x) == 0) {
    invalid("beyond the range of binary64");
  }
  return x;
}

template <class Read>
Vec pair_of(const Json& json, Read read) {
  if (!json.is_array() || json.size() != 2) invalid("not a list of two numbers");
  return {read(json[0]), read(json[1])};
}

std::int64_t whole(const Json& json, std::int64_t least, std::int64_t most) {
  if (!json.is_number_integer() ||
      (json.is_number_unsigned() && json.get<std::uint64_t>() > INT64_MAX)) {
    invalid("not an integer within its limits");
  }
  const auto x = json.get<std::int64_t>();
  if (x < least || x > most) invalid("an integer beyond its limits");
  return x;
}

// Disks lie in the container and do not overlap: by a sweep over their least abscissas.
void check_places(const Scene& scene) {
  const auto& disks = scene.disks;
  Rat widest = 0;
  for (const Disk& d : disks) {
    const Vec n = minus(d.center, scene.center);
    const Rat gap = square(Rat(scene.radius - d.radius)) - norm2(n);
    if (d.radius >= scene.radius || gap < 0) invalid("a disk is not inside the container");
    if (gap == 0 && dot(n, d.velocity) == 0 && norm2(d.velocity) != 0) {
      invalid("a disk touches the container and moves along it");
    }
    if (d.radius > widest) widest = d.radius;
  }
  std::vector<int> order(disks.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<int>(k);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return disks[a].center[0] < disks[b].center[0]; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Disk& a = disks[order[k]];
    for (std::size_t m = k + 1; m < order.size(); ++m) {
      const Disk& b = disks[order[m]];
      if (b.center[0] - a.center[0] > a.radius + widest) break;
      const Rat reach = a.radius + b.radius, d2 = norm2(minus(a.center, b.center));
      if (d2 < square(reach) || d2 == 0) invalid("two disks overlap");
    }
  }
}

std::vector<Quad> edges(const Json& json, int n) {
  if (!json.is_array()) invalid("not a list of edges");
  std::vector<Quad> result;
  for (const Json& q : json) {
    if (!q.is_array() || q.size() != 4) invalid("not an edge");
    int id[4];
    for (int k = 0; k < 4; ++k) id[k] = static_cast<int>(whole(q[k], container, n - 1));
    const Quad quad{id[0], id[1], id[2], id[3]};
    if (quad.l == quad.r || quad.s == quad.l || quad.s == quad.r || quad.e == quad.l ||
        quad.e == quad.r) {
      invalid("a quadruple that names no edge");
    }
    result.push_back(quad);
  }
  return result;
}

// v or p of a collision.
void read_two(const Json& claim, const char* name, bool wall, std::optional<Vec> (&to)[2]) {
  if (!claim.contains(name)) return;
  const Json& two = claim[name];
  if (!two.is_array() || two.size() != 2) invalid("not a list of two");
  if (two[0].is_null() != wall) invalid("null stands for the container, and only for it");
  if (!wall) to[0] = pair_of(two[0], history_number);
  to[1] = pair_of(two[1], history_number);
}

Claim read_claim(const Json& json, int n) {
  Claim claim{};
  if (json.contains("flip")) {
    expect_fields(json, {"t", "flip"});
    claim.kind = Claim::Kind::flip;
    claim.quad = edges(Json::array({json["flip"]}), n)[0];
  } else if (json.contains("collide")) {
    expect_fields(json, {"t", "collide"}, {"v", "p"});
    claim.kind = Claim::Kind::collision;
    const Json& two = json["collide"];
    if (!two.is_array() || two.size() != 2) invalid("not a pair");
    claim.i = static_cast<int>(whole(two[0], container, n - 1));
    claim.j = static_cast<int>(whole(two[1], 0, n - 1));
    if (claim.i >= claim.j) invalid("the smaller id comes first");
    read_two(json, "v", claim.i == container, claim.v);
    read_two(json, "p", claim.i == container, claim.p);
  } else {
    expect_fields(json, {"t", "maneuver"}, {"v", "p"});
    claim.kind = Claim::Kind::maneuver;
    claim.i = claim.j = static_cast<int>(whole(json["maneuver"], 0, n - 1));
    if (json.contains("v")) claim.v[1] = pair_of(json["v"], history_number);
    if (json.contains("p")) claim.p[1] = pair_of(json["p"], history_number);
  }
  claim.t = claim.filed = history_number(json["t"]);
  return claim;
}

// The first line.
void read_header(const Json& json, int n, History& history) {
  expect_fields(json, {"format", "version", "scene_sha256", "horizon", "producer"}, {"initial"});
  expect_format(json, "voroproof-history");
  if (!json["scene_sha256"].is_string() || !json["producer"].is_string()) invalid("not a string");
  history.scene_sha256 = json["scene_sha256"].get<std::string>();
  history.horizon = history_number(json["horizon"]);
  if (history.horizon < 0) invalid("a negative horizon");
  if (json.contains("initial")) history.initial = edges(json["initial"], n);
}

// The last line.
void read_end(const Json& json, History& history) {
  history.stopped = json.contains("stopped");
  const char* kind = history.stopped ? "stopped" : "end";
  expect_fields(json, {kind});
  const Json& end = json[kind];
  if (history.stopped) {
    expect_fields(end, {"t", "reason"}, {"events"});
    const Rat t = history_number(end["t"]);
    if (t < 0 || t > std::max(history.horizon, nearest_binary64(history.horizon)) ||
        !end["reason"].is_string() || (end.contains("events") && !end["events"].is_array())) {
      invalid("a bad last line");
    }
    history.horizon = t;
    return;
  }
  const char* names[] = {"flips", "collisions", "maneuvers"};
  expect_fields(end, {"t", names[0], names[1], names[2]});
  const Rat t = history_number(end["t"]);
  if (t != history.horizon && t != nearest_binary64(history.horizon)) {
    invalid("the last line's t is not the horizon");
  }
  for (int k = 0; k < 3; ++k) history.ended[k] = whole(end[names[k]], 0, INT64_MAX);
}

Disk read_disk(const Json& json, bool alone) {
  expect_fields(json, {"center", "radius", "velocity"}, {"mass"});
  Disk disk{pair_of(json["center"], scene_number), pair_of(json["velocity"], scene_number),
            scene_number(json["radius"]), 0};
  if (disk.radius < 0) invalid("a negative radius");
  disk.mass = json.contains("mass") ? scene_number(json["mass"]) : square(disk.radius);
  if (disk.mass <= 0 && (json.contains("mass") || !alone)) invalid("a mass that is not positive");
  return disk;
}

}  // namespace

Scene read_scene(const std::string& text) {
  const Json json = parse(text.data(), text.data() + text.size());
  expect_fields(json, {"format", "version", "container", "horizon", "disks"},
                {"name", "comment", "seed", "container_law", "restitution", "maneuvers"});
  expect_format(json, "voroproof-scene");
  for (const char* name : {"name", "comment"}) {
    if (json.contains(name) && !json[name].is_string()) invalid("not a string");
  }
  if (json.contains("seed") && !json["seed"].is_string() && !json["seed"].is_number_integer()) {
    invalid("not a seed");
  }
  Scene scene;
  const Json& wall = json["container"];
  expect_fields(wall, {"center", "radius"}, {"restitution"});
  scene.center = pair_of(wall["center"], scene_number);
  scene.radius = scene_number(wall["radius"]);
  if (wall.contains("restitution")) scene.wall_restitution = scene_number(wall["restitution"]);
  if (json.contains("restitution")) scene.restitution = scene_number(json["restitution"]);
  scene.horizon = scene_number(json["horizon"]);
  if (scene.radius <= 0 || scene.horizon < 0) invalid("a negative radius or horizon");
  if (scene.wall_restitution <= 0 || scene.wall_restitution > 1 || scene.restitution < 0 ||
      scene.restitution > 1) {
    invalid("a restitution beyond its limits");
  }
  if (json.contains("container_law")) {
    scene.whole_law = json["container_law"] == "whole";
    if (!scene.whole_law && json["container_law"] != "normal") invalid("an unknown law");
  }
  const Json &disks = json["disks"], none = Json::array();
  const Json& maneuvers = json.contains("maneuvers") ? json["maneuvers"] : none;
  if (!disks.is_array() || disks.size() > 2000000 || !maneuvers.is_array() ||
      maneuvers.size() > 2000000) {
    invalid("not a list, or too long");
  }
  for (const Json& one : disks) scene.disks.push_back(read_disk(one, disks.size() == 1));
  std::set<std::pair<Rat, int>> seen;
  for (const Json& one : maneuvers) {
    expect_fields(one, {"t", "disk", "velocity"});
    const auto disk = whole(one["disk"], 0, static_cast<std::int64_t>(disks.size()) - 1);
    scene.maneuvers.push_back(
        {scene_number(one["t"]), static_cast<int>(disk), pair_of(one["velocity"], scene_number)});
    const Maneuver& m = scene.maneuvers.back();
    if (m.t < 0 || !seen.emplace(m.t, m.disk).second || m.t < seen.rbegin()->first) {
      invalid("maneuvers are sorted by t, from 0, one of a disk at an instant");
    }
  }
  check_places(scene);
  return scene;
}

History read_history(const std::string& text, int n) {
  History history;
  std::int64_t line = 0;
  try {
    for (std::size_t at = 0;;) {
      ++line;
      if (at >= text.size()) invalid("the file ends without its last line");
      const std::size_t end = std::min(text.find('\n', at), text.size());
      if (end - at > std::size_t(1) << (line == 1 ? 28 : 20)) invalid("a line too long");
      const Json json = parse(text.data() + at, text.data() + end);
      at = std::min(end + 1, text.size());
      if (line == 1) {
        read_header(json, n, history);
      } else if (json.contains("end") || json.contains("stopped")) {
        read_end(json, history);
        if (at < text.size()) invalid("something follows the last line");
        history.last_line = line;
        return history;
      } else {
        Claim claim = read_claim(json, n);
        claim.line = line;
        if (claim.t < (history.claims.empty() ? Rat(0) : history.claims.back().t)) {
          invalid("the times decrease");
        }
        if (claim.t > std::max(history.horizon, nearest_binary64(history.horizon))) {
          invalid("an event after the horizon");
        }
        history.claims.push_back(std::move(claim));
      }
    }
  } catch (Stop& stop) {
    if (stop.line == 0) stop.line = line;
    throw;
  }
}

std::string sha256(const std::string& text) {
  unsigned char hash[SHA256_DIGEST_LENGTH];
  SHA256(reinterpret_cast<const unsigned char*>(text.data()), text.size(), hash);
  std::string hex;
  for (const unsigned char byte : hash) {
    hex += "0123456789abcdef"[byte >> 4];
    hex += "0123456789abcdef"[byte & 15];
  }
  return hex;
}

}  // namespace voroproof_kernel
