#include "tests/metamorphic/maps.h"

#include <algorithm>
#include <memory>

#include "history/json_text.h"

namespace voroproof::internal::metamorphic {
namespace {

using testing::Image;
using Claim = voroproof::internal::Event;

ExactVec2 turned(const ExactVec2& v, const Image& image) {
  return {image.xx * v[0] + image.xy * v[1], image.yx * v[0] + image.yy * v[1]};
}

ExactVec2 velocity_image(const ExactVec2& v, const Image& image) {
  ExactVec2 w = turned(v, image);
  for (Rational& x : w) x /= image.time;
  return w;
}

ExactVec2 centre_image(const ExactVec2& p, const Image& image) {
  const ExactVec2 q = turned(p, image);
  return {q[0] + image.dx, q[1] + image.dy};
}

std::optional<ExactVec2> mapped(const std::optional<ExactVec2>& value, const Image& image,
                                ExactVec2 (*map)(const ExactVec2&, const Image&)) {
  if (!value) return std::nullopt;
  return map(*value, image);
}

Vec2 rounded(const ExactVec2& v) { return {round_nearest(v[0]), round_nearest(v[1])}; }

std::optional<Vec2> rounded(const std::optional<ExactVec2>& v) {
  if (!v) return std::nullopt;
  return rounded(*v);
}

bool is_double(const Rational& x) { return to_rational(round_nearest(x)) == x; }

// The values, where a double loses something.
std::shared_ptr<const ExactValues> kept(const ExactValues& values) {
  bool all = is_double(values.t);
  for (const auto* pairs : {&values.v, &values.p}) {
    for (const auto& pair : *pairs) {
      all = all && (!pair || (is_double((*pair)[0]) && is_double((*pair)[1])));
    }
  }
  return all ? nullptr : std::make_shared<const ExactValues>(values);
}

Claim image_of(const FlipEvent& e, const Image& image) {
  const ExactValues values{exact_time(e) * image.time, {}, {}};
  return FlipEvent{round_nearest(values.t), image.edge(e.quad), kept(values)};
}

Claim image_of(const ManeuverEvent& e, const Image& image) {
  ExactValues values{exact_time(e) * image.time, {}, {}};
  values.v[0] = mapped(exact_velocity(e), image, velocity_image);
  values.p[0] = mapped(exact_center(e), image, centre_image);
  return ManeuverEvent{round_nearest(values.t), image.id(e.disk), rounded(values.v[0]),
                       rounded(values.p[0]), kept(values)};
}

Claim image_of(const CollideEvent& e, const Image& image) {
  ExactValues values{exact_time(e) * image.time, {}, {}};
  for (const int side : {0, 1}) {
    const auto k = static_cast<std::size_t>(side);
    values.v[k] = mapped(exact_velocity(e, side), image, velocity_image);
    values.p[k] = mapped(exact_center(e, side), image, centre_image);
  }
  GenId i = image.id(e.i), j = image.id(e.j);
  if (i > j) {
    std::swap(i, j);
    std::swap(values.v[0], values.v[1]);
    std::swap(values.p[0], values.p[1]);
  }
  CollideEvent c{.t = round_nearest(values.t), .i = i, .j = j};
  for (const std::size_t side : {0, 1}) {
    c.v[side] = rounded(values.v[side]);
    c.p[side] = rounded(values.p[side]);
  }
  c.exact = kept(values);
  return c;
}

RoundedState image_of(const RoundedState& s, const Image& image) {
  const auto p = rounded(centre_image({to_rational(s.px), to_rational(s.py)}, image));
  const auto v = rounded(velocity_image({to_rational(s.vx), to_rational(s.vy)}, image));
  RoundedState r = s;
  r.px = p[0];
  r.py = p[1];
  r.vx = v[0];
  r.vy = v[1];
  return r;
}

std::vector<Quad> image_of(const std::vector<Quad>& edges, const Image& image) {
  std::vector<Quad> result;
  for (const Quad& q : edges) result.push_back(image.edge(q));
  std::sort(result.begin(), result.end());
  return result;
}

std::string pair_text(const ExactVec2& v) {
  return "[" + number_text(v[0]) + "," + number_text(v[1]) + "]";
}

std::string sides_text(const char* name, const std::array<std::optional<ExactVec2>, 2>& sides) {
  if (!sides[1]) return "";
  return std::string(",\"") + name + "\":[" + (sides[0] ? pair_text(*sides[0]) : "null") + "," +
         pair_text(*sides[1]) + "]";
}

std::string edge_text(const Quad& q) { return testing::text(q); }

std::string line_text(const Claim& event) {
  std::string out = "{\"t\":" + number_text(exact_time(event));
  if (const auto* f = std::get_if<FlipEvent>(&event)) {
    out += ",\"flip\":" + edge_text(f->quad);
  } else if (const auto* c = std::get_if<CollideEvent>(&event)) {
    out += ",\"collide\":[" + std::to_string(c->i) + "," + std::to_string(c->j) + "]" +
           sides_text("v", {exact_velocity(*c, 0), exact_velocity(*c, 1)}) +
           sides_text("p", {exact_center(*c, 0), exact_center(*c, 1)});
  } else {
    const auto& m = std::get<ManeuverEvent>(event);
    out += ",\"maneuver\":" + std::to_string(m.disk);
    if (const auto v = exact_velocity(m)) out += ",\"v\":" + pair_text(*v);
    if (const auto p = exact_center(m)) out += ",\"p\":" + pair_text(*p);
  }
  return out + "}\n";
}

}  // namespace

testing::ClaimedHistory image_of(const testing::ClaimedHistory& history, const Image& image) {
  testing::ClaimedHistory h = history;
  h.header.horizon *= image.time;
  if (h.header.initial) h.header.initial = image_of(*history.header.initial, image);
  for (Claim& event : h.events) {
    event = std::visit([&](const auto& e) { return image_of(e, image); }, event);
  }
  return h;
}

testing::RecordedRun image_of(const testing::RecordedRun& run, const Image& image) {
  testing::RecordedRun r = run;
  r.initial = image_of(run.initial, image);
  r.final_diagram = image_of(run.final_diagram, image);
  for (testing::Event& e : r.events) {
    e.t = round_nearest(to_rational(e.t) * image.time);
    if (e.kind == testing::Event::Kind::flip) {
      e.edge = image.edge(e.edge);
      continue;
    }
    e.i = image.id(e.i);
    e.j = image.id(e.j);
    e.first = image_of(e.first, image);
    e.second = image_of(e.second, image);
    if (e.i > e.j) {
      std::swap(e.i, e.j);
      std::swap(e.first, e.second);
    }
  }
  return r;
}

std::string history_text(const testing::ClaimedHistory& h, const std::string& scene_sha256) {
  std::string out = "{\"format\":\"voroproof-history\",\"version\":1,\"scene_sha256\":\"" +
                    scene_sha256 + "\",\"horizon\":" + number_text(h.header.horizon) +
                    ",\"producer\":\"metamorphic 1\"";
  if (h.header.initial) {
    out += ",\"initial\":[";
    const char* separator = "";
    for (const Quad& q : *h.header.initial) {
      out += separator + edge_text(q);
      separator = ",";
    }
    out += "]";
  }
  out += "}\n";
  for (const Claim& event : h.events) out += line_text(event);
  const HistoryCounts& c = h.claimed_counts;
  return out + "{\"end\":{\"t\":" + number_text(round_nearest(h.header.horizon)) +
         ",\"flips\":" + std::to_string(c.flips) +
         ",\"collisions\":" + std::to_string(c.collisions) +
         ",\"maneuvers\":" + std::to_string(c.maneuvers) + "}}\n";
}

}  // namespace voroproof::internal::metamorphic
