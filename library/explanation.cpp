#include "library/explanation.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "history/error.h"
#include "history/json_text.h"
#include "history/scene.h"
#include "library/certification.h"
#include "library/json_field.h"
#include "library/report_reader.h"

namespace voroproof::internal {

namespace {

constexpr std::size_t max_report = std::size_t{1} << 26;
constexpr std::size_t longest_text = std::size_t{1} << 16;  // that is shown

// A number of the evidence: exact, or the middle of its enclosure.
double value_of(const JsonField& number) {
  if (number.json().is_string()) return number.number();
  return 0.5 * (number[0].number() + number[1].number());
}

std::string text_of(const JsonField& number) {
  if (number.json().is_string()) return printable(number.text(), longest_text);
  return "in [" + printable(number[0].text(), longest_text) + ", " +
         printable(number[1].text(), longest_text) + "]";
}

GenId id_of(const JsonField& field) {
  const std::int64_t id = field.integer();
  if (id < container_id || id >= max_disks) field.fail("no generator");
  return static_cast<GenId>(id);
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
  if (kind == "another order of touching collisions") {
    return "Of pairs that touch at one instant another collides first (--order any accepts it).";
  }
  if (kind == "wrong pair") return "Other generators than the claimed ones touch.";
  if (kind == "wrong image") return "Another image of the disk than the claimed one touches.";
  if (kind == "wrong response") return "The motion after the event is not the one claimed.";
  if (kind == "wrong initial diagram") return "The history begins with a wrong diagram.";
  if (kind == "overlap") return "Two generators overlap and the history claims no collision.";
  if (kind == "bad count") return "The last line counts other events than the file has.";
  if (kind == "edge not present") return "The diagram has no such edge at that time.";
  return {};
}

// Text of a report, fit for the terminal.
std::string shown(const std::string& text) { return printable(text, longest_text); }
std::string shown(const JsonField& field) { return shown(field.text()); }

class Explainer {
 public:
  explicit Explainer(const JsonField& report) : report_(report) {}

  // `notes`: lines that are said besides.
  Explanation explain(const std::vector<std::string>& notes) {
    const CertificationRun run = read_run(report_);
    const CertifyOptions options = read_options(report_);
    const Certificate certificate = read_certificate(report_);
    require_agreement(run, options, certificate);
    found_.verdict = words_of(options, run.horizon, certificate);
    found_.judges_flips = options.judges_flips();
    found_.reason = report_["reason"].text();
    found_.producer = run.producer;
    found_.scene_sha256 = run.scene_sha256;
    found_.history_sha256 = run.history_sha256;
    out_ << shown(run.history_file) << " against " << shown(run.scene_file) << ": "
         << found_.verdict.verdict << ".\nJudged: " << found_.verdict.about << ".\n";
    for (const std::string& line : found_.verdict.reservations) out_ << "Note: " << line << ".\n";
    for (const std::string& line : notes) out_ << "Note: " << line << ".\n";
    const JsonField prefix = report_["certified_prefix"];
    found_.prefix_events = prefix["events"].integer();
    found_.prefix_t = prefix["t"].number();
    const std::string of = found_.judges_flips ? "event" : "collision or maneuver";
    out_ << (found_.prefix_events == 1
                 ? "The first " + of + " is"
                 : "The first " + std::to_string(found_.prefix_events) +
                       (found_.judges_flips ? " events are" : " collisions and maneuvers are"))
         << " proved right, and nothing is missing before t = " << number_text(found_.prefix_t)
         << ".\n";
    if (report_.has("divergence")) {
      explain_divergence(report_["divergence"]);
    } else if (!found_.reason.empty()) {
      out_ << shown(report_["reason"]) << '\n';
    }
    for (const JsonField& remark : report_["remarks"].elements()) {
      out_ << "Note: " << shown(remark) << ".\n";
    }
    found_.words = out_.str();
    return std::move(found_);
  }

 private:
  void explain_divergence(const JsonField& d) {
    const std::string kind = d["kind"].text();
    found_.fault = FirstFault{kind, d["line"].integer(), d["t"].number(), d["truth"].text()};
    out_ << "\nLine " << found_.fault->line << ", " << shown(kind) << ". " << meaning_of(kind)
         << '\n';
    if (d["claim"].json().is_null()) {
      out_ << "  claim: none\n";
    } else {
      out_ << "  claim: " << shown(d["claim"].json().dump()) << '\n';
    }
    out_ << "  truth: " << shown(d["truth"]) << '\n';
    explain_witness(d["witness"], d["t"].number());
    out_ << "Evidence: " << shown(report_["evidence"]) << ".\n";
  }

