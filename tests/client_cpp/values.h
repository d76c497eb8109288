// Values of conversations (api/conversations/README.md): names of what was saved, copies with other values, parts.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "core/value/value.h"

namespace race::client {

/// What was saved; else a task of api/conversations/tasks, or an example of api/examples, by its name.
class Values {
 public:
  /// Throws std::runtime_error: nothing has this name.
  const Value& get(std::string_view name);
  void set(std::string_view name, Value value);

 private:
  std::map<std::string, Value, std::less<>> known_;
};

/// A file of the project, such as `api/examples/me.nobody.json`, as JSON. Throws std::runtime_error: it is not there,
/// or none.
Value read_file(const std::string& name);

/// What is given in a step, with what its names mean.
Value value_of(const Value& given, Values& saved);

/// The part of a value at a JSON pointer; -1 is the last of a list. Throws std::runtime_error: there is none.
Value part_at(const Value& value, std::string_view pointer);

/// Whether two JSON values are equal: 1 is 1.0, but not true.
bool same(const Value& one, const Value& other);

}  // namespace race::client
