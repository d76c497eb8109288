#include "core/value/fields.h"

#include <algorithm>
#include <cmath>

#include "core/value/error_list.h"

namespace race {
namespace {

const Dict kNoFields;
const List kNoItems;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

bool is_name(std::string_view text) {
  return !text.empty() && is_letter(text.front()) &&
         std::all_of(text.begin(), text.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

bool has_number_out_of_range(const Value& value) {
  switch (value.kind()) {
    case Value::Kind::unknown:
      return true;
    case Value::Kind::number:
      return !std::isfinite(value.as_number());
    case Value::Kind::list: {
      const List& items = value.as_list();
      return std::any_of(items.begin(), items.end(), has_number_out_of_range);
    }
    case Value::Kind::dict: {
      const Dict& entries = value.as_dict();
      return std::any_of(entries.begin(), entries.end(),
                         [](const auto& e) { return has_number_out_of_range(e.second); });
    }
    default:
      return false;
  }
}

bool deeper_than(const Value& value, std::size_t levels) {
  if (!value.is_list() && !value.is_dict()) return false;
  if (levels == 0) return true;
  if (value.is_list())
    return std::any_of(value.as_list().begin(), value.as_list().end(),
                       [&](const Value& item) { return deeper_than(item, levels - 1); });
  return std::any_of(value.as_dict().begin(), value.as_dict().end(),
                     [&](const Dict::Entry& entry) { return deeper_than(entry.second, levels - 1); });
}

std::string_view kind_name(const Value& value) {
  switch (value.kind()) {
    case Value::Kind::unknown:
      return "a number out of range";
    case Value::Kind::null:
      return "null";
    case Value::Kind::boolean:
      return "a bool";
    case Value::Kind::integer:
      return "an int";
    case Value::Kind::number:
      return "a float";
    case Value::Kind::string:
      return "a string";
    case Value::Kind::list:
      return "a list";
    case Value::Kind::dict:
      return "an object";
  }
  return "";
}

Fields::Fields(const Value& json, std::string path, std::string what, std::vector<Error>& errors, Paths paths)
    : fields_(json.is_dict() ? &json.as_dict() : &kNoFields),
      is_object_(json.is_dict()),
      path_(std::move(path)),
      what_(std::move(what)),
      paths_(paths),
      errors_(errors) {
  if (!is_object_) violation(ErrorCode::type, "must be an object, got " + std::string(kind_name(json)));
}

void Fields::violation(ErrorCode code, std::string message, std::string_view key) {
  if (is_full(errors_)) return;
  std::string path = path_;
  if (paths_ == Paths::field && !key.empty()) path += (path.empty() ? "" : "/") + std::string(key);
  add_error(errors_, {code, what_ + ": " + std::move(message), std::move(path)});
}

void Fields::wrong_type(std::string_view key, std::string_view expected, const Value& value) {
  violation(ErrorCode::type,
            quote(key) + " must be " + std::string(expected) + ", got " + std::string(kind_name(value)), key);
}

const Value* Fields::find(std::string_view key, Need need) {
  known_.push_back(key);
  const Value* found = fields_->find(key);
  if (!found && need == Need::required && is_object_)
    violation(ErrorCode::missing, "the field " + quote(key) + " is missing", key);
  return found;
}

std::optional<std::string> Fields::text(std::string_view key, Need need) {
  const Value* found = find(key, need);
  if (!found) return std::nullopt;
  if (found->is_string()) return found->as_string();
  wrong_type(key, "a string", *found);
  return std::nullopt;
}

std::optional<bool> Fields::boolean(std::string_view key) {
  const Value* found = find(key);
  if (!found) return std::nullopt;
  if (found->is_bool()) return found->as_bool();
  wrong_type(key, "true or false", *found);
  return std::nullopt;
}

std::optional<std::int64_t> Fields::integer(std::string_view key, std::int64_t least, std::int64_t most, Need need) {
  const Value* found = find(key, need);
  if (!found) return std::nullopt;
  if (!found->is_integer()) {
    wrong_type(key, "an integer", *found);
  } else if (found->as_integer() < least || found->as_integer() > most) {
    violation(ErrorCode::out_of_range,
              quote(key) + " must be an integer from " + std::to_string(least) + " to " + std::to_string(most), key);
  } else {
    return found->as_integer();
  }
  return std::nullopt;
}

std::optional<double> Fields::number(std::string_view key) {
  const auto found = constant(key);
  if (!found) return std::nullopt;
  if (found->is_numeric()) return found->to_double();
  wrong_type(key, "a number", *found);
  return std::nullopt;
}

const List& Fields::list(std::string_view key, Need need) {
  const Value* found = find(key, need);
  if (!found) return kNoItems;
  if (found->is_list()) return found->as_list();
  wrong_type(key, "a list", *found);
  return kNoItems;
}

std::vector<std::string> Fields::texts(std::string_view key, Need need) {
  std::vector<std::string> out;
  for (const Value& item : list(key, need)) {
    if (item.is_string()) {
      out.push_back(item.as_string());
    } else {
      wrong_type(key, "a list of strings", item);
    }
  }
  return out;
}

std::optional<Value> Fields::constant(std::string_view key, Need need) {
  const Value* found = find(key, need);
  if (!found) return std::nullopt;
  if (!has_number_out_of_range(*found)) return *found;
  violation(ErrorCode::constant, quote(key) + " has a number out of the range of a 64-bit integer or a double", key);
  return std::nullopt;
}

void Fields::close() {
  for (const auto& [key, value] : *fields_) {
    if (std::find(known_.begin(), known_.end(), key.as_string()) == known_.end())
      violation(ErrorCode::unknown_field, "there is no field " + quote(key.as_string()), key.as_string());
  }
}

}  // namespace race
