// The true motion, in 300 digits, held against what a history says of it.
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "tests/adversary/bounds.h"
#include "tests/adversary/diagrams.h"
#include "tests/oracle/motion.h"

namespace voroproof::adversary {
namespace {

using Exact = oracle::MotionOracle;
using MovedTo = oracle::ManeuverRecord;

Wide wide(const Exact::Number& x) {
  const double a = static_cast<double>(x);
  const Exact::Number rest = x - a;
  const double b = static_cast<double>(rest);
  return Wide(a) + b + static_cast<double>(Exact::Number(rest - b));
}

oracle::MotionScene motion_scene(const SceneData& s) {
  oracle::MotionScene scene;
  scene.container = {s.cx, s.cy, s.radius};
  scene.wall_restitution = s.wall_restitution;
  scene.wall_law = s.whole ? oracle::WallLaw::whole : oracle::WallLaw::normal;
  scene.disk_restitution = s.restitution;
  for (const DiskData& d : s.disks) {
    scene.disks.push_back({d.x, d.y, d.vx, d.vy, d.radius, d.mass});
  }
  return scene;
}

}  // namespace

Opinion judge_exact(const SceneData& scene, const History& history,
                    const std::vector<double>& hints) {
  std::vector<oracle::MotionRecord> records;
  std::vector<const Line*> lines;
  std::vector<bool> done(scene.maneuvers.size());
  double last = 0;
  for (const Line& line : history.lines) {
    if (line.t < last || line.t > history.horizon) return wrong("times out of order");
    last = line.t;
    if (line.kind == Line::Kind::flip) continue;
    lines.push_back(&line);
    if (line.kind == Line::Kind::collide) {
      records.push_back(oracle::collision(line.i, line.j));
      continue;
    }
    bool found = false;
    for (std::size_t k = 0; k < done.size() && !found; ++k) {
      const ManeuverData& m = scene.maneuvers[k];
      if (done[k] || m.disk != line.j || std::fabs(m.t - line.t) > 1.1 * tolerance) continue;
      found = done[k] = true;
      if (m.t > history.horizon) return wrong("a maneuver after the horizon");
      records.push_back(oracle::maneuver(m.disk, m.t, m.vx, m.vy));
    }
    if (!found) return wrong("no such maneuver: " + text(line));
  }
  for (std::size_t k = 0; k < done.size(); ++k) {
    if (!done[k] && scene.maneuvers[k].t <= history.horizon) return wrong("a maneuver is missing");
  }
  std::optional<Exact> exact;
  try {
    exact.emplace(motion_scene(scene), records);
  } catch (const std::invalid_argument& error) {
    const std::string why = error.what();
    return why.find("before an earlier") != why.npos ? unclear(why) : wrong(why);
  }

  Motion motion;
  motion.scene = &scene;
  std::vector<double> turns;
  for (const DiskData& d : scene.disks) {
    motion.paths.emplace_back(Piece{0, {d.x, d.y}, {d.vx, d.vy}});
  }
  // Of several turns at one instant the oracle gives the last one's velocity.
  const auto velocity_after = [&](std::size_t k, int id) {
    const auto& t = exact->times()[k];
    if (k + 1 == lines.size() || exact->times()[k + 1] - t > 1e-60) return exact->velocity(id, t);
    const std::vector<oracle::MotionRecord> first(
        records.begin(), records.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    return Exact(motion_scene(scene), first).velocity(id, t);
  };
  Finding f = Finding::right;
  std::string why;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Line& line = *lines[k];
    const Wide t = wide(exact->times()[k]);
    turns.push_back(static_cast<double>(t));
    const auto note = [&](Finding g, const char* reason) {
      f = both(f, g);
      if (g != Finding::right) why = reason + (" at " + text(line));
    };
    const Wide off = t - line.t;
    note(within(off < 0 ? -off : off, tolerance), "another time");
    if (t > history.horizon) {
      note(t > history.horizon * (1 + 1e-15) ? Finding::wrong : Finding::unclear,
           "after the horizon");
    }
    // What the bound of velocities is made of: both before a collision, the scheduled one.
    Wide speed = 0, most_speed = 0;
    if (line.kind == Line::Kind::maneuver) {
      const MovedTo& m = *records[k].maneuver;
      speed = std::hypot(m.vx.get_d(), m.vy.get_d());
      most_speed = std::fabs(m.vx.get_d()) + std::fabs(m.vy.get_d());
    } else {
      for (const int id : {line.i, line.j}) {
        if (id < 0) continue;
        speed += norm(motion.paths[static_cast<std::size_t>(id)].last().v);
        most_speed += length_bound(motion.paths[static_cast<std::size_t>(id)].last().v);
      }
    }
    if (line.kind == Line::Kind::collide && line.i >= 0) {
      // Of a pair that hardly approaches no digits say whether it does.
      const WideVec w = minus(motion.paths[static_cast<std::size_t>(line.j)].last().v,
                              motion.paths[static_cast<std::size_t>(line.i)].last().v);
      const Path &a = motion.paths[static_cast<std::size_t>(line.i)],
                 &b = motion.paths[static_cast<std::size_t>(line.j)];
      const Wide approach = -dot(w, minus(Path::at(b.last(), t), Path::at(a.last(), t)));
      const bool hardly = approach < static_cast<Wide>(1e-9) * speed * motion.reach(line.i, line.j);
      note(hardly ? Finding::unclear : Finding::right, "hardly an approach");
    }
    if (line.kind == Line::Kind::collide && history.velocities && history.centres) {
      // Whether a line must obey the law in itself, with its own centres, is left open here.
      const auto at = [&](int id, std::size_t side) {
        return id < 0 ? WideVec{scene.cx, scene.cy} : wide(line.p[side]);
      };
      const auto before = [&](int id) {
        return id < 0 ? WideVec{} : motion.paths[static_cast<std::size_t>(id)].last().v;
      };
      const auto v =
          response(scene, line, {at(line.i, 0), at(line.j, 1)}, {before(line.i), before(line.j)});
      const Wide bound = law_tolerance * speed / 2;
      const bool obeyed =
          within(norm(minus(wide(line.v[1]), v[1])), bound) == Finding::right &&
          (line.i < 0 || within(norm(minus(wide(line.v[0]), v[0])), bound) == Finding::right);
      note(obeyed ? Finding::right : Finding::unclear, "the law with the file's centres");
    }
    for (const int side : {0, 1}) {
      const int id = side == 0 ? line.i : line.j;
      if (id < 0 || (side == 0 && line.kind == Line::Kind::maneuver)) continue;
      Path& path = motion.paths[static_cast<std::size_t>(id)];
      const auto p = exact->position(id, exact->times()[k]);
      const auto v = velocity_after(k, id);
      const WideVec before = path.last().v;
      const Piece piece{t, {wide(p[0]), wide(p[1])}, {wide(v[0]), wide(v[1])}};
      path.put(piece);
      const auto s = static_cast<std::size_t>(side);
      const Wide reach = motion.reach(line.kind == Line::Kind::maneuver ? -1 : line.i, id);
      const auto bound = [&](Wide of) {
        if (line.kind == Line::Kind::maneuver) return law_tolerance * of;
        return law_tolerance * of +
               std::min(4 * tolerance * of * of / reach, of * std::ldexp(1.0, -10));
      };
      if (history.velocities && speed > 0) {
        note(within(norm(minus(wide(line.v[s]), piece.v)), bound(speed), bound(most_speed)),
             "another velocity");
      }
      const Wide room =
          tolerance * (norm(before) + norm(piece.v)) + 2 * norm(piece.at) * std::ldexp(1.0, -53);
      const Wide most_room = tolerance * (length_bound(before) + length_bound(piece.v)) +
                             4 * length_bound(piece.at) * std::ldexp(1.0, -53);
      if (history.centres) {
        note(within(norm(minus(wide(line.p[s]), piece.at)), room, most_room), "another centre");
      }
    }
  }
  if (f == Finding::wrong) return wrong(why);
  const double extent = std::fabs(scene.cx) + std::fabs(scene.cy) + scene.radius;
  for (int i = -1; i < scene.size(); ++i) {
    for (int j = std::max(0, i + 1); j < scene.size(); ++j) {
      for (const Overlap& o : motion.overlaps(i, j, history.horizon)) {
        if (o.depth > extent * static_cast<Wide>(1e-20)) {
          return wrong("an overlap of " + std::to_string(i) + " and " + std::to_string(j) +
                       " from " + std::to_string(static_cast<double>(o.from)));
        }
      }
    }
  }
  const Opinion diagrams = judge_diagrams(motion, history, history.horizon, turns, hints);
  if (diagrams.finding != Finding::right) return diagrams;
  return {f, why};
}

}  // namespace voroproof::adversary
