// What Python's operators and conversions do with values. Pure; failures go into the Context.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/language/syntax/operators.h"
#include "core/language/values/context.h"
#include "core/value/value.h"

namespace race::language {

/// The type's name as Python's messages have it: int, float, str, list, dict, bool, NoneType.
std::string_view type_name(const Value& v);

/// Python's truth of a value. Requires a known one.
bool truth(const Value& v);

/// Python's ==: 1, 1.0 and True are equal; false after a fault. Requires known values.
bool equal(Context& context, const Value& a, const Value& b);

/// a < b, a <= b, ... for `op` = less ... is_not_none; a type fault where Python has one (then false).
bool compare(Context& context, BinaryOperator op, const Value& a, const Value& b);

/// a + b, ... for `op` = add ... power.
Value arithmetic(Context& context, BinaryOperator op, const Value& a, const Value& b);
/// -a and +a.
Value sign(Context& context, UnaryOperator op, const Value& a);

/// a[key]; null on a fault. The element stays where it is in `a`; one of a string is put into `out`.
const Value* element(Context& context, const Value& a, const Value& key, Value& out);
/// The place of a[key] for changing it; null on a fault. With `create`, a key that a dict does not have is added.
Value* element(Context& context, Value& a, const Value& key, bool create);
/// a[low:high:step]; a missing part is unknown.
Value slice_of(Context& context, const Value& a, const Value& low, const Value& high, const Value& step);

/// The elements of a list, keys of a dict or characters of a string, as a list; unknown on a fault.
Value elements(Context& context, const Value& v);

/// An int (or bool) argument; nothing and a type fault otherwise.
std::optional<std::int64_t> integer(Context& context, const Value& v);

/// The size of a value: elements plus string bytes (SEMANTICS.md section 8), levels of nesting, and whether every
/// double in it is finite. Stops counting above `limit`.
struct Measure {
  std::uint64_t units = 0;
  std::uint64_t visited = 0;  // values and keys; strings twice
  int depth = 0;
  bool finite = true;
};
Measure measure(const Value& v, std::uint64_t limit);

/// start, start + step, ...: `count` integers.
struct Range {
  std::int64_t start = 0, step = 1;
  std::uint64_t count = 0;
};
/// The arguments of range(); nothing and a fault if they are none, or too many integers for a value.
std::optional<Range> range_of_arguments(Context& context, Arguments arguments);

inline constexpr int kMaxValueDepth = 50;  // levels of lists and dicts in each other; JSON documents carry 64

/// `v`, or a budget fault if it is larger or deeper than values may be.
Value within_limits(Context& context, Value v);
/// Whether `container` is within its limits after `added` has become an element; `levels` is the depth of `container`
/// in the value that it belongs to. OPTIMIZATION: small additions are measured at powers of two only, so that appending
/// one by one stays cheap. A value may exceed the limit twofold before it is found, but never in Δ (check_storable).
bool check_growth(Context& context, const Value& container, const Value& added, int levels);
/// Whether a value of `units` is within the limit; a budget fault otherwise.
bool check_units(Context& context, std::uint64_t units);

/// For changing a list or dict in place: one that something else holds, too, is copied first, which is charged. Null
/// after a fault. Each requires its kind.
List* changeable_list(Context& context, Value& v);
Dict* changeable_dict(Context& context, Value& v);

/// Whether `v` may be stored in Δ or sent: not too large, and finite; a fault otherwise.
bool check_storable(Context& context, const Value& v);

}  // namespace race::language
