// The constraints of structure: names, what refers to what, links and oracles.
#include <algorithm>
#include <set>

#include "core/rcm/after.h"
#include "core/rcm/call_text.h"
#include "core/rcm/constraints_internal.h"
#include "core/rcm/deep_history.h"
#include "core/rcm/oracle.h"
#include "core/rcm/path.h"
#include "core/rcm/used_variables.h"
#include "core/value/error_list.h"
#include "core/value/fields.h"

namespace race::rcm {
namespace {

using Names = std::set<std::string_view>;

/// What ports and barriers may lead to: the nodes on one level.
struct Level {
  Names states, barriers;
  bool has(std::string_view name) const { return states.contains(name) || barriers.contains(name); }
};

Level level_of(const std::vector<Node>& nodes) {
  Level out;
  for (const Node& node : nodes)
    (std::holds_alternative<State>(node) ? out.states : out.barriers).insert(name_of(node));
  return out;
}

class Structure {
 public:
  Structure(const Library& library, const std::set<std::string>& nameless, std::vector<Error>& errors)
      : library_(library), nameless_(nameless), errors_(errors) {}

  void check_document(const Document& document, bool has_root) {
    resumed_ = resumed_states(document, library_);
    for (const auto& [key, type] : document.services) {
      if (!is_name(key)) add(ErrorCode::name, "", "service: " + quote(key) + " is no name");
    }
    Names names;
    for (const State& state : document.library) {
      declare("library state", state.name, names, "");
      check_state(state, library_path(state.name), Level{});
    }
    for (const auto& cycle : library_.cycles()) report_cycle(cycle);
    if (!has_root) return;
    const std::string path = node_path("", document.root.name);
    check_state(document.root, path, Level{});
    check_root(document.root, path);
  }

 private:
  void add(ErrorCode code, const std::string& path, std::string message) {
    if (code == ErrorCode::name && nameless_.contains(path)) return;
    add_error(errors_, {code, std::move(message), path});
  }

  /// Names of one kind are unique; whether each is a valid name is checked elsewhere.
  void declare(std::string_view what, const std::string& name, Names& names, const std::string& path) {
    if (!name.empty() && !names.insert(name).second)
      add(ErrorCode::duplicate, path, std::string(what) + " " + quote(name) + " is declared twice");
  }

  void check_name(std::string_view what, const std::string& name, const std::string& path) {
    if (!is_name(name)) add(ErrorCode::name, path, std::string(what) + ": " + quote(name) + " is no name");
  }

  void report_cycle(const std::vector<std::string>& cycle) {
    std::string way;
    for (const std::string& name : cycle) way += name + " -> ";
    add(ErrorCode::link_cycle, library_path(cycle.front()), "links in a circle: " + way + cycle.front());
  }

  void check_root(const State& root, const std::string& path) {
    if (!library_.behaviour(root)) return;
    for (const Parameter& parameter : library_.parameters(root)) {
      if (parameter.from)
        add(ErrorCode::root_from, path,
            "parameter " + quote(parameter.name) + ": the root has no parent in whose scope `from` could be evaluated");
    }
  }

  void check_state(const State& state, const std::string& path, const Level& siblings) {
    if (is_full(errors_)) return;
    check_name("state", state.name, path);
    check_data(state, path);
    check_ports(state, path, siblings);
    if (state.link) return check_link(state, path);
    if (state.keep) check_keep("keep", state.keep->ports, state, path);
    const Level level = level_of(state.children);
    if (state.first && !level.has(*state.first))
      add(ErrorCode::first, path, "`first`: there is no child " + quote(*state.first));
    if (state.oracle) check_oracle(state, path, level);
    if (resumed_.contains(&state)) check_resumed(state, path, level);
    check_after(state, path, level);
    check_children(state, path, level);
  }

  void check_data(const State& state, const std::string& path) {
    Names parameters, results, variables;
    for (const Parameter& parameter : state.parameters) {
      check_name("parameter", parameter.name, path);
      declare("parameter", parameter.name, parameters, path);
      if (parameter.value && parameter.from)
        add(ErrorCode::parameter, path, "parameter " + quote(parameter.name) + " has both `value` and `from`");
    }
    for (const Datum& result : state.results) {
      check_name("result", result.name, path);
      declare("result", result.name, results, path);
    }
    for (const Datum& variable : state.variables) {
      check_name("variable", variable.name, path);
      declare("variable", variable.name, variables, path);
    }
  }

  void check_ports(const State& state, const std::string& path, const Level& siblings) {
    Names names;
    for (const Port& port : state.ports) {
      const std::string at = port_path(path, port.name);
      check_name("port", port.name, at);
      declare("port", port.name, names, path);
      if (!port.when && !port.after && !state.link)
        add(ErrorCode::missing, at, "the field `when` is missing (or `after`, a time in seconds)");
      if (port.after && state.link)
        add(ErrorCode::after, at, "a linking state's port has no `after`: the library says when it fires");
      if (port.when && port.after) add(ErrorCode::after, at, "the port has both `when` and `after`");
      if (port.to && !siblings.has(*port.to))
        add(ErrorCode::port_target, at, "leads to " + quote(*port.to) + ", which is no sibling of its state");
    }
  }

