// The rules of docs/formats.md, section 6 and of the tolerances, as the oracle reads them.
#include "tests/adversary/truth.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "tests/adversary/diagrams.h"
#include "tests/oracle/motion.h"

namespace voroproof::adversary {
namespace {

Opinion wrong(const std::string& why) { return {Finding::wrong, why}; }
Opinion unclear(const std::string& why) { return {Finding::unclear, why}; }

Wide norm(const WideVec& a) { return square_root(a.x * a.x + a.y * a.y); }
// A bound of the length, as a certifier may take it.
Wide length_bound(const WideVec& a) { return (a.x < 0 ? -a.x : a.x) + (a.y < 0 ? -a.y : a.y); }
Wide dot(const WideVec& a, const WideVec& b) { return a.x * b.x + a.y * b.y; }
WideVec minus(const WideVec& a, const WideVec& b) { return {a.x - b.x, a.y - b.y}; }
WideVec wide(const Pair2& v) { return {v[0], v[1]}; }

// Within the bound, beyond it, or too near to it to say.
Finding within(Wide value, Wide bound) {
  const Wide slack = bound * static_cast<Wide>(1e-6);
  return value <= bound - slack   ? Finding::right
         : value <= bound + slack ? Finding::unclear
                                  : Finding::wrong;
}

// The better of two.
Finding either(Finding a, Finding b) {
  if (a == Finding::right || b == Finding::right) return Finding::right;
  return a == Finding::unclear || b == Finding::unclear ? Finding::unclear : Finding::wrong;
}

// The same where a bound may be taken larger than it need be.
Finding within(Wide value, Wide least, Wide most) {
  return either(within(value, least),
                within(value, most) == Finding::wrong ? Finding::wrong : Finding::unclear);
}

// The worse of two.
Finding both(Finding a, Finding b) {
  if (a == Finding::wrong || b == Finding::wrong) return Finding::wrong;
  return a == Finding::unclear || b == Finding::unclear ? Finding::unclear : Finding::right;
}

std::string text(const Line& line) {
  return "t " + std::to_string(line.t) + " of " + std::to_string(line.i) + " and " +
         std::to_string(line.j);
}

class Recorded {
 public:
  Recorded(const SceneData& scene, const History& history) : scene_(scene), history_(history) {
    motion_.scene = &scene;
    extent_ = std::fabs(scene.cx) + std::fabs(scene.cy) + scene.radius;
    for (const DiskData& d : scene.disks) {
      motion_.paths.emplace_back(Piece{0, {d.x, d.y}, {d.vx, d.vy}});
      partners_.push_back(-2);
      moved_.push_back(0);
    }
    done_.resize(scene.maneuvers.size());
  }

  Opinion judge(const std::vector<double>& hints) {
    double last = 0;
    for (const Line& line : history_.lines) {
      if (line.t < last || line.t > history_.horizon) return wrong("times out of order");
      last = line.t;
      if (line.kind == Line::Kind::flip) continue;
      turns_.push_back(line.t);
      const std::string what = text(line);
      if (line.kind == Line::Kind::maneuver) {
        if (note(maneuver(line), "no such maneuver: " + what)) return opinion_;
      } else {
        if (note(contact(line), "no contact at " + what)) return opinion_;
        if (note(law(line), "another response at " + what)) return opinion_;
        if (note(centres(line), "centres at " + what)) return opinion_;
        turn(line);
      }
    }
    for (std::size_t k = 0; k < done_.size(); ++k) {
      if (!done_[k] && scene_.maneuvers[k].t <= history_.horizon) {
        return wrong("a maneuver is missing");
      }
    }
    for (int i = -1; i < scene_.size(); ++i) {
      for (int j = std::max(0, i + 1); j < scene_.size(); ++j) {
        for (const Overlap& o : motion_.overlaps(i, j, history_.horizon)) {
          looks_.push_back(static_cast<double>(o.to) + 1e-3 * tolerance);
          const std::string names = std::to_string(i) + " and " + std::to_string(j);
          if (note(allowed(i, j, o), "an overlap of " + names + " from " +
                                         std::to_string(static_cast<double>(o.from)))) {
            return opinion_;
          }
        }
      }
    }
    looks_.insert(looks_.end(), hints.begin(), hints.end());
    const Opinion diagrams =
        judge_diagrams(motion_, history_, history_.horizon - 1.01 * tolerance, turns_, looks_);
    return diagrams.finding == Finding::right ? opinion_ : diagrams;
  }

