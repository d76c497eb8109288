#include "core/rcm/translate.h"

#include "core/rcm/after.h"
#include "core/rcm/constraints.h"
#include "core/rcm/deep_history.h"
#include "core/rcm/ids.h"
#include "core/rcm/library.h"
#include "core/rcm/oracle.h"
#include "core/rcm/path.h"

namespace race::rcm {
namespace {

/// What ids become: of the document itself, native elements have the same; of what a link takes over, derived from the
/// link's, so that each of several links to a state has its own.
class NativeIds {
 public:
  explicit NativeIds(DerivedIds& derived) : derived_(derived) {}
  /// Below a link with this native id; without one, no element has an id.
  NativeIds below(std::string link) const {
    NativeIds out(derived_);
    out.link_ = std::move(link);
    return out;
  }

  std::string native(const std::string& id) const { return link_ ? derived_(*link_, id) : id; }
  void make_native(Meta& meta) const {
    if (link_) meta.id = native(meta.id);
  }
  /// Of the elements of the state, without children; the state's own is `id`.
  void make_native(State& state, const std::string& id) const {
    state.meta.id = id;
    if (!link_) return;
    for (Parameter& parameter : state.parameters) make_native(parameter.meta);
    for (Datum& result : state.results) make_native(result.meta);
    for (Datum& variable : state.variables) make_native(variable.meta);
    for (Action& action : state.actions) make_native(action.meta);
    for (Port& port : state.ports) make_native(port.meta);
  }

 private:
  DerivedIds& derived_;
  std::optional<std::string> link_;
};

class Translation {
 public:
  Translation(const Document& document, NativeModel& model)
      : library_(document), derived_(document), origin_(model.origin) {}

  State translate_root(const State& root) {
    const std::string path = node_path("", root.name);
    return translate_state(root, root.meta.id, path, path, NativeIds(derived_), false);
  }

 private:
  /// The native form of the state with the path `from` in the document and, in the native model, the path `path` and
  /// the id `id`; `inside`: its parent resumes by a deep history.
  State translate_state(const State& state, const std::string& id, const std::string& path, const std::string& from,
                        const NativeIds& ids, bool inside) {
    return state.link ? follow_link(state, id, path, from, ids, inside) : expand(state, id, path, from, ids, inside);
  }

  /// 3.3.1: everything of the library state, but for the name, the expressions and the destinations of the link.
  State follow_link(const State& state, const std::string& id, const std::string& path, const std::string& from,
                    const NativeIds& ids, bool inside) {
    State own = state;
    ids.make_native(own, id);
    State out = translate_state(*library_.find(*own.link), id, path, library_path(*own.link), ids.below(id), inside);
    out.name = own.name;
    if (!own.doc.empty()) out.doc = own.doc;
    out.meta = merged_meta(out.meta, own.meta);
    const auto parameters = by_name(out.parameters);
    for (const Parameter& parameter : own.parameters) override_parameter(*parameters.at(parameter.name), parameter);
    const auto ports = by_name(out.ports);
    for (const Port& own_port : own.ports) {
      Port& port = *ports.at(own_port.name);
      port.to = own_port.to;
      port.meta = merged_meta(port.meta, own_port.meta);
      origin_[port_path(path, port.name)] = port_path(from, port.name);
    }
    origin_[path] = from;
    return out;
  }

  State expand(const State& state, const std::string& id, const std::string& path, const std::string& from,
               const NativeIds& ids, bool inside) {
    State out = without_children(state);
    ids.make_native(out, id);
    out.oracle = oracle_of(state, inside);
    const bool inside_deep = is_deep(out.oracle);
    origin_[path] = from;
    for (const Port& port : state.ports) origin_[port_path(path, port.name)] = port_path(from, port.name);
    for (const Node& child : state.children) {
      const std::string at = node_path(path, name_of(child)), origin = node_path(from, name_of(child));
      if (const auto* inner = std::get_if<State>(&child)) {
        out.children.emplace_back(translate_state(*inner, ids.native(inner->meta.id), at, origin, ids, inside_deep));
      } else {
        origin_[at] = origin;
        out.children.push_back(child);
        ids.make_native(std::get<Barrier>(out.children.back()).meta);
      }
    }
    if (out.oracle) decide(out, path, from);
    wait(out, path, from);
    return out;
  }

  /// 3.3.2: the dispatcher comes from the composite.
  void decide(State& composite, const std::string& path, const std::string& from) {
    translate_oracle(composite, derived_);
    const State& made = std::get<State>(composite.children.front());
    const std::string at = node_path(path, made.name);
    origin_[at] = from;
    for (const Port& port : made.ports) origin_[port_path(at, port.name)] = from;
  }

  /// What the `after` of the ports make comes from the ports, their barrier from the state.
  void wait(State& state, const std::string& path, const std::string& from) {
    for (const Port& port : state.ports) {
      if (!port.after) continue;
      const std::string at = node_path(path, after_name(port.name)), origin = port_path(from, port.name);
      origin_[at] = origin;
      origin_[port_path(at, kDue)] = origin;
    }
    if (has_after_barrier(state)) origin_[node_path(path, kAfterBarrier)] = from;
    translate_after(state, derived_);
  }

  template <typename Element>
  static std::map<std::string_view, Element*> by_name(std::vector<Element>& elements) {
    std::map<std::string_view, Element*> out;
    for (Element& element : elements) out.emplace(element.name, &element);
    return out;
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
  DerivedIds derived_;
  std::map<std::string, std::string>& origin_;
};

}  // namespace

Checked<NativeModel> translate(const Document& document) {
  auto errors = violations(document);
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  NativeModel out;
  out.root = Translation(document, out).translate_root(document.root);
  return out;
}

}  // namespace race::rcm
