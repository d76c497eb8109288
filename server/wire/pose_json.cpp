#include "server/wire/pose_json.h"

#include <algorithm>
#include <cmath>

namespace race::server {
namespace {

// Of length 1, as far as rounding goes.
bool is_orientation(const Value& value) {
  constexpr double kRounding = 1e-3;
  if (!are_numbers(value, 4)) return false;
  double square = 0;
  for (const Value& each : value.as_list()) square += each.to_double() * each.to_double();
  return std::abs(square - 1) <= kRounding;
}

bool has_text(const Value& value, const char* key) {
  const Value* text = value.find(key);
  return text && text->is_string();
}

bool has_vector(const Value& value, const char* key) {
  const Value* vector = value.find(key);
  return vector && are_numbers(*vector, 3);
}

}  // namespace

bool is_number(const Value& value) { return value.is_numeric() && value.is_finite(); }

bool are_numbers(const Value& value, std::size_t count) {
  return value.is_list() && value.as_list().size() == count && std::ranges::all_of(value.as_list(), is_number);
}

bool is_pose(const Value& value) {
  const Value* position = value.find("position");
  const Value* orientation = value.find("orientation");
  return value.is_dict() && value.as_dict().size() == 2 && position && are_numbers(*position, 3) && orientation &&
         is_orientation(*orientation);
}

bool is_touch(const Value& value) {
  if (!value.is_dict()) return false;
  const bool has_target = value.find("target") != nullptr;
  return has_text(value, "hand") && has_text(value, "body") && has_vector(value, "at") && has_vector(value, "force") &&
         (!has_target || has_vector(value, "target")) && value.as_dict().size() == (has_target ? 5U : 4U);
}

}  // namespace race::server
