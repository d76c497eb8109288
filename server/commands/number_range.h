// The range of a number that a command line or a configuration gives.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace race::server {

struct NumberRange {
  double low = 0, high = 0;  // both included; finite
  bool whole = false;        // an integer

  bool has(double value) const;
  /// "a number from 0 to 3600", "a whole number from 0 to 65535".
  std::string text() const;
};

/// Words with commas between them, for messages.
std::string joined(std::span<const std::string_view> words);

}  // namespace race::server
