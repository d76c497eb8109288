// The bytes of an input as text.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace race::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Its lines, for targets that take a sequence of messages.
inline std::vector<std::string_view> lines_of(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string_view> lines;
  for (std::string_view rest = text_of(data, size); !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    lines.push_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return lines;
}

}  // namespace race::fuzz
