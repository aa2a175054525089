#include "history/sha256.h"

#include <openssl/evp.h>

#include <stdexcept>
#include <vector>

#include "history/byte_source.h"

namespace voroproof::internal {
namespace {

void require(bool done) {
  if (!done) throw std::runtime_error("SHA-256 is not available from libcrypto");
}

}  // namespace

struct Sha256::Context {
  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> digest{EVP_MD_CTX_new(), &EVP_MD_CTX_free};
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {
  require(context_->digest &&
          EVP_DigestInit_ex(context_->digest.get(), EVP_sha256(), nullptr) == 1);
}

Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;
Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
  require(EVP_DigestUpdate(context_->digest.get(), bytes.data(), bytes.size()) == 1);
}

std::string Sha256::hex() {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned length = 0;
  require(EVP_DigestFinal_ex(context_->digest.get(), digest, &length) == 1);
  static constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (unsigned i = 0; i < length; ++i) {
    text += digits[digest[i] >> 4];
    text += digits[digest[i] & 15];
  }
  return text;
}

std::string sha256_hex(std::string_view bytes) {
  Sha256 digest;
  digest.add(bytes);
  return digest.hex();
}

std::string sha256_of_file(const std::string& path) {
  constexpr std::size_t piece = std::size_t{1} << 18;
  ByteSource source(path);
  Sha256 digest;
  std::vector<char> buffer(piece);
  while (const std::size_t got = source.read(buffer.data(), buffer.size())) {
    digest.add({buffer.data(), got});
  }
  return digest.hex();
}

}  // namespace voroproof::internal
