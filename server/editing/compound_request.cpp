#include "server/editing/compound_request.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/edit/compound.h"
#include "core/value/fields.h"

namespace race::server {
namespace {

using edit::Edit;
using edit::Tree;
using Seed = std::string_view;

const std::string& argument(const CompoundRequest& request, std::string_view name) {
  return request.arguments.find(name)->second;
}

struct Kind {
  std::string_view name;
  std::array<std::string_view, 2> arguments;  // texts; "to?" is optional
  bool has_ids;
  Expected<Edit> (*make)(const CompoundRequest& request, const Tree& tree, Seed seed);
};

Expected<Edit> rename(const CompoundRequest& r, const Tree& tree, Seed) {
  return edit::rename(tree, argument(r, "id"), argument(r, "name"));
}

Expected<Edit> rename_service(const CompoundRequest& r, const Tree& tree, Seed) {
  return edit::rename_service(tree, argument(r, "key"), argument(r, "name"));
}

Expected<Edit> connect(const CompoundRequest& r, const Tree& tree, Seed) {
  std::optional<std::string_view> to;
  if (r.arguments.contains("to")) to = argument(r, "to");
  return edit::connect(tree, argument(r, "from"), to);
}

Expected<Edit> disconnect(const CompoundRequest& r, const Tree& tree, Seed) {
  return edit::disconnect(tree, argument(r, "barrier"), argument(r, "state"));
}

Expected<Edit> group(const CompoundRequest& r, const Tree& tree, Seed seed) {
  return edit::group(tree, r.ids, argument(r, "name"), seed);
}

Expected<Edit> ungroup(const CompoundRequest& r, const Tree& tree, Seed) {
  return edit::ungroup(tree, argument(r, "id"));
}

Expected<Edit> duplicate(const CompoundRequest& r, const Tree& tree, Seed seed) {
  return edit::duplicate(tree, argument(r, "id"), seed);
}

Expected<Edit> extract(const CompoundRequest& r, const Tree& tree, Seed seed) {
  return edit::extract(tree, argument(r, "id"), argument(r, "name"), seed);
}

constexpr std::array kKinds = {
    Kind{"rename", {"id", "name"}, false, rename},
    Kind{"rename_service", {"key", "name"}, false, rename_service},
    Kind{"connect", {"from", "to?"}, false, connect},
    Kind{"disconnect", {"barrier", "state"}, false, disconnect},
    Kind{"group", {"name"}, true, group},
    Kind{"ungroup", {"id"}, false, ungroup},
    Kind{"duplicate", {"id"}, false, duplicate},
    Kind{"extract", {"id", "name"}, false, extract},
};

}  // namespace

CompoundRequest read_compound(const Value& json, std::vector<Error>& errors) {
  Fields fields(json, "compound", "compound edit", errors, Fields::Paths::field);
  CompoundRequest out;
  out.kind = fields.text("kind", Fields::Need::required).value_or("");
  const auto kind = std::ranges::find(kKinds, out.kind, &Kind::name);
  if (kind == kKinds.end()) {
    if (fields.find("kind")) fields.violation(ErrorCode::name, "there is no compound edit `" + out.kind + "`", "kind");
    return out;
  }
  for (std::string_view name : kind->arguments) {
    if (name.empty()) continue;
    const bool is_optional = name.ends_with('?');
    if (is_optional) name.remove_suffix(1);
    if (auto text = fields.text(name, is_optional ? Fields::Need::optional : Fields::Need::required))
      out.arguments.emplace(name, *std::move(text));
  }
  if (kind->has_ids) out.ids = fields.texts("ids", Fields::Need::required);
  fields.close();
  return out;
}

Expected<Edit> make_edit(const CompoundRequest& request, const Tree& tree, Seed seed) {
  auto edit = std::ranges::find(kKinds, request.kind, &Kind::name)->make(request, tree, seed);
  if (!edit) edit.error().path = "compound/" + edit.error().path;
  return edit;
}

}  // namespace race::server
