// What a person at the controls says, on a WebSocket of their own (schemas/control_request.json): so no other traffic
// delays a sign of life, and its end is theirs.
#pragma once

#include <memory>
#include <string_view>

#include "core/value/value.h"
#include "server/accounts/role.h"

namespace race::server {

/// One connection of a person who has the controls, or wants them.
class ControlClient {
 public:
  virtual ~ControlClient() = default;
  /// schemas/control_message.json, frozen. Any thread; quick.
  virtual void tell(Value message) = 0;
  virtual const Identity& identity() const = 0;
};

/// Who knows who has the controls. On the sockets' thread; waits for nothing.
class ControlRequests {
 public:
  virtual ~ControlRequests() = default;
  /// Does what the message asks for, or tells the client why not.
  virtual void request(const std::shared_ptr<ControlClient>& client, std::string_view message) = 0;
  virtual void disconnected(const ControlClient& client) = 0;
};

}  // namespace race::server
