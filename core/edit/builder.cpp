#include "core/edit/builder.h"

#include "core/edit/apply.h"
#include "core/rcm/ids.h"
#include "core/value/fields.h"

namespace race::edit {

void Builder::add(Operation operation) {
  if (error_) return;
  auto applied = edit::apply(tree_, operation);
  if (!applied) return fail(std::move(applied).error());
  edit_.operations.push_back(std::move(operation));
}

void Builder::set(std::string_view id, std::string_view field, std::optional<Value> value) {
  const Element* element = tree_.find(id);
  const Value json = element ? write_content(element->content, element->list.value_or(ListName::children)) : Value();
  const Value* old = json.find(field);
  if (old ? value == *old : !value) return;
  add(Set{std::string(id), std::string(field), std::nullopt, std::move(value)});
}

void Builder::fail(Error error) {
  if (!error_) error_ = std::move(error);
}

Expected<Edit> Builder::take() {
  if (error_) return tl::unexpected(*std::move(error_));
  if (edit_.operations.size() > kMaxOperations)
    return unexpected(ErrorCode::too_large, "more than " + std::to_string(kMaxOperations) + " operations");
  freeze(edit_);
  return std::move(edit_);
}

NewIds::NewIds(const Tree& tree, std::string_view seed) : tree_(tree), seed_(seed.empty() ? "-" : seed) {}

std::string NewIds::operator()(std::string_view role) {
  const auto is_taken = [&](const std::string& id) {
    const Value* notes = tree_.fields().meta.find("notes");
    return tree_.find(id) || taken_.contains(id) || tree_.fields().layout.find(id) || (notes && notes->find(id));
  };
  std::string id = rcm::derived_id(seed_, role);
  for (int attempt = 1; is_taken(id); ++attempt)
    id = rcm::derived_id(seed_, std::string(role) + ":" + std::to_string(attempt));
  taken_.insert(id);
  return id;
}

const rcm::State* state_of(const Tree& tree, std::string_view id) {
  const Element* element = tree.find(id);
  return element ? std::get_if<rcm::State>(&element->content) : nullptr;
}

std::string behaviour_of(const Tree& tree, std::string_view id) {
  std::string out(id);
  for (std::size_t links = 0; links <= tree.size(); ++links) {
    const rcm::State* state = state_of(tree, out);
    if (!state || !state->link) return state ? out : std::string();
    out = find_by_name(tree, "", ListName::library, *state->link);
  }
  return {};
}

const std::string& name_of(const Tree& tree, std::string_view id) { return name_of(tree.find(id)->content); }

std::string find_by_name(const Tree& tree, std::string_view parent, ListName list, std::string_view name) {
  for (const std::string& id : tree.list(parent, list)) {
    if (name_of(tree, id) == name) return id;
  }
  return {};
}

std::string free_name(const Tree& tree, std::string_view parent, ListName list, const std::string& wanted) {
  std::string out = wanted;
  for (int number = 2; !find_by_name(tree, parent, list, out).empty(); ++number) out = wanted + std::to_string(number);
  return out;
}

tl::unexpected<Error> no_element(std::string_view id, std::string_view argument) {
  return unexpected(ErrorCode::not_found, "there is no element `" + std::string(id) + "`", std::string(argument));
}

Expected<void> check_new_name(const Tree& tree, std::string_view parent, ListName list, std::string_view name) {
  if (!is_name(name)) return unexpected(ErrorCode::name, "`" + std::string(name) + "` is no name", "name");
  if (!find_by_name(tree, parent, list, name).empty())
    return unexpected(ErrorCode::duplicate, "there is a `" + std::string(name) + "` already", "name");
  return {};
}

}  // namespace race::edit
