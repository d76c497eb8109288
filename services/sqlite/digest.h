// Digest: SHA-256 (FIPS 180-4) of texts, for rows that are kept from damage and for chains of entries.
//
// Threads: any.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

#include "core/value/expected.h"

namespace race::sqlite {

using Digest = std::array<unsigned char, 32>;

/// Of the bytes of `text`.
Digest sha256(std::string_view text);
/// Of several fields: each with its length before it (eight bytes, the least significant first), so that no two lists
/// of fields have the same bytes.
Digest sha256_of(std::initializer_list<std::string_view> fields);

/// Of the content of a file; `read`, unless it is empty, hears now and then how many bytes were read. Error `io`, with
/// the path: it cannot be read.
Expected<Digest> sha256_of_file(const std::string& path, const std::function<void(std::uint64_t)>& read = {});

/// The 32 bytes, as a field of sha256_of and as a blob.
std::string_view bytes(const Digest& digest);
/// 64 hexadecimal digits.
std::string hex(const Digest& digest);

}  // namespace race::sqlite
