#include "history/sha256.h"

// The functions of OpenSSL 1 need no memory. Those that replace them set up the whole library
// first, which crashes where there is none.
#define OPENSSL_API_COMPAT 0x10100000L
#include <openssl/sha.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "history/byte_source.h"

namespace voroproof::internal {

struct Sha256::Context {
  SHA256_CTX digest;
};

Sha256::Sha256() : context_(std::make_unique<Context>()) { SHA256_Init(&context_->digest); }

Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;
Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
  SHA256_Update(&context_->digest, bytes.data(), bytes.size());
}

std::string Sha256::hex_so_far() const {
  Sha256 copy;
  copy.context_->digest = context_->digest;
  return copy.hex();
}

std::string Sha256::hex() {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest;
  SHA256_Final(digest.data(), &context_->digest);
  static constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : digest) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

std::string sha256_hex(std::string_view bytes) {
  Sha256 digest;
  digest.add(bytes);
  return digest.hex();
}

std::string sha256_of_file(const std::string& path) {
  return sha256_of_beginning(path, std::numeric_limits<std::int64_t>::max());
}

std::string sha256_of_beginning(const std::string& path, std::int64_t bytes) {
  constexpr std::int64_t piece = std::int64_t{1} << 18;
  ByteSource source(path);
  Sha256 digest;
  std::vector<char> buffer(piece);
  while (bytes > 0) {
    const std::size_t got =
        source.read(buffer.data(), static_cast<std::size_t>(std::min(bytes, piece)));
    if (got == 0) break;
    digest.add({buffer.data(), got});
    bytes -= static_cast<std::int64_t>(got);
  }
  return digest.hex();
}

}  // namespace voroproof::internal
