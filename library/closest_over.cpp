#include "library/closest_over.h"

#include <string>
#include <vector>

#include "library/planning/given_clearance.h"

namespace voroproof::internal {

std::optional<LeastGap> least_gap_of_all(const Paths& paths, HistoryCursor& history,
                                         const Window& window) {
  if (paths.disks() < 2) return std::nullopt;
  history.seek(window.to);
  GivenPaths given;
  for (GenId g = 0; g < paths.disks(); ++g) {
    given.paths.push_back(
        {std::to_string(g), paths.signed_radius(g), paths.waypoints(g, window.from, window.to)});
  }
  const auto always = [] { return true; };
  given.contacts = paths.contacts();
  const auto least = GivenClearance(given, always).least();
  const bool contact = paths.contacts().contains({least->i, least->j, least->t});
  return LeastGap{least->i, least->j, least->t, least->distance2, contact};
}

}  // namespace voroproof::internal
