// A line diff of two transcripts, as `diff -u` prints it; for the message of a failed comparison.
#pragma once

#include <string>

namespace race {

/// The lines that differ, `-` for those of `expected` alone and `+` for those of `actual` alone, with up to three equal
/// lines around them. At most `limit` lines; then it says that there are more. Empty if both are equal.
std::string line_diff(const std::string& expected, const std::string& actual, std::size_t limit = 200);

}  // namespace race
