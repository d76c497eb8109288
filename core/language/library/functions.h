// The functions and methods of the language: their names, parameters and implementations. The tables are in
// functions.cpp; the functions in builtins.cpp, math.cpp, geo.cpp and the methods of each type.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/language/values/context.h"
#include "core/value/value.h"

namespace race::language {

/// Parameters as text: names with blanks between them, `?` after an optional one, `=` after one that may be given by
/// its name too, `!` after an optional one that is given by its name only, and `*` for any number of others.
struct Function {
  std::string_view name;
  std::string_view parameters;
  Value (*compute)(Context&, Arguments);
  std::uint32_t work = 0;  // of each call, beyond its node; what depends on sizes the function charges itself
};

/// A method, with one overload for each type that has it. An overload computes a value, or mutates the object.
struct Method {
  struct Overload {
    std::string_view parameters;
    Value (*compute)(Context&, const Value& self, Arguments) = nullptr;
    Value (*mutate)(Context&, Value& self, Arguments) = nullptr;
    std::size_t required = 0, most = 0;  // arguments, as `parameters` says
    explicit operator bool() const { return compute != nullptr || mutate != nullptr; }
  };
  std::string_view name;
  Overload string, list, dict;

  const Overload* overload(Value::Kind kind) const;
  /// Whether it changes the value it is called on.
  bool mutates() const { return list.mutate != nullptr || dict.mutate != nullptr; }
  /// Of the first type that has it: where keywords are looked up.
  std::string_view parameters() const;
};

/// Builtins by name, `math.name` and `geo.name`; null if there is none. `available` is not one of them: the interpreter
/// implements it.
const Function* find_function(std::string_view module, std::string_view name);
const Method* find_method(std::string_view name);
/// math.pi and the like; null if there is none.
const Value* find_constant(std::string_view module, std::string_view name);

bool is_builtin(std::string_view name);  // `available` included
bool is_module(std::string_view name);

/// A parameter list, read from its text.
struct Signature {
  struct Parameter {
    std::string_view name;
    bool required = false, positional = false, by_name = false;
  };
  std::vector<Parameter> parameters;
  bool variadic = false;
};
Signature signature(std::string_view parameters);

}  // namespace race::language
