// From a state of the task to one of the library.
#include "core/edit/builder.h"
#include "core/edit/compound.h"

namespace race::edit {
namespace {

/// What a link says about a parameter or port of the state that it links.
Value overriding(std::string_view name, std::string_view field, const std::string& text, std::string id) {
  return Dict{{"name", name}, {field, text}, {"meta", Dict{{"id", std::move(id)}}}};
}

}  // namespace

Expected<Edit> extract(const Tree& tree, std::string_view id, std::string_view name, std::string_view seed) {
  const Element* element = tree.find(id);
  if (!element) return no_element(id, "id");
  const rcm::State* state = state_of(tree, id);
  if (!state || element->list != ListName::children || state->link)
    return unexpected(ErrorCode::not_accepted, "what goes to the library is a state inside of another, and no link",
                      "id");
  if (auto fits = check_new_name(tree, "", ListName::library, name); !fits) return tl::unexpected(fits.error());
  NewIds ids(tree, seed);
  Dict link{{"state", state->name}};
  List parameters, ports;
  Builder builder(tree);
  const Ids& library = tree.list("", ListName::library);
  builder.add(
      Move{std::string(id), {"", ListName::library, library.empty() ? std::nullopt : std::optional(library.back())}});
  builder.set(id, "state", Value(name));
  // The scope of these is that of the link.
  for (const std::string& at : tree.list(id, ListName::parameters)) {
    const auto& parameter = std::get<rcm::Parameter>(tree.find(at)->content);
    if (!parameter.from) continue;
    parameters.push_back(overriding(parameter.name, "from", *parameter.from, ids(at)));
    builder.set(at, "from", std::nullopt);
  }
  for (const std::string& at : tree.list(id, ListName::ports)) {
    const auto& port = std::get<rcm::Port>(tree.find(at)->content);
    if (!port.to) continue;
    ports.push_back(overriding(port.name, "to", *port.to, ids(at)));
    builder.set(at, "to", std::nullopt);
  }
  if (!parameters.empty()) link.set("parameters", std::move(parameters));
  if (!ports.empty()) link.set("ports", std::move(ports));
  const std::string own = ids(id);
  link.set("link", name);
  link.set("meta", Dict{{"id", own}});
  builder.add(Insert{{element->parent, ListName::children, tree.before(id)}, std::move(link)});
  if (const Value* drawn = tree.fields().layout.find(id)) builder.add(Set{"", "layout", own, *drawn});
  return builder.take();
}

}  // namespace race::edit
