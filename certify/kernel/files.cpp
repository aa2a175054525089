#include "certify/kernel/files.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace voroproof_kernel {
namespace {

// The floating-point numbers are binary64; that of nlohmann is wider only so that it does not
// refuse the integers of a seed.
using Json = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t,
                                  std::uint64_t, long double>;

// Refuses what nlohmann would let pass: keys that occur twice, nesting without end, numbers beyond
// binary64, or that are not zero and whose nearest binary64 is. An integer beyond 64 bits is the
// nearest binary64; where it is a scene's seed, which is not used, it is 0.
class StrictReader : public nlohmann::detail::json_sax_dom_parser<Json> {
  using Base = nlohmann::detail::json_sax_dom_parser<Json>;

 public:
  explicit StrictReader(Json& result) : Base(result, false) {}
  bool start_object(std::size_t size) { return open() && Base::start_object(size); }
  bool start_array(std::size_t size) { return open() && Base::start_array(size); }
  bool end_object() { return close() && Base::end_object(); }
  bool end_array() { return close() && Base::end_array(); }
  bool key(std::string& name) {
    if (!keys_.back().insert(name).second) invalid("a field occurs twice");
    is_seed_ = name == "seed";
    return Base::key(name);
  }
  bool number_float(long double, const std::string& text) {
    if (text.size() > 4096) invalid("a number of more than 4096 characters");
    if (is_seed_ && keys_.size() == 1 && text.find_first_of(".eE") == std::string::npos) {
      if (text.size() > 1000) invalid("a seed of more than 1000 characters");
      return Base::number_integer(0);
    }
    const double x = std::strtod(text.c_str(), nullptr);
    const bool zero = text.find_first_of("123456789") >= text.find_first_of("eE");
    if (std::isinf(x) || (x == 0 && !zero)) invalid("beyond the range of binary64");
    return Base::number_float(x, text);
  }

