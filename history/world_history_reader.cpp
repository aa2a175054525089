#include "history/world_history_reader.h"

#include <array>
#include <limits>
#include <utility>

#include "history/error.h"
#include "history/event_limit.h"
#include "history/format_version.h"
#include "history/history_fields.h"
#include "history/history_reader.h"
#include "history/json_reader.h"

namespace voroproof::internal {
namespace {

constexpr auto bit = JsonReader::bit;
constexpr std::int64_t max_count = std::numeric_limits<std::int64_t>::max();

// The members of a line after the first.
enum Member {
  t,
  flip,
  hide,
  appear,
  at,
  swap,
  maneuver,
  jump,
  out,
  in,
  v,
  p,
  growth,
  r,
  end,
  stopped
};
constexpr std::array<std::string_view, 16> member_names = {
    "t",   "flip", "hide", "appear", "at",     "swap", "maneuver", "jump",
    "out", "in",   "v",    "p",      "growth", "r",    "end",      "stopped"};

// A kind of line is told by a member of its own, and has no others than these.
struct Kind {
  Member member;
  std::uint32_t required, allowed;
};
constexpr std::array<Kind, 8> kinds = {{
    {flip, bit(t), 0},
    {hide, bit(t), 0},
    {appear, bit(t), bit(at)},
    {swap, bit(t), 0},
    {maneuver, bit(t), bit(v) | bit(p) | bit(growth)},
    {jump, bit(t), bit(out) | bit(at) | bit(in) | bit(p) | bit(v) | bit(r)},
    {end, 0, 0},
    {stopped, 0, 0},
}};

struct Line {
  std::uint32_t seen = 0;  // the bit set of its members
  Member kind = end;
  Rational time;   // a stop line has one, too, an end line none
  Quad edge{};     // that flips
  GenId disk = 0;  // that turns or jumps
  std::array<GenId, 2> pair{};
  std::optional<Quad> at;  // none where it is null, too
  std::optional<std::vector<Step>> out, in;
  std::optional<Point2> velocity, center;
  std::optional<Rational> growth, radius;
  std::optional<std::variant<WorldEnd, WorldStop>> ending;
};

// A list of two numbers is a hide, one of four a flip, one of six an appear; an appear without an
// edge has null in its place.
Step read_step(JsonReader& json, int last_id) {
  std::array<GenId, 6> ids{};
  bool no_edge = false;
  const std::size_t count = json.array([&](std::size_t i) {
    if (i == 2 && json.null()) {
      no_edge = true;
      return;
    }
    const GenId id = read_id(json, container_id, last_id);
    if (i < ids.size()) ids[i] = id;
  });
  const char* fault = nullptr;
  Step step;
  if (no_edge && count == 3) {
    step = Appear{ids[0], ids[1], std::nullopt};
    fault = fault_of(std::get<Appear>(step));
  } else if (!no_edge && count == 2) {
    step = Hide{ids[0], ids[1]};
    fault = fault_of(std::get<Hide>(step));
  } else if (!no_edge && count == 4) {
    const Quad edge{ids[0], ids[1], ids[2], ids[3]};
    step = canonical(edge);
    if (!names_an_edge(edge)) fault = "names no edge: its generators are not distinct";
  } else if (!no_edge && count == 6) {
    step = Appear{ids[0], ids[1], Quad{ids[2], ids[3], ids[4], ids[5]}};
    fault = fault_of(std::get<Appear>(step));
  } else {
    fault = "neither a flip, a hide nor an appear";
  }
  if (fault != nullptr) json.fail(fault);
  return step;
}

std::vector<Step> read_steps(JsonReader& json, int last_id) {
  std::vector<Step> steps;
  json.array([&](std::size_t) { steps.push_back(read_step(json, last_id)); });
  return steps;
}

Point2 read_point(JsonReader& json) {
  Point2 point;
  json.array_of<2>([&](std::size_t i) { (i == 0 ? point.x : point.y) = json.number().value(); });
  return point;
}

WorldEnd read_end(JsonReader& json, const Rational& horizon) {
  static constexpr std::array<std::string_view, 8> names = {
      "t", "flips", "hides", "appears", "swaps", "jumps", "collisions", "maneuvers"};
  WorldEnd end;
  WorldCounts& counts = end.counts;
  const std::array<std::int64_t*, 7> of_names = {
      &counts.flips, &counts.hides,      &counts.appears,  &counts.swaps,
      &counts.jumps, &counts.collisions, &counts.maneuvers};
  json.object(names, (std::uint32_t{1} << names.size()) - 1, [&](std::size_t member) {
    if (member == 0)
      read_end_time(json, horizon);
    else
      *of_names[member - 1] = json.integer(0, max_count);
  });
  return end;
}

WorldStop read_stop(JsonReader& json) {
  enum { t, reason };
  static constexpr std::array<std::string_view, 2> names = {"t", "reason"};
  WorldStop stop;
  json.object(names, bit(t) | bit(reason), [&](std::size_t member) {
    if (member == t)
      stop.t = read_time(json).value();
    else
      stop.reason = json.text();
  });
  return stop;
}

// Finds out the kind of a line, and whether it has the members of that kind.
void check_members(const JsonReader& json, Line& line) {
  const Kind* found = nullptr;
  for (const Kind& kind : kinds) {
    if (!(line.seen & bit(kind.member))) continue;
    if (found != nullptr) json.fail("more than one event");
    found = &kind;
  }
  if (found == nullptr) json.fail("neither an event nor an end line");
  line.kind = found->member;
  if (found->required & ~line.seen) json.fail_in("t", "missing");
  const std::uint32_t strange =
      line.seen & ~(bit(found->member) | found->required | found->allowed);
  for (std::size_t i = 0; i < member_names.size(); ++i) {
    if (strange & bit(i))
      json.fail_in(std::string(member_names[i]),
                   "no field of a line with \"" + std::string(member_names[line.kind]) + '"');
  }
}

// Puts an appear of the jumping disk before the steps in.
void complete_jump(const JsonReader& json, Line& line) {
  if (!(line.seen & bit(at))) {
    if (line.in && !line.in->empty()) json.fail_in("at", "missing: the disk does not appear first");
    return;
  }
  if (!line.in) json.fail_in("in", "missing beside \"at\"");
  line.in->insert(line.in->begin(),
                  Appear{line.disk, line.at ? line.at->l : container_id, line.at});
}

void read_member(JsonReader& json, std::size_t member, Line& line, int last_id,
                 const Rational& horizon) {
  switch (member) {
    case t:
      line.time = read_time(json).value();
      break;
    case flip:
      line.edge = canonical(read_edge(json, last_id));
      break;
    case hide:
    case appear:
    case swap:
      json.array_of<2>([&](std::size_t i) { line.pair[i] = read_id(json, container_id, last_id); });
      if (member == swap && !(0 <= line.pair[0] && line.pair[0] < line.pair[1]))
        json.fail("not two ids of disks, the smaller first");
      break;
    case at:
      if (!json.null()) line.at = read_edge(json, last_id);
      break;
    case maneuver:
    case jump:
      line.disk = read_id(json, 0, last_id);
      break;
    case out:
      line.out = read_steps(json, last_id);
      break;
    case in:
      line.in = read_steps(json, last_id);
      break;
    case v:
      line.velocity = read_point(json);
      break;
    case p:
      line.center = read_point(json);
      break;
    case growth:
      line.growth = json.number().value();
      break;
    case r:
      line.radius = json.number().value();
      if (*line.radius < 0) json.fail("negative");
      break;
    case end:
      line.ending = read_end(json, horizon);
      break;
    case stopped: {
      WorldStop stop = read_stop(json);
      line.time = stop.t;
      line.ending = std::move(stop);
    }
  }
}

// Precondition: the line has an event.
WorldEvent event_of(const JsonReader& json, Line& line) {
  const auto check = [&](const char* fault, Member member) {
    if (fault != nullptr) json.fail_in(std::string(member_names[member]), fault);
  };
  switch (line.kind) {
    case flip:
      return {line.time, line.edge};
    case hide: {
      const Hide event{line.pair[0], line.pair[1]};
      check(fault_of(event), hide);
      return {line.time, event};
    }
    case appear: {
      if ((line.seen & bit(at)) && !line.at) check("null: where there is none, it is left out", at);
      const Appear event{line.pair[0], line.pair[1], line.at};
      check(fault_of(event), line.at ? at : appear);
      return {line.time, event};
    }
    case swap:
      return {line.time, Swap{line.pair[0], line.pair[1]}};
    case maneuver:
      return {line.time, PathTurn{line.disk, line.velocity, line.center, line.growth}};
    default: {
      complete_jump(json, line);
      Jump event{line.disk,   std::move(line.out), std::move(line.in),
                 line.center, line.velocity,       line.radius};
      check(fault_of(event, line.time), line.at ? at : jump);
      return {line.time, std::move(event)};
    }
  }
}

}  // namespace

WorldHistoryReader::WorldHistoryReader(const std::string& path, int disk_count,
                                       const std::string& scene_sha256)
    : path_(path), lines_(path_), last_id_(disk_count - 1) {
  lines_.keep_digest();
  const auto text = lines_.next(max_world_line);
  if (!text) throw InputError(path_, 1, "", "empty file");
  of_this_version(
      *text, path_, "voroproof-history", [&] { read_header(*text, scene_sha256); }, world_version);
}

void WorldHistoryReader::read_header(std::string_view text, const std::string& wanted_sha256) {
  JsonReader json(text, path_, lines_.number());
  HistoryHeader header = read_history_header(json, world_version, last_id_, wanted_sha256);
  if (!header.initial) json.fail_in("initial", "missing");
  header_ = {std::move(header.scene_sha256), std::move(header.horizon), std::move(header.producer),
             *std::move(header.initial)};
  horizon_ = round_nearest(header_.horizon);
}

std::optional<WorldEvent> WorldHistoryReader::next() {
  if (ending_) return std::nullopt;
  const auto text = lines_.next(max_world_line);
  if (!text)
    throw InputError(path_, lines_.number(), "", "incomplete: the file ends without an end line");
  JsonReader json(*text, path_, lines_.number());
  Line line;
  Extensions extensions;  // read and dropped
  line.seen = json.object(
      member_names, 0,
      [&](std::size_t member) { read_member(json, member, line, last_id_, header_.horizon); },
      &extensions);
  json.finish();
  check_members(json, line);
  if (line.kind != end) check_time(line.time, line.kind == stopped ? "stopped" : "t");
  if (line.ending) {
    if (lines_.next(max_world_line))
      throw InputError(path_, lines_.number(), "", "text after the last line of the history");
    ending_ = std::move(line.ending);
    return std::nullopt;
  }
  WorldEvent event = event_of(json, line);
  counts_.add(event);
  EventLimit::check(counts_.all());
  return event;
}

void WorldHistoryReader::check_time(const Rational& t, const char* field) {
  if (t < last_t_)
    throw InputError(path_, lines_.number(), field, "earlier than the event before it");
  // Rounding an event at the horizon may move it beyond, but not beyond the rounded horizon.
  if (round_nearest(t) > horizon_)
    throw InputError(path_, lines_.number(), field, "beyond the horizon");
  last_t_ = t;
}

bool WorldHistoryReader::counts_match() const {
  const auto* end = std::get_if<WorldEnd>(&ending());
  return end == nullptr || end->counts == counts_;
}

}  // namespace voroproof::internal
