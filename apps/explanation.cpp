#include "apps/explanation.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "exact/rational.h"
#include "history/error.h"
#include "history/file_bytes.h"
#include "history/json_text.h"

namespace voroproof {

namespace {

using Json = nlohmann::json;

constexpr std::size_t max_report = std::size_t{1} << 26;

// A number of the evidence: exact, or the middle of its enclosure.
double value_of(const Json& number) {
  if (number.is_string()) {
    const auto q = parse_rational(number.get<std::string>());
    if (!q) throw std::invalid_argument("not a number: " + number.get<std::string>());
    return round_nearest(*q);
  }
  return 0.5 *
         (std::stod(number.at(0).get<std::string>()) + std::stod(number.at(1).get<std::string>()));
}

std::string text_of(const Json& number) {
  if (number.is_string()) return number.get<std::string>();
  return "in [" + number.at(0).get<std::string>() + ", " + number.at(1).get<std::string>() + "]";
}

std::string name_of(GenId id) {
  return id == container_id ? "the container" : "disk " + std::to_string(id);
}

// Where each kind of fault leads a reader.
std::string meaning_of(const std::string& kind) {
  if (kind == "missing event") return "Something happens that the history does not claim.";
  if (kind == "spurious event") return "What the history claims there does not happen.";
  if (kind == "wrong quadruple") return "Another edge than the claimed one flips.";
  if (kind == "wrong time") return "The event happens, but not within the tolerance of its time.";
  if (kind == "wrong order") return "The events happen in another order.";
  if (kind == "wrong pair") return "Other generators than the claimed ones touch.";
  if (kind == "wrong response") return "The motion after the event is not the one claimed.";
  if (kind == "wrong initial diagram") return "The history begins with a wrong diagram.";
  if (kind == "overlap") return "Two generators overlap and the history claims no collision.";
  if (kind == "bad count") return "The last line counts other events than the file has.";
  if (kind == "edge not present") return "The diagram has no such edge at that time.";
  return {};
}

class Explainer {
 public:
  explicit Explainer(const Json& report) : report_(report) {}

  Explanation explain() {
    const std::string verdict = report_.at("verdict");
    found_.verdict = verdict;
    found_.truth = report_.at("truth");
    found_.reason = report_.at("reason");
    found_.scene_sha256 = report_.at("scene_sha256");
    out_ << report_.at("history").get<std::string>() << " against "
         << report_.at("scene").get<std::string>() << ", truth "
         << report_.at("truth").get<std::string>() << ": " << verdict << ".\n";
    const Json& prefix = report_.at("certified_prefix");
    found_.prefix_events = prefix.at("events");
    found_.prefix_t = prefix.at("t");
    out_ << "The first " << prefix.at("events")
         << " events are proved right, and nothing is missing "
         << "before t = " << prefix.at("t") << ".\n";
    if (report_.contains("divergence")) {
      explain_divergence(report_.at("divergence"));
    } else if (verdict != "CERTIFIED") {
      out_ << report_.at("reason").get<std::string>() << '\n';
    }
    for (const Json& remark : report_.at("remarks")) {
      out_ << "Note: " << remark.get<std::string>() << ".\n";
    }
    found_.words = out_.str();
    return std::move(found_);
  }

 private:
  void explain_divergence(const Json& d) {
    const std::string kind = d.at("kind");
    found_.fault = FirstFault{kind, d.at("line"), d.at("t"), d.at("truth")};
    out_ << "\nLine " << d.at("line") << ", " << kind << ". " << meaning_of(kind) << '\n';
    if (d.at("claim").is_null()) {
      out_ << "  claim: none\n";
    } else {
      out_ << "  claim: " << d.at("claim").dump() << '\n';
    }
    out_ << "  truth: " << d.at("truth").get<std::string>() << '\n';
    explain_witness(d.at("witness"), d.at("t").get<double>());
  }

  void explain_witness(const Json& w, double t) {
    if (!w.contains("generators")) return;
    if (w.contains("isolating_interval")) {
      t = 0.5 *
          (value_of(w.at("isolating_interval").at(0)) + value_of(w.at("isolating_interval").at(1)));
    }
    if (w.contains("t")) t = value_of(w.at("t"));
    out_ << "\nTo check it by hand:\n";
    found_.generators_t = t;
    for (const Json& g : w.at("generators")) {
      const auto id = g.at("id").get<GenId>();
      const Json& c = g.at("center");
      const Json& v = g.at("velocity");
      out_ << "  " << name_of(id) << ", signed radius " << text_of(g.at("signed_radius"))
           << ", is at t0 = " << g.at("t0").get<std::string>()
           << " at\n    x = " << text_of(c.at(0)) << "\n    y = " << text_of(c.at(1))
           << "\n  and moves with\n    vx = " << text_of(v.at(0))
           << "\n    vy = " << text_of(v.at(1)) << '\n';
      const double dt = t - value_of(g.at("t0"));
      const Vec2 velocity{value_of(v.at(0)), value_of(v.at(1))};
      found_.generators.push_back(
          {id,
           {value_of(c.at(0)) + dt * velocity[0], value_of(c.at(1)) + dt * velocity[1]},
           velocity,
           value_of(g.at("signed_radius"))});
    }
    if (w.contains("polynomial")) {
      const Json& p = w.at("polynomial");
      out_ << "  Their " << p.at("is").get<std::string>()
           << " at time t is the polynomial with the coefficients (of 1, t, t^2, ...)\n";
      for (const Json& c : p.at("coefficients")) out_ << "    " << text_of(c) << '\n';
    }
    if (w.contains("isolating_interval")) {
      out_ << "  Exactly one root lies between\n    "
           << w.at("isolating_interval").at(0).get<std::string>() << "\n  and\n    "
           << w.at("isolating_interval").at(1).get<std::string>() << "\n  (about " << number_text(t)
           << ").\n";
    }
    if (w.contains("vertex")) {
      out_ << "  At t = " << w.at("t").get<std::string>() << " the circle of the vertex "
           << w.at("vertex").dump() << " contains a point of "
           << name_of(w.at("contains").get<GenId>()) << ".\n";
    }
  }

  const Json& report_;
  std::ostringstream out_;
  Explanation found_;
};

}  // namespace

Explanation explain_report(const std::string& path) {
  const std::string bytes = file_bytes(path, max_report);
  try {
    const Json report = Json::parse(bytes);
    if (report.at("format") != "voroproof-report" || report.at("version") != 1) {
      throw InputError(path, 0, "format", "not a report of version 1");
    }
    return Explainer(report).explain();
  } catch (const Json::exception& e) {
    throw InputError(path, 0, "", std::string("not a report: ") + printable(e.what(), 200));
  } catch (const std::logic_error& e) {  // a number that is none
    throw InputError(path, 0, "", std::string("not a report: ") + printable(e.what(), 200));
  }
}

}  // namespace voroproof
