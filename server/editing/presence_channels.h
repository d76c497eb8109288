// PresenceChannels: what clients say of the persons at them goes to the channels presence/NAME. Who says nothing for
// Limits::silence (a page that sleeps, a machine that is gone) has left.
//
// Threads: any. Nobody waits: not for the hub, not for the disk.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "server/editing/presence.h"
#include "server/stream/hub.h"
#include "server/stream/requests.h"
#include "server/threads/deadlines.h"
#include "services/mutex.h"

namespace race::server {

class PresenceChannels final : public PresenceRequests {
 public:
  struct Limits {
    std::chrono::milliseconds silence{30'000};  // pages say something every 10 s
    std::chrono::milliseconds look{2'000};      // how often it is looked who is silent
  };

  /// Both outlive this; the deadlines are closed before it goes. `first_id`: as of Presence.
  PresenceChannels(Hub& hub, Deadlines& deadlines, std::int64_t first_id, Limits limits)
      : hub_(hub), deadlines_(deadlines), limits_(limits), presence_(first_id) {}
  PresenceChannels(Hub& hub, Deadlines& deadlines, std::int64_t first_id)
      : PresenceChannels(hub, deadlines, first_id, Limits{}) {}

  void request_presence(const std::shared_ptr<Subscriber>& sender, const Value& message) override EXCLUDES(mutex_);
  void unsubscribed(const Subscriber& subscriber, const std::string& channel) override EXCLUDES(mutex_);
  void disconnected(const Subscriber& subscriber) override EXCLUDES(mutex_);

  /// Publishes who is at the document.
  void publish_snapshot(const std::string& document) EXCLUDES(mutex_);

 private:
  using Time = Presence::Time;
  // To be called after each change of `presence_`. In the lock: so it is told in the order in which it happened.
  void tell() REQUIRES(mutex_);
  void tell_later() REQUIRES(mutex_);
  void look_for_silent() REQUIRES(mutex_);

  Hub& hub_;
  Deadlines& deadlines_;
  const Limits limits_;
  services::Mutex mutex_;
  Presence presence_ GUARDED_BY(mutex_);
  std::optional<Time> telling_ GUARDED_BY(mutex_);  // when something is told that was not due yet
  bool is_looking_ GUARDED_BY(mutex_) = false;      // for those who are silent, soon
};

}  // namespace race::server
