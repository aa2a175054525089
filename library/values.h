// Converts between the values of the library's headers (library/include/voroproof/) and those of
// the program.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "certify/certificate.h"
#include "engine/engine.h"
#include "exact/enclosure.h"
#include "exact/rounding.h"
#include "history/claim.h"
#include "history/diagram_file.h"
#include "history/error.h"
#include "history/history_source.h"
#include "history/scene.h"
#include "library/queries/clearance.h"
#include "voroproof/certify.h"
#include "voroproof/diagram.h"
#include "voroproof/free_space.h"
#include "voroproof/history.h"
#include "voroproof/number.h"
#include "voroproof/scene.h"

namespace voroproof::internal {

Rational rational(const voroproof::Number& number);
voroproof::Number number(const Rational& q);

// The scene as a file of it would be read, checked, and with the hash that its histories name.
// Throws InputError.
Scene checked_scene(const voroproof::Scene& scene);
// `scene` must have been read from a file, or be given its source afterwards.
voroproof::Scene scene_value(const Scene& scene);

voroproof::Edge edge_value(const Quad& quad);
Quad quad(const voroproof::Edge& edge);
voroproof::Event event_value(const Event& event);
Event event(const voroproof::Event& event);
voroproof::Enclosure enclosure_value(const Enclosure& enclosure);

voroproof::Witness witness_value(const Witness& witness);

voroproof::Diagram diagram_value(const DiagramFile& file);
DiagramFile diagram_file(const voroproof::Diagram& diagram);

// Collects a history.
class Collecting final : public voroproof::EventSink {
 public:
  explicit Collecting(voroproof::History& history) : history_(history) {}
  void begin(const std::vector<voroproof::Edge>& initial) override { history_.initial = initial; }
  void event(const voroproof::Event& event) override { history_.events.push_back(event); }

 private:
  voroproof::History& history_;
};

// A history in memory as a source of events, for a scene of so many disks. It must outlive the
// source. Checks what a reader of files checks. Throws InputError for "history".
std::unique_ptr<HistorySource> memory_history(const voroproof::History& history, int disks);
// The checked scene with the history, which must outlive the claim. Throws InputError, also where
// the history is one of another scene.
Claim memory_claim(const voroproof::Scene& scene, const voroproof::History& history);

// The options with this budget. Throw std::invalid_argument where it is less than 64 bits.
MotionOptions motion_options(int max_bits);
EngineOptions engine_options(int max_bits);
// Throws std::invalid_argument for negative times.
Rational instant(const voroproof::Number& t);
// The radius of a probe. Throws std::invalid_argument for negative ones.
Rational probe_radius(const voroproof::Number& probe);

voroproof::ClearancePlace place_value(const ClearanceNode& node);

// Calls work() and throws the errors of the program as those of the library. Throws
// std::runtime_error where doubles do not compute as all bounds assume (exact/rounding.h).
template <class Work>
decltype(auto) with_public_errors(Work&& work);

// Calls read(), which reads a text that was made of values in memory: its errors name no line.
template <class Read>
auto without_lines(const char* name, Read&& read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw InputError(name, 0, error.field(), error.reason());
  }
}

[[noreturn]] void rethrow_public();

template <class Work>
decltype(auto) with_public_errors(Work&& work) {
  require_ieee_arithmetic();
  try {
    return std::forward<Work>(work)();
  } catch (...) {
    rethrow_public();
  }
}

}  // namespace voroproof::internal
