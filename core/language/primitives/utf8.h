// Strings of the language are sequences of Unicode code points, as in Python; a Value holds them as UTF-8. Positions,
// lengths and slices count code points. All functions require valid UTF-8, except `valid`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace race::language::utf8 {

/// Whether `text` is UTF-8 without surrogates and overlong forms.
bool valid(std::string_view text);

/// Whether every code point is one byte, so that positions are bytes.
bool ascii(std::string_view text);

/// The number of code points.
std::size_t length(std::string_view text);

/// The byte at which code point `index` begins; the size of the text if there are not so many.
std::size_t offset(std::string_view text, std::size_t index);

/// The longest beginning of the text that has at most so many bytes and ends between code points.
std::string_view prefix(std::string_view text, std::size_t bytes);

/// The code point that begins at byte `at`; `at` moves to the next one.
char32_t next(std::string_view text, std::size_t& at);

void append(char32_t point, std::string& out);

std::u32string decode(std::string_view text);
std::string encode(std::u32string_view points);

}  // namespace race::language::utf8
