// Writing disk files (docs/formats.md).
#pragma once

#include <iosfwd>
#include <stdexcept>

#include "history/scene.h"

namespace voroproof::internal {

// Writes the disks under their own ids. Throws UnsuitableScene where the scene has what a disk file
// cannot say: a value that is no binary64, a mass other than the radius squared.
void write_disk_file(std::ostream& out, const Scene& scene);

class UnsuitableScene : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace voroproof::internal
