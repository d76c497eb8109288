// ManualControl: people at the controls of the cell, on their connections: who takes them, is heard, calls operations
// by hand, and gives them back, or loses them. However they end, what moved by them stops. Also calls by requests,
// which need the controls for what `moves` alone.
//
// Threads: any. Waits for nothing but locks that nobody holds for long; calls the host without one. manual_control.cpp
// has the controls, calls_by_hand.cpp the calls.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/rsm/call_effect.h"
#include "core/value/expected.h"
#include "core/value/fields.h"
#include "server/control/cell_stop.h"
#include "server/control/control.h"
#include "server/control/held_operation.h"
#include "server/control/person_call.h"
#include "server/stream/control_requests.h"
#include "services/host/host.h"
#include "services/mutex.h"

namespace race::server {

class ManualControl final : public ControlRequests {
 public:
  using Steady = Control::Steady;
  static constexpr std::chrono::seconds kAnswerTime{30};   // for a person at the cell to allow a take-over
  static constexpr std::chrono::seconds kResponseTime{5};  // for a service to answer what a request calls
  /// What somebody has done, as a row of the audit log: who takes the controls, or asks for them; each call by hand,
  /// but of a motion while a button is held the first alone, and not the `stop` that ends it; and how the controls end.
  using Record = std::function<void(const Identity& identity, std::string action, std::string outcome)>;

  /// All outlive this.
  ManualControl(Control& control, services::Host& host, CellStop& cell_stop, Deadlines& deadlines, Record record)
      : control_(control), host_(host), cell_stop_(cell_stop), deadlines_(deadlines), record_(std::move(record)) {}

  void request(const std::shared_ptr<ControlClient>& client, std::string_view message) override EXCLUDES(mutex_);
  void disconnected(const ControlClient& client) override EXCLUDES(mutex_);

  /// Who is silent has the controls no more; a request that nobody answers is dropped. On the thread of the cell, each
  /// step.
  void check(Steady now) EXCLUDES(mutex_);
  /// Who sends a request, and their number if they have the controls, else 0.
  struct Sender {
    const Identity& identity;
    std::uint64_t control = 0;
  };
  /// Calls an operation for a request. `respond` gets the response, or after kResponseTime the error `unavailable`: the
  /// call is abandoned, and what it began may go on. One that `moves` passes what a call on a connection does. One that
  /// is `safe` ends what a person moves there while they hold a button, which must be pressed anew. Errors:
  /// `not_found`: the service; `leased`: it moves, and they have not the controls, or it changes something, and
  /// somebody else has them; `stopped`, of what is called while a button is held that was held when the cell was; those
  /// of PersonCalls::may_wait().
  Expected<void> call_by_request(const Sender& sender, const PersonCall& call, PersonCalls::Respond respond)
      EXCLUDES(mutex_);
  /// What a service says: responses to calls by people go to who made them. Under the host's lock: quick.
  void delivered(const services::Delivery& delivery) EXCLUDES(mutex_);

  /// The number of who proves by the secret of `taken` to have the controls; 0: `secret` is empty. Error `leased`: they
  /// have them no more.
  Expected<std::uint64_t> number_of(std::string_view secret) const EXCLUDES(mutex_);
  /// A person at the cell answers the request of this id: the controls go over, or stay. Errors: `not_found`: there is
  /// no such request, or no more; `rights`: they are not at the cell.
  Expected<void> answer_request(const Identity& identity, std::int64_t id, bool allow) EXCLUDES(mutex_);

 private:
  static constexpr std::string_view kRequests = "request";  // the caller of what needs no controls
  /// Who has the controls.
  struct Holder {
    std::weak_ptr<ControlClient> client;
    Identity identity = {};
    std::uint64_t number = 0;
    std::string secret = {};  // its digest
    PersonCalls calls = {};   // that wait
    HeldOperation held = {};
    /// Whether a call that is let through is more than the going on of a motion, or the stop that ends it.
    bool begins(const PersonCall& call, bool is_held, Steady now) {
      if (is_held) return held.begins(call.service, call.operation, now);
      return call.operation != "stop" || !held.goes_on(call.service, now);
    }
  };
  /// Who wants them from somebody who has them.
  struct Asking {
    std::weak_ptr<ControlClient> client;
    std::int64_t id = 0;
    Steady until;
  };
  struct Message {
    const std::shared_ptr<ControlClient>& client;
    std::vector<Error>& errors;
    Steady now;
  };
  void take(Fields& fields, const Message& message) EXCLUDES(mutex_);
  void beat(Fields& fields, const Message& message) EXCLUDES(mutex_);
  void give_back(Fields& fields, const Message& message) EXCLUDES(mutex_);
  void call(Fields& fields, const Message& message) EXCLUDES(mutex_);
  /// Who wants the response to a call: on the connection of who has the controls, or with a request, of this account.
  struct Wanted {
    PersonCalls::Respond respond;
    PersonCalls::Place place;
    std::optional<std::string> by_request = {};
  };
  /// One that may be made; `is_new`: it is no part of a motion that has begun.
  struct ByHand {
    services::Caller caller;
    bool is_new = false;
  };
  /// The call that waits from now on, of this caller and fence. Errors: those of PersonCalls::may_wait(); on a
  /// connection `too_large` for them, and it requires that somebody has the controls.
  Expected<services::Caller> wait(services::Caller caller, Wanted wanted) REQUIRES(mutex_);
  Expected<ByHand> begin_by_hand(std::uint64_t control, const PersonCall& call, Steady now, Wanted wanted)
      EXCLUDES(mutex_);
  Expected<services::Caller> begin_free(Wanted wanted) EXCLUDES(mutex_);
  /// A request stops `service`: what a person holds there ends, and what they have called before moves nothing, also if
  /// it arrives after the stop.
  void end_by_hand(const std::string& service) EXCLUDES(mutex_);
  /// The response to this call of a request is late.
  void give_up(const services::Caller& caller) EXCLUDES(mutex_);
  Expected<void> may_call(const Sender& sender, const PersonCall& call, rsm::CallEffect effect) const;
  void ask(const std::shared_ptr<ControlClient>& client, const std::string& by, Steady now) EXCLUDES(mutex_);
  void give(const std::shared_ptr<ControlClient>& client, const std::string& by, Steady now) EXCLUDES(mutex_);
  std::uint64_t number_of(const ControlClient& client) const EXCLUDES(mutex_);
  /// How the controls end, for the log and for the audit log.
  struct End {
    const char *why, *outcome;
    bool is_told = true;  // to who had them: not if they have wanted it, which is answered by itself
  };
  void end(const std::optional<Control::Ended>& ended, const End& how) EXCLUDES(mutex_);
  void drop_request(const std::string& why) EXCLUDES(mutex_);

  Control& control_;
  services::Host& host_;
  CellStop& cell_stop_;
  Deadlines& deadlines_;
  const Record record_;
  mutable services::Mutex mutex_;  // the control's may be taken under it
  std::optional<Holder> holder_ GUARDED_BY(mutex_);
  PersonCalls by_request_ GUARDED_BY(mutex_);  // calls of everybody
  std::uint64_t last_call_ GUARDED_BY(mutex_) = 0;
  std::map<std::uint64_t, Identity> replaced_ GUARDED_BY(mutex_);  // by number: had lost them when others took them
  std::optional<Asking> asking_ GUARDED_BY(mutex_);
  std::int64_t requests_ GUARDED_BY(mutex_) = 0;
};

}  // namespace race::server
