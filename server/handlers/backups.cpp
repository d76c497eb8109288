// GET and POST /api/v1/backups, GET and DELETE /api/v1/backups/{name}, POST /api/v1/backups/{name}/restore. One at a
// time is made, removed or brought back, on a thread of their own: no handler waits for another.
#include "server/editing/editing.h"
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"
#include "server/handlers/idempotency.h"
#include "server/queue/run_queue.h"
#include "server/store/backup.h"
#include "server/threads/strand.h"
#include "server/wire/calendar.h"

namespace race::server {
namespace {

Handled answer_with(const Expected<Backup>& backup) {
  if (!backup) return failed(backup.error());
  return ok(backup_json(*backup));
}

}  // namespace

Handled list_backups(const Request&, Backups& backups) {
  const auto found = backups.list();
  if (!found) return failed(found.error());
  List list;
  for (const Backup& backup : *found) list.push_back(backup_json(backup));
  return ok(Dict{{"backups", std::move(list)}});
}

void create_backup(const Request& request, Respond respond, Backups& backups, Pool& restores) {
  restores.post([&backups, progress = request.progress, respond = std::move(respond)] {
    const auto backup = backups.create(now_ms(), progress.get());
    if (!backup) return respond(failed(backup.error()));
    respond(created(backup_json(*backup), "/api/v1/backups/" + backup->name));
  });
}

Handled get_backup(const Request& request, Backups& backups) {
  return answer_with(backups.find(request.parameters.at("name")));
}

void delete_backup(const Request& request, Respond respond, Backups& backups, Pool& restores) {
  restores.post([&backups, name = request.parameters.at("name"), respond = std::move(respond)] {
    respond(answer_with(backups.remove(name)));
  });
}

namespace {

// Cores that are over or have not begun go: the store of that time knows others. Waits for them, and for edits.
Handled restore(const std::string& name, WorkProgress* progress, Backups& backups, Cores& cores, Editing& editing,
                IdempotentAnswers& answers, RunQueue& queue) {
  const auto paused = editing.pause();
  if (!paused) return failed(paused.error());
  if (auto closed = cores.close_for_restore(); !closed) return failed(std::move(closed).error());
  bool changes = false;
  const auto begin = [&]() -> Expected<void> {
    for (const auto& core : cores.all())
      if (auto removed = cores.remove(core->id()); !removed) return tl::unexpected(std::move(removed).error());
    changes = true;
    return {};
  };
  const auto restored = backups.restore(name, begin, progress);
  if (changes) {  // while no core can be created: what is queued is of a store that is no more
    queue.cancel_all();
    answers.clear();
  }
  cores.reopen();
  return answer_with(restored);
}

}  // namespace

void restore_backup(const Request& request, Respond respond, Backups& backups, Cores& cores, Editing& editing,
                    IdempotentAnswers& answers, RunQueue& queue, Pool& restores) {
  restores.post([&, name = request.parameters.at("name"), progress = request.progress, respond = std::move(respond)] {
    respond(restore(name, progress.get(), backups, cores, editing, answers, queue));
  });
}

}  // namespace race::server
