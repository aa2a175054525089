// Tables of waypoints and of polynomial pieces, line by line.
#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "history/error.h"
#include "history/line_source.h"
#include "history/paths_file.h"

namespace voroproof::internal {

namespace {

constexpr std::size_t longest_line = std::size_t{1} << 16;
constexpr std::size_t longest_remark = 1000;
constexpr std::string_view blanks = " \t\r";
constexpr std::string_view axes = "xyz";
// No disk is further from the first box of a periodic table, in sides.
constexpr int most_sides = 100'000'000;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
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

// No place of the path is further from zero along the axis.
Rational farthest(const GivenPath& path, std::size_t axis) {
  Rational most;
  for (const Waypoint& w : path.waypoints) most = std::max<Rational>(most, abs(w.at[axis]));
  for (std::size_t k = 0; k < path.curves.size(); ++k) {
    const Rational duration = path.waypoints[k + 1].t - path.waypoints[k].t;
    Rational sum, power = 1;
    for (const Vec3& c : path.curves[k]) {
      sum += abs(c[axis]) * power;
      power *= duration;
    }
    most = std::max<Rational>(most, sum);
  }
  return most;
}

class TableReader {
 public:
  TableReader(const std::string& path, const std::optional<Rational>& radius)
      : path_(path), radius_(radius), lines_(path) {}

  GivenPaths read() {
    while (const auto line = lines_.next(longest_line)) {
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
    if (periodic_) take_sides();
    return std::move(read_);
  }

 private:
  void take_comment(std::string_view comment) {
    const auto [word, text] = told(comment);
    if (word == "remark") take_remark(text, read_.remarks);
    if (word == "periodic") {
      if (periodic_) fail("periodic", "a second time");
      periodic_ = {lines_.number(), cells(text)};
    }
    if (word != "missing") return;
    if (read_.missing.empty()) read_.missing_line = lines_.number();
    take_remark(text, read_.missing);
  }

  // Takes a remark of the table's author. It is repeated wherever something is said of the paths.
  void take_remark(std::string_view text, std::vector<std::string>& remarks) const {
    if (remarks.size() == max_remarks) fail("remark", "too many");
    remarks.push_back(printable(trimmed(text), longest_remark));
  }

  // The sides of the box, known only when the columns are.
  void take_sides() {
    const auto& [line, sides] = *periodic_;
    const auto refuse = [&, at = line](const std::string& reason) {
      throw InputError(path_, at, "periodic", reason);
    };
    if (sides.size() != dimension()) refuse("not one side for each axis of the table");
    for (std::size_t axis = 0; axis < sides.size(); ++axis) {
      if (sides[axis] == "none") continue;
      std::string reason;
      const auto side = path_number(sides[axis], reason);
      if (!side) refuse(reason);
      if (sgn(*side) <= 0) refuse("a side is not positive");
      read_.sides[axis] = *side;
      for (const GivenPath& path : read_.paths) {
        if (farthest(path, axis) > most_sides * *side)
          refuse("disk " + printable(path.name) + " is more than 1e8 sides away");
      }
    }
  }

  std::size_t dimension() const { return read_.in_space ? 3 : 2; }

  void take_heading(const std::vector<std::string>& names) {
    pieces_ = std::find(names.begin(), names.end(), "duration") != names.end();
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (!is_known(names[k])) {
        fail(printable(names[k]),
             pieces_
                 ? "no such column; they are disk, t, duration, x^0 to x^7, y^0 to y^7, z^0 to "
                   "z^7 and radius"
                 : "no such column; they are disk, t, x, y, z and radius, or with duration those "
                   "of polynomials");
      }
      if (!columns_.emplace(names[k], k).second) fail(names[k], "this column occurs twice");
    }
    read_.in_space = columns_.contains(pieces_ ? "z^0" : "z");
    std::vector<std::string> needed{"disk", "t"};
    for (std::size_t axis = 0; axis < dimension(); ++axis) {
      needed.emplace_back(1, axes[axis]);
      if (pieces_) needed.back() += "^0";
    }
    for (const std::string& name : needed) {
      if (!columns_.contains(name)) fail(name, "this column is missing");
    }
    if (!columns_.contains("radius") && !radius_) {
      fail("radius", "the file has no such column, and no radius is given");
    }
    if (pieces_) {
      take_powers();
      read_.meaning = "the piecewise polynomial paths of the file";
    }
  }

