#include "bench/tasks.h"

#include <algorithm>
#include <random>

#include "bench/plain_motion.h"
#include "engine/engine.h"
#include "library/maneuver_input.h"

namespace voroproof::internal::bench {

namespace {

double first_contact(const PlainMotion& motion, const Quad& q, double horizon) {
  const GenId ids[4] = {q.l, q.r, q.s, q.e};
  double end = horizon;
  for (int a = 0; a < 4; ++a) {
    for (int b = a + 1; b < 4; ++b) {
      const auto [i, j] = std::minmax(ids[a], ids[b]);
      const NextContact c = motion.contact(i, j, 0, end);
      if (c.kind == NextContact::Kind::at) end = std::min(end, c.lo);
    }
  }
  return end;
}

struct HitRecorder : EventSink {
  std::vector<Hit> hits;
  void begin(const std::vector<Quad>&) override {}
  void flip(double, const Quad&) override {}
  void collide(double t, GenId i, GenId j, const RoundedState&, const RoundedState&) override {
    hits.push_back({t, i, j});
  }
  void maneuver(double, GenId, const RoundedState&) override {}
};

}  // namespace

std::vector<FlipTask> flip_tasks(const DataSet& set, double horizon) {
  std::vector<FlipTask> out;
  const PlainMotion motion(*set.motion);
  for (const Quad& q : set.quads) {
    const double end = first_contact(motion, q, horizon);
    if (end > 0) out.push_back({q, end});
  }
  return out;
}

Collapse certified_collapse(CollapseSearch& search, const FlipTask& task) {
  return through_window(
      task, [&](const Quad& q, double start, double end) { return search.after(q, start, end); });
}

std::vector<IncircleTask> incircle_tasks(const DataSet& set) {
  std::mt19937_64 random(1);
  std::vector<IncircleTask> out;
  for (const Quad& q : set.quads) {
    out.push_back({q, static_cast<double>(random() >> 11) * 0x1p-53});
  }
  return out;
}

std::vector<std::pair<GenId, GenId>> neighbours(const DataSet& set) {
  std::vector<std::pair<GenId, GenId>> out;
  for (const Quad& q : set.quads) out.push_back(std::minmax(q.l, q.r));
  return out;
}

std::vector<Hit> hits_of(Scene scene, double horizon) {
  scene.horizon = to_rational(horizon);
  Engine engine(motion_input(scene), {}, {});
  HitRecorder recorder;
  engine.run(recorder);
  return recorder.hits;
}

}  // namespace voroproof::internal::bench