 private:
  // Remembers a doubt; whether all is lost.
  bool note(Finding f, const std::string& why) {
    if (f != Finding::right) opinion_ = {f, why};
    return f == Finding::wrong;
  }

  Path& path(int id) { return motion_.paths[static_cast<std::size_t>(id)]; }
  Piece present(int id) { return id < 0 ? motion_.container() : path(id).last(); }

  // What rounding may do to a gap.
  Wide delta(int i, int j) const {
    const int lines =
        moved_[static_cast<std::size_t>(j)] + (i < 0 ? 0 : moved_[static_cast<std::size_t>(i)]);
    return std::ldexp(extent_, -51) * std::max(1, lines);
  }

  Finding contact(const Line& line) {
    const int i = line.i, j = line.j;
    if (i >= 0 && partners_[static_cast<std::size_t>(i)] == j &&
        partners_[static_cast<std::size_t>(j)] == i) {
      return Finding::wrong;
    }
    const Piece a = present(i), b = present(j);
    const Wide from = std::max(a.since, b.since), r = motion_.reach(i, j), t = line.t;
    const Gap g = motion_.gap(i, a, b, from, r);
    Finding result = Finding::wrong;
    Wide entry = 0, exit = 0;
    const bool enters = g.entry(entry) && entry >= 0;
    if (enters) {
      const Wide off = from + entry - t;
      result = within(off < 0 ? -off : off, tolerance);
    } else if (g.entry(entry) && entry > -static_cast<Wide>(1e-12) * (1 + from)) {
      result = Finding::unclear;  // the entry is where the lines begin, within rounding
    }
    // Two that rest in contact within rounding, and approach since they turned.
    const Wide deep = i < 0 ? square_root(r * r - g(0)) - r : r - square_root(g(0) + r * r);
    if (deep <= 4 * delta(i, j) && deep >= -4 * delta(i, j) && g.a * (t - from) + g.b < 0) {
      const Finding rests =
          deep >= 0 && deep <= delta(i, j) / 2 ? Finding::right : Finding::unclear;
      result = either(result, both(rests, within(t - from, tolerance)));
    }
    for (const Overlap& o : motion_.overlaps(i, j, from)) {
      if (!o.open) continue;
      const bool lasts = g(t - from) < 0 && !(g.exit(exit) && exit < t - from && exit > 0);
      const bool approach = g.a * (t - from) + g.b < 0;
      if (lasts && approach) result = either(result, within(t - o.from, tolerance));
    }
    if (i >= 0 && !enters && g.a > 0 && g.b <= 0) {
      const Wide nearest = -g.b / g.a, off = from + nearest - t;
      const Wide gap = square_root(g(nearest) + r * r) - r;
      const Wide hair = delta(i, j);
      const Finding touches = gap <= hair / 2   ? Finding::right
                              : gap <= 4 * hair ? Finding::unclear
                                                : Finding::wrong;
      result = either(result, both(touches, within(off < 0 ? -off : off, tolerance)));
    }
    return result;
  }

  Finding law(const Line& line) {
    const int i = line.i, j = line.j;
    const Piece a = present(i), b = present(j);
    const WideVec p = Path::at(a, line.t), q = Path::at(b, line.t), n = minus(q, p);
    const Wide nn = dot(n, n);
    if (nn == 0) return Finding::unclear;
    const Wide towards = dot(minus(b.v, a.v), n) / nn;
    WideVec vi = a.v, vj = b.v;
    if (i >= 0) {
      const Wide mi = scene_.disks[static_cast<std::size_t>(i)].mass,
                 mj = scene_.disks[static_cast<std::size_t>(j)].mass;
      const Wide k = (1 + Wide(scene_.restitution)) * towards / (mi + mj);
      vi = {vi.x + k * mj * n.x, vi.y + k * mj * n.y};
      vj = {vj.x - k * mi * n.x, vj.y - k * mi * n.y};
    } else {
      const Wide e = scene_.wall_restitution;
      const Wide k = scene_.whole ? Wide(2) : 1 + e;
      vj = {vj.x - k * towards * n.x, vj.y - k * towards * n.y};
      if (scene_.whole) vj = {e * vj.x, e * vj.y};
    }
    const Wide speed = norm(b.v) + (i < 0 ? Wide(0) : norm(a.v));
    const Wide most_speed = length_bound(b.v) + (i < 0 ? Wide(0) : length_bound(a.v));
    const Wide turned =
        16 * (length_bound(q) + most_speed * line.t) / (motion_.reach(i, j) * std::ldexp(1.0, 53));
    if (turned >= 1) return Finding::unclear;
    const Wide least = law_tolerance * speed, most = (law_tolerance + turned) * most_speed;
    Finding f = within(norm(minus(wide(line.v[1]), vj)), least, most);
    if (i >= 0) f = both(f, within(norm(minus(wide(line.v[0]), vi)), least, most));
    return f;
  }

