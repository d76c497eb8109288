// Evaluation of calls: functions and methods.
#include "core/language/evaluate/machine_internal.h"

namespace race::language {

// Evaluates arguments onto the stack; false if one is unknown or a fault (all are evaluated unless one is a fault).
bool Machine::arguments(const std::uint32_t* run, std::size_t count) {
  bool any_unknown = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (run[i] == kNone) {
      stack_.push_back(Value::unknown());
      continue;
    }
    Value scratch;
    const Value& v = operand(run[i], scratch);
    if (stopped_) return false;
    any_unknown = any_unknown || v.is_unknown();
    if (&v == &scratch) {
      stack_.push_back(std::move(scratch));
    } else {
      stack_.push_back(v);
    }
  }
  return !any_unknown;
}

const Value& Machine::function_call(const Node& n, NodeId id, Value& out) {
  const ArgumentScope scope(stack_);
  if (!arguments(program_->run(n), n.count)) return kUnknown;
  const Function& function = *program_->functions[n.b];
  if (!context_.charge(function.work)) return locate_fault(id);
  return checked(function.compute(context_, scope.arguments()), id, out);
}

const Value& Machine::invalid_call(const Node& n, NodeId id) {
  const ArgumentScope scope(stack_);
  if (!arguments(program_->run(n), n.count)) return kUnknown;
  return fail(FaultKind::type, constants_[n.b].as_string(), id);
}

// The method of the object's type, if it takes so many arguments.
const Method::Overload* Machine::find_overload(const Method& method, const Value& object, std::size_t given,
                                               NodeId id) {
  const Method::Overload* overload = method.overload(object.kind());
  if (overload == nullptr) {
    fail(FaultKind::type,
         "'" + std::string(type_name(object)) + "' object has no method '" + std::string(method.name) + "'", id);
    return nullptr;
  }
  if (given < overload->required || given > overload->most) {
    fail(FaultKind::type, std::string(method.name) + "() takes another number of arguments", id);
    return nullptr;
  }
  return overload;
}

// object.method(arguments) on a value that stays as it is, or on a temporary one
const Value& Machine::method_call(const Node& n, NodeId id, Value& out) {
  const ArgumentScope scope(stack_);
  const std::uint32_t* run = program_->run(n);
  Value object_out;
  const Value& object = evaluate(run[0], object_out);
  if (stopped_) return kUnknown;
  if (!arguments(run + 1, n.count - std::size_t{1}) || object.is_unknown()) return kUnknown;
  const Method& method = *program_->methods[n.b].method;
  const Method::Overload* overload = find_overload(method, object, n.count - std::size_t{1}, id);
  if (overload == nullptr) return kUnknown;
  if (overload->compute != nullptr) return checked(overload->compute(context_, object, scope.arguments()), id, out);
  Value temporary = object;
  context_.levels = 0;
  return checked(overload->mutate(context_, temporary, scope.arguments()), id, out);
}

// place.method(arguments), which mutates the value of the place
const Value& Machine::mutate(const Node& n, NodeId id, Value& out) {
  const MethodCall& call = program_->methods[n.b];
  const Place& place = program_->places[call.place];
  const ArgumentScope scope(stack_);
  if (!keys_of(place) || !arguments(program_->run(n), n.count)) return kUnknown;
  Value copy;
  Value* root = root_of(place, copy, id);
  Value* object = root == nullptr ? nullptr : find(*root, scope.arguments().first(place.steps.size()), id);
  if (object == nullptr) return kUnknown;
  const Method::Overload* overload = find_overload(*call.method, *object, n.count, id);
  if (overload == nullptr) return kUnknown;
  const Arguments arguments = scope.arguments().subspan(place.steps.size());
  if (overload->compute != nullptr) return checked(overload->compute(context_, *object, arguments), id, out);
  context_.levels = static_cast<int>(place.steps.size());
  Value result = overload->mutate(context_, *object, arguments);
  if (context_.failed) return locate_fault(id);
  if (!place.local && !store(place.root, std::move(copy), id)) return kUnknown;
  out = std::move(result);
  return out;
}

}  // namespace race::language
