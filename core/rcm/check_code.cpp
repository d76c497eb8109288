// The constraints of code: every text of a document is checked with the names of its scope, as translation leaves them.
#include <set>
#include <string_view>

#include "core/language/check/checker.h"
#include "core/language/interface/symbols.h"
#include "core/rcm/after.h"
#include "core/rcm/call_text.h"
#include "core/rcm/constraints_internal.h"
#include "core/rcm/oracle.h"
#include "core/rcm/path.h"
#include "core/value/error_list.h"

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

/// Of which element a text is, and which of its fields.
struct TextOf {
  const Meta& element;
  std::string_view field;
};

std::string of_parameter(const Parameter& parameter) { return "parameter `" + parameter.name + "`"; }
std::string of_action(std::size_t number, std::string_view field) {
  return "action " + std::to_string(number) + ", `" + std::string(field) + "`";
}

/// The names that code of one state may use, and what is known of code that uses them.
struct Scope {
  Symbols symbols;
  CodeChecks::Scope* known = nullptr;
};

class CodeCheck {
 public:
  CodeCheck(const Library& library, bool names, CodeChecks* checks, std::vector<Error>& errors)
      : library_(library), names_(names), checks_(checks), open_(scope_of({})), errors_(errors) {}

  void check_state(const State& state, const std::string& path) {
    if (state.link || is_full(errors_)) return;
    const auto at_state = [&] { return path; };
    const Scope scope = scope_of(symbols_of(state));
    const auto own = [&](std::string_view field, const std::optional<std::string>& text) {
      if (text)
        check(
            {state.meta, field}, [&] { return std::string(field); }, *text, CodeKind::function, scope, at_state);
    };
    own("entry", state.entry);
    own("exit", state.exit);
    for (std::size_t i = 0; i < state.actions.size(); ++i) {
      const Action& action = state.actions[i];
      check(
          {action.meta, "when"}, [&] { return of_action(i, "when"); }, action.when, CodeKind::condition, scope,
          at_state);
      check(
          {action.meta, "do"}, [&] { return of_action(i, "do"); }, action.code, CodeKind::function, scope, at_state);
    }
    if (state.oracle) check_oracle(state, scope, path);
    for (const Node& child : state.children) {
      const auto* inner = std::get_if<State>(&child);
      if (!inner) continue;
      const std::string at = node_path(path, inner->name);
      check_parameters(*inner, scope, at);
      check_state(*inner, at);
    }
    for (const Port& port : state.ports) {
      const auto at_port = [&] { return port_path(path, port.name); };
      if (port.when)
        check(
            {port.meta, "when"}, [] { return "`when`"; }, *port.when, CodeKind::condition, scope, at_port);
      if (port.after)
        check(
            {port.meta, "after"}, [] { return "`after`"; }, *port.after, CodeKind::expression, scope, at_port);
    }
  }

  /// The expressions of a library state itself: their scope is that of the states that link it, so their
  /// names are checked there.
  void check_open_parameters(const State& state, const std::string& path) {
    for (const Parameter& parameter : state.parameters) {
      if (parameter.from)
        check(
            {parameter.meta, "from"}, [&] { return of_parameter(parameter); }, *parameter.from, CodeKind::expression,
            open_, [&] { return path; }, Names::open);
    }
  }

 private:
  enum class Names { checked, open, only };
  enum class Lines {
    of_the_text,
    of_a_part
  };  // what is checked: all of a text, or a part of it, whose place is not known

  Symbols symbols_of(const State& state) const {
    Symbols out;
    if (!names_ && !checks_) return out;
    auto own = interface_of(state);
    out.parameters = std::move(own.parameters);
    out.results = std::move(own.results);
    out.ports = std::move(own.ports);
    for (const Datum& variable : state.variables) out.variables.emplace(variable.name, 0);
    for (const Node& child : state.children) {
      const auto* inner = std::get_if<State>(&child);
      const State* behaviour = inner ? library_.behaviour(*inner) : nullptr;
      out.children.emplace(name_of(child), behaviour ? interface_of(*behaviour)
                                           : inner   ? language::ChildSymbols{}
                                                     : barrier_symbols());
    }
    add_after(state, out);
    if (state.oracle && names_) {
      DerivedIds no_ids;
      out.children.emplace(kDispatcher, interface_of(dispatcher(state, no_ids)));
    }
    if (state.oracle && state.oracle->kind == Oracle::Kind::history) out.variables.emplace(kLastActive, 0);
    return out;
  }

