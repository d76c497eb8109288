// How long conditions, expressions and functions take, with nothing around them.
#include <benchmark/benchmark.h>

#include "tests/unit/core/language/environment.h"

namespace race::language::test {
namespace {

void prepare(State& state) {
  const auto payload = parse_json(R"({"x": 5, "value": 2.5, "pose": [1.0, 2.0, 3.0]})");
  Value data = *payload;
  state.deliver(0, data.freeze());
  state.set(State::par_a, Value(List{1, 2, 3}));
  state.set(State::res_x, Value(0.0));
  state.set(State::var_n, Value(0));
}

void condition(benchmark::State& run, const char* text) {
  Runner runner;
  prepare(runner.state);
  const Code code = runner.code(text, CodeKind::condition);
  for (auto _ : run) benchmark::DoNotOptimize(runner.interpreter.condition(code, runner.state));
}

void function(benchmark::State& run, const char* text) {
  Runner runner;
  prepare(runner.state);
  const Code code = runner.code(text, CodeKind::function);
  for (auto _ : run) benchmark::DoNotOptimize(runner.interpreter.function(code, runner.state));
}

BENCHMARK_CAPTURE(condition, presence, "svc.t.data");
BENCHMARK_CAPTURE(condition, guard_on_payload, "svc.t.data.x > 3");
BENCHMARK_CAPTURE(condition, guard_on_second_field, "svc.t.data.value > 3");
BENCHMARK_CAPTURE(condition, result, "res.x > 3");
BENCHMARK_CAPTURE(condition, junction, "res.x < 3 and var.n >= 0 and not chi.C");
BENCHMARK_CAPTURE(condition, missing, "res.unset > 3");
BENCHMARK_CAPTURE(function, add_payload, "res.x = res.x + svc.t.data.value");
BENCHMARK_CAPTURE(function, count, "var.n += 1");
BENCHMARK_CAPTURE(function, call_builtin, "var.n = abs(var.n)");
BENCHMARK_CAPTURE(function, pose, "res.out = [svc.t.data.pose[0], svc.t.data.pose[1], svc.t.data.pose[2] + 0.02]");
BENCHMARK_CAPTURE(function, loop_of_1000, "s = 0\nfor i in range(1000):\n    s += i\nvar.n = s");
BENCHMARK_CAPTURE(
    function, haptic_gesture,
    "f = svc.t.data.pose\nm = 0\nfor i in range(len(f)):\n    if abs(f[i]) > m:\n        m = abs(f[i])\nres.out = m");

}  // namespace
}  // namespace race::language::test
