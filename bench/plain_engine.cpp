#include "bench/plain_engine.h"

#include "bench/plain_motion.h"
#include "engine/processing.h"

namespace voroproof::internal::bench {

namespace {

// Arithmetic in plain doubles, with the members of Certified (engine/certified.h).
class PlainDoubles {
 public:
  PlainDoubles(Motion& motion, EngineStats&) : plain_(motion) {}

  const Moment& now() const { return now_; }
  void begin(const std::vector<FoundEvent>& events) { is_at(events.front()); }
  void is_at(const Moment& m) { now_ = Moment::at(m.dd.hi); }
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

  void tighten(Moment& m) const { m.narrow_to(DdBall(m.dd.hi)); }
  int order(const FoundEvent& a, const FoundEvent& b) {
    if (a.lo != b.lo) return a.lo < b.lo ? -1 : 1;
    return a.item < b.item ? -1 : 1;
  }
  double rounded(const Moment& m) { return m.dd.hi; }

  long settle(Diagram&) { return 0; }
  Impact collide(GenId i, GenId j, bool) { return plain_.collide(i, j, now_.lo); }
  RoundedState maneuver(GenId disk, const Rational&, const Rational& vx, const Rational& vy) {
    return plain_.maneuver(disk, now_.lo, vx.get_d(), vy.get_d());
  }

 private:
  PlainMotion plain_;
  Moment now_;
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
