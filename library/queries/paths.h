// The recorded path of every disk (docs/claim.md, section 3), piece by piece, in exact numbers.
//
// A disk starts as the scene says and turns, where its path is, at the time of each of its
// collisions and maneuvers in the history, to the velocity that the history gives. Centres of the
// history are not used. Every question about the paths has an exact answer.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "history/events.h"
#include "history/paths_file.h"
#include "history/scene.h"
#include "library/queries/history_cursor.h"
#include "library/queries/recorded_moment.h"

namespace voroproof::internal {

// Whether roundings of so much may explain why two with that reach do not touch, in a scene of that
// size. A history could make them as large as it likes.
inline bool may_explain(const Rational& rounding, const Rational& reach, const Rational& extent) {
  return rounding <= extent / (1 << 20) && 4 * rounding <= reach;
}

class Paths {
 public:
  // A maneuver without `v` has the velocity that the scene schedules. Throws InputError where a
  // collision lacks its `v`, or a maneuver is not the scene's.
  Paths(const Scene& scene, const HistoryCursor& history, const std::string& history_path);

  // The pieces of a generator, each in force up to the start of the next; the first starts at 0.
  const std::vector<RecordedState>& pieces(GenId g) const { return pieces_[g + 1]; }
  // The piece in force at t >= 0, just after all events at t.
  const RecordedState& piece(GenId g, const Rational& t) const;
  // The instants in (from, to) at which a piece of one of the generators starts, in order.
  std::vector<Rational> turns(const std::vector<GenId>& generators, const Rational& from,
                              const Rational& to) const;
  // The path of a disk from one time to a later one, or for an instant.
  std::vector<Waypoint> waypoints(GenId g, const Rational& from, const Rational& to) const;
  GenId disks() const { return static_cast<GenId>(pieces_.size()) - 1; }
  // The radius of a disk; -R for the container.
  const Rational& signed_radius(GenId g) const { return radii_[g + 1]; }
  // The collisions of the history at which the two touch on their paths, but for what roundings of
  // its numbers explain. One after the horizon, which rounding puts there, is at the horizon.
  const std::set<GivenContact>& contacts() const { return contacts_; }
  // The first collision of the history at which they do not.
  const std::optional<GivenContact>& collision_apart() const { return collision_apart_; }

 private:
  // Whether the two, which both have a piece that starts at a collision, touch there.
  bool touch(GenId i, GenId j) const;

  std::vector<std::vector<RecordedState>> pieces_;
  std::vector<Rational> radii_;
  Rational extent_;                  // the size of the scene
  std::vector<Rational> roundings_;  // 2^51 times how far they may have moved each by now
  std::set<GivenContact> contacts_;
  std::optional<GivenContact> collision_apart_;
};

// Where a piece leads at time t.
ExactVec2 position_at(const RecordedState& piece, const Rational& t);
Rational squared_distance(const ExactVec2& a, const ExactVec2& b);

}  // namespace voroproof::internal
