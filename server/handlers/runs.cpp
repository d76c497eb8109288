// What the handlers of /api/v1/runs share: which run a request means, and how they answer.
#include "server/handlers/runs.h"

#include <charconv>
#include <limits>

#include "server/runs/run_file.h"

namespace race::server {

Expected<std::uint64_t> query_number(const Request& request, std::string_view name, std::uint64_t least,
                                     std::uint64_t absent) {
  const auto found = request.query.find(name);
  if (found == request.query.end()) return absent;
  const std::string& text = found->second;
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size() && number >= least &&
      number <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
    return number;
  return unexpected(ErrorCode::out_of_range, "must be a whole number from " + std::to_string(least), std::string(name));
}

RunId run_number(std::string_view text) {
  RunId id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  return error == std::errc() && end == text.data() + text.size() ? id : 0;
}

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

Handled answer_replay(Worker& replays, std::function<Expected<Value>(const Worker::Stop&)> replay) {
  auto value = replays.ask(std::move(replay), kReplayTimeout);
  if (!value) return failed(std::move(value).error());
  return answer(std::move(*value));
}

}  // namespace race::server
