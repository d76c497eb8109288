// Hub: the channels of the stream and their subscribers. A channel keeps its last numbered deltas and its last
// snapshot. A subscriber that reconnects gets the deltas it missed. A new one gets the snapshot if it is current; else,
// or if the missed deltas are not kept any more, the hub asks the channel's source for a new snapshot.
//
// All work is done on the hub's strand: publishing never blocks, and each message is serialised once. What waits for
// the strand is bounded (publications.h), and so is all that messages hold, whether channels keep them or clients have
// not taken them (kMaxBytes).
//
// Threads: any.
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/accounts/role.h"
#include "server/stream/outbox.h"
#include "server/stream/publications.h"
#include "server/threads/strand.h"

namespace race::server {

/// A client of the stream. Threads: any.
class Subscriber {
 public:
  virtual ~Subscriber() = default;
  virtual Outbox& outbox() = 0;
  /// Who it is.
  virtual const Identity& identity() const = 0;
  /// The outbox has a new message, or was cut.
  virtual void wake() = 0;
  /// From now on its messages come together, a few at a time.
  virtual void gather() = 0;
};

/// Where the data of a channel comes from. Its functions run on the hub's strand and may be empty.
struct Source {
  bool sampled = false;               // only the newest message counts; every message is the whole state
  std::function<void()> refresh;      // asks for a snapshot, which is published soon; one, however often it was asked
  std::function<void(bool)> watched;  // the channel has its first subscriber (true) or lost its last (false)
};

class Hub {
 public:
  static constexpr std::size_t kMaxDeltas = 256;  // deltas of a channel
  static constexpr std::size_t kMaxDeltaBytes = 4 * 1024 * 1024;
  /// Channels of a subscriber.
  static constexpr std::size_t kMaxSubscriptions = 256;
  /// Channels without a subscriber that keep what they have for those who come again, those that were left last; with
  /// so many bytes of messages in all.
  static constexpr std::size_t kMaxIdle = 64;
  static constexpr std::size_t kMaxIdleBytes = 32 * 1024 * 1024;
  static constexpr std::size_t kMaxIdleDeltaBytes = 256 * 1024;  // of one
  /// Of all messages that channels keep and clients have not taken. Beyond it, what channels keep is dropped, that
  /// which keeps most first (who comes again gets a snapshot); then the client that holds most is cut.
  static constexpr std::size_t kMaxBytes = 128 * 1024 * 1024;

  /// `first`: the number of the first message of every channel; greater than all of an earlier server's. `find` gives
  /// the source of a channel, or nothing if there is no such channel.
  Hub(Pool& pool, std::int64_t first, std::function<std::optional<Source>(const std::string&)> find);

  /// Its work is done first.
  ~Hub() { strand_.finish(); }

  // Frozen values only. What is published faster than the hub tells it is dropped, and the channel begins anew: its
  // source is asked for a snapshot that all get; of a sampled one the newest is told.

  void publish_snapshot(const std::string& channel, Value data);
  void publish_delta(const std::string& channel, Value data);
  /// Does `work`, which must not block, when all that was asked for before is done, and as much told as was published
  /// before: so that who asks for much waits.
  void after(Work work) { strand_.post(std::move(work)); }
  /// Ends the channel: its subscribers get these errors, then nothing. Who subscribes later asks its source again.
  void close(std::string channel, std::vector<Error> errors);

