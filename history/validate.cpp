#include "history/validate.h"

#include <cstdint>
#include <optional>
#include <string_view>

#include "history/diagram_file.h"
#include "history/disk_file.h"
#include "history/error.h"
#include "history/evtsq_reader.h"
#include "history/file_bytes.h"
#include "history/history_reader.h"
#include "history/json_reader.h"
#include "history/json_text.h"
#include "history/plan_file.h"
#include "history/scene.h"

namespace voroproof::internal {
namespace {

constexpr std::size_t beginning = 4096;  // bytes, in which the field "format" is as a rule

// The member "format" of the object that the text starts with. What comes after it may be anything.
std::optional<FileFormat> format_of(std::string_view text, const std::string& path) {
  JsonReader json(text, path);
  std::optional<FileFormat> format;
  json.any_object([&](std::string_view name) {
    if (name == "format") {
      format = {std::string(json.text()), json.line()};
      return false;
    }
    json.any();
    return true;
  });
  return format;
}

// The format that the first bytes name, if they do.
std::string format_at_beginning(const std::string& path) {
  try {
    const auto format = format_of(file_bytes(path, beginning, true), path);
    return format ? format->name : "";
  } catch (const InputError&) {
    return {};
  }
}

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

// Reads the events to the last one, and says how many of each kind there are.
template <class History>
std::string events_of(History& history) {
  while (history.next()) {
  }
  const HistoryCounts& counts = history.counts();
  return count(counts.flips, "flip", "flips") + ", " +
         count(counts.collisions, "collision", "collisions") + ", " +
         count(counts.maneuvers, "maneuver", "maneuvers");
}

std::string validate_history(const std::string& path) {
  HistoryReader history(path);
  const std::string events = events_of(history);
  if (const auto* stop = std::get_if<HistoryStop>(&history.ending()))
    return "history: " + events + ", stopped at t = " + number_text(stop->t) + ": " +
           printable(stop->reason);
  if (!history.counts_match())
    throw InputError(path, history.line(), "end", "wrong counts: the file has " + events);
  return "history: " + events + ", complete to t = " + number_text(history.header().horizon);
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

FileFormat format_of_text(std::string_view text, const std::string& path) {
  if (const auto format = format_of(text, path)) return *format;
  throw InputError(path, 1, "format", "missing");
}

// As a rule the field comes first. Only if it does not, more than the beginning is looked at.
FileFormat format_of_file(const std::string& path) {
  const std::string bytes = file_bytes(path, beginning, true);
  if (bytes.size() < beginning) return format_of_text(bytes, path);
  try {
    if (const auto format = format_of(bytes, path)) return *format;
  } catch (const InputError&) {
    // The fault may be the cut.
  }
  return format_of_text(file_bytes(path, max_scene_bytes, true), path);
}

bool is_history_file(const std::string& path) {
  return is(is_evtsq_file, path) || format_at_beginning(path) == "voroproof-history";
}

bool is_scene_file(const std::string& path) {
  return (is(is_disk_file, path) && !is(is_evtsq_file, path)) ||
         format_at_beginning(path) == "voroproof-scene";
}

std::string validate_file(const std::string& path) {
  if (is_disk_file(path)) {
    // Both formats may begin with comments; an event sequence names its version in one.
    if (is_evtsq_file(path)) return validate_event_sequence(path);
    return "disk file: " + count(read_disk_file(path).ids, "disk", "disks");
  }
  const FileFormat format = format_of_file(path);
  if (format.name == "voroproof-scene") {
    const Scene scene = read_scene(path);
    return "scene: " + count(scene.disks, "disk", "disks") + ", " +
           count(scene.maneuvers, "maneuver", "maneuvers") + ", horizon " +
           number_text(scene.horizon);
  }
  if (format.name == "voroproof-history") return validate_history(path);
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