 private:
  bool open() {
    keys_.emplace_back();
    if (keys_.size() > 16) invalid("nested too deeply");
    return true;
  }
  bool close() {
    keys_.pop_back();
    return true;
  }
  std::vector<std::set<std::string>> keys_;  // keys of each object or list that is open
  bool is_seed_ = false;                     // whether the key read last is that of a seed
};

Json parse(const char* begin, const char* end) {
  Json result;
  StrictReader reader(result);
  if (!Json::sax_parse(begin, end, &reader)) invalid("not JSON");
  return result;
}

using Names = std::initializer_list<const char*>;

// Requires that an object has all fields of the first list, and of others only those of the second
// and, where it may have them, extensions.
void expect_fields(const Json& object, Names required, Names optional = {},
                   bool extensible = true) {
  std::size_t known = required.size();
  for (const char* name : required) {
    if (!object.contains(name)) invalid(std::string("the field '") + name + "' is missing");
  }
  for (const char* name : optional) known += object.contains(name);
  for (const auto& [name, value] : object.items()) known += extensible && name.starts_with("x-");
  if (known != object.size()) invalid("an unknown field");
}

// Before the other fields: a newer version may have some that are not known here.
void expect_format(const Json& object, const char* format) {
  const Json version = object.value("version", Json());
  if (object.value("format", Json()) != format || !version.is_number_integer())
    invalid("another format or version");
  if (version > 1) invalid("of version " + version.dump() + "; this program reads version 1");
  if (version != 1) invalid("another format or version");
}

const std::string& string_of(const Json& json) {
  if (!json.is_string()) invalid("not a string");
  return json.get_ref<const std::string&>();
}

// strtod rounds correctly; integers are rounded to nearest, too.
Rat number(const Json& json) {
  if (json.is_number()) return exactly(json.get<double>());
  return exact_string(string_of(json));
}

// The limits are binary64, the one a little more and the other a little less than the power of ten.
Rat scene_number(const Json& json) {
  const Rat x = number(json), size = abs(x);
  if (x != 0 && (size > exactly(1e100) || size < exactly(1e-100)))
    invalid("beyond a scene's limits");
  return x;
}

Rat history_number(const Json& json) {
  const Rat x = number(json);
  if (x != 0 && json.is_string() && nearest_binary64(x) == 0) invalid("beyond binary64");
  return x;
}

const Json& list(const Json& json, std::size_t least, std::size_t most) {
  if (!json.is_array() || json.size() < least || json.size() > most) invalid("not such a list");
  return json;
}

Vec vec(const Json& json, Rat read(const Json&)) {
  list(json, 2, 2);
  return {read(json[0]), read(json[1])};
}

std::int64_t whole(const Json& json, std::int64_t least, std::int64_t most) {
  if (!json.is_number_integer()) invalid("not an integer");
  const bool huge = json.is_number_unsigned() && json.get<std::uint64_t>() > INT64_MAX;
  const std::int64_t x = huge ? INT64_MAX : json.get<std::int64_t>();
  if (huge || x < least || x > most) invalid("an integer beyond its limits");
  return x;
}

Quad edge(const Json& json, int n) {
  list(json, 4, 4);
  int id[4];
  for (int k = 0; k < 4; ++k) id[k] = static_cast<int>(whole(json[k], container, n - 1));
  const auto [l, r, s, e] = id;
  if (l == r || s == l || s == r || e == l || e == r) invalid("a quadruple that names no edge");
  return {l, r, s, e};
}

// v or p of a claim, of one disk or of two.
void read_vectors(const Json& json, const char* name, const Claim& claim,
                  std::optional<Vec> (&to)[2]) {
  if (!json.contains(name)) return;
  const Json& field = json[name];
  if (claim.kind == Claim::Kind::maneuver) {
    to[1] = vec(field, history_number);
    return;
  }
  list(field, 2, 2);
  if (field[0].is_null() != (claim.first == 1)) invalid("null stands for the container");
  for (int k = claim.first; k < 2; ++k) to[k] = vec(field[k], history_number);
}

Claim read_claim(const Json& json, int n) {
  Claim claim{};
  claim.first = 2;
  if (json.contains("flip")) {
    expect_fields(json, {"t", "flip"});
    claim.quad = edge(json["flip"], n);
  } else {
    const bool two = json.contains("collide");
    expect_fields(json, {"t", two ? "collide" : "maneuver"}, {"v", "p"});
    claim.kind = two ? Claim::Kind::collision : Claim::Kind::maneuver;
    const Json& id = two ? list(json["collide"], 2, 2) : json["maneuver"];
    claim.id[1] = static_cast<int>(whole(two ? id[1] : id, 0, n - 1));
    claim.id[0] = two ? static_cast<int>(whole(id[0], container, claim.id[1] - 1)) : container;
    claim.first = claim.id[0] == container ? 1 : 0;
    read_vectors(json, "v", claim, claim.v);
    read_vectors(json, "p", claim, claim.p);
  }
  claim.t = claim.filed = history_number(json["t"]);
  return claim;
}

void read_header(const Json& json, int n, History& history) {
  expect_format(json, "voroproof-history");
  expect_fields(json, {"format", "version", "scene_sha256", "horizon", "producer"}, {"initial"});
  string_of(json["producer"]);
  history.scene_sha256 = string_of(json["scene_sha256"]);
  history.horizon = history_number(json["horizon"]);
  if (history.horizon < 0) invalid("a negative horizon");
  if (!json.contains("initial")) return;
  history.initial.emplace();
  for (const Json& q : list(json["initial"], 0, SIZE_MAX)) history.initial->push_back(edge(q, n));
}

void read_last(const Json& json, History& history) {
  history.stopped = json.contains("stopped");
  expect_fields(json, {history.stopped ? "stopped" : "end"});
  const Json& last = history.stopped ? json["stopped"] : json["end"];
  if (history.stopped) {
    expect_fields(last, {"t", "reason"}, {"events"}, false);
    string_of(last["reason"]);
    return;
  }
  const char* names[] = {"flips", "collisions", "maneuvers"};
  expect_fields(last, {"t", names[0], names[1], names[2]}, {}, false);
  const Rat t = history_number(last["t"]);
  if (t != history.horizon && t != nearest_binary64(history.horizon)) invalid("t of the last line");
  for (int k = 0; k < 3; ++k) history.ended[k] = whole(last[names[k]], 0, INT64_MAX);
}

Disk read_disk(const Json& json, bool alone) {
  expect_fields(json, {"center", "radius", "velocity"}, {"mass"});
  Disk disk{vec(json["center"], scene_number), vec(json["velocity"], scene_number),
            scene_number(json["radius"]), 0};
  if (disk.radius < 0) invalid("a negative radius");
  disk.mass = json.contains("mass") ? scene_number(json["mass"]) : square(disk.radius);
  if (disk.mass <= 0 && (json.contains("mass") || !alone)) invalid("a mass that is not positive");
  return disk;
}

// Disks lie in the container and do not overlap: by a sweep over their abscissas.
void check_places(const Scene& scene) {
  std::vector<const Disk*> order;
  Rat widest = 0;
  for (const Disk& d : scene.disks) {
    const Vec n = minus(d.center, scene.center);
    const Rat gap = square(scene.radius - d.radius) - norm2(n);
    if (d.radius >= scene.radius || gap < 0) invalid("a disk is not inside the container");
    const bool slides = gap == 0 && dot(n, d.velocity) == 0 && norm2(d.velocity) != 0;
    if (slides) invalid("a disk touches the container and moves along it");
    widest = std::max(widest, d.radius);
    order.push_back(&d);
  }
  std::sort(order.begin(), order.end(),
            [](const Disk* a, const Disk* b) { return a->center[0] < b->center[0]; });
  for (auto a = order.begin(); a != order.end(); ++a) {
    for (auto b = a + 1; b != order.end(); ++b) {
      if ((*b)->center[0] - (*a)->center[0] > (*a)->radius + widest) break;
      const Rat d2 = norm2(minus((*a)->center, (*b)->center));
      const Rat reach = (*a)->radius + (*b)->radius, reach2 = square(reach);
      if (d2 == 0 && reach == 0) invalid("two points coincide");
      if (d2 < reach2) {
        // The distance is the reach times the root of 1 - part.
        const double part = Rat(1 - d2 / reach2).convert_to<double>();
        std::ostringstream amount;
        amount << reach.convert_to<double>() * part / (1 + std::sqrt(1 - part));
        invalid("two disks overlap by " + amount.str());
      }
    }
  }
}

}  // namespace

