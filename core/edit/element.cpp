#include "core/edit/element.h"

#include <type_traits>
#include <utility>

#include "core/rcm/document.h"

namespace race::edit {
namespace {

template <typename... Visits>
struct Overloaded : Visits... {
  using Visits::operator()...;
};
template <typename... Visits>
Overloaded(Visits...) -> Overloaded<Visits...>;

const std::string kNoName;

/// A state with one element in one list is how the codec of documents gets to see a single element.
rcm::State holder(ListName list, Content element) {
  rcm::State out;
  out.name = "S";
  append(out, list, std::move(element));
  return out;
}

void normalize_metas(rcm::State& state) {
  normalize_entries(state.meta.rest);
  for_each_element(state, [](ListName, auto& element) {
    if constexpr (std::is_same_v<std::remove_reference_t<decltype(element)>, rcm::State>) {
      normalize_metas(element);
    } else {
      normalize_entries(element.meta.rest);
    }
  });
}

/// The only element of `state`.
std::optional<Content> take_element(rcm::State& state) {
  std::optional<Content> out;
  for_each_element(state, [&](ListName, auto& element) { out.emplace(std::move(element)); });
  return out;
}

}  // namespace

rcm::Meta& meta_of(Content& content) {
  return std::visit([](auto& element) -> rcm::Meta& { return element.meta; }, content);
}

const rcm::Meta& meta_of(const Content& content) {
  return std::visit([](const auto& element) -> const rcm::Meta& { return element.meta; }, content);
}

const std::string& name_of(const Content& content) {
  return std::visit(Overloaded{[](const rcm::Action&) -> const std::string& { return kNoName; },
                               [](const auto& element) -> const std::string& { return element.name; }},
                    content);
}

std::string_view name_field(const Content& content) {
  return std::visit(Overloaded{[](const rcm::State&) { return std::string_view("state"); },
                               [](const rcm::Barrier&) { return std::string_view("barrier"); },
                               [](const rcm::Action&) { return std::string_view(); },
                               [](const auto&) { return std::string_view("name"); }},
                    content);
}

void append(rcm::State& state, ListName list, Content element) {
  std::visit(Overloaded{[&](rcm::State& e) { state.children.emplace_back(std::move(e)); },
                        [&](rcm::Barrier& e) { state.children.emplace_back(std::move(e)); },
                        [&](rcm::Parameter& e) { state.parameters.push_back(std::move(e)); },
                        [&](rcm::Datum& e) {
                          (list == ListName::results ? state.results : state.variables).push_back(std::move(e));
                        },
                        [&](rcm::Action& e) { state.actions.push_back(std::move(e)); },
                        [&](rcm::Port& e) { state.ports.push_back(std::move(e)); }},
             element);
}

Value write_content(const Content& content, ListName list) {
  if (const auto* state = std::get_if<rcm::State>(&content)) return rcm::write_state(*state);
  const ListName shown = list == ListName::library ? ListName::children : list;
  const Value json = rcm::write_state(holder(shown, content));
  return json.find(name(shown))->as_list().front();
}

Expected<Content> read_content(const Value& json, ListName list) {
  const ListName shown = list == ListName::library ? ListName::children : list;
  const Value document = Dict{{"rcm", 1}, {"root", Dict{{"state", "S"}, {name(shown), List{json}}}}};
  rcm::Draft draft = rcm::read_draft(document);
  if (!draft.errors.empty()) return tl::unexpected(std::move(draft.errors.front()));
  normalize_metas(draft.document.root);
  auto element = take_element(draft.document.root);
  if (!element || (list == ListName::library && !std::holds_alternative<rcm::State>(*element)))
    return unexpected(ErrorCode::type, "is no element of the list `" + std::string(name(list)) + "`");
  return std::move(*element);
}

void normalize_entries(Value& entries) {
  if (!entries.is_dict()) return;
  const Dict& dict = entries.as_dict();
  if (dict.empty()) {
    entries = Value();
  } else if (!dict.is_sorted()) {
    entries = dict.sorted();
  }
}

}  // namespace race::edit
