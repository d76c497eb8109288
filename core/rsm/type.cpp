#include "core/rsm/type.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/value/fields.h"
#include "core/value/json.h"

namespace race::rsm {
namespace {

using Reason = std::optional<std::string>;

constexpr std::array<std::string_view, 8> kPlainTypes = {"any",    "null",   "bool", "int",
                                                         "number", "string", "pose", "image"};

Reason malformed_record(const Value& fields) {
  if (!fields.is_dict()) return "`record` must be an object of types";
  for (const auto& [key, type] : fields.as_dict()) {
    if (!is_name(key.as_string())) return "`" + key.as_string() + "` is no name of a field";
    if (const Reason reason = malformed(type)) return "field `" + key.as_string() + "`: " + *reason;
  }
  return std::nullopt;
}

Reason malformed_size(const Value& type) {
  const Value* size = type.find("size");
  if (!size) return std::nullopt;
  if (!size->is_integer() || size->as_integer() < 0) return "`size` must be an int of at least 0";
  return std::nullopt;
}

Reason malformed_composite(const Value& type) {
  const Dict& fields = type.as_dict();
  if (fields.size() == (type.find("size") ? 2U : 1U)) {
    if (const Value* item = type.find("list")) {
      const Reason reason = malformed(*item);
      return reason ? reason : malformed_size(type);
    }
    if (const Value* record = type.find("record"); record && !type.find("size")) return malformed_record(*record);
    if (const Value* inner = type.find("optional"); inner && !type.find("size")) return malformed(*inner);
    if (const Value* constants = type.find("enum"); constants && !type.find("size")) {
      if (!constants->is_list() || constants->as_list().empty()) return "`enum` must be a list of constants";
      if (has_number_out_of_range(*constants)) return "`enum` has a number out of range";
      return std::nullopt;
    }
  }
  return "expected one of `list` (with `size`), `record`, `enum`, `optional`";
}

std::string expected(std::string_view what, const Value& value) {
  return "expected " + std::string(what) + ", got " + std::string(kind_name(value));
}

/// `reason` one level further out: "x: r" below "position" is "position.x: r". Paths are quoted by the outermost.
Reason within(std::string step, Reason reason) {
  if (!reason) return std::nullopt;
  if (reason->starts_with('`')) {
    const std::string inner = reason->substr(1);
    return "`" + step + (inner.starts_with('[') ? "" : ".") + inner;
  }
  return "`" + step + "`: " + *reason;
}

Reason mismatch_list(const Value& item_type, const Value* size, const Value& value) {
  if (!value.is_list()) return expected("a list", value);
  const List& items = value.as_list();
  if (size && static_cast<std::int64_t>(items.size()) != size->as_integer())
    return "expected " + std::to_string(size->as_integer()) + " items, got " + std::to_string(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (Reason reason = mismatch(item_type, items[i])) return within("[" + std::to_string(i) + "]", std::move(reason));
  }
  return std::nullopt;
}

Reason mismatch_record(const Value& fields, const Value& value) {
  if (!value.is_dict()) return expected("a record", value);
  for (const auto& [key, type] : fields.as_dict()) {
    const Value* field = value.find(key.as_string());
    if (!field && type.find("optional")) continue;
    if (!field) return "the field `" + key.as_string() + "` is missing";
    if (Reason reason = mismatch(type, *field)) return within(key.as_string(), std::move(reason));
  }
  for (const auto& [key, field] : value.as_dict()) {
    if (!fields.find(key.as_string())) return "unexpected field `" + key.as_string() + "`";
  }
  return std::nullopt;
}

const Value& pose_type() {
  static const Value type(Dict{{"record", Dict{{"position", Dict{{"list", "number"}, {"size", 3}}},
                                               {"orientation", Dict{{"list", "number"}, {"size", 4}}}}}});
  return type;
}

Reason mismatch_image(const Value& value) {
  if (!value.is_dict()) return expected("an image", value);
  for (const std::string_view side : {"width", "height"}) {
    const Value* pixels = value.find(side);
    if (!pixels || !pixels->is_integer()) return "expected an image with the int `" + std::string(side) + "`";
  }
  return std::nullopt;
}

bool equal_constant(const Value& a, const Value& b) {
  if (a.is_numeric() && b.is_numeric()) return a == b || a.to_double() == b.to_double();
  return a == b;
}

Reason mismatch_enum(const List& constants, const Value& value) {
  if (std::any_of(constants.begin(), constants.end(), [&](const Value& c) { return equal_constant(c, value); }))
    return std::nullopt;
  std::string names;
  for (const Value& constant : constants) names += (names.empty() ? "" : ", ") + to_json(constant);
  return "expected one of " + names;
}

Reason mismatch_plain(std::string_view type, const Value& value) {
  if (type == "any") return value.is_unknown() ? Reason("expected a value") : std::nullopt;
  if (type == "pose") return mismatch(pose_type(), value);
  if (type == "image") return mismatch_image(value);
  const bool fits = (type == "null" && value.is_null()) || (type == "bool" && value.is_bool()) ||
                    (type == "int" && value.is_integer()) || (type == "number" && value.is_numeric()) ||
                    (type == "string" && value.is_string());
  if (fits) return std::nullopt;
  return expected(type == "int" ? "an int" : type == "null" ? "null" : "a " + std::string(type), value);
}

}  // namespace

std::optional<std::string> malformed(const Value& type) {
  if (type.is_dict()) return malformed_composite(type);
  if (type.is_string() && std::find(kPlainTypes.begin(), kPlainTypes.end(), type.as_string()) != kPlainTypes.end())
    return std::nullopt;
  return "there is no type " + (type.is_unknown() ? std::string("out of range") : to_json(type));
}

std::optional<std::string> mismatch(const Value& type, const Value& value) {
  if (type.is_null()) return std::nullopt;
  if (type.is_string()) return mismatch_plain(type.as_string(), value);
  if (const Value* item = type.find("list")) return mismatch_list(*item, type.find("size"), value);
  if (const Value* fields = type.find("record")) return mismatch_record(*fields, value);
  if (const Value* constants = type.find("enum")) return mismatch_enum(constants->as_list(), value);
  if (const Value* inner = type.find("optional"); inner && !value.is_null()) return mismatch(*inner, value);
  return std::nullopt;
}

}  // namespace race::rsm
