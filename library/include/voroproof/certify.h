// The certifier: proves a claimed history, refutes it with evidence, or says what it cannot decide.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "voroproof/export.h"
#include "voroproof/history.h"
#include "voroproof/scene.h"

namespace voroproof {

// docs/claim.md states what each verdict says.
enum class Verdict { certified, refuted, undecided };
VOROPROOF_API const char* name(Verdict verdict);  // "certified" and so on

enum class Truth {
  exact,     // the true motion of the scene
  recorded,  // the motion that the claimed collision times and velocities define
};

// Which events of a history are judged.
enum class EventKinds {
  all,
  collisions,  // with the maneuvers: flips and diagrams are passed over, and nothing is said of
               // them
};

struct CertifyOptions {
  Truth truth = Truth::exact;
  EventKinds events = EventKinds::all;
  Number tolerance{1e-6};      // for times
  Number law_tolerance{1e-9};  // for velocities, relative to the speeds involved
  bool strict = false;         // swaps, unoriented edges and another horizon are refuted
  // Truth::exact: collisions and maneuvers of one instant may come in any order in which every
  // collision is of two that touch and approach then, and no such pair is left.
  bool any_order = false;
  // Where all events are judged, and for the initial diagram. The report is the same.
  int threads = 1;
  int max_bits = 32768;
  // Called now and then with the time and the number of events judged; false interrupts.
  std::function<bool(double t, std::int64_t events)> monitor;
};

// A number of a witness lies between the two. They are equal where it is rational and short enough
// to be given exactly.
struct Bounds {
  Number lower, upper;
};

// A generator of a witness near the event: at time t its centre is (x + vx (t - t0), y + vy (t -
// t0)). The signed radius of the container is negative.
struct WitnessMotion {
  int generator = 0;
  Number t0;
  Bounds x, y, vx, vy, signed_radius;
};

// Evidence that anybody can check by hand or with a computer algebra system. Which fields there are
// depends on the fault (docs/certificate.md, section 9).
struct Witness {
  std::vector<WitnessMotion> generators;
  // The function that vanishes at the event, and its coefficients (of 1, t, t^2, ...). It has
  // exactly one root in `root`: the exact time of the event.
  std::string polynomial_is;
  std::vector<Bounds> polynomial;
  std::optional<std::array<Number, 2>> root;
  // Or: at t the two overlap; or the circle of the vertex contains a point of `contains`.
  std::optional<Number> t;
  std::optional<std::array<int, 3>> vertex;
  std::optional<int> contains;
};

// Where a refuted history is wrong.
struct Divergence {
  std::string fault;  // "missing event", "wrong time", ... (packaging/schemas/report.schema.json)
  std::int64_t line = 0;     // line of the file; in a History, event k is on line k + 2
  double t = 0;              // time of the claim, or of the truth where no claim is at fault
  std::string truth;         // states the truth in one sentence
  std::optional<Edge> edge;  // that flips in truth
  std::optional<std::array<int, 2>> pair;  // that touches in truth
  Witness witness;
};

// Something that was accepted by leniency (docs/claim.md, section 5).
struct Leniency {
  std::string name, words;
  std::int64_t count = 0;
};

struct Report {
  Verdict verdict = Verdict::undecided;
  // The report in the words of the program: "CERTIFIED" or "CERTIFIED (collisions alone)" and so
  // on; about which events and which truth, up to when, within which tolerances; and each
  // reservation, a line.
  std::string words, about;
  std::vector<std::string> reservations;
  std::string reason;  // in one line, why it is not certified
  std::optional<Divergence> divergence;
  std::string evidence;  // for a refutation: how its witness was checked, by CGAL
  // The first so many events are right, and nothing is missing before t.
  std::int64_t prefix_events = 0;
  double prefix_t = 0;
  // Proved; of a history that is not certified, if all before them is as it says.
  std::int64_t flips = 0, collisions = 0, maneuvers = 0;
  std::int64_t flips_not_judged = 0;  // with EventKinds::collisions: the flips of the history
  std::vector<Leniency> leniency;     // with count > 0
  std::vector<std::string> remarks;
  std::string json;  // the whole report as `voroproof certify --report` writes it, witness included
};

// Throw InputError where the history is none or is not of this scene, Interrupted where the monitor
// says so, std::invalid_argument for tolerances without meaning, and std::logic_error where CGAL
// contradicts the witness of a refutation.
VOROPROOF_API Report certify(const Scene& scene, const History& history,
                             const CertifyOptions& options = {});
// Certifies files, in any format that the program reads; large ones are read as they are judged.
VOROPROOF_API Report certify_files(const std::string& scene_path, const std::string& history_path,
                                   const CertifyOptions& options = {});

// The report in words, several lines, with its witness: what `voroproof explain` prints.
VOROPROOF_API std::string explain(const Report& report);

}  // namespace voroproof
