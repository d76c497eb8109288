// What the handlers of /api/v1/runs share: which run a request means, and how they answer.
#include "server/handlers/runs.h"

#include "server/handlers/query.h"
#include "server/runs/run_file.h"

namespace race::server {

RunId run_number(std::string_view text) { return static_cast<RunId>(whole_number(text).value_or(0)); }

Expected<execution::Journal> journal_of(Core& core, Runs& runs) {
  ASSIGN_OR_RETURN(const std::uint64_t steps, core.position());
  return journal_of(core.run_id(), core.header(), steps, runs);
}

Expected<RunRecord> run_of(const Request& request, Runs& runs) {
  return runs.get(run_number(request.parameters.at("run")));
}

Handled answer_text(Expected<std::string> text) {
  if (!text) return failed(std::move(text).error());
  Reply reply;
  reply.text = std::move(*text);
  reply.type = "application/json";
  reply.headers.emplace_back("Cache-Control", "no-store");
  return reply;
}

void answer_replay(const Request& request, Respond respond, Worker& replays,
                   std::function<Expected<Value>(const Stop&)> replay) {
  replays.ask<Value>(std::move(replay), kReplayLimit, request.gone, answer_to(std::move(respond)));
}

}  // namespace race::server
