// ProcessHost: hosts a component group in a process of its own. The components are those of the server; what they
// announce to their ServiceHosts goes to the server.
//
// Threads: one, the group's. On any: receive(), handle_reply(), and a component's log() and fulfil().
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "services/clock.h"
#include "services/component.h"
#include "services/host/reservations.h"
#include "services/mutex.h"
#include "services/remote/message_queue.h"
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

  /// As Host::declare(): the component is made with what this returns.
  services::ServiceHost& declare(std::string key, std::string type);
  void attach(const std::string& key, std::unique_ptr<services::Component> component);
  /// Called at the beginning and the end of each step; what they hold lives until the components are destroyed.
  void before_step(std::function<void()> work) { before_step_ = std::move(work); }
  void after_step(std::function<void()> work) { after_step_ = std::move(work); }

  /// The world that the components act in, for the server (remote_world.h).
  struct World {
    Value json;                                                    // of the hello
    std::function<Expected<Value>(const Value& command)> execute;  // executes it (null: none); its answer
    std::function<void(bool on)> watch;                            // whether to call send_pose()
  };
  void set_world(World world) { world_ = std::move(world); }
  /// Sends the server where everything is; replaces a pose that waits to be sent.
  void send_pose(Value pose);

  /// `work` is called when something has changed for the host functions of the component `key` (host_functions.h).
  void on_host_change(const std::string& key, std::function<void()> work);
  /// Calls a host function of the component `key` in the server and waits for the reply. Errors: `unavailable` (the
  /// connection has ended or takes nothing more, or the server has not accepted it yet), `constant`, `too_large`.
  Expected<Value> request(const std::string& key, std::string_view function, Dict arguments) EXCLUDES(mutex_);

  /// The server is to say what does not fit an RSM (Component::violated). Before hello().
  void ask_for_violations() { asks_for_violations_ = true; }
  /// The first message, for all that is attached.
  Message hello() const;
  /// What the components announce goes to `server` from now on, and is dropped before that. It outlives this or lives
  /// until disconnect(). `ended`: whether the connection has ended; an empty one: never.
  void connect(SendQueue& server, std::function<bool()> ended = {});
  void disconnect();
  /// A message of the server came, which has so many bytes: step() handles it. false: more wait than may, and the
  /// connection is to end.
  bool receive(Message message, std::size_t bytes);
  /// Handles a message of the server. Error `not_found`: it is for no component or world of this process. Throws what a
  /// component throws, after which the group must not be used.
  Expected<void> handle(Message message);
  /// The reply to a request came; request() may wait for it. On another thread than the group's.
  void handle_reply(Message reply) EXCLUDES(mutex_);
  /// Advances time by 1 ms: handles what was received, runs what is due, then step() of all components. Error: that of
  /// a message, after which the connection is to end.
  Expected<void> step();

  /// How long the server may be silent [s] before all components halt (Component::halt); from the welcome on.
  static constexpr services::Time kMostSilence = 1;

  /// Advances with step(); is set forward, or waits, when it is more than kMaxClockOffset from the server's.
  const services::Clock& clock() const { return clock_; }

 private:
  struct ComponentEntry;
  friend struct ComponentEntry;

  ComponentEntry* find(const std::string& key) const;
  Expected<void> handle_world_message(const Message& message);
  void set_clock(services::Time server);
  void send(const Message& message, const std::string& flow = {});

  struct Received {
    Message message;
    std::size_t bytes = 0;
  };
  friend std::size_t size_of(const Received& received) { return received.bytes; }

  Expected<void> handle_received();
  void notice_silence();

  MessageQueue<Received> received_;
  services::WorldClock clock_;
  services::Reservations reservations_;  // outlives the components: their threads fulfil
  std::function<void()> before_step_, after_step_;
  World world_;
  bool asks_for_violations_ = false;
  std::vector<std::unique_ptr<ComponentEntry>> entries_;  // in order of declaration
  std::atomic<SendQueue*> server_{nullptr};
  std::function<bool()> ended_;
  bool accepted_ = false;                                     // by the server
  services::Time most_silence_ = kMostSilence, silence_ = 0;  // [s] since its last message
  bool is_halted_ = false;
  services::Mutex mutex_;
  services::ConditionVariable reply_arrived_;
  std::optional<Message> reply_ GUARDED_BY(mutex_);
  std::int64_t requests_ = 0;
  services::Time clock_ahead_ = 0;  // [s] of the server's clock, which this one waits for
};

}  // namespace race::remote
