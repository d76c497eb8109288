// GET and POST /api/v1/queue, POST /api/v1/queue/resume, GET and DELETE /api/v1/queue/{id}: runs that wait their turn.
#include "server/handlers/body.h"
#include "server/handlers/handlers.h"
#include "server/handlers/query.h"
#include "server/handlers/supervision.h"
#include "server/queue/run_queue.h"

namespace race::server {

namespace {

constexpr std::int64_t kMostQueued = 100;  // of an answer

struct NewQueuedRun {
  std::string document, name;
  Dict arguments;
  bool goes_on = false;
};

// What the queue does after a fault.
bool read_on_fault(Fields& fields) {
  const auto on_fault = fields.text("on_fault");
  if (on_fault && *on_fault != "stop" && *on_fault != "go_on")
    fields.violation(ErrorCode::out_of_range, "must be `stop` or `go_on`", "on_fault");
  return on_fault == "go_on";
}

Checked<NewQueuedRun> read_queued_run(const std::string& text) {
  return read_body(text, [](Fields& fields) {
    NewQueuedRun run;
    run.document = fields.text("document", kRequired).value_or("");
    run.arguments = read_arguments(fields).value_or(Dict());
    run.name = fields.text("name").value_or("");
    if (run.name.size() > RunQueue::kLongestName)
      fields.violation(ErrorCode::too_large, "has more than " + std::to_string(RunQueue::kLongestName) + " bytes",
                       "name");
    run.goes_on = read_on_fault(fields);
    return run;
  });
}

Handled answer_with(const Expected<QueuedRun>& run) {
  if (!run) return failed(run.error());
  return ok(queued_run_json(*run));
}

Handled answer_with_all(const RunQueue& queue) { return ok(queue.json(0, kMostQueued)); }

}  // namespace

Handled list_queue(const Request& request, RunQueue& queue) {
  const auto after = query_number(request, "after"), limit = query_number(request, "limit", {1, kMostQueued});
  if (!after) return failed(after.error());
  if (!limit) return failed(limit.error());
  return ok(queue.json(after->value_or(0), static_cast<std::size_t>(limit->value_or(kMostQueued))));
}

Handled create_queued_run(const Request& request, Documents& documents, Cores& cores, ManualControl& manual,
                          RunQueue& queue) {
  auto run = read_queued_run(request.body);
  if (!run) return tl::unexpected(std::move(run).error());
  const auto control = control_of(request, manual);
  if (!control) return failed(control.error());
  const std::uint64_t restores = queue.restores();  // before the document is read
  const auto document = documents.get(run->document);
  if (!document) return tl::unexpected(document.error());
  if (const auto fits = cores.check(*document, run->arguments); !fits) return tl::unexpected(fits.error());
  const auto queued = queue.add({document->name, document->revision, std::move(run->arguments), std::move(run->name),
                                 run->goes_on, request.identity, *control, restores});
  if (!queued) return failed(queued.error());
  return created(queued_run_json(*queued), "/api/v1/queue/" + std::to_string(queued->id));
}

Handled resume_queue(const Request&, RunQueue& queue) {
  if (const auto resumed = queue.resume(); !resumed) return failed(resumed.error());
  return answer_with_all(queue);
}

Handled get_queued_run(const Request& request, RunQueue& queue) {
  return answer_with(queue.find(request.parameters.at("id")));
}

Handled cancel_queued_run(const Request& request, RunQueue& queue) {
  return answer_with(queue.cancel(request.parameters.at("id")));
}

}  // namespace race::server
