#include "history/paths_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "history/error.h"
#include "history/file_bytes.h"
#include "history/line_source.h"

namespace voroproof::internal {

namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 16;
constexpr std::size_t kLongestRemark = 1000;
constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// The word before the colon of a comment, in small letters, and the text after it.
std::pair<std::string, std::string_view> told(std::string_view comment) {
  comment.remove_prefix(std::min(comment.find_first_not_of("# \t\r"), comment.size()));
  const std::size_t colon = comment.find(':');
  if (colon == std::string_view::npos) return {};
  std::string word(trimmed(comment.substr(0, colon)));
  for (char& c : word) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return {word, comment.substr(colon + 1)};
}

std::vector<std::string> cells(std::string_view line) {
  std::vector<std::string> all;
  while (true) {
    const std::size_t comma = line.find(',');
    all.emplace_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return all;
    line.remove_prefix(comma + 1);
  }
}

// A table of waypoints, line by line.
class TableReader {
 public:
  TableReader(const std::string& path, const std::optional<Rational>& radius)
      : path_(path), radius_(radius), lines_(path) {}

  GivenPaths read() {
    while (const auto line = lines_.next(kLongestLine)) {
      const std::string_view text = trimmed(*line);
      if (text.empty()) continue;
      if (text.front() == '#') {
        take_comment(text);
      } else if (columns_.empty()) {
        take_heading(cells(text));
      } else {
        take_row(cells(text));
      }
    }
    if (columns_.empty()) fail("", "no heading; it is disk,t,x,y or disk,t,x,y,radius");
    return std::move(read_);
  }

 private:
  void take_comment(std::string_view comment) {
    const auto [word, text] = told(comment);
    if (word == "remark") take_remark(text, read_.remarks);
    if (word != "missing") return;
    if (read_.missing.empty()) read_.missing_line = lines_.number();
    take_remark(text, read_.missing);
  }

  // Takes a remark of the table's author. It is repeated wherever something is said of the paths.
  void take_remark(std::string_view text, std::vector<std::string>& remarks) const {
    if (remarks.size() == max_remarks) fail("remark", "too many");
    remarks.push_back(printable(trimmed(text), kLongestRemark));
  }

  void take_heading(const std::vector<std::string>& names) {
    for (std::size_t k = 0; k < names.size(); ++k) {
      const bool known = names[k] == "disk" || names[k] == "t" || names[k] == "x" ||
                         names[k] == "y" || names[k] == "radius";
      if (!known) fail(printable(names[k]), "no such column; they are disk, t, x, y and radius");
      if (!columns_.emplace(names[k], k).second) fail(names[k], "this column occurs twice");
    }
    for (const char* needed : {"disk", "t", "x", "y"}) {
      if (!columns_.contains(needed)) fail(needed, "this column is missing");
    }
    if (!columns_.contains("radius") && !radius_) {
      fail("radius", "the file has no such column, and no radius is given");
    }
  }

  void take_row(const std::vector<std::string>& row) {
    if (row.size() != columns_.size()) {
      fail("", std::to_string(row.size()) + " fields, not the " + std::to_string(columns_.size()) +
                   " of the heading");
    }
    if (++rows_ > max_waypoints) fail("", "too many waypoints");
    const std::string& name = row[columns_["disk"]];
    if (name.empty()) fail("disk", "no name");
    Waypoint w{number(row, "t"), {number(row, "x"), number(row, "y")}};
    const Rational radius = columns_.contains("radius") ? number(row, "radius") : *radius_;
    if (sgn(radius) < 0) fail("radius", "negative");
    const auto [known, is_new] = index_.emplace(name, read_.paths.size());
    if (is_new) read_.paths.push_back({name, radius, {}});
    GivenPath& path = read_.paths[known->second];
    if (path.radius != radius) fail("radius", "another than before for this disk");
    if (!path.waypoints.empty() && w.t <= path.waypoints.back().t) {
      fail("t", "no later than the waypoint before of this disk");
    }
    path.waypoints.push_back(std::move(w));
  }

  Rational number(const std::vector<std::string>& row, const char* column) {
    std::string reason;
    const auto value = path_number(row[columns_[column]], reason);
    if (!value) fail(column, reason);
    return *value;
  }

  [[noreturn]] void fail(const std::string& field, const std::string& reason) const {
    throw InputError(path_, lines_.number(), field, reason);
  }

  const std::string& path_;
  const std::optional<Rational>& radius_;
  LineSource lines_;
  std::map<std::string, std::size_t> columns_, index_;
  std::size_t rows_ = 0;
  GivenPaths read_;
};

// Where the paths do not all begin and end together.
void take_beyond(GivenPaths& given, Beyond beyond, const std::string& file) {
  if (given.paths.empty()) return;
  const auto [begin, end] = time_of(given.paths);
  std::size_t others = 0;
  for (GivenPath& p : given.paths) {
    std::vector<Waypoint>& w = p.waypoints;
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
    if (w.front().t > begin) w.insert(w.begin(), {begin, Point2(w.front().at)});
    if (w.back().t < end) w.push_back({end, Point2(w.back().at)});
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

std::pair<Rational, Rational> time_of(const std::vector<GivenPath>& paths) {
  std::pair<Rational, Rational> time{paths.front().waypoints.front().t,
                                     paths.front().waypoints.back().t};
  for (const GivenPath& p : paths) {
    time.first = std::min(time.first, p.waypoints.front().t);
    time.second = std::max(time.second, p.waypoints.back().t);
  }
  return time;
}

GivenPaths read_waypoint_table(const std::string& path, const std::optional<Rational>& radius) {
  return TableReader(path, radius).read();
}

GivenPaths read_paths(const std::string& path, const std::optional<Rational>& radius,
                      Beyond beyond) {
  const std::string head = file_bytes(path, 4096, true);
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  const bool is_xml = first != std::string::npos && head[first] == '<';
  GivenPaths given = is_xml ? parse_ccbs_log(file_bytes(path, max_scene_bytes), path, radius)
                            : read_waypoint_table(path, radius);
  take_beyond(given, beyond, path);
  return given;
}

}  // namespace voroproof::internal
