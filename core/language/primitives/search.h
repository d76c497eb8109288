// Search for a text in another one. std::string::find() takes time in proportion to the product of both lengths at
// worst; these take time in proportion to their sum. Positions are bytes; one of UTF-8 in UTF-8 is found at code points
// only.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace race::language {

inline constexpr std::size_t kNowhere = std::string_view::npos;

/// Where `part` begins for the first time in `text`, at `from` or later; kNowhere if it does not. Requires from <=
/// text.size().
std::size_t find_first(std::string_view text, std::string_view part, std::size_t from = 0);
/// Where it begins for the last time.
std::size_t find_last(std::string_view text, std::string_view part);
/// The bytes in reverse order, for several searches from the end.
std::string mirrored(std::string_view text);

}  // namespace race::language