  // No report that this program writes contradicts itself.
  void require_agreement(const CertificationRun& run, const CertifyOptions& options,
                         const Certificate& c) const {
    if (options.tolerance < 0 ||
        options.tolerance > std::max(run.horizon, CertifyOptions().tolerance)) {
      report_["tolerance"].fail("less than 0 or more than the horizon");
    }
    if (report_.has("flips_not_judged") == options.judges_flips()) {
      report_["events"].fail("does not agree with flips_not_judged");
    }
    const JsonField prefix = report_["certified_prefix"];
    if (c.divergence && c.prefix_events >= c.divergence->line) {
      prefix["events"].fail("goes beyond the fault");
    }
    if (c.verdict != Verdict::certified) return;
    if (c.left_out == 0 && c.prefix_t < round_down(run.horizon)) {
      prefix["t"].fail("ends before the horizon in a report that certifies");
    }
    for (const char* second : {"kernel", "proved_checker"}) {
      if (report_.has(second) && !report_[second].text().starts_with("CERTIFIED")) {
        report_[second].fail("does not certify in a report that does");
      }
    }
  }

  void explain_witness(const JsonField& w, double t) {
    if (!w.has("generators")) return;
    if (w.has("isolating_interval")) {
      t = 0.5 * (value_of(w["isolating_interval"][0]) + value_of(w["isolating_interval"][1]));
    }
    if (w.has("t")) t = value_of(w["t"]);
    out_ << "\nTo check it by hand:\n";
    found_.generators_t = t;
    for (const JsonField& g : w["generators"].elements()) {
      const GenId id = id_of(g["id"]);
      const JsonField c = g["center"];
      const JsonField v = g["velocity"];
      out_ << "  " << name_of(id) << ", signed radius " << text_of(g["signed_radius"])
           << ", is at t0 = " << shown(g["t0"]) << " at\n    x = " << text_of(c[0])
           << "\n    y = " << text_of(c[1]) << "\n  and moves with\n    vx = " << text_of(v[0])
           << "\n    vy = " << text_of(v[1]) << '\n';
      const double dt = t - value_of(g["t0"]);
      const Vec2 velocity{value_of(v[0]), value_of(v[1])};
      found_.generators.push_back(
          {id,
           {value_of(c[0]) + dt * velocity[0], value_of(c[1]) + dt * velocity[1]},
           velocity,
           value_of(g["signed_radius"])});
    }
    if (w.has("polynomial")) {
      const JsonField p = w["polynomial"];
      out_ << "  Their " << shown(p["is"])
           << " at time t is the polynomial with the coefficients (of 1, t, t^2, ...)\n";
      for (const JsonField& c : p["coefficients"].elements()) out_ << "    " << text_of(c) << '\n';
    }
    if (w.has("isolating_interval")) {
      out_ << "  Exactly one root lies between\n    " << shown(w["isolating_interval"][0])
           << "\n  and\n    " << shown(w["isolating_interval"][1]) << "\n  (about "
           << number_text(t) << ").\n";
    }
    if (w.has("vertex")) {
      out_ << "  At t = " << shown(w["t"]) << " the circle of the vertex "
           << shown(w["vertex"].json().dump()) << " contains a point of "
           << name_of(id_of(w["contains"])) << ".\n";
    } else if (w.has("t")) {
      out_ << "  At t = " << shown(w["t"]) << " they overlap.\n";
    }
  }

  const JsonField report_;
  std::ostringstream out_;
  Explanation found_;
};

// Said of a report by another program, and of one that does not tell its subject.
std::string by_another(const std::string& its, const std::string& producer) {
  return "the report is by " + shown(its) + ", and this is " + producer;
}
constexpr const char* of_no_history = "the report does not say which history it is about";

}  // namespace

Explanation explain_report(const std::string& path, const std::string& producer) {
  const nlohmann::json report = read_report(path, "voroproof-report", max_report);
  const JsonField field(report, path);
  const CertificationRun run = read_run(field);
  std::vector<std::string> notes;
  for (const auto& [file, sha256] : {std::pair(run.scene_file, run.scene_sha256),
                                     std::pair(run.history_file, run.history_sha256)}) {
    if (has_other_bytes(file, sha256)) {
      notes.push_back(shown(file) + " has other bytes now than those that were judged");
    }
  }
  if (run.producer != producer) {
    notes.push_back(by_another(run.producer, producer));
  }
  if (run.history_sha256.empty()) {
    notes.push_back(of_no_history);
  }
  return Explainer(field).explain(notes);
}

Explanation explain_report_text(const std::string& text, const std::string& name) {
  const nlohmann::json report = parse_report(text, name);
  return Explainer(JsonField(report, name)).explain({});
}

void require_report_of(const Explanation& report, const std::string& name,
                       const std::string& producer, const std::string& scene_sha256,
                       const std::string& history_sha256) {
  if (report.producer != producer) {
    throw InputError(name, 0, "producer", by_another(report.producer, producer));
  }
  if (report.scene_sha256 != scene_sha256) {
    throw InputError(name, 0, "scene_sha256", "the report is about another scene");
  }
  if (report.history_sha256.empty()) {
    throw InputError(name, 0, "history_sha256", of_no_history);
  }
  if (report.history_sha256 != history_sha256) {
    throw InputError(name, 0, "history_sha256", "the report is about another history");
  }
}

}  // namespace voroproof::internal
