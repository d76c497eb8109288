#include "services/sqlite/digest.h"

#include <sodium.h>

#include <cstdint>
#include <fstream>

namespace race::sqlite {

Digest sha256(std::string_view text) {
  Digest digest;
  crypto_hash_sha256(digest.data(), reinterpret_cast<const unsigned char*>(text.data()), text.size());
  return digest;
}

Digest sha256_of(std::initializer_list<std::string_view> fields) {
  crypto_hash_sha256_state state;
  crypto_hash_sha256_init(&state);
  for (const std::string_view field : fields) {
    std::array<unsigned char, 8> length;
    std::uint64_t rest = field.size();
    for (unsigned char& byte : length) {
      byte = static_cast<unsigned char>(rest & 0xFFU);
      rest >>= 8U;
    }
    crypto_hash_sha256_update(&state, length.data(), length.size());
    crypto_hash_sha256_update(&state, reinterpret_cast<const unsigned char*>(field.data()), field.size());
  }
  Digest digest;
  crypto_hash_sha256_final(&state, digest.data());
  return digest;
}

Expected<Digest> sha256_of_file(const std::string& path, const std::function<void(std::uint64_t)>& read) {
  std::ifstream stream(path, std::ios::binary);
  crypto_hash_sha256_state state;
  crypto_hash_sha256_init(&state);
  std::array<char, 65536> part;
  std::uint64_t bytes = 0;
  while (stream) {
    stream.read(part.data(), part.size());
    const auto count = static_cast<std::uint64_t>(stream.gcount());
    crypto_hash_sha256_update(&state, reinterpret_cast<const unsigned char*>(part.data()), count);
    bytes += count;
    if (read) read(bytes);
  }
  if (!stream.is_open() || stream.bad()) return unexpected(ErrorCode::io, "cannot be read", path);
  Digest digest;
  crypto_hash_sha256_final(&state, digest.data());
  return digest;
}

std::string_view bytes(const Digest& digest) { return {reinterpret_cast<const char*>(digest.data()), digest.size()}; }

std::string hex(const Digest& digest) {
  std::string text(2 * digest.size() + 1, '\0');
  sodium_bin2hex(text.data(), text.size(), digest.data(), digest.size());
  text.pop_back();
  return text;
}

}  // namespace race::sqlite
