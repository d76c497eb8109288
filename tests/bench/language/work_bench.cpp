// What a unit of work costs (core/language/values/work.h): each operation of the language on small and large data, in
// nanoseconds for each unit that it charges. An operation is charged right if it lies within twice the median.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "tests/unit/core/language/environment.h"
#include "tests/unit/core/language/work_cases.h"

namespace race::language::test {
namespace {

double processor_time() {  // of this thread, ns
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

struct Cost {
  double time = 0, work = 0;
};

// The least of several times.
Cost cost_of(const WorkCase& each, int repetitions) {
  const std::string before = *each.before ? std::string(each.before) + "\n" : "";
  const std::string loop =
      repetitions == 0 ? "pass" : "for r in range(" + std::to_string(repetitions) + "):\n    " + each.operation;
  Runner r(Interpreter::Limits{.steps = 4'000'000'000'000});
  const Code code = r.code(before + loop, CodeKind::function);
  Cost least{1e300, 0};
  for (int i = 0; i < 5; ++i) {
    const double begin = processor_time();
    if (r.interpreter.function(code, r.state) != Interpreter::Outcome::done)
      std::printf("%s: %s\n", each.name, r.interpreter.fault().message.c_str());
    least = {std::min(least.time, processor_time() - begin), static_cast<double>(r.interpreter.work())};
    r.state.calls.clear();
    r.state.printed.clear();
  }
  return least;
}

// Repeats the operation until it takes longer than what is before it. ns for each unit.
double nanoseconds_per_unit(const WorkCase& each) {
  const Cost before = cost_of(each, 0);
  Cost with = cost_of(each, 1);
  for (int repetitions = 4; repetitions < 200'000; repetitions *= 4) {
    if (with.time > 4 * before.time + 2e6) break;
    with = cost_of(each, repetitions);
  }
  return (with.time - before.time) / (with.work - before.work);
}

int measure_all() {
  std::vector<std::pair<double, const char*>> all;
  for (const WorkCase& each : kWorkCases) all.emplace_back(nanoseconds_per_unit(each), each.name);
  std::ranges::sort(all, {}, &std::pair<double, const char*>::first);
  const double median = all[all.size() / 2].first;
  for (const auto& [ns, name] : all) std::printf("%8.2f ns/unit  x %5.2f  %s\n", ns, ns / median, name);
  std::printf("median %.2f ns/unit, least x %.2f, greatest x %.2f, %zu operations\n", median,
              all.front().first / median, all.back().first / median, all.size());
  return 0;
}

}  // namespace
}  // namespace race::language::test

int main() { return race::language::test::measure_all(); }
