// Collapses: infinitely many collisions of a disk may happen before some instant, as where a
// restitution is below 1 or walls close in on it. No history goes beyond it, and no run reaches it.
#pragma once

#include <string>
#include <vector>

#include "exact/generators.h"

namespace voroproof::internal {

// The exact decimal of a time, for messages.
std::string time_text(double t);

// The disk collides at t, after `times`, of which as many are kept as count. Says how, if its
// collisions seem to have no end; else empty. `scale`: what is a short time is a part of it. To
// stop a run there is never wrong, and nothing is proved by it.
std::string seeming_collapse(GenId disk, double t, double scale, std::vector<double>& times);

}  // namespace voroproof::internal
