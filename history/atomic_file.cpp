#include "history/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "history/error.h"

namespace voroproof {

AtomicFile::AtomicFile(const std::string& path)
    : path_(path), target_(path), buffer_(new char[buffer_size]) {
  std::error_code error;
  if (std::filesystem::is_symlink(path, error)) {
    target_ = std::filesystem::canonical(path, error).string();
    if (error) throw OutputError(path, "cannot follow the link: " + error.message());
  }
  struct stat status {};
  if (stat(target_.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
    throw OutputError(path, "is not a regular file");

  static std::atomic<unsigned> counter{0};
  do {
    temporary_ =
        target_ + "." + std::to_string(getpid()) + "." + std::to_string(counter++) + ".tmp";
    descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor_ < 0 && errno == EEXIST);
  if (descriptor_ < 0) fail("cannot write");
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void AtomicFile::write(std::string_view bytes) {
  if (bytes.size() > buffer_size - used_) flush();
  if (bytes.size() > buffer_size) {
    write_through(bytes.data(), bytes.size());
    return;
  }
  std::memcpy(buffer_.get() + used_, bytes.data(), bytes.size());
  used_ += bytes.size();
}

void AtomicFile::commit() {
  flush();
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (close(descriptor) != 0) fail("cannot write");
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail("cannot rename onto");
  temporary_.clear();
}

void AtomicFile::flush() {
  write_through(buffer_.get(), used_);
  used_ = 0;
}

void AtomicFile::write_through(const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(descriptor_, data, size);
    if (written < 0) {
      if (errno == EINTR) continue;
      fail("cannot write");
    }
    data += written;
    size -= static_cast<std::size_t>(written);
  }
}

void AtomicFile::fail(const char* action) const {
  throw OutputError(path_, std::string(action) + ": " + std::strerror(errno));
}

}  // namespace voroproof
