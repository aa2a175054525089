#include "history/byte_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "history/descriptor.h"
#include "history/error.h"

namespace voroproof::internal {

ByteSource::ByteSource(const std::string& path) : path_(path) {
  if (is_stream(path)) {
    copy_ = StreamCopy::of(path);
  } else {
    descriptor_ = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) {
      throw InputError(path_, 0, "", std::string("cannot read: ") + std::strerror(errno));
    }
  }
  try {
    std::string beginning(longest_magic, '\0');
    std::size_t have = 0;
    while (have < beginning.size()) {
      const std::size_t got = read_stored(beginning.data() + have, beginning.size() - have);
      if (got == 0) break;
      have += got;
    }
    beginning.resize(have);
    beginning_ = beginning;
    expander_ = expander_of(
        beginning, path, [this](char* data, std::size_t size) { return read_stored(data, size); });
  } catch (...) {
    if (descriptor_ >= 0) close(descriptor_);
    throw;
  }
}

ByteSource::~ByteSource() {
  if (descriptor_ >= 0) close(descriptor_);
}

std::size_t ByteSource::read(char* data, std::size_t size) {
  return expander_ ? expander_->read(data, size) : read_stored(data, size);
}

bool ByteSource::skip_to(std::int64_t offset) {
  if (copy_ || expander_) return false;
  if (lseek(descriptor_, static_cast<off_t>(offset), SEEK_SET) < 0) return false;
  beginning_.clear();
  return true;
}

std::size_t ByteSource::known_size() const {
  struct stat status {};
  if (copy_ || expander_ || fstat(descriptor_, &status) != 0) return 0;
  return static_cast<std::size_t>(status.st_size);
}

std::size_t ByteSource::read_stored(char* data, std::size_t size) {
  if (!beginning_.empty()) {
    const std::size_t given = std::min(size, beginning_.size());
    std::memcpy(data, beginning_.data(), given);
    beginning_.erase(0, given);
    return given;
  }
  if (copy_) {
    const std::size_t got = copy_->read(place_, data, size);
    place_ += static_cast<off_t>(got);
    return got;
  }
  for (;;) {
    const ssize_t got = ::read(descriptor_, data, size);
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno == EINTR) continue;
    throw InputError(path_, 0, "", std::string("cannot read: ") + std::strerror(errno));
  }
}

}  // namespace voroproof::internal
