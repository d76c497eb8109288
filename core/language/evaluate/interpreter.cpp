#include "core/language/evaluate/interpreter.h"

#include "core/language/evaluate/comparison_internal.h"
#include "core/language/evaluate/machine_internal.h"

namespace race::language {

Interpreter::Interpreter() : Interpreter(Limits()) {}
Interpreter::Interpreter(Limits limits) : state_(std::make_unique<State>(limits)) {}
void Interpreter::set_limits(Limits limits) { state_ = std::make_unique<State>(limits); }
Interpreter::~Interpreter() = default;

Truth Interpreter::condition(const Code& code, Environment& environment) {
  const Program& program = code.program();
  if (program.comparison.datum != Opcode::pass && environment.trace == nullptr && state_->steps >= Comparison::kUnits)
    if (const auto truth = decide(program, environment)) return *truth;
  return state_->machine.condition(program, environment);
}
std::optional<Value> Interpreter::expression(const Code& code, Environment& environment) {
  return state_->machine.expression(code.program(), environment);
}
Interpreter::Outcome Interpreter::function(const Code& code, Environment& environment) {
  return state_->machine.function(code.program(), environment);
}
std::uint64_t Interpreter::work() const { return state_->machine.work(); }
const Fault& Interpreter::fault() const { return state_->machine.fault(); }

}  // namespace race::language
