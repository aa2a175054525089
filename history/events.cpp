#include "history/events.h"

namespace voroproof::internal {
namespace {

std::optional<ExactVec2> exactly(const std::optional<Vec2>& v) {
  if (!v) return std::nullopt;
  return ExactVec2{to_rational((*v)[0]), to_rational((*v)[1])};
}

}  // namespace

Rational exact_time(const Event& event) {
  return std::visit([](const auto& e) { return e.exact ? e.exact->t : to_rational(e.t); }, event);
}

std::optional<ExactVec2> exact_velocity(const CollideEvent& event, int side) {
  return event.exact ? event.exact->v[side] : exactly(event.v[side]);
}

std::optional<ExactVec2> exact_center(const CollideEvent& event, int side) {
  return event.exact ? event.exact->p[side] : exactly(event.p[side]);
}

std::optional<ExactVec2> exact_velocity(const ManeuverEvent& event) {
  return event.exact ? event.exact->v[0] : exactly(event.v);
}

std::optional<ExactVec2> exact_center(const ManeuverEvent& event) {
  return event.exact ? event.exact->p[0] : exactly(event.p);
}

}  // namespace voroproof::internal
