// Conversions, truth, equality, sizes.
#include "core/language/values/values.h"

#include <bit>
#include <cmath>

#include "core/language/primitives/numbers.h"
#include "core/language/primitives/utf8.h"
#include "core/language/values/work.h"

namespace race::language {

std::string_view type_name(const Value& v) {
  switch (v.kind()) {
    case Value::Kind::boolean:
      return "bool";
    case Value::Kind::integer:
      return "int";
    case Value::Kind::number:
      return "float";
    case Value::Kind::string:
      return "str";
    case Value::Kind::list:
      return "list";
    case Value::Kind::dict:
      return "dict";
    default:
      return "NoneType";
  }
}

bool truth(const Value& v) {
  switch (v.kind()) {
    case Value::Kind::boolean:
      return v.as_bool();
    case Value::Kind::integer:
      return v.as_integer() != 0;
    case Value::Kind::number:
      return v.as_number() != 0;
    case Value::Kind::string:
      return !v.as_string().empty();
    case Value::Kind::list:
      return !v.as_list().empty();
    case Value::Kind::dict:
      return !v.as_dict().empty();
    default:
      return false;
  }
}

std::optional<std::int64_t> integer(Context& context, const Value& v) {
  if (v.is_integer() || v.is_bool()) return v.as_integer();
  context.fail(FaultKind::type, "'" + std::string(type_name(v)) + "' object cannot be interpreted as an integer");
  return std::nullopt;
}

Value elements(Context& context, const Value& v) {
  if (v.is_list()) return v;
  List items;
  if (v.is_dict()) {
    if (!context.charge(work::elements(v.as_dict().size()))) return Value::unknown();
    for (const auto& [key, item] : v.as_dict()) items.push_back(key);
  } else if (v.is_string()) {
    const std::string& text = v.as_string();
    if (!context.charge(work::made(text.size()))) return Value::unknown();
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t begin = at;
      utf8::next(text, at);
      items.emplace_back(std::string_view(text).substr(begin, at - begin));
    }
  } else {
    return context.fail(FaultKind::type, "'" + std::string(type_name(v)) + "' object is not iterable");
  }
  return Value(std::move(items));
}

namespace {

void add(const Value& v, std::uint64_t limit, int depth, Measure& sum) {
  sum.units += 1;
  sum.visited += 1;
  if (sum.units > limit) return;
  if (v.is_number()) {
    sum.finite = sum.finite && std::isfinite(v.as_number());
  } else if (v.is_string()) {
    sum.units += v.as_string().size();
    sum.visited += 1;
  } else if (v.is_list() || v.is_dict()) {
    sum.depth = std::max(sum.depth, depth + 1);
    if (sum.depth > kMaxValueDepth) return;
    if (v.is_list())
      for (const Value& item : v.as_list()) {
        add(item, limit, depth + 1, sum);
        if (sum.units > limit) return;
      }
    if (v.is_dict())
      for (const auto& [key, item] : v.as_dict()) {
        sum.units += key.as_string().size() + 1;
        sum.visited += 1;
        add(item, limit, depth + 1, sum);
        if (sum.units > limit) return;
      }
  }
}

bool fits(Context& context, const Measure& m, int levels = 0) {
  context.charge(work::elements(m.visited));
  if (m.units > context.value_units) {
    context.fail(FaultKind::budget, "a value of more than " + std::to_string(context.value_units) + " units");
  } else if (m.depth + levels > kMaxValueDepth) {
    context.fail(FaultKind::budget, "a value of more than " + std::to_string(kMaxValueDepth) + " levels");
  }
  return !context.failed;
}

}  // namespace

Measure measure(const Value& v, std::uint64_t limit) {
  Measure sum;
  add(v, limit, 0, sum);
  return sum;
}

Value within_limits(Context& context, Value v) {
  if (fits(context, measure(v, context.value_units))) return v;
  return Value::unknown();
}

bool check_growth(Context& context, const Value& container, const Value& added, int levels) {
  constexpr std::uint64_t kSmall = 64;
  const std::size_t count = container.is_list()   ? container.as_list().size()
                            : container.is_dict() ? container.as_dict().size()
                                                  : 0;
  const Measure m = measure(added, kSmall);
  const bool now = m.units > kSmall || (count >= 16 && std::has_single_bit(count)) || count > context.value_units;
  if (m.units <= kSmall && !fits(context, m, levels + 1)) return false;
  return !now || fits(context, measure(container, context.value_units), levels);
}

bool check_units(Context& context, std::uint64_t units) {
  if (units < context.value_units) return true;
  context.fail(FaultKind::budget, "a value of more than " + std::to_string(context.value_units) + " units");
  return false;
}

bool check_storable(Context& context, const Value& v) {
  if (v.is_number()) {
    if (!std::isfinite(v.as_number())) context.fail(FaultKind::value, "NaN and infinities cannot be stored");
    return !context.failed;
  }
  if (v.kind() < Value::Kind::string) return true;
  const Measure m = measure(v, context.value_units);
  if (!fits(context, m)) return false;
  if (!m.finite) context.fail(FaultKind::value, "NaN and infinities cannot be stored");
  return !context.failed;
}

List* changeable_list(Context& context, Value& v) {
  if (v.is_shared() && !context.charge(work::elements(v.as_list().size()))) return nullptr;
  return &v.mutable_list();
}

Dict* changeable_dict(Context& context, Value& v) {
  if (v.is_shared() && !context.charge(work::entries(v.as_dict().size()))) return nullptr;
  return &v.mutable_dict();
}

bool equal(Context& context, const Value& a, const Value& b) {
  const auto numeric = [](const Value& v) { return v.is_numeric() || v.is_bool(); };
  if (numeric(a) && numeric(b)) {
    if (a.is_number() && b.is_number()) return a.as_number() == b.as_number();
    if (a.is_number()) return !std::isnan(a.as_number()) && compare(b.as_integer(), a.as_number()) == 0;
    if (b.is_number()) return !std::isnan(b.as_number()) && compare(a.as_integer(), b.as_number()) == 0;
    return a.as_integer() == b.as_integer();
  }
  if (a.kind() != b.kind()) return false;
  if (a.is_string())
    return a.as_string().size() == b.as_string().size() && context.charge(work::block(a.as_string().size())) &&
           a.as_string() == b.as_string();
  if (a.is_list()) {
    const List& x = a.as_list();
    const List& y = b.as_list();
    if (x.size() != y.size()) return false;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (!context.charge_element(i) || !equal(context, x[i], y[i])) return false;
    return !context.failed;
  }
  if (a.is_dict()) {
    if (a.as_dict().size() != b.as_dict().size()) return false;
    for (const auto& [key, item] : a.as_dict()) {
      if (!context.charge(work::lookups(1) + work::block(key.as_string().size()))) return false;
      const Value* other = b.as_dict().find(key);
      if (other == nullptr || !equal(context, item, *other)) return false;
    }
  }
  return !context.failed;
}

}  // namespace race::language
