#include "history/validate.h"

#include <cstdint>
#include <optional>
#include <string_view>

#include "history/billiard.h"
#include "history/billiard_history.h"
#include "history/diagram_file.h"
#include "history/disk_file.h"
#include "history/error.h"
#include "history/evtsq_reader.h"
#include "history/file_format.h"
#include "history/history_reader.h"
#include "history/json_text.h"
#include "history/plan_file.h"
#include "history/scene.h"
#include "history/world.h"
#include "history/world_history_reader.h"

namespace voroproof::internal {
namespace {

bool is(bool (*of_format)(const std::string& path), const std::string& path) {
  try {
    return of_format(path);
  } catch (const InputError&) {
    return false;
  }
}

std::string count(std::int64_t number, const std::string& one, const std::string& several) {
  return std::to_string(number) + ' ' + (number == 1 ? one : several);
}

template <class List>
std::string count(const List& list, const std::string& one, const std::string& several) {
  return count(static_cast<std::int64_t>(list.size()), one, several);
}

std::string text_of(const HistoryCounts& counts) {
  return count(counts.flips, "flip", "flips") + ", " +
         count(counts.collisions, "collision", "collisions") + ", " +
         count(counts.maneuvers, "maneuver", "maneuvers");
}

std::string text_of(const WorldCounts& counts) {
  return count(counts.flips, "flip", "flips") + ", " + count(counts.hides, "hide", "hides") + ", " +
         count(counts.appears, "appear", "appears") + ", " + count(counts.swaps, "swap", "swaps") +
         ", " + count(counts.jumps, "jump", "jumps") + ", " +
         count(counts.maneuvers, "maneuver", "maneuvers");
}

// Reads the events to the last one, and says how many of each kind there are.
template <class History>
std::string events_of(History& history) {
  while (history.next()) {
  }
  return text_of(history.counts());
}

template <class Stop, class History>
std::string validate_history(const std::string& path, const std::string& name) {
  History history(path);
  const std::string events = events_of(history);
  if (const auto* stop = std::get_if<Stop>(&history.ending()))
    return name + ": " + events + ", stopped at t = " + number_text(stop->t) + ": " +
           printable(stop->reason);
  if (!history.counts_match())
    throw InputError(path, history.line(), "end", "wrong counts: the file has " + events);
  return name + ": " + events + ", complete to t = " + number_text(history.header().horizon);
}

template <class Scene>
std::string summary(const Scene& scene) {
  return count(scene.disks, "disk", "disks") + ", " +
         count(scene.maneuvers, "maneuver", "maneuvers") + ", horizon " +
         number_text(scene.horizon);
}

// Whether the history's first line has a diagram: those of worlds have one, those of billiards
// none.
bool has_initial(const std::string& path) {
  LineSource lines(path);
  const auto text = lines.next(max_header_line);
  bool found = false;
  if (!text) return found;
  JsonReader json(*text, path);
  json.any_object([&](std::string_view name) {
    found = found || name == "initial";
    json.any();
    return !found;
  });
  return found;
}

std::string validate_second_version(const std::string& path) {
  return has_initial(path)
             ? validate_history<WorldStop, WorldHistoryReader>(path, "history of a world")
             : validate_history<HistoryStop, BilliardHistoryReader>(path, "history of a billiard");
}

// Without its disks an event sequence cannot say which ids are right; with them, certify reads it.
std::string validate_event_sequence(const std::string& path) {
  const auto history = open_evtsq(path, std::nullopt, std::nullopt).history;
  const std::string events = events_of(*history);
  if (!history->counts_match()) {
    throw InputError(path, history->line(), "number of events",
                     "wrong: the file has more lines of events");
  }
  return "event sequence: " + events +
         ", complete to t = " + number_text(history->header().horizon) +
         " (its disks are in another file)";
}

}  // namespace

bool is_history_file(const std::string& path) {
  return is(is_evtsq_file, path) || format_at_beginning(path).name == "voroproof-history";
}

bool is_scene_file(const std::string& path) {
  return (is(is_disk_file, path) && !is(is_evtsq_file, path)) ||
         format_at_beginning(path).name == "voroproof-scene";
}

std::string validate_file(const std::string& path) {
  if (is_disk_file(path)) {
    // Both formats may begin with comments; an event sequence names its version in one.
    if (is_evtsq_file(path)) return validate_event_sequence(path);
    return "disk file: " + count(read_disk_file(path).ids, "disk", "disks");
  }
  const FileFormat format = format_of_file(path);
  if (format.name == "voroproof-scene") {
    if (is_billiard_file(path)) return "billiard: " + summary(read_billiard(path));
    return is_of_worlds(format) ? "world: " + summary(read_world(path))
                                : "scene: " + summary(read_scene(path));
  }
  if (format.name == "voroproof-history") {
    return is_of_worlds(format) ? validate_second_version(path)
                                : validate_history<HistoryStop, HistoryReader>(path, "history");
  }
  if (format.name == "voroproof-plan") {
    const PlanTask task = read_plan(path);
    return "plan: " + count(task.vehicles, "vehicle", "vehicles") + ", clearance " +
           number_text(task.clearance) + ", arrive " + number_text(task.arrive);
  }
  if (format.name == "voroproof-diagram") {
    const DiagramFile diagram = read_diagram(path);
    return "diagram: " + count(diagram.disks, "disk", "disks") + ", " +
           count(diagram.vertices, "vertex", "vertices") + ", " +
           count(diagram.edges, "edge", "edges");
  }
  throw InputError(path, format.line, "format",
                   "none that can be validated: " + printable(format.name));
}

}  // namespace voroproof::internal
