#include "server/execution/cores.h"

#include <charconv>

#include "core/rcm/native.h"
#include "core/rcm/translate.h"
#include "server/wire/calendar.h"

namespace race::server {
namespace {

std::vector<Error> wrong_types(const rcm::Document& document, const std::vector<services::ServiceStatus>& services) {
  std::vector<Error> errors;
  for (const services::ServiceStatus& service : services) {
    const auto expected = document.services.find(service.key);
    if (expected == document.services.end() || expected->second == service.type) continue;
    errors.push_back(
        {ErrorCode::type,
         "the task expects a service of type `" + expected->second + "`, here it is `" + service.type + "`",
         "services/" + service.key});
  }
  return errors;
}

// 0 of what is no id. A number has one form: with zeros before it, it would name a core once more.
std::uint64_t number_of(const std::string& id) {
  if (id.starts_with('0')) return 0;
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), number);
  return error == std::errc() && end == id.data() + id.size() ? number : 0;
}

tl::unexpected<std::vector<Error>> one(Error error) { return tl::unexpected(std::vector<Error>{std::move(error)}); }

tl::unexpected<Error> no_core(const std::string& id) {
  return unexpected(ErrorCode::not_found, "there is no core of this id", id);
}

}  // namespace

Checked<Value> native_json(const rcm::Document& document) {
  auto native = rcm::translate(document);
  if (!native) return tl::unexpected(std::move(native).error());
  Value json = rcm::write_native(document, *native);
  return std::move(json.freeze());
}

Value cores_json(const Cores& cores) {
  List list;
  for (const auto& core : cores.all()) list.push_back(core->info());
  Value json = Dict{{"cores", std::move(list)}};
  return std::move(json.freeze());
}

Checked<execution::JournalHeader> Cores::header_of(const StoredDocument& stored, Dict arguments) const {
  const services::Host& host = resources_.host;
  if (auto errors = wrong_types(stored.document, host.services()); !errors.empty())
    return tl::unexpected(std::move(errors));
  auto native = rcm::translate(stored.document);
  if (!native) return tl::unexpected(std::move(native).error());
  auto program = semantics::Program::build(*native, host.models());
  if (!program) return tl::unexpected(std::move(program).error());
  if (auto errors = semantics::check_arguments(**program, arguments); !errors.empty())
    return tl::unexpected(std::move(errors));
  arguments.freeze();
  Value model = rcm::write_native(stored.document, *native);
  return execution::JournalHeader{std::move(model.freeze()), std::move(*program), std::move(arguments), {}};
}

Checked<LiveEdit> Cores::edit_for(const Core& core, const StoredDocument& stored) const {
  const services::Host& host = resources_.host;
  if (auto errors = wrong_types(stored.document, host.services()); !errors.empty())
    return tl::unexpected(std::move(errors));
  const auto native = native_json(stored.document);
  if (!native) return tl::unexpected(native.error());
  const execution::ExecutedModel base = core.model();
  auto entry = execution::edit_between(base, *native, host.models());
  if (!entry) return one(std::move(entry).error());
  entry->revision = stored.revision;
  LiveEdit edit{stored.revision, base.program, std::move(*entry), {}, {}};
  if (edit.changes_nothing()) return edit;
  auto model = execution::edited(base, edit.entry);
  if (!model) return tl::unexpected(std::move(model).error());
  edit.model = std::move(*model);
  return edit;
}

Checked<std::shared_ptr<Core>> Cores::create(const StoredDocument& stored, Dict arguments) {
  auto header = header_of(stored, std::move(arguments));
  if (!header) return tl::unexpected(std::move(header).error());
  if (auto reserved = reserve_place(); !reserved) return one(std::move(reserved).error());
  auto core = create_run(stored, std::move(*header));
  if (core) add(*core);
  const services::MutexLock lock(mutex_);
  --coming_;
  if (!core) return one(std::move(core).error());
  return *core;
}

Expected<void> Cores::reserve_place() {
  const services::MutexLock lock(mutex_);
  if (restoring_) return unexpected(ErrorCode::conflict, "a backup is being restored");
  if (cores_.size() + coming_ >= kMost)
    return unexpected(ErrorCode::conflict, "there are " + std::to_string(kMost) + " cores already; delete one");
  ++coming_;
  return {};
}

bool Cores::is_restoring() const {
  const services::MutexLock lock(mutex_);
  return restoring_;
}

Expected<std::shared_ptr<Core>> Cores::create_run(const StoredDocument& stored, execution::JournalHeader header) {
  ASSIGN_OR_RETURN(RunRecord run,
                   resources_.runs.create({stored.name, stored.revision, header, resources_.host.models()}, now_ms()));
  return Core::create(std::move(run), std::move(header), resources_);
}

