#include "core/execution/journal.h"

#include <utility>

namespace race::execution {
namespace {

Value integer(std::uint64_t n) { return static_cast<std::int64_t>(n); }

// The services as they had described themselves when the program was compiled.
Value services_json(const semantics::Program& program) {
  const language::ServiceTable& table = program.services;
  Dict services;
  for (const std::string& key : table.declared_services()) {
    List operations, events;
    for (const auto& operation : table.operations())
      if (operation.declared && operation.service == key) {
        Dict each{{"name", operation.name}};
        if (operation.safe) each.set("safe", true);
        operations.emplace_back(std::move(each));
      }
    for (const auto& event : table.events())
      if (event.declared && event.service == key) {
        Dict each{{"name", event.name}};
        if (event.sampled) each.set("sampled", true);
        events.emplace_back(std::move(each));
      }
    services.set(key, Dict{{"operations", std::move(operations)}, {"events", std::move(events)}});
  }
  return services;
}

Dict event_json(const EventEntry& entry) {
  return {{"service", entry.service}, {"event", entry.event}, {"data", entry.data}};
}

Dict response_json(const ResponseEntry& entry) {
  return {{"service", entry.service},
          {"operation", entry.operation},
          {"call", integer(entry.call)},
          {entry.is_error ? "error" : "result", entry.data}};
}

struct InputWriter {
  Dict operator()(const StartEntry&) const { return {{"kind", "start"}}; }
  Dict operator()(const EventEntry& entry) const { return with_kind("event", event_json(entry)); }
  Dict operator()(const ResponseEntry& entry) const { return with_kind("response", response_json(entry)); }
  Dict operator()(const AbortEntry&) const { return {{"kind", "abort"}}; }

  static Dict with_kind(const char* kind, const Dict& rest) {
    Dict json{{"kind", kind}};
    for (const auto& [key, value] : rest) json.set(key, value);
    return json;
  }
};

Dict script_step(const JournalEntry& entry) {
  if (const auto* event = std::get_if<EventEntry>(&entry)) return {{"events", List{event_json(*event)}}};
  if (const auto* response = std::get_if<ResponseEntry>(&entry)) return {{"responses", List{response_json(*response)}}};
  return {};
}

}  // namespace

Value header_json(const JournalHeader& header) {
  const semantics::Budgets& budgets = header.budgets;
  return Dict{{"native", header.native},
              {"arguments", header.arguments},
              {"services", services_json(*header.program)},
              {"semantics", kSemanticsVersion},
              {"budgets", Dict{{"steps", integer(budgets.evaluation.steps)},
                               {"value_units", integer(budgets.evaluation.value_units)},
                               {"micro_steps", integer(budgets.micro_steps)}}}};
}

Value input_json(const JournalEntry& entry) { return std::visit(InputWriter{}, entry); }

Value journal_json(const Journal& journal) {
  List entries;
  for (const JournalEntry& entry : journal.entries)
    entries.emplace_back(Dict{{"position", integer(entries.size() + 1)}, {"input", input_json(entry)}});
  return Dict{{"header", header_json(journal.header)}, {"entries", std::move(entries)}};
}

Value script_json(const Journal& journal) {
  List steps;
  for (const JournalEntry& entry : journal.entries) {
    if (std::holds_alternative<AbortEntry>(entry)) break;  // no step of a script
    steps.emplace_back(script_step(entry));
  }
  return Dict{{"arguments", journal.header.arguments},
              {"services", services_json(*journal.header.program)},
              {"closed", true},
              {"steps", std::move(steps)}};
}

}  // namespace race::execution
