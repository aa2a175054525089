// The data of a history for a page that plays it, as flat arrays.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/engine.h"
#include "history/claim.h"
#include "library/history_index.h"

namespace voroproof::internal {

inline constexpr int max_movie_disks = 65'534;
inline constexpr std::size_t max_movie_events = 4'000'000;

enum class MovieEvent : std::uint8_t { flip, collision, maneuver };

// The part of the history that a movie is of: what is after `from` and not after `until`. With an
// index reading begins in the middle, and what the index says is taken at its word.
struct MovieSpan {
  std::optional<Rational> from, until;
  std::optional<IndexFile> index;
  // Whether flips and the diagram belong to it: not where they are not judged.
  bool flips = true;
};

// The events in their order; what they are about follows one another without gaps.
struct MovieData {
  std::vector<double> times;
  std::vector<MovieEvent> kinds;
  // The ids that the events name: l, r, s, e of a flip; i, j of a collision; the disk of a
  // maneuver. The container is 65535.
  std::vector<std::uint16_t> ids;
  // vx, vy just after the event of each disk that a collision or a maneuver names, the container
  // passed over. Between events a disk moves on a line: that is all of its motion.
  std::vector<double> velocities;

  double begin = 0;                    // from which it tells
  std::int64_t left_out = 0;           // events before that
  std::vector<double> disks;           // x, y, radius, vx, vy of each then, all its events over
  std::vector<std::uint16_t> initial;  // l, r, s, e of each edge just after that
  std::string no_initial;              // why there is none, where there should be one
  std::string no_diagram;              // why none is to be shown
  double end = 0;                      // up to which it tells
  bool cut = false;                    // whether the history goes on
  std::optional<HistoryStop> stop;     // where it ends with that
  std::vector<std::string> remarks;    // facts that the files do not tell, and oddities in them
  // The first event on the line asked for or a later one, their number where there is none; nothing
  // where that line is before the begin.
  std::optional<std::size_t> event_at_line = 0;
};

// Reads the history's events of the span. Velocities that it does not record are computed as
// certify --truth recorded does (docs/formats.md, section 8), an initial diagram that it lacks is
// constructed by these options, if that can be. Claims are not judged: a false history has a movie
// too. Throws InputError, also for more disks or events than a movie holds, and where the span
// begins after the horizon or the index is not of this history.
MovieData movie_data(Claim& claim, const std::string& history_path, const MovieSpan& span,
                     std::int64_t line, const EngineOptions& options = {});

}  // namespace voroproof::internal
