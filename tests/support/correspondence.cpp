#include "tests/support/correspondence.h"
#include "tests/support/compact_arithmetic.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "exact/topology/diagram.h"
#include "tests/oracle/brute_force.h"
#include "tests/support/history_check.h"

namespace voroproof::internal::testing {
namespace {

// Gaps between instants below this part of the later one are too narrow to look into.
constexpr double kNarrow = 1e-9;
// Instants between events at which the brute-force diagram is made.
constexpr std::size_t kInstants = 6;

bool is_motion(const Event& e) { return e.kind != Event::Kind::flip; }

// The diagram of a run as time goes on.
class Replay {
 public:
  Replay(const Scene& scene, const RecordedRun& run)
      : run_(run), diagram_(diagram_of(static_cast<int>(scene.disks.size()), run.initial)) {}

  void go_to(double t) {
    for (; next_ < run_.events.size() && run_.events[next_].t <= t; ++next_) {
      const Event& e = run_.events[next_];
      if (is_motion(e)) continue;
      Diagram::HalfEdge h = 0;
      while (h < 2 * diagram_.edges() && diagram_.quad(h) != e.edge) ++h;
      if (h == 2 * diagram_.edges()) throw std::runtime_error("no such edge: " + text(e));
      diagram_.flip(h);
    }
  }
  std::vector<Quad> edges() const { return diagram_.quads(); }

