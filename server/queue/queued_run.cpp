#include "server/queue/queued_run.h"

#include <array>
#include <string_view>

#include "server/wire/errors.h"

namespace race::server {
namespace {

constexpr std::array<std::string_view, 5> kStatusNames = {"waiting", "running", "ended", "refused", "cancelled"};

void set_if_any(Dict& json, std::string_view key, const std::string& text) {
  if (!text.empty()) json.set(key, text);
}

}  // namespace

Value queued_run_json(const QueuedRun& run) {
  const QueuedTask& task = run.task;
  Dict json{{"id", std::to_string(run.id)},
            {"document", task.document},
            {"revision", task.revision},
            {"arguments", task.arguments},
            {"on_fault", task.goes_on ? "go_on" : "stop"},
            {"by", name_for_people(task.by)},
            {"status", kStatusNames.at(static_cast<std::size_t>(run.status))}};
  set_if_any(json, "name", task.name);
  set_if_any(json, "core", run.core);
  set_if_any(json, "end", run.end);
  set_if_any(json, "outcome", run.outcome);
  if (!run.errors.empty()) set_errors(json, run.errors);
  return json;
}

}  // namespace race::server
