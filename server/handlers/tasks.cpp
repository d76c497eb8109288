#include "server/handlers/tasks.h"

#include <algorithm>
#include <ranges>
#include <utility>

#include "server/handlers/idempotency.h"
#include "server/http/field_list.h"

namespace race::server {
namespace {

Value progress_json(const WorkProgress::State& progress) {
  return Dict{{"done", static_cast<std::int64_t>(progress.done)},
              {"total", static_cast<std::int64_t>(progress.total)},
              {"unit", progress.unit}};
}

}  // namespace

bool Tasks::is_preferred(const Request& request) {
  return std::ranges::any_of(elements_of(request, "prefer"), [](std::string_view preference) {
    return lower(trim(preference.substr(0, preference.find(';')))) == "respond-async";
  });
}

Expected<Value> Tasks::begin(const Request& request, bool can_be_stopped) {
  const services::MutexLock lock(mutex_);
  std::size_t running = 0, bytes = request.body.size();
  for (const Task& task : tasks_) {
    if (task.reply) continue;
    ++running;
    bytes += task.bytes;
  }
  if (running >= kMostRunning)
    return unexpected(ErrorCode::unavailable,
                      "the server works on " + std::to_string(kMostRunning) + " such requests already");
  if (bytes > kMostBytes)
    return unexpected(ErrorCode::unavailable, "the server works on such requests with more than " +
                                                  std::to_string(kMostBytes) + " bytes already");
  if (tasks_.size() >= kMost)
    tasks_.erase(std::ranges::find_if(tasks_, [](const Task& task) { return task.reply.has_value(); }));
  Task task{std::to_string(++last_id_), request.identity.account, request.method + ' ' + request.path};
  task.bytes = request.body.size();
  task.stop = can_be_stopped ? request.gone : nullptr;
  task.progress = request.progress;
  tasks_.push_back(std::move(task));
  return json(tasks_.back());
}

void Tasks::end(const std::string& id, const Reply& reply) {
  Reply kept = reply;
  kept.body.freeze();
  const std::size_t bytes = bytes_of(kept);
  const services::MutexLock lock(mutex_);
  const auto task = std::ranges::find(tasks_, id, &Task::id);
  if (task == tasks_.end()) return;
  task->reply = std::move(kept);
  task->bytes = bytes;
  if (task->is_done() && task->progress) task->progress->finish();
  forget_oldest();
}

// The last of them stays, however large it is.
void Tasks::forget_oldest() {
  const auto is_over = [](const Task& task) { return task.reply.has_value(); };
  std::size_t count = 0, bytes = 0;
  for (const Task& task : tasks_ | std::views::filter(is_over)) {
    ++count;
    bytes += task.bytes;
  }
  for (; bytes > kMostBytes && count > 1; --count) {
    const auto oldest = std::ranges::find_if(tasks_, is_over);
    bytes -= oldest->bytes;
    tasks_.erase(oldest);
  }
}

Expected<std::size_t> Tasks::find_task(const std::string& id, const Identity& who) const {
  const auto task = std::ranges::find(tasks_, id, &Task::id);
  if (task == tasks_.end() || (who.account != task->account && who.role != Role::admin))
    return unexpected(ErrorCode::not_found, "there is no task of this id", id);
  return static_cast<std::size_t>(task - tasks_.begin());
}

Expected<Value> Tasks::find(const std::string& id, const Identity& who) const {
  const services::MutexLock lock(mutex_);
  ASSIGN_OR_RETURN(const std::size_t index, find_task(id, who));
  return json(tasks_[index]);
}

Expected<Value> Tasks::cancel(const std::string& id, const Identity& who) {
  const services::MutexLock lock(mutex_);
  ASSIGN_OR_RETURN(const std::size_t index, find_task(id, who));
  Task& task = tasks_[index];
  if (task.reply) return unexpected(ErrorCode::conflict, "it is over", id);
  if (!task.stop) return unexpected(ErrorCode::conflict, "it cannot be told to stop", id);
  task.cancelled = true;
  *task.stop = true;
  return json(task);
}

Value Tasks::json(const Task& task) {
  Dict json{{"id", task.id}, {"request", task.request}};
  if (const auto progress = task.progress ? task.progress->state() : std::nullopt)
    json.set("progress", progress_json(*progress));
  if (!task.reply) {
    json.set("status", "running");
    return json;
  }
  const Reply& reply = *task.reply;
  json.set("status", task.is_done() ? "done" : task.cancelled ? "cancelled" : "failed");
  json.set("code", reply.status);
  if (task.is_done()) {
    json.set("result", reply.body);
    for (const auto& [name, value] : reply.headers)
      if (name == "Location") json.set("location", value);
  } else {
    for (const auto& [key, value] : reply.body.as_dict()) json.set(key, value);  // schemas/errors.json
  }
  return json;
}

}  // namespace race::server
