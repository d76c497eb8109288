// Patterns of paths, for routes ("/api/v1/cores/{id}") and channels ("core/{id}/state"): parts between '/'; a {name}
// stands for any one part that is not empty. Pure functions.
#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace race::server {

/// The parts that a pattern's {names} stand for.
using Parameters = std::map<std::string, std::string, std::less<>>;

/// The parameters if the whole path matches the pattern.
std::optional<Parameters> match(std::string_view pattern, std::string_view path);

/// The path with `values` in place of the pattern's {names}, in order. Requires one value for each.
std::string fill(std::string_view pattern, std::initializer_list<std::string_view> values);

}  // namespace race::server
