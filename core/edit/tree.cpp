#include "core/edit/tree.h"

#include <algorithm>
#include <utility>

#include "core/edit/extent.h"
#include "core/value/fields.h"

namespace race::edit {
namespace {

const Ids kNone;

struct Identified {
  std::string id;
  Element element;
};

std::string described(const Content& content) {
  const std::string& name = name_of(content);
  return name.empty() ? "an action" : "`" + name + "`";
}

/// Takes a node apart: `node` and all below it, parents first.
Expected<void> flatten(Content node, const std::string& parent, std::optional<ListName> list,
                       std::vector<Identified>& out) {
  std::string id = meta_of(node).id;
  if (id.empty()) return unexpected(ErrorCode::missing, described(node) + " has no `meta.id`");
  auto* state = std::get_if<rcm::State>(&node);
  std::vector<std::pair<ListName, Content>> inner;
  if (state) {
    for_each_element(*state, [&](ListName at, auto& element) { inner.emplace_back(at, std::move(element)); });
    state->parameters.clear();
    state->results.clear();
    state->variables.clear();
    state->actions.clear();
    state->children.clear();
    state->ports.clear();
  }
  const std::size_t own = out.size();
  out.push_back({id, Element{parent, list, std::move(node), {}}});
  for (auto& [at, element] : inner) {
    out[own].element.lists[static_cast<std::size_t>(at)].push_back(meta_of(element).id);
    if (auto added = flatten(std::move(element), id, at, out); !added) return added;
  }
  return {};
}

void reserve(rcm::State& state, const std::array<Ids, kListCount>& lists) {
  const auto size = [&](ListName list) { return lists[static_cast<std::size_t>(list)].size(); };
  state.parameters.reserve(size(ListName::parameters));
  state.results.reserve(size(ListName::results));
  state.variables.reserve(size(ListName::variables));
  state.actions.reserve(size(ListName::actions));
  state.children.reserve(size(ListName::children));
  state.ports.reserve(size(ListName::ports));
}

/// Adds what is in the lists of `element` to its state.
void fill(rcm::State& state, const Element& element, const Tree& tree) {
  reserve(state, element.lists);
  for (std::size_t i = 0; i < element.lists.size(); ++i) {
    for (const std::string& id : element.lists[i]) {
      const Element& inner = *tree.find(id);
      if (const auto* child = std::get_if<rcm::State>(&inner.content)) {
        fill(std::get<rcm::State>(state.children.emplace_back(*child)), inner, tree);
      } else {
        append(state, static_cast<ListName>(i), inner.content);
      }
    }
  }
}

}  // namespace

Expected<Tree> Tree::read(const rcm::Document& document, std::optional<JsonLimits> one_line) {
  Tree out;
  out.one_line_ = one_line;
  out.fields_.name = document.name;
  out.fields_.services = document.services;
  out.fields_.layout = document.layout;
  out.fields_.meta = document.meta;
  out.text_bound_ = edit::text_bound(document.name, document.layout) + edit::text_bound("", document.meta);
  for (const auto& [key, type] : document.services) out.text_bound_ += edit::text_bound(key, Value(type));
  out.root_ = document.root.meta.id;
  if (auto added = out.add(document.root, "", std::nullopt); !added) return tl::unexpected(added.error());
  for (const rcm::State& state : document.library) {
    if (auto added = out.add(state, "", ListName::library); !added) return tl::unexpected(added.error());
    out.library_.push_back(state.meta.id);
  }
  return out;
}

Expected<void> Tree::add(Content node, const std::string& parent, std::optional<ListName> list) {
  std::vector<Identified> added;
  if (auto flat = flatten(std::move(node), parent, list, added); !flat) return flat;
  for (std::size_t i = 0; i < added.size(); ++i) {
    text_bound_ += edit::text_bound(added[i].element.content);
    if (elements_.try_emplace(added[i].id, std::move(added[i].element)).second) continue;
    for (std::size_t k = 0; k < i; ++k) elements_.erase(added[k].id);
    return unexpected(ErrorCode::duplicate, "an element has the id `" + added[i].id + "` already");
  }
  return {};
}

rcm::Document Tree::document() const {
  rcm::Document out = fields_;
  out.root = std::get<rcm::State>(compose(*find(root_)));
  out.library.reserve(library_.size());
  for (const std::string& id : library_) out.library.push_back(std::get<rcm::State>(compose(*find(id))));
  return out;
}

Content Tree::compose(const Element& element) const {
  Content out = element.content;
  if (auto* state = std::get_if<rcm::State>(&out)) fill(*state, element, *this);
  return out;
}

const Element* Tree::find(std::string_view id) const {
  const auto found = elements_.find(id);
  return found == elements_.end() ? nullptr : &found->second;
}

Element* Tree::mutable_find(std::string_view id) {
  const auto found = elements_.find(id);
  return found == elements_.end() ? nullptr : &found->second;
}

const Ids& Tree::list(std::string_view parent, ListName list) const {
  if (parent.empty()) return list == ListName::library ? library_ : kNone;
  const Element* state = find(parent);
  return state ? state->lists[static_cast<std::size_t>(list)] : kNone;
}

Ids& Tree::ids(const std::string& parent, ListName list) {
  return parent.empty() ? library_ : mutable_find(parent)->lists[static_cast<std::size_t>(list)];
}

std::optional<std::string> Tree::before(std::string_view id) const {
  const Element* element = find(id);
  const Ids& siblings = list(element->parent, *element->list);
  const auto own = std::ranges::find(siblings, id);
  if (own == siblings.begin()) return std::nullopt;
  return *std::prev(own);
}

bool Tree::is_below(std::string_view ancestor, std::string_view id) const {
  for (const Element* at = find(id); at; at = find(at->parent)) {
    if (meta_of(at->content).id == ancestor) return true;
  }
  return false;
}

Ids Tree::subtree(std::string_view id) const {
  Ids out{std::string(id)};
  for (const Ids& list : find(id)->lists) {
    for (const std::string& inner : list) {
      const Ids below = subtree(inner);
      out.insert(out.end(), below.begin(), below.end());
    }
  }
  return out;
}

Value Tree::write(std::string_view id) const {
  const Element& element = *find(id);
  return write_content(compose(element), element.list.value_or(ListName::children));
}

std::size_t Tree::level(std::string_view parent, std::optional<ListName> list) const {
  if (parent.empty()) return list ? kLibraryLevel : kRootLevel;
  const Element& state = *find(parent);
  return level(state.parent, state.list) + 2;
}

Expected<void> Tree::check_level(const Value& value, std::size_t level) const {
  const std::size_t limit = one_line_.value_or(JsonLimits{}).depth;
  if (level <= limit && !deeper_than(value, limit + 1 - level)) return {};
  return unexpected(ErrorCode::too_deep, "the text of the document would have more than " + std::to_string(limit) +
                                             " levels of lists and objects");
}

Expected<std::size_t> Tree::position(const Place& place, std::string_view moved) const {
  if (place.parent.empty() != (place.list == ListName::library))
    return unexpected(ErrorCode::type, "`library` is the list of the document, the others are lists of states", "list");
  if (!place.parent.empty()) {
    const Element* parent = find(place.parent);
    if (!parent) return unexpected(ErrorCode::not_found, "there is no element `" + place.parent + "`", "parent");
    if (!std::holds_alternative<rcm::State>(parent->content))
      return unexpected(ErrorCode::type, "`" + place.parent + "` is no state: it has no lists", "parent");
  }
  if (!place.after) return 0;
  const Ids& siblings = list(place.parent, place.list);
  const auto sibling = std::ranges::find(siblings, *place.after);
  if (sibling == siblings.end() || *place.after == moved)
    return unexpected(ErrorCode::not_found, "there is no element `" + *place.after + "` in this list", "after");
  return static_cast<std::size_t>(sibling - siblings.begin()) + 1;
}

void Tree::unlist(const Element& element, std::string_view id) { std::erase(ids(element.parent, *element.list), id); }

Expected<Operation> Tree::insert(const Insert& insert) {
  const Place& place = insert.place;
  ASSIGN_OR_RETURN(const std::size_t at, position(place, {}));
  if (auto fits = check_level(insert.node, level(place.parent, place.list)); !fits)
    return unexpected(fits.error().code, fits.error().message, "node");
  auto node = read_content(insert.node, place.list);
  if (!node) return unexpected(node.error().code, node.error().message, "node");
  const std::string id = meta_of(*node).id;
  if (auto added = add(std::move(*node), place.parent, place.list); !added)
    return unexpected(added.error().code, added.error().message, "node");
  Ids& siblings = ids(place.parent, place.list);
  siblings.insert(siblings.begin() + static_cast<std::ptrdiff_t>(at), id);
  return Remove{id};
}

Expected<Operation> Tree::remove(const Remove& remove) {
  const Element* element = find(remove.id);
  if (!element) return unexpected(ErrorCode::not_found, "there is no element `" + remove.id + "`", "id");
  if (!element->list) return unexpected(ErrorCode::not_accepted, "a document has a root", "id");
  Insert inverse{{element->parent, *element->list, before(remove.id)}, write(remove.id)};
  unlist(*element, remove.id);
  for (const std::string& id : subtree(remove.id)) elements_.erase(id);
  return inverse;
}

Expected<Operation> Tree::move(const Move& move) {
  Element* element = mutable_find(move.id);
  if (!element) return unexpected(ErrorCode::not_found, "there is no element `" + move.id + "`", "id");
  if (!element->list) return unexpected(ErrorCode::not_accepted, "the root cannot be moved", "id");
  ASSIGN_OR_RETURN(std::size_t at, position(move.place, move.id));
  if (is_below(move.id, move.place.parent))
    return unexpected(ErrorCode::not_accepted, "`" + move.id + "` cannot be moved into itself", "parent");
  const bool is_state = std::holds_alternative<rcm::State>(element->content);
  const bool was_node = element->list == ListName::children || element->list == ListName::library;
  const bool to_node = move.place.list == ListName::children || (move.place.list == ListName::library && is_state);
  if (was_node ? !to_node : move.place.list != *element->list)
    return unexpected(ErrorCode::type, "is no element of the list `" + std::string(name(move.place.list)) + "`",
                      "list");
  const std::size_t new_level = level(move.place.parent, move.place.list);
  if (new_level > level(element->parent, element->list)) {
    if (auto fits = check_level(write(move.id), new_level); !fits)
      return unexpected(fits.error().code, fits.error().message, "parent");
    for (const std::string& id : subtree(move.id)) text_bound_ += edit::text_bound(find(id)->content);
  }
  Move inverse{move.id, {element->parent, *element->list, before(move.id)}};
  unlist(*element, move.id);
  element->parent = move.place.parent;
  element->list = move.place.list;
  at = *position(move.place, move.id);  // the list may have been its own
  Ids& siblings = ids(move.place.parent, move.place.list);
  siblings.insert(siblings.begin() + static_cast<std::ptrdiff_t>(at), move.id);
  return inverse;
}

}  // namespace race::edit
