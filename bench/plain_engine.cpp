#include "bench/plain_engine.h"

#include "bench/plain_motion.h"
#include "engine/processing.h"

namespace voroproof::internal::bench {

namespace {

// Arithmetic in plain doubles, with the members of Certified (engine/certified.h).
class PlainDoubles {
 public:
  PlainDoubles(Motion& motion, EngineStats&) : plain_(motion) {}

  const Instant& now() const { return now_; }
  void begin(const std::vector<TimedEvent>& events) { set(events.front().lo); }
  void is_at(const Rational& t) { set(round_nearest(t)); }
  void note_flip(const Quad&) {}
  void after_changes() {}

  Collapse collapse_from_now(const Quad& q, double end) { return plain_.collapse(q, now_.lo, end); }
  Collapse collapse_after(const Quad& q, double start, double end, const RootInterval*) {
    return plain_.collapse(q, start, end);
  }
  NextContact contact_from_now(GenId i, GenId j, double end) {
    return plain_.contact(i, j, now_.lo, end);
  }
  bool has_points() const { return false; }
  bool is_point(GenId) const { return false; }
  void require_area(GenId, const std::vector<GenId>&) const {}
  // Nothing is told to happen within an instant.
  bool certainly_apart(GenId, GenId) const { return true; }

  TimedEvent rough(const FoundEvent& event) const { return tight(event); }
  TimedEvent tight(const FoundEvent& event) const {
    const double t = event.exactly != nullptr ? round_nearest(*event.exactly)
                                              : 0.5 * (event.at.lo + event.at.hi);
    return {event, t, t, DdBall(t), true};
  }
  int order(const TimedEvent& a, const TimedEvent& b) {
    if (a.lo != b.lo) return a.lo < b.lo ? -1 : 1;
    return a.event.item < b.event.item ? -1 : 1;
  }
  double rounded(const TimedEvent& event) { return event.lo; }

  long settle(Diagram&) { return 0; }
  Impact collide(GenId i, GenId j, bool) { return plain_.collide(i, j, now_.lo); }
  RoundedState maneuver(GenId disk, const Rational&, const Rational& vx, const Rational& vy) {
    return plain_.maneuver(disk, now_.lo, vx.get_d(), vy.get_d());
  }

 private:
  void set(double t) {
    now_.lo = now_.hi = t;
    now_.dd = DdBall(t);
  }

  PlainMotion plain_;
  Instant now_;
};

}  // namespace

class PlainEngine::Implementation : public EngineOver<PlainDoubles> {
 public:
  using EngineOver<PlainDoubles>::EngineOver;
};

PlainEngine::PlainEngine(MotionInput input, std::vector<ManeuverInput> maneuvers,
                         EngineOptions options)
    : implementation_(std::make_unique<Implementation>(std::move(input), std::move(maneuvers),
                                                       std::move(options))) {}
PlainEngine::~PlainEngine() = default;
Outcome PlainEngine::run(EventSink& sink) { return implementation_->run(sink); }
const EngineStats& PlainEngine::stats() const { return implementation_->stats(); }

}  // namespace voroproof::internal::bench
