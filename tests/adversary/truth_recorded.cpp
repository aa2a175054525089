// The motion that a history records, held against docs/formats.md.
#include <algorithm>
#include <cmath>

#include "tests/adversary/bounds.h"
#include "tests/adversary/diagrams.h"

namespace voroproof::internal::adversary {
namespace {

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
    for (Line line : history_.lines) {
      if (line.t < last || line.t > history_.horizon) return wrong("times out of order");
      last = line.t;
      if (line.kind == Line::Kind::flip) continue;
      if (!history_.velocities) compute_velocities(line);
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
    // What may be left out after that may be what makes them neighbours.
    const Wide certain = history_.horizon - 1.01 * tolerance;
    if (motion_.points_meet(certain)) return wrong("points meet, which has no law");
    looks_.insert(looks_.end(), hints.begin(), hints.end());
    const Opinion diagrams =
        judge_diagrams(motion_, history_, static_cast<double>(certain), turns_, looks_);
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

  // Where a line gives none: from the file's centres, else from the path's, rounded.
  void compute_velocities(Line& line) {
    if (line.kind == Line::Kind::maneuver) {
      // The one that maneuver() takes.
      for (std::size_t k = 0; k < done_.size(); ++k) {
        const ManeuverData& m = scene_.maneuvers[k];
        if (done_[k] || m.disk != line.j || std::fabs(m.t - line.t) > tolerance) continue;
        line.v[1] = {m.vx, m.vy};
        return;
      }
      return;
    }
    const bool filed = history_.centres;
    const WideVec p = line.i < 0 || !filed ? Path::at(present(line.i), line.t) : wide(line.p[0]);
    const WideVec q = filed ? wide(line.p[1]) : Path::at(present(line.j), line.t);
    const auto v = response(scene_, line, {p, q}, {present(line.i).v, present(line.j).v});
    for (std::size_t side = 0; side < 2; ++side) {
      line.v[side] = {static_cast<double>(v[side].x), static_cast<double>(v[side].y)};
    }
  }

  Finding law(const Line& line) {
    if (!history_.velocities) return Finding::right;
    const int i = line.i, j = line.j;
    const Piece a = present(i), b = present(j);
    const WideVec p = Path::at(a, line.t), q = Path::at(b, line.t), n = minus(q, p);
    if (dot(n, n) == 0) return Finding::unclear;
    const auto [vi, vj] = response(scene_, line, {p, q}, {a.v, b.v});
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
    // Where a line gives no velocity, the speed after may count or not.
    const Wide after = history_.velocities ? norm(wide(v)) : Wide(0);
    const Wide least =
        tolerance * (norm(present(id).v) + after) + 2 * norm(at) * std::ldexp(1.0, -53);
    const Wide most = tolerance * (length_bound(present(id).v) + length_bound(wide(v))) +
                      4 * length_bound(at) * std::ldexp(1.0, -53);
    return within(norm(minus(wide(p), at)), least, most);
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
      if (m.t > history_.horizon) return Finding::wrong;
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

}  // namespace

Opinion judge_recorded(const SceneData& scene, const History& history,
                       const std::vector<double>& hints) {
  return Recorded(scene, history).judge(hints);
}

}  // namespace voroproof::internal::adversary
