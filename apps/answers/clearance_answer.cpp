#include "apps/answers/clearance_answer.h"

#include <algorithm>

#include "history/error.h"
#include "history/json_text.h"
#include "library/planning/wall_clearance.h"

namespace voroproof::internal {
namespace {

// Tells of one approach, of two disks or of one to the container, all that it takes to check it by
// hand.
class Teller {
 public:
  explicit Teller(const GivenPaths& given) : given_(given) {}

  OrderedJson json(const Approach& a) const {
    OrderedJson json{{"t", a.t_width == 0 ? internal::json_of(a.t) : internal::json_of(time_of(a))},
                     {"disks", OrderedJson::array()}};
    if (a.i >= 0) json["disks"].push_back(disk_json(a.i, a.t, a.is_exact()));
    json["disks"].push_back(disk_json(a.j, a.t, a.is_exact()));
    if (is_at_flat_wall(a)) {
      json["wall"] = a.i;
    } else {
      json["distance_squared"] =
          a.distance2_width == 0
              ? internal::json_of(a.distance2)
              : internal::json_of(Enclosure{round_down(a.distance2),
                                            round_up(Rational(a.distance2 + a.distance2_width))});
    }
    json["gap"] = internal::json_of(gap(a));
    if (a.i >= 0 && given_.is_periodic()) json["image"] = image_of(a);
    return json;
  }

  std::string names(const Approach& a) const {
    if (a.i < 0) return name(a.j) + " " + wall_name(a);
    std::string image;
    if (a.image != LatticeImage{}) image = image_of(a).dump();
    return name(a.i) + " " + name(a.j) + image;
  }

  // The same for a table of comma-separated values.
  std::string cells(const Approach& a) const {
    std::string cells = a.i < 0 ? name(a.j) + "," + wall_name(a) : name(a.i) + "," + name(a.j);
    if (!given_.is_periodic()) return cells;
    for (std::size_t axis = 0; axis < dimension(); ++axis)
      cells += "," + std::to_string(a.image[axis]);
    return cells;
  }
  std::string heading() const {
    std::string images;
    if (given_.is_periodic())
      images = given_.in_space ? ",image_x,image_y,image_z" : ",image_x,image_y";
    return "first,second" + images + ",from,to,gap,t\n";
  }

  static Enclosure time_of(const Approach& a) {
    return {round_down(a.t), round_up(Rational(a.t + a.t_width))};
  }

  // Adds the spells, of the smallest gap first, to the list and to both tables.
  void add(std::vector<NearSpell> spells, OrderedJson& list,
           std::vector<std::vector<std::string>>& rows, std::string& table) const {
    std::stable_sort(spells.begin(), spells.end(), [](const NearSpell& a, const NearSpell& b) {
      return gap(a.nearest).lo < gap(b.nearest).lo;
    });
    list = OrderedJson::array();
    for (const NearSpell& s : spells) {
      list.push_back({{"from", internal::json_of(s.from)},
                      {"to", internal::json_of(s.to)},
                      {"least", json(s.nearest)}});
      rows.push_back({names(s.nearest), short_text(s.from), short_text(s.to),
                      short_text(gap(s.nearest)), short_text(time_of(s.nearest))});
      table += cells(s.nearest);
      for (const double x : {s.from.lo, s.to.hi, gap(s.nearest).lo, time_of(s.nearest).lo})
        table += "," + number_text(x);
      table += "\n";
    }
  }

  std::string line(const Approach& least) const {
    const bool overlap = gap(least).hi < 0;
    const char* what = least.i >= 0           ? ""
                       : given_.walls.empty() ? "to the container "
                                              : "to the walls ";
    return std::string("c least gap ") + what + short_text(gap(least)) +
           (overlap ? " (they overlap)" : "") + ", of " + names(least) +
           " at t = " + short_text(time_of(least)) + "\n";
  }

  // The container or the walls.
  void add_frame(OrderedJson& json) const {
    if (given_.container) {
      json["container"] = {{"center", place(given_.container->center, true)},
                           {"radius", internal::json_of(given_.container->radius)}};
    }
    for (const BilliardWall& wall : given_.walls) {
      json["walls"].push_back({{"normal", place(wall.normal, true)},
                               {"offset", internal::json_of(wall.offset)},
                               {"speed", internal::json_of(wall.speed)}});
    }
  }

 private:
  std::string name(int g) const {
    return printable(given_.paths[static_cast<std::size_t>(g)].name);
  }

  bool is_at_flat_wall(const Approach& a) const { return a.i < 0 && !given_.container; }

  // The container needs no number.
  std::string wall_name(const Approach& a) const {
    return is_at_flat_wall(a) ? "wall " + std::to_string(a.i) : "wall";
  }

  // Exactly, or rounded where the time is enclosed.
  OrderedJson place(const Vec3& at, bool is_exact) const {
    OrderedJson coordinates = OrderedJson::array();
    for (std::size_t axis = 0; axis < dimension(); ++axis) {
      coordinates.push_back(is_exact ? internal::json_of(at[axis])
                                     : internal::json_of(round_nearest(at[axis])));
    }
    return coordinates;
  }

  OrderedJson image_of(const Approach& a) const {
    OrderedJson image = OrderedJson::array();
    for (std::size_t axis = 0; axis < dimension(); ++axis) image.push_back(a.image[axis]);
    return image;
  }

  std::size_t dimension() const { return given_.in_space ? 3 : 2; }

