#include "server/editing/bundle.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/rcm/translate.h"
#include "core/rsm/document.h"
#include "core/semantics/program.h"
#include "core/value/fields.h"
#include "core/value/json.h"

namespace race::server {
namespace {

using services::ServiceStatus;

constexpr std::int64_t kBundleVersion = 1;

const ServiceStatus* find_here(const std::vector<ServiceStatus>& here, const std::string& key) {
  const auto found = std::ranges::find(here, key, &ServiceStatus::key);
  return found == here.end() ? nullptr : &*found;
}

template <typename Named>
const Named* find_named(const std::vector<Named>& all, const std::string& name) {
  const auto found = std::ranges::find(all, name, &Named::name);
  return found == all.end() ? nullptr : &*found;
}

// "`a`, `b`": the names that are none of `all`.
template <typename Named>
std::string missing_of(const std::set<std::string>& names, const std::vector<Named>& all) {
  std::string missing;
  for (const std::string& name : names)
    if (!find_named(all, name)) missing += (missing.empty() ? "`" : ", `") + name + '`';
  return missing;
}

// Whether a call that one takes is taken by the other, too: all but what is for people.
bool is_alike(const rsm::OperationParameter& a, const rsm::OperationParameter& b) {
  return a.name == b.name && a.type == b.type && a.unit == b.unit && a.min == b.min && a.max == b.max &&
         a.value == b.value;
}

bool has_other_parameters(const std::string& name, const rsm::Service& mine, const rsm::Service& theirs) {
  const rsm::Operation* operation = find_named(mine.operations, name);
  const rsm::Operation* other = find_named(theirs.operations, name);
  return operation && other && !std::ranges::equal(operation->parameters, other->parameters, is_alike);
}

std::optional<Error> what_it_lacks(const std::string& key, const NeededService& needed, const Bundle& bundle,
                                   const ServiceStatus* service) {
  if (!service) return Error{ErrorCode::not_found, "there is no service of this key here", key};
  const auto said = bundle.types.find(key);
  const std::string type = needed.type.empty() && said != bundle.types.end() ? said->second : needed.type;
  if (!type.empty() && type != service->type)
    return Error{ErrorCode::type, "is of type `" + service->type + "` here, not `" + type + '`', key};
  if (const std::string names = missing_of(needed.operations, service->model->operations); !names.empty())
    return Error{ErrorCode::missing, "has not the operations " + names, key};
  if (const std::string names = missing_of(needed.events, service->model->events); !names.empty())
    return Error{ErrorCode::missing, "has not the events " + names, key};
  if (const auto made_with = bundle.services.find(key); made_with != bundle.services.end())
    for (const std::string& name : needed.operations)
      if (has_other_parameters(name, *service->model, made_with->second))
        return Error{ErrorCode::conflict, '`' + name + "` has other parameters here", key};
  if (!service->available) return Error{ErrorCode::unavailable, "is not available now", key};
  return std::nullopt;
}

void read_bundled_services(const Value& json, Fields& bundle, std::vector<Error>& errors, Bundle& out) {
  if (!json.is_dict()) return bundle.violation(ErrorCode::type, "`services` must be an object", "services");
  if (json.as_dict().size() > Bundle::kMostServices)
    return bundle.violation(ErrorCode::too_large,
                            "a bundle has at most " + std::to_string(Bundle::kMostServices) + " services", "services");
  for (const auto& [name, description] : json.as_dict()) {
    const std::string& key = name.as_string();
    const std::string path = "services/" + key;
    if (!is_name(key)) {
      bundle.violation(ErrorCode::name, "the key of a service is a name of letters, digits and `_`", path);
      continue;
    }
    Fields fields(description, path, "the service", errors, kByField);
    if (auto type = fields.text("type")) out.types.emplace(key, std::move(*type));
    const Value* rsm = fields.find("rsm");
    fields.close();
    if (!rsm) continue;
    auto service = rsm::read_service(*rsm, path + "/rsm");
    if (service)
      out.services.emplace(key, std::move(*service));
    else
      errors.insert(errors.end(), service.error().begin(), service.error().end());
  }
}

}  // namespace

Checked<NeededServices> needed_services(const rcm::Document& document) {
  const auto native = rcm::translate(document);
  if (!native) return tl::unexpected(native.error());
  const auto program = semantics::Program::build(*native, {});
  if (!program) return tl::unexpected(program.error());
  NeededServices needed;
  for (const auto& [key, type] : document.services) needed[key].type = type;
  const language::ServiceTable& named = (*program)->services;
  for (const auto& event : named.events()) needed[event.service].events.insert(event.name);
  for (const auto& operation : named.operations())
    if (!operation.open) needed[operation.service].operations.insert(operation.name);
  return needed;
}

Value bundle_json(const std::string& name, Value document, const NeededServices& needed,
                  const std::vector<ServiceStatus>& here) {
  Dict services;
  for (const auto& [key, service] : needed) {
    const ServiceStatus* found = find_here(here, key);
    if (found && !service.type.empty() && found->type != service.type) found = nullptr;
    Dict description;
    if (found || !service.type.empty()) description.set("type", found ? found->type : service.type);
    if (found) description.set("rsm", rsm::write_service(*found->model));
    services.set(key, std::move(description));
  }
  return Dict{
      {"bundle", kBundleVersion}, {"name", name}, {"document", std::move(document)}, {"services", std::move(services)}};
}

Checked<Bundle> read_bundle(const std::string& text) {
  const auto json = parse_json(text);
  if (!json) return tl::unexpected(std::vector<Error>{json.error()});
  std::vector<Error> errors;
  Fields fields(*json, "", "the bundle", errors, kByField);
  Bundle bundle;
  const Value* version = fields.find("bundle", kRequired);
  if (version && !(version->is_integer() && version->as_integer() == kBundleVersion))
    fields.violation(ErrorCode::version, "this program reads bundles of version 1", "bundle");
  bundle.name = fields.text("name", kRequired).value_or("");
  const Value* document = fields.find("document", kRequired);
  if (document && !document->is_dict())
    fields.violation(ErrorCode::type, "`document` must be an object", "document");
  else if (document)
    bundle.document = *document;
  if (const Value* services = fields.find("services")) read_bundled_services(*services, fields, errors, bundle);
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return bundle;
}

std::vector<Error> lacking(const NeededServices& needed, const Bundle& bundle, const std::vector<ServiceStatus>& here) {
  std::vector<Error> errors;
  for (const auto& [key, service] : needed)
    if (auto error = what_it_lacks(key, service, bundle, find_here(here, key))) errors.push_back(std::move(*error));
  return errors;
}

}  // namespace race::server
