#include "tests/support/scene_run.h"

#include <bit>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "engine/kept_run.h"
#include "history/error.h"
#include "history/scene_writer.h"
#include "library/maneuver_input.h"

namespace voroproof::internal::testing {
namespace {

class Recorder : public EventSink {
 public:
  explicit Recorder(RecordedRun& run) : run_(run) {}

  void begin(const std::vector<Quad>& initial) override {
    run_.initial = initial;
    ++run_.begins;
  }
  void flip(double t, const Quad& edge) override {
    Event e{Event::Kind::flip, t};
    e.edge = edge;
    run_.events.push_back(e);
  }
  void collide(double t, GenId i, GenId j, const RoundedState& first,
               const RoundedState& second) override {
    run_.events.push_back({Event::Kind::collision, t, {}, i, j, first, second});
  }
  void maneuver(double t, GenId disk, const RoundedState& state) override {
    run_.events.push_back({Event::Kind::maneuver, t, {}, disk, disk, state, {}});
  }

 private:
  RecordedRun& run_;
};

void tell_event(const Event& e, EventSink& sink) {
  switch (e.kind) {
    case Event::Kind::flip:
      return sink.flip(e.t, e.edge);
    case Event::Kind::collision:
      return sink.collide(e.t, e.i, e.j, e.first, e.second);
    case Event::Kind::maneuver:
      return sink.maneuver(e.t, e.i, e.first);
  }
}

void note_end(const Engine& engine, RecordedRun& run) {
  run.stats = engine.stats();
  run.final_diagram = engine.diagram().quads();
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_state(const RoundedState& a, const RoundedState& b) {
  return same_bits(a.px, b.px) && same_bits(a.py, b.py) && same_bits(a.vx, b.vx) &&
         same_bits(a.vy, b.vy);
}

bool same_event(const Event& a, const Event& b) {
  if (a.kind != b.kind || !same_bits(a.t, b.t)) return false;
  if (a.kind == Event::Kind::flip) return a.edge == b.edge;
  if (a.i != b.i || a.j != b.j) return false;
  const bool first_counts = a.i != container_id, second_counts = a.kind == Event::Kind::collision;
  return (!first_counts || same_state(a.first, b.first)) &&
         (!second_counts || same_state(a.second, b.second));
}

std::string name(const Event& e) {
  switch (e.kind) {
    case Event::Kind::flip:
      return "flip " + text(e.edge);
    case Event::Kind::collision:
      return "collide " + std::to_string(e.i) + " " + std::to_string(e.j);
    case Event::Kind::maneuver:
      return "maneuver " + std::to_string(e.i);
  }
  return "";
}

void write_state(std::ostream& out, const RoundedState& s) {
  out << " p (" << s.px << ", " << s.py << ") v (" << s.vx << ", " << s.vy << ")";
}

}  // namespace

DiskInput disk(Rational x, Rational y, Rational radius, Rational vx, Rational vy) {
  Rational mass = radius * radius;
  return disk(std::move(x), std::move(y), std::move(radius), std::move(vx), std::move(vy),
              std::move(mass));
}

DiskInput disk(Rational x, Rational y, Rational radius, Rational vx, Rational vy, Rational mass) {
  return {std::move(x),  std::move(y),  std::move(radius),
          std::move(vx), std::move(vy), std::move(mass)};
}

Scene scene_of(Rational container_radius, Rational horizon, std::vector<DiskInput> disks) {
  Scene scene;
  scene.container_radius = std::move(container_radius);
  scene.horizon = std::move(horizon);
  scene.disks = std::move(disks);
  return scene;
}

bool is_acceptable(const Scene& scene) {
  try {
    parse_scene(text(scene), "scene");
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::string text(const Scene& scene) {
  std::ostringstream out;
  write_scene(out, scene);
  return out.str();
}

std::string text(const Quad& q) {
  std::ostringstream out;
  out << '[' << q.l << ',' << q.r << ',' << q.s << ',' << q.e << ']';
  return out.str();
}

std::string text(const Event& event) {
  std::ostringstream out;
  out.precision(17);
  out << "t = " << event.t << ": " << name(event);
  if (event.kind != Event::Kind::flip) {
    if (event.i != container_id) write_state(out, event.first);
    if (event.kind == Event::Kind::collision) write_state(out, event.second);
  }
  return out.str();
}

std::size_t RecordedRun::count(Event::Kind kind) const {
  std::size_t n = 0;
  for (const Event& e : events) n += e.kind == kind;
  return n;
}

RecordedRun run(const Scene& scene, const MotionOptions& options,
                std::function<bool(double t, std::uint64_t events)> monitor) {
  EngineOptions engine_options;
  engine_options.motion = options;
  engine_options.monitor = std::move(monitor);
  return run_with(scene, engine_options);
}

RecordedRun run_with(const Scene& scene, const EngineOptions& options) {
  RecordedRun result;
  Recorder recorder(result);
  Engine engine(motion_input(scene), maneuver_input(scene), options);
  result.outcome = engine.run(recorder);
  note_end(engine, result);
  return result;
}

RecordedRun resume(const Scene& scene, std::size_t events, const EngineOptions& options,
                   Keeping keeping, std::size_t& kept) {
  std::optional<KeptRun> left;
  std::size_t marked = 0;
  EngineOptions first = options;
  RecordedRun begun;
  const bool asks = keeping == Keeping::asked_for;
  const auto is_far = [&] { return begun.events.size() >= events; };
  first.is_to_keep = [&] { return asks && !left && is_far(); };
  first.mark = [&] { marked = begun.events.size(); };
  first.keep = [&](KeptRun&& run) {
    if (run.events != marked) throw std::logic_error("kept at another place than was marked");
    left = std::move(run);
  };
  first.monitor = [&](double, std::uint64_t) { return asks ? !left : !is_far(); };
  {
    Recorder recorder(begun);
    Engine engine(motion_input(scene), maneuver_input(scene), first);
    begun.outcome = engine.run(recorder);
    note_end(engine, begun);
  }
  kept = left ? left->events : 0;
  if (!left) return begun.complete() ? begun : run_with(scene, options);
  begun.events.resize(kept);
  const std::vector<Event> told = begun.events;
  Recorder recorder(begun);
  Engine engine(motion_input(scene), maneuver_input(scene), options);
  begun.outcome = engine.resume(
      *left,
      [&](EventSink& sink) {
        for (const Event& event : told) tell_event(event, sink);
      },
      recorder);
  note_end(engine, begun);
  return begun;
}

std::vector<std::string> names(const RecordedRun& run) {
  std::vector<std::string> result;
  for (const Event& e : run.events) result.push_back(name(e));
  return result;
}

std::string difference(const RecordedRun& a, const RecordedRun& b) {
  if (a.outcome.kind != b.outcome.kind) return "outcomes";
  if (a.initial != b.initial) return "initial diagrams";
  for (std::size_t k = 0; k < a.events.size() && k < b.events.size(); ++k) {
    if (!same_event(a.events[k], b.events[k])) {
      return "event " + std::to_string(k) + ": " + text(a.events[k]) + " and " + text(b.events[k]);
    }
  }
  if (a.events.size() != b.events.size()) {
    return std::to_string(a.events.size()) + " and " + std::to_string(b.events.size()) + " events";
  }
  return "";
}

}  // namespace voroproof::internal::testing
