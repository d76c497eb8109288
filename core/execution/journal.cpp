#include "core/execution/journal.h"

#include <utility>

#include "core/execution/executed_model.h"

namespace race::execution {
namespace {

Value integer(std::uint64_t n) { return static_cast<std::int64_t>(n); }

Dict event_json(const EventEntry& entry) {
  return {{"service", entry.service}, {"event", entry.event}, {"data", entry.data}};
}

Dict response_json(const ResponseEntry& entry) {
  return {{"service", entry.service},
          {"operation", entry.operation},
          {"call", integer(entry.call)},
          {entry.is_error ? "error" : "result", entry.data}};
}

Dict edit_json(const EditEntry& entry) {
  Dict json{{"kind", "edit"}};
  if (entry.revision > 0) json.set("revision", entry.revision);
  json.set("edit", edit::write_edit(entry.edit));
  if (!entry.origin.empty()) json.set("origin", entry.origin);
  if (!entry.services.empty()) json.set("services", entry.services);
  return json;
}

Dict force_json(const semantics::Force& force) {
  Dict json{{"path", force.path}, {"scope", name(force.scope)}, {"name", force.name}};
  if (!force.value.is_unknown()) json.set("value", force.value);
  return json;
}

struct InputWriter {
  Dict operator()(const StartEntry&) const { return {{"kind", "start"}}; }
  Dict operator()(const EventEntry& entry) const { return with_kind("event", event_json(entry)); }
  Dict operator()(const ResponseEntry& entry) const { return with_kind("response", response_json(entry)); }
  Dict operator()(const EditEntry& entry) const { return edit_json(entry); }
  Dict operator()(const ForceEntry& entry) const { return {{"kind", "force"}, {"force", force_json(entry.force)}}; }
  Dict operator()(const AbortEntry&) const { return {{"kind", "abort"}}; }

  static Dict with_kind(const char* kind, const Dict& rest) {
    Dict json{{"kind", kind}};
    for (const auto& [key, value] : rest) json.set(key, value);
    return json;
  }
};

Dict budgets_json(const semantics::Budgets& budgets) {
  Dict json{{"steps", integer(budgets.evaluation.steps)},
            {"value_units", integer(budgets.evaluation.value_units)},
            {"micro_steps", integer(budgets.micro_steps)}};
  if (budgets.is_earlier) return json;
  json.set("work", integer(budgets.work));
  json.set("calls", integer(budgets.calls));
  json.set("output_units", integer(budgets.output_units));
  json.set("data_units", integer(budgets.data_units));
  return json;
}

Dict script_step(const JournalEntry& entry) {
  if (const auto* event = std::get_if<EventEntry>(&entry)) return {{"events", List{event_json(*event)}}};
  if (const auto* response = std::get_if<ResponseEntry>(&entry)) return {{"responses", List{response_json(*response)}}};
  if (const auto* edit = std::get_if<EditEntry>(&entry)) return {{"edit", edit::write_edit(edit->edit)}};
  if (const auto* forced = std::get_if<ForceEntry>(&entry)) return {{"force", force_json(forced->force)}};
  return {};
}

}  // namespace

Value header_json(const JournalHeader& header) {
  return Dict{{"native", header.native},
              {"arguments", header.arguments},
              {"services", interfaces_json(*header.program)},
              {"semantics", kSemanticsVersion},
              {"budgets", budgets_json(header.budgets)}};
}

Value input_json(const JournalEntry& entry) { return std::visit(InputWriter{}, entry); }

Value journal_json(const Journal& journal) {
  List entries;
  for (const JournalEntry& entry : journal.entries)
    entries.emplace_back(Dict{{"position", integer(entries.size() + 1)}, {"input", input_json(entry)}});
  return Dict{{"header", header_json(journal.header)}, {"entries", std::move(entries)}};
}

// A script has no services that come with an edit: all are there from the beginning.
Value script_json(const Journal& journal) {
  List steps;
  Dict services = interfaces_json(*journal.header.program);
  for (const JournalEntry& entry : journal.entries) {
    if (std::holds_alternative<AbortEntry>(entry)) break;  // no step of a script
    steps.emplace_back(script_step(entry));
    if (const auto* edit = std::get_if<EditEntry>(&entry))
      for (const auto& [key, service] : edit->services) services.set(key, service);
  }
  return Dict{{"arguments", journal.header.arguments},
              {"services", std::move(services)},
              {"closed", true},
              {"steps", std::move(steps)}};
}

}  // namespace race::execution
