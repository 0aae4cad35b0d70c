#include "latticeworld/common/digest.h"

#include <openssl/evp.h>

#include "latticeworld/common/check.h"

namespace latticeworld {

struct Digest::Context {
  EVP_MD_CTX* evp = EVP_MD_CTX_new();
  ~Context() { EVP_MD_CTX_free(evp); }
};

Digest::Digest() : context_(std::make_unique<Context>()) {
  LW_CHECK(EVP_DigestInit_ex(context_->evp, EVP_sha256(), nullptr) == 1, "SHA-256 is unavailable");
}

Digest::~Digest() = default;

void Digest::AddBytes(const void* data, std::size_t size) {
  LW_CHECK(EVP_DigestUpdate(context_->evp, data, size) == 1, "digest update failed");
}

void Digest::AddText(std::string_view text) {
  Add(static_cast<std::uint64_t>(text.size()));
  AddBytes(text.data(), text.size());
}

std::string Digest::Hex() {
  unsigned char bytes[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  LW_CHECK(EVP_DigestFinal_ex(context_->evp, bytes, &size) == 1, "a digest ends once");
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string hex;
  hex.reserve(2 * size);
  for (unsigned int i = 0; i < size; ++i) {
    hex += kDigits[bytes[i] >> 4];
    hex += kDigits[bytes[i] & 15];
  }
  return hex;
}

std::string Sha256Hex(std::string_view content) {
  Digest digest;
  digest.AddBytes(content.data(), content.size());
  return digest.Hex();
}

}  // namespace latticeworld
