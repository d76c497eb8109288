// Evaluation of lists, dicts, strings and their parts.
#include "core/language/evaluate/machine_internal.h"
#include "core/language/values/printing.h"
#include "core/language/values/work.h"

namespace race::language {

// object.key, which reads a dict like object['key']
const Value& Machine::field(const Node& n, NodeId id, Value& out) {
  Value object_out;
  const Value& object = operand(n.a, object_out);
  if (object.is_unknown()) return kUnknown;
  if (!object.is_dict())
    return fail(
        FaultKind::type,
        "'" + std::string(type_name(object)) + "' object has no attribute '" + constants_[n.b].as_string() + "'", id);
  const Value* found = object.as_dict().find(constants_[n.b]);
  if (found == nullptr) return fail(FaultKind::missing, repr(constants_[n.b]), id);
  if (&object != &object_out) return *found;
  out = *found;
  return out;
}

const Value& Machine::index(const Node& n, NodeId id, Value& out) {
  Value object_out;
  Value key_out;
  const Value& object = operand(n.a, object_out);
  if (object.is_unknown() && stopped_) return kUnknown;
  const Value& key = operand(n.b, key_out);
  if (object.is_unknown() || key.is_unknown()) return kUnknown;
  const Value* found = element(context_, object, key, out);
  if (found == nullptr) return locate_fault(id);
  if (found == &out || &object != &object_out) return *found;
  out = *found;
  return out;
}

const Value& Machine::slice(const Node& n, NodeId id, Value& out) {
  const std::uint32_t* run = program_->run(n);
  Value parts[4] = {Value::unknown(), Value::unknown(), Value::unknown(), Value::unknown()};
  bool any_unknown = false;
  for (std::size_t i = 0; i < 4; ++i) {
    if (run[i] == kNone) continue;
    Value part;
    parts[i] = evaluate(run[i], part);
    if (stopped_) return kUnknown;
    any_unknown = any_unknown || parts[i].is_unknown();
  }
  if (any_unknown) return kUnknown;
  return checked(slice_of(context_, parts[0], parts[1], parts[2], parts[3]), id, out);
}

const Value& Machine::list(const Node& n, NodeId id, Value& out) {
  const std::uint32_t* run = program_->run(n);
  if (!context_.charge(work::made(1))) return locate_fault(id);
  List items;
  items.reserve(n.count);
  bool any_unknown = false;
  for (std::size_t i = 0; i < n.count; ++i) {
    Value item;
    const Value& v = evaluate(run[i], item);
    if (stopped_) return kUnknown;
    any_unknown = any_unknown || v.is_unknown();
    if (&v == &item) {
      items.push_back(std::move(item));
    } else {
      items.push_back(v);
    }
  }
  if (any_unknown) return kUnknown;
  return checked(within_limits(context_, Value(std::move(items))), id, out);
}

const Value& Machine::dict(const Node& n, NodeId id, Value& out) {
  const std::uint32_t* run = program_->run(n);
  if (!context_.charge(work::made(1))) return locate_fault(id);
  Dict entries;
  bool any_unknown = false;
  for (std::size_t i = 0; i < n.count; i += 2) {
    Value key_out;
    Value item_out;
    const Value& key = evaluate(run[i], key_out);
    if (stopped_) return kUnknown;
    const Value& item = evaluate(run[i + 1], item_out);
    if (stopped_) return kUnknown;
    any_unknown = any_unknown || key.is_unknown() || item.is_unknown();
    if (any_unknown) continue;
    if (!key.is_string()) return fail(FaultKind::type, "keys of a dict must be str", run[i]);
    if (!context_.charge(work::sets(1) + work::block(key.as_string().size()))) return locate_fault(run[i]);
    entries.set(key, item);
  }
  if (any_unknown) return kUnknown;
  return checked(within_limits(context_, Value(std::move(entries))), id, out);
}

// par, res, var as a whole: a copy of the values that are set
const Value& Machine::collection(const Node& n, NodeId id, Value& out) {
  const auto& slots = program_->collections[n.a].entries;
  if (!context_.charge(work::sets(slots.size()))) return locate_fault(id);
  Dict entries;
  for (const auto& [name, slot] : slots) {
    const Value& v = environment_->values[slot];
    if (!v.is_unknown()) entries.set(constants_[name], v);
  }
  out = Value(std::move(entries));
  return out;
}

const Value& Machine::comprehension(const Node& n, NodeId id, Value& out) {
  if (!context_.charge(work::made(1))) return locate_fault(id);
  List made;
  bool any_unknown = false;
  if (!clause(n, 0, made, any_unknown)) return kUnknown;
  if (any_unknown) return kUnknown;
  return checked(within_limits(context_, Value(std::move(made))), id, out);
}

// One `for` of a comprehension, with what follows it. An unknown iterable, filter or element makes the whole unknown.
bool Machine::clause(const Node& n, std::size_t number, List& made, bool& any_unknown) {
  const auto& clauses = program_->comprehensions[n.b];
  if (number == clauses.size()) {
    Value element;
    const Value& v = evaluate(n.a, element);
    any_unknown = any_unknown || v.is_unknown();
    if (!any_unknown) made.push_back(v);
    if (made.size() > limits_.value_units) fail(FaultKind::budget, "the list is too large", n.a);
    return !stopped_;
  }
  const ComprehensionClause& c = clauses[number];
  Value iterable_out;
  const Value& iterable = evaluate(c.iterable, iterable_out);
  if (stopped_) return false;
  if (iterable.is_unknown()) return any_unknown = true;
  const Value items = elements(context_, iterable);
  if (context_.failed) return locate_fault(c.iterable), false;
  for (const Value& item : items.as_list()) {
    if (!assign(c.target, item)) return false;
    Truth passes = Truth::yes;
    for (std::size_t i = 0; i < c.filters.size() && passes == Truth::yes; ++i) passes = test(c.filters[i]);
    if (stopped_) return false;
    if (passes == Truth::unknown) any_unknown = true;
    if (passes == Truth::yes && !clause(n, number + 1, made, any_unknown)) return false;
  }
  return true;
}

const Value& Machine::fstring(const Node& n, NodeId id, Value& out) {
  const std::uint32_t* run = program_->run(n);
  std::string text;
  bool any_unknown = false;
  for (std::size_t i = 0; i < n.count; ++i) {
    Value part;
    const Value& v = evaluate(run[i], part);
    if (stopped_) return kUnknown;
    any_unknown = any_unknown || v.is_unknown();
    if (any_unknown) continue;
    if (!check_units(context_, text.size() + v.as_string().size()) ||
        !context_.charge(2 * work::block(v.as_string().size())))
      return locate_fault(id);
    text += v.as_string();
  }
  if (any_unknown) return kUnknown;
  out = Value(std::move(text));
  return out;
}

// One replacement field of an f-string.
const Value& Machine::format(const Node& n, NodeId id, Value& out) {
  Value value_out;
  Value format_out;
  const Value& v = evaluate(n.a, value_out);
  if (stopped_) return kUnknown;
  std::string_view specification;
  if (n.b != kNone) {
    const Value& how = evaluate(n.b, format_out);
    if (stopped_ || how.is_unknown()) return kUnknown;
    specification = how.as_string();
  }
  if (v.is_unknown()) return kUnknown;
  const auto conversion = static_cast<char>(n.c);
  Value shown = v;
  if (conversion != 0) {
    if (!charge_printing(context_, v)) return locate_fault(id);
    shown = Value(conversion == 's' ? str(v) : repr(v));
    if (conversion == 'a') shown = Value(ascii(shown.as_string()));
  }
  return checked(formatted(context_, shown, specification), id, out);
}

}  // namespace race::language
