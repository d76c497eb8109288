#include "server/channels/core_publisher.h"

#include <utility>

#include "server/wire/channel_names.h"
#include "server/wire/path_pattern.h"

namespace race::server {

void CorePublisher::connect(const services::Clock& clock, const Cores& cores) {
  clock_ = &clock;
  cores_ = &cores;
}

void CorePublisher::core_changed(const std::string& id, Value core) {
  const bool news = log_.append_status(clock_->now(), id, core);
  if (news && operator_ && core.find("status")->as_string() == "running") {
    operator_->begin();
    if (const auto running = cores_->find(id)) (*running)->watch_state();
  }
  changed_(id, core);
  Value delta = Dict{{"core", std::move(core)}};
  hub_.publish_delta(std::string(kCoresChannel), std::move(delta.freeze()));
}

void CorePublisher::core_removed(const std::string& id) {
  log_.drop_status(id);
  if (operator_) operator_->removed(id);
  changed_(id, Value());
  Value delta = Dict{{"removed", id}};
  hub_.publish_delta(std::string(kCoresChannel), std::move(delta.freeze()));
  for (const std::string_view pattern : {kCoreStateChannel, kCoreDerivationChannel})
    hub_.close(fill(pattern, {id}), {{ErrorCode::not_found, "the core was removed", id}});
}

void CorePublisher::state_snapshot(const std::string& id, Value state) {
  if (operator_) operator_->state(id, state.find("state")->find("active")->as_list());
  hub_.publish_snapshot(fill(kCoreStateChannel, {id}), std::move(state));
}

void CorePublisher::state_replaced(const std::string& id, Value state) {
  if (operator_) operator_->state(id, state.find("state")->find("active")->as_list());
  hub_.publish_replacement(fill(kCoreStateChannel, {id}), std::move(state));
}

void CorePublisher::state_changed(const std::string& id, Value delta) {
  if (operator_) operator_->changed(id, delta.find("active")->as_dict(), delta.find("fired")->as_list());
  hub_.publish_delta(fill(kCoreStateChannel, {id}), std::move(delta));
}

void CorePublisher::derivation_snapshot(const std::string& id, Value next) {
  hub_.publish_snapshot(fill(kCoreDerivationChannel, {id}), std::move(next));
}

void CorePublisher::derived(const std::string& id, Value steps) {
  hub_.publish_delta(fill(kCoreDerivationChannel, {id}), std::move(steps));
}

void CorePublisher::printed(const std::string& id, const std::string& text) {
  log_.append(clock_->now(), "core/" + id, text, LogLevel::debug);
}

void CorePublisher::run_lost(const std::string& id, const std::string& why) {
  log_.append(clock_->now(), "core/" + id, why, LogLevel::error);
}

}  // namespace race::server
