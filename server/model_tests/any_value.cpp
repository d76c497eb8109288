#include "server/model_tests/any_value.h"

#include <string>
#include <utility>

namespace race::server {
namespace {

// Not std::uniform_int_distribution, which gives other values with other libraries.
std::size_t below(std::size_t count, Random& random) { return static_cast<std::size_t>(random() % count); }

Value one_of(const List& values, Random& random) { return values[below(values.size(), random)]; }

Value any_plain(const std::string& type, Random& random) {
  if (type == "bool") return one_of({false, true}, random);
  if (type == "int") return one_of({0, 1, 2, -1}, random);
  if (type == "number") return one_of({0.0, 0.5, 1.0, -1.0}, random);
  if (type == "string") return one_of({"", "a", "text"}, random);
  if (type == "pose") return Dict{{"position", List{0.4, 0.0, 0.3}}, {"orientation", List{1.0, 0.0, 0.0, 0.0}}};
  if (type == "image") return Dict{{"width", 4}, {"height", 3}};
  return {};  // null, any
}

Value any_list(const Value& item, const Value* size, Random& random) {
  const std::size_t count = size ? static_cast<std::size_t>(size->as_integer()) : below(3, random);
  List items;
  while (items.size() < count) items.push_back(any_value(item, random));
  return items;
}

Value any_record(const Dict& fields, Random& random) {
  Dict record;
  for (const auto& [key, type] : fields) {
    const Value* optional = type.find("optional");
    if (optional && below(2, random) == 0) continue;
    record.set(key, any_value(optional ? *optional : type, random));
  }
  return record;
}

}  // namespace

Value any_value(const Value& type, Random& random) {
  if (type.is_string()) return any_plain(type.as_string(), random);
  if (const Value* item = type.find("list")) return any_list(*item, type.find("size"), random);
  if (const Value* fields = type.find("record")) return any_record(fields->as_dict(), random);
  if (const Value* constants = type.find("enum")) return one_of(constants->as_list(), random);
  if (const Value* inner = type.find("optional"); inner && below(2, random) == 1) return any_value(*inner, random);
  return {};
}

Value any_error(const Value& type, const std::string& code, Random& random) {
  const Value drawn = any_value(type, random);
  Dict error = drawn.is_dict() ? drawn.as_dict() : Dict{};
  const Value* drawn_code = drawn.find("code");
  if (!code.empty())
    error.set("code", code);
  else if (!drawn_code || !drawn_code->is_string() || drawn_code->as_string().empty())
    error.set("code", "failed");
  return error;
}

}  // namespace race::server
