// Control: what may set the cell in motion now.
//
// * A stop latches: until a reset, no motion begins, and no run goes on that was under way.
// * One person at a time has the controls: takes them, is heard at least each kSilence, and gives them back. Only that
//   person moves the cell by hand, and what needs them (a supervised run; in the mode `programming` every run) moves
//   only while they have them.
// * A service that a run has set in motion is reserved for it until the run is over.
//
// All of it is fencing numbers: a call has that which its run, or its person, got when it began; what ends a permission
// ends its number, so nothing that was on its way moves anything.
//
// Not a safety function.
//
// Threads: any. Waits for nothing but its own lock, which nobody holds for long. control.cpp has calls, stops and runs,
// controls.cpp the person at the controls.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/host/motion_gate.h"
#include "services/mutex.h"

namespace race::server {

/// How the cell is worked with. `programming`: by hand, and by runs that a person watches, the tool no faster than
/// kReducedSpeed. `execution`: runs go by themselves, and nobody moves anything by hand.
enum class Mode : std::uint8_t { execution, programming };

/// "execution", "programming".
std::string_view name(Mode mode);
std::optional<Mode> mode_of(std::string_view name);

inline constexpr double kReducedSpeed = 0.25;  // m/s of the tool centre point (ISO 10218-1:2011, 5.6.2)

class Control final : public services::MotionGate {
 public:
  using Steady = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::milliseconds kBeat{100};     // between two signs of life of who has the controls
  static constexpr std::chrono::milliseconds kSilence{250};  // without one, they are lost

  /// Who stopped the cell, and when [ms since 1970].
  struct Stop {
    std::string by;
    std::int64_t time = 0;
  };
  /// What must stop because its permission has ended.
  struct Ended {
    std::uint64_t number = 0;        // of who had the controls; 0: nobody
    std::string by;                  // who that was
    std::set<std::string> services;  // what they, or runs that needed them, have set in motion last
    std::set<std::string> cores;     // of these runs
  };
  /// `changed` gets schemas/control.json, frozen, in order of the changes. `has_accounts`: edits of runs that move
  /// something are confirmed also when nobody has the controls, and so are forced values. Both under the lock: must be
  /// quick.
  explicit Control(
      std::function<void(const Value&)> changed, std::function<bool()> has_accounts = [] { return false; })
      : changed_(std::move(changed)), has_accounts_(std::move(has_accounts)) {}

  /// From now on nothing may set the cell in motion. Of several stops the first is told. The fencing numbers of before
  /// are good no longer, also after the reset. Whether it was not stopped before.
  bool stop(Stop stop) EXCLUDES(mutex_);
  /// Motions may begin again; none does by that. Whether it was stopped.
  bool reset() EXCLUDES(mutex_);
  std::optional<Stop> stopped() const EXCLUDES(mutex_);
  /// How often it was stopped, since the server began: who has to know of a stop that is reset already compares.
  std::uint64_t stops() const EXCLUDES(mutex_);
  /// The port of the stop server, for pages, by the port of the place at which they are.
  void set_stop_port(std::uint16_t place, std::uint16_t port) EXCLUDES(mutex_);
  /// schemas/control.json, frozen.
  Value json() const EXCLUDES(mutex_);

  /// Takes the controls: their number, which is never that of another taking. `by`: who, as people read it. Error
  /// `leased`: somebody has them.
  Expected<std::uint64_t> take(std::string by, Steady now) EXCLUDES(mutex_);
  /// Who took them was heard; whether they have them still.
  bool hear(std::uint64_t number, Steady now) EXCLUDES(mutex_);
  /// Gives them back, or takes them from who has them; nothing: they are had by nobody of this number.
  std::optional<Ended> release(std::uint64_t number) EXCLUDES(mutex_);
  /// Takes them from who has been silent for kSilence.
  std::optional<Ended> release_silent(Steady now) EXCLUDES(mutex_);
  /// The number of who has them; 0: nobody has.
  std::uint64_t holder() const EXCLUDES(mutex_);
  /// The caller of what a person with this number calls (services::Caller), and whether it is one.
  static std::string caller(std::uint64_t number) { return std::string(kCaller) + std::to_string(number); }
  static bool is_person(std::string_view caller) { return caller.starts_with(kCaller); }
  /// The fencing number of calls by hand. Error `leased`: they have not the controls.
  Expected<std::uint64_t> fence_of(std::uint64_t number) const EXCLUDES(mutex_);

  /// Of `service`, no call by hand with this number of the call (services::Caller), or an earlier one, moves anything
  /// any more: somebody has stopped it. Numbers of calls are of one count, whoever has the controls.
  void end_by_hand(const std::string& service, std::uint64_t call) EXCLUDES(mutex_);

