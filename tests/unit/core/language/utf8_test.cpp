// UTF-8: what is valid and what is ASCII, wherever it stands: ASCII is read eight bytes at a time.
#include "core/language/primitives/utf8.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace race::language::utf8 {
namespace {

constexpr std::size_t kLongest = 25;  // three words and a byte

/// Calls visit(text, at) for `part` at each offset of texts of ASCII of each length, on each alignment.
template <typename Visit>
void at_each_offset(std::string_view part, Visit visit) {
  for (std::size_t size = part.size(); size <= kLongest; ++size) {
    for (std::size_t at = 0; at + part.size() <= size; ++at) {
      for (std::size_t alignment = 0; alignment < 8; ++alignment) {
        std::string text = std::string(alignment, '\xff') + std::string(size, 'a');
        text.replace(alignment + at, part.size(), part);
        visit(std::string_view(text).substr(alignment), at);
      }
    }
  }
}

TEST(Utf8, APrefixEndsBetweenCodePoints) {
  const std::string text = "aé€😀";
  const std::vector<std::string> expected = {"", "a", "a", "aé", "aé", "aé", "aé€", "aé€", "aé€", "aé€", text, text};
  for (std::size_t bytes = 0; bytes < expected.size(); ++bytes) EXPECT_EQ(utf8::prefix(text, bytes), expected[bytes]);
}

TEST(Utf8, AsciiIsValidAtEachLength) {
  for (std::size_t size = 0; size <= kLongest; ++size) {
    const std::string text(size, '\x7f');
    EXPECT_TRUE(valid(text)) << size;
    EXPECT_TRUE(ascii(text)) << size;
  }
  EXPECT_TRUE(valid(std::string(9, '\0')));
}

TEST(Utf8, WhatIsBehindTheEndOfATextDoesNotCount) {
  for (const std::size_t size : {0U, 1U, 7U, 8U, 9U, 15U, 16U, 17U}) {
    const std::string text = std::string(size, 'a') + "\xff\xff\xff\xff\xff\xff\xff\xff";
    EXPECT_TRUE(valid(std::string_view(text).substr(0, size))) << size;
    EXPECT_TRUE(ascii(std::string_view(text).substr(0, size))) << size;
    EXPECT_FALSE(valid(std::string_view(text).substr(0, size + 1))) << size;
    EXPECT_FALSE(ascii(std::string_view(text).substr(0, size + 1))) << size;
  }
}

TEST(Utf8, FindsAnInvalidByteAtEachOffset) {
  for (const char* part : {"\x80", "\xbf", "\xc0", "\xc1", "\xc3", "\xe2", "\xf0", "\xf5", "\xff"}) {
    at_each_offset(part, [](std::string_view text, std::size_t at) {
      EXPECT_FALSE(valid(text)) << at << " of " << text.size();
      EXPECT_FALSE(ascii(text)) << at << " of " << text.size();
    });
  }
}

TEST(Utf8, FindsOverlongFormsSurrogatesAndWhatIsBeyondUnicodeAtEachOffset) {
  for (const char* part : {"\xc0\xaf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xed\xbf\xbf", "\xf0\x8f\xbf\xbf",
                           "\xf4\x90\x80\x80", "\xe2\x82", "\xf0\x9f\x98", "\xc3\xa4\xa4"}) {
    at_each_offset(
        part, [](std::string_view text, std::size_t at) { EXPECT_FALSE(valid(text)) << at << " of " << text.size(); });
  }
}

TEST(Utf8, TakesCharactersOfTwoThreeAndFourBytesAtEachOffset) {
  for (const char* part : {"\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80", "\xef\xbf\xbf",
                           "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf", "\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80"}) {
    at_each_offset(part, [](std::string_view text, std::size_t at) {
      EXPECT_TRUE(valid(text)) << at << " of " << text.size();
      EXPECT_FALSE(ascii(text)) << at << " of " << text.size();
    });
  }
}

}  // namespace
}  // namespace race::language::utf8
