#include "history/compression.h"

#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <new>
#include <utility>
#include <vector>

#include "history/error.h"

namespace voroproof::internal {
namespace {

constexpr std::string_view gzip_magic = "\x1f\x8b", zstd_magic = "\x28\xb5\x2f\xfd";
constexpr std::string_view gzip_ending = ".gz", zstd_ending = ".zst";
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

class GzipCompressor final : public Compressor {
 public:
  GzipCompressor() {
    constexpr int usual_memory = 8;
    if (deflateInit2(&stream_, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_window, usual_memory,
                     Z_DEFAULT_STRATEGY) != Z_OK) {
      throw std::bad_alloc();
    }
  }
  ~GzipCompressor() override { deflateEnd(&stream_); }

  void write(std::string_view bytes, const Sink& sink) override {
    while (!bytes.empty()) {
      const std::string_view part = bytes.substr(0, chunk);
      compress(part, Z_NO_FLUSH, sink);
      bytes.remove_prefix(part.size());
    }
  }
  void finish(const Sink& sink) override { compress({}, Z_FINISH, sink); }

 private:
  void compress(std::string_view bytes, int flush, const Sink& sink) {
    std::array<char, chunk> out;
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream_.avail_in = static_cast<uInt>(bytes.size());
    do {
      stream_.next_out = reinterpret_cast<Bytef*>(out.data());
      stream_.avail_out = static_cast<uInt>(out.size());
      deflate(&stream_, flush);
      sink({out.data(), out.size() - stream_.avail_out});
    } while (stream_.avail_out == 0);
  }

  z_stream stream_{};
};

class ZstdCompressor final : public Compressor {
 public:
  ZstdCompressor() : stream_(ZSTD_createCCtx()) {
    if (!stream_) throw std::bad_alloc();
    ZSTD_CCtx_setParameter(stream_.get(), ZSTD_c_checksumFlag, 1);
  }

  void write(std::string_view bytes, const Sink& sink) override {
    compress(bytes, ZSTD_e_continue, sink);
  }
  void finish(const Sink& sink) override { compress({}, ZSTD_e_end, sink); }

 private:
  struct Free {
    void operator()(ZSTD_CCtx* stream) const { ZSTD_freeCCtx(stream); }
  };

  void compress(std::string_view bytes, ZSTD_EndDirective end, const Sink& sink) {
    std::array<char, chunk> room;
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    for (bool done = false; !done;) {
      ZSTD_outBuffer out{room.data(), room.size(), 0};
      const std::size_t left = ZSTD_compressStream2(stream_.get(), &out, &in, end);
      if (ZSTD_isError(left)) throw std::bad_alloc();
      sink({room.data(), out.pos});
      done = end == ZSTD_e_end ? left == 0 : in.pos == in.size;
    }
  }

  std::unique_ptr<ZSTD_CCtx, Free> stream_;
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

std::unique_ptr<Compressor> compressor_for(std::string_view path) {
  if (path.ends_with(gzip_ending)) return std::make_unique<GzipCompressor>();
  if (path.ends_with(zstd_ending)) return std::make_unique<ZstdCompressor>();
  return nullptr;
}

std::string_view without_compression(std::string_view path) {
  for (const std::string_view ending : {gzip_ending, zstd_ending}) {
    if (path.ends_with(ending)) return path.substr(0, path.size() - ending.size());
  }
  return path;
}

}  // namespace voroproof::internal
