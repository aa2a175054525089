// The true motion, in 300 digits, held against what a history says of it.
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "tests/adversary/bounds.h"
#include "tests/adversary/diagrams.h"
#include "tests/oracle/motion.h"

namespace voroproof::internal::adversary {
namespace {

using Exact = oracle::MotionOracle;

Wide to_wide(const Exact::Number& x) {
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

class TrueMotion {
 public:
  TrueMotion(const SceneData& scene, const History& history) : scene_(scene), history_(history) {
    motion_.scene = &scene;
    for (const DiskData& d : scene.disks) {
      motion_.paths.emplace_back(Piece{0, {d.x, d.y}, {d.vx, d.vy}});
      claimed_.push_back({d.vx, d.vy});
    }
  }

  Opinion judge(const std::vector<double>& hints) {
    if (const auto o = read_lines()) return *o;
    try {
      exact_.emplace(motion_scene(scene_), records_);
    } catch (const std::invalid_argument& error) {
      const std::string why = error.what();
      return why.find("before an earlier") != why.npos ? unclear(why) : wrong(why);
    }
    for (std::size_t k = 0; k < lines_.size(); ++k) judge_line(k);
    if (finding_ == Finding::wrong) return wrong(why_);
    if (const auto o = overlaps()) return *o;
    if (motion_.points_meet(history_.horizon)) return wrong("points meet, which has no law");
    const Opinion diagrams = judge_diagrams(motion_, history_, history_.horizon, turns_, hints);
    return diagrams.finding != Finding::right ? diagrams : Opinion{finding_, why_};
  }

 private:
  void note(Finding f, const char* reason, const Line& line) {
    finding_ = both(finding_, f);
    if (f != Finding::right) why_ = reason + (" at " + text(line));
  }

  const Path& path(int id) const { return motion_.paths[static_cast<std::size_t>(id)]; }
  // Just before the line that is judged: the true one, and the one last claimed.
  WideVec velocity(int id) const { return id < 0 ? WideVec{} : path(id).last().v; }
  WideVec claimed(int id) const {
    return id < 0 ? WideVec{} : claimed_[static_cast<std::size_t>(id)];
  }

  // The turns that the lines claim, each maneuver as it is scheduled.
  std::optional<Opinion> read_lines() {
    std::vector<bool> done(scene_.maneuvers.size());
    double last = 0;
    for (const Line& line : history_.lines) {
      if (line.t < last || line.t > history_.horizon) return wrong("times out of order");
      last = line.t;
      if (line.kind == Line::Kind::flip) continue;
      lines_.push_back(&line);
      if (line.kind == Line::Kind::collide) {
        records_.push_back(oracle::collision(line.i, line.j));
        continue;
      }
      bool found = false;
      for (std::size_t k = 0; k < done.size() && !found; ++k) {
        const ManeuverData& m = scene_.maneuvers[k];
        if (done[k] || m.disk != line.j || std::fabs(m.t - line.t) > 1.1 * tolerance) continue;
        found = done[k] = true;
        if (m.t > history_.horizon) return wrong("a maneuver after the horizon");
        records_.push_back(oracle::maneuver(m.disk, m.t, m.vx, m.vy));
      }
      if (!found) return wrong("no such maneuver: " + text(line));
    }
    for (std::size_t k = 0; k < done.size(); ++k) {
      if (!done[k] && scene_.maneuvers[k].t <= history_.horizon) {
        return wrong("a maneuver is missing");
      }
    }
    return std::nullopt;
  }

  // Where several turns are at one instant, the oracle gives the last one's velocity.
  WideVec velocity_after(std::size_t k, int id) const {
    const auto& t = exact_->times()[k];
    const bool last = k + 1 == lines_.size() || exact_->times()[k + 1] - t > 1e-60;
    const auto v =
        last ? exact_->velocity(id, t)
             : Exact(motion_scene(scene_),
                     {records_.begin(), records_.begin() + static_cast<std::ptrdiff_t>(k) + 1})
                   .velocity(id, t);
    return {to_wide(v[0]), to_wide(v[1])};
  }

  void judge_line(std::size_t k) {
    const Line& line = *lines_[k];
    const Wide t = to_wide(exact_->times()[k]), off = t - line.t, end = history_.horizon;
    turns_.push_back(static_cast<double>(t));
    note(within(off < 0 ? -off : off, tolerance), "another time", line);
    if (t > end) {
      const bool clearly = t > end * (1 + static_cast<Wide>(1e-15));
      note(clearly ? Finding::wrong : Finding::unclear, "after the horizon", line);
    }
    if (k > 0 && exact_->times()[k] - exact_->times()[k - 1] < 1e-60) {
      // Only this is known here about the order at one instant: the smallest pair that is due comes
      // first.
      const Line& other = *lines_[k - 1];
      if (std::pair(line.i, line.j) < std::pair(other.i, other.j)) {
        note(Finding::unclear, "the order at an instant", line);
      }
    }
    // What the bounds of velocities are made of: both before a collision, the scheduled one.
    std::array<Wide, 2> speed{};
    const auto add = [&](const WideVec& v) {
      speed[0] += norm(v);
      speed[1] += length_bound(v);
    };
    if (line.kind == Line::Kind::maneuver) {
      const oracle::ManeuverRecord& m = *records_[k].maneuver;
      add({m.vx.get_d(), m.vy.get_d()});
    } else {
      add(velocity(line.i));
      add(velocity(line.j));
      judge_contact(line, t, speed[0]);
    }
    for (const int side : {0, 1}) {
      const int id = side == 0 ? line.i : line.j;
      if (id >= 0 && (side == 1 || line.kind == Line::Kind::collide)) {
        judge_state(k, static_cast<std::size_t>(side), id, t, speed);
      }
    }
  }

  // Approach and response of a collision.
  void judge_contact(const Line& line, Wide t, Wide speed) {
    if (line.i >= 0) {
      // No digits say whether a pair approaches that hardly does.
      const WideVec w = minus(velocity(line.j), velocity(line.i));
      const WideVec n = minus(Path::at(path(line.j).last(), t), Path::at(path(line.i).last(), t));
      if (-dot(w, n) < static_cast<Wide>(1e-9) * speed * motion_.reach(line.i, line.j)) {
        note(Finding::unclear, "hardly an approach", line);
      }
    }
    if (!history_.velocities || !history_.centres) return;
    // The claimed values obey the law among themselves.
    const WideVec p = line.i < 0 ? WideVec{scene_.cx, scene_.cy} : wide(line.p[0]);
    const WideVec q = wide(line.p[1]), vi = claimed(line.i), vj = claimed(line.j);
    const auto v = response(scene_, line, {p, q}, {vi, vj});
    const Wide least = norm(vi) + norm(vj), most = length_bound(vi) + length_bound(vj);
    const Wide turned =
        16 * length_bound(q) / (motion_.reach(line.i, line.j) * std::ldexp(1.0, 53));
    for (const std::size_t side : {0, 1}) {
      if (side == 0 && line.i < 0) continue;
      const Wide off = norm(minus(wide(line.v[side]), v[side]));
      note(within(off, law_tolerance * least, (law_tolerance + turned) * most), "another response",
           line);
    }
  }

  // Goes on along the path of the disk, and compares velocity and centre.
  void judge_state(std::size_t k, std::size_t side, int id, Wide t,
                   const std::array<Wide, 2>& speed) {
    const Line& line = *lines_[k];
    const auto p = exact_->position(id, exact_->times()[k]);
    const WideVec before = velocity(id);
    const Piece piece{t, {to_wide(p[0]), to_wide(p[1])}, velocity_after(k, id)};
    motion_.paths[static_cast<std::size_t>(id)].put(piece);
    claimed_[static_cast<std::size_t>(id)] = history_.velocities ? wide(line.v[side]) : piece.v;
    const auto bound = [&](Wide of) {
      const Wide law = law_tolerance * of;
      if (line.kind == Line::Kind::maneuver) return law;
      const Wide reach = motion_.reach(line.i, line.j);
      return law + std::min(4 * tolerance * of * of / reach, of * std::ldexp(1.0, -10));
    };
    if (history_.velocities && speed[0] > 0) {
      note(within(norm(minus(wide(line.v[side]), piece.v)), bound(speed[0]), bound(speed[1])),
           "another velocity", line);
    }
    if (!history_.centres) return;
    const Wide least =
        tolerance * (norm(before) + norm(piece.v)) + 2 * norm(piece.at) * std::ldexp(1.0, -53);
    const Wide most = tolerance * (length_bound(before) + length_bound(piece.v)) +
                      4 * length_bound(piece.at) * std::ldexp(1.0, -53);
    note(within(norm(minus(wide(line.p[side]), piece.at)), least, most), "another centre", line);
  }

  // A collision that the lines miss.
  std::optional<Opinion> overlaps() const {
    const double extent = std::fabs(scene_.cx) + std::fabs(scene_.cy) + scene_.radius;
    for (int i = -1; i < scene_.size(); ++i) {
      for (int j = std::max(0, i + 1); j < scene_.size(); ++j) {
        for (const Overlap& o : motion_.overlaps(i, j, history_.horizon)) {
          if (o.depth <= extent * static_cast<Wide>(1e-20)) continue;
          return wrong("an overlap of " + std::to_string(i) + " and " + std::to_string(j) +
                       " from " + std::to_string(static_cast<double>(o.from)));
        }
      }
    }
    return std::nullopt;
  }

  const SceneData& scene_;
  const History& history_;
  std::vector<oracle::MotionRecord> records_;
  std::vector<const Line*> lines_;  // one each record
  std::optional<Exact> exact_;
  Motion motion_;
  std::vector<WideVec> claimed_;  // velocities
  std::vector<double> turns_;
  Finding finding_ = Finding::right;
  std::string why_;
};

}  // namespace

Opinion judge_exact(const SceneData& scene, const History& history,
                    const std::vector<double>& hints) {
  return TrueMotion(scene, history).judge(hints);
}

}  // namespace voroproof::internal::adversary
