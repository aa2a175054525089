#include "history/stream_copy.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <system_error>

#include "history/descriptor.h"
#include "history/error.h"

namespace voroproof::internal {
namespace {

// A file that goes with its last descriptor; negative where there is none.
int file_without_name() {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (error) return -1;
  const int file = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file >= 0) return file;
  // Not all file systems have such files.
  std::string name = (folder / "voroproof.XXXXXX").string();
  const int named = mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) unlink(name.c_str());
  return named;
}

// Tells a stream from others, whichever name it is opened by.
std::string identity(const std::string& path, int descriptor) {
  if (const auto named = named_descriptor(path)) return "descriptor " + std::to_string(*named);
  struct stat status {};
  if (fstat(descriptor, &status) != 0) return path;
  return std::to_string(status.st_dev) + ' ' + std::to_string(status.st_ino);
}

}  // namespace

std::shared_ptr<StreamCopy> StreamCopy::of(const std::string& path) {
  static std::mutex guard;
  static std::map<std::string, std::shared_ptr<StreamCopy>> copies;
  const auto named = named_descriptor(path);
  {
    // A pipe that was read to its end would wait for another writer.
    const std::lock_guard lock(guard);
    struct stat status {};
    if (!named && stat(path.c_str(), &status) == 0) {
      const auto found =
          copies.find(std::to_string(status.st_dev) + ' ' + std::to_string(status.st_ino));
      if (found != copies.end()) return found->second;
    }
  }
  const int descriptor =
      named ? fcntl(*named, F_DUPFD_CLOEXEC, 0) : open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    throw InputError(path, 0, "", std::string("cannot read: ") + std::strerror(errno));
  }
  const std::string name = identity(path, descriptor);
  const std::lock_guard lock(guard);
  std::shared_ptr<StreamCopy>& copy = copies[name];
  if (copy) {
    close(descriptor);
  } else {
    copy = std::make_shared<StreamCopy>(path, descriptor);
  }
  return copy;
}

StreamCopy::StreamCopy(const std::string& path, int descriptor)
    : path_(path), stream_(descriptor), kept_(file_without_name()) {
  if (kept_ >= 0) return;
  const int error = errno;
  close(stream_);
  errno = error;
  fail("cannot keep what comes from it in a temporary file");
}

StreamCopy::~StreamCopy() {
  close(stream_);
  close(kept_);
}

std::size_t StreamCopy::read(off_t place, char* data, std::size_t size) {
  const std::lock_guard lock(mutex_);
  for (;;) {
    const bool again = place < length_;
    if (!again && ended_) return 0;
    const ssize_t got = again ? pread(kept_, data, size, place) : ::read(stream_, data, size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail("cannot read");
    if (again) return static_cast<std::size_t>(got);
    ended_ = got == 0;
    for (ssize_t kept = 0; kept < got;) {
      const ssize_t written =
          pwrite(kept_, data + kept, static_cast<std::size_t>(got - kept), length_);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) fail("cannot keep what comes from it in a temporary file");
      kept += written;
      length_ += written;
    }
    return static_cast<std::size_t>(got);
  }
}

void StreamCopy::fail(const std::string& action) const {
  throw InputError(path_, 0, "", action + ": " + std::strerror(errno));
}

}  // namespace voroproof::internal