std::string name(const Quad& q) {
  const auto text = [](int g) { return std::to_string(g); };
  return "[" + text(q.l) + "," + text(q.r) + "," + text(q.s) + "," + text(q.e) + "]";
}

Scene read_scene(const std::string& text) {
  const Json json = parse(text.data(), text.data() + text.size());
  if (!json.is_object()) invalid("not a JSON object");
  expect_format(json, "voroproof-scene");
  expect_fields(json, {"format", "version", "container", "horizon", "disks"},
                {"name", "comment", "seed", "container_law", "restitution", "maneuvers"});
  for (const char* word : {"name", "comment"}) string_of(json.value(word, Json("")));
  if (const Json seed = json.value("seed", Json(0)); !seed.is_number_integer()) string_of(seed);
  const Json& wall = json["container"];
  expect_fields(wall, {"center", "radius"}, {"restitution"}, false);
  Scene scene;
  scene.center = vec(wall["center"], scene_number);
  scene.radius = scene_number(wall["radius"]);
  scene.wall_restitution = scene_number(wall.value("restitution", Json(1)));
  scene.restitution = scene_number(json.value("restitution", Json(1)));
  scene.horizon = scene_number(json["horizon"]);
  if (scene.radius <= 0 || scene.horizon < 0) invalid("a negative radius or horizon");
  const auto& [e, o] = std::tie(scene.restitution, scene.wall_restitution);
  if (e < 0 || e > 1 || o <= 0 || o > 1) invalid("a restitution beyond its limits");
  const std::string law = string_of(json.value("container_law", Json("normal")));
  scene.whole_law = law == "whole";
  if (!scene.whole_law && law != "normal") invalid("an unknown law");
  const Json& disks = list(json["disks"], 0, 2000000);
  for (const Json& one : disks) scene.disks.push_back(read_disk(one, disks.size() == 1));
  std::set<std::pair<Rat, int>> seen;
  const Json maneuvers = json.value("maneuvers", Json::array());
  for (const Json& one : list(maneuvers, 0, 2000000)) {
    expect_fields(one, {"t", "disk", "velocity"});
    const auto most = static_cast<std::int64_t>(disks.size()) - 1;
    const Maneuver m{scene_number(one["t"]), static_cast<int>(whole(one["disk"], 0, most)),
                     vec(one["velocity"], scene_number)};
    const bool later = m.t >= 0 && seen.emplace(m.t, m.disk).second && m.t >= seen.rbegin()->first;
    if (!later) invalid("maneuvers are sorted by t, from 0, one of a disk at an instant");
    scene.maneuvers.push_back(m);
  }
  check_places(scene);
  return scene;
}

History read_history(const std::string& text, int n) {
  History history;
  std::int64_t line = 0;
  try {
    for (std::size_t at = 0; history.last_line == 0;) {
      ++line;
      if (at >= text.size()) invalid("the file ends without its last line");
      const std::size_t end = std::min(text.find('\n', at), text.size());
      if (end - at > std::size_t{1} << (line == 1 ? 28 : 20)) invalid("a line too long");
      const Json json = parse(text.data() + at, text.data() + end);
      at = std::min(end + 1, text.size());
      if (!json.is_object()) invalid("not a JSON object");
      if (line == 1) {
        read_header(json, n, history);
      } else if (json.contains("end") || json.contains("stopped")) {
        read_last(json, history);
        if (at < text.size()) invalid("something follows the last line");
        history.last_line = line;
      } else {
        history.claims.push_back(read_claim(json, n));
        Claim& claim = history.claims.back();
        claim.line = line;
        const bool first = history.claims.size() == 1;
        if (claim.t < (first ? Rat(0) : (&claim)[-1].t)) invalid("the times decrease");
        const Rat most = std::max(history.horizon, nearest_binary64(history.horizon));
        if (claim.t > most) invalid("an event after the horizon");
      }
    }
  } catch (Stop& stop) {
    if (stop.line == 0) stop.line = line;
    throw;
  }
  return history;
}

}  // namespace voroproof_kernel
