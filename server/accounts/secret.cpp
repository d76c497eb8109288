#include "server/accounts/secret.h"

#include <sodium.h>

#include <array>
#include <stdexcept>

#include "services/sqlite/digest.h"

namespace race::server {
namespace {

// So many random bytes in base64url.
template <std::size_t bytes>
std::string random_text() {
  if (sodium_init() < 0) throw std::runtime_error("libsodium has no random numbers");
  std::array<unsigned char, bytes> random{};
  randombytes_buf(random.data(), random.size());
  constexpr int kVariant = sodium_base64_VARIANT_URLSAFE_NO_PADDING;
  std::array<char, sodium_base64_ENCODED_LEN(bytes, kVariant)> text{};
  sodium_bin2base64(text.data(), text.size(), random.data(), random.size(), kVariant);
  return text.data();
}

}  // namespace

std::string make_secret(std::string_view prefix) { return std::string(prefix) + random_text<32>(); }
std::string make_code() { return random_text<16>(); }

std::string digest_of_secret(std::string_view secret) { return sqlite::hex(sqlite::sha256(secret)); }

}  // namespace race::server
