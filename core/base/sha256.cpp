#include "base/sha256.h"

#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>

namespace breakaway {

namespace {

struct ContextEnd {
  void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
};
using Context = std::unique_ptr<EVP_MD_CTX, ContextEnd>;

}  // namespace

struct Sha256::State {
  Context context{EVP_MD_CTX_new()};
};

Sha256::Sha256() : state_(std::make_unique<State>()) {
  EVP_DigestInit_ex(state_->context.get(), EVP_sha256(), nullptr);
}
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::add(std::string_view content) {
  EVP_DigestUpdate(state_->context.get(), content.data(), content.size());
}

std::string Sha256::text() const {
  const Context copy(EVP_MD_CTX_new());
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  if (EVP_MD_CTX_copy_ex(copy.get(), state_->context.get()) != 1 ||
      EVP_DigestFinal_ex(copy.get(), digest.data(), &size) != 1)
    return {};
  std::string text;
  for (unsigned k = 0; k < size; ++k) {
    text += "0123456789abcdef"[digest[k] >> 4U];
    text += "0123456789abcdef"[digest[k] & 15U];
  }
  return text;
}

Result<std::string> sha256OfFile(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr)
    return Error{path, "cannot be read: " + std::error_code(errno, std::generic_category()).message()};
  Sha256 hash;
  std::string block(size_t{1} << 18, '\0');
  size_t got = 0;
  while ((got = std::fread(block.data(), 1, block.size(), file)) > 0) hash.add({block.data(), got});
  const bool failed = std::ferror(file) != 0;
  std::fclose(file);
  if (failed) return Error{path, "cannot be read to its end"};
  return hash.text();
}

}  // namespace breakaway
