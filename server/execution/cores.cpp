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

execution::Interfaces models_of(const std::vector<services::ServiceStatus>& services) {
  execution::Interfaces models;
  for (const services::ServiceStatus& service : services) models.emplace(service.key, *service.model);
  return models;
}

tl::unexpected<std::vector<Error>> one(Error error) { return refused<std::vector<Error>>(std::move(error)); }

tl::unexpected<Error> no_core(const std::string& id) {
  return unexpected(ErrorCode::not_found, "there is no core of this id", id);
}

}  // namespace

// A number has one form: with zeros before it, it would name a core once more.
RunId Cores::number_of(const std::string& id) {
  if (id.starts_with('0')) return 0;
  RunId number = 0;
  const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), number);
  return error == std::errc() && end == id.data() + id.size() ? number : 0;
}

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

Checked<Cores::RunModel> Cores::run_model(const StoredDocument& stored, Dict arguments) const {
  const std::vector<services::ServiceStatus> services = resources_.host.services();
  if (auto errors = wrong_types(stored.document, services); !errors.empty()) return tl::unexpected(std::move(errors));
  auto native = rcm::translate(stored.document);
  if (!native) return tl::unexpected(std::move(native).error());
  execution::Interfaces models = models_of(services);
  auto program = semantics::Program::build(*native, models);
  if (!program) return tl::unexpected(std::move(program).error());
  if (auto errors = semantics::check_arguments(**program, arguments); !errors.empty())
    return tl::unexpected(std::move(errors));
  arguments.freeze();
  Value model = rcm::write_native(stored.document, *native);
  return RunModel{{std::move(model.freeze()), std::move(*program), std::move(arguments), {}}, std::move(models)};
}

Checked<LiveEdit> Cores::edit_for(const Core& core, const StoredDocument& stored) const {
  const std::vector<services::ServiceStatus> services = resources_.host.services();
  if (auto errors = wrong_types(stored.document, services); !errors.empty()) return tl::unexpected(std::move(errors));
  const auto native = native_json(stored.document);
  if (!native) return tl::unexpected(native.error());
  const execution::ExecutedModel base = core.model();
  auto entry = execution::edit_between(base, *native, models_of(services));
  if (!entry) return one(std::move(entry).error());
  entry->revision = stored.revision;
  LiveEdit edit{stored.revision, base.program, std::move(*entry), {}, {}};
  if (edit.changes_nothing()) return edit;
  auto model = execution::edited(base, edit.entry);
  if (!model) return tl::unexpected(std::move(model).error());
  edit.model = std::move(*model);
  return edit;
}

Checked<void> Cores::check(const StoredDocument& stored, Dict arguments) const {
  if (auto model = run_model(stored, std::move(arguments)); !model) return tl::unexpected(std::move(model).error());
  return {};
}

Checked<std::shared_ptr<Core>> Cores::create(const StoredDocument& stored, Dict arguments, bool live) {
  auto model = run_model(stored, std::move(arguments));
  if (!model) return tl::unexpected(std::move(model).error());
  const auto reserved = reserve_place();
  if (!reserved) return one(reserved.error());
  if (*reserved) resources_.watcher.core_removed((*reserved)->id());
  auto core = create_run(stored, std::move(*model), live);
  if (core) add(*core);
  const services::MutexLock lock(mutex_);
  --coming_;
  if (!core) return one(std::move(core).error());
  return *core;
}

Expected<std::shared_ptr<Core>> Cores::reserve_place() {
  const services::MutexLock lock(mutex_);
  if (restoring_) return unexpected(ErrorCode::conflict, "a backup is being restored");
  std::shared_ptr<Core> over;
  if (cores_.size() + coming_ >= kMost) over = take_oldest_over();
  if (cores_.size() + coming_ >= kMost)
    return unexpected(ErrorCode::conflict,
                      "there are " + std::to_string(kMost) + " cores already, and no run of them is over; delete one");
  ++coming_;
  return over;
}

// Its run is stored: all that is shown of a run is durable.
std::shared_ptr<Core> Cores::take_oldest_over() {
  const services::MutexLock changing(changing_->mutex);
  for (const auto& [number, core] : cores_) {
    if (changing_->ids.contains(number) || !is_over(core->info())) continue;
    core->close();
    return cores_.extract(number).mapped();
  }
  return nullptr;
}

Expected<std::shared_ptr<Core>> Cores::create_run(const StoredDocument& stored, RunModel model, bool live) {
  auto& [header, services] = model;
  ASSIGN_OR_RETURN(RunRecord run,
                   resources_.runs.create({stored.name, stored.revision, header, std::move(services)}, now_ms()));
  return Core::create(std::move(run), std::move(header), resources_, live);
}

Expected<void> Cores::recover() {
  ASSIGN_OR_RETURN(const RunList open, resources_.runs.open_runs());
  for (const DamagedRun& run : open.damaged)
    resources_.watcher.run_lost(std::to_string(run.id),
                                (run.is_over ? "is damaged: " : "cannot be rebuilt: ") + to_string(run.error));
  for (const RunRecord& run : open.runs) {
    if (ends_) return {};
    auto header = resources_.runs.header(run.id);
    auto core = !header          ? Expected<std::shared_ptr<Core>>(tl::unexpect, header.error())
                : run.steps == 0 ? Core::create(run, std::move(*header), resources_)
                                 : Core::recover(run, std::move(*header), resources_);
    if (core)
      add(*core);
    else
      resources_.watcher.run_lost(std::to_string(run.id), "cannot be rebuilt: " + to_string(core.error()));
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

bool is_over(const Value& core) {
  const std::string status = core.find("status")->as_string();
  return is_over(std::string_view(status));
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

void Cores::service_changed(const std::string& service, const std::optional<std::string>& state) {
  const services::MutexLock lock(mutex_);
  for (const auto& [number, core] : cores_) core->service_changed(service, state);
}

void Cores::close() {
  ends_ = true;
  for (const auto& core : all()) core->end();
}

}  // namespace race::server
