// Files of given paths: tables of waypoints, and plans of continuous-time multi-agent path finders.
//
// Such files have no events. What is said of them is said of the piecewise linear paths between
// their waypoints: from each to the next with constant velocity (docs/others.md).
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "exact/generators.h"
#include "history/scene.h"

namespace voroproof::internal {

struct Waypoint {
  Rational t;
  Point2 at;
};

// That with which the one leads to the other.
inline Point2 velocity(const Waypoint& a, const Waypoint& b) {
  const Rational dt = b.t - a.t;
  return {(b.at.x - a.at.x) / dt, (b.at.y - a.at.y) / dt};
}

// A disk is there from the time of its first waypoint to that of its last.
struct GivenPath {
  std::string name;  // as in the file
  Rational radius;
  std::vector<Waypoint> waypoints;  // one at least, of increasing times
};

// Two disks, or the container (-1) and a disk, i < j, touch at t, whatever rounded waypoints say.
struct GivenContact {
  GenId i, j;
  Rational t;
  bool operator<(const GivenContact& other) const {
    return std::tie(i, j, t) < std::tie(other.i, other.j, other.t);
  }
};

// All paths are in it, where a file has one.
struct GivenContainer {
  Point2 center;
  Rational radius;
};

struct GivenPaths {
  std::vector<GivenPath> paths;  // in the order of their first lines
  std::set<GivenContact> contacts;
  std::optional<GivenContainer> container;
  std::vector<std::string> remarks;    // facts that the file cannot tell, and assumptions
  std::vector<std::string> missing{};  // who and what may come near and is not in the paths
  std::int64_t missing_line = 0;       // where the first of them stands in the file
  // The meaning of the paths, in words.
  std::string meaning = "the piecewise linear paths between the waypoints of the file";
};

// Where a disk is while others have waypoints and it has none yet, or no more.
enum class Beyond {
  unsaid,
  stays,     // at its first waypoint before that, and at its last one after it
  vanishes,  // nowhere
};

inline constexpr std::size_t max_waypoints = 20'000'000;
inline constexpr std::size_t max_remarks = 100;

// Reads a file of either kind: XML where its first character but for white space is '<', else a
// table. Numbers are exact: a decimal means what it says. `radius`: of all disks whose radius the
// file does not give. Comments "# remark: ..." of a table are among the remarks,
// "# missing: ..." among what is missing, whatever their blanks and capitals. With `beyond` stays
// all disks are there all the time. Throws InputError, also where that is unsaid and the paths do
// not all begin at one time and end at one time.
GivenPaths read_paths(const std::string& path, const std::optional<Rational>& radius,
                      Beyond beyond);

// From the first waypoint of all paths to the last, of one path at least.
std::pair<Rational, Rational> time_of(const std::vector<GivenPath>& paths);

// The two kinds as they stand, without an end that is not in them; `file` is for messages. Throw
// InputError.
GivenPaths read_waypoint_table(const std::string& path, const std::optional<Rational>& radius);
GivenPaths parse_ccbs_log(const std::string& bytes, const std::string& file,
                          const std::optional<Rational>& radius);

// A number of such a file, within the limits of scenes; nothing, with the reason, where it is none.
std::optional<Rational> path_number(const std::string& text, std::string& reason);

}  // namespace voroproof::internal
