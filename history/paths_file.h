// Files of given paths: tables of waypoints or of polynomial pieces, and plans of continuous-time
// multi-agent path finders.
//
// Such files have no events. What is said of them is said of the paths: between waypoints they lead
// from each to the next with constant velocity, on pieces they are polynomials in time
// (docs/others.md).
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "exact/billiard.h"
#include "exact/generators.h"
#include "exact/vector3.h"
#include "history/scene.h"

namespace voroproof::internal {

struct Waypoint {
  Rational t;
  Vec3 at;
};

// That with which the one leads to the other, of a later time.
inline Vec3 velocity(const Waypoint& a, const Waypoint& b) {
  return (b.at - a.at) * Rational(1 / Rational(b.t - a.t));
}

// A place as a polynomial: its coefficients, the constant one first.
using Curve = std::vector<Vec3>;

// Where it leads at s.
inline Vec3 place_on(const Curve& curve, const Rational& s) {
  Vec3 at{};
  for (std::size_t k = curve.size(); k-- > 0;) at = at * s + curve[k];
  return at;
}

// A disk is there from the time of its first waypoint to that of its last. It may go on with the
// next path.
struct GivenPath {
  std::string name;  // as in the file
  Rational radius;   // at time 0
  // One at least, of increasing times. Two have one time where the disk jumps.
  std::vector<Waypoint> waypoints;
  // How it moves from each waypoint to the next, by the time since then; none where all ways are
  // straight. A jump is a straight way that takes no time.
  std::vector<Curve> curves{};
  Rational growth{};  // by how much the radius grows in a unit of time
  // Whether its first waypoint, or its last, is none of the file: it is taken to stay until the
  // next one, or from the one before.
  bool stays_before = false, stays_after = false;
  // Whether it is there no more at the time of its last waypoint, as it leaves or jumps then.
  bool ends_open = false;
  // Whether it is the same disk as that of the path before, which ends when this one begins.
  bool goes_on = false;

  Rational radius_at(const Rational& t) const { return radius + growth * t; }
  // From the first waypoint to the last.
  Rational greatest_radius() const {
    return std::max(radius_at(waypoints.front().t), radius_at(waypoints.back().t));
  }
};

// Two disks, or the container or a wall (-1, -2, ...) and a disk, i < j, touch at t, whatever
// rounded waypoints say.
struct GivenContact {
  GenId i, j;
  Rational t;
  LatticeImage image{};  // the one of j, in a periodic box
  bool operator<(const GivenContact& other) const {
    return std::tie(i, j, t, image) < std::tie(other.i, other.j, other.t, other.image);
  }
};

struct GivenPaths {
  std::vector<GivenPath> paths;  // in the order of their first lines
  std::set<GivenContact> contacts;
  std::optional<RoundFrame> container;  // all paths are in it, where a file has one
  std::vector<BilliardWall> walls{};    // or before these: -1, -2, ... in this order
  bool in_space = false;                // else all third coordinates are zero
  // Sides of the box whose images the disks have; zero where an axis is not periodic.
  Vec3 sides{};
  std::vector<std::string> remarks;    // facts that the file cannot tell, and assumptions
  std::vector<std::string> missing{};  // who and what may come near and is not in the paths
  std::int64_t missing_line = 0;       // where the first of them stands in the file
  // The meaning of the paths, in words.
  std::string meaning = "the piecewise linear paths between the waypoints of the file";

  bool is_periodic() const { return sides[0] != 0 || sides[1] != 0 || sides[2] != 0; }
};

// Where a disk is while others have waypoints and it has none yet, or no more.
enum class Beyond {
  unsaid,
  stays,     // at its first waypoint before that, and at its last one after it
  vanishes,  // nowhere
};

inline constexpr std::size_t max_waypoints = 20'000'000;
inline constexpr std::size_t max_remarks = 100;

// Reads a file of any kind: XML where its first character but for white space is '<', else a table.
// Numbers are exact: a decimal means what it says. `radius`: of all disks whose radius the file
// does not give. With `beyond` stays all disks are there all the time. Throws InputError, also
// where that is unsaid and the paths do not all begin at one time and end at one time.
GivenPaths read_paths(const std::string& path, const std::optional<Rational>& radius,
                      Beyond beyond);

// Notes as missing the disks that have no waypoint at some time at which others have one, while
// they are neither gone nor said to stay.
void note_missing_frames(GivenPaths& given);

// For each path the number of its disk, from 0.
std::vector<int> disks_of(const std::vector<GivenPath>& paths);

// From the first waypoint of all paths to the last, of one path at least.
std::pair<Rational, Rational> time_of(const std::vector<GivenPath>& paths);

// Throws InputError where the paths are not straight ways in the plane, without images: scenes with
// diagrams have no others.
void require_straight_in_plane(const GivenPaths& given, const std::string& file);

// The kinds as they stand, without an end that is not in them; `file` is for messages. Throw
// InputError.
//
// The columns of a table are disk, t, x, y and perhaps z and radius: a line is a waypoint. Or they
// are disk, t, duration, x^0, x^1, ..., y^0, ..., perhaps z^0, ... and radius: a line is a piece,
// on which x is the sum of x^k s^k for the time s since t; k is at most max_degree. Of the comments
// "# remark: ..." are among the remarks, "# missing: ..." among what is missing, and
// "# periodic: 10,10" gives the sides of a periodic box, "none" for an axis without one.
inline constexpr int max_degree = 7;
GivenPaths read_path_table(const std::string& path, const std::optional<Rational>& radius);
GivenPaths parse_ccbs_log(const std::string& bytes, const std::string& file,
                          const std::optional<Rational>& radius);

// A number of such a file, within the limits of scenes; nothing, with the reason, where it is none.
std::optional<Rational> path_number(const std::string& text, std::string& reason);

}  // namespace voroproof::internal
