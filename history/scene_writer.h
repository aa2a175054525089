// Writing a scene (docs/formats.md, section 2).
#pragma once

#include <iosfwd>

#include "history/scene.h"

namespace voroproof::internal {

// Writes the scene so that reading it gives the same values, one disk a line. Values that are
// exactly a binary64 become JSON numbers, others strings "p/q". Masses equal to the default are
// left out, and so are other defaults.
void write_scene(std::ostream& out, const Scene& scene);

}  // namespace voroproof::internal
