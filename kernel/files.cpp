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

// The fields of an object; all must be asked for.
class Fields {
 public:
  explicit Fields(const Json& object) : object_(object) {
    if (!object.is_object()) invalid("not a JSON object");
  }
  ~Fields() noexcept(false) {
    if (std::uncaught_exceptions() == 0 && asked_ != object_.size()) invalid("an unknown field");
  }
  const Json* find(const char* name) {
    const auto it = object_.find(name);
    if (it == object_.end()) return nullptr;
    ++asked_;
    return &*it;
  }
  const Json& get(const char* name) {
    const Json* field = find(name);
    if (field == nullptr) invalid(std::string("the field '") + name + "' is missing");
    return *field;
  }

 private:
  const Json& object_;
  std::size_t asked_ = 0;
};

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

void expect(Fields& fields, const char* format) {
  if (fields.get("format") != format) invalid("another format");
  if (whole(fields.get("version"), 0, INT64_MAX) != 1) invalid("an unknown version");
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
void read_two(const Json* json, bool wall, std::optional<Vec> (&to)[2]) {
  if (json == nullptr) return;
  if (!json->is_array() || json->size() != 2) invalid("not a list of two");
  if ((*json)[0].is_null() != wall) invalid("null stands for the container, and only for it");
  if (!wall) to[0] = pair_of((*json)[0], history_number);
  to[1] = pair_of((*json)[1], history_number);
}

Claim read_claim(const Json& json, int n) {
  Fields fields(json);
  Claim claim{};
  claim.t = claim.filed = history_number(fields.get("t"));
  if (const Json* flip = fields.find("flip")) {
    claim.kind = Claim::Kind::flip;
    claim.quad = edges(Json::array({*flip}), n)[0];
  } else if (const Json* two = fields.find("collide")) {
    claim.kind = Claim::Kind::collision;
    if (!two->is_array() || two->size() != 2) invalid("not a pair");
    claim.i = static_cast<int>(whole((*two)[0], container, n - 1));
    claim.j = static_cast<int>(whole((*two)[1], 0, n - 1));
    if (claim.i >= claim.j) invalid("the smaller id comes first");
    read_two(fields.find("v"), claim.i == container, claim.v);
    read_two(fields.find("p"), claim.i == container, claim.p);
  } else {
    claim.kind = Claim::Kind::maneuver;
    claim.j = static_cast<int>(whole(fields.get("maneuver"), 0, n - 1));
    claim.i = claim.j;
    if (const Json* v = fields.find("v")) claim.v[1] = pair_of(*v, history_number);
    if (const Json* p = fields.find("p")) claim.p[1] = pair_of(*p, history_number);
  }
  return claim;
}

}  // namespace

