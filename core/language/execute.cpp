// Execution of statements: assignments, control flow, calls of operations.
#include <cmath>

#include "core/language/machine_internal.h"

namespace race::language {

Machine::Flow Machine::execute(NodeId id) {
  const Node& n = nodes_[id];
  if (--left_ < 0) {
    if (!stopped_) fail(FaultKind::budget, "more than " + std::to_string(limits_.steps) + " steps", id);
    return Flow::halt;
  }
  switch (n.op) {
    case Op::block:
      return block(n);
    case Op::evaluate: {
      Value out;
      evaluate(n.a, out);
      return stopped_ ? Flow::halt : Flow::next;
    }
    case Op::assign_local: {
      Value out;
      const Value& v = operand(n.a, out);
      if (stopped_) return Flow::halt;
      if (&v == &out) {
        locals_[n.b] = std::move(out);
      } else {
        locals_[n.b] = v;
      }
      return Flow::next;
    }
    case Op::assign_slot: {
      Value out;
      const Value& v = operand(n.a, out);
      if (stopped_) return Flow::halt;
      return store(n.b, &v == &out ? std::move(out) : v, id) ? Flow::next : Flow::halt;
    }
    case Op::assign: {
      Value out;
      const Value v = evaluate(n.b, out);
      if (stopped_) return Flow::halt;
      for (std::size_t i = 0; i < n.count; ++i)
        if (!assign(program_->run(n)[i], v)) return Flow::halt;
      return Flow::next;
    }
    case Op::augment_local:
    case Op::augment_slot:
      return augment(n, id);
    case Op::augment_place:
      return augment_place(n, id);
    case Op::branch:
      return branch(n);
    case Op::loop:
      return loop(n, id);
    case Op::repeat:
      return repeat(n);
    case Op::stop:
      return Flow::leave;
    case Op::skip:
      return Flow::again;
    case Op::call_service:
      return call_service(n, id);
    default:
      return Flow::next;  // pass
  }
}

Machine::Flow Machine::block(const Node& n) {
  const std::uint32_t* statements = program_->run(n);
  const bool top = environment_->trace != nullptr && &n == &nodes_[program_->root];
  for (std::size_t i = 0; i < n.count; ++i) {
    const Node& s = nodes_[statements[i]];
    if (top && s.op != Op::call_service) environment_->trace->statement(s.service, program_->range(statements[i]));
    const Flow flow = execute(statements[i]);
    if (flow != Flow::next) return flow;
  }
  return Flow::next;
}

Machine::Flow Machine::branch(const Node& n) {
  const std::uint32_t* run = program_->run(n);
  std::size_t i = 0;
  for (; i + 1 < n.count; i += 2) {
    const Truth t = test(run[i]);
    if (stopped_) return Flow::halt;
    if (t == Truth::yes) return execute(run[i + 1]);
  }
  return i < n.count ? execute(run[i]) : Flow::next;
}

Machine::Flow Machine::loop(const Node& n, NodeId id) {
  if (nodes_[n.b].op == Op::function && program_->functions[nodes_[n.b].b]->name == "range")
    return range_loop(n, nodes_[n.b]);
  Value out;
  const Value& iterable = evaluate(n.b, out);
  if (stopped_) return Flow::halt;
  const Value items = elements(context_, iterable);
  if (context_.failed) return located(id), Flow::halt;
  for (const Value& item : items.as_list()) {
    if (!assign(n.a, item)) return Flow::halt;
    const Flow flow = execute(n.c);
    if (flow == Flow::leave) break;
    if (flow == Flow::halt) return flow;
  }
  return Flow::next;
}

// OPTIMIZATION: `for i in range(...)` counts and makes no list; the list's bounds hold for it all the same.
Machine::Flow Machine::range_loop(const Node& n, const Node& range) {
  --left_;
  std::optional<Range> counted;
  {
    const Frame frame(stack_);
    if (!arguments(program_->run(range), range.count)) return Flow::halt;
    counted = range_of_arguments(context_, frame.arguments());
  }
  if (!counted) return located(n.b), Flow::halt;
  std::int64_t i = counted->start;
  for (std::uint64_t k = 0; k < counted->count; ++k, i += counted->step) {
    if (nodes_[n.a].op == Op::target_local) {
      locals_[nodes_[n.a].a] = Value(i);
    } else if (!assign(n.a, Value(i))) {
      return Flow::halt;
    }
    const Flow flow = execute(n.c);
    if (flow == Flow::leave) break;
    if (flow == Flow::halt) return flow;
  }
  return Flow::next;
}

Machine::Flow Machine::repeat(const Node& n) {
  for (;;) {
    const Truth t = test(n.a);
    if (stopped_) return Flow::halt;
    if (t != Truth::yes) return Flow::next;
    const Flow flow = execute(n.b);
    if (flow == Flow::leave) return Flow::next;
    if (flow == Flow::halt) return flow;
  }
}

// svc.S.op(arguments)
Machine::Flow Machine::call_service(const Node& n, NodeId id) {
  const ServiceCallSite& site = program_->calls[n.a];
  Value service_out;
  const Value& service = site.service == kNone ? constants_[site.service_name] : evaluate(site.service, service_out);
  if (stopped_) return Flow::halt;
  if (!service.is_string()) return fail(FaultKind::type, "the name of a service must be str", id), Flow::halt;
  const std::string& name = constants_[site.name].as_string();
  const auto argument = [&](NodeId node) {
    Value out;
    Value v = evaluate(node, out);
    if (!stopped_ && !storable(context_, v)) located(node);
    return v;
  };
  List args;
  for (const NodeId node : site.arguments) {
    args.push_back(argument(node));
    if (stopped_) return Flow::halt;
  }
  Dict kwargs;
  for (const auto& [keyword, node] : site.keywords) {
    kwargs.set(constants_[keyword], argument(node));
    if (stopped_) return Flow::halt;
  }
  const OperationId operation =
      site.service == kNone ? site.operation : environment_->services().find_operation(service.as_string(), name);
  environment_->call(operation, service.as_string(), name, std::move(args), std::move(kwargs));
  return Flow::next;
}

// Writing.

bool Machine::store(Slot slot, Value value, NodeId id) {
  if (!storable(context_, value)) return located(id), false;
  environment_->write(slot, std::move(value));
  return true;
}

bool Machine::assign(NodeId target, Value value) {
  const Node& n = nodes_[target];
  switch (n.op) {
    case Op::target_local:
      locals_[n.a] = std::move(value);
      return true;
    case Op::target_slot:
      return store(n.a, std::move(value), target);
    case Op::target_place:
      return assign_place(program_->places[n.a], std::move(value), target);
    default:
      break;
  }
  const Value items = elements(context_, value);
  if (context_.failed) return located(target), false;
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
  const Frame frame(stack_);
  if (!keys_of(place)) return false;
  Value copy;
  Value* root = root_of(place, copy, id);
  if (root == nullptr) return false;
  Value* parent = find(*root, frame.arguments().first(place.steps.size() - 1), id);
  if (parent == nullptr) return false;
  Value* where = element(context_, *parent, frame.arguments().back(), true);
  if (where == nullptr) return located(id), false;
  *where = std::move(value);
  if (!grown(context_, *parent, *where, static_cast<int>(place.steps.size()) - 1)) return located(id), false;
  return place.local || store(place.root, std::move(copy), id);
}

// local op= value, res.x op= value
Machine::Flow Machine::augment(const Node& n, NodeId id) {
  const bool local = n.op == Op::augment_local;
  if ((local ? read_local(n, id) : environment_->values[n.a]).is_unknown()) return unknown(id), Flow::halt;
  Value out;
  const Value& by = operand(n.b, out);
  if (stopped_) return Flow::halt;
  const Value& old = local ? locals_[n.a] : environment_->values[n.a];
  const auto op = static_cast<Op>(n.c);
  // OPTIMIZATION: counting.
  std::int64_t sum = 0;
  if (op == Op::add && old.is_integer() && by.is_integer() &&
      !__builtin_add_overflow(old.as_integer(), by.as_integer(), &sum)) {
    if (local) {
      locals_[n.a] = Value(sum);
    } else {
      environment_->write(n.a, Value(sum));
    }
    return Flow::next;
  }
  const Value change = by;
  Value value = local ? std::move(locals_[n.a]) : old;
  if (!augmented(op, value, change, 0)) return located(id), Flow::halt;
  if (!local) return store(n.a, std::move(value), id) ? Flow::next : Flow::halt;
  locals_[n.a] = std::move(value);
  return Flow::next;
}

// place[key]...[key] op= value
Machine::Flow Machine::augment_place(const Node& n, NodeId id) {
  const Place& place = program_->places[n.a];
  const Frame frame(stack_);
  if (!keys_of(place)) return Flow::halt;
  const auto locate = [&](Value& copy) {
    Value* root = root_of(place, copy, id);
    return root == nullptr ? nullptr : find(*root, frame.arguments().first(place.steps.size()), id);
  };
  if (Value looked; locate(looked) == nullptr)
    return Flow::halt;  // what is not there is a fault before the value is one
  Value out;
  const Value by = evaluate(n.b, out);
  if (stopped_) return Flow::halt;
  Value copy;
  Value* where = locate(copy);
  if (where == nullptr) return Flow::halt;
  if (!augmented(static_cast<Op>(n.c), *where, by, static_cast<int>(place.steps.size())))
    return located(id), Flow::halt;
  if (!place.local && !store(place.root, std::move(copy), id)) return Flow::halt;
  return Flow::next;
}

// value op= by; a list takes every iterable on `+=`. Stands `levels` deep in what it is part of.
bool Machine::augmented(Op op, Value& value, const Value& by, int levels) {
  if (op != Op::add || !value.is_list()) {
    value = arithmetic(context_, op, value, by);
    return !context_.failed;
  }
  const Value items = elements(context_, by);
  if (context_.failed) return false;
  List& list = value.mutable_list();
  list.insert(list.end(), items.as_list().begin(), items.as_list().end());
  return grown(context_, value, items, levels);
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

// What stands at the root of a place, to be changed: the local itself, or a copy of the slot's value.
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
    if (at == nullptr) return located(id), nullptr;
  }
  return at;
}

}  // namespace race::language
