// Execution of assignments: targets, places and changes in place.
#include "core/language/evaluate/machine_internal.h"
#include "core/language/values/work.h"

namespace race::language {

bool Machine::store(ValueIndex slot, Value value, NodeId id) {
  if (!check_storable(context_, value)) return locate_fault(id), false;
  environment_->write(slot, std::move(value));
  return true;
}

bool Machine::assign(NodeId target, Value value) {
  const Node& n = nodes_[target];
  switch (n.op) {
    case Opcode::target_local:
      locals_[n.a] = std::move(value);
      return true;
    case Opcode::target_slot:
      return store(n.a, std::move(value), target);
    case Opcode::target_place:
      return assign_place(program_->places[n.a], std::move(value), target);
    default:
      break;
  }
  const Value items = elements(context_, value);
  if (context_.failed) return locate_fault(target), false;
  const List& list = items.as_list();
  if (list.size() != n.count) {
    fail(FaultKind::value,
         (list.size() < n.count ? "not enough values to unpack (expected " : "too many values to unpack (expected ") +
             std::to_string(n.count) + ")",
         target);
    return false;
  }
  for (std::size_t i = 0; i < n.count; ++i)
    if (!assign(program_->run(n)[i], list[i])) return false;
  return true;
}

// place[key]...[key] = value
bool Machine::assign_place(const Place& place, Value value, NodeId id) {
  const ArgumentScope scope(stack_);
  if (!keys_of(place)) return false;
  Value copy;
  Value* root = root_of(place, copy, id);
  if (root == nullptr) return false;
  Value* parent = find(*root, scope.arguments().first(place.steps.size() - 1), id);
  if (parent == nullptr) return false;
  Value* where = element(context_, *parent, scope.arguments().back(), true);
  if (where == nullptr) return locate_fault(id), false;
  *where = std::move(value);
  if (!check_growth(context_, *parent, *where, static_cast<int>(place.steps.size()) - 1))
    return locate_fault(id), false;
  return place.local || store(place.root, std::move(copy), id);
}

// local op= value, res.x op= value
Machine::Flow Machine::augment(const Node& n, NodeId id) {
  const bool local = n.op == Opcode::augment_local;
  if ((local ? read_local(n, id) : environment_->values[n.a]).is_unknown()) return unknown(id), Flow::halt;
  Value out;
  const Value& by = operand(n.b, out);
  if (stopped_) return Flow::halt;
  const Value& old = local ? locals_[n.a] : environment_->values[n.a];
  const auto op = static_cast<BinaryOperator>(n.c);
  // OPTIMIZATION: counting.
  std::int64_t sum = 0;
  if (op == BinaryOperator::add && old.is_integer() && by.is_integer() &&
      !__builtin_add_overflow(old.as_integer(), by.as_integer(), &sum)) {
    if (local) {
      locals_[n.a] = Value(sum);
    } else {
      environment_->write(n.a, Value(sum));
    }
    return Flow::next;
  }
  const Value change = by;
  Value value;
  if (local) {
    value = std::move(locals_[n.a]);  // it is held once: what it changes is not copied
  } else {
    value = old;
  }
  if (!augmented(op, value, change, 0)) return locate_fault(id), Flow::halt;
  if (!local) return store(n.a, value, id) ? Flow::next : Flow::halt;
  locals_[n.a] = std::move(value);
  return Flow::next;
}

// place[key]...[key] op= value
Machine::Flow Machine::augment_place(const Node& n, NodeId id) {
  const Place& place = program_->places[n.a];
  const ArgumentScope scope(stack_);
  if (!keys_of(place)) return Flow::halt;
  const auto locate = [&](Value& copy) {
    Value* root = root_of(place, copy, id);
    return root == nullptr ? nullptr : find(*root, scope.arguments().first(place.steps.size()), id);
  };
  if (Value looked; locate(looked) == nullptr)
    return Flow::halt;  // a missing target is a fault before the value is evaluated
  Value out;
  const Value by = evaluate(n.b, out);
  if (stopped_) return Flow::halt;
  Value copy;
  Value* where = locate(copy);
  if (where == nullptr) return Flow::halt;
  if (!augmented(static_cast<BinaryOperator>(n.c), *where, by, static_cast<int>(place.steps.size())))
    return locate_fault(id), Flow::halt;
  if (!place.local && !store(place.root, std::move(copy), id)) return Flow::halt;
  return Flow::next;
}

// value op= by; a list takes every iterable on `+=`. `levels` is the depth of `value` in what it is part of.
bool Machine::augmented(BinaryOperator op, Value& value, const Value& by, int levels) {
  if (op != BinaryOperator::add || !value.is_list()) {
    value = arithmetic(context_, op, value, by);
    return !context_.failed;
  }
  const Value items = elements(context_, by);
  if (context_.failed) return false;
  List* list = changeable_list(context_, value);
  if (!list || !context_.charge(work::elements(items.as_list().size()))) return false;
  list->insert(list->end(), items.as_list().begin(), items.as_list().end());
  return check_growth(context_, value, items, levels);
}

// Evaluates the keys of a place onto the stack.
bool Machine::keys_of(const Place& place) {
  for (const Place::Step& step : place.steps) {
    if (step.field != kNone) {
      stack_.push_back(constants_[step.field]);
      continue;
    }
    Value out;
    const Value& key = operand(step.key, out);
    if (stopped_) return false;
    stack_.push_back(key);
  }
  return true;
}

// The root of a place, writable: the local itself, or a copy of the slot's value.
Value* Machine::root_of(const Place& place, Value& copy, NodeId id) {
  if (place.local) {
    if (!locals_[place.root].is_unknown()) return &locals_[place.root];
    fail(FaultKind::name, program_->locals[place.root], id);
    return nullptr;
  }
  copy = environment_->values[place.root];
  if (!copy.is_unknown()) return &copy;
  unknown(id);
  return nullptr;
}

// root[key]...[key], writable; null after a fault
Value* Machine::find(Value& root, Arguments keys, NodeId id) {
  Value* at = &root;
  for (const Value& key : keys) {
    at = element(context_, *at, key, false);
    if (at == nullptr) return locate_fault(id), nullptr;
  }
  return at;
}

}  // namespace race::language
