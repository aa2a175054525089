#include "history/compression.h"

#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <new>
#include <utility>
#include <vector>

#include "history/error.h"

namespace voroproof::internal {
namespace {

constexpr std::string_view gzip_magic = "\x1f\x8b", zstd_magic = "\x28\xb5\x2f\xfd";
constexpr std::size_t chunk = std::size_t{1} << 16;
constexpr int gzip_window = MAX_WBITS + 16;  // with gzip's header and checksum

class GzipExpander final : public Expander {
 public:
  GzipExpander(std::string path, Source source)
      : path_(std::move(path)), source_(std::move(source)), in_(chunk) {
    if (inflateInit2(&stream_, gzip_window) != Z_OK) throw std::bad_alloc();
  }
  ~GzipExpander() override { inflateEnd(&stream_); }

  std::size_t read(char* data, std::size_t size) override {
    stream_.next_out = reinterpret_cast<Bytef*>(data);
    stream_.avail_out = static_cast<uInt>(std::min(size, chunk));
    const uInt wanted = stream_.avail_out;
    while (stream_.avail_out == wanted) {
      if (stream_.avail_in == 0) {
        stream_.next_in = reinterpret_cast<Bytef*>(in_.data());
        stream_.avail_in = static_cast<uInt>(source_(in_.data(), in_.size()));
        if (stream_.avail_in == 0) {
          if (between_) return 0;
          throw DamagedInput(path_, 0, "", "ends within its gzip compression");
        }
      }
      if (between_) inflateReset(&stream_);
      const int result = inflate(&stream_, Z_NO_FLUSH);
      between_ = result == Z_STREAM_END;
      if (result == Z_MEM_ERROR) throw std::bad_alloc();
      if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR) {
        throw DamagedInput(path_, 0, "",
                           std::string("damaged gzip compression") +
                               (stream_.msg != nullptr ? std::string(": ") + stream_.msg : ""));
      }
    }
    return wanted - stream_.avail_out;
  }

 private:
  std::string path_;
  Source source_;
  std::vector<char> in_;
  z_stream stream_{};
  bool between_ = false;  // members
};

class ZstdExpander final : public Expander {
 public:
  ZstdExpander(std::string path, Source source)
      : path_(std::move(path)),
        source_(std::move(source)),
        in_(chunk),
        stream_(ZSTD_createDStream()) {
    if (!stream_) throw std::bad_alloc();
  }

  std::size_t read(char* data, std::size_t size) override {
    ZSTD_outBuffer out{data, size, 0};
    while (out.pos == 0) {
      if (buffer_.pos == buffer_.size && !more_) {
        buffer_ = {in_.data(), source_(in_.data(), in_.size()), 0};
        if (buffer_.size == 0) {
          if (between_) return 0;
          throw DamagedInput(path_, 0, "", "ends within its Zstandard compression");
        }
      }
      const std::size_t result = ZSTD_decompressStream(stream_.get(), &out, &buffer_);
      if (ZSTD_isError(result)) {
        throw DamagedInput(
            path_, 0, "",
            std::string("damaged Zstandard compression: ") + ZSTD_getErrorName(result));
      }
      between_ = result == 0;
      more_ = out.pos == out.size && !between_;  // there may be more output than room
    }
    return out.pos;
  }

 private:
  struct Free {
    void operator()(ZSTD_DStream* stream) const { ZSTD_freeDStream(stream); }
  };

  std::string path_;
  Source source_;
  std::vector<char> in_;
  std::unique_ptr<ZSTD_DStream, Free> stream_;
  ZSTD_inBuffer buffer_{nullptr, 0, 0};
  bool between_ = false, more_ = false;  // between frames; more may come without more input
};

}  // namespace

bool is_compressed(std::string_view beginning) {
  return beginning.starts_with(gzip_magic) || beginning.starts_with(zstd_magic);
}

std::unique_ptr<Expander> expander_of(std::string_view beginning, const std::string& path,
                                      Expander::Source source) {
  if (beginning.starts_with(gzip_magic)) {
    return std::make_unique<GzipExpander>(path, std::move(source));
  }
  if (beginning.starts_with(zstd_magic)) {
    return std::make_unique<ZstdExpander>(path, std::move(source));
  }
  return nullptr;
}

}  // namespace voroproof::internal
