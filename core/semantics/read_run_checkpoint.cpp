// Reading the checkpoint of a run. Nothing of it is believed: what a run could not be is refused.
#include <algorithm>

#include "core/semantics/run_checkpoint_internal.h"
#include "core/semantics/run_internal.h"

namespace race::semantics {
namespace {

using Errors = std::vector<Error>;

Status read_status(Fields& fields) {
  const auto text = fields.text("status", kRequired);
  for (const Status status : {Status::running, Status::ended, Status::faulted, Status::aborted})
    if (text == name(status)) return status;
  if (text) fields.violation(ErrorCode::type, "`status` must be `running`, `ended`, `faulted` or `aborted`", "status");
  return Status::running;
}

std::optional<language::FaultKind> fault_kind(std::string_view text) {
  for (auto kind = language::FaultKind::type;; kind = static_cast<language::FaultKind>(static_cast<int>(kind) + 1)) {
    if (name(kind) == text) return kind;
    if (kind == language::FaultKind::divergence) return std::nullopt;
  }
}

SourceRange read_range(Fields& fields, Errors& errors) {
  SourceRange range;
  const List& items = fields.list("where");
  int* const places[] = {&range.line, &range.column, &range.end_line, &range.end_column};
  const auto fits = [](const Value& item) {
    return item.is_integer() && item.as_integer() >= 0 && item.as_integer() <= std::numeric_limits<int>::max();
  };
  if (items.empty()) return range;
  if (items.size() != std::size(places) || !std::ranges::all_of(items, fits)) {
    errors.push_back({ErrorCode::out_of_range, "four lines and columns", fields.path() + "/where"});
    return range;
  }
  for (std::size_t i = 0; i < items.size(); ++i) *places[i] = static_cast<int>(items[i].as_integer());
  return range;
}

std::optional<RunFault> read_fault(Fields& run, Status status, Errors& errors) {
  const Value* json = run.find("fault");
  if ((json != nullptr) != (status == Status::faulted))
    run.violation(ErrorCode::conflict, "a run that is faulted has a fault, no other has", "fault");
  if (!json) return std::nullopt;
  Fields fields(*json, run.path() + "/fault", "fault", errors, kByField);
  const auto kind = fields.text("kind", kRequired);
  RunFault fault{language::FaultKind::type, fields.text("at", kRequired).value_or(""),
                 fields.text("message", kRequired).value_or(""), read_range(fields, errors)};
  fields.close();
  if (const auto known = fault_kind(kind.value_or("")))
    fault.kind = *known;
  else if (kind)
    fields.violation(ErrorCode::type, "there is no fault `" + *kind + "`", "kind");
  return fault;
}

}  // namespace

Checked<Run> Run::read_checkpoint(std::shared_ptr<const Program> program, const Dict& arguments, Budgets budgets,
                                  const Value& json, const std::string& path) {
  auto run = create(std::move(program), arguments, budgets);
  if (!run) return tl::unexpected(Errors{std::move(run).error()});
  const Value fresh = run->checkpoint_json();
  Errors errors;
  Body& b = *run->body_;
  Fields fields(json, path, "run", errors, kByField);
  b.position = read_number(fields, "position", 0, kMostInCheckpoint - 1, kRequired);
  b.status = read_status(fields);
  b.fault = read_fault(fields, b.status, errors);
  read_run_state(fields, *b.program, b.position, b.state, errors);
  fields.close();
  if (errors.empty() && b.position > 0) check_run_state(*b.program, b.state, b.status, path, errors);
  if (errors.empty() && b.position == 0 && !(run->checkpoint_json() == fresh))
    fields.violation(ErrorCode::conflict, "a run at position 0 has not begun");
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  fill_lists(b.state, *b.program);
  if (b.status == Status::ended) run->end();
  return run.map_error([](Error error) { return Errors{std::move(error)}; });
}

}  // namespace race::semantics
