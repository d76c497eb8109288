// Bytes as text, for JSON: base64 of RFC 4648, with padding.
#pragma once

#include <string>
#include <string_view>

namespace race {

std::string base64(std::string_view bytes);
/// Whether it can be read back: not empty, of whole blocks of four characters.
bool is_base64(std::string_view text);

}  // namespace race
