// Writing gzip (RFC 1952) and Zstandard (RFC 8878).
#pragma once

#include <functional>
#include <memory>
#include <string_view>

namespace voroproof::internal {

// Compresses, with the usual effort of its program. The same text gives the same bytes.
class Compressor {
 public:
  using Sink = std::function<void(std::string_view)>;

  virtual ~Compressor() = default;
  virtual void write(std::string_view bytes, const Sink& sink) = 0;
  virtual void finish(const Sink& sink) = 0;  // once, at the end
};

// The one that the name's ending asks for (.gz, .zst); nothing for other names.
std::unique_ptr<Compressor> compressor_for(std::string_view path);

// The name without that ending, which tells what is compressed.
std::string_view without_compression(std::string_view path);

}  // namespace voroproof::internal
