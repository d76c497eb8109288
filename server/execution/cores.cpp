#include "server/execution/cores.h"

#include <charconv>

#include "core/rcm/native.h"
#include "core/rcm/translate.h"

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

std::uint64_t number_of(const std::string& id) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), number);
  return error == std::errc() && end == id.data() + id.size() ? number : 0;
}

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

Checked<std::shared_ptr<Core>> Cores::create(const std::string& name, const rcm::Document& document, Dict arguments) {
  if (auto errors = wrong_types(document, host_.services()); !errors.empty()) return tl::unexpected(std::move(errors));
  auto native = rcm::translate(document);
  if (!native) return tl::unexpected(std::move(native).error());
  auto program = semantics::Program::build(*native, host_.models());
  if (!program) return tl::unexpected(std::move(program).error());
  if (auto errors = semantics::check_arguments(**program, arguments); !errors.empty())
    return tl::unexpected(std::move(errors));
  arguments.freeze();
  Value model = rcm::write_native(document, *native);
  execution::JournalHeader header{std::move(model.freeze()), std::move(*program), std::move(arguments), {}};
  std::uint64_t number = 0;
  {
    const services::MutexLock lock(mutex_);
    if (cores_.size() >= kMost)
      return tl::unexpected(std::vector<Error>{
          {ErrorCode::conflict, "there are " + std::to_string(kMost) + " cores already; delete one"}});
    number = next_++;
  }
  auto core = Core::create(std::to_string(number), name, std::move(header), pool_, host_, watcher_);
  if (!core) return tl::unexpected(std::vector<Error>{std::move(core).error()});
  // Under the lock: who finds the core and removes it is heard after this.
  const services::MutexLock lock(mutex_);
  cores_.emplace(number, *core);
  (*core)->announce();
  return *core;
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

Expected<std::shared_ptr<Core>> Cores::take(const std::string& id) {
  const services::MutexLock lock(mutex_);
  const auto found = cores_.find(number_of(id));
  if (found == cores_.end()) return no_core(id);
  auto core = std::move(found->second);
  cores_.erase(found);
  return core;
}

Expected<std::shared_ptr<Core>> Cores::remove(const std::string& id) {
  ASSIGN_OR_RETURN(auto core, take(id));
  const auto stopped = core->stop();
  // `conflict`: the run is over or was never started; there is nothing to stop.
  if (!stopped && stopped.error().code != ErrorCode::conflict) watcher_.printed(core->id(), to_string(stopped.error()));
  core->close();
  watcher_.core_removed(core->id());
  return core;
}

void Cores::deliver(const services::Delivery& delivery) {
  const services::MutexLock lock(mutex_);
  if (delivery.kind == services::Delivery::Kind::response) {
    const auto found = cores_.find(number_of(delivery.caller.core));
    if (found != cores_.end()) found->second->deliver(delivery);
    return;
  }
  for (const auto& [number, core] : cores_) {
    const semantics::Program& program = core->program();
    if (program.names_event(program.services.find_event(delivery.key, delivery.name))) core->deliver(delivery);
  }
}

void Cores::close() {
  for (const auto& core : all()) core->close();
}

}  // namespace race::server
