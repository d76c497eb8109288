#include "core/execution/why.h"

#include <algorithm>

namespace race::execution {

using language::Explanation;
using language::Truth;
using semantics::PortId;
using semantics::Run;

namespace {

Value truth_json(Truth truth) {
  if (truth == Truth::yes) return true;
  if (truth == Truth::no) return false;
  return nullptr;  // unknown, or it faults
}

bool is_service(const std::string& text) { return text.starts_with("svc"); }

Value atom_json(const Explanation::Atom& atom, bool decisive, bool together) {
  List reads, requires_;
  for (const Explanation::Read& read : atom.reads) {
    Dict entry{{"text", read.text}};
    if (!read.value.is_unknown()) entry.set("value", read.value);
    reads.emplace_back(std::move(entry));
    if (is_service(read.text)) requires_.emplace_back(read.text);
  }
  Dict json{{"text", atom.text},
            {"value", truth_json(atom.value)},
            {"service", is_service(atom.text) || !requires_.empty()},
            {"blocks", decisive && !together}};
  if (atom.where.line > 0) {
    json.set("line", atom.where.line);
    json.set("column", atom.where.column);
    json.set("end_line", atom.where.end_line);
    json.set("end_column", atom.where.end_column);
  }
  json.set("requires", std::move(requires_));
  json.set("reads", std::move(reads));
  if (decisive) json.set("wanted", atom.wanted);
  if (decisive && together) json.set("together", true);
  return json;
}

// The atoms that are decisive, as "`a` and `b`".
std::string decisive_text(const Explanation& explanation) {
  std::string text;
  for (const std::size_t i : explanation.decisive)
    text += (text.empty() ? "`" : (explanation.together ? " and `" : " or `")) + explanation.atoms[i].text +
            "` becomes " + (explanation.atoms[i].wanted ? "true" : "false");
  return text;
}

std::string reason(const Run::Why& why, bool active) {
  const std::string decisive = decisive_text(why.explanation);
  if (active) return "It has fired and waits to be followed.";
  if (!why.state_active) return "Its state is not active, so it cannot fire.";
  if (why.held_back) return "Its condition is true, but it has fired already in this macro step (R9).";
  if (why.explanation.value == Truth::yes) return "Its condition is true: it fires in the next micro step.";
  if (why.explanation.value == Truth::fault) return "Its condition cannot be evaluated.";
  if (decisive.empty()) return "Its condition cannot become true by changing its atoms.";
  return "It fires when " + decisive + ".";
}

}  // namespace

Value why_json(Execution& execution, PortId port) {
  const Run& run = execution.run();
  const semantics::PortInfo& info = run.program()[port];
  const Run::Why why = execution.why(port);
  const bool active = run.state().flags[run.program().flag(port)] != 0;
  List atoms;
  for (std::size_t i = 0; i < why.explanation.atoms.size(); ++i) {
    const auto& decisive = why.explanation.decisive;
    atoms.push_back(atom_json(why.explanation.atoms[i], std::ranges::find(decisive, i) != decisive.end(),
                              why.explanation.together));
  }
  Dict json{{"port", run.program().address(port)},
            {"condition", info.when.text()},
            {"value", truth_json(why.explanation.value)},
            {"active", active},
            {"state_active", why.state_active},
            {"reason", reason(why, active)},
            {"atoms", std::move(atoms)}};
  if (why.held_back) json.set("held", "R9");
  if (why.occurrence_hidden) json.set("held", "R21");
  return json;
}

Expected<Value> why_before(Replay& replay, const std::string& port, std::uint64_t step, int micro,
                           const std::atomic<bool>* stop) {
  ASSIGN_OR_RETURN(Execution then, replay.before(step, micro, stop));
  const auto id = then.run().program().find_port(port);
  if (!id) return unexpected(ErrorCode::not_found, "there was no port of this path", port);
  return why_json(then, *id);
}

}  // namespace race::execution
