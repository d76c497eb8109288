// POST /api/v1/cores/{id}/start: a core begins, with other arguments than those of its creation if the body has some.
#include "core/rcm/document.h"
#include "core/value/json.h"
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"
#include "server/store/documents.h"

namespace race::server {

namespace {

// Nothing: those of the creation stay.
Checked<std::optional<Dict>> read_body(const std::string& text) {
  if (text.empty()) return std::nullopt;
  auto body = parse_json(text);
  if (!body) return failed(std::move(body).error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  auto arguments = read_arguments(fields);
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return arguments;
}

// The document that the core executes, in the revision that it was created of.
Checked<StoredDocument> document_of(const Core& core, Documents& documents) {
  const Value info = core.info();
  const std::string& name = info.find("document")->as_string();
  const std::int64_t revision = info.find("revision")->as_integer();
  const auto entry = documents.entry(name, revision);
  if (!entry) return tl::unexpected(entry.error());
  auto document = rcm::read_document(entry->document);
  if (!document) return tl::unexpected(std::move(document).error());
  return StoredDocument{name, revision, std::move(*document)};
}

}  // namespace

void start_core(const Request& request, Respond respond, Documents& documents, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  auto arguments = read_body(request.body);
  if (!arguments) return respond(tl::unexpected(std::move(arguments).error()));
  if (!*arguments) return (*core)->start(answer_to(std::move(respond)));
  const auto document = document_of(**core, documents);
  if (!document) return respond(tl::unexpected(document.error()));
  cores.load((*core)->id(), *document, std::move(**arguments), std::nullopt,
             [respond = std::move(respond)](const Checked<std::shared_ptr<Core>>& loaded) {
               if (!loaded) return respond(tl::unexpected(loaded.error()));
               (*loaded)->start(answer_to(respond));
             });
}

}  // namespace race::server
