#include "api/cpp/race_client/values.h"

#include <algorithm>

#include "core/language/primitives/utf8.h"
#include "core/value/fields.h"

namespace race::client {
namespace {

constexpr std::size_t kMostLevels = 64;  // as of a JSON text that is read

bool is_text(const Value& value) {
  if (value.is_string()) return language::utf8::valid(value.as_string());
  if (value.is_list()) return std::ranges::all_of(value.as_list(), is_text);
  if (value.is_dict())
    return std::ranges::all_of(value.as_dict(),
                               [](const Dict::Entry& entry) { return is_text(entry.first) && is_text(entry.second); });
  return true;
}

}  // namespace

std::optional<std::string> unsayable(const Value& value) {
  if (deeper_than(value, kMostLevels)) return "has more than " + std::to_string(kMostLevels) + " levels";
  if (has_number_out_of_range(value)) return "has a number that is not finite";
  if (!is_text(value)) return "has a text that is not UTF-8";
  return std::nullopt;
}

}  // namespace race::client
