// Hub: the channels of the stream and who listens. A channel has numbered deltas, of which the last ones are kept, and
// the last snapshot; who comes again gets what it missed. Who comes new gets the snapshot if nothing has changed since:
// else, or when what is kept does not reach, the source of the channel is asked for a new one. Nobody is shown the
// past.
//
// Everything happens on the hub's strand: sources publish and go on; each message is serialised once.
//
// Threads: any.
#pragma once

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
#include "server/execution/strand.h"
#include "server/stream/outbox.h"

namespace race::server {

/// A client of the stream, as the hub sees it. Threads: any.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual Outbox& outbox() = 0;
  /// Something was pushed.
  virtual void wake() = 0;
};

/// What a channel is, found when it is first subscribed to.
struct Source {
  bool sampled = false;               // only the newest message counts; every message is the whole
  std::function<void()> refresh;      // asks for a snapshot, which is published soon; on the hub's strand
  std::function<void(bool)> watched;  // somebody listens, or nobody any more; may be empty; on the hub's strand
};

class Hub {
 public:
  static constexpr std::size_t kKept = 256;  // deltas of a channel
  static constexpr std::size_t kKeptBytes = 4 * 1024 * 1024;

  /// `first`: the number of the first message of every channel; greater than all of an earlier server's. `find` gives
  /// the source of a channel, or nothing if there is no such channel.
  Hub(Pool& pool, std::int64_t first, std::function<std::optional<Source>(const std::string&)> find);

  /// Frozen values only.
  void publish_snapshot(std::string channel, Value data);
  void publish_delta(std::string channel, Value data);
  /// The channel ends: its listeners are told, and nothing more comes.
  void close(std::string channel);

  void subscribe(std::shared_ptr<Listener> listener, std::string channel, std::optional<std::int64_t> since);
  /// A snapshot for a listener that its outbox owed one, if it still listens.
  void repay(std::shared_ptr<Listener> listener, std::string channel);
  void unsubscribe(std::shared_ptr<Listener> listener, std::string channel);
  /// The listener is gone.
  void leave(std::shared_ptr<Listener> listener);
  /// All listeners are gone, and whoever comes is not listened to: their sockets end. Waits for it.
  void release();
  /// Errors of a request, told to a listener alone.
  void refuse(std::shared_ptr<Listener> listener, std::string channel, std::vector<Error> errors);

 private:
  struct Message {
    std::int64_t sequence;
    Text text;
  };
  using Listeners = std::set<std::shared_ptr<Listener>>;  // held until they leave
  struct Channel {
    Source source;
    std::int64_t sequence = 0;  // of the last message
    std::deque<Message> deltas;
    std::size_t bytes = 0;
    std::optional<Message> snapshot;  // as of its number
    Listeners listeners, waiting;     // those that wait for a snapshot are no listeners yet
  };

  Channel* find(const std::string& name);
  void join(const std::shared_ptr<Listener>& listener, const std::string& name, std::optional<std::int64_t> since);
  void forget(Channel& channel, const std::shared_ptr<Listener>& listener);
  bool catch_up(const std::string& name, Channel& channel, Listener& listener, std::int64_t since);
  static void send(Listener& listener, const std::string& channel, Text text, bool sampled);
  static Text serialise(const std::string& channel, std::int64_t sequence, const char* kind, const Value& data);

  Strand strand_;
  std::int64_t first_;
  std::function<std::optional<Source>(const std::string&)> find_;
  std::map<std::string, Channel> channels_;
  bool released_ = false;
};

}  // namespace race::server
