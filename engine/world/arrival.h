// The path on which a disk that comes is led to where it begins.
#pragma once

#include <vector>

#include "exact/world_motion.h"

namespace voroproof::internal {

// A disk that is one with another at an instant: its state then, as it moves before and after it.
struct MetDisk {
  GrowingDisk before, after;
};

// The diagram is to pass from before the instant at which the disk comes to after it, and how the
// disk moves before is free. It is led so that nothing happens between it and those that it meets:
// as they see it, its way there is that away from there, backwards. For one that is met, or several
// that are the same for ever, it then lies to them just before the instant as just after it. Of two
// that pass each other one lies to their mean before as the other does afterwards, so that after
// their swap, too, all three lie to each other as before. Precondition: some are met.
GrowingDisk led(const GrowingDisk& comes, const std::vector<MetDisk>& met);

}  // namespace voroproof::internal
