// The diagram of a world just after 0.
#pragma once

#include "engine/world/live_diagram.h"
#include "engine/world/moving_rows.h"

namespace voroproof::internal {

// That of the disks that are there. `scale`: some positive time within which little happens. Throws
// Undecided where no time is found at which the diagram is still that at 0+.
LiveDiagram first_diagram(const MovingRows& rows, const Rational& scale);

}  // namespace voroproof::internal
