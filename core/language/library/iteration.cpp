// Builtin functions about lists and what can be iterated. What Python gives as iterators are lists here.
#include <algorithm>

#include "core/language/library/library_internal.h"
#include "core/language/primitives/utf8.h"
#include "core/language/values/values.h"
#include "core/language/values/work.h"

namespace race::language::library {

namespace {

// Whether there is an element of this truth; those before it are looked at.
std::optional<bool> any_of_truth(Context& context, Arguments arguments, bool wanted) {
  const Value items = elements(context, arguments[0]);
  if (context.failed) return std::nullopt;
  const List& list = items.as_list();
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!context.charge_element(i)) return std::nullopt;
    if (truth(list[i]) == wanted) return true;
  }
  return false;
}

}  // namespace

Value all(Context& context, Arguments arguments) {
  const auto found = any_of_truth(context, arguments, false);
  return found ? Value(!*found) : Value::unknown();
}

Value any(Context& context, Arguments arguments) {
  const auto found = any_of_truth(context, arguments, true);
  return found ? Value(*found) : Value::unknown();
}

Value length(Context& context, Arguments arguments) {
  const Value& v = arguments[0];
  if (v.is_list()) return Value(static_cast<std::int64_t>(v.as_list().size()));
  if (v.is_dict()) return Value(static_cast<std::int64_t>(v.as_dict().size()));
  if (v.is_string()) {
    if (!context.charge(work::scan(v.as_string().size()))) return Value::unknown();
    return Value(static_cast<std::int64_t>(utf8::length(v.as_string())));
  }
  return context.fail(FaultKind::type, "object of type '" + std::string(type_name(v)) + "' has no len()");
}

Value range(Context& context, Arguments arguments) {
  const auto counted = range_of_arguments(context, arguments);
  if (!counted || !context.charge(work::elements(counted->count))) return Value::unknown();
  List items;
  items.reserve(counted->count);
  std::int64_t v = counted->start;
  for (std::uint64_t i = 0; i < counted->count; ++i) {
    items.emplace_back(v);
    if (i + 1 < counted->count) v += counted->step;
  }
  return Value(std::move(items));
}

Value reversed(Context& context, Arguments arguments) {
  const Value items = elements(context, arguments[0]);
  if (context.failed || !context.charge(work::elements(items.as_list().size()))) return Value::unknown();
  return within_limits(context, Value(List(items.as_list().rbegin(), items.as_list().rend())));
}

Value sorted(Context& context, Arguments arguments) {
  const Value items = elements(context, arguments[0]);
  if (context.failed || !context.charge(work::elements(items.as_list().size()))) return Value::unknown();
  List list = items.as_list();
  if (!sort(context, list, given(arguments, 1) && truth(arguments[1]))) return Value::unknown();
  return within_limits(context, Value(std::move(list)));
}

Value enumerate(Context& context, Arguments arguments) {
  const Value items = elements(context, arguments[0]);
  if (context.failed) return items;
  std::int64_t number = 0;
  if (given(arguments, 1)) {
    const auto start = integer(context, arguments[1]);
    if (!start) return Value::unknown();
    number = *start;
  }
  if (!context.charge(2 * work::made(items.as_list().size()))) return Value::unknown();
  List pairs;
  for (const Value& item : items.as_list()) {
    pairs.emplace_back(List{Value(number), item});
    if (__builtin_add_overflow(number, 1, &number)) return context.fail(FaultKind::overflow, "integer out of 64 bits");
  }
  return within_limits(context, Value(std::move(pairs)));
}

Value zip(Context& context, Arguments arguments) {
  List columns;
  std::size_t rows = arguments.empty() ? 0 : SIZE_MAX;
  for (const Value& argument : arguments) {
    columns.push_back(elements(context, argument));
    if (context.failed) return Value::unknown();
    rows = std::min(rows, columns.back().as_list().size());
  }
  if (!check_units(context, rows * columns.size()) ||
      !context.charge(2 * work::made(rows) + work::elements(rows * columns.size())))
    return Value::unknown();
  List made;
  for (std::size_t i = 0; i < rows; ++i) {
    List row;
    for (const Value& column : columns) row.push_back(column.as_list()[i]);
    made.emplace_back(std::move(row));
  }
  return within_limits(context, Value(std::move(made)));
}

}  // namespace race::language::library
