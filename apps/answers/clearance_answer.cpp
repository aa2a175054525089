#include "apps/answers/clearance_answer.h"

#include "history/error.h"
#include "library/planning/wall_clearance.h"

namespace voroproof::internal {
namespace {

OrderedJson json_of(const Point2& p) {
  return OrderedJson::array({voroproof::internal::json_of(p.x), voroproof::internal::json_of(p.y)});
}

// An approach of two disks, or of one to the container, with all that it takes to check it by hand.
class Teller {
 public:
  explicit Teller(const GivenPaths& given) : paths_(given.paths) {}

  OrderedJson json(const Approach& a) const { return json(a, {a.i, a.j}); }
  OrderedJson json(const WallApproach& a) const { return json(a, {a.disk}); }

  std::string names(const Approach& a) const { return name(a.i) + " " + name(a.j); }
  std::string names(const WallApproach& a) const { return name(a.disk) + " wall"; }

  // Adds the spells to the list and to the rows of the table.
  template <class Spells>
  void add(const Spells& spells, OrderedJson& list,
           std::vector<std::vector<std::string>>& rows) const {
    list = OrderedJson::array();
    for (const auto& s : spells) {
      list.push_back({{"from", voroproof::internal::json_of(s.from)},
                      {"to", voroproof::internal::json_of(s.to)},
                      {"least", json(s.nearest)}});
      rows.push_back({names(s.nearest), short_text(s.from), short_text(s.to),
                      short_text(gap(s.nearest)), short_text(enclosure(s.nearest.t))});
    }
  }

  template <class Nearest>
  std::string line(const char* what, const Nearest& least) const {
    const bool overlap = gap(least).hi < 0;
    return std::string("c least gap ") + what + short_text(gap(least)) +
           (overlap ? " (they overlap)" : "") + ", of " + names(least) +
           " at t = " + short_text(enclosure(least.t)) + "\n";
  }

 private:
  std::string name(int g) const { return printable(paths_[static_cast<std::size_t>(g)].name); }

  template <class Nearest>
  OrderedJson json(const Nearest& a, std::initializer_list<int> generators) const {
    OrderedJson disks = OrderedJson::array();
    for (const int g : generators) {
      const GivenPath& path = paths_[static_cast<std::size_t>(g)];
      disks.push_back({{"disk", path.name},
                       {"center", json_of(place_at(path, a.t))},
                       {"radius", voroproof::internal::json_of(path.radius)}});
    }
    return {{"t", voroproof::internal::json_of(a.t)},
            {"disks", std::move(disks)},
            {"distance_squared", voroproof::internal::json_of(a.distance2)},
            {"gap", voroproof::internal::json_of(gap(a))}};
  }

  const std::vector<GivenPath>& paths_;
};

// Tells what is judged, for which times, and what is not judged.
void add_basis(const GivenPaths& given, OrderedJson& json, std::string& lines) {
  OrderedJson& remarks = json["remarks"] = OrderedJson::array({"judged are " + given.meaning});
  for (const std::string& r : given.remarks) remarks.push_back(r);
  for (const OrderedJson& r : remarks) lines += "c " + r.get<std::string>() + "\n";
  json["missing"] = given.missing;
  for (const std::string& m : given.missing) lines += "c missing: " + m + "\n";
  if (given.paths.empty()) return;
  const auto [from, to] = time_of(given.paths);
  json["from"] = voroproof::internal::json_of(from);
  json["to"] = voroproof::internal::json_of(to);
  lines += "c judged from t = " + short_text(enclosure(from)) +
           " to t = " + short_text(enclosure(to)) + "\n";
}

}  // namespace

ClearanceAnswer answer_clearance(const ClearanceQuestion& question, const GivenPaths& given,
                                 const std::function<bool()>& go_on) {
  const GivenClearance clearance(given.paths, go_on, given.contacts);
  std::optional<WallClearance> wall;
  if (given.container) wall.emplace(given, go_on);
  const Teller teller(given);
  ClearanceAnswer told;
  OrderedJson& json = told.answer.json;
  std::string& lines = told.answer.table;
  json["format"] = "voroproof-clearance";
  json["version"] = 1;
  json["file"] = printable(question.file, 4096);
  json["disks"] = given.paths.size();
  json["legs"] = clearance.legs();
  add_basis(given, json, lines);

  const std::optional<Approach> least = clearance.least();
  if (least) json["least"] = teller.json(*least);
  std::optional<WallApproach> at_wall;
  if (wall) {
    json["container"] = {{"center", json_of(given.container->center)},
                         {"radius", voroproof::internal::json_of(given.container->radius)}};
    at_wall = wall->least();
  }
  if (least) lines += teller.line("", *least);
  if (at_wall) {
    json["least_to_container"] = teller.json(*at_wall);
    lines += teller.line("to the container ", *at_wall);
  } else if (!least) {
    lines += "c no two disks are there at one time\n";
  }
  if (question.below) {
    json["below"] = voroproof::internal::json_of(*question.below);
    std::vector<std::vector<std::string>> rows{{"pair", "from", "to", "least gap", "t"}};
    teller.add(clearance.spells_below(*question.below), json["approaches"], rows);
    if (wall) {
      teller.add(wall->spells_below(*question.below), json["approaches_to_container"], rows);
    }
    lines += rows.size() == 1 ? "no approach below that\n" : table_of(rows);
  }
  if (question.required) {
    const bool refuted = (least && !keeps_clear(*least, *question.required)) ||
                         (at_wall && !keeps_clear(*at_wall, *question.required));
    const bool is_whole = given.missing.empty() && (least || at_wall);
    told.freedom = refuted ? Freedom::refuted : is_whole ? Freedom::free : Freedom::undecided;
    const char* verdict = refuted ? "REFUTED" : is_whole ? "FREE" : "UNDECIDED";
    json["required"] = voroproof::internal::json_of(*question.required);
    json["verdict"] = verdict;
    lines += std::string("s ") + verdict + "\n";
  }
  return told;
}

}  // namespace voroproof::internal
