// Reading gzip (RFC 1952) and Zstandard (RFC 8878).
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace voroproof::internal {

// Expands what a source gives, in bounded memory.
class Expander {
 public:
  // Up to `size` (> 0) bytes; 0 at the end only.
  using Source = std::function<std::size_t(char* data, std::size_t size)>;

  virtual ~Expander() = default;
  // As a Source. Several members or frames are one text. Throws InputError naming the path where
  // the source is not of the format, is damaged, ends too soon, or needs a window of more than 128
  // MiB.
  virtual std::size_t read(char* data, std::size_t size) = 0;
};

// The most bytes by which a compression is known.
inline constexpr std::size_t longest_magic = 4;

// Whether what begins so is compressed.
bool is_compressed(std::string_view beginning);

// The expander for a file that begins so; nothing where it is not compressed.
std::unique_ptr<Expander> expander_of(std::string_view beginning, const std::string& path,
                                      Expander::Source source);

}  // namespace voroproof::internal
