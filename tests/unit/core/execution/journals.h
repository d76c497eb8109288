// Journals for tests: one made by hand, and those of runs of random models.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/execution/execution.h"
#include "core/execution/journal_walk.h"
#include "core/execution/step_json.h"
#include "core/rcm/document.h"
#include "core/rcm/native.h"
#include "core/rcm/translate.h"
#include "core/rsm/document.h"
#include "tests/unit/core/semantics/random_models.h"

namespace race::execution {

/// A journal without entries, of a document and services.
inline Journal journal_of(const rcm::Document& document, const std::map<std::string, rsm::Service>& services,
                          Dict arguments = {}, semantics::Budgets budgets = {}) {
  const rcm::NativeModel native = rcm::translate(document).value();
  auto program = semantics::Program::build(native, services).value();
  Value json = rcm::write_native(document, native);
  arguments.freeze();
  return {{json.freeze(), std::move(program), std::move(arguments), budgets}, {}};
}

/// A task that calls two declared operations, and one of a service that nobody declares; it reads all of their
/// responses and an event. A library state, linked twice, and an oracle make its native model differ from the document.
inline Journal small_journal() {
  static constexpr const char* kDocument = R"json({"rcm": 1, "name": "small", "services": {"t": "timer"},
    "library": [{"state": "Step", "entry": "svc.t.wait(1)", "ports": [{"name": "done", "when": "svc.t.wait.result"}]}],
    "root": {
  "state": "Root", "parameters": [{"name": "key", "value": "a"}, {"name": "n", "value": 1.5}],
      "entry": "svc['w' if par.key else 'v'].go()",
      "actions": [{"when": "svc['w' if par.key else 'v'].go.error", "do": "var.lost = True"}],
      "children": [{"state": "A", "link": "Step", "ports": [{"name": "done", "to": "B"}]}, {"state": "B", "link": "Step"}],
      "oracle": {"kind": "expr", "expr": "'B' if par.n > 2 else 'A'"}, "first": "A",
      "ports": [{"name": "over", "when": "svc.t.tick.x > 2"}]
}
})json";
  static constexpr const char* kTimer = R"({"operations": [{"name": "wait"}, {"name": "stop", "safe": true}],
    "events": [{"name": "tick", "sampled": true}, {"name": "unread"}]})";
  const rsm::Service timer = rsm::read_service_text(kTimer, "timer").value();
  semantics::Budgets budgets;
  budgets.micro_steps = 500;
  Journal journal = journal_of(rcm::read_document_text(kDocument).value(), {{"t", timer}, {"u", timer}},
                               Dict{{"key", "b"}, {"n", 1}}, budgets);
  journal.entries = {StartEntry{},
                     ResponseEntry{1, "w", "go", true, Dict{{"code", "unavailable"}}},
                     EventEntry{"t", "tick", Dict{{"x", 1.0}}},
                     ResponseEntry{2, "t", "wait", false, Value()},
                     EventEntry{"t", "tick", Dict{{"x", List{1, "\n\u00e9", nullptr}}}},
                     AbortEntry{}};
  return journal;
}

/// The steps that a journal comes to, as a derivation document has them. Errors: those of JournalWalk::next.
inline Expected<List> derived_steps(const Journal& journal) {
  const auto source = std::make_shared<MemoryJournal>(journal.entries);
  ASSIGN_OR_RETURN(JournalWalk walk, JournalWalk::create(journal.header, source, journal.entries.size()));
  List steps;
  while (!walk.at_end()) {
    ASSIGN_OR_RETURN(const Progress* progress, walk.next({.derivation = true}));
    steps.push_back(derived_step(walk.execution(), *progress));
  }
  return steps;
}

/// The journal of a random run of a random model, of at most about `steps` macro steps, and the execution.
inline std::pair<Journal, Execution> random_journal(std::uint64_t seed, int steps) {
  semantics::RandomModels random(seed);
  rcm::Document document;
  document.root = random.model().root;
  semantics::Budgets budgets;
  budgets.micro_steps = 300;
  Journal journal = journal_of(document, semantics::RandomModels::services(), {}, budgets);
  auto execution = Execution::create(journal.header.program, {}, budgets).value();
  journal.entries.push_back(execution.start({}).entry.value());
  for (int step = 1; step < steps && !execution.is_over(); ++step) {
    random.post<Execution>({&execution}, execution.run().state().call_count);
    if (execution.has_input()) journal.entries.push_back(execution.step({}).entry.value());
  }
  if (!execution.is_over() && random.chance(0.5)) journal.entries.push_back(execution.abort().entry.value());
  return {std::move(journal), std::move(execution)};
}

}  // namespace race::execution
