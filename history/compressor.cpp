#include "history/compressor.h"

#include <zlib.h>
#include <zstd.h>

#include <new>
#include <vector>

namespace voroproof::internal {
namespace {

constexpr std::string_view gzip_ending = ".gz", zstd_ending = ".zst";
constexpr std::size_t chunk = std::size_t{1} << 16;
constexpr int gzip_window = MAX_WBITS + 16;  // with gzip's header and checksum

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