  Finding near_path(int id, const Pair2& p, const Pair2& v, double t) {
    if (!history_.centres) return Finding::right;
    const WideVec at = Path::at(present(id), t);
    const Wide bound =
        tolerance * (norm(present(id).v) + norm(wide(v))) + 4 * norm(at) * std::ldexp(1.0, -53);
    return within(norm(minus(wide(p), at)), bound);
  }

  Finding centres(const Line& line) {
    const Finding f = near_path(line.j, line.p[1], line.v[1], line.t);
    return line.i < 0 ? f : both(f, near_path(line.i, line.p[0], line.v[0], line.t));
  }

  void turn(const Line& line) {
    if (line.i >= 0) {
      path(line.i).turn(line.t, wide(line.v[0]));
      partners_[static_cast<std::size_t>(line.i)] = line.j;
      ++moved_[static_cast<std::size_t>(line.i)];
    }
    path(line.j).turn(line.t, wide(line.v[1]));
    partners_[static_cast<std::size_t>(line.j)] = line.i;
    ++moved_[static_cast<std::size_t>(line.j)];
  }

  Finding maneuver(const Line& line) {
    for (std::size_t k = 0; k < done_.size(); ++k) {
      const ManeuverData& m = scene_.maneuvers[k];
      const Finding time = within(std::fabs(m.t - line.t), tolerance);
      if (done_[k] || m.disk != line.j || time == Finding::wrong) continue;
      done_[k] = true;
      const WideVec v{m.vx, m.vy};
      const Wide off = norm(minus(wide(line.v[1]), v));
      Finding f = both(time, within(off, law_tolerance * norm(v), law_tolerance * length_bound(v)));
      f = both(f, near_path(line.j, line.p[1], line.v[1], line.t));
      path(line.j).turn(line.t, wide(line.v[1]));
      partners_[static_cast<std::size_t>(line.j)] = -2;
      ++moved_[static_cast<std::size_t>(line.j)];
      // Velocities of zero, or equal ones, are within any bound.
      return norm(v) == 0 && norm(wide(line.v[1])) == 0 ? Finding::right : f;
    }
    return Finding::wrong;
  }

  Finding allowed(int i, int j, const Overlap& o) {
    const Wide hair = delta(i, j);
    Finding f = 4 * hair > motion_.reach(i, j) ? Finding::wrong
                : o.depth <= hair / 2          ? Finding::right
                : o.depth <= 4 * hair          ? Finding::unclear
                                               : Finding::wrong;
    for (const Line& line : history_.lines) {
      if (line.kind != Line::Kind::collide || line.i != i || line.j != j) continue;
      const Wide late = line.t - o.from;
      if (late < -static_cast<Wide>(1e-15) * (1 + o.from)) continue;
      f = either(f, both(within(late, tolerance), within(o.to - line.t, tolerance)));
    }
    return either(f, within(history_.horizon - o.from, tolerance));
  }

  const SceneData& scene_;
  const History& history_;
  Motion motion_;
  double extent_ = 0;
  std::vector<int> partners_, moved_;
  std::vector<bool> done_;
  std::vector<double> turns_, looks_;
  Opinion opinion_;
};

// ---- The true motion. ----

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

Opinion judge_recorded(const SceneData& scene, const History& history,
                       const std::vector<double>& hints) {
  return Recorded(scene, history).judge(hints);
}

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
      if (speed > 0) {
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
