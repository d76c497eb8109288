#include "tests/client_cpp/values.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/value/json.h"

namespace race::client {
namespace {

const std::string kProject = RACE_SOURCE_DIR;

[[noreturn]] void nothing_at(std::string_view what) {
  throw std::runtime_error("nothing is at `" + std::string(what) + "`");
}

// `/a/0` -> a, 0.
std::vector<std::string> keys_of(std::string_view pointer) {
  std::vector<std::string> keys;
  while (!pointer.empty()) {
    pointer.remove_prefix(1);
    const auto end = std::min(pointer.find('/'), pointer.size());
    keys.emplace_back(pointer.substr(0, end));
    pointer.remove_prefix(end);
  }
  return keys;
}

std::size_t index_of(const List& list, const std::string& key) {
  const long index = std::stol(key);
  const auto size = static_cast<long>(list.size());
  if (index >= size || index < -size) nothing_at(key);
  return static_cast<std::size_t>(index < 0 ? size + index : index);
}

// Sets the value at a pointer, below what is there.
void put_at(Value& whole, std::string_view pointer, const Value& next) {
  Value* place = &whole;
  for (const std::string& key : keys_of(pointer)) {
    if (place->is_list()) {
      const std::size_t index = index_of(place->as_list(), key);
      place = &place->mutable_list()[index];
    } else if (place->is_dict()) {
      Dict& fields = place->mutable_dict();
      if (!std::as_const(fields).find(key)) fields.set(key, Value());
      place = fields.find(Value(key));
    } else {
      nothing_at(pointer);
    }
  }
  *place = next;
}

bool same_dicts(const Dict& one, const Dict& other) {
  return one.size() == other.size() && std::all_of(one.begin(), one.end(), [&other](const Dict::Entry& entry) {
           const Value* const found = other.find(entry.first);
           return found && same(entry.second, *found);
         });
}

}  // namespace

Value read_file(const std::string& name) {
  std::ifstream file(kProject + '/' + name);
  if (!file) throw std::runtime_error("there is no file " + name);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  auto value = parse_json(text, {.depth = 2048});
  if (!value) throw std::runtime_error(name + ": " + value.error().message);
  return std::move(*value);
}

const Value& Values::get(std::string_view name) {
  const auto known = known_.find(name);
  if (known != known_.end()) return known->second;
  const std::string file = std::string(name) + ".json", task = "api/conversations/tasks/" + file;
  const bool is_task = std::ifstream(kProject + '/' + task).good();
  return known_[std::string(name)] = read_file(is_task ? task : "api/examples/" + file);
}

void Values::set(std::string_view name, Value value) { known_[std::string(name)] = std::move(value); }

Value value_of(const Value& given, Values& saved) {
  if (given.is_string() && given.as_string().starts_with('$')) return saved.get(given.as_string().substr(1));
  if (given.is_list()) {
    List all;
    for (const Value& each : given.as_list()) all.push_back(value_of(each, saved));
    return all;
  }
  if (!given.is_dict()) return given;
  if (const Value* const whole = given.find("$change")) {
    Value changed = value_of(*whole, saved);
    const Value changes = value_of(*given.find("set"), saved);
    for (const auto& [pointer, next] : changes.as_dict()) put_at(changed, pointer.as_string(), next);
    return changed;
  }
  Dict all;
  for (const auto& [key, value] : given.as_dict()) all.set(key, value_of(value, saved));
  return all;
}

Value part_at(const Value& value, std::string_view pointer) {
  const Value* part = &value;
  for (const std::string& key : keys_of(pointer)) {
    part = part->is_list() ? &part->as_list()[index_of(part->as_list(), key)] : part->find(key);
    if (!part) nothing_at(pointer);
  }
  return *part;
}

bool same(const Value& one, const Value& other) {
  if (one.is_list() && other.is_list())
    return std::equal(one.as_list().begin(), one.as_list().end(), other.as_list().begin(), other.as_list().end(), same);
  if (one.is_dict() && other.is_dict()) return same_dicts(one.as_dict(), other.as_dict());
  if (one.is_integer() != other.is_integer() && one.is_numeric() && other.is_numeric())
    return one.to_double() == other.to_double();
  return one == other;
}

}  // namespace race::client
