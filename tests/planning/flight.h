// What a scene without collisions does, from its file's values alone.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "history/scene.h"

namespace voroproof::internal::testing {

// The paths of the disks as they follow from starts, velocities and maneuvers.
class Flight {
 public:
  explicit Flight(const Scene& scene) : scene_(scene), legs_(scene.disks.size()) {
    for (std::size_t i = 0; i < legs_.size(); ++i) {
      const DiskInput& d = scene.disks[i];
      legs_[i].push_back({0, {d.x, d.y}, {d.vx, d.vy}});
    }
    for (const Maneuver& m : scene.maneuvers) {
      const Point2 here = place(m.disk, m.t);
      legs_[m.disk].push_back({m.t, here, {m.vx, m.vy}});
    }
  }

  Point2 place(int i, const Rational& t) const {
    const Leg* leg = &legs_[i].front();
    for (const Leg& l : legs_[i])
      if (l.from <= t) leg = &l;
    const Rational dt = t - leg->from;
    return {leg->start.x + dt * leg->velocity.x, leg->start.y + dt * leg->velocity.y};
  }

  Point2 last_velocity(int i) const { return legs_[i].back().velocity; }

  // The least square of the distance of two disks in [from, to].
  Rational least_distance2(int i, int j, const Rational& from, const Rational& to) const {
    std::set<Rational> times{from, to};
    for (const int k : {i, j}) {
      for (const Leg& leg : legs_[k])
        if (leg.from > from && leg.from < to) times.insert(leg.from);
    }
    Rational least = -1;
    const Rational* before = nullptr;
    for (const Rational& t : times) {
      const Point2 a = offset(i, j, before ? *before : t), b = offset(i, j, t);
      const Rational u = b.x - a.x, v = b.y - a.y;
      std::vector<Point2> candidates{a, b};
      // The foot of the perpendicular from the origin, if it is on the segment.
      if (const Rational l = u * u + v * v; l != 0) {
        const Rational s = -(a.x * u + a.y * v) / l;
        if (s > 0 && s < 1) candidates.push_back({a.x + s * u, a.y + s * v});
      }
      for (const Point2& p : candidates) {
        const Rational d = p.x * p.x + p.y * p.y;
        if (least < 0 || d < least) least = d;
      }
      before = &t;
    }
    return least;
  }
  Rational least_distance2(int i, int j) const { return least_distance2(i, j, 0, scene_.horizon); }

 private:
  struct Leg {
    Rational from;
    Point2 start, velocity;
  };
  Point2 offset(int i, int j, const Rational& t) const {
    const Point2 p = place(i, t), q = place(j, t);
    return {q.x - p.x, q.y - p.y};
  }

  const Scene& scene_;
  std::vector<std::vector<Leg>> legs_;
};

}  // namespace voroproof::internal::testing
