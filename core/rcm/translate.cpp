#include "core/rcm/translate.h"

#include "core/rcm/constraints.h"
#include "core/rcm/library.h"
#include "core/rcm/oracle.h"
#include "core/rcm/path.h"

namespace race::rcm {
namespace {

class Translation {
 public:
  Translation(const Document& document, NativeModel& model) : library_(document), origin_(model.origin) {}

  /// The native form of the state with the path `from` in the document and `path` in the native model.
  State translate_state(const State& state, const std::string& path, const std::string& from) {
    return state.link ? follow_link(state, path, from) : expand(state, path, from);
  }

 private:
  /// 3.3.1: everything of the library state, but for the name, the expressions and the destinations of the link.
  State follow_link(const State& state, const std::string& path, const std::string& from) {
    State out = translate_state(*library_.find(*state.link), path, library_path(*state.link));
    out.name = state.name;
    if (!state.doc.empty()) out.doc = state.doc;
    out.meta = merged_meta(out.meta, state.meta);
    out.parameters = library_.parameters(state);
    std::map<std::string_view, Port*> ports;
    for (Port& port : out.ports) ports.emplace(port.name, &port);
    for (const Port& own : state.ports) {
      Port& port = *ports.at(own.name);
      port.to = own.to;
      port.meta = merged_meta(port.meta, own.meta);
      origin_[port_path(path, own.name)] = port_path(from, own.name);
    }
    origin_[path] = from;
    return out;
  }

  State expand(const State& state, const std::string& path, const std::string& from) {
    State out = without_children(state);
    origin_[path] = from;
    for (const Port& port : state.ports) origin_[port_path(path, port.name)] = port_path(from, port.name);
    for (const Node& child : state.children) {
      const std::string at = node_path(path, name_of(child)), origin = node_path(from, name_of(child));
      if (const auto* inner = std::get_if<State>(&child)) {
        out.children.emplace_back(translate_state(*inner, at, origin));
      } else {
        origin_[at] = origin;
        out.children.push_back(child);
      }
    }
    if (state.oracle) decide(out, path, from);
    return out;
  }

  /// 3.3.2: the dispatcher comes from the composite.
  void decide(State& composite, const std::string& path, const std::string& from) {
    translate_oracle(composite);
    const State& made = std::get<State>(composite.children.front());
    const std::string at = node_path(path, made.name);
    origin_[at] = from;
    for (const Port& port : made.ports) origin_[port_path(at, port.name)] = from;
  }

  static State without_children(const State& state) {
    State out;
    out.name = state.name;
    out.doc = state.doc;
    out.parameters = state.parameters;
    out.results = state.results;
    out.variables = state.variables;
    out.entry = state.entry;
    out.exit = state.exit;
    out.actions = state.actions;
    out.first = state.first;
    out.ports = state.ports;
    out.keep = state.keep;
    out.oracle = state.oracle;
    out.meta = state.meta;
    return out;
  }

  Library library_;
  std::map<std::string, std::string>& origin_;
};

}  // namespace

Checked<NativeModel> translate(const Document& document) {
  auto errors = violations(document);
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  NativeModel out;
  const std::string root = node_path("", document.root.name);
  out.root = Translation(document, out).translate_state(document.root, root, root);
  return out;
}

}  // namespace race::rcm
