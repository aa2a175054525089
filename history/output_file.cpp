#include "history/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "history/compressor.h"
#include "history/descriptor.h"
#include "history/error.h"

namespace voroproof::internal {
namespace {

// A descriptor that writes to the stream; nothing for a path that is none.
std::optional<int> opened_stream(const std::string& path) {
  std::optional<int> named = named_descriptor(path);
  if (!named && is_standard_output(path)) named = STDOUT_FILENO;
  // A descriptor that is opened anew would begin at the beginning of its file.
  if (named) return fcntl(*named, F_DUPFD_CLOEXEC, 0);
  if (is_stream(path)) {
    return open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  }
  return std::nullopt;
}

}  // namespace

OutputFile::OutputFile(const std::string& path)
    : path_(path), compressor_(compressor_for(path)), buffer_(new char[buffer_size]) {
  const std::optional<int> stream = opened_stream(path);
  if (!stream) {
    file_.emplace(path);
    return;
  }
  stream_ = *stream;
  if (stream_ < 0) throw OutputError(path_, std::string("cannot write: ") + std::strerror(errno));
}

OutputFile::~OutputFile() {
  if (stream_ >= 0) close(stream_);
}

void OutputFile::write(std::string_view bytes) {
  if (bytes.size() > buffer_size - used_) flush();
  if (bytes.size() > buffer_size) {
    compress(bytes);
    return;
  }
  std::memcpy(buffer_.get() + used_, bytes.data(), bytes.size());
  used_ += bytes.size();
}

bool OutputFile::end_early(
    std::size_t room,
    const std::function<std::optional<std::string>(std::string_view line)>& ending) {
  used_ = 0;
  return file_ && !compressor_ && file_->end_early(room, ending);
}

void OutputFile::commit() {
  finish();
  if (file_) file_->commit();
}

std::string OutputFile::commit_beside(const std::string& suffix) {
  finish();
  return file_.value().commit_beside(suffix);
}

void OutputFile::flush() {
  compress({buffer_.get(), used_});
  used_ = 0;
}

void OutputFile::finish() {
  flush();
  if (!compressor_) return;
  compressor_->finish([this](std::string_view bytes) { write_through(bytes); });
  compressor_.reset();
}

void OutputFile::compress(std::string_view bytes) {
  if (content_) content_->add(bytes);
  size_ += static_cast<std::int64_t>(bytes.size());
  if (compressor_) {
    compressor_->write(bytes, [this](std::string_view compressed) { write_through(compressed); });
  } else {
    write_through(bytes);
  }
}

void OutputFile::write_through(std::string_view bytes) {
  if (file_) {
    file_->write(bytes);
    return;
  }
  while (!bytes.empty()) {
    const ssize_t written = ::write(stream_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      throw OutputError(path_, std::string("cannot write: ") + std::strerror(errno));
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void write_output(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace voroproof::internal
