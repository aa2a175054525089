#include "history/line_source.h"

#include <algorithm>
#include <cstring>

#include "history/error.h"

namespace voroproof::internal {

namespace {

// So many bytes at most are read at once: what is read is in the processor's cache when it is
// parsed, and leaves there what others work on.
constexpr std::size_t kStep = 1 << 17;

}  // namespace

LineSource::LineSource(const std::string& path) : path_(path), source_(path), buffer_(2 * kStep) {}

std::optional<std::string_view> LineSource::next(std::size_t limit) {
  std::size_t searched = 0;
  for (;;) {
    const char* const begin = buffer_.data() + begin_;
    const std::size_t available = end_ - begin_;
    const void* const found =
        available > searched ? std::memchr(begin + searched, '\n', available - searched) : nullptr;
    const std::size_t length =
        found ? static_cast<std::size_t>(static_cast<const char*>(found) - begin) : available;
    if (length > limit)
      throw InputError(path_, number_ + 1, "",
                       "a line of more than " + std::to_string(limit) + " bytes");
    if (found) {
      begin_ += length + 1;
      ++number_;
      offset_ += static_cast<std::int64_t>(length) + 1;
      return std::string_view(begin, length);
    }
    searched = available;
    if (!fill()) {
      if (available == 0) return std::nullopt;
      const char* const rest = buffer_.data() + begin_;  // fill() may have moved it
      begin_ = end_;
      ++number_;
      offset_ += static_cast<std::int64_t>(available);
      return std::string_view(rest, available);
    }
  }
}

bool LineSource::skip_to(std::int64_t offset, std::int64_t number) {
  // The byte before shows whether a line ends there.
  if (!source_.skip_to(offset - 1)) return false;
  begin_ = end_ = 0;
  if (!fill() || buffer_[0] != '\n') {
    throw InputError(path_, 0, "", "no line ends at byte " + std::to_string(offset));
  }
  begin_ = 1;
  number_ = number;
  offset_ = offset;
  return true;
}

bool LineSource::fill() {
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ == buffer_.size()) buffer_.resize(2 * buffer_.size());
  const std::size_t got =
      source_.read(buffer_.data() + end_, std::min(buffer_.size() - end_, kStep));
  end_ += got;
  return got > 0;
}

}  // namespace voroproof::internal
