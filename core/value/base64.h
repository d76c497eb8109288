// Bytes as text, for JSON: base64 of RFC 4648, with padding.
#pragma once

#include <string>
#include <string_view>

namespace race {

std::string base64(std::string_view bytes);
/// Whether `text` is base64: not empty, in blocks of four characters.
bool is_base64(std::string_view text);

}  // namespace race
