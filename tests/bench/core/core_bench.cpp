// What one event costs, in nanoseconds of CPU time: an execution that records nothing, one that makes the entries of a
// journal, a run with the names of the applied rules, and an execution with whole trees, beside a minimal table-driven
// machine doing the same work in the same run. Each figure is the median of interleaved rounds. Usage: core_bench
// [rounds [part of a name [off]]]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "core/execution/execution.h"
#include "tests/bench/core/models.h"
#include "tests/bench/core/table_machine.h"
#include "tests/unit/core/semantics/driven_run.h"

namespace race::bench {
namespace {

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// The payloads are made beforehand: producing them is the service's work.
std::vector<Value> payloads() {
  std::vector<Value> out;
  for (int i = 0; i < 64; ++i) out.emplace_back(Dict{{"x", Value(i % 7 + 1)}});
  return out;
}

class CoreLoad {
 public:
  explicit CoreLoad(rcm::State root) {
    rsm::Service service;
    service.name = "t";
    rsm::Event event;
    event.name = "ev";
    service.events.push_back(event);
    auto program = semantics::Program::build({std::move(root), {}}, {{"t", service}});
    if (!program) std::abort();
    event_ = (*program)->services.find_event("t", "ev");
    execution_ = std::make_unique<execution::Execution>(*execution::Execution::create(*program, {}));
    execution_->start({.entry = false});
    run_ = std::make_unique<semantics::DrivenRun>(*semantics::Run::create(*program, {}));
    semantics::NoRecorder none;
    run_->macro_step(none);
  }

  double nanoseconds(int events, execution::Recording recording) {
    const double start = cpu_seconds();
    for (int i = 0; i < events; ++i) {
      execution_->post_event(event_, payload(i));
      execution_->step(recording);
    }
    if (execution_->is_over()) std::abort();
    return (cpu_seconds() - start) * 1e9 / events;
  }

  // Of the run itself: nobody is given the names of the rules in operation.
  double name_nanoseconds(int events) {
    semantics::NameRecorder recorder;
    const double start = cpu_seconds();
    for (int i = 0; i < events; ++i) {
      recorder.names.clear();
      recorder.micro.clear();
      run_->post_event(event_, payload(i));
      run_->macro_step(recorder);
    }
    return (cpu_seconds() - start) * 1e9 / events;
  }

 private:
  const Value& payload(int i) const { return payloads_[static_cast<std::size_t>(i & 63)]; }

  std::vector<Value> payloads_ = payloads();
  std::unique_ptr<execution::Execution> execution_;
  std::unique_ptr<semantics::DrivenRun> run_;
  semantics::EventId event_ = 0;
};

template <typename Machine>
double table_nanoseconds(Machine machine, int events, double (*check)(const Machine&)) {
  const double start = cpu_seconds();
  for (int i = 0; i < events; ++i) {
    machine.event(static_cast<double>(i % 7 + 1));
    asm volatile("" : : "r"(&machine) : "memory");  // each event is worked on by itself
  }
  const double used = cpu_seconds() - start;
  if (check(machine) < -1) std::abort();
  return used * 1e9 / events;
}

double median(std::vector<double> v) {
  std::ranges::sort(v);
  return v[v.size() / 2];
}

struct Workload {
  std::string name;
  rcm::State model;
  int events;
  std::function<double(int)> table;
};

}  // namespace
}  // namespace race::bench

int main(int argc, char** argv) {
  using namespace race::bench;
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 7;
  const auto machine = [](TableMachine m) {
    return [m](int events) {
      return table_nanoseconds<TableMachine>(m, events, [](const TableMachine& t) { return double(t.state()); });
    };
  };
  const auto sum_machine = [](int events) {
    return table_nanoseconds<TableSum>({}, events, [](const TableSum& t) { return t.sum(); });
  };
  const std::vector<Workload> loads = {
      {"toggle", ring(2), 400000, machine(TableMachine::ring(2))},
      {"toggle under 10 ancestors", deep(10), 100000, machine(TableMachine::deep(10))},
      {"toggle under 50 ancestors", deep(50), 30000, machine(TableMachine::deep(50))},
      {"ring of 10", ring(10), 400000, machine(TableMachine::ring(10))},
      {"ring of 100", ring(100), 400000, machine(TableMachine::ring(100))},
      {"ring of 1000", ring(1000), 400000, machine(TableMachine::ring(1000))},
      {"10 concurrent", concurrent(10), 40000, machine(TableMachine::concurrent(10))},
      {"100 concurrent", concurrent(100), 4000, machine(TableMachine::concurrent(100))},
      {"payload and guard", sum(), 400000, sum_machine},
  };
  std::printf("ns of CPU per event, median of %d interleaved rounds\n", rounds);
  std::printf("%-28s %9s %9s %9s %9s %9s %9s %9s\n", "work", "off", "entry", "names", "tree", "tree/off", "table",
              "off/table");
  for (const Workload& load : loads) {
    if (argc > 2 && load.name.find(argv[2]) == std::string::npos) continue;
    CoreLoad core(load.model);
    std::vector<double> off, entry, names, tree, table;
    for (int i = 0; i < rounds; ++i) {
      off.push_back(core.nanoseconds(load.events, {.entry = false}));
      if (argc > 3) continue;
      names.push_back(core.name_nanoseconds(load.events / 4));
      entry.push_back(core.nanoseconds(load.events / 4, {.entry = true}));
      tree.push_back(core.nanoseconds(load.events / 4, {.entry = false, .derivation = true}));
      table.push_back(load.table(load.events));
    }
    if (argc > 3) {
      std::printf("%-28s %9.0f\n", load.name.c_str(), median(off));
      continue;
    }
    std::printf("%-28s %9.0f %9.0f %9.0f %9.0f %9.1f %9.1f %9.1f\n", load.name.c_str(), median(off), median(entry),
                median(names), median(tree), median(tree) / median(off), median(table), median(off) / median(table));
  }
}