  /// The states that the `after` of ports make.
  static void add_after(const State& state, Symbols& out) {
    for (const Port& port : state.ports) {
      if (!port.after) continue;
      DerivedIds no_ids;
      out.children.emplace(after_name(port.name), interface_of(after_state(port, no_ids)));
    }
    if (has_after_barrier(state)) out.children.emplace(kAfterBarrier, barrier_symbols());
  }

  Scope scope_of(Symbols symbols) const {
    Scope out{std::move(symbols), nullptr};
    if (checks_) out.known = &checks_->scope(out.symbols);
    return out;
  }

  /// The expressions of a child, in the scope of its parent. What a link takes over unchanged was checked in the
  /// library, but for the names.
  void check_parameters(const State& child, const Scope& parent, const std::string& path) {
    const auto check_from = [&](const Parameter& parameter, Names names) {
      check(
          {parameter.meta, "from"}, [&] { return of_parameter(parameter); }, *parameter.from, CodeKind::expression,
          parent, [&] { return path; }, names);
    };
    for (const Parameter& parameter : child.parameters) {
      if (parameter.from) check_from(parameter, Names::checked);
    }
    if (!child.link || !names_) return;
    std::set<std::string_view> own;
    for (const Parameter& parameter : child.parameters) {
      if (parameter.value || parameter.from) own.insert(parameter.name);
    }
    for (const Parameter& parameter : library_.parameters(child)) {
      if (parameter.from && !own.contains(parameter.name)) check_from(parameter, Names::only);
    }
  }

  void check_oracle(const State& state, const Scope& scope, const std::string& path) {
    const Oracle& oracle = *state.oracle;
    const TextOf of{state.meta, "oracle"};
    const auto at = [&] { return path; };
    if (oracle.kind == Oracle::Kind::expr)
      check(
          of, [] { return "oracle"; }, oracle.text, CodeKind::expression, scope, at);
    if (oracle.kind != Oracle::Kind::external) return;
    const auto call = parse_call(oracle.text);
    if (!call) return;
    for (const auto& argument : call->arguments)
      check(
          of, [&] { return "oracle, argument `" + argument.expression + "`"; }, argument.expression,
          CodeKind::expression, scope, at, Names::checked, Lines::of_a_part);
  }

  /// `which`() names this text of the element at the path `where`(), for messages.
  template <typename Which, typename Where>
  void check(TextOf of, Which which, std::string_view text, CodeKind kind, const Scope& scope, Where where,
             Names names = Names::checked, Lines lines = Lines::of_the_text) {
    if (is_full(errors_)) return;
    if (checks_) {
      report(of, which, known_errors(text, kind, scope), where, names, lines);
    } else {
      report(of, which, language::check(text, kind, scope.symbols), where, names, lines);
    }
  }

  /// A text without errors has none but of names with any other names, so that a violation of structure, because of
  /// which names are not checked, does not make all texts be read again.
  const std::vector<Error>& known_errors(std::string_view text, CodeKind kind, const Scope& scope) {
    const std::vector<Error>& errors = checks_->check(text, kind, scope.symbols, *scope.known);
    return names_ || errors.empty() ? errors : checks_->check(text, kind, open_.symbols, *open_.known);
  }

  template <typename Which, typename Where>
  void report(TextOf of, Which which, const std::vector<Error>& found, Where where, Names names, Lines lines) {
    for (const Error& error : found) {
      const bool unknown = error.code == ErrorCode::unknown_name;
      if (!names_ && (unknown || error.code == ErrorCode::scope)) continue;
      if ((names == Names::open && unknown) || (names == Names::only && !unknown)) continue;
      const SourceRange range = lines == Lines::of_the_text ? error.where : SourceRange{};
      add_error(errors_,
                {error.code, which() + (": " + error.message), where(), range, of.element.id, std::string(of.field)});
    }
  }

  const Library& library_;
  const bool names_;
  CodeChecks* const checks_;
  const Scope open_;
  std::vector<Error>& errors_;
};

}  // namespace

void check_code(const Document& document, const Library& library, bool names, CodeChecks* checks,
                std::vector<Error>& errors) {
  if (checks) checks->begin();
  CodeCheck check(library, names, checks, errors);
  for (const State& state : document.library) {
    check.check_open_parameters(state, library_path(state.name));
    check.check_state(state, library_path(state.name));
  }
  check.check_state(document.root, node_path("", document.root.name));
  if (checks) checks->end();
}

}  // namespace race::rcm
