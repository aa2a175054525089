// A file of any content that is on no disk.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>
#include <string>
#include <string_view>

namespace voroproof::internal::fuzz {

class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("fuzz", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw std::runtime_error("no file in memory");
    // By the number of the process: /proc/self/fd would be taken for a stream.
    path_ = "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(descriptor_);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(descriptor_); }

  const std::string& path() const { return path_; }

  void hold(std::string_view bytes) {
    const auto size = static_cast<off_t>(bytes.size());
    if (ftruncate(descriptor_, size) != 0 ||
        pwrite(descriptor_, bytes.data(), bytes.size(), 0) != size) {
      throw std::runtime_error("a file in memory cannot be written");
    }
  }

 private:
  int descriptor_;
  std::string path_;
};

// The path of a file with these bytes, until the next call for the same number.
template <int number = 0>
const std::string& file_with(std::string_view bytes) {
  static MemoryFile file;
  file.hold(bytes);
  return file.path();
}

}  // namespace voroproof::internal::fuzz
