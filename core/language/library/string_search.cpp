// Methods of str that look for a text in another one. Positions are code points.
#include <algorithm>

#include "core/language/library/library_internal.h"
#include "core/language/primitives/search.h"
#include "core/language/primitives/utf8.h"
#include "core/language/values/values.h"
#include "core/language/values/work.h"

namespace race::language::library {
namespace {

const std::string* text(Context& context, const Value& v) {
  if (v.is_string()) return &v.as_string();
  context.fail(FaultKind::type, "must be str, not " + std::string(type_name(v)));
  return nullptr;
}

// self[start:end] as bytes, with where it begins; not `valid` if start lies behind the end of the text.
struct Window {
  bool valid = false;
  std::size_t begin = 0;  // bytes
  std::string_view text;
};

std::optional<Window> window(Context& context, const Value& self, Arguments arguments) {
  const std::string_view text = self.as_string();
  const auto is_given = [](const Value& v) { return !v.is_unknown() && !v.is_null(); };
  if (!is_given(optional(arguments, 1)) && !is_given(optional(arguments, 2))) return Window{true, 0, text};
  if (!context.charge(work::characters(text.size()) / 4)) return std::nullopt;
  const auto size = static_cast<std::int64_t>(utf8::length(text));
  std::int64_t bounds[2] = {0, size};
  for (std::size_t i = 0; i < 2; ++i) {
    const Value& v = optional(arguments, i + 1);
    if (!is_given(v)) continue;
    const auto bound = integer(context, v);
    if (!bound) return std::nullopt;
    bounds[i] = *bound < 0 ? std::max<std::int64_t>(*bound + size, 0) : *bound;
  }
  Window w;
  w.valid = bounds[0] <= size && bounds[0] <= std::min(bounds[1], size);
  if (!w.valid) return w;
  w.begin = utf8::offset(text, static_cast<std::size_t>(bounds[0]));
  const std::size_t end = utf8::offset(text, static_cast<std::size_t>(std::min(bounds[1], size)));
  w.text = text.substr(w.begin, end - w.begin);
  return w;
}

// The position of the first or last occurrence; -1 if there is none; unknown after a fault.
Value search(Context& context, const Value& self, Arguments arguments, bool last) {
  const std::string* sub = text(context, arguments[0]);
  const auto w = sub == nullptr ? std::nullopt : window(context, self, arguments);
  const std::uint64_t passes = last ? 2 : 1;  // from the end, copies are made
  if (!w || !context.charge(passes * work::search(w->text.size() + sub->size()))) return Value::unknown();
  const std::size_t found = !w->valid ? kNowhere : last ? find_last(w->text, *sub) : find_first(w->text, *sub);
  if (found == kNowhere) return Value(-1);
  return Value(static_cast<std::int64_t>(utf8::length(std::string_view(self.as_string()).substr(0, w->begin + found))));
}

Value must_be_found(Context& context, Value position) {
  if (position.is_integer() && position.as_integer() == -1)
    return context.fail(FaultKind::value, "substring not found");
  return position;
}

Value parted(std::string_view before, std::string_view separator, std::string_view after) {
  return Value(List{Value(before), Value(separator), Value(after)});
}

}  // namespace

Value str_find(Context& context, const Value& self, Arguments arguments) {
  return search(context, self, arguments, false);
}
Value str_rfind(Context& context, const Value& self, Arguments arguments) {
  return search(context, self, arguments, true);
}
Value str_index(Context& context, const Value& self, Arguments arguments) {
  return must_be_found(context, search(context, self, arguments, false));
}
Value str_rindex(Context& context, const Value& self, Arguments arguments) {
  return must_be_found(context, search(context, self, arguments, true));
}

Value str_count(Context& context, const Value& self, Arguments arguments) {
  const std::string* sub = text(context, arguments[0]);
  const auto w = sub == nullptr ? std::nullopt : window(context, self, arguments);
  if (!w || !context.charge(work::search(w->text.size() + sub->size()))) return Value::unknown();
  if (!w->valid) return Value(0);
  if (sub->empty()) return Value(static_cast<std::int64_t>(utf8::length(w->text) + 1));
  std::int64_t count = 0;
  for (std::size_t at = find_first(w->text, *sub); at != kNowhere; at = find_first(w->text, *sub, at + sub->size())) {
    if (!context.charge(1)) return Value::unknown();
    ++count;
  }
  return Value(count);
}

Value str_startswith(Context& context, const Value& self, Arguments arguments) {
  const std::string* prefix = text(context, arguments[0]);
  const auto w = prefix == nullptr ? std::nullopt : window(context, self, arguments);
  if (!w || !context.charge(work::block(prefix->size()))) return Value::unknown();
  return Value(w->valid && w->text.substr(0, prefix->size()) == *prefix);
}

Value str_endswith(Context& context, const Value& self, Arguments arguments) {
  const std::string* suffix = text(context, arguments[0]);
  const auto w = suffix == nullptr ? std::nullopt : window(context, self, arguments);
  if (!w || !context.charge(work::block(suffix->size()))) return Value::unknown();
  return Value(w->valid && w->text.size() >= suffix->size() &&
               w->text.substr(w->text.size() - suffix->size()) == *suffix);
}

Value str_partition(Context& context, const Value& self, Arguments arguments) {
  const std::string* sep = text(context, arguments[0]);
  if (sep == nullptr) return Value::unknown();
  if (sep->empty()) return context.fail(FaultKind::value, "empty separator");
  const std::string_view all = self.as_string();
  if (!context.charge(work::made(3) + work::search(all.size() + sep->size()))) return Value::unknown();
  const std::size_t at = find_first(all, *sep);
  if (at == kNowhere) return parted(all, "", "");
  return parted(all.substr(0, at), *sep, all.substr(at + sep->size()));
}

Value str_rpartition(Context& context, const Value& self, Arguments arguments) {
  const std::string* sep = text(context, arguments[0]);
  if (sep == nullptr) return Value::unknown();
  if (sep->empty()) return context.fail(FaultKind::value, "empty separator");
  const std::string_view all = self.as_string();
  if (!context.charge(work::made(3) + work::search(all.size() + sep->size()))) return Value::unknown();
  const std::size_t at = find_last(all, *sep);
  if (at == kNowhere) return parted("", "", all);
  return parted(all.substr(0, at), *sep, all.substr(at + sep->size()));
}

Value str_replace(Context& context, const Value& self, Arguments arguments) {
  const std::string* old = text(context, arguments[0]);
  const std::string* by = old == nullptr ? nullptr : text(context, arguments[1]);
  if (by == nullptr) return Value::unknown();
  std::int64_t count = -1;
  if (given(arguments, 2)) {
    const auto limit = integer(context, arguments[2]);
    if (!limit) return Value::unknown();
    count = *limit;
  }
  const std::string_view all = self.as_string();
  if (!context.charge(work::search(all.size() + old->size()))) return Value::unknown();
  std::string out;
  std::size_t at = 0;
  for (; count != 0; --count) {
    const std::size_t found = find_first(all, *old, at);
    if (found == kNowhere) break;
    const std::size_t added = found - at + by->size();
    if (!check_units(context, out.size() + added) || !context.charge(work::lookups(1) + work::block(added)))
      return Value::unknown();
    out += all.substr(at, found - at);
    out += *by;
    at = found + old->size();
    if (!old->empty()) continue;
    // Between all code points, before the first and behind the last.
    if (at == all.size()) return Value(std::move(out));
    const std::size_t begin = at;
    utf8::next(all, at);
    out += all.substr(begin, at - begin);
  }
  out += all.substr(at);
  return check_units(context, out.size()) ? Value(std::move(out)) : Value::unknown();
}

}  // namespace race::language::library
