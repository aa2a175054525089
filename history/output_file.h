// The output of a run: to a file, which appears whole or not at all, or into a stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "history/atomic_file.h"
#include "history/compressor.h"
#include "history/sha256.h"

namespace voroproof::internal {

// A regular file, or a new one, is written as AtomicFile says. What is no such file (a pipe, a
// device, a descriptor; the file to which standard output is redirected) is not replaced but
// written to, as the bytes come. A name that ends in .gz or .zst is compressed so. Members throw
// OutputError naming the path when the system refuses.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  // Without commit() a file leaves no trace; a stream has had some of the bytes.
  ~OutputFile();

  void write(std::string_view bytes);

  // Gives fast writers room for at least `size` bytes (size <= max_room) in the buffer; the caller
  // fills it and tells by advance() where it stopped.
  static constexpr std::size_t max_room = 4096;
  char* room(std::size_t size) {
    if (buffer_size - used_ < size) flush();
    return buffer_.get() + used_;
  }
  void advance(const char* end) { used_ = static_cast<std::size_t>(end - buffer_.get()); }

  // Makes the text so far outlive the process, but for what a compressor still holds.
  void flush();

  // Whether the bytes go into a stream.
  bool is_stream() const { return stream_ >= 0; }

  // The content that flush() has written, of files alone whose content is followed.
  struct Written {
    std::int64_t bytes = 0;
    std::string sha256;
  };
  // To be called before anything is written.
  void follow_content() { content_.emplace(); }
  Written written() const { return {size_, Sha256(content_.value()).hex()}; }

  // As those of AtomicFile; nothing for streams.
  void outlive() {
    if (file_) file_->outlive();
  }
  void discard() {
    if (file_) file_->discard();
  }

  // As that of AtomicFile; false for streams, and for what is compressed.
  bool end_early(std::size_t room,
                 const std::function<std::optional<std::string>(std::string_view line)>& ending);

  // Writes what is left, and gives a file its name. Nothing may be written afterwards.
  void commit();
  // The same for a file with `suffix` at the end of its name, which is returned.
  std::string commit_beside(const std::string& suffix);

 private:
  static constexpr std::size_t buffer_size = std::size_t{1} << 18;

  void finish();                          // all but the name
  void compress(std::string_view bytes);  // where that is asked for
  void write_through(std::string_view bytes);

  std::string path_;
  std::optional<AtomicFile> file_;
  int stream_ = -1;
  std::unique_ptr<Compressor> compressor_;
  std::optional<Sha256> content_;
  std::int64_t size_ = 0;
  std::unique_ptr<char[]> buffer_;
  std::size_t used_ = 0;
};

// Writes an output that is one text. Throws OutputError.
void write_output(const std::string& path, std::string_view text);

}  // namespace voroproof::internal
