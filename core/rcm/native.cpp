#include "core/rcm/native.h"

#include <utility>

#include "core/rcm/document.h"
#include "core/rcm/translate.h"
#include "core/value/error_list.h"
#include "core/value/fields.h"

namespace race::rcm {
namespace {

using Errors = std::vector<Error>;
using Need = Fields::Need;
using Origin = std::map<std::string, std::string>;

// The model itself: translation leaves it as it is, and names each of its elements.
Checked<NativeModel> read_model(const Value& json, const std::string& path) {
  const auto below = [&path](Errors errors) {
    for (Error& error : errors) error.path = error.path.empty() ? path : path + "/" + error.path;
    return tl::unexpected(std::move(errors));
  };
  const auto document = read_document(json);
  if (!document) return below(document.error());
  if (!document->library.empty())
    return below({{ErrorCode::unknown_field, "a native model has no library", "library"}});
  auto native = translate(*document);
  if (!native) return below(std::move(native).error());
  if (native->root != document->root)
    return below({{ErrorCode::oracle, "a native model has no links, oracles or `after`"}});
  return native;
}

// `elements`: every element of the model, by path.
Origin read_origin(const Dict& json, const std::string& path, const Origin& elements, Errors& errors) {
  Origin origin;
  for (const auto& [key, from] : json) {
    const std::string& element = key.as_string();
    if (!elements.contains(element))
      add_error(errors, {ErrorCode::unknown_name, "the model has no element of this path", path + "/" + element});
    else if (!from.is_string())
      add_error(errors, {ErrorCode::type, "an origin must be a string, got " + std::string(kind_name(from)),
                         path + "/" + element});
    else
      origin.emplace(element, from.as_string());
  }
  for (const auto& [element, itself] : elements)
    if (!json.find(element)) add_error(errors, {ErrorCode::missing, "the origin is missing", path + "/" + element});
  return origin;
}

}  // namespace

Value write_native(const Document& document, const NativeModel& native) {
  Document translated;
  translated.name = document.name;
  translated.services = document.services;
  translated.root = native.root;
  Dict origin;
  for (const auto& [path, from] : native.origin) origin.set(path, from);
  return Dict{{"document", write_document(translated)}, {"origin", std::move(origin)}};
}

Checked<NativeModel> read_native(const Value& json, const std::string& path) {
  Errors errors;
  Fields fields(json, path, "native model", errors, Fields::Paths::field);
  const Value* document = fields.find("document", Need::required);
  const Value* origin = fields.find("origin", Need::required);
  if (origin && !origin->is_dict())
    fields.violation(ErrorCode::type, "`origin` must be an object, got " + std::string(kind_name(*origin)), "origin");
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  auto model = read_model(*document, path + "/document");
  if (!model) return model;
  model->origin = read_origin(origin->as_dict(), path + "/origin", model->origin, errors);
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return model;
}

}  // namespace race::rcm
