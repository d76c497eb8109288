#include "server/commands/options.h"

#include <algorithm>
#include <charconv>

namespace race::server {

std::string Options::text(std::string_view name, std::string fallback) const {
  const auto found = values.find(name);
  return found == values.end() ? fallback : found->second;
}

Expected<double> Options::number(std::string_view name, double fallback, double low, double high) const {
  const auto found = values.find(name);
  if (found == values.end()) return fallback;
  const std::string& text = found->second;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= low && value <= high))
    return unexpected(ErrorCode::out_of_range, "must be a number within its limits, got `" + text + "`",
                      std::string(name));
  return value;
}

namespace {

// The options of a usage, and whether each has a value: "[--port N]" has one, "[--fast]" has none.
std::map<std::string, bool, std::less<>> known_options(std::string_view arguments) {
  std::map<std::string, bool, std::less<>> known;
  for (auto at = arguments.find("--"); at != std::string_view::npos; at = arguments.find("--", at + 2)) {
    const auto end = std::min(arguments.find_first_of(" ]", at), arguments.size());
    known.emplace(arguments.substr(at, end - at), end < arguments.size() && arguments[end] == ' ');
  }
  return known;
}

}  // namespace

Expected<Options> read_options(const std::vector<std::string>& words, std::string_view arguments) {
  const auto known = known_options(arguments);
  Options options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!words[i].starts_with("--")) {
      options.rest.push_back(words[i]);
      continue;
    }
    const auto equals = words[i].find('=');
    const std::string name = words[i].substr(0, equals);
    const auto option = known.find(name);
    const bool valued = option != known.end() && option->second;
    if (option == known.end() || (!valued && equals != std::string::npos))
      return unexpected(ErrorCode::unknown_field, "there is no such option", words[i]);
    std::string value;
    if (valued && equals != std::string::npos) {
      value = words[i].substr(equals + 1);
    } else if (valued) {
      if (++i == words.size()) return unexpected(ErrorCode::missing, "the option needs a value", name);
      value = words[i];
    }
    if (!options.values.emplace(name, value).second)
      return unexpected(ErrorCode::duplicate, "the option stands twice", name);
  }
  return options;
}

}  // namespace race::server
