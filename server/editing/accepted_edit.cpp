#include "server/editing/accepted_edit.h"

#include "server/wire/errors.h"

namespace race::server {

Value accepted_edit_json(const DocumentPast::Edit& accepted, const std::vector<Error>& errors, EditDepths depths) {
  const auto& [revision, edit] = accepted;
  const Origin::Kind kind = revision.origin.kind;
  Dict json{{"document", revision.document},    {"revision", revision.number},
            {"author", revision.change.author}, {"message", revision.change.message},
            {"time", revision.change.time_ms},  {"kind", takes_back(kind) ? name(kind) : "change"}};
  if (takes_back(kind)) json.set("of", revision.origin.revision);
  if (!edit.request.empty()) json.set("request", edit.request);
  json.set("operations", *edit::write_edit(edit.edit).find("operations"));
  set_errors(json, errors);
  json.set("undo", static_cast<std::int64_t>(depths.undo));
  json.set("redo", static_cast<std::int64_t>(depths.redo));
  Value out(std::move(json));
  return std::move(out.freeze());
}

Value document_snapshot_json(const DocumentEntry& entry) {
  Dict json{{"document", entry.revision.document}, {"revision", entry.revision.number}, {"json", entry.document}};
  set_errors(json, entry.errors);
  Value out(std::move(json));
  return std::move(out.freeze());
}

Value edit_refusal_json(const std::string& document, const std::string& token, const EditRefusal& refusal) {
  Dict json{{"document", document}, {"request", token}};
  set_errors(json, refusal.errors);
  if (refusal.revision > 0) {
    json.set("revision", refusal.revision);
    json.set("author", refusal.author);
  }
  Value out(std::move(json));
  return std::move(out.freeze());
}

}  // namespace race::server
