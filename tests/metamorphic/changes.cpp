// Changes of a scene that leave its events, or some of them.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/metamorphic/maps.h"
#include "tests/metamorphic/relations.h"
#include "tests/support/compact_arithmetic.h"

namespace voroproof::internal::metamorphic {
namespace {

using adversary::Random;
using testing::Image;
using testing::RecordedRun;
using Happening = testing::Event;

// Whether the event is the maneuver, as far as it is written.
bool is_of(const Happening& e, const Maneuver& m) {
  return e.kind == Happening::Kind::maneuver && e.i == m.disk && e.t == round_nearest(m.t) &&
         e.first.vx == round_nearest(m.vx) && e.first.vy == round_nearest(m.vy);
}

void without(RecordedRun& run, const std::vector<Maneuver>& maneuvers) {
  const auto added = [&](const Happening& e) {
    return std::any_of(maneuvers.begin(), maneuvers.end(),
                       [&](const Maneuver& m) { return is_of(e, m); });
  };
  run.events.erase(std::remove_if(run.events.begin(), run.events.end(), added), run.events.end());
}

// A time at or beside an event, or any, before `end`.
Rational some_time(const RecordedRun& run, const Rational& end, Random& random) {
  if (!run.events.empty() && random.chance(0.7)) {
    const auto last = static_cast<int>(run.events.size()) - 1;
    double t = run.events[static_cast<std::size_t>(random.integer(0, last))].t;
    const int way = random.integer(-1, 1);
    if (way != 0) t = std::nextafter(t, way * std::numeric_limits<double>::infinity());
    return to_rational(std::max(t, 0.0));
  }
  return end * Rational(random.integer(0, 256), 256);
}

// Maneuvers to the velocities that disks have, while these are known exactly.
std::vector<Maneuver> still_maneuvers(const World& world, const RecordedRun& run, Random& random) {
  std::vector<Maneuver> all;
  for (int k = random.integer(1, 3); k > 0; --k) {
    const int disk = random.integer(0, static_cast<int>(world.scene.disks.size()) - 1);
    const Rational t = some_time(run, world.scene.horizon, random);
    if (t > world.scene.horizon) continue;
    bool known = true;
    for (const Happening& e : run.events) {
      const bool concerns = e.kind == Happening::Kind::collision && (e.i == disk || e.j == disk);
      known = known && !(concerns && to_rational(e.t) <= t);
    }
    const DiskInput& d = world.scene.disks[static_cast<std::size_t>(disk)];
    Maneuver m{t, disk, d.vx, d.vy};
    for (const Maneuver& before : world.scene.maneuvers) {
      known = known && !(before.disk == disk && round_nearest(before.t) == round_nearest(t));
      if (before.disk == disk && before.t < t) {
        m.vx = before.vx;
        m.vy = before.vy;
      }
    }
    for (const Maneuver& other : all) known = known && !(other.disk == disk && other.t == t);
    if (known) all.push_back(m);
  }
  return all;
}

void add(Scene& scene, const std::vector<Maneuver>& maneuvers) {
  scene.maneuvers.insert(scene.maneuvers.end(), maneuvers.begin(), maneuvers.end());
  std::stable_sort(scene.maneuvers.begin(), scene.maneuvers.end(),
                   [](const Maneuver& a, const Maneuver& b) { return a.t < b.t; });
}

// Collisions and maneuvers of disks with ids in [from, to), named from 0.
RecordedRun motions(const RecordedRun& run, int from, int to) {
  RecordedRun result;
  result.outcome = run.outcome;
  for (Happening e : run.events) {
    if (e.kind == Happening::Kind::flip || e.j < from || e.j >= to) continue;
    if (e.i != container_id) e.i -= from;
    e.j -= from;
    result.events.push_back(e);
  }
  return result;
}

Comparison compared(const std::string& difference, const Case& ours, const RecordedRun& run,
                    const Case& theirs, const RecordedRun& their_run) {
  if (!difference.empty()) {
    return {true, told("simulate: " + difference, ours, run, theirs, their_run)};
  }
  if (!run.complete()) return {true};
  return {true, own_verdicts(ours, run, theirs, their_run)};
}

// Whether a flip is written with the time of a later turn of one of its disks.
bool rounds_flip_to_turn(const RecordedRun& run) {
  std::vector<GenId> flipped;  // generators of the flips with the present time
  double t = -1;
  for (const testing::Event& e : run.events) {
    if (e.t > t) flipped.clear();
    t = e.t;
    const auto has_flipped = [&](GenId g) {
      return g != container_id && std::find(flipped.begin(), flipped.end(), g) != flipped.end();
    };
    if (e.kind == testing::Event::Kind::flip) {
      flipped.insert(flipped.end(), {e.edge.l, e.edge.r, e.edge.s, e.edge.e});
    } else if (has_flipped(e.i) || has_flipped(e.j)) {
      return true;
    }
  }
  return false;
}

// How far the centres come from the container's, along each axis.
double extent(const Scene& scene, const RecordedRun& run) {
  double far = 0;
  const auto look = [&](const Rational& x, const Rational& y) {
    far = std::max({far, std::fabs(Rational(x - scene.cx).get_d()),
                    std::fabs(Rational(y - scene.cy).get_d())});
  };
  struct Last {
    Rational t, x, y, vx, vy;
  };
  std::vector<Last> last;
  for (const DiskInput& d : scene.disks) {
    last.push_back({0, d.x, d.y, d.vx, d.vy});
    look(d.x, d.y);
  }
  const auto restart = [&](GenId g, double t, const RoundedState& s) {
    last[static_cast<std::size_t>(g)] = {to_rational(t), to_rational(s.px), to_rational(s.py),
                                         to_rational(s.vx), to_rational(s.vy)};
    look(to_rational(s.px), to_rational(s.py));
  };
  for (const Happening& e : run.events) {
    if (e.kind == Happening::Kind::flip) continue;
    if (e.i != container_id) restart(e.i, e.t, e.first);
    if (e.kind == Happening::Kind::collision) restart(e.j, e.t, e.second);
  }
  for (const Last& l : last) {
    const Rational left = scene.horizon - l.t;
    look(l.x + left * l.vx, l.y + left * l.vy);
  }
  return far;
}

bool meets_wall(const RecordedRun& run) {
  return std::any_of(run.events.begin(), run.events.end(), [](const Happening& e) {
    return e.i == container_id && e.j != container_id && e.kind == Happening::Kind::collision;
  });
}

// The cluster moved far away, or disks at rest there.
Scene others(Scene scene, Relation relation, const Rational& far, Random& random) {
  if (relation == Relation::side_by_side) {
    Image image;
    image.xx = image.yy = 0;
    image.xy = -1;
    image.yx = 1;
    image.dx = far + scene.cx + scene.cy;
    image.dy = scene.cy - scene.cx;
    Scene moved = testing::image_of(scene, image);
    moved.cx = scene.cx;
    moved.cy = scene.cy;
    return moved;
  }
  scene.disks.clear();
  scene.maneuvers.clear();
  for (int k = 0, n = random.integer(1, 5); k < n; ++k) {
    const Rational r = random.chance(0.3) ? Rational(0) : far / (20 + random.integer(0, 8));
    scene.disks.push_back(testing::disk(scene.cx + far * (random.chance(0.5) ? 1 : -1),
                                        scene.cy + far * Rational(2 * k - n, 8), r, 0, 0, 1));
  }
  return scene;
}

Scene joined(const Scene& a, const Scene& b) {
  Scene scene = a;
  const int first = static_cast<int>(a.disks.size());
  scene.disks.insert(scene.disks.end(), b.disks.begin(), b.disks.end());
  std::vector<Maneuver> moved = b.maneuvers;
  for (Maneuver& m : moved) m.disk += first;
  add(scene, moved);
  return scene;
}

}  // namespace

bool refused_for_rounding(const Answer& own, Truth truth, const RecordedRun& run) {
  return truth == Truth::recorded && own.fault == Fault::wrong_order && rounds_flip_to_turn(run);
}

std::optional<Contradiction> own_verdicts(const Case& our_case, const RecordedRun& our_run,
                                          const Case& their_case, const RecordedRun& their_run) {
  Case ours = our_case, theirs = their_case;
  ours.claim = testing::claimed_history(ours.scene, our_run);
  theirs.claim = testing::claimed_history(theirs.scene, their_run);
  for (const Truth truth : both_truths) {
    const Answer a = certified(ours, truth), b = certified(theirs, truth);
    if (a.verdict == b.verdict || a.verdict == "endless" || b.verdict == "endless") continue;
    if (refused_for_rounding(a, truth, our_run) || refused_for_rounding(b, truth, their_run)) {
      continue;
    }
    ours.answer = text(a);
    theirs.answer = text(b);
    return Contradiction{"certify, " + std::string(name_of(truth)), ours, theirs};
  }
  return std::nullopt;
}

Comparison compare_still_maneuvers(const World& world) {
  Random random = random_for(world, Relation::still_maneuvers);
  const Case ours{world.scene, {}, world.tolerance};
  const RecordedRun run = simulated(ours.scene);
  if (!run.complete()) return {};
  const auto maneuvers = still_maneuvers(world, run, random);
  if (maneuvers.empty()) return {};
  Scene scene = world.scene;
  add(scene, maneuvers);
  auto read = read_again(scene);
  if (!read) return {};
  const Case theirs{std::move(*read), {}, world.tolerance};
  Run their_run = simulated(theirs.scene);
  // A mirror image of which one side has a maneuver is none for what proves ties by symmetry: then
  // a tie may take more than the budget.
  const bool stopped = their_run.outcome.kind == Outcome::Kind::stopped;
  if (their_run.endless() || (stopped && !world.generic)) return {};
  const RecordedRun complete = their_run;
  without(their_run, maneuvers);
  std::string difference;
  if (world.generic) {
    difference = testing::difference(run, their_run);
  } else {
    // Flips of one instant may be told otherwise where a maneuver divides it.
    const int n = static_cast<int>(world.scene.disks.size());
    difference = testing::difference(motions(run, 0, n), motions(their_run, 0, n));
    if (difference.empty() && run.final_diagram != their_run.final_diagram) {
      difference = "the last diagram";
    }
  }
  return compared(difference, ours, run, theirs, complete);
}

Comparison compare_earlier_horizon(const World& world) {
  Random random = random_for(world, Relation::earlier_horizon);
  const Case ours{world.scene, {}, world.tolerance};
  RecordedRun run = simulated(ours.scene);
  if (!run.complete()) return {};
  const Rational end = some_time(run, world.scene.horizon, random);
  // What is at the very end may round to either side of it.
  const bool at_event = std::any_of(run.events.begin(), run.events.end(),
                                    [&](const Happening& e) { return to_rational(e.t) == end; });
  if (at_event || end > world.scene.horizon || sgn(end) == 0) return {};
  Case theirs{world.scene, {}, world.tolerance};
  theirs.scene.horizon = end;
  while (theirs.tolerance > end) theirs.tolerance /= 1024;
  const Run their_run = simulated(theirs.scene);
  if (their_run.endless()) return {};
  RecordedRun beginning = run;
  while (!beginning.events.empty() && to_rational(beginning.events.back().t) > end) {
    beginning.events.pop_back();
  }
  const std::string difference = testing::difference(beginning, their_run);
  Comparison comparison = compared(difference, ours, run, theirs, their_run);
  // What an event within the tolerance after the horizon has begun may be undecided without it.
  const bool begun = beginning.events.size() < run.events.size() &&
                     to_rational(run.events[beginning.events.size()].t) - end <= theirs.tolerance;
  if (begun && comparison.found && comparison.found->theirs.answer.starts_with("undecided")) {
    return {};
  }
  return comparison;
}

Comparison compare_clusters(const World& world, Relation relation) {
  Random random = random_for(world, relation);
  Case ours{world.scene, {}, world.tolerance};
  ours.scene.container_radius *= Rational(1 << 20);
  const RecordedRun run = simulated(ours.scene);
  if (!run.complete() || meets_wall(run)) return {};
  const double reach = extent(ours.scene, run) + world.scene.container_radius.get_d();
  const Rational far = 16 * to_rational(reach);
  if (4 * far > ours.scene.container_radius) return {};
  const Scene second = others(ours.scene, relation, far, random);
  auto read = read_again(joined(ours.scene, second));
  if (!read || !read_again(second)) return {};
  const Case theirs{std::move(*read), {}, world.tolerance};
  const Run their_run = simulated(theirs.scene);
  // Together the numbers are longer, and a tie may take more than the budget.
  if (!their_run.complete()) return {};
  const int n = static_cast<int>(ours.scene.disks.size());
  const int all = static_cast<int>(theirs.scene.disks.size());
  std::string difference = testing::difference(motions(run, 0, n), motions(their_run, 0, n));
  if (difference.empty()) {
    const RecordedRun alone = simulated(second);
    difference = testing::difference(motions(alone, 0, all - n), motions(their_run, n, all));
  }
  Comparison comparison = compared(difference, ours, run, theirs, their_run);
  // Edges between the clusters may have ties of their own.
  if (comparison.found && comparison.found->theirs.answer.starts_with("undecided")) return {};
  return comparison;
}

}  // namespace voroproof::internal::metamorphic
