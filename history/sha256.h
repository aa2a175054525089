// The fingerprint that ties a history to its scene, and what is said of either to its bytes.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace voroproof::internal {

// SHA-256 (FIPS 180-4) of bytes that come piece by piece.
class Sha256 {
 public:
  Sha256();
  // Goes on behind `length` bytes whose state() this was; nothing where it is the state of none.
  static std::optional<Sha256> resumed(std::string_view state, std::int64_t length);
  Sha256(const Sha256& other);
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;
  ~Sha256();

  void add(std::string_view bytes);
  // The hash of all bytes so far, as 64 lower-case hexadecimal digits. Call it once, and add
  // nothing afterwards.
  std::string hex();

  // The state after the bytes so far, from which resumed() goes on: hexadecimal digits of the eight
  // words of FIPS 180-4, and of the bytes behind the last whole block of 64.
  std::string state() const;

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

// SHA-256 of the bytes, as 64 lower-case hexadecimal digits.
std::string sha256_hex(std::string_view bytes);

// The same of the content of a file of any size (ByteSource). Throws InputError.
std::string sha256_of_file(const std::string& path);
// The hash of the first `bytes` bytes; of all where there are fewer.
std::string sha256_of_beginning(const std::string& path, std::int64_t bytes);

}  // namespace voroproof::internal
