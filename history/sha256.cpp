#include "history/sha256.h"

// The functions of OpenSSL 1 need no memory. Those that replace them set up the whole library
// first, which crashes where there is none.
#define OPENSSL_API_COMPAT 0x10100000L
#include <openssl/sha.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <vector>

#include "history/byte_source.h"

namespace voroproof::internal {

struct Sha256::Context {
  SHA256_CTX digest;
};

namespace {

constexpr std::size_t word_digits = 8, words = 8, block = SHA256_CBLOCK;

void add_hex(std::string& text, unsigned char byte) {
  static constexpr char digits[] = "0123456789abcdef";
  text += digits[byte >> 4];
  text += digits[byte & 15];
}

// The number that so many hexadecimal digits denote; nothing where they are none.
std::optional<std::uint32_t> hexadecimal(std::string_view digits) {
  std::uint32_t value = 0;
  const char* const last = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), last, value, 16);
  return error == std::errc() && end == last ? std::optional(value) : std::nullopt;
}

}  // namespace

Sha256::Sha256() : context_(std::make_unique<Context>()) { SHA256_Init(&context_->digest); }

std::optional<Sha256> Sha256::resumed(std::string_view state, std::int64_t length) {
  const std::size_t pending = static_cast<std::size_t>(length) % block;
  if (length < 0 || state.size() != words * word_digits + 2 * pending) return std::nullopt;
  Sha256 sha;
  SHA256_CTX& digest = sha.context_->digest;
  for (std::size_t k = 0; k < words; ++k) {
    const auto word = hexadecimal(state.substr(word_digits * k, word_digits));
    if (!word) return std::nullopt;
    digest.h[k] = *word;
  }
  // The length in bits, without the bytes that are yet to be added.
  const auto bits = 8 * static_cast<std::uint64_t>(length - static_cast<std::int64_t>(pending));
  digest.Nl = static_cast<std::uint32_t>(bits);
  digest.Nh = static_cast<std::uint32_t>(bits >> 32);
  for (std::size_t k = 0; k < pending; ++k) {
    const auto byte = hexadecimal(state.substr(words * word_digits + 2 * k, 2));
    if (!byte) return std::nullopt;
    const char added = static_cast<char>(*byte);
    sha.add({&added, 1});
  }
  return sha;
}

Sha256::Sha256(const Sha256& other) : context_(std::make_unique<Context>(*other.context_)) {}
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;
Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
  SHA256_Update(&context_->digest, bytes.data(), bytes.size());
}

std::string Sha256::hex() {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest;
  SHA256_Final(digest.data(), &context_->digest);
  std::string text;
  for (const unsigned char byte : digest) add_hex(text, byte);
  return text;
}

std::string Sha256::state() const {
  const SHA256_CTX& digest = context_->digest;
  std::string text;
  for (const SHA_LONG word : digest.h) {
    for (const int shift : {24, 16, 8, 0}) add_hex(text, static_cast<unsigned char>(word >> shift));
  }
  const auto* pending = reinterpret_cast<const unsigned char*>(digest.data);
  for (unsigned k = 0; k < digest.num; ++k) add_hex(text, pending[k]);
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
