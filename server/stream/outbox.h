// Outbox: the queue of messages to one client. It is bounded: of a sampled channel it keeps the newest message only; if
// a client is too slow for a state channel, all queued messages of that channel are dropped and the channel needs a
// snapshot. Until the snapshot is pushed, other messages of that channel are dropped: the client could not apply them.
//
// Threads: any.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "server/stream/messages.h"
#include "services/mutex.h"

namespace race::server {

class Outbox {
 public:
  static constexpr std::size_t kMessages = 256;
  static constexpr std::size_t kBytes = 8 * 1024 * 1024;
  /// What is for one client alone is queued under no channel's name: one queue, whatever names clients ask for. No
  /// snapshot makes up for what is dropped of it (take_stale_channels()): the connection has to end, so that the client
  /// asks again.
  static constexpr const char* kPrivateQueue = "";

  /// Queues a message. `sampled`: it replaces a queued one of its channel.
  void push(const std::string& channel, Text text, bool sampled) EXCLUDES(mutex_);
  /// The next message, if there is one.
  std::optional<Text> pop() EXCLUDES(mutex_);
  /// The next messages, in their order: the first, however large it is, and as many as fit into `limit` bytes with it.
  std::vector<Text> pop_together(std::size_t limit) EXCLUDES(mutex_);
  /// Drops all messages of a channel, and that it needs a snapshot: the next message pushed is one.
  void drop(const std::string& channel) EXCLUDES(mutex_);
  /// Once the queue is empty: the channels that need a snapshot, each once. Messages pushed to them are dropped until
  /// drop() is called.
  std::vector<std::string> take_stale_channels() EXCLUDES(mutex_);
  /// Drops all messages, and those to come: the connection has to end at once (take_stale_channels() says so, too).
  void cut() EXCLUDES(mutex_);
  bool is_cut() const EXCLUDES(mutex_);
  /// No message is queued, and no channel needs a snapshot that was not taken (take_stale_channels()).
  bool is_empty() const EXCLUDES(mutex_);
  /// Number of queued messages.
  std::size_t size() const EXCLUDES(mutex_);
  /// Bytes of queued messages and of what was taken last, which is on its way to the client.
  std::size_t bytes() const EXCLUDES(mutex_);

 private:
  struct Item {
    std::string channel;
    Text text;
    bool sampled;
  };
  void erase(const std::string& channel) REQUIRES(mutex_);

  mutable services::Mutex mutex_;
  std::deque<Item> items_ GUARDED_BY(mutex_);
  std::size_t bytes_ GUARDED_BY(mutex_) = 0;    // of items_
  std::size_t sending_ GUARDED_BY(mutex_) = 0;  // bytes of what was taken last
  bool is_cut_ GUARDED_BY(mutex_) = false;
  std::map<std::string, bool> needs_snapshot_ GUARDED_BY(mutex_);  // channel -> whether it was taken
};

}  // namespace race::server