  /// Shown to all until it is answered: who asks to take the controls from who has them; nothing: nobody does.
  struct Request {
    std::int64_t id = 0;
    std::string by;
  };
  void show_request(std::optional<Request> request) EXCLUDES(mutex_);

  /// What moved until now must stop, whatever the modes; none begins by that. Error `leased`: `number` has not the
  /// controls.
  Expected<Ended> set_mode(std::uint64_t number, Mode mode) EXCLUDES(mutex_);
  /// Of the start.
  void set_mode(Mode mode) EXCLUDES(mutex_);
  Mode mode() const EXCLUDES(mutex_);

  /// Whether the sender of a request may put the cell back to its start, and the arm with it: `control` is their
  /// number, or 0. Errors `stopped`; `leased`: somebody else has the controls.
  Expected<void> may_reset_cell(std::uint64_t control) const EXCLUDES(mutex_);
  Expected<std::uint64_t> begin(const services::Beginning& run) override EXCLUDES(mutex_);
  Expected<void> may_force(const services::Beginning& run) override EXCLUDES(mutex_);
  bool confirms_edits(const std::string& core) override EXCLUDES(mutex_);
  /// Errors {code, message} of core/SEMANTICS.md, R7: `stopped`: the cell is, or was since the run began, or the person
  /// who watched it has the controls no more; `leased`: another run has the service. The first call that may is what
  /// reserves the service. Of calls by hand also `not_accepted`: in this mode nothing is moved by hand.
  std::optional<Value> refuse(const services::Caller& caller, const std::string& service,
                              rsm::CallEffect effect) override EXCLUDES(mutex_);
  void release(const std::string& core, const std::string& service) override EXCLUDES(mutex_);

 private:
  static constexpr std::string_view kCaller = "control/";
  /// The person at the controls.
  struct Holder {
    std::uint64_t number = 0;
    std::uint64_t fence = 0;  // of what they call, and of runs that need them
    std::string by;
    Steady heard;
    std::set<std::string> runs;  // that need them
  };
  /// Of a service: whose it is.
  struct Reservation {
    std::string core;
    std::uint64_t fence = 0;  // of its last call
  };
  Value state() const REQUIRES(mutex_);
  void tell() REQUIRES(mutex_) { changed_(state()); }
  std::optional<Error> refuse_stopped() const REQUIRES(mutex_);
  /// Why who has this number, or 0, does not act beside the person at the controls; nothing: they are that, or nobody
  /// is.
  std::optional<Error> refuse_other(std::uint64_t control) const REQUIRES(mutex_);
  /// Why the sender of `run` may not act on runs now; nothing: they may.
  std::optional<Error> refuse_person(const services::Beginning& run) const REQUIRES(mutex_);
  /// Whether a run needs a person at the controls.
  bool needs_person(const services::Beginning& run) const REQUIRES(mutex_) {
    return mode_ == Mode::programming || run.supervised;
  }
  bool is_holder(std::uint64_t number) const REQUIRES(mutex_) { return holder_ && holder_->number == number; }
  bool has_reserved(const std::string& core) const REQUIRES(mutex_);
  Expected<void> check_holder(std::uint64_t number) const REQUIRES(mutex_);
  bool is_good(std::uint64_t fence) const REQUIRES(mutex_);
  bool is_ended_by_hand(const std::string& service, std::uint64_t call) const REQUIRES(mutex_);
  std::string whose(const std::string& service, const Reservation& reservation) const REQUIRES(mutex_);
  Ended end_holder() REQUIRES(mutex_);

  const std::function<void(const Value&)> changed_;
  const std::function<bool()> has_accounts_;
  mutable services::Mutex mutex_;
  std::optional<Stop> stopped_ GUARDED_BY(mutex_);
  std::uint64_t stops_ GUARDED_BY(mutex_) = 0;
  Mode mode_ GUARDED_BY(mutex_) = Mode::execution;
  std::uint64_t last_fence_ GUARDED_BY(mutex_) = 1;
  std::uint64_t free_fence_ GUARDED_BY(mutex_) = 1;  // of runs that need nobody
  std::uint64_t takings_ GUARDED_BY(mutex_) = 0;
  std::optional<Holder> holder_ GUARDED_BY(mutex_);
  std::optional<Request> request_ GUARDED_BY(mutex_);
  std::map<std::string, Reservation> reservations_ GUARDED_BY(mutex_);     // by service
  std::map<std::string, std::uint64_t> moved_ GUARDED_BY(mutex_);          // by service: the fence of its last motion,
                                                                           // which may go on without its reservation
  std::map<std::string, std::uint64_t> ended_by_hand_ GUARDED_BY(mutex_);  // by service: the last call that is over
  std::map<std::uint16_t, std::uint16_t> stop_ports_ GUARDED_BY(mutex_);
};

}  // namespace race::server
