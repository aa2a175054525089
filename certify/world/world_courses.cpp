#include "certify/world/world_courses.h"

#include <algorithm>
#include <optional>

namespace voroproof::internal {

namespace {

WorldPolynomial line(const Rational& value, const Rational& rate, const Rational& at) {
  return {Rational(value - rate * at), rate};
}

Course course_of(const GrowingDisk& s, const Rational& from) {
  return {line(s.x, s.vx, from), line(s.y, s.vy, from), line(s.radius, s.growth, from)};
}

Scheduled::Kind kind_of(PieceStart start) {
  switch (start) {
    case PieceStart::enters:
      return Scheduled::Kind::enters;
    case PieceStart::turns:
      return Scheduled::Kind::turns;
    default:
      return Scheduled::Kind::jumps;
  }
}

}  // namespace

WorldCourses::WorldCourses(const WorldMotion& world, bool filters)
    : horizon_(world.horizon),
      limit_(world.horizon > 0 ? Rational(2 * world.horizon) : Rational(1)),
      has_circle_(world.circle.has_value()),
      rough_(static_cast<int>(world.paths.size()), filters),
      courses_(world.paths.size() + 1),
      there_(world.paths.size(), false),
      ends_(world.paths.size()) {
  if (has_circle_) {
    const WorldCircle& c = *world.circle;
    set(container_id, {WorldPolynomial{c.center.x}, WorldPolynomial{c.center.y},
                       WorldPolynomial{c.radius, c.growth}});
  }
  for (GenId g = 0; g < disks(); ++g) schedule_disk(g, world.paths[g]);
  std::stable_sort(schedule_.begin(), schedule_.end(), [](const Scheduled& a, const Scheduled& b) {
    return a.t != b.t ? a.t < b.t : a.g < b.g;
  });
  for (auto s = schedule_.rbegin(); s != schedule_.rend(); ++s) ends_[s->g].push_back(s->t);
}

void WorldCourses::schedule_disk(GenId g, const WorldPath& path) {
  if (path.empty()) return;
  set(g, course_of(path.front().state, path.front().from));
  for (const WorldPiece& piece : path) {
    if (piece.start == PieceStart::enters && piece.from == 0) {
      there_[g] = true;
    } else {
      schedule_.push_back({piece.from, g, kind_of(piece.start), piece.state});
    }
  }
  const std::optional<Rational>& leave = path.back().to;
  if (leave) schedule_.push_back({*leave, g, Scheduled::Kind::leaves, {}});
}

const Rational& WorldCourses::until(GenId g) const {
  return g < 0 || ends_[g].empty() ? limit_ : ends_[g].back();
}

void WorldCourses::take(const Scheduled& change) {
  ends_[change.g].pop_back();
  there_[change.g] = change.kind != Scheduled::Kind::leaves;
  if (there_[change.g]) set(change.g, course_of(change.after, change.t));
}

void WorldCourses::set(GenId g, Course course) {
  rough_.set(g, {course.x, course.y, course.r});
  courses_[g + 1] = std::move(course);
}

}  // namespace voroproof::internal
