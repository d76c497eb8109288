#include "core/edit/element.h"

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
rcm::State holder(ListName list, const Content& element) {
  rcm::State out;
  out.name = "S";
  append(out, list, element);
  return out;
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

void append(rcm::State& state, ListName list, const Content& element) {
  std::visit(Overloaded{[&](const rcm::State& e) { state.children.emplace_back(e); },
                        [&](const rcm::Barrier& e) { state.children.emplace_back(e); },
                        [&](const rcm::Parameter& e) { state.parameters.push_back(e); },
                        [&](const rcm::Datum& e) {
                          (list == ListName::results ? state.results : state.variables).push_back(e);
                        },
                        [&](const rcm::Action& e) { state.actions.push_back(e); },
                        [&](const rcm::Port& e) { state.ports.push_back(e); }},
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
  auto element = take_element(draft.document.root);
  if (!element || (list == ListName::library && !std::holds_alternative<rcm::State>(*element)))
    return unexpected(ErrorCode::type, "is no element of the list `" + std::string(name(list)) + "`");
  return std::move(*element);
}

}  // namespace race::edit
