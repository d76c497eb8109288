// Execution of statements: assignments, control flow, calls of operations.
#include <cmath>

#include "core/language/evaluate/machine_internal.h"
#include "core/language/values/work.h"

namespace race::language {

Machine::Flow Machine::execute(NodeId id) {
  const Node& n = nodes_[id];
  if (!take_unit()) {
    fail_over_budget(id);
    return Flow::halt;
  }
  switch (n.op) {
    case Opcode::block:
      return block(n);
    case Opcode::evaluate: {
      Value out;
      evaluate(n.a, out);
      return stopped_ ? Flow::halt : Flow::next;
    }
    case Opcode::assign_local: {
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
    case Opcode::assign_slot: {
      Value out;
      const Value& v = operand(n.a, out);
      if (stopped_) return Flow::halt;
      return store(n.b, &v == &out ? std::move(out) : v, id) ? Flow::next : Flow::halt;
    }
    case Opcode::assign: {
      Value out;
      const Value v = evaluate(n.b, out);
      if (stopped_) return Flow::halt;
      for (std::size_t i = 0; i < n.count; ++i)
        if (!assign(program_->run(n)[i], v)) return Flow::halt;
      return Flow::next;
    }
    case Opcode::augment_local:
    case Opcode::augment_slot:
      return augment(n, id);
    case Opcode::augment_place:
      return augment_place(n, id);
    case Opcode::branch:
      return branch(n);
    case Opcode::for_loop:
      return for_loop(n, id);
    case Opcode::while_loop:
      return while_loop(n);
    case Opcode::break_loop:
      return Flow::break_loop;
    case Opcode::continue_loop:
      return Flow::continue_loop;
    case Opcode::call_service:
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
    if (top && s.op != Opcode::call_service) environment_->trace->statement(s.service, program_->range(statements[i]));
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

Machine::Flow Machine::for_loop(const Node& n, NodeId id) {
  if (nodes_[n.b].op == Opcode::function && program_->functions[nodes_[n.b].b]->name == "range")
    return for_range(n, nodes_[n.b]);
  Value out;
  const Value& iterable = evaluate(n.b, out);
  if (stopped_) return Flow::halt;
  const Value items = elements(context_, iterable);
  if (context_.failed) return locate_fault(id), Flow::halt;
  for (const Value& item : items.as_list()) {
    if (!assign(n.a, item)) return Flow::halt;
    const Flow flow = execute(n.c);
    if (flow == Flow::break_loop) break;
    if (flow == Flow::halt) return flow;
  }
  return Flow::next;
}

// OPTIMIZATION: `for i in range(...)` counts without a list; the limits of a list apply all the same.
Machine::Flow Machine::for_range(const Node& n, const Node& range) {
  --context_.left;
  std::optional<Range> counted;
  {
    const ArgumentScope scope(stack_);
    if (!arguments(program_->run(range), range.count)) return Flow::halt;
    counted = range_of_arguments(context_, scope.arguments());
  }
  if (!counted) return locate_fault(n.b), Flow::halt;
  std::int64_t i = counted->start;
  for (std::uint64_t k = 0; k < counted->count; ++k, i += counted->step) {
    if (nodes_[n.a].op == Opcode::target_local) {
      locals_[nodes_[n.a].a] = Value(i);
    } else if (!assign(n.a, Value(i))) {
      return Flow::halt;
    }
    const Flow flow = execute(n.c);
    if (flow == Flow::break_loop) break;
    if (flow == Flow::halt) return flow;
  }
  return Flow::next;
}

Machine::Flow Machine::while_loop(const Node& n) {
  for (;;) {
    const Truth t = test(n.a);
    if (stopped_) return Flow::halt;
    if (t != Truth::yes) return Flow::next;
    const Flow flow = execute(n.b);
    if (flow == Flow::break_loop) return Flow::next;
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
  if (!context_.charge(2 * work::made(1))) return locate_fault(id), Flow::halt;
  const std::string& name = constants_[site.name].as_string();
  const auto argument = [&](NodeId node) {
    Value out;
    Value v = evaluate(node, out);
    if (!stopped_ && !check_storable(context_, v)) locate_fault(node);
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
      site.service == kNone ? site.operation : environment_->services().dynamic_operation(service.as_string(), name);
  environment_->call(operation, service.as_string(), name, std::move(args), std::move(kwargs));
  return Flow::next;
}

}  // namespace race::language
