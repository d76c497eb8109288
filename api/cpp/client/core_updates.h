// CoreUpdates: what somebody who follows a core has heard of it, without sockets: numbers, folding, and a bounded queue
// for its reader. Values in it are frozen.
//
// Threads: one at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "api/cpp/client/api_error.h"
#include "core/value/value.h"

namespace race::client {

/// What has happened to a core that is followed. Frozen: any thread may read it.
struct Update {
  enum class Kind { snapshot, delta };
  Kind kind = Kind::snapshot;
  Value state = {};        // core and values as they are after it (core_state.json)
  Value delta = {};        // that led to it (core_delta.json); null: of a snapshot
  std::size_t merged = 0;  // of a snapshot: how many updates it stands for, as they came faster than they were read
};

class CoreUpdates {
 public:
  static constexpr std::size_t kCapacity = 1000;  // updates that wait for a slow reader

  explicit CoreUpdates(std::string_view core, std::size_t capacity = kCapacity);

  /// `core/{id}/state`.
  const std::string& channel() const { return channel_; }
  /// A message of the server (stream_message.json). One that says that the channel has ended, that is none, or that
  /// does not follow the one before, is a failure.
  void receive(const Value& message);
  /// Nothing more can be heard. The first one counts.
  void fail(ApiError error);

  /// Whether no more can come: the run is over, or following it has failed.
  bool is_over() const { return failure_.has_value() || is_run_over_; }
  bool has_state() const { return has_state_; }
  bool has_next() const { return !waiting_.empty(); }
  /// The next update; nothing: there is none now.
  std::optional<Update> pop();
  const std::optional<ApiError>& failure() const { return failure_; }

 private:
  void take(const Value& message);
  void put(Update update);

  std::string channel_;
  std::size_t capacity_;
  std::deque<Update> waiting_;
  Value state_;
  std::int64_t last_ = 0;  // number of the last message
  bool has_state_ = false;
  bool is_run_over_ = false;
  std::optional<ApiError> failure_;
};

}  // namespace race::client
