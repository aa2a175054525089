#include "history/billiard_history.h"

#include <array>
#include <utility>

#include "history/error.h"
#include "history/event_limit.h"
#include "history/format_version.h"
#include "history/history_fields.h"

namespace voroproof::internal {
namespace {

constexpr auto bit = JsonReader::bit;

enum Member { t, collide, image, maneuver, v, p, end, stopped };
constexpr std::array<std::string_view, 8> member_names = {"t", "collide", "image", "maneuver",
                                                          "v", "p",       "end",   "stopped"};

CompactRational compact(const Number& number) {
  return number.exact ? CompactRational(*number.exact) : CompactRational(number.nearest);
}

HistoryStop read_stop(JsonReader& json) {
  enum { t, reason };
  static constexpr std::array<std::string_view, 2> names = {"t", "reason"};
  HistoryStop stop;
  json.object(names, bit(t) | bit(reason), [&](std::size_t member) {
    if (member == t) {
      stop.exact_t = read_time(json).value();
      stop.t = round_nearest(*stop.exact_t);
    } else {
      stop.reason = json.text();
    }
  });
  return stop;
}

}  // namespace

struct BilliardHistoryReader::Line {
  std::uint32_t seen = 0;
  CompactRational time;
  std::array<GenId, 2> pair{};
  GenId disk = 0;
  std::optional<LatticeImage> image;
  std::array<std::optional<CompactVec3>, 2> v{}, p{};
  std::size_t v_count = 0, p_count = 0;  // vectors: 0 for one that stands alone
  std::optional<std::variant<HistoryEnd, HistoryStop>> ending;
};

BilliardHistoryReader::BilliardHistoryReader(const std::string& path, const Billiard* billiard,
                                             std::optional<std::string_view> text)
    : path_(path),
      billiard_(billiard),
      dimension_(billiard ? static_cast<std::size_t>(billiard->dimension) : 0),
      lines_(path_, text) {
  lines_.keep_digest();
  const auto first = lines_.next(max_header_line);
  if (!first) throw InputError(path_, 1, "", "empty file");
  of_this_version(
      *first, path_, "voroproof-history", [&] { read_header(*first); }, world_version);
}

void BilliardHistoryReader::read_header(std::string_view text) {
  JsonReader json(text, path_, lines_.number());
  const std::string wanted = billiard_ ? billiard_->sha256 : std::string();
  header_ = read_history_header(json, world_version, max_disks - 1, wanted);
  if (header_.initial) json.fail_in("initial", "a billiard has no diagram");
  horizon_ = round_nearest(header_.horizon);
}

void BilliardHistoryReader::require_dimension(const JsonReader& json, std::size_t coordinates) {
  if (dimension_ == 0 && (coordinates == 2 || coordinates == 3)) dimension_ = coordinates;
  if (dimension_ == 0) json.fail("neither two nor three coordinates");
  if (coordinates != dimension_)
    json.fail("not " + std::to_string(dimension_) + " coordinates, the dimension of the scene");
}

CompactVec3 BilliardHistoryReader::read_vector(JsonReader& json) {
  CompactVec3 vector;
  const std::size_t count = json.array([&](std::size_t i) {
    if (i >= vector.size()) json.fail("beyond three coordinates");
    vector[i] = compact(json.number());
  });
  require_dimension(json, count);
  return vector;
}

LatticeImage BilliardHistoryReader::read_image(JsonReader& json) {
  constexpr std::int64_t far = 1 << 30;
  LatticeImage image{};
  const std::size_t count = json.array([&](std::size_t i) {
    if (i >= image.size()) json.fail("beyond three coordinates");
    image[i] = static_cast<int>(json.integer(-far, far));
    if (image[i] != 0 && billiard_ && billiard_->lattice.sides[i] == 0)
      json.fail("the axis is not periodic");
  });
  require_dimension(json, count);
  return image;
}

HistoryEnd BilliardHistoryReader::read_end(JsonReader& json) const {
  static constexpr std::array<std::string_view, 8> names = {
      "t", "collisions", "maneuvers", "flips", "hides", "appears", "swaps", "jumps"};
  HistoryEnd last;
  json.object(names, bit(0) | bit(1) | bit(2), [&](std::size_t member) {
    if (member == 0)
      read_end_time(json, header_.horizon);
    else if (member == 1)
      last.counts.collisions = json.integer(0, std::numeric_limits<std::int64_t>::max());
    else if (member == 2)
      last.counts.maneuvers = json.integer(0, std::numeric_limits<std::int64_t>::max());
    else
      json.integer(0, 0);
  });
  return last;
}

// One vector, or one of each of two, null for one that has none. `count`: 0 for one that stands
// alone.
void BilliardHistoryReader::read_vectors(JsonReader& json,
                                         std::array<std::optional<CompactVec3>, 2>& vectors,
                                         std::size_t& count) {
  count = 0;
  CompactVec3 alone;
  const std::size_t elements = json.array([&](std::size_t i) {
    const bool is_one_of_two = json.array_is_next() || json.null_is_next();
    if (i >= (is_one_of_two ? 2U : 3U) || (i > 0 && is_one_of_two != (count > 0)))
      json.fail("neither a vector, nor one of each of two");
    if (!is_one_of_two) {
      alone[i] = compact(json.number());
      return;
    }
    if (!json.null()) vectors[i] = read_vector(json);
    ++count;
  });
  if (count == 1) json.fail("not one of each of two");
  if (count > 0) return;
  require_dimension(json, elements);
  vectors[0] = alone;
}

void BilliardHistoryReader::read_member(JsonReader& json, std::size_t member, Line& line) {
  const int last = billiard_ ? static_cast<int>(billiard_->disks.size()) - 1 : max_disks - 1;
  const int lowest = billiard_ ? billiard_->last_wall() : -max_disks;
  switch (member) {
    case t:
      line.time = compact(read_time(json));
      break;
    case collide:
      json.array_of<2>([&](std::size_t i) { line.pair[i] = read_id(json, lowest, last); });
      if (line.pair[0] >= line.pair[1] || line.pair[1] < 0)
        json.fail("not two ids, the smaller first, the second of a disk");
      break;
    case image:
      line.image = read_image(json);
      break;
    case maneuver:
      line.disk = read_id(json, 0, last);
      break;
    case v:
      read_vectors(json, line.v, line.v_count);
      break;
    case p:
      read_vectors(json, line.p, line.p_count);
      break;
    case end:
      line.ending = read_end(json);
      break;
    case stopped: {
      HistoryStop stop = read_stop(json);
      line.time = *stop.exact_t;
      line.ending = std::move(stop);
    }
  }
}

// Walls have no velocity, nor have disks that are fixed.
bool BilliardHistoryReader::may_be_null(GenId id) const {
  return id < 0 || billiard_ == nullptr || billiard_->disks[static_cast<std::size_t>(id)].fixed;
}

BilliardEvent BilliardHistoryReader::event_of(JsonReader& json, Line& line) {
  if (!(line.seen & bit(t))) json.fail_in("t", "missing");
  const std::size_t wanted = line.seen & bit(collide) ? 2 : 0;
  if ((line.seen & bit(v)) && line.v_count != wanted)
    json.fail_in("v", wanted ? "not one of each of two" : "not one velocity");
  if ((line.seen & bit(p)) && line.p_count != wanted)
    json.fail_in("p", wanted ? "not one of each of two" : "not one centre");
  if (line.seen & bit(maneuver)) {
    if (line.image) json.fail_in("image", "no field of a line with \"maneuver\"");
    return {line.time, lines_.number(), BilliardTurn{line.disk, line.v[0], line.p[0]}};
  }
  const auto [a, b] = line.pair;
  if (a < 0 && line.image && *line.image != LatticeImage{})
    json.fail_in("image", "a wall has no images");
  for (const int side : {0, 1}) {
    const GenId id = side == 0 ? a : b;
    if (id < 0 && line.v[0]) json.fail_in("v", "not null for a wall");
    if (id < 0 && line.p[0]) json.fail_in("p", "not null for a wall");
    if (may_be_null(id)) continue;
    if ((line.seen & bit(v)) && !line.v[side]) json.fail_in("v", "null for a disk");
  }
  return {line.time, lines_.number(),
          BilliardCollision{a, b, line.image, std::move(line.v), std::move(line.p)}};
}

std::optional<BilliardEvent> BilliardHistoryReader::next() {
  if (ending_) return std::nullopt;
  const auto text = lines_.next(max_event_line);
  if (!text)
    throw InputError(path_, lines_.number(), "", "incomplete: the file ends without an end line");
  JsonReader json(*text, path_, lines_.number());
  Line line;
  Extensions extensions;  // read and dropped
  line.seen = json.object(
      member_names, 0, [&](std::size_t member) { read_member(json, member, line); }, &extensions);
  json.finish();
  constexpr std::uint32_t kinds = bit(collide) | bit(maneuver) | bit(end) | bit(stopped);
  const std::uint32_t kind = line.seen & kinds;
  if (kind == 0) json.fail("neither an event nor an end line");
  if ((kind & (kind - 1)) != 0) json.fail("more than one event");
  if (line.ending) {
    if (line.seen != kind) json.fail("an end line has no other fields");
    if (kind == bit(stopped)) check_time(line.time, "stopped");
    if (lines_.next(max_event_line))
      throw InputError(path_, lines_.number(), "", "text after the last line of the history");
    ending_ = std::move(line.ending);
    return std::nullopt;
  }
  BilliardEvent event = event_of(json, line);
  check_time(event.t, "t");
  ++(kind == bit(collide) ? counts_.collisions : counts_.maneuvers);
  EventLimit::check(counts_);
  return event;
}

bool BilliardHistoryReader::counts_match() const {
  const auto* last = std::get_if<HistoryEnd>(&ending());
  return last == nullptr || last->counts == counts_;
}

void BilliardHistoryReader::check_time(const CompactRational& t, const char* field) {
  if (t < last_t_)
    throw InputError(path_, lines_.number(), field, "earlier than the event before it");
  // Rounding an event at the horizon may move it beyond, but not beyond the rounded horizon.
  if ((t.exact() ? round_nearest(*t.exact()) : t.leading()) > horizon_)
    throw InputError(path_, lines_.number(), field, "beyond the horizon");
  last_t_ = t;
}

}  // namespace voroproof::internal