  bool is_known(const std::string& name) const {
    if (name == "disk" || name == "t" || name == "radius") return true;
    if (name.empty() || axes.find(name.front()) == std::string_view::npos)
      return pieces_ && name == "duration";
    if (!pieces_) return name.size() == 1;
    return name.size() == 3 && name[1] == '^' && name[2] >= '0' && name[2] <= '0' + max_degree;
  }

  // The columns of coefficients; a power without a column has the coefficient 0.
  void take_powers() {
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      for (int k = 0; k <= max_degree; ++k) {
        const std::string name = {axes[axis], '^', static_cast<char>('0' + k)};
        if (!columns_.contains(name)) continue;
        if (axis >= dimension()) fail(name, "without the column z^0");
        powers_.push_back({axis, static_cast<std::size_t>(k), name});
        degree_ = std::max(degree_, static_cast<std::size_t>(k));
      }
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
    const Rational radius = columns_.contains("radius") ? number(row, "radius") : *radius_;
    if (sgn(radius) < 0) fail("radius", "negative");
    const auto [known, is_new] = index_.emplace(name, read_.paths.size());
    if (is_new) read_.paths.push_back({name, radius, {}});
    GivenPath& path = read_.paths[known->second];
    if (path.radius != radius) fail("radius", "another than before for this disk");
    if (pieces_) {
      take_piece(row, path);
    } else {
      take_waypoint(row, path.waypoints);
    }
  }

  void take_waypoint(const std::vector<std::string>& row, std::vector<Waypoint>& waypoints) {
    Waypoint w{number(row, "t"), {number(row, "x"), number(row, "y")}};
    if (read_.in_space) w.at[2] = number(row, "z");
    if (!waypoints.empty() && w.t <= waypoints.back().t) {
      fail("t", "no later than the waypoint before of this disk");
    }
    waypoints.push_back(std::move(w));
  }

  void take_piece(const std::vector<std::string>& row, GivenPath& path) {
    const Rational t = number(row, "t"), duration = number(row, "duration");
    if (sgn(duration) <= 0) fail("duration", "not positive");
    Curve curve(degree_ + 1);
    for (const Power& power : powers_) {
      const Rational c = number(row, power.column);
      Rational part = abs(c);
      for (std::size_t k = 0; k < power.k; ++k) part *= duration;
      if (part > farthest_) fail(power.column, "leads further than 1e100");
      curve[power.k][power.axis] = c;
    }
    std::vector<Waypoint>& waypoints = path.waypoints;
    if (waypoints.empty()) {
      waypoints.push_back({t, curve[0]});
    } else if (t != waypoints.back().t) {
      fail("t", "not where the piece before of this disk ends");
    } else if (waypoints.back().at != curve[0]) {
      waypoints.push_back({t, curve[0]});
      path.curves.emplace_back();
    }
    Vec3 end = place_on(curve, duration);
    path.curves.push_back(std::move(curve));
    waypoints.push_back({Rational(t + duration), std::move(end)});
  }

  Rational number(const std::vector<std::string>& row, const std::string& column) {
    std::string reason;
    const auto value = path_number(row[columns_[column]], reason);
    if (!value) fail(column, reason);
    return *value;
  }

  [[noreturn]] void fail(const std::string& field, const std::string& reason) const {
    throw InputError(path_, lines_.number(), field, reason);
  }

  struct Power {
    std::size_t axis, k;
    std::string column;
  };

  const Rational farthest_ = to_rational(max_scene_value);
  const std::string& path_;
  const std::optional<Rational>& radius_;
  LineSource lines_;
  std::map<std::string, std::size_t> columns_, index_;
  bool pieces_ = false;        // else waypoints
  std::vector<Power> powers_;  // the columns of pieces
  std::size_t degree_ = 0;
  std::size_t rows_ = 0;
  std::optional<std::pair<std::int64_t, std::vector<std::string>>> periodic_;  // line and sides
  GivenPaths read_;
};

}  // namespace

GivenPaths read_path_table(const std::string& path, const std::optional<Rational>& radius) {
  return TableReader(path, radius).read();
}

}  // namespace voroproof::internal
