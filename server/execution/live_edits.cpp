#include "server/execution/live_edits.h"

#include <utility>

#include "services/failures.h"

namespace race::server {

void LiveEdits::changed(const std::string& document) {
  const services::MutexLock lock(mutex_);
  if (closed_) return;
  changed_.insert(document);
  if (!std::exchange(busy_, true)) pool_.post([this] { bring_all(); });
}

void LiveEdits::close() {
  {
    const services::MutexLock lock(mutex_);
    closed_ = true;
    changed_.clear();
  }
  pool_.end();
}

void LiveEdits::bring_all() {
  while (const auto document = next()) services::run_reporting("an edit of live cores", [&] { bring(*document); });
}

std::optional<std::string> LiveEdits::next() {
  const services::MutexLock lock(mutex_);
  busy_ = !changed_.empty();
  if (!busy_) return std::nullopt;
  return std::move(changed_.extract(changed_.begin()).value());
}

void LiveEdits::bring(const std::string& document) {
  std::vector<std::shared_ptr<Core>> followers;
  for (const auto& core : cores_.all())
    if (core->is_live() && *core->info().find("document") == Value(document)) followers.push_back(core);
  if (followers.empty()) return;
  const auto entry = documents_.entry(document);
  const auto stored = documents_.get(document);
  for (const auto& core : followers)
    if (stored)
      bring(core, *stored);
    else if (entry)
      core->refuse_edit(entry->revision.number, stored.error());
}

// One that has not begun is loaded anew: there is nothing to carry over. It may begin meanwhile.
void LiveEdits::bring(const std::shared_ptr<Core>& core, const StoredDocument& stored) {
  const Value info = core->info();
  if (*info.find("status") == Value("ready")) {
    if (*info.find("revision") == Value(stored.revision)) return;
    const auto loaded = cores_.load(core->id(), stored, core->header().arguments);
    if (loaded) return;
    if (loaded.error().front().code != ErrorCode::conflict) return core->refuse_edit(stored.revision, loaded.error());
  }
  auto edit = cores_.edit_for(*core, stored);
  if (!edit) return core->refuse_edit(stored.revision, edit.error());
  edit->stale = [this, document = stored.name] { changed(document); };
  core->follow(std::move(*edit));
}

}  // namespace race::server
