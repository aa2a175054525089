// A folder for what is written on the way.
#pragma once

#include <cstddef>
#include <filesystem>

namespace voroproof::internal {

// A new folder in that of the system (TMPDIR), which goes with the object. A process that is killed
// outright leaves it; the next one removes it. Those of living processes are locked (flock).
class ScratchFolder {
 public:
  // Throws OutputError.
  ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  // A folder of its own for the job of that number.
  std::filesystem::path folder(std::size_t number) const;

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace voroproof::internal
