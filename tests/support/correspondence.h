// Two runs that must tell the same story: of a scene and of its image, or of its parts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {

// A similarity of the plane with rational coefficients and a change of tempo, or new ids.
struct Image {
  // (x, y) -> (xx x + xy y, yx x + yy y) + (dx, dy), where xx yy - xy yx = +- length^2.
  Rational xx = 1, xy = 0, yx = 0, yy = 1, dx = 0, dy = 0;
  Rational length = 1;   // of radii and distances
  Rational time = 1;     // of times
  std::vector<int> ids;  // of disk i; empty where all keep theirs
  bool mirrored() const { return sgn(xx * yy - xy * yx) < 0; }
  GenId id(GenId g) const {
    return g == container_id || ids.empty() ? g : ids[static_cast<std::size_t>(g)];
  }
  // The edge's canonical name in the image: a reflection makes left right.
  Quad edge(const Quad& q) const;
};

Scene image_of(const Scene& scene, const Image& image);

// The diagram of a run just after all its events up to time t, as a sorted list.
std::vector<Quad> diagram_after(const Scene& scene, const RecordedRun& run, double t);

// The first difference between a run and that of the image; empty if they correspond:
// - collisions and maneuvers are the same at the same instants. Where the order of the ids is
//   kept, in the same order; else in any order within an instant;
// - the diagrams after each instant are the same. Where the order of ids is not kept the choice
//   among cotangent edges may differ: then those of the image, by the ids of the scene, agree with
//   the scene's own brute-force diagram between some instants;
// - where neither ids nor orientation change, the flips are the same in the same order.
// Both runs are complete. Where ids change, no maneuver falls on the instant of a collision.
std::string difference_from_image(const Scene& scene, const RecordedRun& run, const Image& image,
                                  const RecordedRun& image_run);

// Whether two collisions of one instant share a disk: then the order of ids decides what comes of
// them.
bool shares_a_disk_at_an_instant(const RecordedRun& run);

// The rest of an elastic scene from time t on, after all events at t; nullopt where a collision
// happened at an irrational time.
std::optional<Scene> rest_of(const Scene& scene, const RecordedRun& run, const Rational& t);

// The first difference between a run and those of its two parts, up to and from time t, which is a
// binary64; empty if there is none. The second part may be missing. All runs are complete.
std::string difference_from_parts(const Scene& scene, const RecordedRun& whole, const Rational& t,
                                  const RecordedRun& beginning, const RecordedRun* end);

}  // namespace voroproof::internal::testing
