#include "core/execution/executed_model.h"

#include "core/edit/apply.h"
#include "core/edit/difference.h"
#include "core/edit/tree.h"
#include "core/rcm/constraints.h"
#include "core/rcm/document.h"
#include "core/rcm/native.h"
#include "core/rsm/document.h"
#include "core/value/fields.h"

namespace race::execution {
namespace {

using Errors = std::vector<Error>;

tl::unexpected<Errors> failed(Error error) { return tl::unexpected(Errors{std::move(error)}); }

/// `item`: an operation or an event, of which a program knows no more than name and flag.
template <typename Item>
Dict item_json(const Item& item, const char* flag, bool is_set) {
  Dict json{{"name", item.name}};
  if (is_set) json.set(flag, true);
  return json;
}

Dict interface_json(const rsm::Service& service) {
  List operations, events;
  for (const rsm::Operation& each : service.operations) operations.emplace_back(item_json(each, "safe", each.safe));
  for (const rsm::Event& each : service.events) events.emplace_back(item_json(each, "sampled", each.sampled));
  return {{"operations", std::move(operations)}, {"events", std::move(events)}};
}

/// The items of the list `key`, each an object with a name and perhaps the flag `flag`.
template <typename Item>
std::vector<Item> read_items(Fields& service, std::string_view key, std::string_view flag, bool Item::*member,
                             Errors& errors) {
  std::vector<Item> items;
  for (const Value& json : service.list(key, kRequired)) {
    const std::string path = service.path() + "/" + std::string(key) + "/" + std::to_string(items.size());
    Fields fields(json, path, "an item of `" + std::string(key) + "`", errors, kByField);
    Item& item = items.emplace_back();
    item.name = fields.text("name", kRequired).value_or("");
    item.*member = fields.boolean(flag).value_or(false);
    fields.close();
  }
  return items;
}

rsm::Service read_interface(const Value& json, const std::string& path, Errors& errors) {
  const std::size_t before = errors.size();
  Fields fields(json, path, "service", errors, kByField);
  rsm::Service service;
  service.operations = read_items(fields, "operations", "safe", &rsm::Operation::safe, errors);
  service.events = read_items(fields, "events", "sampled", &rsm::Event::sampled, errors);
  fields.close();
  if (errors.size() == before) append_below(errors, rsm::violations(service, path), "");
  return service;
}

/// What the text of a native model's document may be. In a journal, a checkpoint or an entry, levels stand around it.
constexpr JsonLimits kNativeLimits{.depth = 2 * rcm::kMaxDepth + JsonLimits{}.depth, .bytes = kJournalLimits.bytes};
static_assert(kNativeLimits.depth < kJournalLimits.depth);

/// The `document` of a native model. Constraints are checked when a program is made of it.
Checked<edit::Tree> read_tree(const Value& native) {
  const Value* json = native.find("document");
  rcm::Draft draft = rcm::read_draft(json ? *json : Value());
  if (!draft.errors.empty()) return tl::unexpected(std::move(draft.errors));
  auto tree = edit::Tree::read(draft.document, kNativeLimits);
  if (!tree) return failed(std::move(tree).error());
  return std::move(*tree);
}

const Dict& origin_of(const Value& native) {
  static const Dict none;
  const Value* origin = native.find("origin");
  return origin && origin->is_dict() ? origin->as_dict() : none;
}

/// What has to be set in `before`, to null what has to go, to make it `after`.
Dict changes(const Dict& before, const Dict& after) {
  Dict changed;
  for (const auto& [key, value] : after)
    if (const Value* old = before.find(key); !old || *old != value) changed.set(key, value);
  for (const auto& [key, value] : before)
    if (!after.find(key)) changed.set(key, Value());
  return changed;
}

Dict changed(Dict before, const Dict& changes) {
  for (const auto& [key, value] : changes)
    if (value.is_null())
      before.erase(key.as_string());
    else
      before.set(key, value);
  return before;
}

}  // namespace

Dict interfaces_json(const semantics::Program& program) {
  const language::ServiceTable& table = program.services;
  Dict services;
  for (const std::string& key : table.declared_services()) {
    List operations, events;
    for (const auto& each : table.operations())
      if (each.declared && each.service == key) operations.emplace_back(item_json(each, "safe", each.safe));
    for (const auto& each : table.events())
      if (each.declared && each.service == key) events.emplace_back(item_json(each, "sampled", each.sampled));
    services.set(key, Dict{{"operations", std::move(operations)}, {"events", std::move(events)}});
  }
  return services;
}

Interfaces read_interfaces(const Dict& json, const std::string& path, Errors& errors) {
  Interfaces services;
  for (const auto& [key, service] : json)
    services.emplace(key.as_string(), read_interface(service, path + "/" + key.as_string(), errors));
  return services;
}

Checked<ExecutedModel> build_model(Value native, const Interfaces& services, const std::string& path) {
  const auto model = rcm::read_native(native, path);
  if (!model) return tl::unexpected(model.error());
  auto program = semantics::Program::build(*model, services);
  if (!program) {
    Errors errors;
    append_below(errors, std::move(program).error(), path + "/document");
    return tl::unexpected(std::move(errors));
  }
  return ExecutedModel{std::move(native.freeze()), std::move(*program), 0};
}

Expected<EditEntry> edit_between(const ExecutedModel& before, const Value& native, const Interfaces& services) {
  const auto from = read_tree(before.native), to = read_tree(native);
  if (!from) return tl::unexpected(from.error().front());
  if (!to) return tl::unexpected(to.error().front());
  EditEntry entry;
  ASSIGN_OR_RETURN(entry.edit, edit::difference(*from, *to));
  entry.origin = changes(origin_of(before.native), origin_of(native));
  const Dict known = interfaces_json(*before.program);
  for (const auto& [key, service] : services) {
    Value json = interface_json(service);
    if (const Value* old = known.find(Value(key)); !old || *old != json) entry.services.set(key, std::move(json));
  }
  entry.origin.freeze();
  entry.services.freeze();
  return entry;
}

Checked<ExecutedModel> edited(const ExecutedModel& before, const EditEntry& entry) {
  auto tree = read_tree(before.native);
  if (!tree) return tl::unexpected(std::move(tree).error());
  if (auto inverse = edit::apply(*tree, entry.edit); !inverse) return failed(std::move(inverse).error());
  Value native = Dict{{"document", rcm::write_document(tree->document())},
                      {"origin", changed(origin_of(before.native), entry.origin)}};
  Errors errors;
  const Interfaces services =
      read_interfaces(changed(interfaces_json(*before.program), entry.services), "services", errors);
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  auto model = build_model(std::move(native), services, "native");
  if (model) model->revision = entry.revision;
  return model;
}

}  // namespace race::execution
