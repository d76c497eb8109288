// Code: any text is refused with a reason, or compiles and runs within its budget; what it leaves is within the limits
// of values, and reads back as it is printed.
#include <initializer_list>

#include "core/language/evaluate/explain.h"
#include "core/language/values/printing.h"
#include "core/language/values/values.h"
#include "tests/fuzz/support/expect.h"
#include "tests/fuzz/support/input.h"
#include "tests/unit/core/language/environment.h"

namespace race::language {
namespace {

using test::Runner;
using test::State;

constexpr Interpreter::Limits kLimits = {.steps = 2000, .value_units = 10'000};

void hold_value(const Value& value) {
  if (value.is_unknown()) return;
  const Measure size = measure(value, kLimits.value_units);
  FUZZ_EXPECT(size.units <= kLimits.value_units);
  FUZZ_EXPECT(size.depth <= kMaxValueDepth);
  FUZZ_EXPECT(size.finite);
  const std::string printed = repr(value);
  Runner runner;
  const Code code = runner.code(printed, CodeKind::expression);
  if (!code) return;  // longer than a text may be
  const auto again = runner.interpreter.expression(code, runner.state);
  FUZZ_EXPECT(again && repr(*again) == printed);
}

void run(const Code& code, CodeKind kind, Runner& runner) {
  if (kind == CodeKind::function) {
    runner.interpreter.function(code, runner.state);
    for (const ValueIndex slot :
         std::initializer_list<ValueIndex>{State::res_out, State::res_x, State::var_n, State::var_log})
      hold_value(runner.state.at(slot));
  } else if (kind == CodeKind::expression) {
    runner.interpreter.expression(code, runner.state);
  } else {
    runner.interpreter.condition(code, runner.state);
    explain(code, runner.state);
  }
}

void hold(std::string_view text, CodeKind kind) {
  Runner runner(kLimits);
  State& state = runner.state;
  state.set(State::par_a, Value(List{1, "a"}));
  state.set(State::res_x, Value(1));
  state.set(State::var_n, Value(Dict{{"k", Value(2)}}));
  state.deliver(0, Value(Dict{{"x", Value(1.5)}}));
  for (const std::string& name : variable_names(text)) state.symbols.variables.emplace(name, State::var_log);
  const auto errors = check(text, kind, state.symbols);
  const auto code = compile(text, kind, state.symbols, state.table);
  FUZZ_EXPECT(errors.empty() == code.has_value());
  if (code) run(*code, kind, runner);
}

}  // namespace
}  // namespace race::language

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using race::language::CodeKind;
  const std::string_view text = race::fuzz::text_of(data, size);
  for (const CodeKind kind : {CodeKind::condition, CodeKind::expression, CodeKind::function})
    race::language::hold(text, kind);
  return 0;
}
