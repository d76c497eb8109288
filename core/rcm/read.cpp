// Reading documents: the shape. One function for each element of the format; each gets the path of its parent.
#include <algorithm>

#include "core/rcm/constraints.h"
#include "core/rcm/document.h"
#include "core/rcm/entries.h"
#include "core/rcm/ids.h"
#include "core/rcm/path.h"
#include "core/rsm/type.h"
#include "core/value/fields.h"
#include "core/value/json.h"

namespace race::rcm {
namespace {

using Need = Fields::Need;

struct ReadErrors : std::vector<Error> {
  std::size_t bad_ids = 0;  // how many of them are about `meta.id`
};

/// The text at `key`, for paths and messages; empty if there is none.
std::string label(const Value& json, std::string_view key) {
  const Value* name = json.find(key);
  return name && name->is_string() ? name->as_string() : "";
}

std::string element(std::string_view what, const Value& json, std::string_view key) {
  const std::string name = label(json, key);
  return std::string(what) + (name.empty() ? "" : " `" + name + "`");
}

Value read_type(Fields& fields) {
  const Value* type = fields.find("type");
  if (!type) return Value();
  const auto reason = rsm::malformed(*type);
  if (!reason) return *type;
  fields.violation(ErrorCode::type, "`type`: " + *reason);
  return Value();
}

Value read_json_meta(Fields& fields) { return fields.constant("meta").value_or(Value()); }

/// Of the document: `notes` on elements by their ids.
Value read_document_meta(Fields& fields) {
  const Value meta = read_json_meta(fields);
  const Value* notes = meta.find("notes");
  const bool are_texts = !notes || (notes->is_dict() && std::ranges::all_of(notes->as_dict(), [](const auto& note) {
                                      return note.second.is_string();
                                    }));
  if (!are_texts) fields.violation(ErrorCode::type, "`meta.notes` must be an object of texts, each by an id");
  return ordered_document_meta(meta);
}

Meta read_meta(Fields& fields, ReadErrors& errors) {
  const Value json = read_json_meta(fields);
  const Value* id = json.find("id");
  if (!id) return {"", ordered_entries(json)};
  Meta out;
  if (id->is_string() && is_id(id->as_string())) {
    out.id = id->as_string();
  } else {
    ++errors.bad_ids;
    fields.violation(ErrorCode::type, "`meta.id` must be a text of 1 to 64 of A-Z a-z 0-9 _ -");
  }
  Dict rest = json.as_dict();
  rest.erase("id");
  out.rest = ordered_entries(rest);
  return out;
}

std::optional<Parameter> read_parameter(const Value& json, const std::string& path, ReadErrors& errors) {
  Fields fields(json, path, element("parameter", json, "name"), errors);
  const auto name = fields.text("name", Need::required);
  Parameter out;
  out.name = name.value_or("");
  out.value = fields.constant("value");
  out.from = fields.text("from");
  out.type = read_type(fields);
  out.unit = fields.text("unit").value_or("");
  out.doc = fields.text("doc").value_or("");
  out.meta = read_meta(fields, errors);
  fields.close();
  if (!name) return std::nullopt;
  return out;
}

std::optional<Datum> read_datum(std::string_view what, const Value& json, const std::string& path, ReadErrors& errors) {
  Fields fields(json, path, element(what, json, "name"), errors);
  const auto name = fields.text("name", Need::required);
  Datum out;
  out.name = name.value_or("");
  out.initial = fields.constant("initial");
  out.type = read_type(fields);
  out.unit = fields.text("unit").value_or("");
  out.doc = fields.text("doc").value_or("");
  out.meta = read_meta(fields, errors);
  fields.close();
  if (!name) return std::nullopt;
  return out;
}

std::optional<Action> read_action(const Value& json, const std::string& path, ReadErrors& errors) {
  Fields fields(json, path, "action", errors);
  auto when = fields.text("when", Need::required);
  auto code = fields.text("do", Need::required);
  Meta meta = read_meta(fields, errors);
  fields.close();
  if (!when || !code) return std::nullopt;
  return Action{std::move(*when), std::move(*code), std::move(meta)};
}

std::optional<Port> read_port(const Value& json, const std::string& state, ReadErrors& errors) {
  Fields fields(json, port_path(state, label(json, "name")), element("port", json, "name"), errors);
  const auto name = fields.text("name", Need::required);
  Port out;
  out.name = name.value_or("");
  out.when = fields.text("when");
  out.after = fields.text("after");
  out.to = fields.text("to");
  out.meta = read_meta(fields, errors);
  fields.close();
  if (!name) return std::nullopt;
  return out;
}

/// A list of ports under `key`; without it, none is given.
std::optional<std::vector<std::string>> read_ports(Fields& fields, std::string_view key) {
  const Value* ports = fields.find(key);
  if (!ports) return std::nullopt;
  auto names = fields.texts(key);
  return ports->is_list() ? std::optional(std::move(names)) : std::nullopt;
}

/// `deep`, which is true or absent.
bool read_deep(Fields& fields) {
  const Value* deep = fields.find("deep");
  if (!deep) return false;
  if (!deep->is_bool() || !deep->as_bool()) fields.violation(ErrorCode::type, "`deep` must be true");
  return true;
}

std::optional<Keep> read_deep_keep(const Value& json, const std::string& path, ReadErrors& errors) {
  Fields fields(json, path, "keep", errors);
  if (!read_deep(fields)) fields.violation(ErrorCode::missing, "the field `deep` is missing");
  auto ports = read_ports(fields, "ports");
  fields.close();
  return Keep{.any = !ports, .ports = std::move(ports).value_or(std::vector<std::string>()), .deep = true};
}

std::optional<Keep> read_keep(Fields& fields, const std::string& path, ReadErrors& errors) {
  const Value* keep = fields.find("keep");
  if (!keep) return std::nullopt;
  if (keep->is_bool() && keep->as_bool()) return Keep{.any = true};
  if (keep->is_list()) return Keep{.ports = fields.texts("keep")};
  if (keep->is_dict()) return read_deep_keep(*keep, path, errors);
  fields.violation(ErrorCode::type,
                   "`keep` must be true, a list of ports or an object, got " + std::string(kind_name(*keep)));
  return std::nullopt;
}

std::optional<Oracle> read_history(Fields& fields) {
  Oracle out{.kind = Oracle::Kind::history, .text = "", .resume = read_ports(fields, "resume")};
  out.deep = read_deep(fields);
  fields.close();
  return out;
}

std::optional<Oracle> read_oracle_text(Fields& fields, Oracle::Kind kind, std::string_view key) {
  const auto text = fields.text(key, Need::required);
  fields.close();
  if (!text) return std::nullopt;
  return Oracle{.kind = kind, .text = *text, .resume = std::nullopt};
}

std::optional<Oracle> read_oracle(const Value* json, const std::string& path, ReadErrors& errors) {
  if (!json) return std::nullopt;
  Fields fields(*json, path, "oracle", errors);
  const auto kind = fields.text("kind", Need::required);
  if (!kind) return std::nullopt;
  if (*kind == "expr") return read_oracle_text(fields, Oracle::Kind::expr, "expr");
  if (*kind == "external") return read_oracle_text(fields, Oracle::Kind::external, "call");
  if (*kind == "history") return read_history(fields);
  fields.violation(ErrorCode::oracle, "there is no oracle of the kind `" + *kind + "`");
  return std::nullopt;
}

Barrier read_barrier(const Value& json, const std::string& path, ReadErrors& errors) {
  Fields fields(json, path, element("barrier", json, "barrier"), errors);
  Barrier out;
  out.name = fields.text("barrier", Need::required).value_or("");
  out.to = fields.texts("to", Need::required);
  out.meta = read_meta(fields, errors);
  fields.close();
  return out;
}

/// Reads a list of elements that are left out when they cannot be read.
template <typename T, typename Read>
std::vector<T> read_all(const List& items, Read read) {
  std::vector<T> out;
  for (const Value& item : items) {
    if (std::optional<T> element = read(item)) out.push_back(std::move(*element));
  }
  return out;
}

State read_state(const Value& json, const std::string& path, ReadErrors& errors);

std::optional<Node> read_node(const Value& json, const std::string& parent, ReadErrors& errors) {
  const bool barrier = json.find("barrier") && !json.find("state");
  const std::string path = node_path(parent, label(json, barrier ? "barrier" : "state"));
  if (barrier) return read_barrier(json, path, errors);
  if (!json.is_dict()) {
    const Fields refused(json, parent, "child", errors);
    return std::nullopt;
  }
  return read_state(json, path, errors);
}

State read_state(const Value& json, const std::string& path, ReadErrors& errors) {
  Fields fields(json, path, element("state", json, "state"), errors);
  const auto datum = [&](std::string_view what) {
    return [&, what](const Value& item) { return read_datum(what, item, path, errors); };
  };
  State out;
  out.name = fields.text("state", Need::required).value_or("");
  out.doc = fields.text("doc").value_or("");
  out.parameters = read_all<Parameter>(fields.list("parameters"),
                                       [&](const Value& item) { return read_parameter(item, path, errors); });
  out.results = read_all<Datum>(fields.list("results"), datum("result"));
  out.variables = read_all<Datum>(fields.list("variables"), datum("variable"));
  out.entry = fields.text("entry");
  out.exit = fields.text("exit");
  out.actions =
      read_all<Action>(fields.list("actions"), [&](const Value& item) { return read_action(item, path, errors); });
  out.children =
      read_all<Node>(fields.list("children"), [&](const Value& item) { return read_node(item, path, errors); });
  out.first = fields.text("first");
  out.ports = read_all<Port>(fields.list("ports"), [&](const Value& item) { return read_port(item, path, errors); });
  out.keep = read_keep(fields, path, errors);
  out.link = fields.text("link");
  out.oracle = read_oracle(fields.find("oracle"), path, errors);
  out.meta = read_meta(fields, errors);
  fields.close();
  return out;
}

std::map<std::string, std::string> read_services(const Value* json, ReadErrors& errors) {
  std::map<std::string, std::string> out;
  if (!json) return out;
  Fields fields(*json, "", "services", errors);
  if (!fields.is_object()) return out;
  for (const auto& [key, type] : json->as_dict()) {
    if (const auto text = fields.text(key.as_string())) out[key.as_string()] = *text;
  }
  return out;
}

void read_fields(Fields& fields, Draft& out, ReadErrors& errors) {
  const Value* version = fields.find("rcm");
  if (!version || *version != Value(1)) fields.violation(ErrorCode::version, "`rcm` must be 1");
  out.document.name = fields.text("name").value_or("");
  out.document.services = read_services(fields.find("services"), errors);
  for (const Value& item : fields.list("library"))
    out.document.library.push_back(read_state(item, library_path(label(item, "state")), errors));
  if (const Value* root = fields.find("root", Need::required)) {
    out.document.root = read_state(*root, node_path("", label(*root, "state")), errors);
    out.has_root = root->is_dict();
  }
  out.document.layout = ordered_entries(fields.constant("layout").value_or(Value()));
  if (!out.document.layout.is_null() && !out.document.layout.is_dict())
    fields.violation(ErrorCode::type, "`layout` must be an object");
  out.document.meta = read_document_meta(fields);
  fields.close();
}

}  // namespace

Draft read_draft(const Value& json) {
  Draft out;
  ReadErrors errors;
  Fields fields(json, "", "document", errors);
  if (fields.is_object()) read_fields(fields, out, errors);
  out.bad_ids = errors.bad_ids;
  out.errors = std::move(errors);
  return out;
}

Checked<Document> read_document(const Value& json) {
  Draft draft = read_draft(json);
  std::vector<Error> errors = violations(draft);
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return std::move(draft.document);
}

Checked<Document> read_document_text(std::string_view text) {
  const auto json = parse_json(text, JsonLimits{.keep_out_of_range = true});
  if (!json) return tl::unexpected(std::vector<Error>{json.error()});
  return read_document(*json);
}

}  // namespace race::rcm
