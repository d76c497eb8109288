// What Python knows about single code points (Unicode 14, the version of Python 3.11). The tables in
// unicode_tables.cpp are made by unicode_tables.py.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace race::language::unicode {

bool is_alpha(char32_t point);
bool is_decimal(char32_t point);
bool is_digit(char32_t point);
bool is_numeric(char32_t point);
bool is_space(char32_t point);
bool is_upper(char32_t point);
bool is_lower(char32_t point);
bool is_title(char32_t point);
/// Whether repr() shows it as it is.
bool is_printable(char32_t point);
/// Whether a word goes on after it for str.title() and str.lower() (cased or ignored between cased ones).
bool is_cased(char32_t point);
bool is_case_ignorable(char32_t point);

/// The digit that a decimal code point stands for. Requires is_decimal.
int decimal_value(char32_t point);

// Append the upper, lower or title case of a code point.
void append_upper(char32_t point, std::u32string& out);
void append_lower(char32_t point, std::u32string& out);
void append_title(char32_t point, std::u32string& out);

// The tables. A range holds first, first + stride, ..., last; in a Shift, each maps to itself + delta.
struct Range {
  char32_t first, last, stride;
};
struct Shift {
  char32_t first, last, stride;
  std::int32_t delta;
};
struct Expansion {
  char32_t from;
  char32_t to[3];
};
extern const std::span<const Range> kAlpha, kDecimal, kDigit, kNumeric, kSpace, kUpper, kLower, kTitle, kPrintable,
    kCaseIgnorable;
extern const std::span<const Shift> kToUpper, kToLower, kToTitle;
extern const std::span<const Expansion> kLongUpper, kLongLower, kLongTitle;

}  // namespace race::language::unicode
