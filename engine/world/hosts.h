// Which disks of a world hide which.
#pragma once

#include <vector>

#include "engine/world/live_diagram.h"
#include "engine/world/moving_rows.h"
#include "filtered/worlds/lazy_time.h"

namespace voroproof::internal {

// Whether j, a disk or the frame, hides g just after the instant: it contains g, or g is wholly
// outside of the frame, touching it from inside or not. Of two disks that are the same for ever the
// one of larger id is hidden.
bool hides_after(const MovingRows& rows, GenId j, GenId g, const LazyTime& t);

// Some generator that hides g just after the instant and is not hidden itself then; or
// LiveDiagram::visible.
GenId host_after(const MovingRows& rows, GenId g, const LazyTime& t);

// The visible disks, but for `host`, that g, which nobody hides just after the instant, touches
// from inside at it, or is one with.
std::vector<GenId> also_left_at(const MovingRows& rows, const LiveDiagram& live, GenId host,
                                GenId g, const LazyTime& t);
// The first of these, or the host, to which g is nearest just after the instant.
GenId nearest_after(const MovingRows& rows, GenId host, const std::vector<GenId>& others, GenId g,
                    const LazyTime& t);

// A time after the instant `now` at which j may cease to hide g, which it does until then; the
// first, up to `end`. nullopt: none.
std::optional<WorldTime> exit_after(const MovingRows& rows, GenId j, GenId g, const LazyTime& now,
                                    const Rational& end);
// The first time after `now`, up to `end`, at which of two visible generators, one of them a disk,
// one touches the other from inside.
std::optional<LazyTime> meeting_after(const MovingRows& rows, GenId i, GenId j, const LazyTime& now,
                                      const Rational& end);
// Whether two disks are the same at the instant.
bool coincide_at(const MovingRows& rows, GenId i, GenId j, const LazyTime& t);

}  // namespace voroproof::internal
