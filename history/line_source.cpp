#include "history/line_source.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "history/descriptor.h"
#include "history/error.h"

namespace voroproof::internal {

namespace {

// The most bytes that are read at once. They are in the processor's cache when they are parsed, and
// do not push out what other threads work on.
constexpr std::size_t kStep = 1 << 17;

}  // namespace

LineSource::LineSource(const std::string& path, std::optional<std::string_view> text)
    : path_(path) {
  if (text) {
    buffer_.assign(text->begin(), text->end());
    end_ = buffer_.size();
  } else {
    source_.emplace(path);
    buffer_.resize(2 * kStep);
  }
}

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

bool LineSource::skip_to(std::int64_t offset, std::int64_t number, std::optional<Sha256> digest) {
  // The byte before shows whether a line ends there.
  if (!source_ || !source_->skip_to(offset - 1)) return false;
  digest_.reset();
  begin_ = end_ = 0;
  if (!fill() || buffer_[0] != '\n') {
    throw InputError(path_, 0, "", "no line ends at byte " + std::to_string(offset));
  }
  begin_ = 1;
  number_ = number;
  offset_ = digested_ = offset;
  settled_ = all_given;
  digest_ = std::move(digest);
  return true;
}

const Sha256& LineSource::digest_up_to(std::int64_t offset) {
  const auto more = static_cast<std::size_t>(offset - digested_);
  digest_->add({buffer_.data() + begin_ - (offset_ - digested_), more});
  digested_ = offset;
  return *digest_;
}

std::string LineSource::content_sha256() {
  if (!digest_ || (!ended_ && is_stream(path_))) return {};
  try {
    do {
      offset_ += static_cast<std::int64_t>(end_ - begin_);
      begin_ = end_;
      digest_up_to(offset_);
    } while (fill());
  } catch (const DamagedInput&) {
    return {};
  }
  return Sha256(*digest_).hex();
}

// Makes room for more; what may still be asked of the digest is kept.
void LineSource::drop_given() {
  std::size_t drop = begin_;
  if (digest_) {
    const std::int64_t settled = std::min(settled_, offset_);
    if (settled > digested_) digest_up_to(settled);
    drop -= static_cast<std::size_t>(offset_ - digested_);
  }
  if (drop == 0) return;
  std::memmove(buffer_.data(), buffer_.data() + drop, end_ - drop);
  end_ -= drop;
  begin_ -= drop;
}

bool LineSource::fill() {
  if (!source_) {
    ended_ = true;
    return false;
  }
  drop_given();
  if (end_ == buffer_.size()) buffer_.resize(2 * buffer_.size());
  const std::size_t got =
      source_->read(buffer_.data() + end_, std::min(buffer_.size() - end_, kStep));
  end_ += got;
  ended_ = got == 0;
  return got > 0;
}

}  // namespace voroproof::internal
