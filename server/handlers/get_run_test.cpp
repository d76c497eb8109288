// GET /api/v1/runs/{run}/test: a test file that the run makes, for `race test`.
#include "server/handlers/runs.h"
#include "server/model_tests/recorded_run.h"

namespace race::server {

// The name is that under which `race test` looks for the model of the run.
void get_run_test(const Request& request, Respond respond, Runs& runs, Worker& replays) {
  const auto run = run_of(request, runs);
  if (!run) return respond(failed(run.error()));
  if (!run->is_over()) return respond(failed(Error{ErrorCode::not_accepted, "the run is not over"}));
  replays.ask<std::string, std::vector<Error>>(
      [&runs, id = run->id](const Stop& stop) -> Checked<std::string> {
        const auto recorded = recorded_run(id, runs);
        if (!recorded) return failed(recorded.error());
        return test_of_run("as run " + std::to_string(id), *recorded, &stop);
      },
      kReplayLimit, request.gone,
      [respond = std::move(respond), document = run->document](Checked<std::string> text) {
        if (!text) return respond(tl::unexpected(std::move(text).error()));
        Handled reply = answer_text(std::move(*text));
        reply->headers.emplace_back("Content-Disposition", "attachment; filename=\"" + document + ".test.json\"");
        respond(std::move(reply));
      });
}

}  // namespace race::server
