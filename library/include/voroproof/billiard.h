// Billiards: disks, or balls in space, that bounce off each other and off walls, also in periodic
// boxes, and their histories, with which no diagram goes (docs/formats.md, section 21).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "voroproof/certify.h"
#include "voroproof/export.h"
#include "voroproof/history.h"
#include "voroproof/number.h"
#include "voroproof/simulate.h"

namespace voroproof {

namespace internal {
struct Billiard;
}

// A billiard that was read and checked. It does not change.
class VOROPROOF_API Billiard {
 public:
  // The bytes of a scene file; `name` is for messages. Throws InputError, also where disks overlap
  // or are outside of their frame, and Undecided where too many images meet to tell.
  explicit Billiard(std::string bytes, const std::string& name = "scene");

  const std::string& text() const { return text_; }  // the bytes
  const std::string& sha256() const;                 // by which histories name it
  int dimension() const;                             // 2 or 3
  int size() const;                                  // the number of disks
  Number horizon() const;

  // For the library itself.
  const internal::Billiard& read() const { return *read_; }

 private:
  std::string text_;
  std::shared_ptr<const internal::Billiard> read_;
};

// Reads a scene file. Throws as the constructor.
VOROPROOF_API Billiard read_billiard(const std::string& path);
// Writes it, whole or not at all. Throws OutputError.
VOROPROOF_API void write_billiard(const std::string& path, const Billiard& billiard);

// An event, in plain memory: an array of them can be handed to others as it is. In the plane third
// coordinates are 0. A vector that there is not is NaN throughout.
struct BilliardEvent {
  static constexpr std::int32_t collision = 1, maneuver = 2;                      // kinds
  static constexpr std::int32_t none = std::numeric_limits<std::int32_t>::min();  // no id, no image
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  double t = 0;
  std::int32_t kind = collision;
  // The two that collide, the smaller first: disks, or wall -k and a disk; or the disk of a
  // maneuver and `none`.
  std::array<std::int32_t, 2> ids{none, none};
  // The image of the second that the first touches; `none` throughout: the nearest one.
  std::array<std::int32_t, 3> image{none, none, none};
  // Just after, and then: [0] of the first, [1] of the second.
  std::array<std::array<double, 3>, 2> velocity{{{nan, nan, nan}, {nan, nan, nan}}};
  std::array<std::array<double, 3>, 2> center = velocity;
};

struct BilliardHistory {
  std::string scene_sha256;  // see Billiard::sha256()
  int dimension = 2;
  Number horizon;
  std::string producer;               // "name version"
  std::vector<BilliardEvent> events;  // in their order
  Ending ending;
  // Events of a file with numbers that are no binary64: here they are rounded. certify_files()
  // judges the file itself.
  std::int64_t rounded = 0;
};

// Reads a history of the billiard. Throws InputError.
VOROPROOF_API BilliardHistory read_history(const std::string& path, const Billiard& billiard);
// Writes it, whole or not at all. Throws OutputError, and InputError where it is no history.
VOROPROOF_API void write_history(const std::string& path, const BilliardHistory& history);

// As those of scenes. Options for threads have no effect. All events are judged, which are
// collisions and maneuvers; std::invalid_argument for `strict` and `any_order`.
VOROPROOF_API BilliardHistory simulate(const Billiard& billiard,
                                       const SimulateOptions& options = {});
VOROPROOF_API Report certify(const Billiard& billiard, const BilliardHistory& history,
                             const CertifyOptions& options = {});

}  // namespace voroproof
