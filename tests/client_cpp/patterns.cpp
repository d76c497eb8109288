#include "tests/client_cpp/patterns.h"

#include <algorithm>
#include <cstdint>
#include <regex>
#include <string_view>

#include "core/value/json.h"

namespace race::client {
namespace {

bool fits(const Value& pattern, const Value& value, Values& saved) { return !mismatch(pattern, value, saved); }

bool are_in_order(const List& patterns, const List& values, Values& saved) {
  auto next = values.begin();
  for (const Value& pattern : patterns) {
    next = std::find_if(next, values.end(), [&](const Value& each) { return fits(pattern, each, saved); });
    if (next == values.end()) return false;
    ++next;
  }
  return true;
}

// Of operators whose value is a list; nothing: the name is of none.
std::optional<bool> list_holds(std::string_view name, const Value& given, const Value& value, Values& saved) {
  const auto fits_given = [&](const Value& each) { return fits(given, each, saved); };
  const List none, &list = value.is_list() ? value.as_list() : none;
  if (name == "$contains") return std::any_of(list.begin(), list.end(), fits_given);
  if (name == "$each") return !list.empty() && std::all_of(list.begin(), list.end(), fits_given);
  if (name == "$ordered") return value.is_list() && are_in_order(given.as_list(), list, saved);
  if (name == "$size")
    return value.is_list() && same(value_of(given, saved), Value(static_cast<std::int64_t>(list.size())));
  return std::nullopt;
}

// Whether an operator holds; nothing: the name is of none.
std::optional<bool> holds(std::string_view name, const Value& given, const Value& value, Values& saved) {
  if (name == "$equals") return same(value_of(given, saved), value);
  if (name == "$matches")
    return value.is_string() && std::regex_search(value.as_string(), std::regex(given.as_string()));
  if (name == "$least") return value.is_numeric() && value.to_double() >= given.to_double();
  return list_holds(name, given, value, saved);
}

std::string shown(const Value& value) { return to_json(value).substr(0, 400); }

std::optional<std::string> mismatch_of_field(const Value& pattern, const std::string& key, const Value& whole,
                                             Values& saved, const std::string& path) {
  const Value* const found = whole.find(key);
  const std::string below = path + '/' + key;
  if (pattern == Value(Dict{{"$absent", true}})) return found ? std::optional(below + " is there") : std::nullopt;
  return found ? mismatch(pattern, *found, saved, below) : below + " is not there";
}

std::optional<std::string> mismatch_of_fields(const Dict& pattern, const Value& value, Values& saved,
                                              const std::string& path) {
  for (const auto& [key, wanted] : pattern)
    if (auto why = mismatch_of_field(wanted, key.as_string(), value, saved, path)) return why;
  return std::nullopt;
}

std::optional<std::string> mismatch_of_elements(const List& pattern, const List& value, Values& saved,
                                                const std::string& path) {
  for (std::size_t i = 0; i < pattern.size(); ++i)
    if (auto why = mismatch(pattern[i], value[i], saved, path + '/' + std::to_string(i))) return why;
  return std::nullopt;
}

std::optional<std::string> mismatch_of_all(const List& patterns, const Value& value, Values& saved,
                                           const std::string& path) {
  for (const Value& pattern : patterns)
    if (auto why = mismatch(pattern, value, saved, path)) return why;
  return std::nullopt;
}

}  // namespace

std::optional<std::string> mismatch(const Value& pattern, const Value& value, Values& saved, const std::string& path) {
  if (pattern.is_string() && pattern.as_string().starts_with('$'))
    return mismatch(Dict{{"$equals", pattern}}, value, saved, path);
  std::optional<bool> held;
  if (pattern.is_dict() && pattern.as_dict().size() == 1) {
    const auto& [name, given] = *pattern.as_dict().begin();
    if (name == Value("$all")) return mismatch_of_all(given.as_list(), value, saved, path);
    held = holds(name.as_string(), given, value, saved);
  }
  if (!held && pattern.is_dict() && value.is_dict()) return mismatch_of_fields(pattern.as_dict(), value, saved, path);
  if (pattern.is_list() && value.is_list() && pattern.as_list().size() == value.as_list().size())
    return mismatch_of_elements(pattern.as_list(), value.as_list(), saved, path);
  if (!held) held = !pattern.is_dict() && !pattern.is_list() && same(pattern, value);
  if (*held) return std::nullopt;
  return (path.empty() ? "/" : path) + ": " + shown(value) + " does not fit " + shown(pattern);
}

}  // namespace race::client
