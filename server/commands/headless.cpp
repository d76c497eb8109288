#include "server/commands/headless.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "core/rcm/translate.h"
#include "server/execution/replay.h"
#include "server/execution/why.h"

namespace race::server {

using semantics::Run;
using semantics::Status;

namespace {

Value integer(std::uint64_t n) { return static_cast<std::int64_t>(n); }

Dict summary(const Run& run, Cell& cell) {
  Dict out{{"status", semantics::name(run.status())}};
  if (run.status() == Status::ended) out.set("outcome", run.outcome());
  if (run.fault()) out.set("fault", fault_json(*run.fault()));
  out.set("results", root_results(run));
  out.set("time", cell.clock().now());
  out.set("steps", integer(run.position()));
  if (const LocalWorld* world = cell.local_world()) out.set("cell", world->pose(cell.clock().now()));
  return out;
}

}  // namespace

Checked<Status> Headless::run(const rcm::Document& document, Dict arguments, const HeadlessSetup& setup,
                              const Report& report) {
  const auto fail = [](Error error) { return tl::unexpected(std::vector<Error>{std::move(error)}); };
  Headless observer(report);
  CellSetup of_cell = setup.cell;
  of_cell.own_threads = false;
  auto cell = Cell::create(of_cell, observer);
  if (!cell) return fail(std::move(cell).error());
  if (setup.script) {
    CellWorld* world = (*cell)->world();
    if (!world) return fail({ErrorCode::not_found, "an operator script needs a cell with a world", "--operator"});
    if (auto errors = check_bodies(*setup.script, *world); !errors.empty()) return tl::unexpected(std::move(errors));
    observer.operator_ = std::make_unique<Operator>(*setup.script, *setup.screens, [&](const std::string& text) {
      observer.logged((*cell)->clock().now(), "operator", text);
    });
    observer.operator_->begin();
    (*cell)->before_step([&, world] { observer.operator_->step((*cell)->clock().now(), *world); });
  }
  auto native = rcm::translate(document);
  if (!native) return tl::unexpected(std::move(native).error());
  auto program = semantics::Program::build(*native, (*cell)->host().models());
  if (!program) return tl::unexpected(std::move(program).error());
  auto run = Run::create(std::move(*program), arguments);
  if (!run) return fail(std::move(run).error());
  observer.execute(*run, **cell, setup);
  report(summary(*run, **cell));
  (*cell)->stop();
  observer.operator_.reset();
  return run->status();
}

void Headless::execute(Run& run, Cell& cell, const HeadlessSetup& setup) {
  view_.snapshot(run);
  auto next = std::chrono::steady_clock::now();
  settle(run, cell);
  while (run.status() == Status::running && cell.clock().now() < setup.limit_s) {
    if (!setup.fast) std::this_thread::sleep_until(next += std::chrono::milliseconds(1));
    cell.step();
    settle(run, cell);
  }
}

void Headless::delivered(const services::Delivery& delivery) {
  deliveries_.push_back(delivery);
  if (operator_) operator_->happened(delivery);
}

// Everything that can happen before time passes.
void Headless::settle(Run& run, Cell& cell) {
  do {
    take_deliveries(run);
    while (run.has_input()) {
      macro_step(run, cell);
      take_deliveries(run);
    }
  } while (cell.work() || !deliveries_.empty());
}

void Headless::take_deliveries(Run& run) {
  std::vector<services::Delivery> all = std::exchange(deliveries_, {});
  std::ranges::sort(all, services::before);
  for (services::Delivery& each : all) {
    if (each.kind == services::Delivery::Kind::event) {
      run.post_event(each.key, each.name, std::move(each.data));
    } else {
      run.post_response(each.caller.call, each.is_error, std::move(each.data));
    }
  }
}

void Headless::macro_step(Run& run, Cell& cell) {
  JournalEntry entry;
  std::optional<semantics::Input> input;
  if (run.position() > 0) {
    input = run.take_input();
    entry = {JournalEntry::Kind::input, *input};
  }
  List calls;
  semantics::NoRecorder none;
  run.begin(std::move(input));
  for (bool more = true; more;) {
    more = run.micro(none);
    view_.look(run);
    for (const semantics::OutgoingCall& call : run.take_calls()) {
      cell.host().call({"1", call.number}, call.service, call.name, call.args, call.kwargs);
      calls.push_back(call_json(call));
    }
    for (std::string& text : run.take_printed()) {
      if (text.ends_with('\n')) text.pop_back();
      logged(cell.clock().now(), "core", text);
    }
  }
  Dict out{{"time", cell.clock().now()}, {"step", integer(run.position())}};
  out.set("input", input_json(run.program(), entry));
  for (auto& [key, value] : view_.delta(run)) out.set(key, value);
  out.set("calls", std::move(calls));
  report_(out);
  const Dict& report = out;
  if (operator_) operator_->changed("1", report.find("active")->as_dict(), report.find("fired")->as_list());
}

void Headless::logged(services::Time time, const std::string& key, const std::string& text) {
  report_(Dict{{"time", time}, {"source", key}, {"text", text}});
}

}  // namespace race::server
