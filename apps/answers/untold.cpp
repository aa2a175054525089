#include "apps/answers/untold.h"

#include "history/json_text.h"

namespace voroproof::internal {
namespace {

// Whether the claim is what the scene schedules, but for rounding.
bool is_scheduled(const ClaimedManeuver& claim, const BilliardManeuver& m) {
  const auto same = [](const Rational& a, const Rational& b) {
    return round_nearest(a) == round_nearest(b);
  };
  if (!same(claim.t, m.t)) return false;
  if (!claim.v) return true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!same((*claim.v)[axis], m.velocity[axis])) return false;
  }
  return true;
}

void note_maneuvers(const ToldHistory& told, const std::vector<BilliardManeuver>& scheduled,
                    std::vector<std::string>& missing) {
  const auto& claims = told.maneuvers;
  std::vector<std::size_t> next(claims.size(), 0);
  std::size_t count = 0;
  std::string first;
  for (const BilliardManeuver& m : scheduled) {
    if (m.t > told.end) break;
    const auto g = static_cast<std::size_t>(m.disk);
    const std::size_t k = next[g]++;
    if (k < claims[g].size() && is_scheduled(claims[g][k], m)) continue;
    if (count++ == 0) first = std::to_string(m.disk) + " at t = " + number_text(m.t);
  }
  for (std::size_t g = 0; g < claims.size(); ++g) {
    if (claims[g].size() <= next[g]) continue;
    missing.push_back("the scene has no such maneuver: disk " + std::to_string(g) +
                      " at t = " + number_text(claims[g][next[g]].t));
    break;
  }
  if (count == 0) return;
  missing.push_back((count == 1 ? "a maneuver" : std::to_string(count) + " maneuvers") +
                    " of the scene, not in the history as scheduled: disk " + first);
}

}  // namespace

std::vector<std::string> untold(const ToldHistory& told, const Rational& horizon,
                                const std::vector<BilliardManeuver>& scheduled) {
  std::vector<std::string> missing;
  // The horizon may be rounded in the history.
  if (told.stops || round_nearest(told.end) < round_nearest(horizon)) {
    missing.push_back("the time from t = " + number_text(told.end) + ", where the history " +
                      (told.stops ? "stops" : "ends") + ", to the scene's horizon, " +
                      number_text(horizon));
  }
  if (!told.counts_match)
    missing.push_back("events: the last line of the history counts others than it has");
  note_maneuvers(told, scheduled, missing);
  return missing;
}

}  // namespace voroproof::internal