  OrderedJson disk_json(int g, const Rational& t, bool is_exact) const {
    const GivenPath& path = given_.paths[static_cast<std::size_t>(g)];
    const Rational radius = path.radius_at(t);
    return {{"disk", printable(path.name, 4096)},
            {"center", place(place_at(path, t), is_exact)},
            {"radius", is_exact || path.growth == 0 ? internal::json_of(radius)
                                                    : internal::json_of(round_nearest(radius))}};
  }

  const GivenPaths& given_;
};

// Tells what is judged, for which times and how, and what is not judged.
void add_basis(const ClearanceQuestion& question, const GivenPaths& given, OrderedJson& json,
               std::string& lines) {
  const ClearanceRules& rules = question.rules;
  OrderedJson& remarks = json["remarks"] = OrderedJson::array(
      {"judged are " + (rules.at_waypoints
                            ? "the instants of the waypoints of the file alone (--frames-only)"
                            : given.meaning)});
  if (rules.height) {
    remarks.push_back(
        "two that differ by " + number_text(*rules.height) +
        " or more in height are not near each other, and gaps are horizontal (--height)");
  }
  if (given.is_periodic()) remarks.push_back("all images of the periodic box are judged, too");
  for (const std::string& r : given.remarks) remarks.push_back(r);
  for (const OrderedJson& r : remarks) lines += "c " + r.get<std::string>() + "\n";
  json["missing"] = given.missing;
  for (const std::string& m : given.missing) lines += "c missing: " + m + "\n";
  if (rules.height) json["height"] = internal::json_of(*rules.height);
  if (rules.at_waypoints) json["frames_only"] = true;
  if (given.paths.empty()) return;
  const auto [from, to] = time_of(given.paths);
  json["from"] = internal::json_of(from);
  json["to"] = internal::json_of(to);
  lines += "c judged from t = " + short_text(enclosure(from)) +
           " to t = " + short_text(enclosure(to)) + "\n";
}

// How a gap of 0, or less, counts.
std::string allowance(const ClearanceQuestion& question) {
  if (!question.required || *question.required > 0) return "";
  if (*question.required < 0) {
    return "c overlaps of up to " + short_text(enclosure(Rational(-*question.required))) +
           " are allowed\n";
  }
  return question.touching == Touching::is_allowed ? "c touching is allowed\n"
                                                   : "c touching is too near\n";
}

}  // namespace

ClearanceAnswer answer_clearance(const ClearanceQuestion& question, const GivenPaths& given,
                                 const std::function<bool()>& go_on) {
  const GivenClearance clearance(given, go_on, question.rules);
  std::optional<WallClearance> wall;
  if (given.container || !given.walls.empty()) wall.emplace(given, go_on);
  const Teller teller(given);
  ClearanceAnswer told;
  OrderedJson& json = told.answer.json;
  std::string& lines = told.answer.table;
  json["format"] = "voroproof-clearance";
  json["version"] = 1;
  json["file"] = printable(question.file, 4096);
  json["disks"] = given.paths.empty() ? 0 : disks_of(given.paths).back() + 1;
  json["legs"] = clearance.legs();
  add_basis(question, given, json, lines);
  lines += allowance(question);

  const std::optional<Approach> least = clearance.least();
  if (least) json["least"] = teller.json(*least);
  teller.add_frame(json);
  const std::optional<Approach> at_wall = wall ? wall->least() : std::nullopt;
  if (least) lines += teller.line(*least);
  if (at_wall) {
    json["least_to_container"] = teller.json(*at_wall);
    lines += teller.line(*at_wall);
  } else if (!least) {
    lines += question.rules.height ? "c no two disks are near each other in height at one time\n"
                                   : "c no two disks are there at one time\n";
  }
  if (question.below) {
    json["below"] = internal::json_of(*question.below);
    std::vector<std::vector<std::string>> rows{{"pair", "from", "to", "least gap", "t"}};
    told.table = teller.heading();
    teller.add(clearance.spells_below(*question.below), json["approaches"], rows, told.table);
    if (wall) {
      teller.add(wall->spells_below(*question.below), json["approaches_to_container"], rows,
                 told.table);
    }
    lines += "c " + std::to_string(rows.size() - 1) +
             (rows.size() == 2 ? " approach below " : " approaches below ") +
             short_text(enclosure(*question.below)) + "\n";
    if (rows.size() > 1) lines += table_of(rows);
  }
  if (question.required) {
    const Rational& required = *question.required;
    const bool refuted = (least && falls_short(*least, required, question.touching)) ||
                         (at_wall && falls_short(*at_wall, required, question.touching));
    const bool is_told = (!least || keeps_clear(*least, required, question.touching)) &&
                         (!at_wall || keeps_clear(*at_wall, required, question.touching));
    const bool is_whole = given.missing.empty() && (least || at_wall);
    told.freedom = refuted               ? Freedom::refuted
                   : is_whole && is_told ? Freedom::free
                                         : Freedom::undecided;
    const char* verdict = refuted                         ? "REFUTED"
                          : told.freedom == Freedom::free ? "FREE"
                                                          : "UNDECIDED";
    json["required"] = internal::json_of(required);
    json["touching"] = question.touching == Touching::is_allowed;
    json["verdict"] = verdict;
    if (!refuted && !is_told)
      lines += "c missing: a gap is the required one, or too near it to be told\n";
    lines += std::string("s ") + verdict + "\n";
  }
  return told;
}

}  // namespace voroproof::internal
