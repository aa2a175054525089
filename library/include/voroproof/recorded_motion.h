// The motion that a history writes down, at any time: places, gaps, neighbours.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "voroproof/export.h"
#include "voroproof/free_space.h"
#include "voroproof/history.h"
#include "voroproof/number.h"
#include "voroproof/scene.h"

namespace voroproof {

// A disk starts as the scene says and turns, where it is, at the time of each of its collisions and
// maneuvers in the history to the velocity that the history gives. These recorded paths are known
// exactly (docs/claim.md, section 3), so that every answer has one right value. Nothing here judges
// the history.
struct Neighbourhood {
  int generator = 0;
  Number from, to;  // as the history has them, or an end of the window
};

struct LeastGap {
  int i = 0, j = 0;  // i < j
  Number t;          // when it is reached first
  Enclosure gap;     // between the boundaries; zero at a contact
  bool contact = false;
};

class VOROPROOF_API RecordedMotion {
 public:
  // Throws InputError where the history is none or not of this scene, also where a collision lacks
  // its velocities, and Undecided where it has no initial diagram and none can be found.
  RecordedMotion(const Scene& scene, const History& history);
  RecordedMotion(RecordedMotion&&) noexcept;
  RecordedMotion& operator=(RecordedMotion&&) noexcept;
  ~RecordedMotion();

  // All throw std::invalid_argument for generators that there are not and for times that the
  // history does not cover: 0 <= t <= horizon, or t < ending.t of one that stopped.

  // The centre of every disk at t, rounded to nearest; and its velocity just after t.
  std::vector<Vector> positions(const Number& t) const;
  std::vector<Vector> velocities(const Number& t) const;
  // The gap of two generators at t: rounded to nearest, or next to that where 1024 bits do not say
  // which of two binary64 is nearer. Negative where they overlap.
  double gap(int i, int j, const Number& t) const;

  // When the cell of each generator shares an edge with that of the disk, by generator and time.
  // Throws InputError where a flip names an edge that is not there.
  std::vector<Neighbourhood> neighbours(int disk, const Number& from, const Number& to);
  // The least gap of the two; and of any two disks, which there is from two disks on.
  LeastGap least_gap(int i, int j, const Number& from, const Number& to);
  std::optional<LeastGap> least_gap(const Number& from, const Number& to);

  // These throw Undecided where a decision needs more than the budget, std::invalid_argument for a
  // negative radius and where `from` is not before `to`, and InputError where the recorded paths do
  // not fit the claimed diagram. Instants at which a probe just fits and no longer are left out.

  // When some V-edge of the two generators lets the probe pass from end to end.
  std::vector<Opening> tunnel_openings(int i, int j, const Number& probe, const Number& from,
                                       const Number& to);
  // When the diagram has the V-vertex of three different generators, counterclockwise, and the
  // probe fits there.
  std::vector<Opening> void_openings(const std::array<int, 3>& vertex, const Number& probe,
                                     const Number& from, const Number& to);
  // The lives of the voids in the order in which they come about.
  std::vector<VoidLife> void_lives(const Number& probe, const Number& from, const Number& to);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace voroproof
