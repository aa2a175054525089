// The bytes of an input, whatever it is: a file, a pipe, compressed or not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "history/compression.h"
#include "history/stream_copy.h"

namespace voroproof::internal {

// Reads from the beginning. What comes through a pipe or a descriptor is kept (StreamCopy), so that
// each source reads all of it. A content that begins as gzip or Zstandard does is expanded,
// whatever its name. Members throw InputError naming the path.
class ByteSource {
 public:
  explicit ByteSource(const std::string& path);
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  ~ByteSource();

  // Up to `size` (> 0) bytes of the content; 0 at its end only.
  std::size_t read(char* data, std::size_t size);

  // Goes on at this byte of the content, counted from 0. False, and nothing is done, where the
  // content is not that of a plain file.
  bool skip_to(std::int64_t offset);

  // How many bytes the content has, where that is known before it is read; 0 otherwise.
  std::size_t known_size() const;

 private:
  std::size_t read_stored(char* data, std::size_t size);

  std::string path_;
  int descriptor_ = -1;               // where it is a file
  std::shared_ptr<StreamCopy> copy_;  // where it is anything else
  off_t place_ = 0;                   // in the copy
  std::string beginning_;             // read already, to see how it is compressed
  std::unique_ptr<Expander> expander_;
};

}  // namespace voroproof::internal
