#include "history/history_reader.h"

#include <array>
#include <limits>
#include <utility>

#include "history/error.h"
#include "history/event_limit.h"
#include "history/format_version.h"
#include "history/history_fields.h"
#include "history/json_reader.h"
#include "history/plain_line.h"

namespace voroproof::internal {
namespace {

constexpr auto bit = JsonReader::bit;
constexpr std::int64_t max_count = std::numeric_limits<std::int64_t>::max();

// A member "v" or "p": of a maneuver a vector, of a collision two, of which null is the
// container's. Which of both can be told only once all keys are read.
struct Vectors {
  using Value = std::array<Number, 2>;
  bool given = false;
  bool single = false;  // one vector, at [0]
  std::array<std::optional<Value>, 2> values;
};

Vectors read_vectors(JsonReader& json) {
  Vectors vectors;
  vectors.given = true;
  Vectors::Value flat;
  json.array_of<2>([&](std::size_t i) {
    const bool nested = json.array_is_next();
    const bool null = !nested && json.null();
    const bool single = !nested && !null;
    if (i == 0) vectors.single = single;
    if (vectors.single != single) json.fail("mixes numbers and vectors");
    if (single) {
      flat[i] = json.number();
    } else if (nested) {
      Vectors::Value& value = vectors.values[i].emplace();
      json.array_of<2>([&](std::size_t k) { value[k] = json.number(); });
    }
  });
  if (vectors.single) vectors.values[0] = std::move(flat);
  return vectors;
}

bool has_exact(const Vectors& vectors) {
  for (const auto& value : vectors.values)
    if (value && ((*value)[0].exact || (*value)[1].exact)) return true;
  return false;
}

std::optional<Vec2> nearest(const std::optional<Vectors::Value>& value) {
  if (!value) return std::nullopt;
  return Vec2{(*value)[0].nearest, (*value)[1].nearest};
}

std::optional<ExactVec2> exactly(const std::optional<Vectors::Value>& value) {
  if (!value) return std::nullopt;
  return ExactVec2{(*value)[0].value(), (*value)[1].value()};
}

// The exact values of a line, or null where all its numbers are binary64.
std::shared_ptr<const ExactValues> exact_values(const Number& t, const Vectors& v,
                                                const Vectors& p) {
  if (!t.exact && !has_exact(v) && !has_exact(p)) return nullptr;
  auto values = std::make_shared<ExactValues>();
  values->t = t.value();
  for (std::size_t side = 0; side < 2; ++side) {
    values->v[side] = exactly(v.values[side]);
    values->p[side] = exactly(p.values[side]);
  }
  return values;
}

HistoryEnd read_end(JsonReader& json, const Rational& horizon) {
  enum { t, flips, collisions, maneuvers };
  static constexpr std::array<std::string_view, 4> names = {"t", "flips", "collisions",
                                                            "maneuvers"};
  HistoryEnd end;
  const std::uint32_t all = bit(t) | bit(flips) | bit(collisions) | bit(maneuvers);
  json.object(names, all, [&](std::size_t member) {
    switch (member) {
      case t:
        read_end_time(json, horizon);
        break;
      case flips:
        end.counts.flips = json.integer(0, max_count);
        break;
      case collisions:
        end.counts.collisions = json.integer(0, max_count);
        break;
      case maneuvers:
        end.counts.maneuvers = json.integer(0, max_count);
    }
  });
  return end;
}

HistoryStop read_stop(JsonReader& json) {
  enum { t, reason, events };
  static constexpr std::array<std::string_view, 3> names = {"t", "reason", "events"};
  HistoryStop stop;
  json.object(names, bit(t) | bit(reason), [&](std::size_t member) {
    switch (member) {
      case t: {
        Number number = read_time(json);
        stop.t = number.nearest;
        stop.exact_t = std::move(number.exact);
        break;
      }
      case reason:
        stop.reason = json.text();
        break;
      case events:
        json.array([&](std::size_t) { stop.events.emplace_back(json.any()); });
    }
  });
  return stop;
}

// The members of a line after the first.
enum Member { t, flip, collide, maneuver, v, p, end, stopped };
constexpr std::array<std::string_view, 8> member_names = {"t", "flip", "collide", "maneuver",
                                                          "v", "p",    "end",     "stopped"};
constexpr std::uint32_t flip_line = bit(flip), collide_line = bit(collide),
                        maneuver_line = bit(maneuver), end_line = bit(end),
                        stop_line = bit(stopped);

struct Line {
  std::uint32_t seen = 0;  // the bit set of its members
  Number time;             // also of a stop line; not of an end line
  Quad quad{};
  std::array<GenId, 2> pair{};
  GenId disk = 0;
  Vectors velocities, centers;
  Extensions extensions;
  std::optional<std::variant<HistoryEnd, HistoryStop>> ending;
};

// Whether the vectors of a collision are two, and null for the container only.
void check_vectors(const JsonReader& json, const Line& line, const Vectors& vectors,
                   const std::string& name) {
  if (!vectors.given) return;
  if (vectors.single) json.fail_in(name, "not two vectors");
  for (std::size_t side = 0; side < 2; ++side) {
    const bool is_container = line.pair[side] == container_id;
    if (vectors.values[side].has_value() == is_container)
      json.fail_in(name, is_container ? "not null for the container" : "null for a disk");
  }
}

// Whether the members of a line make one event, or one last line.
void check_members(const JsonReader& json, const Line& line) {
  const std::uint32_t kind =
      line.seen & (flip_line | collide_line | maneuver_line | end_line | stop_line);
  if (kind == 0) json.fail("neither an event nor an end line");
  if (kind & (kind - 1)) json.fail("more than one event");
  if (kind & (end_line | stop_line)) {
    if (line.seen != kind) json.fail("an end line with other fields");
    return;
  }
  if (!(line.seen & bit(t))) json.fail_in("t", "missing");
  if (kind & flip_line) {
    if (line.seen != (bit(t) | bit(flip))) json.fail("a flip has neither v nor p");
  } else if (kind & collide_line) {
    check_vectors(json, line, line.velocities, "v");
    check_vectors(json, line, line.centers, "p");
  } else {
    if (line.velocities.given && !line.velocities.single) json.fail_in("v", "not one vector");
    if (line.centers.given && !line.centers.single) json.fail_in("p", "not one vector");
  }
}

Line read_line(std::string_view text, const std::string& path, std::int64_t number, int last_id,
               const Rational& horizon) {
  JsonReader json(text, path, number);
  Line line;
  line.seen = json.object(
      member_names, 0,
      [&](std::size_t member) {
        switch (member) {
          case t:
            line.time = read_time(json);
            break;
          case flip:
            line.quad = canonical(read_edge(json, last_id));
            break;
          case collide:
            json.array_of<2>(
                [&](std::size_t i) { line.pair[i] = read_id(json, container_id, last_id); });
            if (line.pair[0] >= line.pair[1]) json.fail("not two ids, the smaller first");
            break;
          case maneuver:
            line.disk = read_id(json, 0, last_id);
            break;
          case v:
            line.velocities = read_vectors(json);
            break;
          case p:
            line.centers = read_vectors(json);
            break;
          case end:
            line.ending = read_end(json, horizon);
            break;
          case stopped: {
            HistoryStop stop = read_stop(json);
            line.time = {stop.t, stop.exact_t};
            line.ending = std::move(stop);
          }
        }
      },
      &line.extensions);
  json.finish();
  check_members(json, line);
  return line;
}

FlipEvent flip_of(const Line& line) {
  return {line.time.nearest, line.quad, exact_values(line.time, line.velocities, line.centers)};
}

CollideEvent collision_of(const Line& line) {
  const auto& [v_i, v_j] = line.velocities.values;
  const auto& [p_i, p_j] = line.centers.values;
  return {line.time.nearest,
          line.pair[0],
          line.pair[1],
          {nearest(v_i), nearest(v_j)},
          {nearest(p_i), nearest(p_j)},
          exact_values(line.time, line.velocities, line.centers)};
}

ManeuverEvent maneuver_of(const Line& line) {
  return {line.time.nearest, line.disk, nearest(line.velocities.values[0]),
          nearest(line.centers.values[0]), exact_values(line.time, line.velocities, line.centers)};
}

}  // namespace

HistoryHeader read_history_header(JsonReader& json, std::int64_t wanted_version, int last_id,
                                  const std::string& wanted_sha256) {
  enum { format, version, scene_sha256, horizon, producer, initial };
  static constexpr std::array<std::string_view, 6> names = {"format",  "version",  "scene_sha256",
                                                            "horizon", "producer", "initial"};
  constexpr std::uint32_t required =
      bit(format) | bit(version) | bit(scene_sha256) | bit(horizon) | bit(producer);
  HistoryHeader header;
  json.object(
      names, required,
      [&](std::size_t member) {
        switch (member) {
          case format:
            if (json.text() != "voroproof-history") json.fail("not \"voroproof-history\"");
            break;
          case version:
            read_version(json, wanted_version);
            break;
          case scene_sha256:
            header.scene_sha256 = read_scene_sha256(json, wanted_sha256);
            break;
          case horizon:
            header.horizon = read_time(json).value();
            break;
          case producer:
            header.producer = json.text();
            break;
          case initial:
            header.initial = read_initial(json, last_id);
        }
      },
      &header.extensions);
  json.finish();
  return header;
}

HistoryReader::HistoryReader(const std::string& path, int disk_count,
                             const std::string& scene_sha256)
    : path_(path), lines_(path_), last_id_(disk_count - 1) {
  lines_.keep_digest();
  const auto text = lines_.next(max_header_line);
  if (!text) throw InputError(path_, 1, "", "empty file");
  of_this_version(*text, path_, "voroproof-history", [&] { read_header(*text, scene_sha256); });
}

void HistoryReader::read_header(std::string_view text, const std::string& wanted_sha256) {
  JsonReader json(text, path_, lines_.number());
  header_ = read_history_header(json, format_version, last_id_, wanted_sha256);
  horizon_ = round_nearest(header_.horizon);
}

std::optional<Event> HistoryReader::next() {
  if (ending_) return std::nullopt;
  return next_line();
}

std::optional<Event> HistoryReader::next_line() {
  if (!keeps_digest_) lines_.drop_digest();
  const auto text = lines_.next(max_event_line);
  if (!text)
    throw InputError(path_, lines_.number(), "", "incomplete: the file ends without an end line");
  extensions_.clear();
  std::optional<Event> event = plain_event(*text, last_id_);
  if (event) {
    check_time({time(*event), {}}, "t");
  } else {
    event = read_strictly(*text);
  }
  if (event) {
    counts_.add(*event);
    EventLimit::check(counts_);
  }
  return event;
}

std::optional<Event> HistoryReader::read_strictly(std::string_view text) {
  Line line = read_line(text, path_, lines_.number(), last_id_, header_.horizon);
  extensions_ = std::move(line.extensions);
  if (!(line.seen & end_line)) check_time(line.time, line.seen & stop_line ? "stopped" : "t");
  if (line.ending) {
    if (lines_.next(max_event_line))
      throw InputError(path_, lines_.number(), "", "text after the last line of the history");
    ending_ = std::move(line.ending);
    return std::nullopt;
  }
  if (line.seen & flip_line) return flip_of(line);
  if (line.seen & collide_line) return collision_of(line);
  return maneuver_of(line);
}

bool HistoryReader::skip_to(const HistoryPlace& place) {
  if (!lines_.skip_to(place.offset, place.line, place.digest)) return false;
  last_t_ = place.t;
  last_exact_t_.reset();
  counts_ = place.counts;
  return true;
}

void HistoryReader::check_time(const Number& t, const char* field) {
  const bool decreases = t.exact || last_exact_t_
                             ? t.value() < last_exact_t_.value_or(to_rational(last_t_))
                             : t.nearest < last_t_;
  if (decreases)
    throw InputError(path_, lines_.number(), field, "earlier than the event before it");
  // Rounding an event at the horizon may move it beyond, but not beyond the rounded horizon.
  if (t.nearest > horizon_) throw InputError(path_, lines_.number(), field, "beyond the horizon");
  last_t_ = t.nearest;
  last_exact_t_ = t.exact;
}

bool HistoryReader::counts_match() const {
  const auto* end = std::get_if<HistoryEnd>(&ending());
  return end == nullptr || end->counts == counts_;
}

}  // namespace voroproof::internal
