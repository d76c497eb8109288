// Methods of list, and sorting.
#include <algorithm>

#include "core/language/library/library_internal.h"
#include "core/language/values/values.h"
#include "core/language/values/work.h"

namespace race::language::library {

Value list_append(Context& context, Value& self, Arguments arguments) {
  List* items = changeable_list(context, self);
  if (!items) return Value::unknown();
  items->push_back(arguments[0]);
  check_growth(context, self, arguments[0], context.levels);
  return {};
}

Value list_clear(Context&, Value& self, Arguments) {
  self = Value(List());
  return {};
}

Value list_count(Context& context, const Value& self, Arguments arguments) {
  const List& items = self.as_list();
  if (!context.charge(work::elements(items.size()))) return Value::unknown();
  std::int64_t count = 0;
  for (const Value& item : items) {
    if (equal(context, item, arguments[0])) ++count;
    if (context.failed) return Value::unknown();
  }
  return Value(count);
}

Value list_extend(Context& context, Value& self, Arguments arguments) {
  const Value more = elements(context, arguments[0]);
  if (context.failed) return more;
  List* items = changeable_list(context, self);
  if (!items || !context.charge(work::elements(more.as_list().size()))) return Value::unknown();
  items->insert(items->end(), more.as_list().begin(), more.as_list().end());
  check_growth(context, self, more, context.levels);
  return {};
}

Value list_index(Context& context, const Value& self, Arguments arguments) {
  const List& items = self.as_list();
  const auto size = static_cast<std::int64_t>(items.size());
  std::int64_t bounds[2] = {0, size};
  for (std::size_t i = 0; i < 2; ++i) {
    if (!given(arguments, i + 1)) continue;
    const auto bound = integer(context, arguments[i + 1]);
    if (!bound) return Value::unknown();
    bounds[i] = *bound < 0 ? std::max<std::int64_t>(*bound + size, 0) : *bound;
  }
  for (std::int64_t i = bounds[0]; i < std::min(bounds[1], size); ++i) {
    if (!context.charge_element(static_cast<std::size_t>(i))) return Value::unknown();
    if (equal(context, items[static_cast<std::size_t>(i)], arguments[0])) return Value(i);
  }
  return context.fail(FaultKind::value, "the value is not in the list");
}

Value list_insert(Context& context, Value& self, Arguments arguments) {
  const auto at = integer(context, arguments[0]);
  if (!at) return Value::unknown();
  List* items = changeable_list(context, self);
  if (!items) return Value::unknown();
  const auto size = static_cast<std::int64_t>(items->size());
  const std::int64_t place = std::clamp<std::int64_t>(*at < 0 ? (*at < -size ? 0 : *at + size) : *at, 0, size);
  if (!context.charge(work::elements(static_cast<std::uint64_t>(size - place)))) return Value::unknown();
  items->insert(items->begin() + place, arguments[1]);
  check_growth(context, self, arguments[1], context.levels);
  return {};
}

Value list_pop(Context& context, Value& self, Arguments arguments) {
  std::int64_t at = -1;
  if (given(arguments, 0)) {
    const auto i = integer(context, arguments[0]);
    if (!i) return Value::unknown();
    at = *i;
  }
  const auto size = static_cast<std::int64_t>(self.as_list().size());
  if (size == 0) return context.fail(FaultKind::missing, "pop from empty list");
  if (at < -size || at >= size) return context.fail(FaultKind::missing, "pop index out of range");
  List* items = changeable_list(context, self);
  const std::int64_t from = at < 0 ? at + size : at;
  if (!items || !context.charge(work::elements(static_cast<std::uint64_t>(size - 1 - from)))) return Value::unknown();
  const auto place = items->begin() + from;
  Value popped = std::move(*place);
  items->erase(place);
  return popped;
}

Value list_remove(Context& context, Value& self, Arguments arguments) {
  List* items = changeable_list(context, self);
  if (!items || !context.charge(work::elements(items->size()))) return Value::unknown();
  const auto found = std::ranges::find_if(
      *items, [&](const Value& item) { return context.failed || equal(context, item, arguments[0]); });
  if (context.failed) return Value::unknown();
  if (found == items->end()) return context.fail(FaultKind::value, "list.remove(x): x not in list");
  items->erase(found);
  return {};
}

Value list_reverse(Context& context, Value& self, Arguments) {
  List* items = changeable_list(context, self);
  if (!items || !context.charge(work::elements(items->size()))) return Value::unknown();
  std::reverse(items->begin(), items->end());
  return {};
}

Value list_sort(Context& context, Value& self, Arguments arguments) {
  if (List* items = changeable_list(context, self)) sort(context, *items, given(arguments, 0) && truth(arguments[0]));
  return {};
}

bool sort(Context& context, List& items, bool reverse) {
  // Merging by hand: a comparison may be a fault, and NaN orders nothing, so std::stable_sort's premises do not hold.
  List merged(items.size());
  const auto less = [&](const Value& a, const Value& b) { return compare(context, BinaryOperator::less, a, b); };
  if (reverse) std::reverse(items.begin(), items.end());
  for (std::size_t width = 1; width < items.size() && !context.failed; width *= 2) {
    if (!context.charge(work::elements(items.size()))) return false;
    for (std::size_t begin = 0; begin < items.size(); begin += 2 * width) {
      const std::size_t middle = std::min(begin + width, items.size());
      const std::size_t end = std::min(begin + 2 * width, items.size());
      std::size_t left = begin;
      std::size_t right = middle;
      for (std::size_t out = begin; out < end; ++out) {
        const bool from_right = left == middle || (right < end && less(items[right], items[left]));
        merged[out] = std::move(from_right ? items[right++] : items[left++]);
      }
    }
    items.swap(merged);
  }
  if (reverse) std::reverse(items.begin(), items.end());
  return !context.failed;
}

}  // namespace race::language::library
