// Indices, slices and ranges.
#include <algorithm>

#include "core/language/primitives/utf8.h"
#include "core/language/values/printing.h"
#include "core/language/values/values.h"
#include "core/language/values/work.h"

namespace race::language {
namespace {

// The position that `key` means in a sequence of `size`; nothing and a fault if it has none.
std::optional<std::size_t> position(Context& context, const Value& key, std::size_t size, std::string_view type) {
  if (!key.is_integer() && !key.is_bool()) {
    context.fail(FaultKind::type, std::string(type) + " indices must be integers, not " + std::string(type_name(key)));
    return std::nullopt;
  }
  std::int64_t i = key.as_integer();
  if (i < 0) i += static_cast<std::int64_t>(size);
  if (i >= 0 && i < static_cast<std::int64_t>(size)) return static_cast<std::size_t>(i);
  context.fail(FaultKind::missing, std::string(type) + " index out of range");
  return std::nullopt;
}

// Whether `key` may be looked up in a dict; only strings are found there.
bool is_key(Context& context, const Value& key) {
  if (key.is_string()) return true;
  if (key.is_list() || key.is_dict()) {
    context.fail(FaultKind::type, "unhashable type: '" + std::string(type_name(key)) + "'");
  } else {
    context.fail(FaultKind::missing, repr(key));
  }
  return false;
}

void not_subscriptable(Context& context, const Value& a) {
  context.fail(FaultKind::type, "'" + std::string(type_name(a)) + "' object is not subscriptable");
}

// A bound of a slice, as Python clips it.
std::int64_t clipped(const Value& bound, std::int64_t otherwise, std::int64_t size, std::int64_t low,
                     std::int64_t high) {
  if (bound.is_unknown() || bound.is_null()) return otherwise;
  std::int64_t i = bound.as_integer();
  if (i < 0) i = i < -size ? low : i + size;
  return std::clamp(i, low, high);
}

}  // namespace

const Value* element(Context& context, const Value& a, const Value& key, Value& out) {
  if (a.is_list()) {
    const auto at = position(context, key, a.as_list().size(), "list");
    return at ? &a.as_list()[*at] : nullptr;
  }
  if (a.is_dict()) {
    if (!is_key(context, key) || !context.charge(work::block(key.as_string().size()))) return nullptr;
    const Value* found = a.as_dict().find(key);
    if (found == nullptr) context.fail(FaultKind::missing, repr(key));
    return found;
  }
  if (!a.is_string()) {
    not_subscriptable(context, a);
    return nullptr;
  }
  const std::string& text = a.as_string();
  if (!context.charge(work::characters(text.size()) / 4)) return nullptr;
  const auto at = position(context, key, utf8::length(text), "string");
  if (!at) return nullptr;
  std::size_t begin = utf8::offset(text, *at);
  std::size_t end = begin;
  utf8::next(text, end);
  out = Value(text.substr(begin, end - begin));
  return &out;
}

Value* element(Context& context, Value& a, const Value& key, bool create) {
  if (a.is_list()) {
    const auto at = position(context, key, a.as_list().size(), create ? "list assignment" : "list");
    List* items = at ? changeable_list(context, a) : nullptr;
    return items ? &(*items)[*at] : nullptr;
  }
  if (!a.is_dict()) {
    if (create) {
      context.fail(FaultKind::type, "'" + std::string(type_name(a)) + "' object does not support item assignment");
    } else {
      not_subscriptable(context, a);
    }
    return nullptr;
  }
  if (create && !key.is_string()) {
    context.fail(FaultKind::type, "keys of a dict must be str");
    return nullptr;
  }
  if (!is_key(context, key) || !context.charge(work::block(key.as_string().size()))) return nullptr;
  Dict* entries = changeable_dict(context, a);
  if (!entries) return nullptr;
  if (Value* found = entries->find(key)) return found;
  if (create) {
    if (!context.charge(work::sets(1))) return nullptr;
    entries->set(key, Value());
    return entries->find(key);
  }
  context.fail(FaultKind::missing, repr(key));
  return nullptr;
}

Value slice_of(Context& context, const Value& a, const Value& low, const Value& high, const Value& step) {
  if (!a.is_list() && !a.is_string()) {
    if (a.is_dict()) return context.fail(FaultKind::type, "unhashable type: 'slice'");
    not_subscriptable(context, a);
    return Value::unknown();
  }
  for (const Value* part : {&low, &high, &step})
    if (!part->is_unknown() && !part->is_null() && !part->is_integer() && !part->is_bool())
      return context.fail(FaultKind::type, "slice indices must be integers or None");
  const std::int64_t by = step.is_unknown() || step.is_null() ? 1 : step.as_integer();
  if (by == 0) return context.fail(FaultKind::value, "slice step cannot be zero");
  const bool is_text = a.is_string();
  const bool bytes = is_text && utf8::ascii(a.as_string());
  if (is_text && !context.charge(work::characters(a.as_string().size()) / (bytes ? 2 : 1))) return Value::unknown();
  const std::u32string points = is_text && !bytes ? utf8::decode(a.as_string()) : std::u32string();
  const auto size = static_cast<std::int64_t>(!is_text ? a.as_list().size()
                                              : bytes  ? a.as_string().size()
                                                       : points.size());
  const bool forward = by > 0;
  const std::int64_t least = forward ? 0 : -1;
  const std::int64_t most = forward ? size : size - 1;
  const std::int64_t begin = clipped(low, forward ? 0 : size - 1, size, least, most);
  const std::int64_t end = clipped(high, forward ? size : -1, size, least, most);
  if (!is_text && begin != end) {
    // What lies between the bounds, divided by the step, is what is copied.
    const auto distance = static_cast<std::uint64_t>(forward ? std::max<std::int64_t>(end - begin, 0)
                                                             : std::max<std::int64_t>(begin - end, 0));
    const auto step_size = forward ? static_cast<std::uint64_t>(by) : ~static_cast<std::uint64_t>(by) + 1;
    if (!context.charge(work::made(1) + 2 * work::elements(distance / step_size))) return Value::unknown();
  }
  std::string text;
  std::u32string chosen;
  List items;
  for (std::int64_t i = begin; forward ? i < end : i > end;) {
    const auto at = static_cast<std::size_t>(i);
    if (!is_text) {
      items.push_back(a.as_list()[at]);
    } else if (bytes) {
      text += a.as_string()[at];
    } else {
      chosen += points[at];
    }
    if (__builtin_add_overflow(i, by, &i)) break;
  }
  if (!is_text) return Value(std::move(items));
  return bytes ? Value(std::move(text)) : Value(utf8::encode(chosen));
}

std::optional<Range> range_of_arguments(Context& context, Arguments arguments) {
  const auto first = integer(context, arguments[0]);
  if (!first) return std::nullopt;
  Range range;
  std::int64_t end = *first;
  if (!arguments[1].is_unknown()) {
    range.start = *first;
    const auto second = integer(context, arguments[1]);
    if (!second) return std::nullopt;
    end = *second;
  }
  if (!arguments[2].is_unknown()) {
    const auto step = integer(context, arguments[2]);
    if (!step) return std::nullopt;
    range.step = *step;
  }
  if (range.step == 0) {
    context.fail(FaultKind::value, "range() arg 3 must not be zero");
    return std::nullopt;
  }
  const bool up = range.step > 0;
  if (up ? range.start < end : range.start > end) {
    const auto distance = up ? static_cast<std::uint64_t>(end) - static_cast<std::uint64_t>(range.start)
                             : static_cast<std::uint64_t>(range.start) - static_cast<std::uint64_t>(end);
    const auto step = up ? static_cast<std::uint64_t>(range.step) : ~static_cast<std::uint64_t>(range.step) + 1;
    range.count = (distance - 1) / step + 1;
  }
  if (!check_units(context, range.count)) return std::nullopt;
  return range;
}

}  // namespace race::language
