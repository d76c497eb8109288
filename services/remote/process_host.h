// ProcessHost: the components of a process, and the ServiceHosts that they talk to: what they announce goes to the
// server. The components are those of the server, and cannot tell the difference.
//
// Threads: one, the group's; its queue takes work from any, and handle_reply() is for another. A component may log and
// fulfil reservations on its own.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "services/clock.h"
#include "services/component.h"
#include "services/host/reservations.h"
#include "services/host/work_queue.h"
#include "services/remote/protocol.h"
#include "services/remote/send_queue.h"

namespace race::remote {

class ProcessHost {
 public:
  static constexpr services::Time kStep = 1e-3;             // [s]
  static constexpr services::Time kMaxClockOffset = 50e-3;  // [s] that its clock and the server's may be apart

  ProcessHost();
  ~ProcessHost();
  ProcessHost(const ProcessHost&) = delete;
  ProcessHost& operator=(const ProcessHost&) = delete;

  /// As of a Host: the component is made with what this returns.
  services::ServiceHost& declare(std::string key, std::string type);
  void attach(const std::string& key, std::unique_ptr<services::Component> component);
  /// Called at the beginning and the end of each step; what the components act in is kept with it until they are gone.
  void before_step(std::function<void()> work) { before_step_ = std::move(work); }
  void after_step(std::function<void()> work) { after_step_ = std::move(work); }

  /// What the components act in, for the server (remote_world.h).
  struct World {
    Value json;                                                // that goes with the hello
    std::function<Expected<Value>(const Value& act)> execute;  // does it (null: nothing); what the server is told of it
    std::function<void(bool on)> watch;                        // show() is wanted, or no longer
  };
  void set_world(World world) { world_ = std::move(world); }
  /// Tells the server where everything is; one that waits to be sent makes room.
  void send_pose(Value pose);

  /// Called when there is news at the desk (desk.h) of the component `key`; what it needs is kept with it.
  void on_host_change(const std::string& key, std::function<void()> work);
  /// Asks the desk of the component `key` in the server and waits for the answer. Errors: `unavailable` (the connection
  /// has ended or takes nothing more, or is not welcome yet), `constant`, `too_large`.
  Expected<Value> request(const std::string& key, std::string_view function, Dict arguments);

  /// The first message, for all that is attached.
  Message hello() const;
  /// What the components announce goes here from now on, and is lost before that. It outlives the group or
  /// disconnect(). `over`: whether the connection has ended; an empty one: never.
  void connect(SendQueue& server, std::function<bool()> ended = {});
  void disconnect();
  /// Does what the server says. Error `not_found`: the message is for no component or world of this process. What a
  /// component throws, comes through: the group is as good as dead.
  Expected<void> handle(Message message);
  /// The reply to a request came, which may be waited for. On another thread than the group's.
  void handle_reply(Message reply);
  /// 1 ms: what was posted, what is due, then step() of all.
  void step();

  services::WorkQueue& queue() { return queue_; }
  /// Runs by the steps, and is set forward or waits where it is more than kMaxClockOffset from what the server said
  /// last.
  const services::Clock& clock() const { return clock_; }

 private:
  struct ComponentEntry;
  friend struct ComponentEntry;

  ComponentEntry* find(const std::string& key) const;
  Expected<void> handle_world_message(const Message& message);
  void set_clock(services::Time server);
  void send(const Message& message, const std::string& flow = {});

  services::WorkQueue queue_;
  services::WorldClock clock_;
  services::Reservations reservations_;  // outlives the components: their threads fulfil
  std::function<void()> before_step_, after_step_;
  World world_;
  std::vector<std::unique_ptr<ComponentEntry>> entries_;  // in order of declaration
  std::atomic<SendQueue*> server_{nullptr};
  std::function<bool()> ended_;
  bool accepted_ = false;  // by the server
  std::mutex mutex_;       // of the reply
  std::condition_variable reply_arrived_;
  std::optional<Message> reply_;
  std::int64_t requests_ = 0;
  services::Time clock_ahead_ = 0;  // [s] of the server's clock, which this one waits for
};

}  // namespace race::remote
