#include "server/handlers/tasks.h"

#include <algorithm>
#include <utility>

#include "server/http/field_list.h"

namespace race::server {

bool Tasks::is_preferred(const Request& request) {
  return std::ranges::any_of(elements_of(request, "prefer"), [](std::string_view preference) {
    return lower(trim(preference.substr(0, preference.find(';')))) == "respond-async";
  });
}

Expected<Value> Tasks::begin(const Request& request, bool can_be_stopped) {
  const services::MutexLock lock(mutex_);
  const auto is_over = [](const Task& task) { return task.reply.has_value(); };
  const auto over = static_cast<std::size_t>(std::ranges::count_if(tasks_, is_over));
  if (tasks_.size() - over >= kMostRunning)
    return unexpected(ErrorCode::unavailable, "the server works on " + std::to_string(kMostRunning) + " already");
  if (tasks_.size() >= kMost) tasks_.erase(std::ranges::find_if(tasks_, is_over));
  tasks_.push_back({std::to_string(++last_id_), request.identity.account, request.method + ' ' + request.path,
                    can_be_stopped ? request.gone : nullptr});
  return json(tasks_.back());
}

void Tasks::end(const std::string& id, const Reply& reply) {
  Reply kept = reply;
  kept.body.freeze();
  const services::MutexLock lock(mutex_);
  const auto task = std::ranges::find(tasks_, id, &Task::id);
  if (task != tasks_.end()) task->reply = std::move(kept);
}

Expected<const Tasks::Task*> Tasks::find_task(const std::string& id, const Identity& who) const {
  const auto task = std::ranges::find(tasks_, id, &Task::id);
  if (task == tasks_.end() || (who.account != task->account && who.role != Role::admin))
    return unexpected(ErrorCode::not_found, "there is no task of this id", id);
  return &*task;
}

Expected<Value> Tasks::find(const std::string& id, const Identity& who) const {
  const services::MutexLock lock(mutex_);
  ASSIGN_OR_RETURN(const Task* task, find_task(id, who));
  return json(*task);
}

Expected<Value> Tasks::cancel(const std::string& id, const Identity& who) {
  const services::MutexLock lock(mutex_);
  ASSIGN_OR_RETURN(const Task* task, find_task(id, who));
  if (task->reply) return unexpected(ErrorCode::conflict, "it is over", id);
  if (!task->stop) return unexpected(ErrorCode::conflict, "it cannot be told to stop", id);
  *task->stop = true;
  return json(*task);
}

Value Tasks::json(const Task& task) {
  Dict json{{"id", task.id}, {"request", task.request}};
  if (!task.reply) {
    json.set("status", "running");
    return json;
  }
  const Reply& reply = *task.reply;
  const bool is_done = reply.status < 400;
  json.set("status", is_done ? "done" : task.stop && *task.stop ? "cancelled" : "failed");
  json.set("code", reply.status);
  if (is_done) {
    json.set("result", reply.body);
    for (const auto& [name, value] : reply.headers)
      if (name == "Location") json.set("location", value);
  } else {
    for (const auto& [key, value] : reply.body.as_dict()) json.set(key, value);  // schemas/errors.json
  }
  return json;
}

}  // namespace race::server
