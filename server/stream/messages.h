// Messages of the stream: each is serialised once, and shared by all who keep it or have not sent it yet.
//
// Threads: any.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace race::server {

/// A message as it is sent, with what its head says for who sends that in another form, too.
struct StreamMessage {
  std::int64_t sequence = 0;
  std::string_view kind;  // "snapshot", "delta", ...: a literal
  std::string json;       // schemas/stream_message.json
};

/// One serialisation, shared by all clients that get it.
using Text = std::shared_ptr<const StreamMessage>;

/// Makes messages, and counts the bytes of those that somebody still holds: each once, however many do.
class MessageMemory {
 public:
  Text make(StreamMessage message) {
    auto owned = std::make_unique<const StreamMessage>(std::move(message));
    *held_ += owned->json.size();
    // Messages may outlive this.
    return {owned.release(), [held = held_](const StreamMessage* each) {
              *held -= each->json.size();
              delete each;
            }};
  }
  std::size_t held() const { return *held_; }

 private:
  const std::shared_ptr<std::atomic<std::size_t>> held_ = std::make_shared<std::atomic<std::size_t>>(0);
};

}  // namespace race::server
