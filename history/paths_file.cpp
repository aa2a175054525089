#include "history/paths_file.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "history/error.h"
#include "history/file_bytes.h"
#include "history/json_text.h"

namespace voroproof::internal {

namespace {

// Makes the disk stand before its first waypoint and after its last.
void stay(GivenPath& path, const Rational& begin, const Rational& end) {
  std::vector<Waypoint>& w = path.waypoints;
  const bool is_curved = !path.curves.empty();
  if (w.front().t > begin) {
    path.stays_before = true;
    w.insert(w.begin(), {begin, Vec3(w.front().at)});
    if (is_curved) path.curves.insert(path.curves.begin(), Curve());
  }
  if (w.back().t < end) {
    path.stays_after = true;
    w.push_back({end, Vec3(w.back().at)});
    if (is_curved) path.curves.emplace_back();
  }
}

// Where pieces of a path do not meet.
void take_jumps(GivenPaths& given) {
  std::size_t jumps = 0;
  Rational longest2;
  for (const GivenPath& p : given.paths) {
    for (std::size_t k = 1; k < p.waypoints.size(); ++k) {
      if (p.waypoints[k].t != p.waypoints[k - 1].t) continue;
      ++jumps;
      const Vec3 way = p.waypoints[k].at - p.waypoints[k - 1].at;
      longest2 = std::max<Rational>(longest2, dot(way, way));
    }
  }
  if (jumps == 0) return;
  given.remarks.push_back(std::to_string(jumps) +
                          " pieces begin elsewhere than the one before ends, by up to " +
                          number_text(std::sqrt(round_nearest(longest2))) +
                          ": the disk is taken to go there straight, at once");
}

// Where the paths do not all begin and end together.
void take_beyond(GivenPaths& given, Beyond beyond, const std::string& file) {
  if (given.paths.empty()) return;
  const auto [begin, end] = time_of(given.paths);
  std::size_t others = 0;
  for (GivenPath& p : given.paths) {
    const std::vector<Waypoint>& w = p.waypoints;
    if (w.front().t == begin && w.back().t == end) continue;
    ++others;
    if (beyond == Beyond::unsaid) {
      throw InputError(file, 0, "disk " + printable(p.name),
                       "has waypoints from t = " + w.front().t.get_str() + " to " +
                           w.back().t.get_str() + ", and the file from " + begin.get_str() +
                           " to " + end.get_str() +
                           ": say by --stay or --vanish where it is meanwhile");
    }
    if (beyond == Beyond::vanishes) continue;
    stay(p, begin, end);
  }
  if (others == 0) return;
  given.remarks.push_back(std::to_string(others) + " of " + std::to_string(given.paths.size()) +
                          (beyond == Beyond::stays
                               ? " disks are taken to stay where they are before their first "
                                 "waypoint and after their last (--stay)"
                               : " disks are taken to be nowhere before their first waypoint and "
                                 "after their last (--vanish)"));
}

}  // namespace

std::optional<Rational> path_number(const std::string& text, std::string& reason) {
  auto value = parse_rational(text, &reason);
  if (!value) return std::nullopt;
  static const Rational least = to_rational(min_scene_value), most = to_rational(max_scene_value);
  const Rational magnitude = abs(*value);
  if (magnitude != 0 && (magnitude < least || magnitude > most)) {
    reason = "not zero, and not from 1e-100 to 1e100 in magnitude";
    return std::nullopt;
  }
  return value;
}

void note_missing_frames(GivenPaths& given) {
  std::vector<const Rational*> frames;
  for (const GivenPath& p : given.paths) {
    for (const Waypoint& w : p.waypoints) frames.push_back(&w.t);
  }
  const auto is_less = [](const Rational* a, const Rational* b) { return *a < *b; };
  std::sort(frames.begin(), frames.end(), is_less);
  const auto is_same = [](const Rational* a, const Rational* b) { return *a == *b; };
  frames.erase(std::unique(frames.begin(), frames.end(), is_same), frames.end());
  std::size_t others = 0;
  std::string first;
  for (const GivenPath& p : given.paths) {
    const std::size_t begin = p.stays_before ? 1 : 0,
                      end = p.waypoints.size() - (p.stays_after ? 1 : 0);
    auto frame = std::lower_bound(frames.begin(), frames.end(), &p.waypoints[begin].t, is_less);
    for (std::size_t k = begin; k < end; ++k) {
      if (k > begin && p.waypoints[k].t == p.waypoints[k - 1].t) continue;
      if (p.waypoints[k].t == **frame) {
        ++frame;
        continue;
      }
      if (++others == 1)
        first = "disk " + printable(p.name) + " at t = " + number_text(round_nearest(**frame));
      break;
    }
  }
  if (others == 0) return;
  given.missing.push_back(std::to_string(others) + " of " + std::to_string(given.paths.size()) +
                          " disks have no waypoint at an instant of others, " + first +
                          " (--frames-only)");
}

std::vector<int> disks_of(const std::vector<GivenPath>& paths) {
  std::vector<int> disks;
  for (const GivenPath& path : paths)
    disks.push_back(disks.empty() ? 0 : disks.back() + (path.goes_on ? 0 : 1));
  return disks;
}

std::pair<Rational, Rational> time_of(const std::vector<GivenPath>& paths) {
  std::pair<Rational, Rational> time{paths.front().waypoints.front().t,
                                     paths.front().waypoints.back().t};
  for (const GivenPath& p : paths) {
    time.first = std::min(time.first, p.waypoints.front().t);
    time.second = std::max(time.second, p.waypoints.back().t);
  }
  return time;
}

void require_straight_in_plane(const GivenPaths& given, const std::string& file) {
  const auto refuse = [&](const char* field, const char* reason) {
    throw InputError(file, 0, field, reason);
  };
  if (given.in_space) refuse("z", "the disks of a scene move in a plane");
  if (given.is_periodic()) refuse("periodic", "the disks of a scene have no images");
  for (const GivenPath& path : given.paths) {
    if (!path.curves.empty()) refuse("duration", "the disks of a scene move on straight ways");
  }
}

GivenPaths read_paths(const std::string& path, const std::optional<Rational>& radius,
                      Beyond beyond) {
  const std::string head = file_bytes(path, 4096, true);
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  const bool is_xml = first != std::string::npos && head[first] == '<';
  GivenPaths given = is_xml ? parse_ccbs_log(file_bytes(path, max_scene_bytes), path, radius)
                            : read_path_table(path, radius);
  take_jumps(given);
  take_beyond(given, beyond, path);
  return given;
}

}  // namespace voroproof::internal
