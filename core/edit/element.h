// Elements: the nodes of the tree that a document is to its edits. The fields of an element stay in the types of
// core/rcm; its JSON is read and written by the codec of documents, one element at a time. Pure functions.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/edit/operation.h"
#include "core/rcm/model.h"
#include "core/value/expected.h"

namespace race::edit {

/// Of a state, its lists are empty here if it is an element of a Tree, and filled if it is a whole node.
using Content = std::variant<rcm::State, rcm::Barrier, rcm::Parameter, rcm::Datum, rcm::Action, rcm::Port>;

rcm::Meta& meta_of(Content& content);
const rcm::Meta& meta_of(const Content& content);

/// The name of an element; empty for an action.
const std::string& name_of(const Content& content);

/// The field that holds the name: `state`, `barrier` or `name`; empty for an action.
std::string_view name_field(const Content& content);

/// As the format has it, with its id and all that `content` holds. `list`: where it stands; the root: in `children`.
Value write_content(const Content& content, ListName list);

/// Reads what write_content writes. Errors: those of rcm::read_draft, and `type` if it is no element of such a list.
Expected<Content> read_content(const Value& json, ListName list);

/// Calls visit(list, element) for every element in the lists of `state`, in the order of the format.
template <typename AnyState, typename Visit>
void for_each_element(AnyState& state, Visit&& visit) {
  for (auto& parameter : state.parameters) visit(ListName::parameters, parameter);
  for (auto& result : state.results) visit(ListName::results, result);
  for (auto& variable : state.variables) visit(ListName::variables, variable);
  for (auto& action : state.actions) visit(ListName::actions, action);
  for (auto& child : state.children) std::visit([&](auto& node) { visit(ListName::children, node); }, child);
  for (auto& port : state.ports) visit(ListName::ports, port);
}

/// Adds an element to the end of a list. Requires an element of that list.
void append(rcm::State& state, ListName list, const Content& element);

}  // namespace race::edit
