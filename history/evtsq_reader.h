// Event sequences (`.evtsq`): histories as the engine of the paper's authors writes them
// (docs/formats.md). The initial diagram and the velocities after collisions are not in them, and
// the header is lossy: horizon and restitution have two decimals.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "history/history_source.h"
#include "history/scene.h"
#include "history/text_fields.h"

namespace voroproof::internal {

struct EvtsqHeader {
  std::string source, generator;
  bool has_centers = true;      // version 1.1
  Rational horizon;             // rounded to two decimals
  Rational restitution = 1;     // likewise
  std::int64_t lines = 0;       // count of events, as claimed
  std::int64_t first_line = 0;  // the line of the first event
};

// How far the horizon and the restitution may be off.
inline Rational evtsq_rounding() { return {1, 200}; }

// Whether the file begins as an event sequence does, with a header that names its version.
bool is_evtsq_file(const std::string& path);

// The parts of an event sequence that are a scene's, read before the events are judged.
struct EvtsqSetting {
  EvtsqHeader header;
  std::vector<Maneuver> maneuvers;  // the velocity changes
  std::string sha256;               // hash of the bytes that these are from
};

// Reads the whole file, for scenes whose format has no such things. `ids` as in DiskFile.
EvtsqSetting read_evtsq_setting(const std::string& path, const std::vector<std::int64_t>& ids);

// The ids in an event sequence of the disks 0, 1, ...: ascending. Nothing where the disks are not
// known: then each id that comes up names a disk of its own, the next one.
using EvtsqIds = std::optional<std::vector<std::int64_t>>;

struct EventSequence {
  EvtsqHeader header;
  std::unique_ptr<HistorySource> history;
};

// Opens an event sequence. The "shadow flips" of such a file, roots that are said to be no flips,
// are no events. `horizon`: that of the scene if it has one; where it rounds to the header's, that
// is what the header means. `sha256`: that of the bytes from which its setting is, if it was read;
// require_unchanged() compares. Throws InputError, now or as the events are read.
EventSequence open_evtsq(const std::string& path, const EvtsqIds& ids,
                         const std::optional<Rational>& horizon, const std::string& sha256 = {});

}  // namespace voroproof::internal
