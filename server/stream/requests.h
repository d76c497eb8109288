// What a client says on the stream (schemas/stream_request.json).
#pragma once

#include <memory>
#include <string_view>

#include "server/accounts/role.h"
#include "server/stream/displays.h"
#include "server/stream/hub.h"

namespace race::server {

/// Who does what a client asks for with a message `edit`, and tells it: soon, on another thread.
class EditRequests {
 public:
  virtual ~EditRequests() = default;
  virtual void request_edit(const std::shared_ptr<Subscriber>& sender, const Value& message) = 0;
};

/// Who knows at which documents the persons at clients are. Must be quick.
class PresenceRequests {
 public:
  virtual ~PresenceRequests() = default;
  /// Does what a message `presence` asks for.
  virtual void request_presence(const std::shared_ptr<Subscriber>& sender, const Value& message) = 0;
  /// The client wants no channel of this name any more.
  virtual void unsubscribed(const Subscriber& subscriber, const std::string& channel) = 0;
  /// The client is gone.
  virtual void disconnected(const Subscriber& subscriber) = 0;
};

/// What is known of clients beyond their connection. Must be quick.
class ClientRecords {
 public:
  virtual ~ClientRecords() = default;
  /// Whether a client still is who it was when it connected: it is cut otherwise.
  virtual bool is_current(const Identity& identity) const = 0;
  /// A client has changed something: "press 3".
  virtual void record(const Identity& identity, std::string action, std::string outcome) = 0;
  /// A process of services is refused when it says what it is.
  virtual void refused(const Identity& identity, const Error& why) = 0;
};

/// Where the messages of clients go.
struct StreamTargets {
  Hub& hub;
  Displays& displays;
  EditRequests& edits;
  PresenceRequests& presence;
  ClientRecords& records;
};

/// Does what the message asks for, or tells the client why not.
void handle_stream_request(std::string_view message, const std::shared_ptr<Subscriber>& subscriber,
                           const StreamTargets& targets);

}  // namespace race::server
