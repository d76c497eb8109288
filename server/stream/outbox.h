// Outbox: the messages that wait for one client. It never grows without bound: of a sampled channel only the newest
// waits; when a client is too slow for a state channel, all that waits of that channel is dropped, and once the client
// has caught up it is owed a snapshot. Until that is on its way, nothing else of the channel is: it would not follow.
//
// Threads: any; what it calls is called without its lock.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace race::server {

/// One serialisation, shared by all clients that get it.
using Text = std::shared_ptr<const std::string>;

class Outbox {
 public:
  static constexpr std::size_t kMessages = 256;
  static constexpr std::size_t kBytes = 8 * 1024 * 1024;

  /// A message for this client. `sampled`: it replaces one of its channel that waits.
  void push(const std::string& channel, Text text, bool sampled);
  /// The next message; nothing if none waits.
  std::optional<Text> pop();
  /// Forgets what waits of a channel, and that it is owed a snapshot: what is pushed next is one.
  void drop(const std::string& channel);
  /// The channels of which a client that has caught up is owed a snapshot: each once. What is pushed to them is lost
  /// until drop().
  std::vector<std::string> take_owed();
  /// Messages that wait.
  std::size_t size() const;

 private:
  struct Item {
    std::string channel;
    Text text;
    bool sampled;
  };
  void erase(const std::string& channel);

  mutable std::mutex mutex_;
  std::deque<Item> items_;
  std::size_t bytes_ = 0;
  std::map<std::string, bool> owed_;  // channel -> whether it was taken
};

}  // namespace race::server
