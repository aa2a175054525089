// The file in which a run of `simulate` keeps what it takes to go on (docs/formats.md, section 17).
//
// One JSON object a line. The first line:
//   format, version           "voroproof-kept-run", 1
//   producer, scene_sha256, horizon
//                             as in the history's header
//   bytes, sha256             size and hash of the beginning of the history, expanded
//   t                         a time after the events of that beginning and before all others
//   last                      the time of the last of them
//   events                    numbers: flips by the paper's kinds, collisions of disks and with the
//                             container, maneuvers; settling_flips, which are no events
//   divisions                 numbers of turns after which another instant begins that rounds to
//                             the same time
//   precision                 of the states: goal, per_time, bits, v_scale (docs/design/engine.md)
// The second line:
//   diagram                   at t, as `initial` in a history
// A line for each disk that has turned:
//   disk, state               its id; the number of its last turn among all turns
//   t, x, y, vx, vy           at t it was at (x, y). A coordinate is [digits, exponent, r, e]:
//                             0.digits (hexadecimal, signed) times 2^exponent, within r times 2^e
// Where a restitution is below 1, a line for each disk:
//   at_wall, times            its last collisions
// The last line:
//   end                       the SHA-256 of the lines before
#pragma once

#include <optional>
#include <string>

#include "engine/kept_run.h"
#include "history/history_reader.h"
#include "history/output_file.h"

namespace voroproof::internal {

inline constexpr const char* kept_format = "voroproof-kept-run";
inline constexpr const char* kept_ending = ".kept";

struct KeptFile {
  KeptRun run;
  OutputFile::Written history;  // its beginning, up to which the run is kept

  HistoryCounts counts() const;
};

// `header`: of the run's history, without the diagram.
std::string kept_text(const KeptFile& kept, const HistoryHeader& header);

// Nothing where there is no such file, where it is damaged, and where it is of another run.
std::optional<KeptFile> read_kept(const std::string& path, const HistoryHeader& header, int disks);

}  // namespace voroproof::internal
