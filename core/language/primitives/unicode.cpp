#include "core/language/primitives/unicode.h"

#include <algorithm>

namespace race::language::unicode {
namespace {

// The last entry that begins at or before `point`, if it reaches that far.
template <typename Entry>
const Entry* find(std::span<const Entry> table, char32_t point) {
  auto after = std::upper_bound(table.begin(), table.end(), point,
                                [](char32_t p, const Entry& entry) { return p < entry.first; });
  // Entries of stride 2 may lie in each other: two neighbours are enough to look at.
  for (int looks = 0; looks < 2 && after != table.begin(); ++looks) {
    --after;
    if (point <= after->last && (point - after->first) % after->stride == 0) return &*after;
  }
  return nullptr;
}

void append(char32_t point, std::span<const Shift> shifts, std::span<const Expansion> expansions, std::u32string& out) {
  if (const Shift* shift = find(shifts, point)) {
    out += static_cast<char32_t>(static_cast<std::int32_t>(point) + shift->delta);
    return;
  }
  const auto* found = std::lower_bound(expansions.data(), expansions.data() + expansions.size(), point,
                                       [](const Expansion& e, char32_t p) { return e.from < p; });
  if (found == expansions.data() + expansions.size() || found->from != point) {
    out += point;
    return;
  }
  for (const char32_t to : found->to)
    if (to != 0) out += to;
}

}  // namespace

bool is_alpha(char32_t point) { return find(kAlpha, point) != nullptr; }
bool is_decimal(char32_t point) { return find(kDecimal, point) != nullptr; }
bool is_digit(char32_t point) { return find(kDigit, point) != nullptr; }
bool is_numeric(char32_t point) { return find(kNumeric, point) != nullptr; }
bool is_space(char32_t point) { return find(kSpace, point) != nullptr; }
bool is_upper(char32_t point) { return find(kUpper, point) != nullptr; }
bool is_lower(char32_t point) { return find(kLower, point) != nullptr; }
bool is_title(char32_t point) { return find(kTitle, point) != nullptr; }
bool is_printable(char32_t point) {
  if (point < 0x7F) return point >= 0x20;
  return find(kPrintable, point) != nullptr;
}
bool is_cased(char32_t point) { return is_upper(point) || is_lower(point) || is_title(point); }
bool is_case_ignorable(char32_t point) { return find(kCaseIgnorable, point) != nullptr; }

int decimal_value(char32_t point) {
  // Decimal digits come in blocks of ten that begin with their zero.
  const Range* block = find(kDecimal, point);
  return static_cast<int>((point - block->first) % 10);
}

void append_upper(char32_t point, std::u32string& out) { append(point, kToUpper, kLongUpper, out); }
void append_lower(char32_t point, std::u32string& out) { append(point, kToLower, kLongLower, out); }
void append_title(char32_t point, std::u32string& out) { append(point, kToTitle, kLongTitle, out); }

}  // namespace race::language::unicode
