// Where ports and barriers lead to.
#include <algorithm>

#include "core/edit/builder.h"
#include "core/edit/compound.h"

namespace race::edit {
namespace {

/// Whether `id` is a child of `parent`, as what a port of a sibling leads to.
bool is_child(const Tree& tree, std::string_view parent, std::string_view id) {
  const Element* element = tree.find(id);
  return element && element->list == ListName::children && element->parent == parent;
}

Value texts(const std::vector<std::string>& names) { return List(names.begin(), names.end()); }

}  // namespace

Expected<Edit> connect(const Tree& tree, std::string_view from, std::optional<std::string_view> to) {
  const Element* source = tree.find(from);
  if (!source) return no_element(from, "from");
  if (to && !tree.find(*to)) return no_element(*to, "to");
  Builder builder(tree);
  if (source->list == ListName::ports) {
    if (to && !is_child(tree, tree.find(source->parent)->parent, *to))
      return unexpected(ErrorCode::port_target, "a port leads to a sibling of its state", "to");
    builder.set(from, "to", to ? std::optional<Value>(name_of(tree, *to)) : std::nullopt);
    return builder.take();
  }
  const auto* barrier = std::get_if<rcm::Barrier>(&source->content);
  if (!barrier || !to) return unexpected(ErrorCode::not_accepted, "a port or a barrier leads to a state", "from");
  if (!is_child(tree, source->parent, *to) || !state_of(tree, *to))
    return unexpected(ErrorCode::barrier_target, "a barrier leads to sibling states", "to");
  std::vector<std::string> targets = barrier->to;
  const std::string& name = name_of(tree, *to);
  if (std::ranges::find(targets, name) == targets.end()) targets.push_back(name);
  builder.set(from, "to", texts(targets));
  return builder.take();
}

Expected<Edit> disconnect(const Tree& tree, std::string_view barrier, std::string_view state) {
  const Element* source = tree.find(barrier);
  if (!source) return no_element(barrier, "barrier");
  if (!state_of(tree, state)) return no_element(state, "state");
  const auto* content = std::get_if<rcm::Barrier>(&source->content);
  if (!content) return unexpected(ErrorCode::not_accepted, "is no barrier", "barrier");
  std::vector<std::string> targets = content->to;
  std::erase(targets, name_of(tree, state));
  Builder builder(tree);
  builder.set(barrier, "to", texts(targets));
  return builder.take();
}

}  // namespace race::edit
