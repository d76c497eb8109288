// Cores that are loaded anew, removed, or set aside for a restore. A load or removal goes on where the core answers,
// and then on the thread of changes, as the store may take its time: one core that is busy keeps no other from it.
#include <utility>

#include "server/execution/cores.h"

namespace race::server {
namespace {

using Errors = std::vector<Error>;

}  // namespace

// While it lives, no other change of the core begins.
class Cores::Change {
 public:
  Change(std::shared_ptr<Changing> changing, RunId id) : changing_(std::move(changing)), id_(id) {}
  Change(const Change&) = delete;
  ~Change() { end(); }
  /// Before who asked is answered: the next may begin then.
  void end() {
    if (std::exchange(ended_, true)) return;
    const services::MutexLock lock(changing_->mutex);
    changing_->ids.erase(id_);
  }

 private:
  const std::shared_ptr<Changing> changing_;
  const RunId id_;
  bool ended_ = false;
};

Expected<std::shared_ptr<Cores::Change>> Cores::begin_change(RunId id, bool is_load) {
  const services::MutexLock lock(mutex_);
  if (is_load && restoring_) return unexpected(ErrorCode::conflict, "a backup is being restored");
  const services::MutexLock changing(changing_->mutex);
  if (!changing_->ids.insert(id).second)
    return unexpected(ErrorCode::conflict, "core " + std::to_string(id) + " is being loaded or removed");
  return std::make_shared<Change>(changing_, id);
}

struct Cores::Load {
  std::shared_ptr<Core> old;
  std::string document;
  std::int64_t revision;
  RunModel model;
  bool live;
  std::shared_ptr<Change> change;
  Done<std::shared_ptr<Core>, Errors> done;
};

void Cores::load(const std::string& id, const StoredDocument& stored, Dict arguments, std::optional<bool> live,
                 Done<std::shared_ptr<Core>, Errors> done) {
  auto old = find(id);
  if (!old) return done(refused<Errors>(std::move(old).error()));
  auto model = run_model(stored, std::move(arguments));
  if (!model) return done(tl::unexpected(std::move(model).error()));
  auto change = begin_change((*old)->run_id(), true);
  if (!change) return done(refused<Errors>(std::move(change).error()));
  old = find(id);  // it may be another one by now
  if (!old) return done(refused<Errors>(std::move(old).error()));
  auto load = std::make_shared<Load>(Load{*old, stored.name, stored.revision, std::move(*model),
                                          live.value_or((*old)->is_live()), std::move(*change), std::move(done)});
  (*old)->retire([this, load](const Expected<Core::Preparation>& preparation) {
    changes_.post([this, load, preparation] {
      auto core = preparation ? finish_load(*load, *preparation) : refused<Errors>(preparation.error());
      load->change->end();
      load->done(std::move(core));
    });
  });
}

// The new core has the number of the old one, which begins no more.
Checked<std::shared_ptr<Core>> Cores::finish_load(Load& load, Core::Preparation preparation) {
  auto& [header, services] = load.model;
  auto run = resources_.runs.replace(load.old->run_id(), {load.document, load.revision, header, std::move(services)});
  if (!run) {
    load.old->reinstate();
    return refused<Errors>(std::move(run).error());
  }
  auto core = Core::create(std::move(*run), std::move(header), resources_, load.live);
  if (!core) return refused<Errors>(std::move(core).error());
  (*core)->replace(*load.old, std::move(preparation));
  add(*core);
  return *core;
}

Checked<std::shared_ptr<Core>> Cores::load(const std::string& id, const StoredDocument& stored, Dict arguments) {
  return wait_for<std::shared_ptr<Core>, Errors>(
      [&](auto done) { load(id, stored, std::move(arguments), std::nullopt, std::move(done)); });
}

void Cores::remove(const std::string& id, Done<std::shared_ptr<Core>> done) {
  auto found = find(id);
  if (!found) return done(tl::unexpected(std::move(found).error()));
  auto change = begin_change((*found)->run_id(), false);
  if (!change) return done(tl::unexpected(std::move(change).error()));
  found = find(id);
  if (!found) return done(tl::unexpected(std::move(found).error()));
  const std::shared_ptr<Core> core = *found;
  core->dismiss([this, core, change = *change, done = std::move(done)](const Expected<bool>& had_begun) {
    changes_.post([this, core, change, done, had_begun] {
      auto removed = finish_removal(core, had_begun);
      change->end();
      done(std::move(removed));
    });
  });
}

// One whose journal is damaged cannot go on in any case; its run stays in the store.
Expected<std::shared_ptr<Core>> Cores::finish_removal(const std::shared_ptr<Core>& core,
                                                      const Expected<bool>& had_begun) {
  if (!had_begun && had_begun.error().code != ErrorCode::corrupt) return tl::unexpected(had_begun.error());
  if (had_begun && !*had_begun)
    if (auto removed = resources_.runs.remove(core->run_id());
        !removed && removed.error().code != ErrorCode::not_found) {
      core->reinstate();
      return tl::unexpected(removed.error());
    }
  core->close();
  {
    const services::MutexLock lock(mutex_);
    cores_.erase(core->run_id());
  }
  resources_.watcher.core_removed(core->id());
  return core;
}

Expected<std::shared_ptr<Core>> Cores::remove(const std::string& id) {
  return wait_for<std::shared_ptr<Core>>([&](auto done) { remove(id, std::move(done)); });
}

// A core that has not begun is retired, so that no start gets through.
Expected<void> Cores::close_for_restore() {
  {
    const services::MutexLock lock(mutex_);
    const services::MutexLock no_change(changing_->mutex);
    if (restoring_ || coming_ > 0 || !changing_->ids.empty())
      return unexpected(ErrorCode::conflict, "a core is being created, loaded or removed; ask again");
    restoring_ = true;
  }
  for (const auto& core : all()) {
    if (core->retire()) continue;
    if (is_over(core->info())) continue;
    reopen();
    return unexpected(ErrorCode::conflict, "the run of core " + core->id() + " is not over");
  }
  return {};
}

void Cores::reopen() {
  for (const auto& core : all()) core->reinstate();
  const services::MutexLock lock(mutex_);
  restoring_ = false;
}

}  // namespace race::server
