#include "server/wire/path_pattern.h"

#include <cassert>

namespace race::server {
namespace {

// The first part of `rest`, which becomes what follows its '/', or nothing after the last part.
std::string_view take_part(std::optional<std::string_view>& rest) {
  const auto end = rest->find('/');
  const std::string_view part = rest->substr(0, end);
  if (end == std::string_view::npos) {
    rest.reset();
  } else {
    rest->remove_prefix(end + 1);
  }
  return part;
}

bool is_parameter(std::string_view part) { return part.starts_with('{'); }

}  // namespace

std::optional<Parameters> match(std::string_view pattern, std::string_view path) {
  Parameters parameters;
  std::optional<std::string_view> pattern_rest = pattern, path_rest = path;
  while (pattern_rest && path_rest) {
    const std::string_view expected = take_part(pattern_rest), part = take_part(path_rest);
    if (is_parameter(expected)) {
      if (part.empty()) return std::nullopt;
      parameters.emplace(expected.substr(1, expected.size() - 2), part);
    } else if (expected != part) {
      return std::nullopt;
    }
  }
  if (pattern_rest || path_rest) return std::nullopt;
  return parameters;
}

std::string fill(std::string_view pattern, std::initializer_list<std::string_view> values) {
  std::string path;
  auto value = values.begin();
  std::optional<std::string_view> rest = pattern;
  while (rest) {
    const std::string_view part = take_part(rest);
    assert(!is_parameter(part) || value != values.end());
    path += is_parameter(part) ? *value++ : part;
    if (rest) path += '/';
  }
  assert(value == values.end());
  return path;
}

}  // namespace race::server
