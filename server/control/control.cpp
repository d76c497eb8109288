#include "server/control/control.h"

#include "services/component.h"

namespace race::server {

using services::error_value;
using services::MutexLock;

bool Control::stop(Stop stop) {
  const MutexLock lock(mutex_);
  ++fence_;
  if (stopped_) return false;
  stopped_ = std::move(stop);
  tell();
  return true;
}

void Control::reset() {
  const MutexLock lock(mutex_);
  if (!stopped_) return;
  stopped_.reset();
  tell();
}

std::optional<Control::Stop> Control::stopped() const {
  const MutexLock lock(mutex_);
  return stopped_;
}

void Control::set_stop_port(std::uint16_t place, std::uint16_t port) {
  const MutexLock lock(mutex_);
  stop_ports_[place] = port;
}

Value Control::json() const {
  const MutexLock lock(mutex_);
  return state();
}

Value Control::state() const {
  Dict json{{"stopped", nullptr}};
  if (stopped_) json.set("stopped", Dict{{"by", stopped_->by}, {"time", stopped_->time}});
  List leases;
  for (const auto& [service, core] : leases_) leases.push_back(Dict{{"service", service}, {"core", core}});
  json.set("leases", std::move(leases));
  List ports;
  for (const auto& [place, port] : stop_ports_)
    ports.push_back(Dict{{"port", std::int64_t{place}}, {"stop_port", std::int64_t{port}}});
  json.set("stop_ports", std::move(ports));
  Value value(std::move(json));
  value.freeze();
  return value;
}

Expected<std::uint64_t> Control::begin() {
  const MutexLock lock(mutex_);
  if (stopped_) return unexpected(ErrorCode::stopped, "the cell was stopped by " + stopped_->by + "; reset it first");
  return fence_;
}

std::optional<Value> Control::refuse(const services::Caller& caller, const std::string& service) {
  const MutexLock lock(mutex_);
  if (stopped_ || caller.fence != fence_)
    return error_value(name(ErrorCode::stopped),
                       "the cell was stopped; nothing moves until it is reset, and a run begins");
  const auto [lease, is_new] = leases_.try_emplace(service, caller.core);
  if (lease->second != caller.core)
    return error_value(name(ErrorCode::leased), "run " + lease->second + " has `" + service + "` until it is over");
  if (is_new) tell();
  return std::nullopt;
}

void Control::release(const std::string& core, const std::string& service) {
  const MutexLock lock(mutex_);
  const auto lease = leases_.find(service);
  if (lease == leases_.end() || lease->second != core) return;
  leases_.erase(lease);
  tell();
}

}  // namespace race::server
