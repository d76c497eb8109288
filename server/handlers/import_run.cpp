// POST /api/v1/runs: the file of a run, of this server or another one; checked whole, then stored under a new number.
#include <tuple>

#include "server/handlers/runs.h"
#include "server/http/request_filter.h"
#include "server/runs/run_file.h"
#include "server/runs/run_json.h"

namespace race::server {

static_assert(RequestFilter::kRunFileBytes == kRunFileLimits.bytes);

Handled import_run(const Request& request, Runs& runs, Samples& samples) {
  std::map<std::uint64_t, std::string> checkpoints;
  auto file = read_run_file_text(request.body, &checkpoints);
  if (!file) return tl::unexpected(std::move(file).error());
  const Runs::NewRun run{file->record.document, file->record.revision, file->journal.header, file->services};
  const auto record = runs.import(file->record, run, file->journal.entries, checkpoints);
  if (!record) return failed(record.error());
  if (auto stored = samples.append(record->id, file->samples); !stored) {
    std::ignore = runs.remove(record->id);  // whole or not at all
    return failed(std::move(stored).error());
  }
  Reply reply = ok(run_json(*record));
  reply.status = 201;
  return reply;
}

}  // namespace race::server