  /// Errors, told to the subscriber: `not_found`; `too_large`, it has kMaxSubscriptions.
  void subscribe(std::shared_ptr<Subscriber> subscriber, std::string channel, std::optional<std::int64_t> since);
  /// Sends a snapshot to a subscriber that lost messages (Outbox::take_stale_channels()) of a channel, if it is still
  /// subscribed.
  void resend_snapshot(std::shared_ptr<Subscriber> subscriber, std::string channel);
  void unsubscribe(std::shared_ptr<Subscriber> subscriber, std::string channel);
  /// Removes the subscriber from all channels.
  void disconnect(std::shared_ptr<Subscriber> subscriber);
  /// Removes all subscribers and accepts no new ones: their sockets end. What was published is not told any more.
  /// Waits until that is done.
  void shut_down();
  /// The channel is about something else from now on: no delta leads from what it was to this snapshot, which all
  /// subscribers get.
  void publish_replacement(const std::string& channel, Value data);
  /// The same of all channels whose names begin so; their sources are asked for the snapshots.
  void restart(std::string prefix);
  /// Units of what was published and waits to be told.
  std::size_t waiting_units() const { return publications_.units(); }
  /// Bytes of all messages that somebody still holds.
  std::size_t message_bytes() const { return messages_.held(); }
  enum class To { all, those_not_subscribed };
  /// Sends a message to one client alone, if it is still there and, `those_not_subscribed`, does not get the deltas of
  /// the channel.
  void send(std::weak_ptr<Subscriber> subscriber, std::string channel, const char* kind, Value data, To to = To::all);
  /// Sends the errors of a request to its subscriber alone.
  void refuse(std::shared_ptr<Subscriber> subscriber, std::string channel, std::vector<Error> errors);

 private:
  using Subscribers = std::set<std::shared_ptr<Subscriber>>;  // held until they disconnect
  struct Channel {
    Source source;
    std::int64_t first = 0;     // before its first message
    std::int64_t sequence = 0;  // of the last message
    std::deque<Text> deltas;
    std::size_t bytes = 0;
    Text snapshot;                     // as of its number; may be empty
    Subscribers subscribers, waiting;  // those that wait for a snapshot get no deltas yet

    bool is_idle() const { return subscribers.empty() && waiting.empty(); }
    std::size_t kept_bytes() const { return bytes + (snapshot ? snapshot->json.size() : 0); }
    void drop_kept() {
      deltas.clear();
      bytes = 0;
      snapshot.reset();
    }
  };

  using Publish = void (Hub::*)(const std::string& name, Channel& channel, const Publication& what);
  void publish(Publish publish, Publications::Kind kind, const std::string& name, Value data);
  void add_snapshot(const std::string& name, Channel& channel, const Publication& what);
  void add_delta(const std::string& name, Channel& channel, const Publication& what);
  void replace(const std::string& name, Channel& channel, const Publication& what);
  void overflow(const std::string& name, const Publications::Overflow& overflow);

  Channel* find(const std::string& name);
  static void begin_anew(Channel& channel);
  static void restart(Channel& channel, bool ask);
  void send_alone(const std::shared_ptr<Subscriber>& subscriber, const std::string& channel, const char* kind,
                  const Value& data);
  void join(const std::shared_ptr<Subscriber>& subscriber, const std::string& name, std::optional<std::int64_t> since);
  void detach(const std::string& name, const std::shared_ptr<Subscriber>& subscriber);
  void put_idle(const std::string& name);
  void remove_channel(std::map<std::string, Channel>::iterator channel);
  bool catch_up(const std::string& name, Channel& channel, Subscriber& subscriber, std::int64_t since);
  static void send(Subscriber& subscriber, const std::string& channel, Text text, bool sampled);
  Text serialise(const std::string& channel, std::int64_t sequence, const char* kind, const Value& data);
  Text serialise(const std::string& channel, std::int64_t sequence, const char* kind, const Publication& what);
  void limit_memory(const std::shared_ptr<Subscriber>& told);
  void drop_kept();

  Strand strand_;
  MessageMemory messages_;
  Publications publications_;
  const std::int64_t first_;
  std::int64_t next_first_;  // of channels to come: larger than all numbers of channels that were closed
  std::function<std::optional<Source>(const std::string&)> find_;
  std::map<std::string, Channel> channels_;
  std::map<std::shared_ptr<Subscriber>, std::set<std::string>> joined_;  // the channels of each subscriber
  std::deque<std::string> idle_;                                         // channels without one, in order of leaving
  std::atomic<bool> shut_down_{false};
};

}  // namespace race::server
