// Contradictions made small, as long as they stay ones of their relation.
#pragma once

#include "tests/metamorphic/relations.h"

namespace voroproof::internal::metamorphic {

// Without a claim where the engine's own history will do, with fewer disks, maneuvers and events.
World shrunk(Relation relation, const World& world);

}  // namespace voroproof::internal::metamorphic
