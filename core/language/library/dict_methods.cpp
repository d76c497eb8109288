// Methods of dict. What Python gives as views are lists here.
#include "core/language/library/library_internal.h"
#include "core/language/values/printing.h"
#include "core/language/values/values.h"
#include "core/language/values/work.h"

namespace race::language::library {
namespace {

// A key that can be looked up; others are in no dict, lists and dicts are type faults.
bool is_hashable(Context& context, const Value& key) {
  if (key.is_list() || key.is_dict())
    context.fail(FaultKind::type, "unhashable type: '" + std::string(type_name(key)) + "'");
  return !context.failed;
}

bool charge_lookup(Context& context, const Value& key) {
  return !key.is_string() || context.charge(work::block(key.as_string().size()));
}

}  // namespace

Value copied(Context&, const Value& self, Arguments) { return self; }

Value dict_clear(Context&, Value& self, Arguments) {
  self = Value(Dict());
  return {};
}

Value dict_get(Context& context, const Value& self, Arguments arguments) {
  if (!is_hashable(context, arguments[0]) || !charge_lookup(context, arguments[0])) return Value::unknown();
  const Value* found = arguments[0].is_string() ? self.as_dict().find(arguments[0]) : nullptr;
  if (found != nullptr) return *found;
  return given(arguments, 1) ? arguments[1] : Value();
}

Value dict_items(Context& context, const Value& self, Arguments) {
  if (!context.charge(work::made(self.as_dict().size()))) return Value::unknown();
  List items;
  for (const auto& [key, item] : self.as_dict()) items.emplace_back(List{key, item});
  return within_limits(context, Value(std::move(items)));
}

Value dict_keys(Context& context, const Value& self, Arguments) {
  if (!context.charge(work::elements(self.as_dict().size()))) return Value::unknown();
  List items;
  for (const auto& [key, item] : self.as_dict()) items.push_back(key);
  return Value(std::move(items));
}

Value dict_values(Context& context, const Value& self, Arguments) {
  if (!context.charge(work::elements(self.as_dict().size()))) return Value::unknown();
  List items;
  for (const auto& [key, item] : self.as_dict()) items.push_back(item);
  return Value(std::move(items));
}

Value dict_pop(Context& context, Value& self, Arguments arguments) {
  // In an empty dict Python does not look at the key.
  if (!self.as_dict().empty() && !is_hashable(context, arguments[0])) return Value::unknown();
  if (!charge_lookup(context, arguments[0])) return Value::unknown();
  const Value* found = arguments[0].is_string() ? self.as_dict().find(arguments[0]) : nullptr;
  if (found == nullptr && given(arguments, 1)) return arguments[1];
  if (found == nullptr) return context.fail(FaultKind::missing, repr(arguments[0]));
  Value popped = *found;
  Dict* entries = changeable_dict(context, self);
  if (!entries || !context.charge(2 * work::entries(entries->size())))
    return Value::unknown();  // its index is made anew
  entries->erase(arguments[0].as_string());
  return popped;
}

Value dict_setdefault(Context& context, Value& self, Arguments arguments) {
  if (!arguments[0].is_string()) return context.fail(FaultKind::type, "keys of a dict must be str");
  if (!charge_lookup(context, arguments[0])) return Value::unknown();
  if (const Value* found = self.as_dict().find(arguments[0])) return *found;
  const Value added = given(arguments, 1) ? arguments[1] : Value();
  Dict* entries = changeable_dict(context, self);
  if (!entries || !context.charge(work::sets(1))) return Value::unknown();
  entries->set(arguments[0], added);
  return check_growth(context, self, added, context.levels) ? added : Value::unknown();
}

Value dict_update(Context& context, Value& self, Arguments arguments) {
  const Value more = to_dict(context, std::span(arguments).first(1));
  if (context.failed) return more;
  Dict* entries = changeable_dict(context, self);
  if (!entries || !context.charge(work::sets(more.as_dict().size()))) return Value::unknown();
  for (const auto& [key, item] : more.as_dict()) entries->set(key, item);
  check_growth(context, self, more, context.levels - 1);
  return {};
}

}  // namespace race::language::library