  void check_children(const State& state, const std::string& path, const Level& level) {
    Names names;
    for (const Node& child : state.children) {
      const std::string at = node_path(path, name_of(child));
      declare("child", name_of(child), names, path);
      if (const auto* inner = std::get_if<State>(&child)) {
        check_state(*inner, at, level);
      } else {
        check_barrier(std::get<Barrier>(child), at, level);
      }
    }
  }

  void check_barrier(const Barrier& barrier, const std::string& path, const Level& siblings) {
    check_name("barrier", barrier.name, path);
    for (const std::string& target : barrier.to) {
      if (!siblings.states.contains(target))
        add(ErrorCode::barrier_target, path, "leads to " + quote(target) + ", which is no sibling state");
    }
  }

  void check_keep(std::string_view field, const std::vector<std::string>& ports, const State& state,
                  const std::string& path) {
    Names names;
    for (const Port& port : state.ports) names.insert(port.name);
    for (const std::string& port : ports) {
      if (!names.contains(port)) add(ErrorCode::keep, path, quote(field) + ": there is no port " + quote(port));
    }
  }

  void check_link(const State& state, const std::string& path) {
    if (!state.results.empty() || !state.variables.empty() || state.entry || state.exit || !state.actions.empty() ||
        !state.children.empty() || state.first || state.keep || state.oracle)
      add(ErrorCode::link_field, path, "a linking state has no behaviour of its own: only parameters and ports");
    if (!library_.find(*state.link))
      return add(ErrorCode::link_unknown, path, "the library has no state " + quote(*state.link));
    const Library::Interface* linked = library_.interface(*state.link);
    if (!linked) return;  // a later link leads nowhere or back, which is reported there
    for (const Parameter& parameter : state.parameters) {
      if (!linked->parameters.contains(parameter.name))
        add(ErrorCode::link_parameter, path, quote(*state.link) + " has no parameter " + quote(parameter.name));
    }
    for (const Port& port : state.ports) {
      if (!linked->ports.contains(port.name))
        add(ErrorCode::link_port, port_path(path, port.name), quote(*state.link) + " has no port " + quote(port.name));
    }
  }

  void check_oracle(const State& state, const std::string& path, const Level& level) {
    const Oracle& oracle = *state.oracle;
    const bool history = oracle.kind == Oracle::Kind::history;
    if (level.states.empty()) add(ErrorCode::oracle, path, "an oracle needs child states to choose from");
    if (!state.first && oracle.kind != Oracle::Kind::expr)
      add(ErrorCode::oracle, path, "an oracle of this kind needs `first`");
    if (state.first && level.barriers.contains(*state.first))
      add(ErrorCode::oracle, path, "the `first` of an oracle is a state, not a barrier");
    if (oracle.kind == Oracle::Kind::external && !parse_call(oracle.text))
      add(ErrorCode::oracle, path, "`call` must be a call such as svc.Oracle.decide(par, res, var)");
    if (history && state.keep) add(ErrorCode::oracle, path, "a history has no `keep` of its own");
    if (history && oracle.resume) check_keep("resume", *oracle.resume, state, path);
    check_made_names(state, path, level, history);
  }

  /// The names that the translation of `after` adds must be free.
  void check_after(const State& state, const std::string& path, const Level& level) {
    for (const Port& port : state.ports) {
      if (port.after && level.has(after_name(port.name)))
        add(ErrorCode::duplicate, path,
            "child " + quote(after_name(port.name)) + ": the `after` of the port makes a state of this name");
    }
    if (has_after_barrier(state) && level.has(kAfterBarrier))
      add(ErrorCode::duplicate, path, "child `After`: the `after` of a port makes a barrier of this name");
  }

  /// The names that the translation of the oracle adds must be free.
  void check_made_names(const State& state, const std::string& path, const Level& level, bool history) {
    check_dispatcher("oracle", path, level);
    if (history && declares_last_active(state)) add_last_active("history", path);
  }

  /// The same of a state that a deep history around it resumes. Its code does not know of the variable either.
  void check_resumed(const State& state, const std::string& path, const Level& level) {
    const std::string around = "deep history around it";
    check_dispatcher(around, path, level);
    const auto used = used_variables(state);
    if (declares_last_active(state) || std::ranges::find(used, kLastActive) != used.end())
      add_last_active(around, path);
  }

  void check_dispatcher(const std::string& maker, const std::string& path, const Level& level) {
    if (level.has(kDispatcher))
      add(ErrorCode::duplicate, path, "child `Dispatcher`: the " + maker + " makes a state of this name");
  }
  static bool declares_last_active(const State& state) {
    return std::ranges::find(state.variables, kLastActive, &Datum::name) != state.variables.end();
  }
  void add_last_active(const std::string& maker, const std::string& path) {
    add(ErrorCode::duplicate, path, "variable `last_active`: the " + maker + " makes a variable of this name");
  }

  const Library& library_;
  const std::set<std::string>& nameless_;
  std::vector<Error>& errors_;
  std::set<const State*> resumed_;
};

}  // namespace

void check_structure(const Document& document, bool has_root, const Library& library,
                     const std::set<std::string>& nameless, std::vector<Error>& errors) {
  Structure(library, nameless, errors).check_document(document, has_root);
}

}  // namespace race::rcm
