#include "server/control/control.h"

#include "services/component.h"

namespace race::server {

using services::error_value;
using services::MutexLock;

bool Control::stop(Stop stop) {
  const MutexLock lock(mutex_);
  moved_.clear();
  free_fence_ = ++last_fence_;
  if (holder_) holder_->fence = ++last_fence_;
  if (stopped_) return false;
  ++stops_;
  stopped_ = std::move(stop);
  tell();
  return true;
}

bool Control::reset() {
  const MutexLock lock(mutex_);
  if (!stopped_) return false;
  stopped_.reset();
  if (holder_)
    holder_->fence = ++last_fence_;  // a button that was pressed while it was stopped is to be let go of first
  tell();
  return true;
}

std::optional<Control::Stop> Control::stopped() const {
  const MutexLock lock(mutex_);
  return stopped_;
}

std::uint64_t Control::stops() const {
  const MutexLock lock(mutex_);
  return stops_;
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
  Dict json{{"stopped", nullptr}, {"mode", std::string(name(mode_))}, {"holder", nullptr}, {"request", nullptr}};
  if (stopped_) json.set("stopped", Dict{{"by", stopped_->by}, {"time", stopped_->time}});
  if (holder_) json.set("holder", Dict{{"number", static_cast<std::int64_t>(holder_->number)}, {"by", holder_->by}});
  if (request_) json.set("request", Dict{{"id", request_->id}, {"by", request_->by}});
  List reservations;
  for (const auto& [service, reservation] : reservations_)
    reservations.push_back(Dict{{"service", service}, {"core", reservation.core}});
  json.set("leases", std::move(reservations));
  List ports;
  for (const auto& [place, port] : stop_ports_)
    ports.push_back(Dict{{"port", std::int64_t{place}}, {"stop_port", std::int64_t{port}}});
  json.set("stop_ports", std::move(ports));
  Value value(std::move(json));
  value.freeze();
  return value;
}

bool Control::is_good(std::uint64_t fence) const {
  return !stopped_ && (fence == free_fence_ || (holder_ && fence == holder_->fence));
}

std::optional<Error> Control::refuse_stopped() const {
  if (!stopped_) return std::nullopt;
  return Error{ErrorCode::stopped, "the cell was stopped by " + stopped_->by + "; reset the stop first", {}};
}

std::optional<Error> Control::refuse_other(std::uint64_t control) const {
  if (!holder_ || is_holder(control)) return std::nullopt;
  return Error{ErrorCode::leased, holder_->by + " has the controls of the cell", {}};
}

Expected<void> Control::may_reset_cell(std::uint64_t control) const {
  const MutexLock lock(mutex_);
  if (auto refused = refuse_stopped()) return tl::unexpected(std::move(*refused));
  if (auto refused = refuse_other(control)) return tl::unexpected(std::move(*refused));
  return {};
}

std::optional<Error> Control::refuse_person(const services::Beginning& run) const {
  if (auto refused = refuse_other(run.control)) return refused;
  if (is_holder(run.control) || !needs_person(run)) return std::nullopt;
  return Error{ErrorCode::conflict,
               run.supervised ? "take the controls of the cell first: the run is supervised"
                              : "take the controls of the cell first: it is programmed",
               {}};
}

Expected<std::uint64_t> Control::begin(const services::Beginning& run) {
  const MutexLock lock(mutex_);
  if (auto refused = refuse_stopped()) return tl::unexpected(std::move(*refused));
  if (auto refused = refuse_person(run)) return tl::unexpected(std::move(*refused));
  if (holder_) holder_->runs.erase(run.core);
  if (!needs_person(run)) return free_fence_;
  holder_->runs.insert(run.core);
  return holder_->fence;
}

Expected<void> Control::may_force(const services::Beginning& run) {
  const MutexLock lock(mutex_);
  if (auto refused = refuse_person(run)) return tl::unexpected(std::move(*refused));
  if (!holder_ && has_accounts_() && has_reserved(run.core))
    return unexpected(ErrorCode::conflict, "take the controls of the cell first: the run moves something");
  return {};
}

std::optional<Value> Control::refuse(const services::Caller& caller, const std::string& service,
                                     rsm::CallEffect effect) {
  const MutexLock lock(mutex_);
  if (!is_good(caller.fence))
    return error_value(name(ErrorCode::stopped),
                       "the cell was stopped, or has nobody at the controls; nothing moves until a run begins");
  // A person slows down, and lets go on, what others have set in motion; it stays theirs.
  if (is_person(caller.core) && effect == rsm::CallEffect::pace) return std::nullopt;
  if (is_person(caller.core) && mode_ != Mode::programming)
    return error_value(name(ErrorCode::not_accepted), "nothing is moved by hand in execution mode");
  if (is_person(caller.core) && is_ended_by_hand(service, caller.call))
    return error_value(name(ErrorCode::stopped), "somebody has stopped `" + service + "` meanwhile; begin it anew");
  const auto [found, is_new] = reservations_.try_emplace(service, Reservation{caller.core, caller.fence});
  Reservation& reservation = found->second;
  const bool is_own = reservation.core == caller.core;
  // What a person has moved by hand is that of their runs, too, but not the other way round.
  const bool is_theirs = is_person(reservation.core) && reservation.fence == caller.fence;
  if (!is_own && !is_theirs && is_good(reservation.fence))
    return error_value(name(ErrorCode::leased), whose(service, reservation));
  moved_[service] = caller.fence;
  reservation = {caller.core, caller.fence};  // of a run that moves no more until it is resumed, it is taken over
  if (is_new || !is_own) tell();
  return std::nullopt;
}

bool Control::is_ended_by_hand(const std::string& service, std::uint64_t call) const {
  const auto ended = ended_by_hand_.find(service);
  return ended != ended_by_hand_.end() && call <= ended->second;
}

std::string Control::whose(const std::string& service, const Reservation& reservation) const {
  if (!is_person(reservation.core)) return "run " + reservation.core + " has `" + service + "` until it is over";
  return (holder_ ? holder_->by : "somebody") + " has `" + service + "` until they give the controls back";
}

void Control::release(const std::string& core, const std::string& service) {
  const MutexLock lock(mutex_);
  if (holder_) holder_->runs.erase(core);
  const auto reservation = reservations_.find(service);
  if (reservation == reservations_.end() || reservation->second.core != core) return;
  reservations_.erase(reservation);
  tell();
}

}  // namespace race::server
