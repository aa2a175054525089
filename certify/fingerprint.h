// SHA-256 of values: two sequences of values of the same kinds have one fingerprint only if they
// are the same.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "history/history_reader.h"
#include "history/scene.h"
#include "history/sha256.h"

namespace voroproof::internal {

class Fingerprint {
 public:
  void add(std::int64_t x) {
    static_assert(std::endian::native == std::endian::little, "the bytes are added as they are");
    add_bytes(&x, sizeof x);
  }
  void add(std::uint64_t) = delete;  // no other type is taken for a double or an integer
  void add(int x) { add(std::int64_t{x}); }
  void add(bool x) { add(std::int64_t{x}); }
  void add(double x) { add(std::bit_cast<std::int64_t>(x)); }
  void add(std::string_view text);
  void add(const char*) = delete;
  void add(const Rational& q);
  void add(const ExactVec2& v);
  void add(const Quad& q);
  void add(const HistoryHeader& header);  // the judged part of it

  // The hash of all so far, as 64 lower-case hexadecimal digits. Call it once, and last.
  std::string hex();

 private:
  // Values are small, and a call of the library is not.
  void add_bytes(const void* bytes, std::size_t size) {
    if (size > piece_.size() - used_) {
      add_piece();
      if (size > piece_.size()) return sha_.add({static_cast<const char*>(bytes), size});
    }
    std::memcpy(piece_.data() + used_, bytes, size);
    used_ += size;
  }
  void add_piece();

  std::array<char, 4096> piece_;
  std::size_t used_ = 0;
  Sha256 sha_;
};

// Begins a fingerprint with all that is judged of a scene, and of a history before its first line.
std::string fingerprint_of(const Scene& scene, const HistoryHeader& header);

}  // namespace voroproof::internal
