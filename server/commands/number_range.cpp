#include "server/commands/number_range.h"

#include <array>
#include <charconv>
#include <cmath>

namespace race::server {
namespace {

// The shortest text that reads back the same, without an exponent.
std::string digits(double value) {
  std::array<char, 400> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed).ptr;
  return {text.data(), end};
}

}  // namespace

bool NumberRange::has(double value) const {
  return value >= low && value <= high && (!whole || std::trunc(value) == value);
}

std::string NumberRange::text() const {
  return (whole ? "a whole number from " : "a number from ") + digits(low) + " to " + digits(high);
}

std::string joined(std::span<const std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
  return text;
}

}  // namespace race::server
