// Renaming elements and services with all that names them.
#include <algorithm>
#include <iterator>

#include "core/edit/builder.h"
#include "core/edit/compound.h"
#include "core/edit/references.h"
#include "core/rcm/after.h"
#include "core/rcm/document.h"
#include "core/value/fields.h"

namespace race::edit {
namespace {

using Path = std::vector<std::string>;

Ids states_of(const Tree& tree) {
  Ids out;
  tree.for_each([&](const Element& element) {
    if (std::holds_alternative<rcm::State>(element.content)) out.push_back(meta_of(element.content).id);
  });
  return out;
}

/// Of all states, each once.
std::vector<CodeText> all_texts(const Tree& tree) {
  std::vector<CodeText> out;
  for (const std::string& id : states_of(tree)) std::ranges::move(texts_in_scope(tree, id), std::back_inserter(out));
  return out;
}

class Renaming {
 public:
  Renaming(const Tree& tree, std::string old, std::string_view name)
      : builder_(tree), old_(std::move(old)), name_(name) {}

  Expected<Edit> take() { return builder_.take(); }
  const Tree& tree() const { return builder_.tree(); }

  void element(std::string_view id, ListName list, const std::string& parent) {
    builder_.set(id, name_field(tree().find(id)->content), Value(name_));
    switch (list) {
      case ListName::children:
        return child(parent);
      case ListName::library:
        return links();
      case ListName::ports:
        port_lists(parent);
        waiting_state(id, parent);
        return of_state(parent, "port", ListName::ports);
      case ListName::parameters:
        return of_state(parent, "par", list);
      case ListName::results:
        return of_state(parent, "res", std::nullopt);
      case ListName::variables:
        return in_scope(parent, {"var", old_});
      case ListName::actions:
        return;
    }
  }

  /// Renames the last name of `path` in all texts of a scope.
  void in_scope(std::string_view state, const Path& path) { in_scope(state, path, name_); }
  void in_scope(std::string_view state, const Path& path, const std::string& name) {
    for (const CodeText& text : texts_in_scope(tree(), state)) in_text(text, path, name);
    for (const auto& [link, text] : taken_over_texts(tree(), state)) {
      if (!replacements_in(text, path, name).empty())
        builder_.fail({ErrorCode::scope,
                       "its parameter " + quote(name_of(tree(), text.id)) + " names " + quote(old_) + " in the library",
                       link});
    }
  }

  void services() {
    if (old_ == rcm::kTimer) keep_time_outs();
    const auto& services = tree().fields().services;
    if (const auto entry = services.find(old_); entry != services.end()) {
      builder_.add(Set{"", "services", name_, Value(entry->second)});
      builder_.add(Set{"", "services", old_, std::nullopt});
    }
    for (const CodeText& text : all_texts(tree())) in_text(text, {"svc", old_}, name_);
  }

 private:
  /// Translation makes calls of the service with this key.
  void keep_time_outs() {
    tree().for_each([&](const Element& element) {
      const auto* port = std::get_if<rcm::Port>(&element.content);
      if (port && port->after)
        builder_.fail({ErrorCode::not_accepted, "the time-out of a port calls `svc.timer`", port->meta.id});
    });
  }

  void in_text(const CodeText& text, const Path& path, const std::string& name) {
    auto replacements = replacements_in(text, path, name);
    if (!replacements.empty())
      builder_.set(text.id, text.field, field_with(tree(), text, replaced(text.text, std::move(replacements))));
  }

  std::vector<Replacement> replacements_in(const CodeText& text, const Path& path, const std::string& name) {
    const References references = references_in(text);
    if (!references.is_parsed) unparsed(text);
    std::vector<Replacement> out;
    for (const Reference& reference : references.found) {
      if (reference.begins_with(path)) out.push_back(with_name(text.text, reference, path.size() - 1, name));
    }
    return out;
  }

  void unparsed(const CodeText& text) {
    if (text.text.find(old_) == std::string::npos) return;
    builder_.fail({ErrorCode::syntax, "`" + text.field + "` cannot be parsed and may name `" + old_ + "`", text.id});
  }

  void child(const std::string& parent) {
    for (const std::string& sibling : Ids(tree().list(parent, ListName::children))) {
      for (const std::string& port : Ids(tree().list(sibling, ListName::ports))) {
        if (std::get<rcm::Port>(tree().find(port)->content).to == old_) builder_.set(port, "to", Value(name_));
      }
      if (const auto* barrier = std::get_if<rcm::Barrier>(&tree().find(sibling)->content))
        builder_.set(sibling, "to", renamed(barrier->to));
    }
    const rcm::State& composite = *state_of(tree(), parent);
    if (composite.first == old_) builder_.set(parent, "first", Value(name_));
    in_scope(parent, {"chi", old_});
    const auto& oracle = state_of(tree(), parent)->oracle;
    if (!oracle || oracle->kind != rcm::Oracle::Kind::expr) return;
    const std::string text = replaced(oracle->text, renamed_values(oracle->text, old_, name_));
    builder_.set(parent, "oracle", Dict{{"kind", "expr"}, {"expr", text}});
  }

  void links() {
    for (const std::string& id : states_of(tree())) {
      if (state_of(tree(), id)->link == old_) builder_.set(id, "link", Value(name_));
    }
  }

