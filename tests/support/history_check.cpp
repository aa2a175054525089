#include "tests/support/history_check.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <map>
#include <string>
#include <vector>

#include "tests/support/checked_run.h"
#include "tests/support/diagram_check.h"
#include "tests/support/motion_check.h"

namespace voroproof::internal::testing {
namespace {

template <unsigned Digits>
void check(const Scene& scene, const RecordedRun& run, const HistoryCheck& check,
           CheckCounts& counts) {
  const CheckedRun<Digits> checked(scene, run, check, counts);
  MotionCheck<Digits>(checked).run_all();
  DiagramCheck<Digits>(checked).run_all();
}

}  // namespace

oracle::MotionScene oracle_scene(const Scene& scene) {
  oracle::MotionScene result;
  result.container = {scene.cx, scene.cy, scene.container_radius};
  result.wall_restitution = scene.container_restitution;
  result.wall_law =
      scene.law == ContainerLaw::normal ? oracle::WallLaw::normal : oracle::WallLaw::whole;
  result.disk_restitution = scene.restitution;
  for (const DiskInput& d : scene.disks) {
    result.disks.push_back({d.x, d.y, d.vx, d.vy, d.radius, d.mass});
  }
  return result;
}

// A maneuver at the instant of an earlier event of its
// disk is moved by less than anything here resolves, since the oracle rounds that event's time.
std::vector<oracle::MotionRecord> motion_records(const Scene& scene, const RecordedRun& run) {
  const Rational nudge(1, Integer(1) << 700);
  std::vector<oracle::MotionRecord> records;
  std::map<int, double> last;
  std::vector<std::size_t> done(scene.disks.size(), 0);
  for (const Event& e : run.events) {
    if (e.kind == Event::Kind::collision) {
      records.push_back(oracle::collision(e.i, e.j));
      last[e.i] = last[e.j] = e.t;
    } else if (e.kind == Event::Kind::maneuver) {
      // The k-th maneuver of the disk.
      std::size_t k = done.at(static_cast<std::size_t>(e.i))++;
      const auto it = std::find_if(scene.maneuvers.begin(), scene.maneuvers.end(),
                                   [&](const Maneuver& m) { return m.disk == e.i && k-- == 0; });
      if (it == scene.maneuvers.end()) throw Fault("a maneuver too many: " + text(e));
      const bool shared = last.count(e.i) != 0 && last[e.i] == e.t;
      records.push_back(
          oracle::maneuver(e.i, shared ? Rational(it->t + nudge) : it->t, it->vx, it->vy));
      last[e.i] = e.t;
    }
  }
  return records;
}

std::vector<oracle::Quadruple> quadruples(const std::vector<Quad>& edges) {
  std::vector<oracle::Quadruple> result;
  for (const Quad& q : edges) result.push_back({q.l, q.r, q.s, q.e});
  return result;
}

CheckCounts& CheckCounts::operator+=(const CheckCounts& o) {
  brute_force += o.brute_force;
  cgal += o.cgal;
  legality += o.legality;
  flip_times += o.flip_times;
  ties += o.ties;
  skipped += o.skipped;
  return *this;
}

std::string check_history(const Scene& scene, const RecordedRun& run, const HistoryCheck& options,
                          CheckCounts* counts) {
  CheckCounts seen;
  std::string fault;
  try {
    // 300 digits carry some 70 collisions of one causal chain.
    if (run.count(Event::Kind::collision) <= 50) {
      check<300>(scene, run, options, seen);
    } else {
      check<1000>(scene, run, options, seen);
    }
  } catch (const std::exception& e) {
    fault = e.what();
  }
  if (counts != nullptr) *counts += seen;
  return fault;
}

}  // namespace voroproof::internal::testing
