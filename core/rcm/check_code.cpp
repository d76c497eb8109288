// The constraints of code: every text of a document is checked with the names of its scope, as translation leaves them.
#include <set>
#include <string_view>

#include "core/language/check/checker.h"
#include "core/language/interface/symbols.h"
#include "core/rcm/call_text.h"
#include "core/rcm/constraints_internal.h"
#include "core/rcm/oracle.h"
#include "core/rcm/path.h"

namespace race::rcm {
namespace {

using language::CodeKind;
using language::Symbols;

language::ChildSymbols interface_of(const State& state) {
  language::ChildSymbols out;
  for (const Parameter& parameter : state.parameters) out.parameters.emplace(parameter.name, 0);
  for (const Datum& result : state.results) out.results.emplace(result.name, 0);
  for (const Port& port : state.ports) out.ports.emplace(port.name, 0);
  return out;
}

language::ChildSymbols barrier_symbols() {
  language::ChildSymbols out;
  out.barrier = true;
  return out;
}

std::string of_parameter(const Parameter& parameter) { return "parameter `" + parameter.name + "`"; }

class CodeCheck {
 public:
  CodeCheck(const Library& library, bool names, std::vector<Error>& errors)
      : library_(library), names_(names), errors_(errors) {}

  void check_state(const State& state, const std::string& path) {
    if (state.link) return;
    const Symbols symbols = symbols_of(state);
    if (state.entry) check("entry", *state.entry, CodeKind::function, symbols, path);
    if (state.exit) check("exit", *state.exit, CodeKind::function, symbols, path);
    for (std::size_t i = 0; i < state.actions.size(); ++i) {
      const std::string which = "action " + std::to_string(i);
      check(which + ", `when`", state.actions[i].when, CodeKind::condition, symbols, path);
      check(which + ", `do`", state.actions[i].code, CodeKind::function, symbols, path);
    }
    if (state.oracle) check_oracle(*state.oracle, symbols, path);
    for (const Node& child : state.children) {
      const auto* inner = std::get_if<State>(&child);
      if (!inner) continue;
      const std::string at = node_path(path, inner->name);
      check_parameters(*inner, symbols, at);
      check_state(*inner, at);
    }
    for (const Port& port : state.ports) {
      if (port.when) check("`when`", *port.when, CodeKind::condition, symbols, port_path(path, port.name));
    }
  }

  /// The expressions of a library state itself: their scope is that of the states that link it, so their
  /// names are checked there.
  void check_open_parameters(const State& state, const std::string& path) {
    for (const Parameter& parameter : state.parameters) {
      if (parameter.from)
        report(of_parameter(parameter), language::check(*parameter.from, CodeKind::expression, Symbols{}), path,
               Names::open);
    }
  }

 private:
  enum class Names { checked, open, only };

  Symbols symbols_of(const State& state) const {
    Symbols out;
    if (!names_) return out;
    const auto own = interface_of(state);
    out.parameters = own.parameters;
    out.results = own.results;
    out.ports = own.ports;
    for (const Datum& variable : state.variables) out.variables.emplace(variable.name, 0);
    for (const Node& child : state.children) {
      const auto* inner = std::get_if<State>(&child);
      const State* behaviour = inner ? library_.behaviour(*inner) : nullptr;
      out.children.emplace(name_of(child), behaviour ? interface_of(*behaviour)
                                           : inner   ? language::ChildSymbols{}
                                                     : barrier_symbols());
    }
    if (state.oracle) {
      DerivedIds no_ids;
      out.children.emplace(kDispatcher, interface_of(dispatcher(state, no_ids)));
    }
    if (state.oracle && state.oracle->kind == Oracle::Kind::history) out.variables.emplace(kLastActive, 0);
    return out;
  }

  /// The expressions of a child, in the scope of its parent. What a link takes over unchanged was checked in the
  /// library, but for the names.
  void check_parameters(const State& child, const Symbols& parent, const std::string& path) {
    for (const Parameter& parameter : child.parameters) {
      if (parameter.from) check(of_parameter(parameter), *parameter.from, CodeKind::expression, parent, path);
    }
    if (!child.link || !names_) return;
    std::set<std::string_view> own;
    for (const Parameter& parameter : child.parameters) {
      if (parameter.value || parameter.from) own.insert(parameter.name);
    }
    for (const Parameter& parameter : library_.parameters(child)) {
      if (parameter.from && !own.contains(parameter.name))
        report(of_parameter(parameter), language::check(*parameter.from, CodeKind::expression, parent), path,
               Names::only);
    }
  }

  void check_oracle(const Oracle& oracle, const Symbols& symbols, const std::string& path) {
    if (oracle.kind == Oracle::Kind::expr) check("oracle", oracle.text, CodeKind::expression, symbols, path);
    if (oracle.kind != Oracle::Kind::external) return;
    const auto call = parse_call(oracle.text);
    if (!call) return;
    for (const auto& argument : call->arguments)
      check("oracle, argument `" + argument.expression + "`", argument.expression, CodeKind::expression, symbols, path);
  }

  /// `which`: the name of this text of the element at `path`, for messages.
  void check(const std::string& which, std::string_view text, CodeKind kind, const Symbols& symbols,
             const std::string& path) {
    report(which, language::check(text, kind, symbols), path, Names::checked);
  }

  void report(const std::string& which, std::vector<Error> found, const std::string& path, Names names) {
    for (Error& error : found) {
      const bool unknown = error.code == ErrorCode::unknown_name;
      if (!names_ && (unknown || error.code == ErrorCode::scope)) continue;
      if ((names == Names::open && unknown) || (names == Names::only && !unknown)) continue;
      error.path = path;
      error.message = which + ": " + error.message;
      errors_.push_back(std::move(error));
    }
  }

  const Library& library_;
  const bool names_;
  std::vector<Error>& errors_;
};

}  // namespace

void check_code(const Document& document, const Library& library, bool names, std::vector<Error>& errors) {
  CodeCheck check(library, names, errors);
  for (const State& state : document.library) {
    check.check_open_parameters(state, library_path(state.name));
    check.check_state(state, library_path(state.name));
  }
  check.check_state(document.root, node_path("", document.root.name));
}

}  // namespace race::rcm