  void port_lists(const std::string& parent) {
    rcm::State state = *state_of(tree(), parent);
    const auto rename_in = [&](std::vector<std::string>& ports) { std::ranges::replace(ports, old_, name_); };
    if (state.keep) rename_in(state.keep->ports);
    if (state.oracle && state.oracle->resume) rename_in(*state.oracle->resume);
    const Value json = rcm::write_state(state);
    if (state.keep && !state.keep->ports.empty()) builder_.set(parent, "keep", *json.find("keep"));
    if (state.oracle && state.oracle->resume) builder_.set(parent, "oracle", *json.find("oracle"));
  }

  /// The state that waits for the time of a port with `after` is named after the port.
  void waiting_state(std::string_view port, const std::string& state) {
    if (!std::get<rcm::Port>(tree().find(port)->content).after) return;
    in_scope(state, {"chi", rcm::after_name(old_)}, rcm::after_name(name_));
  }

  /// A port, parameter or result of a state: in its own texts, in those of its parent, and the same for the states that
  /// link it. `overridden`: the list in which a link may have it, too.
  void of_state(const std::string& state, const std::string& collection, std::optional<ListName> overridden) {
    in_scope(state, {collection, old_});
    for (const std::string& user : users_of(state)) {
      const Element& element = *tree().find(user);
      if (element.list == ListName::children)
        in_scope(element.parent, {"chi", name_of(tree(), user), collection, old_});
      if (user == state || !overridden) continue;
      const std::string own = find_by_name(tree(), user, *overridden, old_);
      if (!own.empty()) builder_.set(own, "name", Value(name_));
    }
  }

  /// `state` and all states whose links lead to it.
  Ids users_of(const std::string& state) const {
    Ids out{state};
    for (std::size_t i = 0; i < out.size(); ++i) {
      const Element& user = *tree().find(out[i]);
      if (user.list != ListName::library) continue;
      for (const std::string& id : states_of(tree())) {
        if (state_of(tree(), id)->link == name_of(user.content) && std::ranges::find(out, id) == out.end())
          out.push_back(id);
      }
    }
    return out;
  }

  Value renamed(const std::vector<std::string>& names) const {
    List out;
    for (const std::string& one : names) out.emplace_back(one == old_ ? name_ : one);
    return out;
  }

  Builder builder_;
  const std::string old_, name_;
};

bool uses(const CodeText& text, const Path& path) {
  return std::ranges::any_of(references_in(text).found, [&](const Reference& r) { return r.begins_with(path); });
}

/// Whether code of the scope names an undeclared variable `name`.
bool uses_variable(const Tree& tree, std::string_view state, std::string_view name) {
  const Path path{"var", std::string(name)};
  return std::ranges::any_of(texts_in_scope(tree, state), [&](const CodeText& text) { return uses(text, path); }) ||
         std::ranges::any_of(taken_over_texts(tree, state), [&](const TakenOver& t) { return uses(t.text, path); });
}

/// Whether code names a service `name`, which need not be declared.
bool uses_service(const Tree& tree, std::string_view name) {
  const Path path{"svc", std::string(name)};
  return std::ranges::any_of(all_texts(tree), [&](const CodeText& text) { return uses(text, path); });
}

}  // namespace

Expected<Edit> rename(const Tree& tree, std::string_view id, std::string_view name) {
  const Element* element = tree.find(id);
  if (!element) return no_element(id, "id");
  if (name_field(element->content).empty()) return unexpected(ErrorCode::not_accepted, "an action has no name", "id");
  const std::string& old = name_of(element->content);
  if (old == name) return Edit{};
  const ListName list = element->list.value_or(ListName::actions);  // nothing refers to the root
  const std::string parent = element->parent;
  const rcm::State* owner = state_of(tree, parent);
  if (owner && owner->link && (list == ListName::ports || list == ListName::parameters))
    return unexpected(list == ListName::ports ? ErrorCode::link_port : ErrorCode::link_parameter,
                      "`" + old + "` is what `" + *owner->link + "` of the library calls it", "id");
  if (auto fits = check_new_name(tree, parent, list, name); !fits) return tl::unexpected(fits.error());
  if (list == ListName::variables && uses_variable(tree, parent, name))
    return unexpected(ErrorCode::duplicate, "code uses a variable `" + std::string(name) + "` already", "name");
  Renaming renaming(tree, old, name);
  renaming.element(id, list, parent);
  return renaming.take();
}

Expected<Edit> rename_service(const Tree& tree, std::string_view key, std::string_view name) {
  if (!is_name(name)) return unexpected(ErrorCode::name, "`" + std::string(name) + "` is no name", "name");
  if (key == name) return Edit{};
  if (tree.fields().services.contains(std::string(name)) || uses_service(tree, name))
    return unexpected(ErrorCode::duplicate, "there is a service `" + std::string(name) + "` already", "name");
  Renaming renaming(tree, std::string(key), name);
  renaming.services();
  auto edit = renaming.take();
  if (edit && edit->operations.empty())
    return unexpected(ErrorCode::not_found, "there is no service `" + std::string(key) + "`", "key");
  return edit;
}

}  // namespace race::edit
