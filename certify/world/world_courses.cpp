#include "certify/world/world_courses.h"

#include <algorithm>

namespace voroproof::internal {

namespace {

WorldPolynomial line(const Rational& value, const Rational& rate, const Rational& at) {
  return {Rational(value - rate * at), rate};
}

Course course_of(const GrowingDisk& s, const Rational& from) {
  return {line(s.x, s.vx, from), line(s.y, s.vy, from), line(s.radius, s.growth, from)};
}

void advance(GrowingDisk& s, const Rational& time) {
  s.x += s.vx * time;
  s.y += s.vy * time;
  s.radius += s.growth * time;
}

void apply(const WorldManeuver& m, GrowingDisk& s) {
  if (m.center) {
    s.x = m.center->x;
    s.y = m.center->y;
  }
  if (m.velocity) {
    s.vx = m.velocity->x;
    s.vy = m.velocity->y;
  }
  if (m.radius) s.radius = *m.radius;
  if (m.growth) s.growth = *m.growth;
}

}  // namespace

WorldCourses::WorldCourses(const World& world)
    : horizon_(world.horizon),
      limit_(world.horizon + 1),
      has_circle_(world.circle.has_value()),
      courses_(world.disks.size() + 1),
      there_(world.disks.size(), false),
      ends_(world.disks.size()) {
  if (has_circle_) {
    const WorldCircle& c = *world.circle;
    courses_[0] = {WorldPolynomial{c.center.x}, WorldPolynomial{c.center.y},
                   WorldPolynomial{c.radius, c.growth}};
  }
  for (GenId g = 0; g < disks(); ++g) schedule_disk(world, g);
  std::stable_sort(schedule_.begin(), schedule_.end(), [](const Scheduled& a, const Scheduled& b) {
    return a.t != b.t ? a.t < b.t : a.g < b.g;
  });
  for (auto s = schedule_.rbegin(); s != schedule_.rend(); ++s) ends_[s->g].push_back(s->t);
}

void WorldCourses::schedule_disk(const World& world, GenId g) {
  const WorldDisk& disk = world.disks[g];
  GrowingDisk state = disk.state;
  Rational at = disk.enter;
  courses_[g + 1] = course_of(state, at);
  if (at > horizon_) return;
  if (at == 0) {
    there_[g] = true;
  } else {
    schedule_.push_back({at, g, Scheduled::Kind::enters, state});
  }
  for (const WorldManeuver& m : world.maneuvers) {
    if (m.disk != g || m.t > horizon_) continue;
    advance(state, m.t - at);
    at = m.t;
    apply(m, state);
    schedule_.push_back(
        {at, g, m.is_jump() ? Scheduled::Kind::jumps : Scheduled::Kind::turns, state});
  }
  if (disk.leave && *disk.leave <= horizon_) {
    schedule_.push_back({*disk.leave, g, Scheduled::Kind::leaves, {}});
  }
}

const Rational& WorldCourses::until(GenId g) const {
  return g < 0 || ends_[g].empty() ? limit_ : ends_[g].back();
}

void WorldCourses::take(const Scheduled& change) {
  ends_[change.g].pop_back();
  there_[change.g] = change.kind != Scheduled::Kind::leaves;
  if (there_[change.g]) courses_[change.g + 1] = course_of(change.after, change.t);
}

}  // namespace voroproof::internal
