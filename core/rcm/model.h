// The syntax of RCM (thesis 3.1, Definitions 3.1 to 3.9) with its extensions link and oracle (3.3) and `after`, as
// values. A Document is what is stored and edited; a native model (translate.h) has no links, oracles or `after` and is
// what executes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/value/value.h"

namespace race::rcm {

/// What is said about an element besides what it does; never semantic.
struct Meta {
  std::string id;  // who it is, whatever it is called and wherever it stands (ids.h); empty: not said
  Value rest;      // the other entries; what `meta` is, if it is no object (then there is no id); null: nothing
  bool operator==(const Meta&) const = default;
};

/// PA: its value on activation is `value`, or `from` evaluated in the parent's scope, or required (neither).
struct Parameter {
  std::string name;
  std::optional<Value> value;
  std::optional<std::string> from;
  Value type;  // TYPE as JSON, or null
  std::string unit, doc;
  Meta meta;
  bool operator==(const Parameter&) const = default;
};

/// A result or a variable.
struct Datum {
  std::string name;
  std::optional<Value> initial;
  Value type;
  std::string unit, doc;
  Meta meta;
  bool operator==(const Datum&) const = default;
};

/// A: a conditioned function.
struct Action {
  std::string when, code;  // fields `when`, `do`
  Meta meta;
  bool operator==(const Action&) const = default;
};

/// P: leads to a sibling of its state, or nowhere. It has a condition `when`, or `after`: an expression in the scope of
/// its state, the time [s] after the activation of that at which it fires. A linking state's port has neither.
struct Port {
  std::string name;
  std::optional<std::string> when, after;
  std::optional<std::string> to;
  Meta meta;
  bool operator==(const Port&) const = default;
};

struct Barrier {
  std::string name;
  std::vector<std::string> to;
  Meta meta;
  bool operator==(const Barrier&) const = default;
};

/// 3.3.2. `text` is the expression (expr) or the call (external).
struct Oracle {
  enum class Kind { expr, external, history } kind = Kind::expr;
  std::string text;
  std::optional<std::vector<std::string>> resume;  // history
  bool deep = false;                               // history: of the states inside, too
  bool operator==(const Oracle&) const = default;
};

/// `keep` (R8): through which ports a state may be left and keep its values.
struct Keep {
  bool any = false;
  std::vector<std::string> ports = {};
  bool deep = false;  // R26: it also keeps them when it is left with its parent, and what its children have kept
  bool operator==(const Keep&) const = default;
};

struct State;
using Node = std::variant<State, Barrier>;

struct State {
  std::string name, doc;
  std::vector<Parameter> parameters;
  std::vector<Datum> results, variables;
  std::optional<std::string> entry, exit;
  std::vector<Action> actions;
  std::vector<Node> children;
  std::optional<std::string> first;
  std::vector<Port> ports;
  std::optional<Keep> keep;
  std::optional<std::string> link;
  std::optional<Oracle> oracle;
  Meta meta;
  bool operator==(const State&) const;
};

struct Document {
  std::string name;
  std::map<std::string, std::string> services;  // key after svc. -> service type
  std::vector<State> library;
  State root;
  Value layout;  // of an editor: id, or path, of an element -> any JSON
  Value meta;    // any JSON, or null; `notes`: id of an element -> text
  bool operator==(const Document&) const = default;
};

const std::string& name_of(const Node& node);

/// A native model: no links, no oracles, no `after`; and for every element that translation made or copied, the element
/// of the document it came from.
struct NativeModel {
  State root;
  /// Path in the native model (`Root/A`, `Root/A.port`) -> path in the document (`Root/A`, `library/Pick/A.port`).
  std::map<std::string, std::string> origin;
};

}  // namespace race::rcm
