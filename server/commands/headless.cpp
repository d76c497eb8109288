#include "server/commands/headless.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "core/execution/step_json.h"
#include "core/rcm/translate.h"
#include "server/execution/outgoing_calls.h"

namespace race::server {

using execution::Execution;
using execution::Progress;
using semantics::Run;
using semantics::Status;

namespace {

Value integer(std::uint64_t n) { return static_cast<std::int64_t>(n); }

Dict summary(const Run& run, Cell& cell) {
  Dict out;
  execution::set_status(run, out);
  out.set("results", execution::root_results(run));
  out.set("time", cell.clock().now());
  out.set("steps", integer(run.position()));
  if (const LocalWorld* world = cell.local_world()) out.set("cell", world->pose(cell.clock().now()));
  return out;
}

}  // namespace

tl::expected<Status, FileErrors> Headless::run(const rcm::Document& document, Dict arguments,
                                               const HeadlessSetup& setup, const Report& report) {
  const auto fail = [](Error error) { return tl::unexpected(FileErrors{"", {std::move(error)}}); };
  const auto fail_in = [](const std::string& file, std::vector<Error> errors) {
    return tl::unexpected(FileErrors{file, std::move(errors)});
  };
  Headless observer(report, setup);
  CellSetup of_cell = setup.cell;
  of_cell.own_threads = false;
  auto cell = Cell::create(of_cell, observer);
  if (!cell) return fail_in("", std::move(cell).error());
  if (setup.script) {
    CellWorld* world = (*cell)->world();
    if (!world) return fail({ErrorCode::not_found, "an operator script needs a cell with a world", "--operator"});
    if (auto errors = check_bodies(*setup.script, *world); !errors.empty())
      return fail_in(setup.script_file, std::move(errors));
    observer.operator_ = std::make_unique<Operator>(*setup.script, *setup.screens, [&](const std::string& text) {
      observer.logged((*cell)->clock().now(), "operator", text);
    });
    observer.operator_->begin();
    (*cell)->before_step([&, world] { observer.operator_->step((*cell)->clock().now(), *world); });
  }
  auto native = rcm::translate(document);
  if (!native) return fail_in(setup.model_file, std::move(native).error());
  auto program = semantics::Program::build(*native, (*cell)->host().models());
  if (!program) return fail_in(setup.model_file, std::move(program).error());
  auto execution = Execution::create(std::move(*program), arguments);
  if (!execution) return fail(std::move(execution).error());
  observer.execute(*execution, **cell, setup);
  report(summary(execution->run(), **cell));
  (*cell)->stop();
  observer.operator_.reset();
  return execution->run().status();
}

void Headless::execute(Execution& execution, Cell& cell, const HeadlessSetup& setup) {
  execution.watch();
  auto next = std::chrono::steady_clock::now();
  settle(execution, cell);
  while (!execution.is_over() && cell.clock().now() < setup.limit_s) {
    if (!setup.fast) std::this_thread::sleep_until(next += std::chrono::milliseconds(1));
    cell.step();
    settle(execution, cell);
  }
}

void Headless::delivered(const services::Delivery& delivery) {
  deliveries_.push_back(delivery);
  if (operator_) operator_->happened(delivery);
}

// Everything that can happen before time passes.
void Headless::settle(Execution& execution, Cell& cell) {
  do {
    take_deliveries(execution);
    if (execution.run().position() == 0) {
      finish_step(execution, execution.start({}, first_part()), cell);
      take_deliveries(execution);
    }
    while (execution.has_input()) {
      finish_step(execution, execution.step({}, first_part()), cell);
      take_deliveries(execution);
    }
  } while (cell.work() || !deliveries_.empty());
}

void Headless::take_deliveries(Execution& execution) {
  std::vector<services::Delivery> all = std::exchange(deliveries_, {});
  std::ranges::sort(all, services::before);
  for (services::Delivery& each : all) {
    if (each.kind == services::Delivery::Kind::event) {
      execution.post_event(each.key, each.name, std::move(each.data));
    } else {
      execution.post_response(each.caller.call, each.is_error, std::move(each.data));
    }
  }
}

// The rest of a macro step that has begun, micro step by micro step if somebody looks.
void Headless::finish_step(Execution& execution, const Progress& first, Cell& cell) {
  for (const Progress* part = &first;; part = &execution.continue_step(1)) {
    complete(execution, *part, cell);
    if (look_) look_(execution);
    if (part->complete) return;
  }
}

// What came of a macro step, or of a part of one, leaves.
void Headless::complete(const Execution& execution, const Progress& progress, Cell& cell) {
  for (const std::string& text : progress.printed) logged(cell.clock().now(), "core", text);
  make_calls(cell.host(), "1", 0, progress.calls, execution.is_over());
  Dict out{{"time", cell.clock().now()}, {"step", integer(progress.position)}};
  if (progress.begins && progress.entry) out.set("input", input_json(*progress.entry));
  for (const auto& [key, value] : progress.delta) out.set(key, value);
  out.set("calls", execution::calls_json(progress.calls));
  report_(out);
  if (operator_)
    operator_->changed("1", progress.delta.find("active")->as_dict(), progress.delta.find("fired")->as_list());
}

void Headless::logged(services::Time time, const std::string& key, const std::string& text) {
  report_(Dict{{"time", time}, {"source", key}, {"text", text}});
}

}  // namespace race::server
