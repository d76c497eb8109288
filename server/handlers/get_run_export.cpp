// GET /api/v1/runs/{run}/export: all of a run in one file, which any server opens.
#include "server/handlers/runs.h"
#include "server/runs/run_file.h"
#include "server/store/documents.h"

namespace race::server {

namespace {

// The model as it was edited; none: the store has lost that revision, or the run is of another server.
std::optional<Value> document_of(const RunRecord& run, Documents& documents) {
  if (run.imported) return {};
  auto entry = documents.entry(run.document, run.revision);
  if (!entry || !entry->errors.empty()) return {};
  return std::move(entry->document);
}

Expected<std::string> write(const Request& request, Runs& runs, Samples& samples, Pictures& pictures,
                            Documents& documents) {
  RunFile file;
  ASSIGN_OR_RETURN(file.record, run_of(request, runs));
  ASSIGN_OR_RETURN(file.journal, journal_of(file.record, runs));
  file.document = document_of(file.record, documents);
  ASSIGN_OR_RETURN(file.services, services_of(file.record.id, runs));
  ASSIGN_OR_RETURN(file.samples, samples.read(file.record.id));
  ASSIGN_OR_RETURN(file.pictures, pictures.read_all(file.record.id));
  ASSIGN_OR_RETURN(file.timing, timing_of(file.record.id, runs));
  return write_run_file(file);
}

}  // namespace

Handled get_run_export(const Request& request, Runs& runs, Samples& samples, Pictures& pictures, Documents& documents) {
  Handled reply = answer_text(write(request, runs, samples, pictures, documents));
  if (reply)
    reply->headers.emplace_back("Content-Disposition",
                                "attachment; filename=\"run-" + request.parameters.at("run") + ".json\"");
  return reply;
}

}  // namespace race::server
