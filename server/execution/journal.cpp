#include "server/execution/journal.h"

namespace race::server {
namespace {

// The services as they have described themselves to the program.
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

// Of a response: whose, and its result or error.
Dict response_json(const semantics::Program& program, const semantics::Input& input) {
  const auto& operation = program.services.operations()[input.number];
  return Dict{{"service", program.services.is_open(input.number) ? input.service : operation.service},
              {"operation", operation.name},
              {"call", static_cast<std::int64_t>(input.call)},
              {input.is_error ? "error" : "result", input.data}};
}

Dict event_json(const semantics::Program& program, const semantics::Input& input) {
  const auto& event = program.services.events()[input.number];
  return Dict{{"service", event.service}, {"event", event.name}, {"data", input.data}};
}

}  // namespace

Value input_json(const semantics::Program& program, const JournalEntry& entry) {
  if (entry.kind == JournalEntry::Kind::start) return Dict{{"kind", "start"}};
  if (entry.kind == JournalEntry::Kind::abort) return Dict{{"kind", "abort"}};
  const bool is_event = entry.input.kind == semantics::Input::Kind::event;
  Dict json{{"kind", is_event ? "event" : "response"}};
  for (auto& [key, value] : is_event ? event_json(program, entry.input) : response_json(program, entry.input))
    json.set(key, value);
  return json;
}

Value journal_json(const Journal& journal) {
  const JournalHeader& header = journal.header;
  const auto number = [](auto n) { return Value(static_cast<std::int64_t>(n)); };
  Dict json_header{{"native", header.native},
                   {"arguments", header.arguments},
                   {"services", services_json(*header.program)},
                   {"semantics", "1"},
                   {"budgets", Dict{{"steps", number(header.budgets.evaluation.steps)},
                                    {"value_units", number(header.budgets.evaluation.value_units)},
                                    {"micro_steps", number(header.budgets.micro_steps)}}}};
  List entries;
  for (const JournalEntry& entry : journal.entries)
    entries.emplace_back(Dict{{"position", number(entries.size() + 1)}, {"input", input_json(*header.program, entry)}});
  return Dict{{"header", std::move(json_header)}, {"entries", std::move(entries)}};
}

Value script_json(const Journal& journal) {
  const semantics::Program& program = *journal.header.program;
  List steps;
  for (const JournalEntry& entry : journal.entries) {
    if (entry.kind == JournalEntry::Kind::abort) break;  // no step of a script
    Dict step;
    if (entry.kind == JournalEntry::Kind::input) {
      if (entry.input.kind == semantics::Input::Kind::event) {
        step.set("events", List{event_json(program, entry.input)});
      } else {
        step.set("responses", List{response_json(program, entry.input)});
      }
    }
    steps.emplace_back(std::move(step));
  }
  return Dict{{"arguments", journal.header.arguments},
              {"services", services_json(program)},
              {"closed", true},
              {"steps", std::move(steps)}};
}

}  // namespace race::server
