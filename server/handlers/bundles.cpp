// GET /api/v1/documents/{name}/bundle and POST /api/v1/bundles?as&author&message: a task with the interfaces of its
// services as one file, and from one.
#include "core/rcm/document.h"
#include "core/value/json.h"
#include "server/cell/cell.h"
#include "server/editing/bundle.h"
#include "server/editing/editing.h"
#include "server/handlers/document_requests.h"
#include "server/handlers/preconditions.h"
#include "server/handlers/query.h"
#include "server/wire/errors.h"

namespace race::server {
namespace {

Reply installed(const DocumentEntry& stored, const std::vector<Error>& lacking) {
  const Revision& revision = stored.revision;
  Dict json{{"name", revision.document}, {"revision", revision.number}, {"lacking", error_list(lacking)}};
  Reply reply =
      stored.is_new ? created(std::move(json), "/api/v1/documents/" + revision.document) : ok(std::move(json));
  add_tag(reply, revision.number);
  return reply;
}

}  // namespace

Handled get_document_bundle(const Request& request, Documents& documents, Cell& cell) {
  const auto stored = documents.get(request.parameters.at("name"));
  if (!stored) return tl::unexpected(stored.error());
  auto entry = documents.entry(stored->name, stored->revision);
  if (!entry) return tl::unexpected(std::move(entry).error());
  const auto needed = needed_services(stored->document);
  if (!needed) return tl::unexpected(needed.error());
  return ok(bundle_json(stored->name, std::move(entry->document), *needed, cell.host().services()));
}

// All of it is checked before the document is stored.
Handled install_bundle(const Request& request, Editing& editing, Cell& cell) {
  const auto match = if_match(request);
  if (!match) return failed(match.error());
  const auto change = change_of(request);
  if (!change) return failed(change.error());
  const auto bundle = read_bundle(request.body);
  if (!bundle) return tl::unexpected(bundle.error());
  const std::string text = to_json(bundle->document);
  const auto document = rcm::read_document_text(text);
  if (!document) return tl::unexpected(document.error());
  const auto needed = needed_services(*document);
  if (!needed) return tl::unexpected(needed.error());
  const std::string as = query_text(request, "as");
  const Documents::Put options{false, *match, !*match};
  const auto stored = editing.put(as.empty() ? bundle->name : as, text, *change, options);
  if (!stored) return answer_changed(stored, match->has_value());
  return installed(*stored, lacking(*needed, *bundle, cell.host().services()));
}

}  // namespace race::server
