// Hosted: one service while it is offered: its calls, its state, and what it says. It joins a declaration to whoever
// hosts components, and outlives each connection.
//
// Threads: that of the group, which makes it a component; emit(), take(), log(), state() and speed_limit() on any.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "api/cpp/race_client/declaration.h"
#include "api/cpp/race_client/inbox.h"
#include "api/cpp/race_client/running_call.h"
#include "api/cpp/race_client/workers.h"
#include "core/rsm/rules.h"
#include "services/component.h"
#include "services/mutex.h"

namespace race::client {

class Hosted {
 public:
  /// The declaration outlives it, and changes no more once there is a component.
  explicit Hosted(const Declaration& declaration) : declaration_(declaration) {}
  Hosted(const Hosted&) = delete;
  Hosted& operator=(const Hosted&) = delete;
  ~Hosted();

  /// The RSM of model_of(); once, before component().
  void set_model(rsm::Service model) { model_ = std::move(model); }
  const Declaration& declaration() const { return declaration_; }

  /// Speaks for this service, which is to be connected() while the component lives.
  std::unique_ptr<services::Component> component(services::ServiceHost& host);
  /// Somebody listens to the component: the service begins in its first state.
  void connected() EXCLUDES(mutex_);
  /// Nobody does any more: what is under way ends, and the service halts.
  void lost() EXCLUDES(mutex_);
  /// Whether all handlers have ended within this time [s].
  bool wait_for_handlers(double seconds) { return workers_.wait_for_all(seconds); }

  // As Service has them.

  void emit(std::string_view event, Value data);
  void take(std::string_view transition) EXCLUDES(mutex_);
  void log(std::string_view text);
  std::string state() const EXCLUDES(mutex_);
  std::optional<double> speed_limit() const EXCLUDES(mutex_);

 private:
  class Link;
  /// Of a call: the result, or the error if that is not null; both frozen.
  struct Outcome {
    Value result, error;
  };

  void called(const services::Call& call);
  void run_busy(const std::shared_ptr<RunningCall>& call, Dict arguments);
  Outcome run_handler(RunningCall& running, Dict arguments) const;
  Outcome failed(const std::string& operation, const std::string& what) const;
  void answer(RunningCall& call, Outcome outcome);
  void respond(RunningCall& call, Outcome outcome);
  void follow(const rsm::Transition& transition, services::CallId number, const RunningCall* own);
  void finish(RunningCall& call);
  void silent();
  void halt();
  void halt_by(const rsm::Operation& operation);
  void set_state(const std::string& state) EXCLUDES(mutex_);
  void set_speed_limit(std::optional<double> limit) EXCLUDES(mutex_);

  const Declaration& declaration_;
  rsm::Service model_;
  services::ServiceHost* host_ = nullptr;
  rsm::Instance instance_;
  std::map<services::CallId, std::shared_ptr<RunningCall>>
      calls_;  // that wait for an answer; their handlers hold them too
  Inbox inbox_;
  mutable services::Mutex mutex_;
  bool is_connected_ GUARDED_BY(mutex_) = false;
  std::string state_ GUARDED_BY(mutex_);
  std::optional<double> speed_limit_ GUARDED_BY(mutex_);
  Workers workers_;  // the last: its threads use the others
};

}  // namespace race::client
