// POST /api/v1/cores/{id}/start: a core begins, with other arguments than those of its creation if the body has some.
#include "server/execution/cores.h"
#include "server/handlers/body.h"
#include "server/handlers/handlers.h"
#include "server/handlers/supervision.h"
#include "server/store/documents.h"

namespace race::server {

namespace {

struct Body {
  std::optional<Dict> arguments = {};  // nothing: those of the creation stay
  std::optional<bool> supervised = {};
};

Checked<Body> read_start(const std::string& text) {
  if (text.empty()) return Body();
  return read_body(text, [](Fields& fields) { return Body{read_arguments(fields), fields.boolean("supervised")}; });
}

// The document that the core executes, in the revision that it was created of.
Checked<StoredDocument> document_of(const Core& core, Documents& documents) {
  const Value info = core.info();
  return documents.get(info.find("document")->as_string(), info.find("revision")->as_integer());
}

}  // namespace

void start_core(const Request& request, Respond respond, Documents& documents, Cores& cores, ManualControl& manual) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  auto body = read_start(request.body);
  if (!body) return respond(tl::unexpected(std::move(body).error()));
  const auto control = control_of(request, manual);
  if (!control) return respond(failed(control.error()));
  const Supervision by{*control, body->supervised};
  if (!body->arguments) return (*core)->start(answer_to(std::move(respond)), by);
  const auto document = document_of(**core, documents);
  if (!document) return respond(tl::unexpected(document.error()));
  cores.load((*core)->id(), *document, std::move(*body->arguments), std::nullopt,
             [respond = std::move(respond), by](const Checked<std::shared_ptr<Core>>& loaded) {
               if (!loaded) return respond(tl::unexpected(loaded.error()));
               (*loaded)->start(answer_to(respond), by);
             });
}

}  // namespace race::server
