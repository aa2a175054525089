// Reading billiards: scenes of version 2 whose disks bounce (docs/formats.md, section 21). No
// diagram goes with them.
#pragma once

#include <string>
#include <string_view>

#include "exact/billiard.h"
#include "history/scene.h"

namespace voroproof::internal {

// Whether a file says that it is a scene of version 2 whose disks bounce. The whole file is looked
// at; false where it cannot be read.
bool is_billiard_file(const std::string& path);

// Reads and checks a billiard: form and values, but not whether disks overlap or leave the frame.
// Throws InputError.
Billiard read_billiard(const std::string& path);
Billiard parse_billiard(std::string_view bytes, const std::string& file_name);

}  // namespace voroproof::internal
