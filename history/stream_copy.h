// The bytes that came through a pipe, kept so that they can be read again.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>

namespace voroproof::internal {

// Bytes that can be had only once, from a pipe, a terminal or a socket, are copied to a temporary
// file without a name (in the folder that TMPDIR names, or the one of the system) as they are read
// for the first time. So several readers each begin at the beginning, and the first can read what
// another program is still writing. The copies last as long as the process. Members throw
// InputError naming the path.
class StreamCopy {
 public:
  // The copy of this process of the stream that the path names (is_stream()).
  static std::shared_ptr<StreamCopy> of(const std::string& path);

  // Takes over the descriptor.
  StreamCopy(const std::string& path, int descriptor);
  StreamCopy(const StreamCopy&) = delete;
  StreamCopy& operator=(const StreamCopy&) = delete;
  ~StreamCopy();

  // Up to `size` bytes from the place on, waiting for them if they have not come yet; 0 at the end.
  std::size_t read(off_t place, char* data, std::size_t size);

 private:
  [[noreturn]] void fail(const std::string& action) const;

  std::string path_;
  int stream_, kept_;
  std::mutex mutex_;
  off_t length_ = 0;  // length of the kept bytes
  bool ended_ = false;
};

}  // namespace voroproof::internal