 private:
  const RecordedRun& run_;
  Diagram diagram_;
  std::size_t next_ = 0;
};

std::vector<Quad> mapped(const std::vector<Quad>& edges, const Image& image) {
  std::vector<Quad> result;
  for (const Quad& q : edges) result.push_back(image.edge(q));
  std::sort(result.begin(), result.end());
  return result;
}

// A collision or maneuver as its instant, kind and disks.
struct MotionEvent {
  double t;
  bool collision;
  std::pair<GenId, GenId> disks;
  auto operator<=>(const MotionEvent&) const = default;
};

std::vector<MotionEvent> motion_of(const RecordedRun& run, const Image& image) {
  std::vector<MotionEvent> events;
  for (const Event& e : run.events) {
    if (!is_motion(e)) continue;
    events.push_back(
        {e.t, e.kind == Event::Kind::collision, std::minmax({image.id(e.i), image.id(e.j)})});
  }
  return events;
}

// The two times are roundings of one number, in different tempos.
bool same_time(double t, double image_t, const Image& image) {
  const double scaled = t * image.time.get_d();
  return std::fabs(image_t - scaled) <= 1e-14 * scaled;
}

std::string motion_difference(const RecordedRun& run, const Image& image,
                              const RecordedRun& image_run) {
  std::vector<MotionEvent> ours = motion_of(run, image), theirs = motion_of(image_run, {});
  if (!image.ids.empty()) {
    std::sort(ours.begin(), ours.end());
    std::sort(theirs.begin(), theirs.end());
  }
  if (ours.size() != theirs.size()) return "numbers of collisions or maneuvers";
  for (std::size_t k = 0; k < ours.size(); ++k) {
    if (ours[k].collision != theirs[k].collision || ours[k].disks != theirs[k].disks ||
        !same_time(ours[k].t, theirs[k].t, image))
      return "collision or maneuver " + std::to_string(k);
  }
  return "";
}

std::set<double> instants_of(const RecordedRun& run) {
  std::set<double> instants{0};
  for (const Event& e : run.events) instants.insert(e.t);
  return instants;
}

// The maneuvers in the order in which they take place.
std::vector<Maneuver> sorted(std::vector<Maneuver> maneuvers) {
  std::sort(maneuvers.begin(), maneuvers.end(), [](const Maneuver& a, const Maneuver& b) {
    return a.t != b.t ? a.t < b.t : a.disk < b.disk;
  });
  return maneuvers;
}

// The collisions and maneuvers of a run, for the oracle of motion.
std::vector<oracle::MotionRecord> records_of(const Scene& scene, const RecordedRun& run) {
  const std::vector<Maneuver> maneuvers = sorted(scene.maneuvers);
  std::vector<oracle::MotionRecord> records;
  std::size_t next_maneuver = 0;
  for (const Event& e : run.events) {
    if (e.kind == Event::Kind::collision) {
      records.push_back(oracle::collision(e.i, e.j));
    } else if (e.kind == Event::Kind::maneuver) {
      const Maneuver& m = maneuvers.at(next_maneuver++);
      records.push_back(oracle::maneuver(m.disk, m.t, m.vx, m.vy));
    }
  }
  return records;
}

std::string difference_modulo_cotangency(const Scene& scene, const RecordedRun& run,
                                         const Image& image, const RecordedRun& image_run) {
  Image back;
  back.ids.resize(image.ids.size());
  for (std::size_t i = 0; i < image.ids.size(); ++i)
    back.ids[static_cast<std::size_t>(image.ids[i])] = static_cast<int>(i);
  const oracle::MotionScene motion_scene = oracle_scene(scene);
  const oracle::BasicMotionOracle<300> motion(motion_scene, records_of(scene, run));
  const oracle::Circle container = oracle::rounded(motion_scene.container);

  std::set<double> instants = instants_of(run);
  instants.merge(instants_of(image_run));
  instants.insert(scene.horizon.get_d());
  const std::size_t step = std::max<std::size_t>(1, instants.size() / kInstants);
  Replay replay(scene, image_run);
  std::size_t k = 0;
  for (auto from = instants.begin(), to = std::next(from); to != instants.end(); ++from, ++to) {
    if (k++ % step != 0 || *to - *from < kNarrow * *to) continue;
    const double between = 0.5 * (*from + *to);
    replay.go_to(between);
    const std::vector<Quad> edges = mapped(replay.edges(), back);
    const oracle::BruteDiagram truth =
        oracle::brute_force_diagram(motion.disks_at(between), container);
    std::string why;
    if (!oracle::agrees(truth, quadruples(edges), &why))
      return "at t = " + std::to_string(between) + ": " + why;
  }
  return "";
}

}  // namespace

Quad Image::edge(const Quad& q) const {
  const Quad renamed{id(q.l), id(q.r), id(q.s), id(q.e)};
  if (!mirrored()) return canonical(renamed);
  return canonical(Quad{renamed.r, renamed.l, renamed.s, renamed.e});
}

Scene image_of(const Scene& scene, const Image& image) {
  const auto turn = [&](Rational& x, Rational& y) {
    const Rational turned = image.xx * x + image.xy * y;
    y = image.yx * x + image.yy * y;
    x = turned;
  };
  const auto move = [&](Rational& x, Rational& y) {
    turn(x, y);
    x += image.dx;
    y += image.dy;
  };
  const auto move_velocity = [&](Rational& x, Rational& y) {
    turn(x, y);
    x /= image.time;
    y /= image.time;
  };
  Scene result = scene;
  move(result.cx, result.cy);
  result.container_radius *= image.length;
  result.horizon *= image.time;
  for (std::size_t i = 0; i < scene.disks.size(); ++i) {
    DiskInput& d = result.disks[static_cast<std::size_t>(image.id(static_cast<GenId>(i)))];
    d = scene.disks[i];
    change_both(d.x, d.y, move);
    change_both(d.vx, d.vy, move_velocity);
    d.radius *= image.length;
  }
  for (Maneuver& m : result.maneuvers) {
    m.disk = image.id(m.disk);
    m.t *= image.time;
    move_velocity(m.vx, m.vy);
  }
  return result;
}

std::vector<Quad> diagram_after(const Scene& scene, const RecordedRun& run, double t) {
  Replay replay(scene, run);
  replay.go_to(t);
  return replay.edges();
}

std::string difference_from_image(const Scene& scene, const RecordedRun& run, const Image& image,
                                  const RecordedRun& image_run) {
  const std::string motion = motion_difference(run, image, image_run);
  if (!motion.empty()) return motion;
  if (!image.ids.empty()) return difference_modulo_cotangency(scene, run, image, image_run);
  if (!image.mirrored()) {
    if (run.initial != image_run.initial) return "initial diagrams";
    if (names(run) != names(image_run)) return "events";
    for (std::size_t k = 0; k < run.events.size(); ++k) {
      if (!same_time(run.events[k].t, image_run.events[k].t, image))
        return "the time of event " + std::to_string(k);
    }
    return "";
  }
  const std::set<double> ours = instants_of(run), theirs = instants_of(image_run);
  if (ours.size() != theirs.size()) return "numbers of instants";
  Replay replay(scene, run), image_replay(scene, image_run);
  for (auto t = ours.begin(), u = theirs.begin(); t != ours.end(); ++t, ++u) {
    if (!same_time(*t, *u, image)) return "an instant, " + std::to_string(*t);
    replay.go_to(*t);
    image_replay.go_to(*u);
    if (mapped(replay.edges(), image) != image_replay.edges())
      return "diagrams after t = " + std::to_string(*t);
  }
  return "";
}

bool shares_a_disk_at_an_instant(const RecordedRun& run) {
  std::map<GenId, double> last;
  for (const Event& e : run.events) {
    if (e.kind != Event::Kind::collision) continue;
    for (const GenId g : {e.i, e.j}) {
      if (g == container_id) continue;
      const auto [place, first] = last.emplace(g, e.t);
      if (!first && place->second == e.t) return true;
      place->second = e.t;
    }
  }
  return false;
}

std::optional<Scene> rest_of(const Scene& scene, const RecordedRun& run, const Rational& t) {
  Scene rest = scene;
  rest.maneuvers = sorted(scene.maneuvers);
  std::vector<Rational> since(scene.disks.size());
  const auto advance = [&](GenId g, const Rational& to) -> DiskInput& {
    DiskInput& d = rest.disks[static_cast<std::size_t>(g)];
    Rational& from = since[static_cast<std::size_t>(g)];
    const Rational passed = to - from;
    d.x += passed * d.vx;
    d.y += passed * d.vy;
    from = to;
    return d;
  };
  std::size_t next_maneuver = 0;
  for (const Event& e : run.events) {
    if (to_rational(e.t) > t) break;
    if (e.kind == Event::Kind::maneuver) {
      const Maneuver& m = rest.maneuvers.at(next_maneuver++);
      DiskInput& d = advance(m.disk, m.t);
      d.vx = m.vx;
      d.vy = m.vy;
    } else if (e.kind == Event::Kind::collision) {
      // Counted from the later of both references: |p + s w| = reach.
      const bool wall = e.i == container_id;
      const Rational base = wall ? since[static_cast<std::size_t>(e.j)]
                                 : std::max(since[static_cast<std::size_t>(e.i)],
                                            since[static_cast<std::size_t>(e.j)]);
      DiskInput resting;  // the container
      resting.x = scene.cx;
      resting.y = scene.cy;
      DiskInput& a = wall ? resting : advance(e.i, base);
      DiskInput& b = advance(e.j, base);
      const Rational px = b.x - a.x, py = b.y - a.y, wx = b.vx - a.vx, wy = b.vy - a.vy;
      const Rational reach = wall ? scene.container_radius - b.radius : a.radius + b.radius;
      const Rational aa = wx * wx + wy * wy, bb = px * wx + py * wy;
      const auto root = rational_sqrt(bb * bb - aa * (px * px + py * py - reach * reach));
      if (!root) return std::nullopt;
      const Rational contact = base + (wall ? Rational(*root - bb) : Rational(-*root - bb)) / aa;
      if (!wall) advance(e.i, contact);
      advance(e.j, contact);
      const Rational nx = b.x - a.x, ny = b.y - a.y;
      const Rational along = ((b.vx - a.vx) * nx + (b.vy - a.vy) * ny) / (nx * nx + ny * ny);
      if (wall) {
        b.vx -= Rational(2 * along * nx);
        b.vy -= Rational(2 * along * ny);
      } else {
        const Rational share = 2 * along / (a.mass + b.mass);
        a.vx += share * b.mass * nx;
        a.vy += share * b.mass * ny;
        b.vx -= share * a.mass * nx;
        b.vy -= share * a.mass * ny;
      }
    }
  }
  for (std::size_t g = 0; g < rest.disks.size(); ++g) advance(static_cast<GenId>(g), t);
  rest.horizon -= t;
  rest.maneuvers.erase(rest.maneuvers.begin(),
                       rest.maneuvers.begin() + static_cast<long>(next_maneuver));
  for (Maneuver& m : rest.maneuvers) m.t -= t;
  return rest;
}

std::string difference_from_parts(const Scene& scene, const RecordedRun& whole, const Rational& t,
                                  const RecordedRun& beginning, const RecordedRun* end) {
  if (beginning.initial != whole.initial) return "initial diagrams";
  if (beginning.final_diagram != diagram_after(scene, whole, t.get_d())) return "diagrams at t";
  const std::vector<std::string> expected = names(whole);
  std::vector<std::string> parts = names(beginning);
  const std::size_t first = parts.size();
  if (first > expected.size() || !std::equal(parts.begin(), parts.end(), expected.begin()))
    return "events of the first part";
  if (end == nullptr) return "";
  if (end->initial != beginning.final_diagram) return "the initial diagram of the second part";
  const std::vector<std::string> later = names(*end);
  parts.insert(parts.end(), later.begin(), later.end());
  if (parts != expected) return "events of the second part";
  for (std::size_t k = 0; k < end->events.size(); ++k) {
    const double expected_t = whole.events[first + k].t;
    if (std::fabs(end->events[k].t + t.get_d() - expected_t) > 1e-14 * (1 + expected_t))
      return "the time of event " + std::to_string(first + k);
  }
  return "";
}

}  // namespace voroproof::internal::testing
