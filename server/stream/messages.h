// Messages of the stream: each is serialised once, and shared by all who keep it or have not sent it yet.
//
// Threads: any.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

namespace race::server {

/// One serialisation, shared by all clients that get it.
using Text = std::shared_ptr<const std::string>;

/// Makes messages, and counts the bytes of those that somebody still holds: each once, however many do.
class MessageMemory {
 public:
  Text make(std::string text) {
    auto owned = std::make_unique<const std::string>(std::move(text));
    *held_ += owned->size();
    // Messages may outlive this.
    return {owned.release(), [held = held_](const std::string* each) {
              *held -= each->size();
              delete each;
            }};
  }
  std::size_t held() const { return *held_; }

 private:
  const std::shared_ptr<std::atomic<std::size_t>> held_ = std::make_shared<std::atomic<std::size_t>>(0);
};

}  // namespace race::server
