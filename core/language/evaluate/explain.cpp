#include "core/language/evaluate/explain.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/language/evaluate/machine_internal.h"

namespace race::language {
namespace {

bool is_junction(Opcode op) {
  return op == Opcode::logical_and || op == Opcode::logical_or || op == Opcode::logical_not;
}

bool is_read(Opcode op) {
  return op == Opcode::slot || op == Opcode::flag || (op >= Opcode::event && op <= Opcode::collection);
}

class Explainer {
 public:
  Explainer(const Program& program, Environment& environment)
      : program_(program), environment_(environment), machine_(Interpreter::Limits()) {}

  Explanation run() {
    EvaluationTrace* const trace = std::exchange(environment_.trace, nullptr);
    made_.value = machine_.condition(program_, environment_);
    atoms(program_.root);
    if (made_.value != Truth::yes) decide();
    environment_.trace = trace;
    return std::move(made_);
  }

  ExplainedValue run_expression() {
    EvaluationTrace* const trace = std::exchange(environment_.trace, nullptr);
    ExplainedValue made;
    if (std::optional<Value> value = machine_.expression(program_, environment_))
      made.value = std::move(*value);
    else
      made.fault = machine_.fault();
    made.reads = reads(0, program_.root);
    environment_.trace = trace;
    return made;
  }

 private:
  std::vector<NodeId> parts(NodeId id) const {
    const Node& n = program_.nodes[id];
    if (n.op == Opcode::logical_not) return {n.a};
    return {program_.run(n), program_.run(n) + n.count};
  }

  void atoms(NodeId id) {
    if (is_junction(program_.nodes[id].op)) {
      for (const NodeId part : parts(id)) atoms(part);
      return;
    }
    Explanation::Atom atom;
    atom.text = std::string(slice(program_.text, program_.spans[id]));
    atom.where = program_.range(id);
    atom.value = machine_.part(program_, environment_, id);
    atom.reads = reads(nodes_.empty() ? 0 : nodes_.back() + 1, id);
    nodes_.push_back(id);
    made_.atoms.push_back(std::move(atom));
  }

  // What nodes [first, last] read. A part precedes the whole, so a path `a.b` follows its `a` and replaces it.
  std::vector<Explanation::Read> reads(NodeId first, NodeId last) {
    std::vector<NodeId> found;
    for (NodeId id = first; id <= last; ++id) {
      const Node& n = program_.nodes[id];
      if (is_read(n.op)) found.push_back(id);
      if (n.op == Opcode::field && !found.empty() && found.back() == n.a) found.back() = id;
    }
    std::vector<Explanation::Read> made;
    for (const NodeId id : found) {
      std::string text(slice(program_.text, program_.spans[id]));
      const bool known = std::any_of(made.begin(), made.end(), [&](const auto& read) { return read.text == text; });
      if (!known) made.push_back({std::move(text), machine_.value(program_, environment_, id)});
    }
    return made;
  }

  std::size_t number(NodeId atom) const {
    return static_cast<std::size_t>(std::find(nodes_.begin(), nodes_.end(), atom) - nodes_.begin());
  }

  // The truth of the condition if its atoms were `values`.
  Truth with(NodeId id, const std::vector<Truth>& values) const {
    const Opcode op = program_.nodes[id].op;
    if (!is_junction(op)) return values[number(id)];
    if (op == Opcode::logical_not) {
      const Truth t = with(program_.nodes[id].a, values);
      return t == Truth::yes ? Truth::no : t == Truth::no ? Truth::yes : t;
    }
    const Truth decides = op == Opcode::logical_and ? Truth::no : Truth::yes;
    Truth result = op == Opcode::logical_and ? Truth::yes : Truth::no;
    for (const NodeId part : parts(id)) {
      const Truth t = with(part, values);
      if (t == decides || t == Truth::fault) return t;
      if (t == Truth::unknown) result = t;
    }
    return result;
  }

  std::vector<Truth> values() const {
    std::vector<Truth> now;
    for (const Explanation::Atom& atom : made_.atoms) now.push_back(atom.value);
    return now;
  }

  // Sets an atom and those of the same text.
  void set(std::vector<Truth>& values, std::size_t atom, bool to) const {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (made_.atoms[i].text == made_.atoms[atom].text) values[i] = to ? Truth::yes : Truth::no;
  }

  // The fewest changes of atoms that make a part `wanted`; nothing if there are none. Correct because every atom occurs
  // once.
  using Changes = std::vector<std::pair<std::size_t, bool>>;
  std::optional<Changes> changes(NodeId id, bool wanted) const {
    const Opcode op = program_.nodes[id].op;
    if (op == Opcode::logical_not) return changes(program_.nodes[id].a, !wanted);
    if (!is_junction(op)) {
      const std::size_t atom = number(id);
      if (made_.atoms[atom].value == (wanted ? Truth::yes : Truth::no)) return Changes();
      if (made_.atoms[atom].reads.empty()) return std::nullopt;
      return Changes{{atom, wanted}};
    }
    std::optional<Changes> all = Changes();
    std::optional<Changes> fewest;
    for (const NodeId part : parts(id)) {
      const auto some = changes(part, wanted);
      if (all && some) all->insert(all->end(), some->begin(), some->end());
      if (!some) all.reset();
      if (some && (!fewest || some->size() < fewest->size())) fewest = some;
    }
    return (op == Opcode::logical_and) == wanted ? all : fewest;
  }

  void decide() {
    for (std::size_t i = 0; i < made_.atoms.size(); ++i)
      for (const bool to : {true, false}) {
        if (made_.atoms[i].reads.empty()) continue;
        std::vector<Truth> changed = values();
        set(changed, i, to);
        if (changed[i] == made_.atoms[i].value || with(program_.root, changed) != Truth::yes) continue;
        made_.atoms[i].wanted = to;
        made_.decisive.push_back(i);
        break;
      }
    if (!made_.decisive.empty()) return;
    std::vector<Truth> changed = values();
    const auto needed = changes(program_.root, true);
    if (!needed) return;
    for (const auto& [atom, to] : *needed) set(changed, atom, to);
    if (with(program_.root, changed) != Truth::yes) return;
    made_.together = true;
    for (const auto& [atom, to] : *needed) {
      made_.atoms[atom].wanted = to;
      made_.decisive.push_back(atom);
    }
  }

  const Program& program_;
  Environment& environment_;
  Machine machine_;
  Explanation made_;
  std::vector<NodeId> nodes_;  // of the atoms
};

}  // namespace

Explanation explain(const Code& condition, Environment& environment) {
  return Explainer(condition.program(), environment).run();
}

ExplainedValue explain_value(const Code& expression, Environment& environment) {
  return Explainer(expression.program(), environment).run_expression();
}

}  // namespace race::language
