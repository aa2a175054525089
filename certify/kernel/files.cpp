#include "certify/kernel/files.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "certify/kernel/json.h"

namespace voroproof_kernel {
namespace {

Quad edge(const Json& json, int n) {
  list(json, 4, 4);
  int id[4];
  for (int k = 0; k < 4; ++k) id[k] = static_cast<int>(whole(json[k], container, n - 1));
  const auto [l, r, s, e] = id;
  if (l == r || s == l || s == r || e == l || e == r) invalid("a quadruple that names no edge");
  return {l, r, s, e};
}

// v or p of a claim, of one disk or of two.
void read_vectors(const Json& json, const char* name, const Scene& scene, Claim& claim) {
  if (!json.contains(name)) return;
  const Json& field = json[name];
  const bool places = *name == 'p';
  std::optional<Vec>(&to)[2] = places ? claim.p : claim.v;
  if (claim.kind == Claim::Kind::maneuver) {
    to[1] = vec(field, history_number, scene.coordinates());
    return;
  }
  list(field, 2, 2);
  for (int k = 0; k < 2; ++k) {
    const bool wall = claim.id[k] < 0;
    const bool may_lack =
        scene.is_billiard() && (places || (!wall && scene.disks[claim.id[k]].fixed));
    if (field[k].is_null() ? !wall && !may_lack : wall) invalid("null stands for the frame");
    if (!field[k].is_null()) to[k] = vec(field[k], history_number, scene.coordinates());
  }
}

Image read_image(const Json& json, const Scene& scene, const Claim& claim) {
  const std::size_t coordinates = scene.coordinates();
  list(json, coordinates, coordinates);
  Image image{};
  for (std::size_t k = 0; k < coordinates; ++k) {
    const int most = claim.first == 0 && scene.sides[k] != 0 ? 1 << 30 : 0;
    image[k] = static_cast<int>(whole(json[k], -most, most));
  }
  return image;
}

Claim read_claim(const Json& json, const Scene& scene) {
  const int n = static_cast<int>(scene.disks.size());
  Claim claim{};
  claim.first = 2;
  if (!scene.is_billiard() && json.contains("flip")) {
    expect_fields(json, {"t", "flip"});
    claim.quad = edge(json["flip"], n);
  } else {
    const bool two = json.contains("collide");
    if (two && scene.is_billiard()) {
      expect_fields(json, {"t", "collide"}, {"v", "p", "image"});
    } else {
      expect_fields(json, {"t", two ? "collide" : "maneuver"}, {"v", "p"});
    }
    claim.kind = two ? Claim::Kind::collision : Claim::Kind::maneuver;
    const Json& id = two ? list(json["collide"], 2, 2) : json["maneuver"];
    claim.id[1] = static_cast<int>(whole(two ? id[1] : id, 0, n - 1));
    claim.id[0] =
        two ? static_cast<int>(whole(id[0], scene.last_wall(), claim.id[1] - 1)) : container;
    claim.first = claim.id[0] < 0 ? 1 : 0;
    if (json.contains("image")) claim.image = read_image(json["image"], scene, claim);
    read_vectors(json, "v", scene, claim);
    read_vectors(json, "p", scene, claim);
  }
  claim.t = claim.filed = history_number(json["t"]);
  return claim;
}

void read_header(const Json& json, const Scene& scene, History& history) {
  if (version_of(json, "voroproof-history") != (scene.is_billiard() ? 2 : 1))
    invalid("of another version than its scene");
  expect_fields(json, {"format", "version", "scene_sha256", "horizon", "producer"}, {"initial"});
  string_of(json["producer"]);
  history.scene_sha256 = string_of(json["scene_sha256"]);
  history.horizon = history_number(json["horizon"]);
  if (history.horizon < 0) invalid("a negative horizon");
  if (!json.contains("initial")) return;
  if (scene.is_billiard()) invalid("a billiard has no diagram");
  history.initial.emplace();
  const int n = static_cast<int>(scene.disks.size());
  for (const Json& q : list(json["initial"], 0, SIZE_MAX)) history.initial->push_back(edge(q, n));
}

void read_last(const Json& json, const Scene& scene, History& history) {
  history.stopped = json.contains("stopped");
  expect_fields(json, {history.stopped ? "stopped" : "end"});
  const Json& last = history.stopped ? json["stopped"] : json["end"];
  if (history.stopped) {
    if (scene.is_billiard()) {
      expect_fields(last, {"t", "reason"}, {}, false);
    } else {
      expect_fields(last, {"t", "reason"}, {"events"}, false);
    }
    string_of(last["reason"]);
    return;
  }
  if (scene.is_billiard()) {
    const Names none = {"flips", "hides", "appears", "swaps", "jumps"};
    expect_fields(last, {"t", "collisions", "maneuvers"}, none, false);
    for (const char* name : none) whole(last.value(name, Json(0)), 0, 0);
  } else {
    expect_fields(last, {"t", "flips", "collisions", "maneuvers"}, {}, false);
  }
  const Rat t = history_number(last["t"]);
  if (t != history.horizon && t != nearest_binary64(history.horizon)) invalid("t of the last line");
  const char* names[] = {"flips", "collisions", "maneuvers"};
  for (int k = 0; k < 3; ++k) history.ended[k] = whole(last.value(names[k], Json(0)), 0, INT64_MAX);
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

void read_remarks(const Json& json) {
  for (const char* word : {"name", "comment"}) string_of(json.value(word, Json("")));
  if (const Json seed = json.value("seed", Json(0)); !seed.is_number_integer()) string_of(seed);
}

void read_maneuvers(const Json& json, Scene& scene) {
  std::set<std::pair<Rat, int>> seen;
  const Json maneuvers = json.value("maneuvers", Json::array());
  for (const Json& one : list(maneuvers, 0, 2000000)) {
    expect_fields(one, {"t", "disk", "velocity"});
    const auto most = static_cast<std::int64_t>(scene.disks.size()) - 1;
    const Maneuver m{scene_number(one["t"]), static_cast<int>(whole(one["disk"], 0, most)),
                     vec(one["velocity"], scene_number, scene.coordinates())};
    const bool later = m.t >= 0 && seen.emplace(m.t, m.disk).second && m.t >= seen.rbegin()->first;
    if (!later) invalid("maneuvers are sorted by t, from 0, one of a disk at an instant");
    if (scene.disks[m.disk].fixed) invalid("a maneuver of a fixed disk");
    scene.maneuvers.push_back(m);
  }
}

Scene read_scene(const std::string& text) {
  const Json json = parse(text.data(), text.data() + text.size());
  if (!json.is_object()) invalid("not a JSON object");
  if (version_of(json, "voroproof-scene") == 2) return read_billiard(json);
  expect_fields(json, {"format", "version", "container", "horizon", "disks"},
                {"name", "comment", "seed", "container_law", "restitution", "maneuvers"});
  read_remarks(json);
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
  read_maneuvers(json, scene);
  check_places(scene);
  return scene;
}

History read_history(const std::string& text, const Scene& scene) {
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
        read_header(json, scene, history);
      } else if (json.contains("end") || json.contains("stopped")) {
        read_last(json, scene, history);
        if (at < text.size()) invalid("something follows the last line");
        history.last_line = line;
      } else {
        history.claims.push_back(read_claim(json, scene));
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
