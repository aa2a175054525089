// The lines of an input of any length, in bounded memory, or of a text.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "history/byte_source.h"
#include "history/sha256.h"

namespace voroproof::internal {

class LineSource {
 public:
  // Throws InputError where the file cannot be opened. With a text its lines are given, and the
  // path is a name for messages.
  explicit LineSource(const std::string& path, std::optional<std::string_view> text = {});

  // The next line without its end, or nothing after the last. Text after the last line end is a
  // line too. The view holds until the next call. Throws InputError where the line has more than
  // `limit` bytes, or the file cannot be read.
  std::optional<std::string_view> next(std::size_t limit);

  // The number of the line that next() gave last; 0 before the first.
  std::int64_t number() const { return number_; }
  // The bytes up to the end of that line, its line end included.
  std::int64_t offset() const { return offset_; }

  // Goes on as if that line, which has that number, had been given. False, and nothing is done,
  // where the input is no plain file. Throws InputError where no line ends there. The content is
  // hashed on from `digest`, where that is given, else no more.
  bool skip_to(std::int64_t offset, std::int64_t number, std::optional<Sha256> digest = {});

  // The content is hashed as it is read: nothing is read a second time, when it may have become
  // other bytes. Precondition: nothing has been given yet.
  void keep_digest() { digest_.emplace(); }
  void drop_digest() { digest_.reset(); }

  // The hash of the content up to `offset`: the end of the line given last, or of one before it
  // that is no earlier than what was settled. Offsets do not decrease from call to call.
  // Precondition: the digest is kept.
  const Sha256& digest_up_to(std::int64_t offset);
  // From now on nobody asks for the hash of less than this, or of less than all that has been given
  // where that is less still.
  void settle(std::int64_t offset) { settled_ = offset; }
  static constexpr std::int64_t all_given = std::numeric_limits<std::int64_t>::max();

  // The SHA-256 of the whole content, of which the rest is read. Empty where the digest is not kept
  // and where a stream has not been read to its end, which may never come. Nothing is read
  // afterwards. Empty, too, where the rest is damaged.
  std::string content_sha256();

 private:
  bool fill();  // reads more; false at the end of the file
  void drop_given();

  std::string path_;
  std::optional<ByteSource> source_;  // none of a text, which is in the buffer
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  // bytes read and not yet given
  std::int64_t number_ = 0, offset_ = 0;
  bool ended_ = false;            // nothing more can be read
  std::optional<Sha256> digest_;  // hash of the first `digested_` bytes
  std::int64_t digested_ = 0;
  std::int64_t settled_ = all_given;
};

}  // namespace voroproof::internal