Scene read_scene(const std::string& text) {
  const Json json = parse(text.data(), text.data() + text.size());
  Scene scene;
  Fields top(json);
  expect(top, "voroproof-scene");
  for (const char* name : {"name", "comment"}) {
    const Json* word = top.find(name);
    if (word != nullptr && !word->is_string()) invalid("not a string");
  }
  const Json* seed = top.find("seed");
  if (seed != nullptr && !seed->is_string() && !seed->is_number()) invalid("not a seed");
  {
    Fields wall(top.get("container"));
    scene.center = pair_of(wall.get("center"), scene_number);
    scene.radius = scene_number(wall.get("radius"));
    if (const Json* e = wall.find("restitution")) scene.wall_restitution = scene_number(*e);
  }
  if (scene.radius <= 0) invalid("the container's radius is not positive");
  if (scene.wall_restitution <= 0 || scene.wall_restitution > 1) invalid("a restitution beyond 1");
  if (const Json* law = top.find("container_law")) {
    scene.whole_law = *law == "whole";
    if (!scene.whole_law && *law != "normal") invalid("an unknown law of the container");
  }
  if (const Json* e = top.find("restitution")) scene.restitution = scene_number(*e);
  if (scene.restitution < 0 || scene.restitution > 1) invalid("a restitution beyond 1");
  scene.horizon = scene_number(top.get("horizon"));
  if (scene.horizon < 0) invalid("a negative horizon");
  const Json& disks = top.get("disks");
  if (!disks.is_array() || disks.size() > 2000000) invalid("not a list of disks");
  for (const Json& one : disks) {
    Fields fields(one);
    Disk disk;
    disk.center = pair_of(fields.get("center"), scene_number);
    disk.radius = scene_number(fields.get("radius"));
    disk.velocity = pair_of(fields.get("velocity"), scene_number);
    if (disk.radius < 0) invalid("a negative radius");
    const Json* mass = fields.find("mass");
    disk.mass = mass == nullptr ? square(disk.radius) : scene_number(*mass);
    if (mass != nullptr && disk.mass <= 0) invalid("a mass that is not positive");
    if (disk.mass == 0 && disks.size() > 1) invalid("a disk of radius 0 without a mass");
    scene.disks.push_back(disk);
  }
  if (const Json* list = top.find("maneuvers")) {
    if (!list->is_array() || list->size() > 2000000) invalid("not a list of maneuvers");
    std::set<std::pair<Rat, int>> seen;
    for (const Json& one : *list) {
      Fields fields(one);
      Maneuver m{scene_number(fields.get("t")), 0, {}};
      m.disk = static_cast<int>(whole(fields.get("disk"), 0, (std::int64_t)disks.size() - 1));
      m.velocity = pair_of(fields.get("velocity"), scene_number);
      if (m.t < 0 || (!scene.maneuvers.empty() && m.t < scene.maneuvers.back().t)) {
        invalid("maneuvers are sorted by t, from 0");
      }
      if (!seen.emplace(m.t, m.disk).second) invalid("two maneuvers of a disk at one instant");
      scene.maneuvers.push_back(m);
    }
  }
  check_places(scene);
  return scene;
}

History read_history(const std::string& text, int n) {
  History history;
  std::size_t at = 0;
  std::int64_t line = 0;
  Rat latest;
  try {
    for (bool done = false; !done; at = std::min(text.find('\n', at), text.size() - 1) + 1) {
      ++line;
      if (at >= text.size()) invalid("the file ends without its last line");
      const std::size_t end = std::min(text.find('\n', at), text.size());
      if (end - at > std::size_t(1) << (line == 1 ? 28 : 20)) invalid("a line too long");
      const Json json = parse(text.data() + at, text.data() + end);
      if (line == 1) {
        Fields fields(json);
        expect(fields, "voroproof-history");
        const Json &hash = fields.get("scene_sha256"), &producer = fields.get("producer");
        if (!hash.is_string() || !producer.is_string()) invalid("not a string");
        history.scene_sha256 = hash.get<std::string>();
        history.horizon = history_number(fields.get("horizon"));
        if (history.horizon < 0) invalid("a negative horizon");
        latest = nearest_binary64(history.horizon);
        if (latest < history.horizon) latest = history.horizon;
        if (const Json* initial = fields.find("initial")) history.initial = edges(*initial, n);
      } else if (json.contains("end")) {
        Fields fields(json);
        Fields last(fields.get("end"));
        const Rat t = history_number(last.get("t"));
        if (t != history.horizon && t != nearest_binary64(history.horizon)) {
          invalid("the last line's t is not the horizon");
        }
        const char* names[] = {"flips", "collisions", "maneuvers"};
        for (int k = 0; k < 3; ++k) history.ended[k] = whole(last.get(names[k]), 0, INT64_MAX);
        done = true;
      } else if (json.contains("stopped")) {
        Fields fields(json);
        Fields last(fields.get("stopped"));
        const Rat t = history_number(last.get("t"));
        if (t > latest || t < 0 || !last.get("reason").is_string()) invalid("a bad last line");
        const Json* events = last.find("events");
        if (events != nullptr && !events->is_array()) invalid("not a list");
        history.horizon = t;
        history.stopped = done = true;
      } else {
        history.claims.push_back(read_claim(json, n));
        Claim& claim = history.claims.back();
        claim.line = line;
        const std::size_t count = history.claims.size();
        if (claim.t < 0 || (count > 1 && claim.t < history.claims[count - 2].t)) {
          invalid("the times decrease");
        }
        if (claim.t > latest) invalid("an event after the horizon");
      }
    }
    if (at < text.size()) invalid("something follows the last line");
  } catch (Stop& stop) {
    if (stop.line == 0) stop.line = line;
    throw;
  }
  history.last_line = line;
  return history;
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
