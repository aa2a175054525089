#include "apps/answers/clearance_answer.h"

#include "history/error.h"

namespace voroproof::internal {
namespace {

constexpr const char* kInterpolation =
    "judged are the piecewise linear paths between the waypoints of the file";

class Teller {
 public:
  Teller(const GivenPaths& given) : paths_(given.paths) {}

  // An approach, with all that it takes to check it by hand.
  Json json(const Approach& a) const {
    Json disks = Json::array();
    for (const int g : {a.i, a.j}) {
      const GivenPath& path = paths_[static_cast<std::size_t>(g)];
      const Point2 at = place_at(path, a.t);
      disks.push_back({{"disk", path.name},
                       {"center", Json::array({json_of(at.x), json_of(at.y)})},
                       {"radius", json_of(path.radius)}});
    }
    return {{"t", json_of(a.t)},
            {"disks", std::move(disks)},
            {"distance_squared", json_of(a.distance2)},
            {"gap", json_of(gap(a))}};
  }

  std::string pair(const Approach& a) const {
    return printable(paths_[static_cast<std::size_t>(a.i)].name) + " " +
           printable(paths_[static_cast<std::size_t>(a.j)].name);
  }

 private:
  const std::vector<GivenPath>& paths_;
};

void add_spells(Answer& answer, const Teller& teller, const std::vector<NearSpell>& spells) {
  std::vector<std::vector<std::string>> rows{{"pair", "from", "to", "least gap", "t"}};
  Json& all = answer.json["approaches"] = Json::array();
  for (const NearSpell& s : spells) {
    all.push_back(
        {{"from", json_of(s.from)}, {"to", json_of(s.to)}, {"least", teller.json(s.nearest)}});
    rows.push_back({teller.pair(s.nearest), short_text(s.from), short_text(s.to),
                    short_text(gap(s.nearest)), short_text(enclosure(s.nearest.t))});
  }
  answer.table += spells.empty() ? "no approach below that\n" : table_of(rows);
}

}  // namespace

ClearanceAnswer answer_clearance(const ClearanceQuestion& question, const GivenPaths& given,
                                 std::function<bool()> go_on) {
  const GivenClearance clearance(given.paths, std::move(go_on));
  const Teller teller(given);
  ClearanceAnswer told;
  Json& json = told.answer.json;
  std::string& lines = told.answer.table;
  json["format"] = "voroproof-clearance";
  json["version"] = 1;
  json["file"] = printable(question.file, 4096);
  json["disks"] = given.paths.size();
  json["legs"] = clearance.legs();
  Json& remarks = json["remarks"] = Json::array({kInterpolation});
  for (const std::string& r : given.remarks) remarks.push_back(r);
  for (const Json& r : remarks) lines += "c " + r.get<std::string>() + "\n";

  const std::optional<Approach> least = clearance.least();
  if (least) {
    json["least"] = teller.json(*least);
    const bool overlap = gap(*least).hi < 0;
    lines += "c least gap " + short_text(gap(*least)) + (overlap ? " (they overlap)" : "") +
             ", of " + teller.pair(*least) + " at t = " + short_text(enclosure(least->t)) + "\n";
  } else {
    lines += "c no two disks are there at one time\n";
  }
  if (question.below) {
    json["below"] = json_of(*question.below);
    add_spells(told.answer, teller, clearance.spells_below(*question.below));
  }
  if (question.required) {
    told.refuted = least && !keeps_clear(*least, *question.required);
    json["required"] = json_of(*question.required);
    json["verdict"] = told.refuted ? "REFUTED" : "FREE";
    lines += told.refuted ? "s REFUTED\n" : "s FREE\n";
  }
  return told;
}

}  // namespace voroproof::internal