// The new core has the number of the old one, which begins no more.
Checked<std::shared_ptr<Core>> Cores::load(const std::string& id, const StoredDocument& stored, Dict arguments) {
  const auto old = find(id);
  if (!old) return one(old.error());
  auto header = header_of(stored, std::move(arguments));
  if (!header) return tl::unexpected(std::move(header).error());
  const services::MutexLock one_at_a_time(loading_);
  if (is_restoring()) return one({ErrorCode::conflict, "a backup is being restored"});
  auto preparation = (*old)->retire();
  if (!preparation) return one(std::move(preparation).error());
  auto run =
      resources_.runs.replace((*old)->run_id(), {stored.name, stored.revision, *header, resources_.host.models()});
  if (!run) {
    (*old)->reinstate();
    return one(std::move(run).error());
  }
  auto core = Core::create(std::move(*run), std::move(*header), resources_);
  if (!core) return one(std::move(core).error());
  (*core)->replace(**old, std::move(*preparation));
  add(*core);
  return *core;
}

Expected<void> Cores::recover() {
  ASSIGN_OR_RETURN(const RunList open, resources_.runs.open_runs());
  for (const DamagedRun& run : open.damaged)
    resources_.watcher.printed(std::to_string(run.id),
                               (run.is_over ? "is damaged: " : "cannot be rebuilt: ") + to_string(run.error));
  for (const RunRecord& run : open.runs) {
    auto header = resources_.runs.header(run.id);
    auto core = !header          ? Expected<std::shared_ptr<Core>>(tl::unexpect, header.error())
                : run.steps == 0 ? Core::create(run, std::move(*header), resources_)
                                 : Core::recover(run, std::move(*header), resources_);
    if (core)
      add(*core);
    else
      resources_.watcher.printed(std::to_string(run.id), "cannot be rebuilt: " + to_string(core.error()));
  }
  return {};
}

// Under the lock: who finds the core and removes it is heard after this.
void Cores::add(const std::shared_ptr<Core>& core) {
  const services::MutexLock lock(mutex_);
  cores_.insert_or_assign(core->run_id(), core);
  core->announce();
}

Expected<std::shared_ptr<Core>> Cores::find(const std::string& id) const {
  const services::MutexLock lock(mutex_);
  const auto found = cores_.find(number_of(id));
  if (found == cores_.end()) return no_core(id);
  return found->second;
}

std::vector<std::shared_ptr<Core>> Cores::all() const {
  const services::MutexLock lock(mutex_);
  std::vector<std::shared_ptr<Core>> all;
  for (const auto& [number, core] : cores_) all.push_back(core);
  return all;
}

Expected<std::shared_ptr<Core>> Cores::remove(const std::string& id) {
  const services::MutexLock one_at_a_time(loading_);
  ASSIGN_OR_RETURN(auto core, find(id));
  const auto had_begun = core->dismiss();
  // One whose journal is damaged cannot go on in any case; the run stays in the store.
  if (!had_begun && had_begun.error().code != ErrorCode::corrupt) return tl::unexpected(had_begun.error());
  if (had_begun && !*had_begun)
    if (auto removed = resources_.runs.remove(core->run_id()); !removed && removed.error().code != ErrorCode::not_found)
      return tl::unexpected(removed.error());
  core->close();
  {
    const services::MutexLock lock(mutex_);
    cores_.erase(core->run_id());
  }
  resources_.watcher.core_removed(core->id());
  return core;
}

bool is_over(const Value& core) {
  const std::string status = core.find("status")->as_string();
  return status == "ended" || status == "faulted" || status == "aborted";
}

// A core that has not begun is retired, so that no start gets through.
Expected<void> Cores::close_for_restore() {
  const services::MutexLock one_at_a_time(loading_);
  {
    const services::MutexLock lock(mutex_);
    if (restoring_ || coming_ > 0) return unexpected(ErrorCode::conflict, "a core is being created, ask again");
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

void Cores::deliver(const services::Delivery& delivery) {
  const services::MutexLock lock(mutex_);
  if (delivery.kind == services::Delivery::Kind::response) {
    const auto found = cores_.find(number_of(delivery.caller.core));
    if (found != cores_.end()) found->second->deliver(delivery);
    return;
  }
  for (const auto& [number, core] : cores_) {
    if (core->names_event(delivery.key, delivery.name)) core->deliver(delivery);
  }
}

void Cores::close() {
  for (const auto& core : all()) core->close();
}

}  // namespace race::server
