// Reading journals: the header, which gives the program, then the entries against it.
#include <limits>
#include <optional>
#include <utility>

#include "core/execution/executed_model.h"
#include "core/execution/input_fields.h"
#include "core/execution/journal.h"
#include "core/value/error_list.h"
#include "core/value/fields.h"

namespace race::execution {
namespace {

using semantics::Program;
using Errors = std::vector<Error>;

void wrong_type(Fields& fields, std::string_view key, std::string_view expected, const Value& value) {
  fields.violation(
      ErrorCode::type,
      "`" + std::string(key) + "` must be " + std::string(expected) + ", got " + std::string(kind_name(value)), key);
}

/// A whole number from 1 to `most`; nothing (a violation) if it is absent or another.
std::optional<std::uint64_t> read_count(Fields& fields, std::string_view key,
                                        std::int64_t most = std::numeric_limits<std::int64_t>::max()) {
  const auto number = fields.integer(key, 1, most, kRequired);
  return number ? std::optional(static_cast<std::uint64_t>(*number)) : std::nullopt;
}

// ---- The header.

Interfaces read_services(Fields& header, Errors& errors) {
  const Value* json = header.find("services", kRequired);
  if (json && !json->is_dict()) wrong_type(header, "services", "an object", *json);
  return json && json->is_dict() ? read_interfaces(json->as_dict(), "header/services", errors) : Interfaces();
}

semantics::Budgets read_budgets(Fields& header, Errors& errors) {
  semantics::Budgets budgets;
  const Value* json = header.find("budgets", kRequired);
  if (!json) return budgets;
  Fields fields(*json, "header/budgets", "budgets", errors, kByField);
  const auto steps = read_count(fields, "steps"), units = read_count(fields, "value_units"),
             micro_steps = read_count(fields, "micro_steps", std::numeric_limits<std::uint32_t>::max());
  // A header of an earlier version has none of these: the run has those of this version.
  budgets.is_earlier = !fields.find("work");
  if (!budgets.is_earlier) {
    budgets.work = read_count(fields, "work").value_or(0);
    budgets.calls = read_count(fields, "calls").value_or(0);
    budgets.output_units = read_count(fields, "output_units").value_or(0);
    budgets.data_units = read_count(fields, "data_units").value_or(0);
  }
  fields.close();
  budgets.evaluation = {steps.value_or(0), units.value_or(0)};
  budgets.micro_steps = static_cast<std::uint32_t>(micro_steps.value_or(0));
  return budgets;
}

/// Of another version, only that is said: what else would have to be there is not known.
bool is_of_this_version(const Value& header) {
  const Value* version = header.find("semantics");
  return !version || *version == Value(kSemanticsVersion);
}

// Without a program if there are violations.
JournalHeader read_header_at(const Value& json, Errors& errors) {
  JournalHeader header;
  Fields fields(json, "header", "header", errors, kByField);
  if (!is_of_this_version(json)) {
    fields.violation(ErrorCode::version, "`semantics` must be \"" + std::string(kSemanticsVersion) + "\"", "semantics");
    return header;
  }
  fields.find("semantics", kRequired);
  if (const Value* native = fields.find("native", kRequired)) header.native = *native;
  const Interfaces services = read_services(fields, errors);
  header.budgets = read_budgets(fields, errors);
  const auto arguments = read_data(fields, "arguments");
  if (arguments && !arguments->is_dict()) wrong_type(fields, "arguments", "an object", *arguments);
  fields.close();
  if (!errors.empty()) return header;
  header.arguments = arguments->as_dict();
  auto model = build_model(header.native, services, "header/native");
  if (!model) {
    append_below(errors, std::move(model).error(), "");
    return header;
  }
  append_below(errors, semantics::check_arguments(*model->program, header.arguments), "header");
  header.native = std::move(model->native);
  header.program = std::move(model->program);
  return header;
}

// ---- The entries.

void unknown_name(Fields& fields, const std::string& what, const std::string& service, const std::string& name,
                  std::string_view key) {
  fields.violation(ErrorCode::unknown_name, "the model reads no " + what + " `" + service + "." + name + "`", key);
}

JournalEntry read_event(Fields& fields, const Program* program) {
  const auto service = fields.text("service", kRequired), event = fields.text("event", kRequired);
  EventEntry entry{service.value_or(""), event.value_or(""), read_data(fields, "data").value_or(Value())};
  if (program && service && event && !program->names_event(program->services.find_event(*service, *event)))
    unknown_name(fields, "event", *service, *event, "event");
  return entry;
}

JournalEntry read_response(Fields& fields, const Program* program) {
  ResponseEntry entry;
  entry.call = read_count(fields, "call").value_or(0);
  const auto service = fields.text("service", kRequired), operation = fields.text("operation", kRequired);
  entry.is_error = fields.find("error") != nullptr;
  if (entry.is_error == (fields.find("result") != nullptr)) {
    fields.violation(ErrorCode::missing, "a response has either a result or an error");
  } else {
    entry.data = read_data(fields, entry.is_error ? "error" : "result").value_or(Value());
  }
  entry.service = service.value_or("");
  entry.operation = operation.value_or("");
  if (program && service && operation &&
      !program->names_response(program->services.dynamic_operation(*service, *operation)))
    unknown_name(fields, "response of", *service, *operation, "operation");
  return entry;
}

/// An object, if it is there; else empty.
Dict read_object(Fields& fields, std::string_view key) {
  const auto json = fields.find(key) ? read_data(fields, key) : std::nullopt;
  if (json && !json->is_dict()) wrong_type(fields, key, "an object", *json);
  return json && json->is_dict() ? json->as_dict() : Dict();
}

JournalEntry read_edit_entry(Fields& fields, Errors& errors) {
  EditEntry entry;
  if (const Value* json = fields.find("edit", kRequired)) {
    if (auto edit = edit::read_edit(*json))
      entry.edit = std::move(*edit);
    else
      append_below(errors, std::move(edit).error(), fields.path() + "/edit");
  }
  entry.revision = fields.integer("revision", 1, std::numeric_limits<std::int64_t>::max()).value_or(0);
  entry.origin = read_object(fields, "origin");
  entry.services = read_object(fields, "services");
  for (const auto& [path, from] : entry.origin)
    if (!from.is_string() && !from.is_null())
      add_error(errors, {ErrorCode::type, "an origin must be a string or null, got " + std::string(kind_name(from)),
                         fields.path() + "/origin/" + path.as_string()});
  read_interfaces(entry.services, fields.path() + "/services", errors);
  return entry;
}

JournalEntry read_force_entry(Fields& fields, Errors& errors) {
  const Value* json = fields.find("force", kRequired);
  if (!json) return ForceEntry{};
  Fields force(*json, fields.path() + "/force", "force", errors, kByField);
  ForceEntry entry{read_force(force)};
  force.close();
  return entry;
}

/// What may stand at a place of the journal: it begins with the start, unless the run was aborted before; nothing
/// follows an abort.
void check_order(Fields& fields, const std::string& kind, const JournalEntry* before) {
  const bool aborted = before && std::holds_alternative<AbortEntry>(*before);
  if (aborted) return fields.violation(ErrorCode::type, "nothing follows an abort", "kind");
  if (!before && kind != "start" && kind != "abort")
    return fields.violation(ErrorCode::type, "the first input is the start", "kind");
  if (before && kind == "start") fields.violation(ErrorCode::type, "only the first input is the start", "kind");
}

JournalEntry read_input_at(const Value& json, const std::string& path, const JournalEntry* before,
                           const Program* program, Errors& errors) {
  Fields fields(json, path, "input", errors, kByField);
  const auto kind = fields.text("kind", kRequired);
  if (!kind) return {};
  check_order(fields, *kind, before);
  JournalEntry entry = StartEntry{};
  if (*kind == "event")
    entry = read_event(fields, program);
  else if (*kind == "response")
    entry = read_response(fields, program);
  else if (*kind == "edit")
    entry = read_edit_entry(fields, errors);
  else if (*kind == "force")
    entry = read_force_entry(fields, errors);
  else if (*kind == "abort")
    entry = AbortEntry{};
  else if (*kind != "start")
    fields.violation(ErrorCode::type, "`kind` must be `start`, `event`, `response`, `edit`, `force` or `abort`",
                     "kind");
  fields.close();
  return entry;
}

// `program`: of the header; null once the model has been edited.
void read_entry(const Value& json, Journal& journal, const Program* program, Errors& errors) {
  const std::string path = "entries/" + std::to_string(journal.entries.size());
  const std::size_t position = journal.entries.size() + 1;
  Fields fields(json, path, "entry", errors, kByField);
  const auto found = read_count(fields, "position");
  if (found && *found != position)
    fields.violation(ErrorCode::out_of_range, "`position` must be " + std::to_string(position), "position");
  const Value* input = fields.find("input", kRequired);
  fields.close();
  if (!input) return;
  const JournalEntry* before = journal.entries.empty() ? nullptr : &journal.entries.back();
  JournalEntry entry = read_input_at(*input, path + "/input", before, program, errors);
  journal.entries.push_back(std::move(entry));
}

}  // namespace

Checked<JournalHeader> read_header(const Value& json) {
  Errors errors;
  JournalHeader header = read_header_at(json, errors);
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return header;
}

Checked<JournalEntry> read_input(const Value& json, const JournalEntry* before) {
  Errors errors;
  JournalEntry entry = read_input_at(json, "input", before, nullptr, errors);
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return entry;
}

Checked<Journal> read_journal(const Value& json) {
  Errors errors;
  Journal journal;
  Fields fields(json, "", "journal", errors, kByField);
  const Value* header = fields.find("header", kRequired);
  const List& entries = fields.list("entries", kRequired);
  fields.close();
  if (header) journal.header = read_header_at(*header, errors);
  const Program* program = journal.header.program.get();
  for (auto entry = entries.begin(); entry != entries.end() && errors.empty(); ++entry) {
    read_entry(*entry, journal, program, errors);
    if (!journal.entries.empty() && std::holds_alternative<EditEntry>(journal.entries.back())) program = nullptr;
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return journal;
}

}  // namespace race::execution
